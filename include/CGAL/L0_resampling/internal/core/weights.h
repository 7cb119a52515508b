// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_WEIGHTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_WEIGHTS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>
#include <type_traits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// The weight functions of the paper. `T` is a number, or an Eigen array of numbers that are
// computed at once; `S` is the type of one number.

/// \f$ \max(x, low) \f$, entry by entry.
template <typename T, typename S>
CGAL_L0_HOST_DEVICE inline T at_least(const T& x, S low)
{
  if constexpr (std::is_arithmetic<T>::value)
    return x < T(low) ? T(low) : x;
  else
    return (x.max)(typename T::Scalar(low));
}

/// \f$ \min(x, high) \f$, entry by entry.
template <typename T, typename S>
CGAL_L0_HOST_DEVICE inline T at_most(const T& x, S high)
{
  if constexpr (std::is_arithmetic<T>::value)
    return x > T(high) ? T(high) : x;
  else
    return (x.min)(typename T::Scalar(high));
}

/// The values, not negative, with the signs of `signs`, entry by entry; 0 where a sign is that of
/// 0. This is how one normal is turned to the side of another: of two normals at a right angle
/// neither side is the right one, and the result must not depend on the signs of the input normals.
template <typename T>
CGAL_L0_HOST_DEVICE inline T with_sign_of(const T& signs, const T& values)
{
  if constexpr (std::is_arithmetic<T>::value)
    return signs > 0 ? values : signs < 0 ? -values : T(0);
  else
    return values.with_sign_of(signs);
}

/// The values where `a < b`, 0 elsewhere.
template <typename T>
CGAL_L0_HOST_DEVICE inline typename std::enable_if<std::is_arithmetic<T>::value, T>::type
where_less(T a, T b, T values)
{
  return a < b ? values : T(0);
}

CGAL_L0_HOST_DEVICE inline double square(double x) { return x * x; }
CGAL_L0_HOST_DEVICE inline double cube(double x) { return x * x * x; }

/// The nearest number to x that is a share of 1.
CGAL_L0_HOST_DEVICE inline double as_share(double x) { return x > 1 ? 1 : x > 0 ? x : 0; }

/// \f$ e^{-x} \f$ for x >= 0. Stops falling at e^-40, far below the rounding of any sum it enters:
/// smaller values run into subnormal numbers, with which processors are a hundred times slower.
template <typename T>
CGAL_L0_HOST_DEVICE inline T decay(const T& x)
{
  using std::exp;
  return T(exp(T(-at_most(x, 40))));
}

/// \f$ \theta(d) = e^{-d^2/\sigma_q^2} \f$ of Eq. (2), in (0, 1].
template <typename T, typename S>
CGAL_L0_HOST_DEVICE inline T gaussian_weight(const T& squared_distance, S squared_bandwidth)
{
  return decay(T(squared_distance * (1 / squared_bandwidth)));
}

/// \f$ \theta \psi \f$ of Eq. (1) and (2), in (0, 1], with
/// \f$ \psi = e^{-(1 - |n^T n'|)^2 / (1 - \cos\sigma_n)^2} \f$, which is Eq. (2) with two changes.
/// The square is EAR's and not in the print, whose form hardly filters: on noisy normals it leaves
/// 24.6 of 25.0 degrees of error at edges where the square leaves 18.7. The absolute value makes
/// the weight blind to the sign of the normals, which PCA leaves open.
template <typename T, typename S>
CGAL_L0_HOST_DEVICE inline T bilateral_weight(const T& squared_distance, S squared_bandwidth,
                                              const T& cosine, S normal_bandwidth)
{
  using std::abs;
  const T difference = 1 - T(abs(cosine));
  return decay(T(squared_distance * (1 / squared_bandwidth)
                 + T(difference * difference) * (1 / normal_bandwidth)));
}

/// The weight of a point in a ball whose end is soft, so that no rounding decides whether the point
/// counts: 1, falling to 0 over the last tenth of the squared radius, and 0 beyond. A ball of
/// infinite radius has no end.
template <typename T, typename S>
CGAL_L0_HOST_DEVICE inline T share_in_ball(const T& squared_distance, S squared_radius)
{
  return at_most(at_least(T(S(10) - squared_distance * (10 / squared_radius)), S(0)), S(1));
}

/// \f$ \bar\theta e^{-h^2/J^2} \f$, where \f$ \bar\theta(d) = e^{d^2/r_p^2} \f$ of Eq. (4) grows
/// with the distance, from 1, and the other factor is 1 in LOR and ALOR: in the default method it
/// lets go of pairs with a wide jump between them, such as those of two sheets. Self neighbors
/// start closer than r_p/2 but are kept while they move. Beyond r_p the first weight stays at e,
/// where the printed form would overflow for pairs that drift apart.
/// \param squared_height \f$ h^2 \f$, with the larger of the heights of each sample over the plane
/// of the other
/// \param squared_jump \f$ J^2 \f$, may be infinite
template <typename T, typename S>
CGAL_L0_HOST_DEVICE inline T pair_weight(const T& squared_distance, S squared_radius,
                                         const T& squared_height, S squared_jump)
{
  using std::exp;
  return T(exp(T(at_most(T(squared_distance * (1 / squared_radius)), 1)
                 - at_most(T(squared_height * (1 / squared_jump)), 40))));
}

/// \f$ \theta \psi e^{-h^2/H^2} \f$: `bilateral_weight()` for the points of one sheet only.
/// \param height `symmetric_height()`
/// \param squared_sheet_height \f$ H^2 \f$
template <typename T, typename S>
CGAL_L0_HOST_DEVICE inline T sheet_weight(const T& squared_distance, S squared_bandwidth,
                                          const T& cosine, S normal_bandwidth, const T& height,
                                          S squared_sheet_height)
{
  using std::abs;
  const T difference = 1 - T(abs(cosine));
  return decay(T(squared_distance * (1 / squared_bandwidth)
                 + T(difference * difference) * (1 / normal_bandwidth)
                 + T(height * height) * (1 / squared_sheet_height)));
}

/// The height of a point over the sheet of another, by the planes of both, half and half:
/// \f$ \frac12 (n_i + n_j)^T (q_j - p_i) \f$ with \f$ n_j \f$ turned to the side of \f$ n_i \f$. It
/// is zero for any two points of one sphere (the symmetric distance of Rusinkiewicz 2019), so that
/// curvature is no height.
/// \param own_height, turned_other_height \f$ n_i^T (q_j - p_i) \f$ and \f$ n_j^T (q_j - p_i) \f$
template <typename T>
CGAL_L0_HOST_DEVICE inline T symmetric_height(const T& own_height, const T& turned_other_height)
{
  return T(T(own_height + turned_other_height) * 0.5f);
}

/// The variance of numbers about their weighted mean.
/// \param weight, sum, squares \f$ \sum_j w_j \f$, \f$ \sum_j w_j h_j \f$ and
/// \f$ \sum_j w_j h_j^2 \f$
CGAL_L0_HOST_DEVICE inline double weighted_variance(double weight, double sum, double squares)
{
  const double variance = squares / weight - sum * sum / (weight * weight);
  return variance > 0 ? variance : 0;
}

/// The variance of a weighted mean: that of the numbers themselves, and what is left of it in a
/// mean so weighted.
/// \param weight, sum, squares as of `weighted_variance()`
/// \param squared_weights \f$ \sum_j w_j^2 \f$
CGAL_L0_HOST_DEVICE inline double variance_of_mean(double weight, double squared_weights,
                                                   double sum, double squares)
{
  return weighted_variance(weight, sum, squares) * squared_weights / (weight * weight);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_WEIGHTS_H
