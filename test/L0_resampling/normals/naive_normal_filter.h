// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_NAIVE_NORMAL_FILTER_H
#define CGAL_L0_RESAMPLING_TEST_NAIVE_NORMAL_FILTER_H

#include "stage_support.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace test {

/// The nearest number to x in [0, 1].
inline double clamped(double x) { return (std::min)((std::max)(x, 0.), 1.); }

/// \f$ (1 - \cos\sigma_n)^2 \f$ of Eq. (2), for an angle in degrees.
inline double naive_normal_bandwidth(double sharpness_angle)
{
  return std::pow(1 - std::cos(sharpness_angle * EIGEN_PI / 180), 2);
}

/// Eq. (1) as it stands, once for all points, with any \f$ \psi \f$ of \f$ |n^T n'| \f$. A normal
/// on the other side is turned first.
template <typename Psi>
std::vector<Vector> filter_normals_naively(const std::vector<Vector>& points,
                                           const std::vector<Vector>& normals, double radius,
                                           double spatial_bandwidth, const Psi& psi)
{
  const auto neighbors = brute_force_neighbors(points, points, radius);
  std::vector<Vector> filtered;
  for (std::size_t j = 0; j < points.size(); ++j)
  {
    Vector sum = Vector::Zero();
    for (std::size_t k : neighbors[j])
    {
      const double cosine = normals[j].dot(normals[k]);
      const double theta = std::exp(-(points[j] - points[k]).squaredNorm()
                                    / (spatial_bandwidth * spatial_bandwidth));
      sum += theta * psi(std::abs(cosine)) * (cosine < 0 ? -1 : 1) * normals[k];
    }
    filtered.push_back(sum.normalized());
  }
  return filtered;
}

/// The mean angle between lines, in degrees: normals without orientation have no sign.
inline double mean_angle(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += angle_of_lines(a[i], b[i]);
  return sum / double(a.size());
}

/// Two squares of side 1 that meet in a right angle along the x axis.
inline Oriented_points wedge_points(std::size_t n, Generator& generator)
{
  Oriented_points wedge;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = random_number(0, 1, generator), away = random_number(0, 1, generator);
    wedge.points.push_back(i % 2 ? Vector(x, away, 0) : Vector(x, 0, away));
    wedge.normals.push_back(i % 2 ? Vector::UnitZ() : Vector::UnitY());
  }
  return wedge;
}

/// Unit vectors near `normals`: each is moved by a Gaussian of this deviation in every coordinate.
inline std::vector<Vector> noisy_normals(std::vector<Vector> normals, double deviation,
                                         Generator& generator)
{
  add_gaussian_noise(normals, deviation, generator);
  for (Vector& n : normals)
    n.normalize();
  return normals;
}

/// To the other side, as good as any where sides do not count.
inline void turn_some(Generator& generator, std::vector<Vector>& normals)
{
  for (Vector& n : normals)
    if (std::bernoulli_distribution()(generator))
      n = -n;
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_NAIVE_NORMAL_FILTER_H
