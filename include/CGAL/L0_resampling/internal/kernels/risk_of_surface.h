// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RISK_OF_SURFACE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RISK_OF_SURFACE_H

#include <CGAL/L0_resampling/internal/kernels/surface_of_disks.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The scale of the quadric that the bias of all others is measured against.
constexpr int scale_of_reference = 1;

/// The reference at a sample: the quadric, or, where points are exact, that of the smallest balls.
CGAL_L0_HOST_DEVICE inline Surface_of_disks reference_of(const Surface_of_disks& quadric,
                                                         const Surface_of_disks& smallest,
                                                         float share_of_smallest)
{
  if (!quadric.is_determined() || !smallest.is_determined())
    return quadric;
  const auto mean = [&](float a, float b) { return a + share_of_smallest * (b - a); };
  Surface_of_disks reference = quadric;
  reference.height = mean(quadric.height, smallest.height);
  reference.slope_u = mean(quadric.slope_u, smallest.slope_u);
  reference.slope_v = mean(quadric.slope_v, smallest.slope_v);
  reference.height_variance = mean(quadric.height_variance, smallest.height_variance);
  reference.slope_variance = mean(quadric.slope_variance, smallest.slope_variance);
  return reference;
}

/// Within what radius the bias of the surfaces of a scale is averaged, in units of the refinement.
CGAL_L0_HOST_DEVICE inline double radius_of_bias(int scale)
{
  const double radius = 0.6 * radius_of_fit(scale);
  return radius < 2 ? 2 : radius > 6 ? 6 : radius;
}

/*!
Sums over the samples of the same face around a sample: by how much a surface of theirs differs from
their reference. What chance explains of it, the difference of the variances, is no bias.
\tparam S a number, or lanes of numbers
*/
template <typename S>
struct Differences_from_reference
{
  S weight = S(), heights = S(), slopes = S();

  /// \param w how much the sample counts
  /// \param of_sample its `differences()`
  CGAL_L0_HOST_DEVICE void add(const S& w, const Differences_from_reference& of_sample)
  {
    weight += w * of_sample.weight;
    heights += w * of_sample.heights;
    slopes += w * of_sample.slopes;
  }
};

/// Those of one sample, of weight 1; nothing where one of the two surfaces is missing.
CGAL_L0_HOST_DEVICE inline Differences_from_reference<float> differences(const Surface_of_disks& s,
                                                                         const Surface_of_disks& r)
{
  if (!s.is_determined() || !r.is_determined())
    return {};
  const float height = s.height - r.height, slope_u = s.slope_u - r.slope_u,
              slope_v = s.slope_v - r.slope_v;
  return {1, height * height - at_least(r.height_variance - s.height_variance, 0),
          (slope_u * slope_u + slope_v * slope_v) / 2
            - at_least(r.slope_variance - s.slope_variance, 0)};
}

/// How much a sample counts whose normal has this cosine with that of the sample in the middle,
/// whichever side they point to.
template <typename S, typename T>
CGAL_L0_HOST_DEVICE S weight_of_difference(const S& squared_distance, T squared_radius,
                                           const S& cosine)
{
  using std::abs;
  return at_least(S(T(1) - squared_distance * (T(1) / squared_radius)), T(0))
         * at_least(S(T(1) - (T(1) - abs(cosine)) * (T(1) / T(opening_of_face))), T(0));
}

/*!
The risk of a surface at a sample, per the variance of its reference:
\f[ \frac{v + b^2}{v_0} + \frac{v' + b'^2}{v_0'}, \f]
v the variance of its height, b the bias of it, and the same of its slope.
*/
CGAL_L0_HOST_DEVICE inline float risk_of_surface(const Surface_of_disks& surface,
                                                 const Surface_of_disks& reference,
                                                 const Differences_from_reference<float>& d)
{
  const float bias = at_least(d.heights / d.weight, 0),
              bias_of_slope = at_least(d.slopes / d.weight, 0);
  return (surface.height_variance + bias) / reference.height_variance
         + (surface.slope_variance + bias_of_slope) / reference.slope_variance;
}

/// The mean of the surfaces of a sample, weighted by the inverse cubes of their risks.
struct Mean_surface
{
  float weight = 0, height = 0, slope_u = 0, slope_v = 0, uu = 0, uv = 0, vv = 0;
  float height_variance = 0, slope_variance = 0;

  CGAL_L0_HOST_DEVICE void add(const Surface_of_disks& s, float risk)
  {
    const float w = 1 / (risk * risk * risk);
    weight += w;
    height += w * s.height;
    slope_u += w * s.slope_u;
    slope_v += w * s.slope_v;
    uu += w * s.uu;
    uv += w * s.uv;
    vv += w * s.vv;
    height_variance += w * s.height_variance;
    slope_variance += w * s.slope_variance;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RISK_OF_SURFACE_H
