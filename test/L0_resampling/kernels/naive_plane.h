// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_TEST_NAIVE_PLANE_H
#define L0_TEST_NAIVE_PLANE_H

#include "normals/naive_normal_filter.h"
#include "stage_support.h"

#include <Eigen/LU>

#include <cmath>

namespace test {

/// How much a surface counts by the formula of `share_of_surface()`.
/// \param unknowns beside its height
inline double naive_share_of_surface(double number, int unknowns, double leverage, double cosine,
                                     double excess)
{
  return clamped(number / unknowns - 1) * clamped(2 - leverage / 10) * clamped((cosine - 0.5) / 0.1)
         * std::exp(-excess * excess);
}

/// `fit_local_surface()` of degree 1, with Eigen's inverse.
struct Naive_plane
{
  Vector normal;
  double share, height;

  /// \param own the center's normal
  /// \param believed the largest variance that is; 0 for any
  Naive_plane(const Eigen::Matrix3d& covariance, const Vector& mean, double number,
              const Vector& own, double believed = 0)
  {
    const Eigen::Matrix3d inverse =
      (covariance + 0.01 * covariance.trace() * Eigen::Matrix3d::Identity()).inverse();
    normal = (inverse * (inverse * own).normalized()).normalized();
    const Vector offset = mean - normal.dot(mean) * normal;
    const double variance = normal.dot(covariance * normal);
    share = naive_share_of_surface(number, 2, 1 + offset.dot(inverse * offset), normal.dot(own),
                                   believed > 0 ? variance / believed : 0);
    height = normal.dot(mean) / normal.dot(own);
  }
};

} // namespace test

#endif // L0_TEST_NAIVE_PLANE_H
