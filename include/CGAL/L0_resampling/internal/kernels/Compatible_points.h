// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_COMPATIBLE_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_COMPATIBLE_POINTS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Border_of_ball.h>
#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Sums over the points of a ball, each with the weight
/// \f$ w_j = \theta \psi e^{-h_{ij}^2/H^2} / v_j \f$.
/// \tparam S a number, or lanes of numbers
template <typename S>
struct Compatible_points
{
  S all = S();                    ///< \f$ \sum_j \theta / v_j \f$
  Plane_moments<S> places;        ///< of \f$ q_j - p_i \f$, with the weights \f$ w_j \f$
  S squared_weights = S();        ///< \f$ \sum_j w_j^2 \f$
  S height = S();                 ///< \f$ \sum_j w_j h_{ij} \f$
  S squared_heights = S();        ///< \f$ \sum_j w_j h_{ij}^2 \f$
  S nx = S(), ny = S(), nz = S(); ///< \f$ \sum_j w_j n_j \f$, turned to the side of \f$ n_i \f$

  /// \param dx, dy, dz \f$ q_j - p_i \f$
  /// \param squared_distance of the two
  /// \param px, py, pz \f$ n_j \f$
  /// \param scale \f$ \theta / v_j \f$ for the cut at the radius, 0 outside of the ball
  /// \param normal_x, normal_y, normal_z \f$ n_i \f$
  template <typename T>
  CGAL_L0_HOST_DEVICE void add(const S& dx, const S& dy, const S& dz, const S& squared_distance,
                               const S& px, const S& py, const S& pz, const S& scale, T normal_x,
                               T normal_y, T normal_z, const Fit_kernel<T>& kernel)
  {
    const Seen_point<S> point(dx, dy, dz, px, py, pz, normal_x, normal_y, normal_z);
    const S h = point.height,
            w = scale * weight_in_sheet(squared_distance, point.cosine, point.height, kernel),
            signed_weight = point.sign * w;
    all += scale;
    places.add(dx, dy, dz, w);
    squared_weights += w * w;
    height += w * h;
    squared_heights += w * h * h;
    nx += signed_weight * px;
    ny += signed_weight * py;
    nz += signed_weight * pz;
  }

  /// \f$ \sum_j w_j \f$
  CGAL_L0_HOST_DEVICE S weight() const { return places.sum; }

  /// The same sums as other numbers, such as those of all lanes.
  template <typename S2, typename F>
  CGAL_L0_HOST_DEVICE Compatible_points<S2> transformed(const F& f) const
  {
    return {S2(f(all)),
            places.template transformed<S2>(f),
            S2(f(squared_weights)),
            S2(f(height)),
            S2(f(squared_heights)),
            S2(f(nx)),
            S2(f(ny)),
            S2(f(nz))};
  }
};

/// The sheet in which a sample looks a second time for its points: as high as others for one that
/// is unsupported, and lower where points scatter more than those of one sheet.
CGAL_L0_HOST_DEVICE inline double squared_height_of_second_look(
  const Unsupported_sample& support, const Compatible_points<double>& sums,
  double squared_sheet_height)
{
  return support.is_unsupported
           ? support.squared_sheet_height
           : squared_sheet_height_among(squared_sheet_height,
                                        weighted_variance(sums.weight(), sums.height,
                                                          sums.squared_heights));
}

/// Whether the points around a sample scatter more than those of one sheet with the noise that was
/// estimated do: as those of two sheets that became one, or those of larger noise.
/// \param sums of the first look
CGAL_L0_HOST_DEVICE inline bool is_unexplained(const Unsupported_sample& support,
                                               const Compatible_points<double>& sums,
                                               double squared_sheet_height)
{
  return !support.is_unsupported
         && weighted_variance(sums.weight(), sums.height, sums.squared_heights)
              > variance_of_two_sheets * squared_sheet_height;
}

/*!
The standard deviation of the points of a fit across the surface. Their weights fall off with the
height as \f$ e^{-h^2/H^2} \f$ and with the distance as \f$ e^{-d^2/\sigma_p^2} \f$, so that
Gaussian heights of the variance \f$ \sigma^2 \f$ have the weighted variance v, with

\f[ \frac{1}{v} = \frac{1}{\sigma^2} + \frac{2}{H^2} + \frac{2}{\sigma_p^2}. \f]

Where the points fill the sheet, v is what the weights let through and tells no \f$ \sigma \f$;
then the result is the one at which v is nine tenths of that.

\param sums of the fit, without points or not
\param kernel of these sums
*/
template <typename T>
CGAL_L0_HOST_DEVICE double noise_of_fit(const Compatible_points<double>& sums,
                                        const Fit_kernel<T>& kernel)
{
  if (!(sums.weight() > minimum_weight_of_compatible_points))
    return 0;
  const double variance = weighted_variance(sums.weight(), sums.height, sums.squared_heights),
               rest = 1
                      - 2 * variance
                          * (1 / double(kernel.squared_sheet_height)
                             + 1 / double(kernel.squared_bandwidth));
  return std::sqrt(variance / (rest > 0.1 ? rest : 0.1));
}

/// What the points of its ball make of a sample.
struct Fit_of_sample
{
  bool has_points;     ///< else nothing of the others holds
  double variance;     ///< of the mean height
  Triple to_centroid;  ///< \f$ c_i - p_i \f$
  Triple outward;      ///< as long as the root of the share that is held back
  bool has_new_normal; ///< whether the mean of the normals has a direction
  Triple normal;       ///< that direction

  /// \param normal \f$ n_i \f$ of the sums
  /// \param border of balls of scale 1
  /// \param scale of the sample
  CGAL_L0_HOST_DEVICE Fit_of_sample(const Compatible_points<double>& sums, const Triple& own_normal,
                                    const Border_of_ball& border, double scale)
    : has_points(sums.weight() > minimum_weight_of_compatible_points),
      variance(0), to_centroid{0, 0, 0}, outward{0, 0, 0}, has_new_normal(false), normal(own_normal)
  {
    if (!has_points)
      return;
    const double total = sums.weight();
    variance = variance_of_mean(total, sums.squared_weights, sums.height, sums.squared_heights);
    const Offset_of_mean offset(sums.places, square(total) / sums.squared_weights, own_normal,
                                border.variance * square(scale));
    to_centroid = sums.height / total * own_normal + border.way_back(offset) * offset.direction;
    outward = -std::sqrt(border.share_held_back(offset)) * offset.direction;
    const Triple mean_normal = {sums.nx, sums.ny, sums.nz};
    const double length = std::sqrt(dot(mean_normal, mean_normal));
    has_new_normal = length > minimum_length_of_mean_normal * total;
    if (has_new_normal)
      normal = 1 / length * mean_normal;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_COMPATIBLE_POINTS_H
