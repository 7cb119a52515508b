// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CREASE_FACE_H
#define CGAL_L0_RESAMPLING_INTERNAL_CREASE_FACE_H

#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// All lengths are in units of `spacing_of_creases()`.

struct Oriented_sample
{
  Vector position, normal;
};

/// Of the ball whose samples a face is fitted to.
constexpr double radius_of_face = 5;
/// What samples of one face deviate from it, and their normals, in radians.
constexpr double height_deviation_of_face = 0.1, normal_deviation_of_face = 0.06;
/// The standard deviation of curvatures: few samples give a plane, many a quadric.
constexpr double curvature_of_faces = 0.1;

/*!
One of the faces beside a crease: the quadric \f$ h(u, v) = x_0 + x_1 u + x_2 v + x_3 u^2 + x_4 uv +
x_5 v^2 \f$ over the plane of the mean normal, fitted to the positions and to the normals of its
samples, with a prior on the second order.
*/
class Crease_face
{
  using Coefficients = Eigen::Matrix<double, 6, 1>;
  using Matrix = Eigen::Matrix<double, 6, 6>;

  Vector m_origin, m_u, m_v, m_normal; // of the frame
  Coefficients m_coefficients;
  Eigen::LLT<Matrix> m_factors; // of the normal equations

public:
  struct Place
  {
    double height; ///< across the face, of a point above it
    Vector normal; ///< of the face below the point
  };

  /// \returns nothing if the samples around `center` are too few
  static std::optional<Crease_face> fit(const std::vector<Oriented_sample>& samples,
                                        const Vector& center)
  {
    const double minimum_weight = 0.3;
    Vector normal = Vector::Zero(), origin = Vector::Zero();
    double sum_of_weights = 0;
    for (const Oriented_sample& sample : samples)
    {
      const double weight = weight_at(sample.position - center);
      normal += weight * sample.normal;
      origin += weight * sample.position;
      sum_of_weights += weight;
    }
    if (samples.size() < 3 || !(sum_of_weights > minimum_weight) || !(normal.norm() > 0))
      return std::nullopt;
    Crease_face face(origin / sum_of_weights, normal.normalized());
    if (!face.solve(samples, center))
      return std::nullopt;
    return face;
  }

  Place at(const Vector& p) const
  {
    const Vector way = p - m_origin;
    const double u = way.dot(m_u), v = way.dot(m_v);
    const Coefficients& x = m_coefficients;
    const double along_u = x[1] + 2 * x[3] * u + x[4] * v, along_v = x[2] + x[4] * u + 2 * x[5] * v,
                 height = x[0] + (x[1] + x[3] * u + x[4] * v) * u + (x[2] + x[5] * v) * v,
                 per_length = 1 / std::sqrt(1 + along_u * along_u + along_v * along_v);
    return {(way.dot(m_normal) - height) * per_length,
            per_length * (m_normal - along_u * m_u - along_v * m_v)};
  }

  /// Of the height at a place, where the samples that it was fitted to deviate as was assumed, or
  /// as they do if that is more.
  double variance_of_height(const Vector& p, const std::vector<Oriented_sample>& samples,
                            const Vector& center) const
  {
    double squared_heights = 0, squared_angles = 0, sum_of_weights = 0;
    for (const Oriented_sample& sample : samples)
    {
      const double weight = weight_at(sample.position - center);
      const Place place = at(sample.position);
      squared_heights += weight * place.height * place.height;
      squared_angles += weight * (sample.normal - place.normal).squaredNorm() / 2;
      sum_of_weights += weight;
    }
    const double excess = 0.5 / sum_of_weights
                          * (squared_heights / (height_deviation_of_face * height_deviation_of_face)
                             + squared_angles
                                 / (normal_deviation_of_face * normal_deviation_of_face));
    const double u = (p - m_origin).dot(m_u), v = (p - m_origin).dot(m_v);
    Coefficients row;
    row << 1, u, v, u * u, u * v, v * v;
    return (std::max)(1., excess) * row.dot(m_factors.solve(row));
  }

private:
  Crease_face(const Vector& origin, const Vector& normal)
    : m_origin(origin), m_u(normal.unitOrthogonal()), m_v(normal.cross(m_u)), m_normal(normal)
  {}

  static double weight_at(const Vector& way)
  {
    const double rest = 1 - way.squaredNorm() / (radius_of_face * radius_of_face);
    return rest > 0 ? rest * rest : 0;
  }

  /// \returns whether there is a face
  bool solve(const std::vector<Oriented_sample>& samples, const Vector& center)
  {
    const double minimum_cosine = 0.3;
    const double information_of_height = 1 / (height_deviation_of_face * height_deviation_of_face),
                 information_of_normal = 1 / (normal_deviation_of_face * normal_deviation_of_face);
    Matrix matrix = Matrix::Zero(); // below the diagonal
    Coefficients right = Coefficients::Zero();
    const auto add = [&](const double(&row)[6], double value, double weight) {
      for (int i = 0; i < 6; ++i)
      {
        for (int j = 0; j <= i; ++j)
          matrix(i, j) += weight * row[i] * row[j];
        right[i] += weight * value * row[i];
      }
    };
    for (const Oriented_sample& sample : samples)
    {
      const double weight = weight_at(sample.position - center),
                   cosine = sample.normal.dot(m_normal);
      if (!(weight > 0) || cosine < minimum_cosine)
        continue;
      const Vector way = sample.position - m_origin;
      const double u = way.dot(m_u), v = way.dot(m_v),
                   weight_of_slope = weight * information_of_normal * cosine * cosine;
      add({1, u, v, u * u, u * v, v * v}, way.dot(m_normal), weight * information_of_height);
      add({0, 1, 0, 2 * u, v, 0}, -sample.normal.dot(m_u) / cosine, weight_of_slope);
      add({0, 0, 1, 0, u, 2 * v}, -sample.normal.dot(m_v) / cosine, weight_of_slope);
    }
    const double prior = 4 / (curvature_of_faces * curvature_of_faces);
    for (int i = 0; i < 6; ++i)
      matrix(i, i) += i < 3 ? 1e-9 : i == 4 ? prior / 2 : prior;
    m_factors.compute(matrix);
    if (m_factors.info() != Eigen::Success)
      return false;
    m_coefficients = m_factors.solve(right);
    return true;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CREASE_FACE_H
