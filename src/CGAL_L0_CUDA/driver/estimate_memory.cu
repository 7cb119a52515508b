// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/estimate_memory.cuh"
#include "orientation/orientation.cuh"

#include <CGAL/L0_resampling/internal/plan/Method_rules.h>

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

constexpr std::size_t megabyte = std::size_t(1) << 20;

/// Of `orient_normals()`, beside the samples: votes and the field, or grades of the edges.
std::size_t of_orientation(std::size_t m, std::size_t k)
{
  return 4 * k * m + (std::max)(132 * m + bytes_of_field, 2 * k * m + 16 * m);
}

} // namespace

std::size_t estimate_memory(std::size_t n, std::size_t m, const Parameters& parameters,
                            bool has_hints)
{
  const Method_rules rules = rules_of(parameters.method);
  const std::size_t of_scales = rules.estimates_scales ? 4 * n : 0;
  const std::size_t slack = megabyte + of_scales,
                    of_outliers = parameters.outlier_sensitivity > 0 ? 4 * n : 0;
  // positions, normals, fit and confidences; what the default method adds; and what parameters ask
  // for
  const std::size_t of_samples = (60 + (rules.refines ? 11 : 0)
                                  + (rules.uses_areas && parameters.keep_density ? 4 : 0)
                                  + (has_hints ? 16 : 0) + (parameters.with_noises ? 4 : 0)
                                  + (parameters.with_deviations ? 8 : 0))
                                 * m;
  // points with their cells, and normals; and their order before
  const std::size_t of_points = of_outliers + 18 * n + 16 * n + of_scales, of_order = 5 * n;
  const std::size_t of_sorting = of_outliers + 24 * n + 64 * n;
  const std::size_t of_filtering = of_points + of_order + 16 * n
                                   + (rules.number_of_normal_refits > 0 ? 20 : 10) * n;
  const std::size_t of_start = of_points + of_order + 24 * n + 16 * m + (has_hints ? 12 * n : 0);
  const std::size_t of_sample_grid = 19 * m;
  const std::size_t of_neighbors = rules.refines ? 80 * m : 64 * m;
  const std::size_t of_sorting_samples = (rules.refines ? of_points : 0) + of_sample_grid + 5 * m
                                         + (rules.refines ? 72 : 64) * m;
  const std::size_t of_fit = of_points + of_sample_grid + 15 * m;
  const std::size_t of_minimization = (rules.refines ? of_points + 16 * m : 0) + 16 * m
                                      + of_neighbors + 68 * m;
  // the default method needs the points until the samples are refined
  const std::size_t of_points_beside = rules.refines ? of_points : 0;
  const std::size_t of_quadrics = of_points_beside + 2 * of_sample_grid + 20 * m + 64 * m;
  // copies of the samples; what is found of their disks and surfaces; and the disks that are
  // merged, which take more than the kernels of all disks, or what splits sheets
  const std::size_t of_fitted_surfaces = 164 * m,
                    of_refinement = rules.refines ? of_points + 7 * n + 65 * m + of_sample_grid
                                                      + of_fitted_surfaces + 150 * m
                                                  : 0;
  return slack + of_samples
         + (std::max)(
           {of_sorting, of_filtering, of_start, of_sorting_samples, of_fit, of_minimization,
            of_quadrics, of_refinement,
            of_points_beside + of_orientation(m, parameters.number_of_orientation_neighbors)});
}

std::size_t estimate_memory_to_orient(std::size_t n, const Parameters& parameters, bool has_normals,
                                      bool has_hints)
{
  const std::size_t of_scales = 4 * n, of_samples = (76 + (has_hints ? 16 : 0)) * n;
  const std::size_t of_lists = (4 + (has_normals ? 12 : 0) + (has_hints ? 12 : 0)) * n,
                    of_grid = 31 * n;
  const std::size_t of_sorting = of_lists + of_grid + 64 * n;
  return megabyte + of_scales + of_samples
         + (std::max)(of_sorting,
                      of_orientation(n, voters_per_neighbor
                                          * parameters.number_of_orientation_neighbors));
}

std::size_t estimate_memory_to_orient_tiles(std::size_t m, const Parameters& parameters)
{
  const std::size_t of_samples = 60 * m, of_order = 4 * m, of_sorting = 19 * m + 5 * m + 64 * m;
  return megabyte + of_samples + of_order
         + (std::max)(of_sorting, of_orientation(m, parameters.number_of_orientation_neighbors));
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
