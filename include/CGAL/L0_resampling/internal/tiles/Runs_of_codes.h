// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RUNS_OF_CODES_H
#define CGAL_L0_RESAMPLING_INTERNAL_RUNS_OF_CODES_H

#include <CGAL/L0_resampling/internal/cloud/estimate_scale_field.h>
#include <CGAL/L0_resampling/internal/kernels/Morton_points.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Places in Morton order, in runs: those in a cell of a level at which cells are no wider than the
/// paper's radius.
class Runs_of_codes
{
  Morton_cells m_cells;
  int m_level = 0;

public:
  explicit Runs_of_codes(const Facts& extents) : m_cells(cells_of_places(extents.robust_diagonal))
  {
    const double radius = paper_radius(extents);
    for (double width = 2 * m_cells.size;
         width <= radius && m_level + 2 < Morton_cells::number_of_levels; width *= 2)
      ++m_level;
  }

  const Morton_cells& cells() const { return m_cells; }
  std::uint64_t key_of(std::uint64_t code) const { return code >> 3 * m_level; }

  /// Whether it is among the outermost, which collect what lies beyond.
  bool is_outermost(std::uint64_t key) const
  {
    const std::uint64_t last = (std::uint64_t(1) << (Morton_cells::number_of_levels - m_level)) - 1;
    bool is = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::uint64_t place = Morton_cells::gather(key >> axis);
      is = is || place == 0 || place == last;
    }
    return is;
  }

  /// Calls `f(key, first, end)` for each run of codes.
  /// \param codes ascending
  template <typename F>
  void for_each(const std::uint64_t* codes, std::size_t size, const F& f) const
  {
    for (std::size_t end = 0; end < size;)
    {
      const std::size_t first = end;
      const std::uint64_t key = key_of(codes[first]);
      while (end < size && key_of(codes[end]) == key)
        ++end;
      f(key, first, end);
    }
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RUNS_OF_CODES_H
