// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SUM_OF_VECTORS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SUM_OF_VECTORS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A weighted sum of vectors.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Sum_of_vectors
{
  S x = S(), y = S(), z = S();

  CGAL_L0_HOST_DEVICE void add(const S& vx, const S& vy, const S& vz, const S& weight)
  {
    x += weight * vx;
    y += weight * vy;
    z += weight * vz;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SUM_OF_VECTORS_H
