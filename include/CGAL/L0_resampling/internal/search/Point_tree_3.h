// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINT_TREE_3_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINT_TREE_3_H

#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
A kd-tree that answers in double precision and breaks ties by index, so that an answer depends
neither on rounding within a cell nor on how the tree was built. A grid has one cell size; this one
holds for queries far from all points, and for a million points at one place, of which no more are
looked at than are asked for. CGAL's tree breaks no ties, and its memory is not counted.
*/
class Point_tree_3
{
  static constexpr std::size_t points_per_leaf = 8;
  static constexpr std::size_t points_per_look = 65536; // at the loop
  static constexpr std::size_t too_few_for_threads = 16384;
  static constexpr unsigned char no_axis = 3; // of a node whose points are all at one place,
                                              // in the order of their indices

  // The node of [begin, end) is the point in its middle; smaller ones along its axis stand before
  // it.
  Buffer<Vector> m_points;
  Buffer<Index> m_indices;
  Buffer<unsigned char> m_axes;
  int m_exponent = 0; // brings the largest coordinate below 1, so that no square overflows

public:
  /// A point of the tree by its squared distance, in the unit of the tree, and its index.
  using Candidate = std::pair<double, Index>;

  /// \param points finite
  /// \param indices one for each point
  template <typename ConcurrencyTag>
  Point_tree_3(ConcurrencyTag, Buffer<Vector> points, Buffer<Index> indices)
    : m_points(std::move(points)), m_indices(std::move(indices)),
      m_axes(m_points.size(), no_axis, m_points.get_allocator())
  {
    double largest = 0;
    for_each_in_order(m_points.size(), [&](std::size_t i) {
      largest = (std::max)(largest, m_points[i].cwiseAbs().maxCoeff());
    });
    if (largest > 0)
      m_exponent = -std::ilogb(largest) - 1;
    for_each_in_order(m_points.size(), [&](std::size_t i) { m_points[i] = scaled(m_points[i]); });

    Buffer<Index> order(m_indices.get_allocator());
    order.reserve(m_points.size());
    for_each_in_order(m_points.size(), [&](std::size_t i) { order.push_back(Index(i)); });
    build<ConcurrencyTag>(0, order.size(), order);
    apply_order<ConcurrencyTag>(order, m_points);
    apply_order<ConcurrencyTag>(order, m_indices);
  }

  /// Finds the `k` points nearest to `query`, by distance and, where distances are equal, by index;
  /// fewer if there are fewer.
  /// \param found room for k
  /// \returns how many there are
  std::size_t find_nearest(const Vector& query, std::size_t k, Candidate* found) const
  {
    Search search{scaled(query), k, found, 0};
    visit(0, m_points.size(), search);
    return search.size;
  }

private:
  struct Search
  {
    Vector query;
    std::size_t k;
    Candidate* found; // ascending
    std::size_t size;

    bool may_hold(double squared_distance) const
    {
      return size < k || squared_distance <= found[size - 1].first;
    }

    void add(const Candidate& candidate)
    {
      if (size == k && !(candidate < found[size - 1]))
        return;
      size += size < k;
      std::size_t place = size - 1;
      for (; place > 0 && candidate < found[place - 1]; --place)
        found[place] = found[place - 1];
      found[place] = candidate;
    }
  };

  Vector scaled(const Vector& p) const
  {
    return {std::ldexp(p[0], m_exponent), std::ldexp(p[1], m_exponent),
            std::ldexp(p[2], m_exponent)};
  }

  static std::size_t middle_of(std::size_t begin, std::size_t end)
  {
    return begin + (end - begin) / 2;
  }

  template <typename ConcurrencyTag>
  void build(std::size_t begin, std::size_t end, Buffer<Index>& order)
  {
    if (end - begin <= points_per_leaf)
      return;
    Vector low = m_points[order[begin]], high = low;
    for (std::size_t i = begin; i < end; ++i)
    {
      if (i % points_per_look == 0)
        poll_for_cancellation();
      low = low.cwiseMin(m_points[order[i]]);
      high = high.cwiseMax(m_points[order[i]]);
    }
    const auto at = [&](std::size_t i) { return order.begin() + std::ptrdiff_t(i); };
    const auto has_smaller_index = [&](Index a, Index b) { return m_indices[a] < m_indices[b]; };
    const std::size_t middle = middle_of(begin, end);
    Eigen::Index axis;
    std::size_t number_of_comparisons = 0;
    if (!((high - low).maxCoeff(&axis) > 0))
    {
      std::sort(at(begin), at(end), watched_order(has_smaller_index, number_of_comparisons));
      return;
    }
    const auto is_lower = [&](Index a, Index b) {
      return m_points[a][axis] != m_points[b][axis] ? m_points[a][axis] < m_points[b][axis]
                                                    : has_smaller_index(a, b);
    };
    std::nth_element(at(begin), at(middle), at(end),
                     watched_order(is_lower, number_of_comparisons));
    m_axes[middle] = static_cast<unsigned char>(axis);
    if (end - begin < too_few_for_threads)
    {
      build<Sequential_tag>(begin, middle, order);
      build<Sequential_tag>(middle + 1, end, order);
      return;
    }
    for_each_block<ConcurrencyTag>(2, 1, [&](std::size_t half, std::size_t) {
      build<ConcurrencyTag>(half == 0 ? begin : middle + 1, half == 0 ? middle : end, order);
    });
  }

  void add(std::size_t i, Search& search) const
  {
    search.add({(m_points[i] - search.query).squaredNorm(), m_indices[i]});
  }

  void visit(std::size_t begin, std::size_t end, Search& search) const
  {
    const std::size_t middle = middle_of(begin, end);
    const bool is_leaf = end - begin <= points_per_leaf;
    if (is_leaf || m_axes[middle] == no_axis)
    {
      const std::size_t looked_at = is_leaf ? end - begin : (std::min)(end - begin, search.k);
      for (std::size_t i = begin; i < begin + looked_at; ++i)
        add(i, search);
      return;
    }
    const double beyond = search.query[m_axes[middle]] - m_points[middle][m_axes[middle]];
    const bool is_low = beyond < 0;
    visit(is_low ? begin : middle + 1, is_low ? middle : end, search);
    add(middle, search);
    if (search.may_hold(beyond * beyond))
      visit(is_low ? middle + 1 : begin, is_low ? end : middle, search);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINT_TREE_3_H
