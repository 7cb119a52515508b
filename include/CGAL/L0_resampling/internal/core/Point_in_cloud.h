// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_POINT_IN_CLOUD_H
#define CGAL_L0_RESAMPLING_INTERNAL_POINT_IN_CLOUD_H

#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What a tile has to know of a point that it reads: what a look at the whole cloud finds of it.
/// Plain data, which goes to files and to devices as it is.
struct Point_in_cloud
{
  std::uint64_t units = 0; ///< the area that it stands for; 0 if it is an outlier
  /// In the order of the whole cloud, modulo 2^32: random numbers follow from it, and nothing else.
  std::uint32_t index = 0;
  std::uint32_t number_of_samples = 0; ///< that start on it, or between it and another
  float scale = 1;                     ///< of its radius
  std::uint32_t is_own = 0;            ///< 1 if the tile keeps these samples, 0 if another does
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_POINT_IN_CLOUD_H
