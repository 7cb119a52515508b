// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PREPARE_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_PREPARE_POINTS_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/cloud/are_all_given.h>
#include <CGAL/L0_resampling/internal/cloud/find_outliers.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/core/precedes.h>
#include <CGAL/L0_resampling/internal/search/thin_crowds.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Coincident points are in no order but that of the input, which must not matter: puts their
/// normals, hints or noises in one.
template <typename Value, typename Less>
void sort_values_of_coincident_points(const Buffer<Vector>& points, Buffer<Value>& values,
                                      const Less& less)
{
  if (values.empty())
    return;
  for_each_in_order(points.size(), [&](std::size_t begin) {
    if (begin > 0 && points[begin] == points[begin - 1])
      return;
    std::size_t end = begin + 1;
    while (end < points.size() && points[end] == points[begin])
      ++end;
    std::sort(values.begin() + std::ptrdiff_t(begin), values.begin() + std::ptrdiff_t(end), less);
  });
}

/// The input points in the order of their grid, with what the stages find out about them.
struct Prepared_points
{
  Buffer<Vector>& points;
  Buffer<float> scales;       ///< of the points; none if all are 1
  Buffer<float> noise_ratios; ///< of that of each point to that of the cloud; none if all are 1
  /// Which points of the call they are; none if nobody asks.
  Buffer<Index> indices;
  Search_grid_3 grid;
  /// How many points of the input each one stands for; empty if only for itself.
  Buffer<Index> numbers_of_points;
  Buffer<Local_vector> normals;  ///< filtered
  Buffer<Local> density_weights; ///< \f$ v_j \f$

  /// \param p the points, which are in no order yet: the grid has none of them
  explicit Prepared_points(Buffer<Vector>& p)
    : points(p), scales(p.get_allocator()), noise_ratios(p.get_allocator()),
      indices(p.get_allocator()), grid(Buffer<Vector>(p.get_allocator()), 1.),
      numbers_of_points(p.get_allocator()), normals(p.get_allocator()),
      density_weights(p.get_allocator())
  {}

  /// Notes which point of the call each one is.
  void keep_indices()
  {
    indices.reserve(points.size());
    for_each_in_order(points.size(), [&](std::size_t i) { indices.push_back(Index(i)); });
  }

  /// Frees the memory, once the samples are fitted.
  void release_all()
  {
    release(points);
    release(scales);
    release(noise_ratios);
    release(indices);
    release(numbers_of_points);
    release(normals);
    release(density_weights);
    grid = Search_grid_3(points, grid.cell_size()); // of no points
  }
};

/// Removes points, and what belongs to them.
/// \param are_dropped not 0 for these
/// \returns their number
inline std::size_t drop_points(const Buffer<unsigned char>& are_dropped, Prepared_points& input,
                               Buffer<Local_vector>& given_normals, Buffer<Local_vector>& hints)
{
  const auto drop_from = [&](auto& values) {
    std::size_t size = 0;
    for_each_in_order(values.size(), [&](std::size_t i) {
      if (!are_dropped[i])
        values[size++] = values[i];
    });
    values.resize(size);
  };
  const std::size_t n = input.points.size();
  drop_from(input.points);
  drop_from(input.scales);
  drop_from(input.noise_ratios);
  drop_from(input.indices);
  drop_from(given_normals);
  drop_from(hints);
  return n - input.points.size();
}

/// Whether each of the points is an outlier. Parameters are those of `find_outliers()`.
template <typename ConcurrencyTag>
Buffer<unsigned char> outliers_among(const Prepared_points& input, double radius, double extent,
                                     const Outlier_thresholds& thresholds, Facts_of_cloud& facts,
                                     Progress& progress)
{
  return find_outliers<Local, ConcurrencyTag>(input.points, radius, extent, thresholds,
                                              view_of_scales(input.scales),
                                              facts.median_number_of_neighbors, progress);
}

/// Sorts the points, and what belongs to them, into the order of their grid.
/// \returns the number of distinct points
template <typename ConcurrencyTag>
std::size_t sort_points(double cell_size, Prepared_points& input,
                        Buffer<Local_vector>& given_normals, Buffer<Local_vector>& hints)
{
  const Buffer<Vector>& points = input.points;
  {
    const Buffer<Index> order =
      Search_grid_3::sorted_order<ConcurrencyTag>(points, Cell_sizes(cell_size, input.scales));
    apply_order<ConcurrencyTag>(order, input.points);
    apply_order<ConcurrencyTag>(order, input.scales);
    apply_order<ConcurrencyTag>(order, input.indices);
    apply_order<ConcurrencyTag>(order, input.noise_ratios);
    sort_values_of_coincident_points(points, input.noise_ratios, std::less<float>());
    for (Buffer<Local_vector>* vectors : {&given_normals, &hints})
    {
      apply_order(order, *vectors);
      sort_values_of_coincident_points(points, *vectors, precedes<Local>);
    }
  }
  std::size_t number_of_distinct_points = 0;
  for_each_in_order(points.size(), [&](std::size_t i) {
    number_of_distinct_points += i == 0 || points[i] != points[i - 1];
  });
  return number_of_distinct_points;
}

/// Sorts the points, and what belongs to them, into the order of their grid, and leaves out those
/// of crowds but for a few, which stand for the others.
/// \returns the number of distinct points
template <typename ConcurrencyTag>
std::size_t sort_and_thin_points(double cell_size, Prepared_points& input,
                                 Buffer<Local_vector>& given_normals, Buffer<Local_vector>& hints)
{
  const std::size_t number_of_distinct_points = sort_points<ConcurrencyTag>(cell_size, input,
                                                                            given_normals, hints);
  input.grid = Search_grid_3(ConcurrencyTag(), input.points, Cell_sizes(cell_size, input.scales));
  const Representatives kept = thin_crowds<ConcurrencyTag>(input.grid, input.points,
                                                           maximum_number_of_points_of_subcell);
  if (!kept.are_all_points())
  {
    input.numbers_of_points = kept.numbers_of_points();
    kept.keep(input.points);
    kept.keep(input.scales);
    kept.keep(input.noise_ratios);
    kept.keep(input.indices);
    kept.keep(given_normals);
    kept.keep(hints);
    input.grid = Search_grid_3(ConcurrencyTag(), input.points, Cell_sizes(cell_size, input.scales));
  }
  return number_of_distinct_points;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PREPARE_POINTS_H
