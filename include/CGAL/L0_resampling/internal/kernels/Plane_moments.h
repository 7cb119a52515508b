// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PLANE_MOMENTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_PLANE_MOMENTS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How much a plane counts whose normal is the smallest eigenvector of this covariance. Of points
/// in a strip or a clump the two smaller variances are equal, and a rounding would choose the
/// normal.
CGAL_L0_HOST_DEVICE inline double share_of_plane(const Eigen_decomposition& eigen)
{
  return as_share((eigen.values[1] - eigen.values[0]) / (minimum_gap_of_plane * eigen.values[2]));
}

/// A plane through points.
struct Fitted_plane
{
  Triple normal;
  bool spans_plane; ///< whether the points determine it, and are not too few to be trusted
  double variance;  ///< of the points across it
  double share;     ///< how much it counts, `share_of_plane()`
  bool is_line;     ///< whether the points are on a line, up to noise
};

/// The weighted moments of points relative to some center, up to the second, and what a plane
/// through the points takes from them (Hoppe et al. 1992).
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Plane_moments
{
  S sum = S(), x = S(), y = S(), z = S(), xx = S(), xy = S(), xz = S(), yy = S(), yz = S(),
    zz = S();

  CGAL_L0_HOST_DEVICE void add(const S& dx, const S& dy, const S& dz, const S& weight)
  {
    const S wx = weight * dx, wy = weight * dy, wz = weight * dz;
    sum += weight;
    x += wx;
    y += wy;
    z += wz;
    xx += wx * dx;
    xy += wx * dy;
    xz += wx * dz;
    yy += wy * dy;
    yz += wy * dz;
    zz += wz * dz;
  }

  /// The same sums as other numbers, such as those of all lanes.
  template <typename S2, typename F>
  CGAL_L0_HOST_DEVICE Plane_moments<S2> transformed(const F& f) const
  {
    return {S2(f(sum)), S2(f(x)),  S2(f(y)),  S2(f(z)),  S2(f(xx)),
            S2(f(xy)),  S2(f(xz)), S2(f(yy)), S2(f(yz)), S2(f(zz))};
  }

  /// \pre `S` is a number, and `sum` is positive
  CGAL_L0_HOST_DEVICE Symmetric_matrix covariance() const
  {
    const double n = sum, mx = x / n, my = y / n, mz = z / n;
    return {xx / n - mx * mx, xy / n - mx * my, xz / n - mx * mz,
            yy / n - my * my, yz / n - my * mz, zz / n - mz * mz};
  }

  /// Of the covariance. The plane's normal is its smallest vector, the variance across it its
  /// smallest value.
  /// \pre `S` is a number, and `sum` is positive
  CGAL_L0_HOST_DEVICE Eigen_decomposition eigen_decomposition() const
  {
    return decompose(covariance());
  }

  /// The unit vector that most of the points lie along, as seen from the center, of any sign: the
  /// largest eigenvector of the second moments.
  /// \pre `S` is a number
  CGAL_L0_HOST_DEVICE Triple main_direction() const
  {
    return decompose({yy + zz, -xy, -xz, xx + zz, -yz, xx + yy}).smallest_vector;
  }

  /// The plane through points of weight 1 in a ball. Points on a line give a normal across it;
  /// coincident points give (0, 0, 1).
  /// \param epsilon of the number type of the points' coordinates
  CGAL_L0_HOST_DEVICE Fitted_plane plane(double squared_radius, double epsilon) const
  {
    Fitted_plane fit = {{0, 0, 1}, false, 0, 0, false};
    if (sum < 2)
      return fit;
    const Eigen_decomposition eigen = eigen_decomposition();
    const double longest = eigen.values[2] < squared_radius * 1e-6 ? squared_radius * 1e-6
                                                                   : eigen.values[2];
    const double rounding = 16 * epsilon * longest; // what is left of a variance across a line
    if (!(eigen.values[2] > rounding))
      return fit;
    fit.normal = eigen.smallest_vector;
    fit.spans_plane = eigen.values[1] > rounding && sum >= minimum_number_of_points_of_plane;
    fit.variance = eigen.values[0] < 0 ? 0 : eigen.values[0];
    fit.share = share_of_plane(eigen);
    fit.is_line = eigen.values[1] < minimum_gap_of_plane * eigen.values[2];
    return fit;
  }
};

/// The normal of a point whose own ball lies in a strip, such as one ring of a spinning scanner: as
/// far as that has no plane, the normal of a ball twice as large, as far as that has one.
/// \param own, wide of the two balls
CGAL_L0_HOST_DEVICE inline Triple normal_beyond_strip(const Fitted_plane& own,
                                                      const Fitted_plane& wide)
{
  const double weight = (1 - own.share) * wide.share,
               turned = with_sign_of(dot(own.normal, wide.normal), weight);
  const Triple sum = (1 - weight) * own.normal + turned * wide.normal;
  return dot(sum, sum) > 0 ? normalized(sum) : own.normal;
}

/// Whether no ball tells the normal of a point: it is on a line, such as one ring of a scanner that
/// is far from the next, and its normal is that of the noise.
/// \param own, wide of its ball and of one twice as large
CGAL_L0_HOST_DEVICE inline bool lies_on_line(const Fitted_plane& own, const Fitted_plane& wide)
{
  return own.is_line && wide.is_line;
}

/// The moments of all lanes.
template <typename L>
Plane_moments<double> sum_of_lanes(const Plane_moments<L>& m)
{
  return m.template transformed<double>([](const L& sum) { return sum.sum(); });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PLANE_MOMENTS_H
