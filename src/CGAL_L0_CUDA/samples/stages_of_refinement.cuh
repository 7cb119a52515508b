// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_STAGES_OF_REFINEMENT_CUH
#define CGAL_L0_CUDA_STAGES_OF_REFINEMENT_CUH

#include "driver/stages.cuh"

#include <CGAL/L0_resampling/internal/kernels/deviation_of_sample.h>
#include <CGAL/L0_resampling/internal/kernels/lengths_of_refinement.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

// The stages of the refinement, see `Refinement`. The samples are in the order of their
// grid; the fourth numbers of their normals are the heights of the points over their disks, from
// `share_points()` on.

/// The lengths at a sample.
__device__ inline Lengths_of_refinement lengths_at(const Lengths_of_refinement& lengths,
                                                   const Samples& samples, unsigned i)
{
  return lengths.at(samples.scale(i), samples.noise_ratios[i]);
}

/// What the points tell of the disks of the samples, beside their heights.
struct Shares_of_samples
{
  float* informations; // as `Lengths_of_refinement` says
  float* variances;    // as of `Disk`
  // W, the variance of the points about their mean height, and the means of the squares and fourth
  // powers of their heights; null unless sheets are split
  float4* scatters;
};

/// Shares the points among the samples around them, as `share_points()` on the CPU.
/// \param widening of the noise
/// \param sample_grid of the same cells as `point_grid`
void share_points(const Execution_context& context, const Lengths_of_refinement& lengths,
                  double widening, const Cell_grid& point_grid, const Cell_grid& sample_grid,
                  const Samples& samples, const Shares_of_samples& shares);

/// The disks that sheets are told apart by.
struct Scattered_disks
{
  const float4* normals; // and the heights of the points over the disks
  const float4* scatters;
};

/// Puts them in the order of a grid; arrays are taken from the arena.
Scattered_disks in_order_of(const Execution_context& context, const Cell_grid& grid,
                            const Scattered_disks& disks);

/// Splits samples between two sheets, and finds the noise around each, as `Sheet_splitter` on the
/// CPU.
/// \param wide_grid of the samples, of cells that suit a ball of `radius_of_split`
/// \param order where each sample of that grid stands; null if each in its own place
/// \param disks in the order of that grid
/// \param region_grid, order_of_region the same for a ball of `radius_of_region`
/// \param sample_grid in whose order the samples are
/// \param splits whether sheets are split, beside finding the noise
void split_sheets(const Execution_context& context, const Lengths_of_refinement& lengths,
                  const Cell_grid& wide_grid, const unsigned* order, const Scattered_disks& disks,
                  const Cell_grid& region_grid, const unsigned* order_of_region,
                  const Cell_grid& sample_grid, bool splits, const Samples& samples);

/// The disks that surfaces are fitted to.
struct Disks
{
  unsigned size;
  const double* positions; // xyz interleaved
  const float4* normals;   // and the heights of the points over the disks
  const float* informations;
  const float* scales; // null if all are 1
};

/// Joins the disks of samples that share a cell and a face, as `merge_disks()` on the CPU. Waits
/// for the device.
/// \param frame of the cells
/// \returns arrays from the arena
Disks merge_disks(const Execution_context& context, const Cell_frame& frame, const Samples& samples,
                  const float* informations);

/// Puts what is fitted of the disks in the order of their grid; arrays are taken from the arena.
Disks in_order_of(const Execution_context& context, const Cell_grid& grid, const Disks& disks);

/// Fits a plane and a quadric to the disks of a ball around each sample, as `fit_disks()` on the
/// CPU.
/// \param sample_grid of the same cells as `disk_grid`
/// \param is_in_order whether the samples are in the order of that grid
/// \param disks in the order of their grid
/// \param scale which of the radii
/// \param predictions in: the surface of the next smaller ball at each sample; out: of this one
/// \param surfaces out
void fit_disks(const Execution_context& context, const Lengths_of_refinement& lengths,
               const Cell_grid& sample_grid, bool is_in_order, const Cell_grid& disk_grid,
               const Disks& disks, int scale, const Samples& samples, const float* variances,
               Surface_of_disks* predictions, Surfaces_of_scale* surfaces);

/// The references of the samples, see `reference_of()`.
void find_references(const Execution_context& context, const Lengths_of_refinement& lengths,
                     const Samples& samples, const Surfaces_of_scale* surfaces,
                     const Surfaces_of_scale* smallest, Surface_of_disks* references);

/// Adds the surfaces of one scale to the mean of each sample, as `weigh_by_risk()` on the CPU.
/// \param radius of the samples that the bias is averaged over, at scale 1
void weigh_by_risk(const Execution_context& context, const Cell_grid& sample_grid, double radius,
                   const Samples& samples, const Surface_of_disks* references,
                   const Surfaces_of_scale* surfaces, Mean_surface* means);

/// Moves the samples to the mean of their surfaces.
/// \param bends out, of each sample
/// \param variances out, likewise; may be null
void settle_on_means(const Execution_context& context, const Lengths_of_refinement& lengths,
                     const Mean_surface* means, const Samples& samples, Bend* bends,
                     Variances_of_fit* variances);

/// Slides samples back on their own face of a crease, as `keep_clear_of_creases()` on the CPU.
/// Waits for the device.
/// \param frame of cells no smaller than `reach_of_clearance` spacings
void keep_clear_of_creases(const Execution_context& context, const Cell_frame& frame,
                           double spacing, const Bend* bends, const Samples& samples);

/// The deviations as far as they are known without the refinement, as on the CPU.
void begin_deviations(const Execution_context& context, const Lengths_of_refinement& lengths,
                      const Samples& samples);

/// Finds how far samples may be off the surface, as `find_deviations()` on the CPU.
/// \param frame of cells no smaller than the largest `Ball_of_normals`
/// \param variances of the fits of the samples
/// \param samples whose deviations are found
void find_deviations(const Execution_context& context, const Cell_frame& frame,
                     const Lengths_of_refinement& lengths, const Variances_of_fit* variances,
                     const Samples& samples);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_STAGES_OF_REFINEMENT_CUH
