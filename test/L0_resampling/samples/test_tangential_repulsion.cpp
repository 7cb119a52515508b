// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/tangential_repulsion.h>

#include <algorithm>
#include <cmath>

using namespace test;

struct Repelled
{
  std::vector<Vector> before, after; ///< in the same order
  std::vector<Vector> normals, outward;
};

constexpr double range_per_spacing = 2.5;

/// \param outward one a point; none means nowhere
Repelled repel(const Oriented_points& cloud, std::vector<Vector> outward, double spacing,
               std::size_t number_of_steps)
{
  const double self_neighbor_radius = range_per_spacing * spacing;
  outward.resize(cloud.points.size(), Vector::Zero());
  const Gridded_points sorted(cloud.points, self_neighbor_radius);
  Samples<double> samples{Counting_allocator<Vector>()};
  samples.positions = sorted.points;
  samples.normals = to_buffer(permuted(sorted.order, cloud.normals));
  samples.outward_directions = to_buffer(permuted(sorted.order, outward));
  Unwatched unwatched;
  const Neighborhoods neighbors = find_self_neighbors<CGAL::Sequential_tag>(
    sorted.grid, sorted.points, self_neighbor_radius, unwatched.progress);
  Samples<double> sequential = samples;
  repel_tangentially<CGAL::Parallel_if_available_tag>(
    neighbors, sorted.points, self_neighbor_radius, spacing, spacing, number_of_steps, samples);
  repel_tangentially<CGAL::Sequential_tag>(neighbors, sorted.points, self_neighbor_radius, spacing,
                                           spacing, number_of_steps, sequential);
  CHECK(sequential.positions == samples.positions);
  return {sorted.vector,
          {samples.positions.begin(), samples.positions.end()},
          permuted(sorted.order, cloud.normals),
          permuted(sorted.order, outward)};
}

/// A square lattice in the plane z = 0 of this many points a side, spacing 1.
Oriented_points flat_lattice(std::size_t side)
{
  Oriented_points lattice;
  for (const Vector& p : lattice_points(side, 1))
    if (p[2] == 0)
    {
      lattice.points.push_back(p);
      lattice.normals.push_back(Vector::UnitZ());
    }
  return lattice;
}

/// Coefficient of variation of the distances to the nearest neighbor.
double unevenness(const std::vector<Vector>& points)
{
  double sum = 0, sum_of_squares = 0;
  for (const Vector& p : points)
  {
    double nearest = 1e9;
    for (const Vector& q : points)
      if (&p != &q)
        nearest = (std::min)(nearest, (p - q).norm());
    sum += nearest / double(points.size());
    sum_of_squares += nearest * nearest / double(points.size());
  }
  return std::sqrt(sum_of_squares - sum * sum) / sum;
}

/// Where all pushes cancel nobody moves; those on the border would fall off unless they knew that
/// it is one.
void check_lattice()
{
  const Oriented_points lattice = flat_lattice(13);
  const auto border_direction = [](const Vector& p) {
    return Vector((p[0] == 12) - (p[0] == 0), (p[1] == 12) - (p[1] == 0), 0).normalized();
  };
  std::vector<Vector> outward, inward;
  for (const Vector& p : lattice.points)
  {
    outward.push_back(border_direction(p));
    inward.push_back(-border_direction(p));
  }
  const Repelled free = repel(lattice, {}, 1, 1), bound = repel(lattice, outward, 1, 1);
  CHECK(repel(lattice, inward, 1, 1).after
        == free.after); // only what points to the border is left out
  double inner = 0, off_border = 0, off_free_border = 0;
  for (std::size_t i = 0; i < lattice.points.size(); ++i)
  {
    const Vector& p = free.before[i];
    const bool is_inner = p.head<2>().minCoeff() >= 3 && p.head<2>().maxCoeff() <= 9;
    const Vector out = border_direction(p);
    if (is_inner)
      inner = (std::max)({inner, (free.after[i] - p).norm(), (bound.after[i] - p).norm()});
    off_border = (std::max)(off_border, out.dot(bound.after[i] - p));
    off_free_border = (std::max)(off_free_border, out.dot(free.after[i] - p));
  }
  CHECK(inner < 1e-14);
  CHECK(off_border < 1e-14);
  CHECK(off_free_border > 0.1);
}

/// How far two samples go away from each other that were so far apart when they were found to be
/// neighbors, and are half as far now.
double push_of_pair(double distance)
{
  const double spacing = 1;
  const std::vector<Vector> places = {Vector::Zero(), Vector(distance, 0, 0)};
  const Gridded_points sorted(places, range_per_spacing);
  Unwatched unwatched;
  const Neighborhoods neighbors = find_self_neighbors<CGAL::Sequential_tag>(
    sorted.grid, sorted.points, range_per_spacing, unwatched.progress);
  Samples<double> samples{Counting_allocator<Vector>()};
  for (const Vector& place : sorted.points)
    samples.positions.push_back(place / 2);
  samples.normals = samples.outward_directions = Buffer<Vector>(2, Vector::UnitZ());
  const Buffer<Vector> before = samples.positions;
  repel_tangentially<CGAL::Sequential_tag>(neighbors, sorted.points, range_per_spacing, spacing,
                                           spacing, 1, samples);
  return (samples.positions[0] - before[0]).norm() + (samples.positions[1] - before[1]).norm();
}

/// No rounding that decides whether two samples are neighbors moves them, however near they have
/// come.
void check_end_of_range()
{
  CHECK(push_of_pair(0.9 * range_per_spacing) > 0.1);
  CHECK(push_of_pair((1 - 1e-9) * range_per_spacing) < 1e-7);
  CHECK(push_of_pair((1 + 1e-9) * range_per_spacing) == 0);
}

/// Nobody leaves its tangent plane, and no step is longer than 0.3 spacings.
void check_step(Generator& generator)
{
  const Oriented_points sphere = sphere_points(1000, 1, generator);
  const double spacing = std::sqrt(4 * EIGEN_PI / 1000);
  for (std::size_t number_of_steps : {1, 5})
  {
    const Repelled repelled = repel(sphere, {}, spacing, number_of_steps);
    double off_plane = 0, longest = 0;
    for (std::size_t i = 0; i < repelled.before.size(); ++i)
    {
      const Vector step = repelled.after[i] - repelled.before[i];
      off_plane = (std::max)(off_plane, std::abs(step.dot(repelled.normals[i])));
      longest = (std::max)(longest, step.norm());
    }
    CHECK(off_plane < 1e-14);
    CHECK(longest > 0.1 * spacing
          && longest <= 0.3 * spacing * double(number_of_steps) * (1 + 1e-12));
  }
  const Repelled untouched = repel(sphere, {}, spacing, 0);
  CHECK(untouched.after == untouched.before);
}

/// No step is longer than the limit of its sample, and pushes that would be longer end there.
/// \param with_spacings whether the samples have spacings of their own, as with `keep_density`
void check_step_limit(bool with_spacings, double radius, Generator& generator)
{
  const double spacing = 1, range = range_per_spacing * spacing;
  // five to twenty times as dense as the spacings say, so that pushes at the border are long
  const Oriented_points crowd = plane_points(2000, 20, generator);
  const Gridded_points sorted(crowd.points, range);
  Samples<double> samples{Counting_allocator<Vector>()};
  samples.positions = sorted.points;
  const std::size_t n = samples.positions.size();
  samples.normals = Buffer<Vector>(n, Vector::UnitZ());
  samples.outward_directions = Buffer<Vector>(n, Vector::Zero());
  for (std::size_t i = 0; with_spacings && i < n; ++i)
    samples.spreading_radii.push_back(float(3 + sorted.points[i][0] / 10));
  const auto spacing_of = [&](std::size_t i) {
    return with_spacings ? samples.spreading_radii[i] / self_neighbor_radius_per_spacing : spacing;
  };
  Unwatched unwatched;
  using Tag = CGAL::Sequential_tag;
  const Buffer<Vector>& places = sorted.points;
  const auto neighbors = find_self_neighbors<Tag>(sorted.grid, places, range, unwatched.progress);
  repel_tangentially<Tag>(neighbors, places, range, spacing, radius, 1, samples);
  std::size_t beyond_limit = 0, at_limit = 0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double limit = (std::min)(0.3 * spacing_of(i), 0.15 * radius);
    const double step = (samples.positions[i] - sorted.points[i]).norm();
    beyond_limit += step > limit * (1 + 1e-9);
    at_limit += is_close(step, limit, 1e-9);
  }
  CHECK(beyond_limit == 0);
  CHECK(at_limit > n / 100 && at_limit < n);
}

/// Random samples become even ones.
void check_evenness(Generator& generator)
{
  Oriented_points sphere = sphere_points(1500, 1, generator);
  const double spacing = std::sqrt(4 * EIGEN_PI / 1500);
  const double before = unevenness(sphere.points);
  for (int round = 0; round < 8; ++round) // neighbors anew, as after each turn of Algorithm 1
  {
    sphere.points = repel(sphere, {}, spacing, 4).after;
    for (std::size_t i = 0; i < sphere.points.size(); ++i)
      sphere.normals[i] = sphere.points[i] = sphere.points[i].normalized();
  }
  CHECK(before > 0.4);
  CHECK(unevenness(sphere.points) < 0.1);
}

int main()
{
  Generator generator(16);
  check_lattice();
  check_end_of_range();
  check_step(generator);
  for (bool with_spacings : {false, true})
    for (double radius : {1., 10.}) // which of the two limits is the smaller one
      check_step_limit(with_spacings, radius, generator);
  check_evenness(generator);
  return result();
}
