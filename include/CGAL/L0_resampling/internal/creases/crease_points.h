// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CREASE_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_CREASE_POINTS_H

#include <CGAL/L0_resampling/internal/creases/Crease_face.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>

namespace CGAL {
namespace L0_resampling {
namespace internal {

// All lengths are in units of `spacing_of_creases()`, all angles in radians.

/// How far from a sample the other face of a crease is looked for.
constexpr double reach_of_crease = 2;
/// How far around a sample all is that its creases depend on.
constexpr double reach_of_crease_point = 1.2 * reach_of_crease + radius_of_face;
/// Normals that differ by less, or at a crease by less, are of one face.
constexpr double minimum_crease_angle = 22 * double(EIGEN_PI) / 180;

/// A place on a crease, as a sample near it sees it.
struct Crease_point
{
  Vector position, tangent;      ///< the tangent of any sign
  std::array<Vector, 2> normals; ///< of the two faces there
  double angle;                  ///< between the normals
  double variance;               ///< of the position, across the crease
  double confidence;             ///< in [0, 1]
  bool is_convex;
};

/// A place where three faces meet, as a sample near it sees it.
struct Corner_point
{
  Vector position;
  double weight; ///< of its position
  int votes;     ///< how many samples it counts for
};

/// A place where creases meet.
struct Corner_of_creases
{
  Vector position;
  double rounding; ///< how far from it noise has made the creases round
};

/*!
Finds the creases that a sample is beside, from the samples within `reach_of_crease_point` of it.
Each group of normals around it that is not its own makes a hypothesis of two faces; both are fitted
to the samples that agree with them, and the sample goes to where they intersect.
*/
class Creases_of_sample
{
  using Samples = std::vector<Oriented_sample>;

  std::vector<Crease_point> m_points;
  std::vector<Corner_point> m_corners;
  Samples m_first, m_second, m_third; // of the faces

public:
  const std::vector<Crease_point>& points() const { return m_points; }
  const std::vector<Corner_point>& corners() const { return m_corners; }

  /// \param around the samples within `reach_of_crease_point`, itself included
  void find(const Oriented_sample& sample, const Samples& around)
  {
    m_points.clear();
    m_corners.clear();
    for (const Vector& normal : other_normals(sample, around))
      try_faces(sample, normal, around);
  }

private:
  /// The mean normals of the groups around the sample that are not of its face.
  std::vector<Vector> other_normals(const Oriented_sample& sample, const Samples& around) const
  {
    const double maximum_cosine = std::cos(minimum_crease_angle),
                 cosine_of_back = -0.94, // of a thin sheet, which meets this one nowhere
      cosine_within_group = 0.92, minimum_weight = 0.8;
    std::vector<Vector> sums;
    std::vector<double> weights;
    for (const Oriented_sample& other : around)
    {
      const double squared_distance = (other.position - sample.position).squaredNorm(),
                   cosine = other.normal.dot(sample.normal);
      if (squared_distance > reach_of_crease * reach_of_crease || cosine > maximum_cosine
          || cosine < cosine_of_back)
        continue;
      const double weight = 1 - 0.7 * squared_distance / (reach_of_crease * reach_of_crease);
      std::size_t group = 0;
      while (group < sums.size()
             && sums[group].dot(other.normal) <= cosine_within_group * sums[group].norm())
        ++group;
      if (group == sums.size())
      {
        sums.push_back(Vector::Zero());
        weights.push_back(0);
      }
      sums[group] += weight * other.normal;
      weights[group] += weight;
    }
    std::vector<Vector> normals;
    for (std::size_t group = 0; group < sums.size(); ++group)
      if (weights[group] >= minimum_weight)
        normals.push_back(sums[group].normalized());
    return normals;
  }

  void try_faces(const Oriented_sample& sample, const Vector& other_normal, const Samples& around)
  {
    share_by_normals(sample, other_normal, around);
    Vector place = sample.position;
    const std::optional<Crease_face> first = Crease_face::fit(m_first, place),
                                     second = Crease_face::fit(m_second, place);
    if (!first || !second || !intersect(*first, *second, place)
        || (place - sample.position).norm() > 1.2 * reach_of_crease
        || angle_at(place, *first, *second) < 0.7 * minimum_crease_angle)
      return;
    share_by_faces(*first, *second, place, around);
    if (is_crease(place, *first, *second))
      add_if_corner(place, *first, *second, around);
  }

  static double angle_between(const Vector& a, const Vector& b)
  {
    return std::acos((std::max)(-1., (std::min)(1., a.dot(b))));
  }
  static double angle_at(const Vector& p, const Crease_face& first, const Crease_face& second)
  {
    return angle_between(first.at(p).normal, second.at(p).normal);
  }

  void share_by_normals(const Oriented_sample& sample, const Vector& other_normal,
                        const Samples& around)
  {
    const double minimum_cosine =
      (std::max)(std::cos(0.5 * angle_between(sample.normal, other_normal)), 0.8);
    m_first.clear();
    m_second.clear();
    for (const Oriented_sample& other : around)
    {
      const double own = other.normal.dot(sample.normal), opposite = other.normal.dot(other_normal);
      if ((other.position - sample.position).squaredNorm() < radius_of_face * radius_of_face
          && (std::max)(own, opposite) >= minimum_cosine)
        (own > opposite ? m_first : m_second).push_back(other);
    }
  }

  /// How little a sample agrees with a face: below 1 within all deviations that count.
  static double disagreement(const Oriented_sample& sample, const Crease_face& face)
  {
    const double height_bandwidth = 0.9, angle_bandwidth = 0.45;
    const Crease_face::Place place = face.at(sample.position);
    const double height = place.height / height_bandwidth;
    return (place.normal - sample.normal).squaredNorm() / (angle_bandwidth * angle_bandwidth)
           + height * height;
  }

  void share_by_faces(const Crease_face& first, const Crease_face& second, const Vector& place,
                      const Samples& around)
  {
    m_first.clear();
    m_second.clear();
    for (const Oriented_sample& other : around)
      if ((other.position - place).squaredNorm() < radius_of_face * radius_of_face)
      {
        const double a = disagreement(other, first), b = disagreement(other, second);
        if ((std::min)(a, b) <= 1)
          (a < b ? m_first : m_second).push_back(other);
      }
  }

  /// Moves the place to the nearest one on both faces, within the plane of their normals.
  /// \returns whether there is one
  static bool intersect(const Crease_face& first, const Crease_face& second, Vector& place)
  {
    const int number_of_steps = 4;
    const double longest_step = 2, minimum_determinant = 0.02, tolerance = 0.05;
    for (int step = 0; step < number_of_steps; ++step)
    {
      const Crease_face::Place a = first.at(place), b = second.at(place);
      const double cosine = a.normal.dot(b.normal), determinant = 1 - cosine * cosine;
      if (determinant < minimum_determinant)
        return false;
      const Vector way = ((cosine * b.height - a.height) * a.normal
                          + (cosine * a.height - b.height) * b.normal)
                         / determinant;
      place += (std::min)(1., longest_step / way.norm()) * way;
    }
    return std::abs(first.at(place).height) + std::abs(second.at(place).height) <= tolerance;
  }

  /// Which side of the other face the samples of a face are on, near the crease.
  struct Sides
  {
    double number_below = 0, number = 0, number_near = 0;

    Sides(const Samples& samples, const Vector& place, const Vector& other_normal,
          const Vector& tangent, double sine)
    {
      const double reach_along = 2.5, reach_across = 2, clear_of_face = 0.2;
      for (const Oriented_sample& sample : samples)
      {
        const Vector way = sample.position - place;
        const double along = way.dot(tangent), across = way.squaredNorm() - along * along,
                     above = way.dot(other_normal);
        if (std::abs(along) > reach_along)
          continue;
        number_near += across < reach_across * reach_across;
        if (std::abs(above) < clear_of_face * sine)
          continue;
        ++number;
        number_below += above < 0 ? 1 : -1;
      }
    }
    double agreement() const { return number_below / number; }
  };

  /// Whether two faces meet there; then it is added.
  bool is_crease(const Vector& place, const Crease_face& first, const Crease_face& second)
  {
    const double minimum_agreement = 0.3, enough_samples = 6, variance_of_fit = 4e-4;
    const std::array<Vector, 2> normals = {first.at(place).normal, second.at(place).normal};
    const double angle = angle_between(normals[0], normals[1]), sine = std::sin(angle);
    if (angle < minimum_crease_angle)
      return false;
    const Vector tangent = normals[0].cross(normals[1]).normalized();
    const Sides a(m_first, place, normals[1], tangent, sine),
      b(m_second, place, normals[0], tangent, sine);
    if (a.number_near < 1 || b.number_near < 1 || a.number < 2 || b.number < 2
        || a.number_below * b.number_below <= 0 || std::abs(a.agreement()) < minimum_agreement
        || std::abs(b.agreement()) < minimum_agreement)
      return false;
    m_points.push_back({place, tangent, normals, angle,
                        (first.variance_of_height(place, m_first, place)
                         + second.variance_of_height(place, m_second, place))
                            / (sine * sine)
                          + variance_of_fit,
                        (std::min)(1., (a.number_near + b.number_near) / enough_samples)
                          * (std::min)(std::abs(a.agreement()), std::abs(b.agreement())),
                        a.number_below > 0});
    return true;
  }

  void add_if_corner(const Vector& place, const Crease_face& first, const Crease_face& second,
                     const Samples& around)
  {
    const double reach = 3, height_of_face = 0.8, cosine_of_face = 0.951, cosine_of_group = 0.95,
                 cosine_of_member = 0.93, farthest_from_place = 3.5, farthest_from_samples = 2.6;
    const std::size_t minimum_number = 3;

    const auto belongs_to = [&](const Oriented_sample& sample, const Crease_face& face) {
      const Crease_face::Place at = face.at(sample.position);
      return at.normal.dot(sample.normal) > cosine_of_face && std::abs(at.height) < height_of_face;
    };
    std::vector<const Oriented_sample*> rest;
    for (const Oriented_sample& other : around)
      if ((other.position - place).squaredNorm() < reach * reach && !belongs_to(other, first)
          && !belongs_to(other, second))
        rest.push_back(&other);
    std::size_t most = 0;
    Vector normal = Vector::Zero();
    for (const Oriented_sample* sample : rest)
    {
      const std::size_t alike = std::size_t(
        std::count_if(rest.begin(), rest.end(), [&](const Oriented_sample* other) {
          return sample->normal.dot(other->normal) > cosine_of_group;
        }));
      if (alike > most)
      {
        most = alike;
        normal = sample->normal;
      }
    }
    if (most < minimum_number)
      return;

    m_third.clear();
    for (const Oriented_sample& other : around)
    {
      const double cosine = other.normal.dot(normal);
      if ((other.position - place).squaredNorm() < radius_of_face * radius_of_face
          && cosine > cosine_of_member && cosine > other.normal.dot(first.at(other.position).normal)
          && cosine > other.normal.dot(second.at(other.position).normal))
        m_third.push_back(other);
    }
    const std::optional<Crease_face> third = Crease_face::fit(m_third, place);
    Vector corner = place;
    if (!third || !intersect(first, second, *third, corner)
        || (corner - place).norm() > farthest_from_place)
      return;
    for (const Samples* samples : {&m_first, &m_second, &m_third})
      if (std::none_of(samples->begin(), samples->end(), [&](const Oriented_sample& sample) {
            return (sample.position - corner).norm() < farthest_from_samples;
          }))
        return;
    m_corners.push_back({corner, 1 / (1 + (corner - place).squaredNorm()), 1});
  }

  static bool intersect(const Crease_face& first, const Crease_face& second,
                        const Crease_face& third, Vector& place)
  {
    const int number_of_steps = 5;
    const double longest_step = 2, minimum_determinant = 0.15;
    for (int step = 0; step < number_of_steps; ++step)
    {
      Eigen::Matrix3d normals;
      Vector heights;
      int row = 0;
      for (const Crease_face* face : {&first, &second, &third})
      {
        const Crease_face::Place at = face->at(place);
        normals.row(row) = at.normal.transpose();
        heights[row++] = at.height;
      }
      if (std::abs(normals.determinant()) < minimum_determinant)
        return false;
      const Vector way = -(normals.inverse() * heights);
      place += (std::min)(1., longest_step / way.norm()) * way;
    }
    return true;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CREASE_POINTS_H
