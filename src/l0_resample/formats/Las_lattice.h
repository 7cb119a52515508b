// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_LAS_LATTICE_H
#define L0_RESAMPLE_LAS_LATTICE_H

#include "basis/Las_origin.h"
#include "formats/Point_rows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace l0_tool {

/// The coordinates that a LAS file can hold: an integer of 32 bits times the scale of the axis,
/// plus its offset.
struct Las_lattice
{
  std::array<double, 3> scale, offset;

  /// The nearest one.
  std::int32_t integer(double coordinate, std::size_t axis) const;

  double coordinate(std::int32_t integer, std::size_t axis) const
  {
    return integer * scale[axis] + offset[axis];
  }
};

/*!
Chooses the lattice for points, all of them finite: that of the file they come from, if they lie on
it. Else points are rounded by no more than a thousandth of their spacing: the scale is that of the
file if it is fine enough, or a power of ten, and the offset is near the middle of the points. The
scale is larger only where 32 bits would not hold all coordinates.
*/
Las_lattice choose_las_lattice(const Point_rows& rows, const std::optional<Las_origin>& origin);

} // namespace l0_tool

#endif // L0_RESAMPLE_LAS_LATTICE_H
