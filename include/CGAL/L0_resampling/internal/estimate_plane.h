// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PLANE_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PLANE_H

#include <CGAL/L0_resampling/internal/Parameters.h>
#include <CGAL/L0_resampling/internal/ball_queries.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A plane through points.
template <typename T>
struct Plane_fit
{
  Eigen::Matrix<T, 3, 1> normal = Eigen::Matrix<T, 3, 1>::UnitZ();
  bool spans_plane = false;            ///< whether the points determine it, and are not too few to be trusted
  double variance = 0;                 ///< of the points across it
  std::size_t number_of_points = 0;
};

/// Fits a plane to the candidates in the ball around `center`, the smallest eigenvector of their covariance
/// (Hoppe et al. 1992). Points on a line give a normal across it; coincident points give (0, 0, 1).
template <typename T>
Plane_fit<T> fit_plane(const Eigen::Matrix<T, 3, 1>& center, const Local_points<T>& candidates, T squared_radius)
{
  using L = Lanes<T>;
  L n, x, y, z, xx, xy, xz, yy, yz, zz;
  for (std::size_t k = 0; k < candidates.padded_size(); k += L::size)
  {
    const L dx = L::load(&candidates.x[k]) - center[0];
    const L dy = L::load(&candidates.y[k]) - center[1];
    const L dz = L::load(&candidates.z[k]) - center[2];
    const L inside = where_less(dx * dx + dy * dy + dz * dz, squared_radius, L(T(1)));
    const L mx = inside * dx, my = inside * dy, mz = inside * dz;
    n += inside;
    x += mx;  y += my;  z += mz;
    xx += mx * dx;  xy += mx * dy;  xz += mx * dz;
    yy += my * dy;  yz += my * dz;  zz += mz * dz;
  }

  const double count = n.sum();
  Plane_fit<T> fit;
  fit.number_of_points = std::size_t(count);
  if (fit.number_of_points < 2)
    return fit;
  const Eigen::Vector3d mean = Eigen::Vector3d(x.sum(), y.sum(), z.sum()) / count;
  Eigen::Matrix3d covariance;
  covariance << xx.sum(), xy.sum(), xz.sum(),
                xy.sum(), yy.sum(), yz.sum(),
                xz.sum(), yz.sum(), zz.sum();
  covariance = covariance / count - mean * mean.transpose();

  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  const Eigen::Vector3d& variances = solver.eigenvalues();
  // Relative to what rounding leaves of a variance across a line, in units of the squared ball
  const double rounding = 16 * double(std::numeric_limits<T>::epsilon()) * (std::max)(variances[2], double(squared_radius) * 1e-6);
  if (!(variances[2] > rounding))
    return fit;
  fit.normal = solver.eigenvectors().col(0).normalized().template cast<T>();
  fit.spans_plane = variances[1] > rounding && fit.number_of_points >= fewest_points_of_plane;
  fit.variance = (std::max)(variances[0], 0.);
  return fit;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_PLANE_H
