// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/refit_sample_normals.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace test;

const double radius = 0.3;
const Sample_refit_kernel kernel(radius, square(1 - std::cos(37.5 * EIGEN_PI / 180)));

/// The stage, for samples in any order; the result in the order of the grid.
struct Refitted
{
  Gridded_points sorted;
  std::vector<Vector> before, after;
  std::vector<double> variances;

  Refitted(const Oriented_points& cloud, const std::vector<double>& unsorted_variances,
           std::size_t number_of_passes)
    : sorted(cloud.points, radius), before(permuted(sorted.order, cloud.normals))
  {
    for (Index i : sorted.order)
      variances.push_back(unsorted_variances[i]);
    Samples<double> samples{Counting_allocator<Vector>()};
    samples.positions = sorted.points;
    samples.normals = to_buffer(before);
    samples.fit_variances.assign(variances.begin(), variances.end());
    Unwatched unwatched;
    const Neighborhoods neighbors = find_self_neighbors<CGAL::Sequential_tag>(
      sorted.grid, sorted.points, radius, unwatched.progress);
    Samples<double> sequential = samples;
    refit_sample_normals<CGAL::Parallel_if_available_tag>(kernel, neighbors, number_of_passes,
                                                          samples);
    refit_sample_normals<CGAL::Sequential_tag>(kernel, neighbors, number_of_passes, sequential);
    CHECK(samples.normals == sequential.normals);
    after.assign(samples.normals.begin(), samples.normals.end());
  }

  Refitted(const Oriented_points& cloud, double variance, std::size_t number_of_passes)
    : Refitted(cloud, std::vector<double>(cloud.points.size(), variance), number_of_passes)
  {}
};

/// The formulas of the docstrings, with Eigen's inverse.
void check_formula(Generator& generator)
{
  Oriented_points cloud = wedge_points(1200, generator);
  add_gaussian_noise(cloud.points, 0.02, generator);
  cloud.points.emplace_back(5, 0, 0); // nobody is near this one
  cloud.normals.emplace_back(0, 0, 1);
  cloud.normals = noisy_normals(cloud.normals, 0.3, generator);
  std::vector<double> variances;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    variances.push_back(square(random_number(0, 0.05, generator)));
  const Refitted refitted(cloud, variances, 1);
  double worst = 0;
  std::size_t number_halfway = 0, number_in_between = 0;
  for (std::size_t i = 0; i < refitted.before.size(); ++i)
  {
    const Vector p = refitted.sorted.vector[i], n = refitted.before[i];
    double total = 0, variance = 0;
    Vector mean = Vector::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < refitted.before.size(); ++k)
    {
      const Vector d = refitted.sorted.vector[k] - p;
      const double cosine = n.dot(refitted.before[k]), sign = cosine < 0 ? -1 : cosine > 0;
      const double height = 0.5 * (n + sign * refitted.before[k]).dot(d),
                   share = 10 * (1 - d.squaredNorm() / square(radius));
      const double weight = (std::min)((std::max)(share, 0.), 1.)
                            * std::exp(-d.squaredNorm() / square(0.7 * radius)
                                       - square(1 - std::abs(cosine)) / kernel.normal_bandwidth
                                       - square(height / (radius / 8)));
      total += weight;
      mean += weight * d;
      squares += weight * d * d.transpose();
      variance += weight * refitted.variances[k];
    }
    mean /= total;
    Eigen::Matrix3d covariance = squares / total - mean * mean.transpose();
    Vector expected = n;
    if (total > 2)
    {
      covariance = (covariance / covariance.trace() + 0.01 * Eigen::Matrix3d::Identity()).eval();
      const Vector plane = (covariance.inverse() * (covariance.inverse() * n)).normalized();
      const double cosine = plane.dot(n);
      const double share =
        1 - std::exp(-square(2 * (1 - cosine) / (variance / total / square(radius) + 1e-12)));
      const double weight = (std::min)((total - 2) / 2, 1.)
                            * (std::min)((std::max)((cosine - 0.5) / 0.1, 0.), 1.) * share;
      number_halfway += weight > 0.99;
      number_in_between += weight > 0.1 && weight < 0.9;
      expected = (n + weight * plane).normalized();
    }
    worst = (std::max)(worst, (refitted.after[i] - expected).norm());
  }
  CHECK(worst < 1e-7);
  CHECK(number_halfway > 100);
  CHECK(number_in_between > 100);
}

/// Where fits are exact, a pass halves the error of normals, on a bent surface as on two faces with
/// an edge between them.
void check_exact_fits(const Oriented_points& truth, Generator& generator)
{
  Oriented_points cloud = truth;
  cloud.normals = noisy_normals(cloud.normals, 0.05, generator);
  double before = mean_angle(cloud.normals, truth.normals);
  for (std::size_t number_of_passes : {1, 2})
  {
    const Refitted refitted(cloud, 0, number_of_passes);
    const double after = mean_angle(refitted.after, permuted(refitted.sorted.order, truth.normals));
    CHECK(after < 0.6 * before);
    before = after;
  }
}

/// Normals that are exact on a plane stay so where the heights of the samples are known to be
/// noise, and follow them where not.
void check_noise(Generator& generator)
{
  const double noise = 0.01;
  Oriented_points plane = plane_points(2000, 3, generator);
  for (Vector& p : plane.points)
    p.z() += std::normal_distribution<>(0, noise)(generator);
  const Refitted with_noise(plane, noise * noise, 2), without(plane, 0, 2);
  const double of_noise = mean_angle(without.after, without.before);
  CHECK(of_noise > 0.3);
  CHECK(mean_angle(with_noise.after, with_noise.before)
        < 0.3 * of_noise); // 0.21: a tilt may be twice what is usual
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
  const Refitted refitted(cloud, 0, 2);
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
  const Refitted refitted(cube, 0, 1), of_turned(turned, 0, 1);
  for (std::size_t i = 0; i < refitted.before.size(); ++i)
    if (refitted.before[i] == of_turned.before[i])
      CHECK(refitted.after[i] == of_turned.after[i]);
}

int main()
{
  Generator generator(15);
  check_formula(generator);
  check_exact_fits(sphere_points(3000, 1, generator), generator);
  check_exact_fits(wedge_points(4000, generator), generator);
  check_noise(generator);
  check_no_plane();
  check_right_angles(generator);
  return result();
}
