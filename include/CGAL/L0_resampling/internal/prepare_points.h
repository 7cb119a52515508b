// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PREPARE_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_PREPARE_POINTS_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/Plan.h>
#include <CGAL/L0_resampling/internal/density_weights.h>
#include <CGAL/L0_resampling/internal/estimate_pca_normals.h>
#include <CGAL/L0_resampling/internal/estimate_scale_field.h>
#include <CGAL/L0_resampling/internal/estimate_scales.h>
#include <CGAL/L0_resampling/internal/filter_normals.h>
#include <CGAL/L0_resampling/internal/find_outliers.h>
#include <CGAL/L0_resampling/internal/refit_normals.h>
#include <CGAL/L0_resampling/internal/thin_crowds.h>
#include <CGAL/L0_resampling/internal/working_frame.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The scalar type of what happens within one ball, where relative coordinates make `float` enough.
using Local = float;
using Local_vector = Eigen::Matrix<Local, 3, 1>;

/// Finds the facts of the cloud, plans the call, and makes r_p the unit of frame and points.
/// \param frame that the points have entered
/// \param scales out: of the points; none if all are 1
template <typename ConcurrencyTag>
Plan plan_and_scale(const Parameters& parameters, Buffer<Vector>& points, Working_frame& frame,
                    Progress& progress, Report& report, Buffer<float>& scales)
{
  Facts facts{points.size(), box_diagonal(points), robust_diagonal<ConcurrencyTag>(points),
              frame.exponent()};
  if (Plan::needs_scales(parameters))
  {
    facts.scales = estimate_scales<ConcurrencyTag, Local>(points, paper_radius(facts), progress);
    report.estimated_spacing = frame.length_of_input(facts.scales.spacing * paper_radius(facts));
    report.estimated_noise = frame.length_of_input(facts.scales.noise * paper_radius(facts));
  }
  Plan plan = make_plan(parameters, facts);
  if (plan.follows_scales)
  {
    const Scale_field field = estimate_scale_field<ConcurrencyTag>(
      points, facts.robust_diagonal, usual_scales(plan, facts), progress);
    scales = field.of_points<ConcurrencyTag>(points);
  }
  const Range_of_scales range = range_of(scales);
  plan.largest_radius = range.largest;
  frame.set_unit<ConcurrencyTag>(plan.unit, points);
  report_radii(plan, range, frame, report);
  return plan;
}

/// Coincident points are in no order but that of the input, which must not matter: puts their
/// normals, or hints, in one.
inline void sort_normals_of_coincident_points(const Buffer<Vector>& points,
                                              Buffer<Local_vector>& normals)
{
  for_each_in_order(points.size(), [&](std::size_t begin) {
    if (begin > 0 && points[begin] == points[begin - 1])
      return;
    std::size_t end = begin + 1;
    while (end < points.size() && points[end] == points[begin])
      ++end;
    std::sort(normals.begin() + std::ptrdiff_t(begin), normals.begin() + std::ptrdiff_t(end),
              [](const Local_vector& a, const Local_vector& b) {
                return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
              });
  });
}

/// Removes the outliers from the points and what belongs to them.
/// \returns their number
template <typename ConcurrencyTag>
std::size_t drop_outliers(double radius, Buffer<Vector>& points, Buffer<float>& scales,
                          Buffer<Local_vector>& given_normals, Buffer<Local_vector>& hints,
                          Progress& progress)
{
  const Buffer<unsigned char> is_outlier =
    find_outliers<Local, ConcurrencyTag>(points, radius, view_of_scales(scales), progress);
  const auto drop_from = [&](auto& values) {
    std::size_t size = 0;
    for_each_in_order(values.size(), [&](std::size_t i) {
      if (!is_outlier[i])
        values[size++] = values[i];
    });
    values.resize(size);
  };
  const std::size_t n = points.size();
  drop_from(points);
  drop_from(scales);
  drop_from(given_normals);
  drop_from(hints);
  return n - points.size();
}

/// Sorts the points, and what belongs to them, into the order of their grid.
/// \returns the number of distinct points
template <typename ConcurrencyTag>
std::size_t sort_points(double cell_size, Buffer<Vector>& points, Buffer<float>& scales,
                        Buffer<Local_vector>& given_normals, Buffer<Local_vector>& hints)
{
  {
    const Buffer<Index> order =
      Search_grid_3::sorted_order<ConcurrencyTag>(points, Cell_sizes(cell_size, scales));
    apply_order<ConcurrencyTag>(order, points);
    if (!scales.empty())
      apply_order<ConcurrencyTag>(order, scales);
    for (Buffer<Local_vector>* vectors : {&given_normals, &hints})
      if (!vectors->empty())
      {
        apply_order(order, *vectors);
        sort_normals_of_coincident_points(points, *vectors);
      }
  }
  std::size_t number_of_distinct_points = 0;
  for_each_in_order(points.size(), [&](std::size_t i) {
    number_of_distinct_points += i == 0 || points[i] != points[i - 1];
  });
  return number_of_distinct_points;
}

/// Whether there is a normal for each point.
inline bool are_all_given(const Buffer<Local_vector>& given_normals)
{
  return !given_normals.empty()
         && std::none_of(given_normals.begin(), given_normals.end(),
                         [](const Local_vector& n) { return n.isZero(0); });
}

/// The input points in the order of their grid, with what the stages find out about them.
struct Prepared_points
{
  Buffer<Vector>& points;
  Buffer<float>& scales; ///< of the points; none if all are 1
  Search_grid_3 grid;
  /// How many points of the input each one stands for; empty if only for itself.
  Buffer<Index> numbers_of_points;
  Buffer<Local_vector> normals;  ///< filtered
  Buffer<Local> density_weights; ///< \f$ v_j \f$

  /// Frees the memory, once the samples are fitted.
  void release_all()
  {
    release(points);
    release(scales);
    release(numbers_of_points);
    release(normals);
    release(density_weights);
    grid = Search_grid_3(points, grid.cell_size()); // of no points
  }
};

/// Section 3.1: the filtered normals of the input points, Eq. (1) and (2). `given_normals` replace
/// PCA where they are usable.
template <typename ConcurrencyTag>
void compute_filtered_normals(const Plan& plan, const Buffer<Local_vector>& given_normals,
                              Progress& progress, Report& report, Prepared_points& input)
{
  const Search_grid_3& grid = input.grid;
  const Buffer<Vector>& points = input.points;
  Buffer<Local_vector>& normals = input.normals;
  normals = filled_buffer(points.size(), Local_vector(Local_vector::UnitZ()),
                          points.get_allocator());
  if (!are_all_given(given_normals))
  {
    progress.begin_stage("PCA normals", 0.1, points.size());
    report.number_of_degenerate_neighborhoods = estimate_pca_normals<ConcurrencyTag>(
      grid, points, input.numbers_of_points, plan.pca_radius, progress, normals);
  }
  for_each_in_order(given_normals.size(), [&](std::size_t i) {
    if (!given_normals[i].isZero(0))
      normals[i] = given_normals[i];
  });

  const Normal_filter<Local> filter{plan.filter_radius, Local(plan.squared_bandwidth),
                                    Local(plan.normal_bandwidth)};
  const Normal_filter<Local> plane{plan.filter_radius, Local(plan.squared_bandwidth),
                                   Local(plan.compatible_bandwidth)};
  progress.begin_stage("filter normals", 0.4,
                       points.size() * (plan.number_of_filter_passes + plan.number_of_refits));
  filter_normals<ConcurrencyTag>(
    grid, points, filter, plan.number_of_filter_passes - plan.number_of_refits, progress, normals);
  for (std::size_t refit = 0; refit < plan.number_of_refits; ++refit)
  {
    refit_normals<ConcurrencyTag>(grid, points, plane, Local(square(plan.sheet_height)), progress,
                                  normals);
    filter_normals<ConcurrencyTag>(grid, points, filter, 1, progress, normals);
  }
}

/// Removes outliers, sorts the points, and thins crowds.
/// \param points in the working frame
/// \param scales of the points; none if all are 1
/// \returns the points without normals and density weights
template <typename ConcurrencyTag>
Prepared_points sort_and_thin(const Plan& plan, Buffer<Vector>& points, Buffer<float>& scales,
                              Buffer<Local_vector>& given_normals, Buffer<Local_vector>& hints,
                              Progress& progress, Report& report)
{
  if (plan.drops_outliers)
  {
    progress.begin_stage("find outliers", 0.05, points.size());
    report.number_of_outliers = drop_outliers<ConcurrencyTag>(plan.radius, points, scales,
                                                              given_normals, hints, progress);
    progress.begin_stage("sort points", 0.05, 1);
  }
  report.number_of_distinct_points = sort_points<ConcurrencyTag>(plan.cell_size, points, scales,
                                                                 given_normals, hints);
  const auto allocator = points.get_allocator();
  Prepared_points input{points,
                        scales,
                        Search_grid_3(points, Cell_sizes(plan.cell_size, scales)),
                        Buffer<Index>(allocator),
                        Buffer<Local_vector>(allocator),
                        Buffer<Local>(allocator)};
  const Representatives kept = thin_crowds<ConcurrencyTag>(input.grid, points,
                                                           most_points_of_subcell);
  if (!kept.are_all_points())
  {
    input.numbers_of_points = kept.numbers_of_points();
    kept.keep(points);
    kept.keep(scales);
    kept.keep(given_normals);
    kept.keep(hints);
    input.grid = Search_grid_3(points, Cell_sizes(plan.cell_size, scales));
  }
  return input;
}

/// Finds the normals of the points and their density weights of Eq. (5).
/// \param given_normals used up
template <typename ConcurrencyTag>
void find_normals_and_weights(const Plan& plan, Buffer<Local_vector>& given_normals,
                              Progress& progress, Report& report, Prepared_points& input)
{
  compute_filtered_normals<ConcurrencyTag>(plan, given_normals, progress, report, input);
  const bool all_normals_given = are_all_given(given_normals);
  release(given_normals);

  progress.begin_stage("density weights", 0.08, input.points.size());
  const std::size_t number_of_sparse_balls = compute_input_density_weights<ConcurrencyTag>(
    input.grid, input.points, plan.filter_radius, plan.squared_bandwidth, progress,
    input.density_weights);
  if (all_normals_given)
    report.number_of_degenerate_neighborhoods = number_of_sparse_balls;
  if (!plan.weighs_density)
    input.density_weights.assign(input.points.size(),
                                 Local(1)); // sparse points shall not count more than dense ones
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PREPARE_POINTS_H
