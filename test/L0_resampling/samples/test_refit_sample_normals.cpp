// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/naive_plane.h"
#include "normals/naive_normal_filter.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/refit_sample_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace test;

const double radius = 0.3;
const Fit_kernel<double> kernel = {
  radius, square(0.6 * radius), square(1 - std::cos(37.5 * EIGEN_PI / 180)), square(0.2 * radius)};

/// The stage, for samples in any order; the result in the order of the grid.
struct Refitted
{
  Gridded_points sorted;
  std::vector<Vector> before, after;

  explicit Refitted(const Oriented_points& cloud)
    : sorted(cloud.points, radius), before(permuted(sorted.order, cloud.normals))
  {
    Samples<double> samples{Counting_allocator<Vector>()};
    samples.positions = sorted.points;
    samples.normals = to_buffer(before);
    Unwatched unwatched;
    const Neighborhoods neighbors = find_self_neighbors<CGAL::Sequential_tag>(
      sorted.grid, sorted.points, radius, unwatched.progress);
    Samples<double> sequential = samples;
    refit_sample_normals<CGAL::Parallel_if_available_tag>(kernel, neighbors, samples);
    refit_sample_normals<CGAL::Sequential_tag>(kernel, neighbors, sequential);
    CHECK(samples.normals == sequential.normals);
    after.assign(samples.normals.begin(), samples.normals.end());
  }
};

/// The formulas of the docstrings, with Eigen's inverse.
void check_formula(Generator& generator)
{
  Oriented_points cloud = wedge_points(1200, generator);
  add_gaussian_noise(cloud.points, 0.02, generator);
  cloud.points.emplace_back(5, 0, 0); // nobody is near this one
  cloud.normals.emplace_back(0, 0, 1);
  cloud.normals = noisy_normals(cloud.normals, 0.5, generator);
  const Refitted refitted(cloud);
  double worst = 0;
  std::size_t number_halfway = 0, number_in_between = 0;
  for (std::size_t i = 0; i < refitted.before.size(); ++i)
  {
    const Vector p = refitted.sorted.vector[i], n = refitted.before[i];
    double total = 0;
    Vector mean = Vector::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < refitted.before.size(); ++k)
    {
      const Vector d = refitted.sorted.vector[k] - p;
      const double cosine = n.dot(refitted.before[k]), sign = cosine < 0 ? -1 : cosine > 0;
      const double height = 0.5 * (n + sign * refitted.before[k]).dot(d),
                   share = 10 * (1 - d.squaredNorm() / square(radius));
      const double weight = (std::min)((std::max)(share, 0.), 1.)
                            * std::exp(-d.squaredNorm() / square(0.6 * radius)
                                       - square(1 - std::abs(cosine)) / kernel.normal_bandwidth
                                       - square(height / (0.2 * radius)));
      total += weight;
      mean += weight * d;
      squares += weight * d * d.transpose();
    }
    mean /= total;
    Vector expected = n;
    if (total > 2)
    {
      const Naive_plane plane(squares / total - mean * mean.transpose(), mean, total, n);
      number_halfway += plane.share > 0.99;
      number_in_between += plane.share > 0.1 && plane.share < 0.9;
      expected = (n + plane.share * plane.normal).normalized();
    }
    worst = (std::max)(worst, (refitted.after[i] - expected).norm());
  }
  CHECK(worst < 1e-7);
  CHECK(number_halfway > 100);
  CHECK(number_in_between > 10);
}

/// The error of normals is halved, on a bent surface as on two faces with an edge between them.
void check_clean_samples(const Oriented_points& truth, Generator& generator)
{
  Oriented_points cloud = truth;
  cloud.normals = noisy_normals(cloud.normals, 0.05, generator);
  const Refitted refitted(cloud);
  CHECK(mean_angle(refitted.after, permuted(refitted.sorted.order, truth.normals))
        < 0.6 * mean_angle(cloud.normals, truth.normals));
}

/// Samples on a line, in one place, and alone have no plane.
void check_no_plane()
{
  Oriented_points cloud;
  const Vector along = Vector(1, 2, -3).normalized(), across = along.unitOrthogonal();
  for (int i = 0; i < 50; ++i)
  {
    cloud.points.push_back(0.05 * i * along);
    cloud.normals.push_back(across);
    cloud.points.push_back(Vector(9, 0, 0));
    cloud.normals.push_back(Vector::UnitX());
  }
  cloud.points.push_back(Vector(0, 7, 0));
  cloud.normals.push_back(Vector(0.6, 0, 0.8));
  const Refitted refitted(cloud);
  double worst = 0;
  for (std::size_t i = 0; i < refitted.before.size(); ++i)
    worst = (std::max)(worst, (refitted.after[i] - refitted.before[i]).norm());
  CHECK(worst < 1e-12);
}

/// The sign of a neighbor's normal does not matter, also where it is at a right angle to the
/// sample's own.
void check_right_angles(Generator& generator)
{
  Oriented_points cube = cube_points(2000, 1, generator), turned = cube;
  for (Vector& n : turned.normals)
    if (n.x() != 0)
      n = -n;
  const Refitted refitted(cube), of_turned(turned);
  for (std::size_t i = 0; i < refitted.before.size(); ++i)
    if (refitted.before[i] == of_turned.before[i])
      CHECK(refitted.after[i] == of_turned.after[i]);
}

int main()
{
  Generator generator(15);
  check_formula(generator);
  check_clean_samples(sphere_points(3000, 1, generator), generator);
  check_clean_samples(wedge_points(4000, generator), generator);
  check_no_plane();
  check_right_angles(generator);
  return result();
}
