// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H

#include <CGAL/L0_resampling/internal/ball_queries.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Up to k nearest other samples of each sample, in no particular order.
class Nearest_samples
{
  std::size_t m_k;
  Buffer<Index> m_indices;   // k a sample, of which the first counts[i] are used
  Buffer<Index> m_counts;

public:
  Nearest_samples(std::size_t size, std::size_t k, const Counting_allocator<Index>& allocator)
    : m_k(k), m_indices(size * k, 0, allocator), m_counts(size, 0, allocator) {}

  const Index* begin(Index i) const { return m_indices.data() + i * m_k; }
  const Index* end(Index i) const { return begin(i) + m_counts[i]; }
  bool contains(Index i, Index k) const { return std::find(begin(i), end(i), k) != end(i); }
  std::size_t number_of_pairs() const { return m_indices.size(); }

  void add(Index i, Index k) { m_indices[i * m_k + m_counts[i]++] = k; }
};

/// Finds the k nearest samples of each sample. Where even a ball of 1000 times `spacing_guess` holds fewer, the list is shorter.
template <typename ConcurrencyTag>
Nearest_samples find_nearest_samples(const Buffer<Vector>& positions, std::size_t k, double spacing_guess, Progress& progress)
{
  const int number_of_doublings = 10;
  Nearest_samples nearest(positions.size(), k, positions.get_allocator());

  Buffer<unsigned char> is_open(positions.size(), 1, positions.get_allocator());
  Buffer<Index> open(positions.get_allocator());
  for (int doubling = 0; doubling <= number_of_doublings; ++doubling)
  {
    const double radius = std::ldexp(spacing_guess, doubling);
    const bool take_what_is_there = doubling == number_of_doublings;

    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(positions, radius);
    Buffer<Vector> sorted_positions(positions);
    apply_order(order, sorted_positions);
    const Search_grid_3 grid(sorted_positions, radius);

    open.clear();
    std::copy_if(order.begin(), order.end(), std::back_inserter(open), [&](Index i) { return is_open[i] != 0; });
    if (open.empty())
      break;
    Buffer<Vector> open_positions(positions);
    apply_order(open, open_positions);
    const Search_grid_3 open_grid(open_positions, radius);
    const auto make_visitor = [&]() {
      return [&, found = std::vector<std::pair<double, Index>>()](Search_grid_3::Range queries, const Local_points<double>& candidates,
                                                                  const Vector& origin) mutable {
        for (Index q = queries.first; q < queries.second; ++q)
        {
          const Vector center = open_positions[q] - origin;
          found.resize(candidates.indices.size() + 1);
          // Each candidate is written, and overwritten by the next one unless it is near: no branch that cannot be foreseen.
          std::size_t size = 0;
          for (std::size_t c = 0; c < candidates.indices.size(); ++c)
          {
            const Vector p(candidates.x[c], candidates.y[c], candidates.z[c]);
            const double squared_distance = (p - center).squaredNorm();
            found[size] = {squared_distance, order[candidates.indices[c]]};
            size += std::size_t(squared_distance < radius * radius) & std::size_t(found[size].second != open[q]);
          }
          if (size < k && !take_what_is_there)
            continue;
          const std::size_t count = (std::min)(k, size);
          std::nth_element(found.begin(), found.begin() + std::ptrdiff_t(count), found.begin() + std::ptrdiff_t(size));
          for (std::size_t n = 0; n < count; ++n)
            nearest.add(open[q], found[n].second);
          is_open[open[q]] = 0;
        }
      };
    };
    for_each_cell<double, ConcurrencyTag>(open_grid, open_positions, grid, sorted_positions, 1, progress, make_visitor);
  }
  return nearest;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H
