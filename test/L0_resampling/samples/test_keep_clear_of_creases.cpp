// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "samples/sorted_samples.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/kernels/lengths_of_refinement.h>
#include <CGAL/L0_resampling/internal/samples/keep_clear_of_creases.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace test;

const double spacing = 0.05;

struct Slid
{
  Buffer<Vector> positions;
  Buffer<Local_vector> normals;
};

Slid slid(const Oriented_points& samples, const Buffer<Bend>& bends, int times = 1)
{
  const auto run = [&](auto tag) {
    using Tag = decltype(tag);
    Slid result = {to_buffer(samples.points), to_local_vectors<Local>(samples.normals)};
    Unwatched unwatched;
    for (int k = 0; k < times; ++k)
      keep_clear_of_creases<Tag>(bends, spacing, 0, unwatched.progress, result.positions,
                                 result.normals);
    return result;
  };
  Slid result = run(CGAL::Parallel_if_available_tag());
  const Slid sequential = run(CGAL::Sequential_tag());
  CHECK(result.positions == sequential.positions && result.normals == sequential.normals);
  return result;
}

Slid slid(const Oriented_points& samples, int times = 1)
{
  return slid(samples, Buffer<Bend>(samples.points.size()), times);
}

struct Naively_slid
{
  Vector position, normal;
  bool is_at_limit = false; // of what is a face, and how steep a way may be
};

/// \param side_of tells the face of a sample
template <typename Side_of>
Naively_slid slid_naively(const Oriented_points& samples, const Buffer<Bend>& bends, std::size_t i,
                          const Side_of& side_of)
{
  const Vector p = samples.points[i], n = samples.normals[i];
  struct Face
  {
    Vector normals = Vector::Zero();
    double weight = 0, height = 0, squared_height = 0;
  };
  std::vector<Face> faces(6);
  Vector of_own = Vector::Zero();
  double weight_of_own = 0;
  for (std::size_t k = 0; k < samples.points.size(); ++k)
  {
    const Vector d = p - samples.points[k], other = samples.normals[k];
    const double w = 1 - d.squaredNorm() / square(3 * spacing);
    if (w <= 0)
      continue;
    if (std::abs(n.dot(other)) >= 0.87)
    {
      of_own -= w * d;
      weight_of_own += w;
      continue;
    }
    Face& face = faces[side_of(k)];
    face.normals += w * other;
    face.weight += w;
    face.height += w * other.dot(d);
    face.squared_height += w * square(other.dot(d));
  }
  Naively_slid result = {p, n};
  Vector way = Vector::Zero();
  for (const Face& face : faces)
  {
    const double variance = face.squared_height / face.weight - square(face.height / face.weight),
                 maximum_variance = square(0.3 * spacing);
    result.is_at_limit |= std::abs(face.weight - 2.5) < 1e-4
                          || std::abs(variance / maximum_variance - 1) < 1e-4;
    if (face.weight < 2.5 || variance > maximum_variance)
      continue;
    const Vector other = face.normals.normalized();
    const double cosine = other.dot(n), sine = std::sqrt(1 - cosine * cosine),
                 height = face.height / face.weight,
                 height_of_own = height + other.dot(of_own) / weight_of_own,
                 side = height_of_own > 0 ? 1 : -1;
    if (sine < 0.3)
      continue;
    result.is_at_limit |= std::abs(height_of_own) < 1e-4 * spacing;
    const double missing = (std::min)(0.35 * spacing * sine - side * height, spacing);
    if (missing > 0)
      way += side * missing / (sine * sine) * (other - cosine * n);
  }
  if (way.norm() > spacing)
    way *= spacing / way.norm();
  const Bend& b = bends[i];
  Eigen::Matrix3d form;
  form << b.xx, b.xy, b.xz, b.xy, b.yy, b.yz, b.xz, b.yz, b.zz;
  const Vector slope = form * way;
  result.is_at_limit |= std::abs(slope.squaredNorm() - 0.12) < 1e-4;
  if (slope.squaredNorm() > 0.12)
    return result;
  result.position += way + slope.dot(way) / 2 * n;
  result.normal = (n - slope).normalized();
  return result;
}

/// A cube with samples beside, on and beyond its edges and corners, or a hole of this shape, with
/// surfaces that bend in any way. The faces are known here.
void check_formula(bool is_hole, Generator& generator)
{
  const double side = 0.6;
  Oriented_points cube = cube_points(1600, side, generator);
  std::vector<std::size_t> sides;
  for (std::size_t i = 0; i < cube.points.size(); ++i)
  {
    Vector &p = cube.points[i], &n = cube.normals[i];
    Eigen::Index axis;
    n.cwiseAbs().maxCoeff(&axis);
    sides.push_back(std::size_t(2 * axis + (n[axis] > 0)));
    const double height = p[axis];
    p *= 1.1; // beyond the edges
    p[axis] = height;
    n = (is_hole ? -1 : 1) * noisy_normals({n}, 0.03, generator)[0].cast<Local>().cast<double>();
  }
  Buffer<Bend> bends;
  for (std::size_t i = 0; i < cube.points.size(); ++i)
  {
    const Tangent_frame frame(triple(cube.normals[i]));
    const auto any = [&]() { return random_number(-5, 5, generator); };
    bends.push_back(bend_of(any(), any(), any(), frame.u, frame.v));
  }
  const Slid result = slid(cube, bends);
  double off = 0, number_of_moved = 0, number_of_steep = 0;
  for (std::size_t i = 0; i < cube.points.size(); ++i)
  {
    const Naively_slid naive = slid_naively(cube, bends, i,
                                            [&](std::size_t k) { return sides[k]; });
    if (naive.is_at_limit)
      continue;
    off = (std::max)({off, (result.positions[i] - naive.position).norm() / spacing,
                      (result.normals[i].cast<double>() - naive.normal).norm()});
    number_of_moved += naive.position != cube.points[i];
    number_of_steep += (naive.normal - cube.normals[i]).norm() > 0.2;
  }
  CHECK(off < 1e-4);
  CHECK(number_of_moved > 200 && number_of_moved < 1000 && number_of_steep > 5);
}

/// Bends are forms on space: those of a quadric over its tangent plane.
void check_bends()
{
  const Triple u = {0.6, 0.8, 0}, v = {0, 0, 1};
  const Bend bend = bend_of(1, 2, 3, u, v);
  const auto height = [&](const Triple& t) {
    const Symmetric_matrix form = {bend.xx, bend.xy, bend.xz, bend.yy, bend.yz, bend.zz};
    return dot(multiply(form, t), t) / 2;
  };
  for (const double a : {-1., 0., 0.5})
    for (const double b : {-2., 0., 1.})
      CHECK(std::abs(height(a * u + b * v) - (a * a + 2 * a * b + 3 * b * b)) < 1e-5);
}

/// The two faces of a roof, which meet in the line x = z = 0 and go down, or up, by this angle. All
/// of their rows of samples end beyond the edge, or inside of it.
/// \param stray of a sample of every fifth row of one face, in spacings beyond the edge
Oriented_points roof_samples(double degrees, double beyond, double stray, Generator& generator)
{
  const double angle = degrees * EIGEN_PI / 180;
  Oriented_points roof;
  for (const double side : {-1., 1.})
  {
    const Vector away(side * std::cos(angle), 0, -std::sin(angle)),
      normal(side * std::sin(angle), 0, std::cos(angle));
    for (int row = 0; row < 20; ++row)
      for (int k = 0; k < 9; ++k)
      {
        const double x = k - beyond + random_number(-0.2, 0.2, generator),
                     y = row + random_number(-0.2, 0.2, generator);
        roof.points.push_back(
          spacing
          * ((k == 0 && row % 5 == 2 && side > 0 ? -stray : x) * away + y * Vector::UnitY()));
        roof.normals.push_back(normal);
      }
  }
  return roof;
}

/// How far inside of the edge a sample is, in spacings.
double depth(const Vector& p, const Vector& normal, double degrees)
{
  const double angle = degrees * EIGEN_PI / 180;
  return Vector((normal.x() * std::sin(angle) > 0 ? 1 : -1) * std::cos(angle), 0, -std::sin(angle))
           .dot(p)
         / spacing;
}

/// Samples beyond an edge come back, on their own face and as far as the driver lets them; those
/// away from it stay where they are. Convex and concave edges of several angles.
void check_edge(double degrees, double beyond, double stray, Generator& generator)
{
  const Oriented_points roof = roof_samples(degrees, beyond, stray, generator);
  const Slid result = slid(roof, number_of_clearances);
  double least = 1e9, off_face = 0, along = 0, number_of_moved = 0, number_away = 0;
  for (std::size_t i = 0; i < roof.points.size(); ++i)
  {
    const Vector &p = roof.points[i], &n = roof.normals[i], way = result.positions[i] - p;
    least = (std::min)(least, depth(result.positions[i], n, degrees));
    off_face = (std::max)(off_face, std::abs(way.dot(n)) / spacing);
    along = (std::max)(along, std::abs(way.y()) / spacing);
    number_of_moved += way != Vector::Zero();
    CHECK(result.normals[i] == n.cast<Local>());
    if (depth(p, n, degrees) > 0.5)
    {
      ++number_away;
      CHECK(way == Vector::Zero());
    }
  }
  CHECK(least > 0.3);
  CHECK(off_face < 1e-4 && along < 1e-4);
  CHECK(number_away > 300 && number_of_moved > 20);
}

void check_edges(Generator& generator)
{
  for (const double degrees : {45., 25., 50., -45., -25., -50.})
  {
    for (const double beyond : {0.2, 0., -0.2})
      check_edge(degrees, beyond, 0, generator);
    check_edge(degrees, -0.1, 0.6, generator);
  }
}

/// Nothing moves on a plane, on a sphere, on the two sheets of a plate, and beside a sample or two
/// of another face.
void check_what_stays(Generator& generator)
{
  const auto stays = [](const Oriented_points& samples) {
    return slid(samples).positions == to_buffer(samples.points);
  };
  Oriented_points plane = even_samples(spacing, generator);
  CHECK(stays(plane));
  CHECK(stays(sphere_points(3000, 0.8, generator)));
  Oriented_points lone = plane;
  lone.points.emplace_back(0.3 * spacing, 0.2 * spacing, -1.6 * spacing);
  lone.normals.push_back(Vector::UnitX());
  CHECK(stays(lone));
  for (std::size_t i = 0; i < plane.points.size(); i += 2)
  {
    plane.points[i].z() = -0.5 * spacing;
    plane.normals[i] = -Vector::UnitZ();
  }
  CHECK(stays(plane));
}

/// Samples slide along a wall that bends, not along its tangent plane.
void check_bent_wall(Generator& generator)
{
  const double size = 8 * spacing;
  Oriented_points cylinder;
  Buffer<Bend> bends;
  for (double angle = 0; angle < 2 * EIGEN_PI; angle += spacing / size)
    for (double z = -6; z < 0.5; ++z)
    {
      const Vector n(std::cos(angle), std::sin(angle), 0), along(-n.y(), n.x(), 0);
      cylinder.points.push_back(size * n + spacing * (z + 0.5) * Vector::UnitZ());
      cylinder.normals.push_back(n);
      bends.push_back(bend_of(-1 / (2 * size), 0, 0, triple(along), {0, 0, 1}));
    }
  const std::size_t number_on_wall = cylinder.points.size();
  for (const Vector& p : even_samples(spacing, generator).points)
    if (p.norm() < size + 0.3 * spacing)
    {
      cylinder.points.push_back(p);
      cylinder.normals.push_back(Vector::UnitZ());
      bends.emplace_back();
    }
  const Slid result = slid(cylinder, bends, number_of_clearances);
  double off = 0, turned = 0, highest = -1e9;
  for (std::size_t i = 0; i < number_on_wall; ++i)
  {
    const Vector p = result.positions[i], n = result.normals[i].cast<double>();
    const Vector outwards = Vector(p.x(), p.y(), 0).normalized();
    off = (std::max)(off, std::abs(std::hypot(p.x(), p.y()) - size) / spacing);
    turned = (std::max)(turned, angle_of_lines(n, outwards));
    highest = (std::max)(highest, p.z() / spacing);
  }
  CHECK(off < 0.05);
  CHECK(turned < 1);
  CHECK(highest < -0.3);
}

void check_few()
{
  CHECK(slid(Oriented_points()).positions.empty());
  const Oriented_points one = {{Vector(1, 2, 3)}, {Vector::UnitX()}};
  CHECK(slid(one).positions == to_buffer(one.points));
}

int main()
{
  Generator generator(20261128);
  check_formula(false, generator);
  check_formula(true, generator);
  check_bends();
  check_edges(generator);
  check_what_stays(generator);
  check_bent_wall(generator);
  check_few();
  return result();
}
