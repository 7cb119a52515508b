// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIT_KERNEL_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIT_KERNEL_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What weighs the points of a ball that a surface is fitted to.
/// \tparam T a floating-point number
template <typename T>
struct Fit_kernel
{
  T radius;
  T squared_bandwidth;    ///< may be infinite
  T normal_bandwidth;     ///< \f$ (1 - \cos\sigma_n)^2 \f$
  T squared_sheet_height; ///< \f$ H^2 \f$

  CGAL_L0_HOST_DEVICE T squared_radius() const { return radius * radius; }

  CGAL_L0_HOST_DEVICE Fit_kernel scaled(T scale) const
  {
    const T s = scale * scale;
    return {radius * scale, squared_bandwidth * s, normal_bandwidth, squared_sheet_height * s};
  }

  /// The same of other numbers.
  template <typename T2>
  Fit_kernel<T2> as() const
  {
    return {T2(radius), T2(squared_bandwidth), T2(normal_bandwidth), T2(squared_sheet_height)};
  }
};

/// A point of a ball, as the one at the center sees it.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Seen_point
{
  S cosine;     ///< of the angle between the normals
  S sign;       ///< of that, which turns the point's normal to the side of the center's
  S own_height; ///< over the plane across the center's normal
  S height;     ///< `symmetric_height()`

  /// \param dx, dy, dz the point, relative to the center
  /// \param nx, ny, nz its normal
  /// \param own_x, own_y, own_z the center's normal
  template <typename T>
  CGAL_L0_HOST_DEVICE Seen_point(const S& dx, const S& dy, const S& dz, const S& nx, const S& ny,
                                 const S& nz, const T& own_x, const T& own_y, const T& own_z)
    : cosine(nx * own_x + ny * own_y + nz * own_z), sign(with_sign_of(cosine, S(T(1)))),
      own_height(dx * own_x + dy * own_y + dz * own_z),
      height(symmetric_height(own_height, S(sign * (dx * nx + dy * ny + dz * nz))))
  {}
};

/// The weight \f$ \theta \psi e^{-h^2/H^2} \f$ of a point of a ball, without the end of the ball.
/// \param cosine, height as of `Seen_point`
/// \tparam S a number, or lanes of numbers
template <typename S, typename T>
CGAL_L0_HOST_DEVICE S weight_in_sheet(const S& squared_distance, const S& cosine, const S& height,
                                      const Fit_kernel<T>& kernel)
{
  return sheet_weight(squared_distance, kernel.squared_bandwidth, cosine, kernel.normal_bandwidth,
                      height, kernel.squared_sheet_height);
}

/// The same with the end of the ball, `share_in_ball()`.
template <typename S, typename T>
CGAL_L0_HOST_DEVICE S weight_in_ball(const S& squared_distance, const S& cosine, const S& height,
                                     const Fit_kernel<T>& kernel)
{
  return share_in_ball(squared_distance, kernel.squared_radius())
         * weight_in_sheet(squared_distance, cosine, height, kernel);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIT_KERNEL_H
