// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_BILATERAL_KERNEL_H
#define CGAL_L0_RESAMPLING_INTERNAL_BILATERAL_KERNEL_H

#include <CGAL/L0_resampling/internal/core/weights.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What weighs the normals of a ball around a point in Eq. (1).
/// \tparam T a floating-point number
template <typename T>
struct Bilateral_kernel
{
  T squared_radius;    ///< \f$ r_q^2 \f$
  T squared_bandwidth; ///< \f$ \sigma_q^2 \f$
  T normal_bandwidth;  ///< \f$ (1 - \cos\sigma_n)^2 \f$
};

/// The weight of Eq. (1), (2) of a pair of normals with this cosine, with the sign that turns one
/// of them to the side of the other; 0 outside of the ball.
/// \tparam S a number, or lanes of numbers
template <typename S, typename T>
CGAL_L0_HOST_DEVICE inline S signed_weight(const S& squared_distance, const S& cosine,
                                           const Bilateral_kernel<T>& kernel)
{
  return where_less(squared_distance, kernel.squared_radius,
                    with_sign_of(cosine,
                                 bilateral_weight(squared_distance, kernel.squared_bandwidth,
                                                  cosine, kernel.normal_bandwidth)));
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_BILATERAL_KERNEL_H
