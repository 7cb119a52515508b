// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CURVES_AT_CORNER_H
#define CGAL_L0_RESAMPLING_INTERNAL_CURVES_AT_CORNER_H

#include <CGAL/L0_resampling/internal/creases/Crease_graph.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// All lengths are in units of `spacing_of_creases()`.

/// Curves that end at a corner.
class Curves_at_corner
{
  std::vector<std::vector<Vector>> m_curves; // the places of each, from the corner on

public:
  void add(std::vector<Vector> curve) { m_curves.push_back(std::move(curve)); }

  /// Whether three creases meet here, or two that turn.
  bool is_corner() const
  {
    const double maximum_cosine_of_line = -0.82; // of the two directions of one that goes on
    const std::size_t steps = 3;
    const auto direction = [&](const std::vector<Vector>& curve) {
      return (curve[(std::min)(curve.size() - 1, steps)] - curve.front()).normalized();
    };
    return m_curves.size() > 2
           || (m_curves.size() == 2
               && direction(m_curves[0]).dot(direction(m_curves[1])) > maximum_cosine_of_line);
  }

  /// Where the curves lead. Noise makes the surface around a corner round, and moves the place
  /// where its faces would meet; from a few spacings on, edges are where they are. Each counts as a
  /// straight line, the more the straighter it is, and against where the corner seems to be.
  Corner_of_creases meeting() const
  {
    const double variance_of_corner = 1;
    const Vector& corner = m_curves.front().front();
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity() / variance_of_corner;
    Vector right = Vector::Zero();
    for (const std::vector<Vector>& curve : m_curves)
      if (const std::optional<Line> line = line_of(curve))
      {
        const Eigen::Matrix3d across = (Eigen::Matrix3d::Identity()
                                        - line->direction * line->direction.transpose())
                                       / line->variance;
        matrix += across;
        right += across * (line->place - corner);
      }
    const Vector way = matrix.ldlt().solve(right);
    return {corner + way, way.norm()};
  }

private:
  struct Line
  {
    Vector place, direction;
    double variance; // across it, at the corner
  };

  /// Of the places that are so far from the corner, along the curve.
  static std::optional<Line> line_of(const std::vector<Vector>& curve)
  {
    const double nearest = 3, farthest = 12, variance_of_place = 0.02;
    const std::size_t minimum_number_of_places = 4;
    std::vector<Vector> places;
    std::vector<double> lengths;
    double length = 0;
    for (std::size_t k = 1; k < curve.size() && length <= farthest; ++k)
    {
      length += (curve[k] - curve[k - 1]).norm();
      if (length < nearest || length > farthest)
        continue;
      places.push_back(curve[k]);
      lengths.push_back(length);
    }
    if (places.size() < minimum_number_of_places)
      return std::nullopt;
    const double number = double(places.size()),
                 mean_length = std::accumulate(lengths.begin(), lengths.end(), 0.) / number;
    Vector mean = Vector::Zero();
    double second = 0, third = 0; // moments of the lengths
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const double t = lengths[k] - mean_length;
      mean += places[k] / number;
      second += t * t / number;
      third += t * t * t / number;
    }
    // a parabola to which no line is alike: what the places have of it leads away from their line
    const auto parabola = [&](double t) { return t * t - third / second * t - second; };
    Vector along = Vector::Zero(), bend = Vector::Zero();
    double sum_of_squares = 0;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const double t = lengths[k] - mean_length;
      along += t * (places[k] - mean);
      bend += parabola(t) * (places[k] - mean);
      sum_of_squares += parabola(t) * parabola(t);
    }
    bend *= parabola(-mean_length) / sum_of_squares; // at the corner
    return Line{mean, along.normalized(), bend.squaredNorm() + variance_of_place};
  }
};

/// The corners of a graph.
inline std::vector<Corner_of_creases> corners_of(
  const Crease_graph& graph, const std::vector<std::vector<std::size_t>>& curves)
{
  std::vector<Curves_at_corner> curves_at(graph.number_of_corners());
  const auto add = [&](auto place, auto end) {
    if (!graph.is_corner(*place))
      return;
    std::vector<Vector> places;
    Curves_at_corner& corner = curves_at[*place - graph.number_of_nodes()];
    for (; place != end; ++place)
      places.push_back(graph.position(*place));
    corner.add(std::move(places));
  };
  for (const std::vector<std::size_t>& curve : curves)
  {
    add(curve.begin(), curve.end());
    add(curve.rbegin(), curve.rend());
  }
  std::vector<Corner_of_creases> corners;
  for (const Curves_at_corner& curves_here : curves_at)
    if (curves_here.is_corner())
      corners.push_back(curves_here.meeting());
  return corners;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CURVES_AT_CORNER_H
