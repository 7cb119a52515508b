// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_POINT_SET_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_POINT_SET_IMPL_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/cloud/prepare_points.h>
#include <CGAL/L0_resampling/internal/driver/Cpu_points.h>
#include <CGAL/L0_resampling/internal/driver/orient_point_set.h>
#include <CGAL/L0_resampling/internal/driver/run.h>
#include <CGAL/L0_resampling/internal/kernels/spacing_to_orient.h>
#include <CGAL/L0_resampling/internal/normals/estimate_pca_normals.h>
#include <CGAL/L0_resampling/internal/normals/refit_normals.h>
#include <CGAL/L0_resampling/internal/orientation/orient_normals.h>
#include <CGAL/L0_resampling/internal/orientation/side_hints.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/L0_resampling/internal/search/thin_crowds.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Points in the working frame, of which one after the other comes to stand for those near it.
struct Thinned_points
{
  Buffer<Index> of_input; ///< for each point of the input, the place of the one that stands for it
  Buffer<Vector> positions;
  Buffer<float> scales;                ///< none if all are 1
  Buffer<Local_vector> normals, hints; ///< one each, or none at all; zero where there is none

  /// Sorts the points into the order of the grid of these cells.
  template <typename ConcurrencyTag>
  void sort(double cell_size)
  {
    const Buffer<Index> order =
      Search_grid_3::sorted_order<ConcurrencyTag>(positions, Cell_sizes(cell_size, scales));
    apply_order<ConcurrencyTag>(order, positions);
    apply_order<ConcurrencyTag>(order, scales);
    for (Buffer<Local_vector>* vectors : {&normals, &hints})
      apply_order<ConcurrencyTag>(order, *vectors);
    Buffer<Index> new_places = filled_buffer(order.size(), Index(0), order.get_allocator());
    for_each_in_order(order.size(), [&](std::size_t i) { new_places[order[i]] = Index(i); });
    move_to(new_places);
  }

  /// Removes the points that others stand for.
  void keep(const Representatives& representatives)
  {
    if (representatives.are_all_points())
      return;
    Buffer<Index> new_places = copy_of(representatives.of_points);
    Index number_of_kept = 0;
    for_each_in_order(new_places.size(), [&](std::size_t i) { // a kept point comes before
      new_places[i] = representatives.is_kept(i) ? number_of_kept++ : new_places[new_places[i]];
    });
    move_to(new_places);
    representatives.keep(positions);
    representatives.keep(scales);
    representatives.keep(normals);
    representatives.keep(hints);
  }

private:
  void move_to(const Buffer<Index>& new_places)
  {
    if (of_input.empty())
      of_input = copy_of(new_places);
    else
      for_each_in_order(of_input.size(),
                        [&](std::size_t i) { of_input[i] = new_places[of_input[i]]; });
  }
};

/// For points at one place the first one, with the largest normal and hint that are given: by x,
/// then y, then z.
inline Representatives representatives_of_places(Thinned_points& points)
{
  const Buffer<Vector>& positions = points.positions;
  for (Buffer<Local_vector>* vectors : {&points.normals, &points.hints})
    if (!vectors->empty())
      sort_values_of_coincident_points(positions, *vectors, precedes<Local>);
  Representatives result{Buffer<Index>(positions.get_allocator())};
  result.of_points.reserve(positions.size());
  for_each_in_order(positions.size(), [&](std::size_t i) {
    const bool is_new = i == 0 || positions[i] != positions[i - 1];
    const Index first = is_new ? Index(i) : result.of_points.back();
    result.of_points.push_back(first);
    for (Buffer<Local_vector>* vectors : {&points.normals, &points.hints})
      if (!is_new && !vectors->empty() && !(*vectors)[i].isZero(0))
        (*vectors)[first] = (*vectors)[i];
  });
  return result;
}

/// Estimates the normals that are not given.
template <typename ConcurrencyTag>
void estimate_missing_normals(const Plan& plan, Progress& progress, Report& report,
                              Thinned_points& points)
{
  if (are_all_given<ConcurrencyTag>(points.normals))
    return;
  const std::size_t n = points.positions.size();
  progress.begin_stage("PCA normals", 0.3, n * (1 + plan.number_of_refits));
  const Search_grid_3 grid(points.positions, Cell_sizes(plan.cell_size, points.scales));
  Buffer<Local_vector> estimated = filled_buffer(n, Local_vector(Local_vector::UnitZ()),
                                                 points.positions.get_allocator());
  report.number_of_degenerate_neighborhoods = estimate_pca_normals<ConcurrencyTag>(
    grid, points.positions, Buffer<Index>(points.of_input.get_allocator()), plan.pca_radius,
    plan.looks_beyond_strips, progress, estimated);
  for (std::size_t refit = 0; refit < plan.number_of_refits; ++refit)
    refit_normals<ConcurrencyTag>(grid, points.positions, plan.kernel_of_points(), progress,
                                  estimated);
  for_each_in_order(points.normals.size(), [&](std::size_t i) {
    if (!points.normals[i].isZero(0))
      estimated[i] = points.normals[i];
  });
  points.normals = std::move(estimated);
}

/// The points of a call that only orients: `plan_call()` finds scales of places if they are needed.
template <typename ConcurrencyTag>
class Points_to_orient : public Cpu_points<ConcurrencyTag>
{
  using Points = Cpu_points<ConcurrencyTag>;
  bool m_are_all_normals_given;

public:
  Points_to_orient(Buffer<Vector>& points, bool are_all_normals_given, Progress& progress,
                   Report& report)
    : Points(points, progress, report), m_are_all_normals_given(are_all_normals_given)
  {}

  Range_of_scales estimate_scale_field(double robust_diagonal, const Reference_scales& usual)
  {
    return needs_scales_to_orient(m_are_all_normals_given, usual.spacing, usual.noise)
             ? Points::estimate_scale_field(robust_diagonal, usual)
             : Range_of_scales();
  }
};

template <typename ConcurrencyTag>
Oriented_representatives orient_point_set(Buffer<Vector>& positions,
                                          Buffer<Local_vector>& given_normals,
                                          Buffer<Local_vector>& hints, const Parameters& parameters,
                                          Progress& progress, Report& report)
{
  const auto allocator = positions.get_allocator();
  Points_to_orient<ConcurrencyTag> all_points(
    positions, are_all_given<ConcurrencyTag>(given_normals), progress, report);
  const Plan plan = plan_call(parameters, all_points);
  Thinned_points points{Buffer<Index>(allocator), std::move(positions),
                        std::move(all_points.scales()), std::move(given_normals), std::move(hints)};
  points.sort<ConcurrencyTag>(plan.cell_size);
  points.keep(representatives_of_places(points));
  report.number_of_distinct_points = points.positions.size();
  points.keep(thin_crowds<ConcurrencyTag>(Search_grid_3(points.positions,
                                                        Cell_sizes(plan.cell_size, points.scales)),
                                          points.positions, maximum_number_of_points_of_subcell));
  estimate_missing_normals<ConcurrencyTag>(plan, progress, report, points);

  const std::size_t number_of_points = points.positions.size();
  const double spacing = spacing_of_representatives(plan.sample_spacing, plan.noise);
  if (spacing > plan.sample_spacing)
  {
    const double cell_size = subcells_per_axis * spacing;
    points.sort<ConcurrencyTag>(cell_size);
    points.keep(thin_crowds<ConcurrencyTag>(
      Search_grid_3(points.positions, Cell_sizes(cell_size, points.scales)), points.positions, 1));
  }
  progress.begin_stage("orient normals", 0.5, points.positions.size());
  Buffer<Local_vector> mean_normals(allocator);
  const Orientation orientation = orient_normals<ConcurrencyTag>(
    points.positions, parameters.number_of_orientation_neighbors,
    spacing_on_surface(plan.sample_spacing, number_of_points, points.positions.size()),
    side_hints(parameters, all_points.frame(), points.positions, points.hints), progress,
    points.normals, noise_of_heights(plan.noise), &mean_normals);
  report.oriented_share = orientation.oriented_share;
  report.right_side_share = orientation.right_side_share();
  report.hinted_share = orientation.hinted_share;
  progress.end_stage();
  return {std::move(points.of_input), std::move(points.normals), std::move(mean_normals)};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENT_POINT_SET_IMPL_H
