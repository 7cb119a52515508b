// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEAREST_INPUT_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEAREST_INPUT_POINTS_H

#include <CGAL/L0_resampling/Near_points.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/search/Point_tree_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Finds the `count` input points nearest to each of the `queries`; where distances are equal,
/// those of the smallest indices. A point weighs \f$ e^{-d^2/h^2} \f$, where \f$ h^2 \f$ is the
/// mean of the squared distances of all that were found.
/// \param tree of the input, not empty
template <typename ConcurrencyTag, typename FT>
void nearest_input_points(const Point_tree_3& tree, const Buffer<std::array<FT, 3>>& queries,
                          Progress& progress, Near_points& near_points)
{
  const std::size_t count = near_points.count, queries_per_block = 1024;
  fill_buffer(queries.size() * count, Index(0), near_points.indices);
  fill_buffer(queries.size() * count, 0.f, near_points.weights);
  for_each_block<ConcurrencyTag>(
    queries.size(), queries_per_block, [&](std::size_t begin, std::size_t end) {
      std::vector<Point_tree_3::Candidate> found(count);
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vector query{double(queries[i][0]), double(queries[i][1]), double(queries[i][2])};
        const std::size_t size = tree.find_nearest(query, count, found.data());
        double squared_bandwidth = 0;
        for (std::size_t n = 0; n < size; ++n)
          squared_bandwidth += found[n].first / double(size);
        for (std::size_t n = 0; n < size; ++n)
        {
          near_points.indices[i * count + n] = found[n].second;
          near_points.weights[i * count + n] =
            squared_bandwidth > 0 ? float(gaussian_weight(found[n].first / squared_bandwidth, 1.))
                                  : 1.f;
        }
      }
      progress.advance(end - begin);
    });
}

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template void nearest_input_points<Sequential_tag, float>(
  const Point_tree_3&, const Buffer<std::array<float, 3>>&, Progress&, Near_points&);
extern template void nearest_input_points<Sequential_tag, double>(
  const Point_tree_3&, const Buffer<std::array<double, 3>>&, Progress&, Near_points&);
#ifdef CGAL_LINKED_WITH_TBB
extern template void nearest_input_points<Parallel_tag, float>(const Point_tree_3&,
                                                               const Buffer<std::array<float, 3>>&,
                                                               Progress&, Near_points&);
extern template void nearest_input_points<Parallel_tag, double>(
  const Point_tree_3&, const Buffer<std::array<double, 3>>&, Progress&, Near_points&);
#endif
#endif

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEAREST_INPUT_POINTS_H
