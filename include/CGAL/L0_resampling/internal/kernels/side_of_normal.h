// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SIDE_OF_NORMAL_H
#define CGAL_L0_RESAMPLING_INTERNAL_SIDE_OF_NORMAL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cstdint>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Tells a vector from its opposite.
template <typename T>
CGAL_L0_HOST_DEVICE bool is_negative(const T& x, const T& y, const T& z)
{
  // No branches: they would be mispredicted half of the time.
  return (x < 0) | ((x == 0) & ((y < 0) | ((y == 0) & (z < 0))));
}

/// What a normal does at the end of the refinement, which does not look at sides: these may be
/// found later. Normals are not negative meanwhile. The two sheets of a thin part that it splits
/// look away from each other.
enum class Side_after_refinement : signed char
{
  AS_IT_IS,
  TURNED,
  OUTWARDS ///< as it is, whatever is found later
};

/// Of the samples of a tile that look outwards; all others are of trees whose sides are found
/// later.
constexpr std::uint32_t tree_of_known_sides = (std::numeric_limits<std::uint32_t>::max)();

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SIDE_OF_NORMAL_H
