// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MORTON_PLACES_H
#define CGAL_L0_RESAMPLING_INTERNAL_MORTON_PLACES_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/parallel_sort.h>
#include <CGAL/L0_resampling/internal/kernels/Morton_points.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Owns the arrays that `Morton_points` shows.
class Morton_places
{
  Morton_cells m_cells;
  Buffer<std::uint64_t> m_codes;
  Buffer<Vector> m_places;

public:
  /// \param codes ascending, all different
  Morton_places(const Morton_cells& cells, Buffer<std::uint64_t> codes)
    : m_cells(cells), m_codes(std::move(codes)), m_places(m_codes.get_allocator())
  {
    m_places.reserve(m_codes.size());
    for (std::uint64_t code : m_codes)
      m_places.push_back({cells.middle(code, 0), cells.middle(code, 1), cells.middle(code, 2)});
  }

  const Morton_cells& cells() const { return m_cells; }
  const Buffer<std::uint64_t>& codes() const { return m_codes; }

  Morton_points view() const
  {
    return {m_cells, m_codes.size(), m_codes.data(), coordinates(m_places)};
  }

  std::size_t number_of_bytes() const
  {
    return m_codes.size() * (sizeof(std::uint64_t) + sizeof(Vector));
  }

  /// Every `stride`-th place.
  Morton_places one_of(std::size_t stride) const
  {
    Buffer<std::uint64_t> codes(m_codes.get_allocator());
    for (std::size_t i = 0; i < m_codes.size(); i += stride)
      codes.push_back(m_codes[i]);
    return {m_cells, std::move(codes)};
  }
};

/// The places of points.
template <typename ConcurrencyTag>
Morton_places places_of(const Buffer<Vector>& points, const Morton_cells& cells)
{
  Buffer<std::uint64_t> codes(points.size(), points.get_allocator());
  for_each_block<ConcurrencyTag>(points.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      codes[i] = cells.code(points[i].data());
  });
  sort_by_key<ConcurrencyTag>(
    codes, [](std::uint64_t code) { return code; },
    [](std::uint64_t, std::uint64_t) { return false; });
  codes.resize(std::size_t(std::unique(codes.begin(), codes.end()) - codes.begin()));
  return {cells, std::move(codes)};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MORTON_PLACES_H
