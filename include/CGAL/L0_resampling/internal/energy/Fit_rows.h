// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIT_ROWS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIT_ROWS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/energy/half_sampling.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The fit term as the paper has it, one term a neighbor: \f$ M_{p_i} \f$, or \f$ \hat{M}_{p_i} \f$
/// after half-sampling, of every sample. Only solvers that ask for the rows of Eq. (11) pay for
/// this.
struct Fit_rows
{
  Buffer<std::size_t> offsets; ///< the neighbors of sample i are `[offsets[i], offsets[i+1])`
  Buffer<Vector> positions;    ///< of each neighbor
  Buffer<double> weights;      ///< \f$ 1/v_j \f$, or the sum of those merged

  Explicit_rows<double> view(const Buffer<Vector>& origins,
                             const Buffer<double>& normal_offsets) const
  {
    return {offsets.data(), coordinates(positions), weights.data(), normal_offsets.data(),
            coordinates(origins)};
  }
};

/// Puts the rows of sample `order[i]` in place `i`.
inline void apply_order(const Buffer<Index>& order, Fit_rows& rows)
{
  Fit_rows sorted{Buffer<std::size_t>(rows.offsets.get_allocator()),
                  Buffer<Vector>(rows.positions.get_allocator()),
                  Buffer<double>(rows.weights.get_allocator())};
  sorted.offsets.push_back(0);
  sorted.offsets.reserve(rows.offsets.size());
  sorted.positions.reserve(rows.positions.size());
  sorted.weights.reserve(rows.weights.size());
  for_each_in_order(order.size(), [&](std::size_t place) {
    const Index i = order[place];
    const auto first = std::ptrdiff_t(rows.offsets[i]), last = std::ptrdiff_t(rows.offsets[i + 1]);
    sorted.positions.insert(sorted.positions.end(), rows.positions.begin() + first,
                            rows.positions.begin() + last);
    sorted.weights.insert(sorted.weights.end(), rows.weights.begin() + first,
                          rows.weights.begin() + last);
    sorted.offsets.push_back(sorted.positions.size());
  });
  rows = std::move(sorted);
}

/*!
Lists the original neighbors of each sample, halved `number_of_passes` times by Algorithm 2.

\param radius \f$ r_p \f$
\param input_density_weights \f$ v_j \f$
*/
template <typename ConcurrencyTag, typename T>
Fit_rows gather_fit_rows(const Search_grid_3& sample_grid, const Buffer<Vector>& samples,
                         const Search_grid_3& grid, const Buffer<Vector>& points,
                         const Buffer<T>& input_density_weights, double radius,
                         std::size_t number_of_passes, Progress& progress)
{
  const auto allocator = samples.get_allocator();
  const double squared_radius = radius * radius;
  Fit_rows rows{filled_buffer(samples.size() + 1, std::size_t(0), allocator),
                Buffer<Vector>(allocator), Buffer<double>(allocator)};

  // The neighbors of one sample, in the order of the points, at most every stride-th as in
  // `collapse_fit_term()`
  const auto for_each_neighbor = [&](Index i, const Local_points<T>& candidates,
                                     const Vector& origin, const auto& f) {
    const Eigen::Matrix<T, 3, 1> center = (samples[i] - origin).template cast<T>();
    for (std::size_t k = 0; k < candidates.indices.size(); ++k)
    {
      const T dx = candidates.x[k] - center[0], dy = candidates.y[k] - center[1],
              dz = candidates.z[k] - center[2];
      if (dx * dx + dy * dy + dz * dz < T(squared_radius))
        f(candidates.indices[k]);
    }
  };
  const int reach = cells_in_reach(radius, grid.cell_size());

  for_each_cell<T, ConcurrencyTag>(sample_grid, samples, grid, points, reach, progress, [&]() {
    return [&](Search_grid_3::Range queries, const Local_points<T>& candidates,
               const Vector& origin) {
      for (Index i = queries.first; i < queries.second; ++i)
      {
        std::size_t count = 0;
        for_each_neighbor(i, candidates, origin, [&](Index) { ++count; });
        for (std::size_t pass = 0; pass < number_of_passes; ++pass)
          count -= count / 2;
        rows.offsets[i + 1] = (std::max)(count,
                                         std::size_t(1)); // a lonely sample is tied to where it is
      }
    };
  });
  for_each_in_order(samples.size(), [&](std::size_t i) { rows.offsets[i + 1] += rows.offsets[i]; });
  fill_buffer(rows.offsets.back(), Vector(Vector::Zero()), rows.positions);
  fill_buffer(rows.offsets.back(), 0., rows.weights);

  for_each_cell<T, ConcurrencyTag>(sample_grid, samples, grid, points, reach, progress, [&]() {
    return [&, pair_up = Pair_partitioner<double>(), positions = std::vector<Vector>(),
            weights = std::vector<double>()](Search_grid_3::Range queries,
                                             const Local_points<T>& candidates,
                                             const Vector& origin) mutable {
      for (Index i = queries.first; i < queries.second; ++i)
      {
        positions.clear();
        weights.clear();
        for_each_neighbor(i, candidates, origin, [&](Index j) {
          positions.push_back(points[j]);
          weights.push_back(1 / double(input_density_weights[j]));
        });
        if (positions.empty())
        {
          positions.push_back(samples[i]);
          weights.push_back(1);
        }
        std::size_t size = positions.size();
        for (std::size_t pass = 0; pass < number_of_passes; ++pass)
          size = merge_pairs(pair_up(positions.data()->data(), size), positions.data()->data(),
                             weights.data());
        std::copy_n(positions.begin(), size,
                    rows.positions.begin() + std::ptrdiff_t(rows.offsets[i]));
        std::copy_n(weights.begin(), size, rows.weights.begin() + std::ptrdiff_t(rows.offsets[i]));
      }
    };
  });
  return rows;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIT_ROWS_H
