// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H

#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Up to k nearest other samples of each sample. Of these, the `number_of_first` nearest come
/// first; else they are in no particular order.
class Nearest_samples
{
  std::size_t m_k, m_number_of_first;
  Buffer<Index> m_indices; // k a sample, of which the first counts[i] are used
  Buffer<Index> m_counts;

public:
  Nearest_samples(std::size_t size, std::size_t k, std::size_t number_of_first,
                  const Counting_allocator<Index>& allocator)
    : m_k(k), m_number_of_first(number_of_first), m_indices(size * k, allocator),
      m_counts(filled_buffer(size, Index(0), allocator))
  {}

  const Index* begin(Index i) const { return m_indices.data() + i * m_k; }
  const Index* end(Index i) const { return begin(i) + m_counts[i]; }
  const Index* end_of_first(Index i) const
  {
    return begin(i) + (std::min)(std::size_t(m_counts[i]), m_number_of_first);
  }
  /// Whether k is one of the first of i. Counts, as that takes no branches, unlike a search.
  bool is_one_of_first(Index i, Index k) const
  {
    return std::count(begin(i), end_of_first(i), k) > 0;
  }

  void release()
  {
    internal::release(m_indices);
    internal::release(m_counts);
  }

  void add(Index i, Index k) { m_indices[i * m_k + m_counts[i]++] = k; }
};

/// The candidates in a ball around a sample, and the nearest of them.
class Candidates_in_ball
{
  std::size_t m_size = 0;
  float m_squared_radius = 0;
  Aligned_vector<float> m_squared_distances; // with room for full lanes
  std::vector<Index> m_indices, m_nearest;

public:
  std::size_t size() const { return m_size; }

  /// Lists those in the ball but `self`.
  void list(const Eigen::Vector3f& center, Index self, Local_points<float>& candidates,
            float squared_radius)
  {
    constexpr std::size_t lanes = Lanes<float>::size;
    const Index* const indices = candidates.indices.data();
    const std::size_t number_of_candidates = candidates.indices.size();
    m_squared_distances.resize(candidates.padded_size() + lanes);
    m_indices.resize(candidates.padded_size() + 1);
    m_squared_radius = squared_radius;
    m_size = 0;
    candidates.for_each_run_in_ball(
      center, squared_radius, [&](std::size_t first, const Lanes<float>& squared_distances) {
        float distances[lanes];
        squared_distances.store(distances);
        // Each candidate is written, and overwritten by the next one unless it is near: no branch
        // that cannot be foreseen.
        for (std::size_t c = 0, count = (std::min)(lanes, number_of_candidates - first); c < count;
             ++c)
        {
          const Index index = indices[first + c];
          m_squared_distances[m_size] = distances[c];
          m_indices[m_size] = index;
          m_size += std::size_t(distances[c] < squared_radius) & std::size_t(index != self);
        }
      });
  }

  /// The `count` nearest, and of these first the `number_of_first` nearest; of the equally near
  /// ones those that were listed first.
  /// \pre `number_of_first <= count && count <= size()`
  const std::vector<Index>& nearest(std::size_t number_of_first, std::size_t count)
  {
    m_nearest.resize(m_size + 1);
    const std::optional<float> reach = squared_reach_of(count, m_squared_radius, m_size),
                               reach_of_first = reach
                                                  ? squared_reach_of(number_of_first, *reach, count)
                                                  : std::nullopt;
    if (reach_of_first)
    {
      const std::size_t kept = keep_between(0, *reach_of_first, 0);
      if (number_of_first < count)
        keep_between(*reach_of_first, *reach, kept);
    }
    else
      keep_by_rank(number_of_first, count);
    m_nearest.resize(count);
    return m_nearest;
  }

private:
  /// A squared distance than which only `count` are nearer, found from how many are nearer than
  /// others: on a surface their number grows with the squared distance. A few counts of all take a
  /// quarter of the time of `std::nth_element()`, whose branches no processor foresees.
  /// \param high a squared distance than which `size` are nearer, at least `count`
  /// \returns nothing if there is no such distance or it was not found
  std::optional<float> squared_reach_of(std::size_t count, float high, std::size_t size)
  {
    using L = Lanes<float>;
    L((std::numeric_limits<float>::max)()).store(&m_squared_distances[m_size]);
    const auto number_nearer_than = [&](float squared_distance) {
      L number;
      for (std::size_t k = 0; k < m_size; k += L::size)
        number += where_less(L::load(&m_squared_distances[k]), squared_distance, L(1.f));
      return number.sum();
    };

    const int maximum_number_of_steps = 16;
    const float wanted = float(count);
    float low = 0, number_of_low = 0, number_of_high = float(size);
    for (int step = 0; number_of_high != wanted; ++step)
    {
      const float middle =
        low + (high - low) * (wanted + 0.5f - number_of_low) / (number_of_high + 1 - number_of_low);
      if (step == maximum_number_of_steps || !(low < middle && middle < high))
        return std::nullopt;
      const float number = number_nearer_than(middle);
      if (number < wanted)
        low = middle, number_of_low = number;
      else
        high = middle, number_of_high = number;
    }
    return high;
  }

  /// Keeps those at squared distances of [low, high) from the place `kept` on, and returns the
  /// place after them.
  std::size_t keep_between(float low, float high, std::size_t kept)
  {
    for (std::size_t c = 0; c < m_size; ++c)
    {
      m_nearest[kept] = m_indices[c];
      kept += std::size_t(low <= m_squared_distances[c])
              & std::size_t(m_squared_distances[c] < high);
    }
    return kept;
  }

  void keep_by_rank(std::size_t number_of_first, std::size_t count)
  {
    std::vector<std::pair<float, std::size_t>> places;
    for (std::size_t c = 0; c < m_size; ++c)
      places.emplace_back(m_squared_distances[c], c);
    const auto begin = places.begin(), end_of_first = begin + std::ptrdiff_t(number_of_first),
               end = begin + std::ptrdiff_t(count);
    std::nth_element(begin, end, places.end());
    if (number_of_first < count)
      std::nth_element(begin, end_of_first, end);
    for (std::size_t c = 0; c < count; ++c)
      m_nearest[c] = m_indices[places[c].second];
  }
};

/*!
Finds the k nearest samples of each sample, the `number_of_first` nearest of them first. Where even
a ball of 1000 times `spacing_guess` holds fewer, the list is shorter.

Looks at balls of twice the radius where a ball holds fewer than k, on the same grid as long as its
cells are not too many, then on a coarser one.
*/
template <typename ConcurrencyTag>
Nearest_samples find_nearest_samples(const Buffer<Vector>& positions, std::size_t number_of_first,
                                     std::size_t k, double spacing_guess, Progress& progress)
{
  const int number_of_doublings = 10, doublings_on_one_grid = 2;
  Nearest_samples nearest(positions.size(), k, number_of_first, positions.get_allocator());
  Buffer<unsigned char> is_open(positions.size(), 1, positions.get_allocator());
  std::atomic<std::size_t> number_of_open{positions.size()};

  for (int doubling = 0; doubling <= number_of_doublings && number_of_open > 0;)
  {
    const double cell_size = std::ldexp(spacing_guess, doubling);
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(positions, cell_size);
    Buffer<Vector> sorted_positions = copy_of(positions);
    apply_order<ConcurrencyTag>(order, sorted_positions);
    const Search_grid_3 grid(sorted_positions, cell_size);
    for (int last = (std::min)(doubling + doublings_on_one_grid, number_of_doublings);
         doubling <= last && number_of_open > 0; ++doubling)
    {
      const bool are_all_open = number_of_open
                                == positions.size(); // as in the first pass, the longest one
      Buffer<Index> open(positions.get_allocator()); // places in `order`
      Buffer<Vector> open_positions(positions.get_allocator());
      if (!are_all_open)
        for_each_in_order(order.size(), [&](std::size_t place) {
          if (is_open[order[place]])
          {
            open.push_back(Index(place));
            open_positions.push_back(sorted_positions[place]);
          }
        });
      const Search_grid_3 open_grid(open_positions, cell_size);
      const Search_grid_3& query_grid = are_all_open ? grid : open_grid;
      const Buffer<Vector>& query_positions = are_all_open ? sorted_positions : open_positions;

      const double radius = std::ldexp(spacing_guess, doubling);
      const bool take_what_is_there = doubling == number_of_doublings;
      const auto make_visitor = [&]() {
        return [&, found = Candidates_in_ball()](Search_grid_3::Range queries,
                                                 Local_points<float>& candidates,
                                                 const Vector& origin) mutable {
          std::size_t number_of_closed = 0;
          for (Index q = queries.first; q < queries.second; ++q)
          {
            const Index place = are_all_open ? q : open[q];
            found.list((query_positions[q] - origin).template cast<float>(), place, candidates,
                       float(radius * radius));
            if (found.size() < k && !take_what_is_there)
              continue;
            const Index sample = order[place];
            for (Index near_place : found.nearest((std::min)(number_of_first, found.size()),
                                                  (std::min)(k, found.size())))
              nearest.add(sample, order[near_place]);
            is_open[sample] = 0;
            ++number_of_closed;
          }
          number_of_open -= number_of_closed;
        };
      };
      for_each_cell<float, ConcurrencyTag>(query_grid, query_positions, grid, sorted_positions,
                                           cells_in_reach(radius, cell_size), progress,
                                           make_visitor);
    }
  }
  return nearest;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEAREST_SAMPLES_H
