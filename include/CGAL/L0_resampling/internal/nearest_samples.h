// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H

#include <CGAL/L0_resampling/internal/ball_queries.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Up to k nearest other samples of each sample, in no particular order.
class Nearest_samples
{
  std::size_t m_k;
  Buffer<Index> m_indices; // k a sample, of which the first counts[i] are used
  Buffer<Index> m_counts;

public:
  Nearest_samples(std::size_t size, std::size_t k, const Counting_allocator<Index>& allocator)
    : m_k(k), m_indices(filled_buffer(size * k, Index(0), allocator)), m_counts(filled_buffer(size, Index(0), allocator))
  {}

  const Index* begin(Index i) const { return m_indices.data() + i * m_k; }
  const Index* end(Index i) const { return begin(i) + m_counts[i]; }
  bool contains(Index i, Index k) const { return std::find(begin(i), end(i), k) != end(i); }

  void add(Index i, Index k) { m_indices[i * m_k + m_counts[i]++] = k; }
};

/// Lists the candidates in the ball but `self`, as numbers that ascend with the distance and have the candidate's index as their lower half.
/// \returns how many
inline std::size_t list_by_distance(const Eigen::Vector3f& center, Index self, const Local_points<float>& candidates,
                                    float squared_radius, std::vector<std::uint64_t>& found)
{
  constexpr std::size_t lanes = Lanes<float>::size;
  const Index* const indices = candidates.indices.data();
  const std::size_t number_of_candidates = candidates.indices.size();
  std::size_t size = 0;
  candidates.for_each_run_in_ball(center, squared_radius, [&](std::size_t first, const Lanes<float>& squared_distances) {
    float distances[lanes];
    squared_distances.store(distances);
    // Each candidate is written, and overwritten by the next one unless it is near: no branch that cannot be foreseen.
    for (std::size_t c = 0, count = (std::min)(lanes, number_of_candidates - first); c < count; ++c)
    {
      std::uint32_t bits; // ascend with the number, as it is not negative
      std::memcpy(&bits, &distances[c], sizeof bits);
      const Index index = indices[first + c];
      found[size] = (std::uint64_t(bits) << 32) | index;
      size += std::size_t(distances[c] < squared_radius) & std::size_t(index != self);
    }
  });
  return size;
}

/*!
Finds the k nearest samples of each sample. Where even a ball of 1000 times `spacing_guess` holds fewer, the list is shorter.

Looks at balls of twice the radius where a ball holds fewer than k, on the same grid as long as its cells are not too many, then on a coarser one.
*/
template <typename ConcurrencyTag>
Nearest_samples find_nearest_samples(const Buffer<Vector>& positions, std::size_t k, double spacing_guess,
                                     Progress& progress)
{
  const int number_of_doublings = 10, doublings_on_one_grid = 2;
  Nearest_samples nearest(positions.size(), k, positions.get_allocator());
  Buffer<unsigned char> is_open(positions.size(), 1, positions.get_allocator());
  std::atomic<std::size_t> number_of_open{positions.size()};

  for (int doubling = 0; doubling <= number_of_doublings && number_of_open > 0;)
  {
    const double cell_size = std::ldexp(spacing_guess, doubling);
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(positions, cell_size);
    Buffer<Vector> sorted_positions = copy_of(positions);
    apply_order(order, sorted_positions);
    const Search_grid_3 grid(sorted_positions, cell_size);
    for (int last = (std::min)(doubling + doublings_on_one_grid, number_of_doublings);
         doubling <= last && number_of_open > 0; ++doubling)
    {
      Buffer<Index> open(positions.get_allocator()); // places in `order`
      open.reserve(number_of_open);
      for_each_in_order(order.size(), [&](std::size_t place) {
        if (is_open[order[place]])
          open.push_back(Index(place));
      });
      Buffer<Vector> open_positions(positions.get_allocator());
      open_positions.reserve(open.size());
      for_each_in_order(open.size(), [&](std::size_t q) { open_positions.push_back(sorted_positions[open[q]]); });
      const Search_grid_3 open_grid(open_positions, cell_size);

      const double radius = std::ldexp(spacing_guess, doubling);
      const bool take_what_is_there = doubling == number_of_doublings;
      const auto make_visitor = [&]() {
        return [&, found = std::vector<std::uint64_t>()](
                 Search_grid_3::Range queries, const Local_points<float>& candidates, const Vector& origin) mutable {
          found.resize(candidates.padded_size() + 1);
          for (Index q = queries.first; q < queries.second; ++q)
          {
            const std::size_t size = list_by_distance((open_positions[q] - origin).template cast<float>(), open[q],
                                                      candidates, float(radius * radius), found);
            if (size < k && !take_what_is_there)
              continue;
            const std::size_t count = (std::min)(k, size);
            std::nth_element(found.begin(), found.begin() + std::ptrdiff_t(count), found.begin() + std::ptrdiff_t(size));
            const Index sample = order[open[q]];
            for (std::size_t n = 0; n < count; ++n)
              nearest.add(sample, order[Index(found[n])]);
            is_open[sample] = 0;
            --number_of_open;
          }
        };
      };
      for_each_cell<float, ConcurrencyTag>(open_grid, open_positions, grid, sorted_positions,
                                           cells_in_reach(radius, cell_size), progress, make_visitor);
    }
  }
  return nearest;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H
