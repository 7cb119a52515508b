// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_REFINEMENT_CUH
#define CGAL_L0_CUDA_REFINEMENT_CUH

#include "samples/stages_of_refinement.cuh"

#include <optional>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// What the refinement needs of the samples, copied, so that `samples` themselves keep their order.
/// \returns arrays from the arena; its `start_indices` tell which sample is where
Samples samples_to_refine(const Execution_context& context, const Samples& samples);

/// Puts positions and normals back in the order before, on the sides before unless these are known
/// now.
void put_back(const Execution_context& context, const Samples& refined, const Samples& samples);

/// One round of the refinement, or the split of sheets before, as `Refinement` on the CPU: the
/// arrays of it, and what runs on them.
class Refinement
{
  const Execution_context m_context;
  const Lengths_of_refinement m_lengths;
  const Framed_box m_box; // of the points
  const double m_minimum_cell_size;
  const Samples m_samples; // in the order of their grid

  // until the samples have moved
  std::optional<Arena_scope> m_fits_scope; // of the arena
  Cell_grid m_grid;                        // of the samples
  Shares_of_samples m_shares;
  Mean_surface* m_means = nullptr;
  Surface_of_disks *m_predictions = nullptr, *m_references = nullptr;
  Surfaces_of_scale* m_surfaces = nullptr;
  std::optional<Arena_scope> m_smallest_scope;      // of the arena, on top of that
  Surfaces_of_scale* m_smallest_surfaces = nullptr; // which wait for their reference

  // from then on
  std::optional<Arena_scope> m_bends_scope; // of the scratch arena
  Bend* m_bends = nullptr;
  Variances_of_fit* m_variances = nullptr; // null unless deviations are asked for

public:
  /// \param box of the points
  /// \param of_points frame of their grid
  /// \param samples of `samples_to_refine()`; they are sorted
  Refinement(const Execution_context& context, const Lengths_of_refinement& lengths,
             const Framed_box& box, double minimum_cell_size, const Cell_frame& of_points,
             const Samples& samples);

  /// And finds the noise around each sample; nothing else runs after that.
  /// \param grid of the points
  /// \param are_sides_known whether it is known what the points were seen from: then none is split
  void split_sheets(const Positions& points, const Cell_grid& grid, bool are_sides_known);
  void share_points(const Positions& points, const Cell_grid& grid);
  void fit_disks(int scale);
  void weigh_by_risk(int scale);
  void take_mean_surfaces();
  void keep_clear_of_creases();
  void find_deviations();

private:
  Cell_frame frame_of(double cell_size, double longest_query) const
  {
    return Cell_frame::around(m_box.low, m_box.high, cell_size, longest_query, m_samples.scales);
  }
  Cell_frame frame_of_samples(const Cell_frame& of_points) const;
  void share(const Positions& points, const Cell_grid& grid, double widening,
             const Shares_of_samples& shares);
  void weigh(const Surfaces_of_scale* surfaces, int scale);
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_REFINEMENT_CUH
