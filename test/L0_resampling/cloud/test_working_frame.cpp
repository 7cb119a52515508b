// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cmath>

using namespace test;

std::vector<Vector> scaled(std::vector<Vector> points, int exponent)
{
  for (Vector& p : points)
    p = Vector(std::ldexp(p[0], exponent), std::ldexp(p[1], exponent), std::ldexp(p[2], exponent));
  return points;
}

std::vector<Vector> moved(std::vector<Vector> points, const Vector& offset)
{
  for (Vector& p : points)
    p += offset;
  return points;
}

/// Points in their frame, after both steps.
struct Framed
{
  Working_frame frame;
  Buffer<Vector> points;

  /// \param radius in the unit of the input
  Framed(const std::vector<Vector>& input, double radius) : points(to_buffer(input))
  {
    frame.enter<CGAL::Parallel_if_available_tag>(points);
    frame.set_unit<CGAL::Parallel_if_available_tag>(std::ldexp(radius, frame.exponent()), points);
  }
};

/// The frame of a cloud times a power of two is the same frame, bit by bit, and leaves it with the
/// same bits.
void check_scale(const std::vector<Vector>& cloud)
{
  const Framed framed(cloud, 0.3);
  for (int exponent : {-1000, -300, -40, -1, 1, 40, 300, 1000})
  {
    const std::vector<Vector> scaled_cloud = scaled(cloud, exponent);
    const double radius = std::ldexp(0.3, exponent);
    const Framed scaled_framed(scaled_cloud, radius);
    CHECK(scaled_framed.points == framed.points);
    CHECK(scaled_framed.frame.length_of_input(1) == radius);
    CHECK(framed.frame.length_of_input(1) == 0.3);
    CHECK(scaled_framed.frame.length_of_input(1.7)
          == std::ldexp(framed.frame.length_of_input(1.7), exponent));
    std::vector<Vector> left, scaled_left;
    for (const Vector& p : framed.points)
    {
      left.push_back(framed.frame.leave(p));
      scaled_left.push_back(scaled_framed.frame.leave(p));
    }
    CHECK(scaled_left == scaled(left, exponent));
  }
}

/// The frame of a cloud times any factor is the same frame, up to the rounding of the coordinates.
void check_any_scale(const std::vector<Vector>& cloud)
{
  const Framed framed(cloud, 0.3);
  for (double factor : {3., 1. / 3, 1000., 0.001, 0.3048, 7.})
  {
    std::vector<Vector> scaled_cloud = cloud;
    for (Vector& p : scaled_cloud)
      p *= factor;
    const Framed scaled_framed(scaled_cloud, 0.3 * factor);
    double worst = 0;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      worst = (std::max)(worst, (scaled_framed.points[i] - framed.points[i]).cwiseAbs().maxCoeff());
    CHECK(worst < 1e-14);
    CHECK(is_close(scaled_framed.frame.length_of_input(1.7),
                   factor * framed.frame.length_of_input(1.7), 1e-15));
  }
}

/// What the stages rely on: radius 1, medians 0, coordinates of moderate size, and a way back.
void check_frame(const std::vector<Vector>& cloud, double radius)
{
  const Framed framed(cloud, radius);
  CHECK(framed.frame.length_of_input(1) == radius);

  Buffer<Vector> first_step = to_buffer(cloud);
  Working_frame().enter<CGAL::Parallel_if_available_tag>(first_step);
  double largest = 0, worst = 0, diagonal = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    largest = (std::max)(largest, first_step[i].cwiseAbs().maxCoeff());
    worst = (std::max)(worst,
                       (framed.frame.leave(framed.points[i]) - cloud[i]).cwiseAbs().maxCoeff());
    diagonal = (std::max)(diagonal, cloud[i].cwiseAbs().maxCoeff());
  }
  CHECK(largest <= 2);
  Framed again = framed; // a second unit of the same frame
  again.frame.set_unit<CGAL::Parallel_if_available_tag>(128, again.points);
  CHECK(again.frame.length_of_input(1) == 128 * radius);
  CHECK(again.points.front() == framed.points.front() / 128);
  CHECK(again.frame.leave(again.points.front()) == framed.frame.leave(framed.points.front()));
  CHECK(worst <= 5e-16 * diagonal);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::size_t below = 0, above = 0;
    for (const Vector& p : framed.points)
    {
      below += p[axis] < 0;
      above += p[axis] > 0;
    }
    CHECK(below <= cloud.size() / 2 && above <= cloud.size() / 2);
  }
}

/// A cloud and its copy at UTM coordinates, which has the digits that are left there, differ by
/// those digits only.
void check_offset(const std::vector<Vector>& cloud)
{
  const Vector utm(448262, 5411932, 35);
  const Framed here(cloud, 0.3), there(moved(cloud, utm), 0.3);
  double worst = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    worst = (std::max)(worst, (there.points[i] - here.points[i]).norm());
  }
  CHECK(worst < 1e-8);
  CHECK(worst > 0);

  // without digits to lose nothing changes
  std::vector<Vector> coarse = cloud;
  for (Vector& p : coarse)
    p = (1024 * p).array().round() / 1024;
  const Framed coarse_here(coarse, 0.3), coarse_there(moved(coarse, utm), 0.3);
  bool are_equal = true;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    are_equal = are_equal && coarse_there.points[i] == coarse_here.points[i];
  CHECK(are_equal);
}

double plain_diagonal(const std::vector<Vector>& points)
{
  Vector low = points.front(), high = points.front();
  for (const Vector& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// The diagonal of the bounding box, which an outlier at 1e9 does not stretch.
void check_diagonal(const std::vector<Vector>& cloud)
{
  const double diagonal = plain_diagonal(cloud);
  CHECK(robust_diagonal<CGAL::Parallel_if_available_tag>(to_buffer(cloud)) == diagonal);
  for (const Vector& outlier : {Vector(1e9, 0, 0), Vector(0, -1e9, 0), Vector(-1e9, 1e9, 1e9)})
  {
    std::vector<Vector> with_outlier = cloud;
    with_outlier.insert(with_outlier.begin() + 7, outlier);
    CHECK(robust_diagonal<CGAL::Parallel_if_available_tag>(to_buffer(with_outlier))
          <= diagonal * (1 + 1e-12));
    CHECK(robust_diagonal<CGAL::Parallel_if_available_tag>(to_buffer(with_outlier))
          >= diagonal * 0.999);
  }
}

/// A radius is one that reaches somebody and not more than everybody.
void check_sensible_radius(const std::vector<Vector>& cloud)
{
  const double diagonal = plain_diagonal(cloud);
  const Buffer<Vector> points = to_buffer(cloud);
  CHECK(sensible_radius(0.3, box_diagonal(points)) == 0.3);
  CHECK(sensible_radius(1e300, box_diagonal(points)) == diagonal);
  CHECK(sensible_radius(1e-300, box_diagonal(points)) > 0
        && sensible_radius(1e-300, box_diagonal(points)) < 1e-20 * diagonal);
  // a float has room for the whole cloud in units of the radius
  CHECK(diagonal / sensible_radius(1e-300, box_diagonal(points))
        < 1e-3 * double((std::numeric_limits<float>::max)()));
  CHECK(sensible_radius(5, box_diagonal(to_buffer(std::vector<Vector>(3, Vector(1, 2, 3))))) == 1);
}

int main()
{
  Generator generator(11);
  std::vector<Vector> cloud = cube_points(1001, 2, generator).points;
  add_gaussian_noise(cloud, 0.05, generator);
  check_scale(cloud);
  check_any_scale(cloud);
  check_frame(cloud, 0.3);
  check_frame(moved(cloud, Vector(448262, 5411932, 35)), 0.3);
  for (int exponent : {-900, 900})
    check_frame(scaled(cloud, exponent), std::ldexp(0.7, exponent));
  check_frame({Vector(3, -4, 5)}, 2);
  check_frame({Vector(0, 0, 0), Vector(0, 0, 0)}, 2);
  check_offset(cloud);

  const std::vector<Vector> plane = plane_points(400, 3, generator).points;
  const std::vector<Vector> few = sphere_points(30, 1, generator).points;
  for (const auto& points : {cloud, plane, few, lattice_points(5, 0.5)})
    CHECK(robust_diagonal<CGAL::Parallel_if_available_tag>(to_buffer(points))
          == plain_diagonal(points));
  CHECK(robust_diagonal<CGAL::Parallel_if_available_tag>(
          to_buffer(std::vector<Vector>{Vector(0, 0, 0), Vector(1, 2, 2)}))
        == 3);
  CHECK(robust_diagonal<CGAL::Parallel_if_available_tag>(
          to_buffer(std::vector<Vector>(40, Vector(1, 2, 2))))
        == 0);
  check_diagonal(cloud);
  check_sensible_radius(cloud);
  return result();
}
