// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_THIN_CREASE_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_THIN_CREASE_POINTS_H

#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/creases/Nearby_points.h>
#include <CGAL/L0_resampling/internal/creases/crease_points.h>

#include <numeric>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// All lengths are in units of `spacing_of_creases()`.

/// Whether two crease points can be of one crease.
inline bool are_alike(const Crease_point& a, const Crease_point& b)
{
  const double minimum_cosine_of_tangents = 0.85, minimum_cosine_of_normals = 0.8;
  const auto cosine = [&](int i, int j) {
    return a.normals[std::size_t(i)].dot(b.normals[std::size_t(j)]);
  };
  return a.is_convex == b.is_convex
         && std::abs(a.tangent.dot(b.tangent)) >= minimum_cosine_of_tangents
         && (std::max)((std::min)(cosine(0, 0), cosine(1, 1)),
                       (std::min)(cosine(0, 1), cosine(1, 0)))
              > minimum_cosine_of_normals;
}

/*!
Draws the crease points, several of which each sample beside a crease has, to curves: each goes
across its tangent to a parabola through those near it, weighed by their variances. Of what is then
on curves, as many are kept as samples would be.
*/
class Crease_thinning
{
  std::vector<Crease_point> m_points;
  std::vector<double> m_weights; // of the points around each

public:
  template <typename ConcurrencyTag>
  Crease_thinning(ConcurrencyTag tag, std::vector<Crease_point> points)
    : m_points(std::move(points)), m_weights(m_points.size(), 0)
  {
    const int number_of_rounds = 3;
    for (int round = 0; round < number_of_rounds; ++round)
      draw_to_curves(tag);
  }

  /// \param corners the crease points around them are left out
  std::vector<Crease_point> nodes(const std::vector<Corner_of_creases>& corners) const
  {
    const double spacing = 0.8, minimum_share_of_weight = 0.12;
    if (m_points.empty())
      return {};
    std::vector<double> sorted = m_weights;
    std::nth_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(sorted.size() / 2),
                     sorted.end());
    const double minimum_weight = minimum_share_of_weight * sorted[sorted.size() / 2];

    std::vector<char> is_left(m_points.size(), 1);
    const std::vector<Vector> positions = positions_of_points();
    const Nearby_points nearby(positions, 2 * spacing);
    for (const Corner_of_creases& corner : corners)
      nearby.for_each_near(corner.position, spacing + corner.rounding,
                           [&](std::size_t i) { is_left[i] = 0; });
    std::vector<std::size_t> order(m_points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return m_weights[a] > m_weights[b]; });
    std::vector<Crease_point> nodes;
    for (std::size_t i : order)
    {
      if (!is_left[i] || m_weights[i] < minimum_weight)
        continue;
      const Crease_point& node = m_points[i];
      nodes.push_back(node);
      nearby.for_each_near(node.position, 2 * spacing, [&](std::size_t k) {
        const Vector way = m_points[k].position - node.position;
        const double along = way.dot(node.tangent), across = way.squaredNorm() - along * along;
        if (way.norm() < spacing
            || (std::abs(along) < spacing && across < spacing * spacing
                && std::abs(m_points[k].tangent.dot(node.tangent)) > 0.85))
          is_left[k] = 0;
      });
    }
    return nodes;
  }

private:
  std::vector<Vector> positions_of_points() const
  {
    std::vector<Vector> positions;
    for (const Crease_point& point : m_points)
      positions.push_back(point.position);
    return positions;
  }

  template <typename ConcurrencyTag>
  void draw_to_curves(ConcurrencyTag)
  {
    const double reach = 3, farthest_across = 1, minimum_variance = 0.01;
    const std::size_t points_per_block = 64;
    const std::vector<Vector> positions = positions_of_points();
    const Nearby_points nearby(positions, reach);
    const std::vector<Crease_point> before = m_points;
    const auto draw = [&](std::size_t i) {
      const Crease_point& point = before[i];
      Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
      Vector tangent = Vector::Zero();
      double sum_of_weights = 0;
      nearby.for_each_near(point.position, reach, [&](std::size_t k) {
        const Crease_point& other = before[k];
        const Vector way = other.position - point.position;
        const double along = way.dot(point.tangent),
                     squared_distance = way.squaredNorm() / (reach * reach);
        if (way.squaredNorm() - along * along > farthest_across * farthest_across
            || !are_alike(point, other))
          return;
        const double weight = (1 - squared_distance) * (1 - squared_distance) * other.confidence
                              / (other.variance + minimum_variance);
        const Vector row(1, along / reach, along * along / (reach * reach));
        matrix += weight * row * row.transpose();
        right += weight * row * (way - along * point.tangent).transpose();
        tangent += (other.tangent.dot(point.tangent) < 0 ? -weight : weight) * other.tangent;
        sum_of_weights += weight;
      });
      matrix.diagonal() += sum_of_weights * Vector(0, 0.01, 0.01);
      m_weights[i] = sum_of_weights;
      m_points[i].position += (matrix.ldlt().solve(right)).row(0).transpose();
      m_points[i].tangent = tangent.normalized();
    };
    for_each_block<ConcurrencyTag>(before.size(), points_per_block,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       draw(i);
                                   });
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_THIN_CREASE_POINTS_H
