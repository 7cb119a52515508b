// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/naive_plane.h"
#include "normals/naive_normal_filter.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/normals/refit_normals.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace test;

const double radius = 0.3, bandwidth = radius / 2, angle = 30, squared_sheet_height = 0.05 * 0.05;

/// The stage, for points in any order; the result in the order of the grid.
struct Refitted
{
  Gridded_points sorted;
  std::vector<Vector> before, after;

  Refitted(const Oriented_points& cloud)
    : sorted(cloud.points, radius), before(permuted(sorted.order, cloud.normals))
  {
    auto normals = to_local_vectors<double>(before), sequential = normals;
    const Fit_kernel<double> kernel = {radius, bandwidth * bandwidth, naive_normal_bandwidth(angle),
                                       squared_sheet_height};
    Unwatched unwatched;
    refit_normals<CGAL::Parallel_if_available_tag>(sorted.grid, sorted.points, kernel,
                                                   unwatched.progress, normals);
    refit_normals<CGAL::Sequential_tag>(sorted.grid, sorted.points, kernel, unwatched.progress,
                                        sequential);
    CHECK(normals == sequential);
    after.assign(normals.begin(), normals.end());
  }
};

/// The formulas of the docstrings, with Eigen's inverse.
void check_formula(Generator& generator)
{
  Oriented_points cloud = wedge_points(1200, generator);
  add_gaussian_noise(cloud.points, 0.02, generator);
  for (int i = 0; i < 100; ++i) // a strip of few points
  {
    cloud.points.push_back(Vector(5 + 0.07 * i, 0, 0)
                           + random_vector(Vector(0, 0.04, 0.005), generator));
    cloud.normals.push_back(Vector::UnitZ());
  }
  cloud.normals = noisy_normals(cloud.normals, 0.15, generator);
  const Refitted refitted(cloud);
  double worst = 0;
  std::size_t number_in_between = 0;
  for (std::size_t i = 0; i < refitted.before.size(); ++i)
  {
    const Vector p = refitted.sorted.vector[i], n = refitted.before[i];
    Vector mean = Vector::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    double total = 0;
    for (std::size_t j = 0; j < refitted.before.size(); ++j)
    {
      const Vector d = refitted.sorted.vector[j] - p;
      if (d.norm() >= radius)
        continue;
      const double cosine = n.dot(refitted.before[j]);
      const double height = 0.5 * (n + (cosine < 0 ? -1 : 1) * refitted.before[j]).dot(d);
      const double similarity = std::exp(-std::pow(1 - std::abs(cosine), 2)
                                           / naive_normal_bandwidth(angle)
                                         - height * height / squared_sheet_height);
      const double share = 10 * (1 - d.squaredNorm() / (radius * radius));
      const double weight = (std::min)(share, 1.)
                            * std::exp(-d.squaredNorm() / (bandwidth * bandwidth)) * similarity;
      mean += weight * d;
      squares += weight * d * d.transpose();
      total += weight;
    }
    mean /= total;
    Vector expected = n;
    if (total > 2)
    {
      const Naive_plane plane(squares / total - mean * mean.transpose(), mean, total, n);
      number_in_between += plane.share > 0.1 && plane.share < 0.9;
      expected = (n + plane.share * plane.normal).normalized();
    }
    worst = (std::max)(worst, (refitted.after[i] - expected).norm());
  }
  CHECK(worst < 1e-7);
  CHECK(number_in_between > 10);
}

/// Normals that lean over the edge, as a mean leaves them, are righted.
void check_leaning_normals(Generator& generator)
{
  Oriented_points wedge = wedge_points(4000, generator);
  const std::vector<Vector> truth = wedge.normals;
  Vector bisector = Vector::Zero();
  for (const Vector& n : truth)
    bisector += n;
  bisector.normalize();
  for (Vector& n : wedge.normals)
    n = (n + 0.2 * bisector).normalized();
  const Refitted refitted(wedge);
  const std::vector<Vector> sorted_truth = permuted(refitted.sorted.order, truth);
  double before = 0, after = 0;
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    before += angle_of_lines(refitted.before[i], sorted_truth[i]);
    after += angle_of_lines(refitted.after[i], sorted_truth[i]);
  }
  CHECK(after < 0.6 * before); // 0.51: half, and a little for points of the other side
}

/// Points on a line determine no plane, and a lonely point even less: their normals stay, up to
/// what rounding makes of a line.
void check_no_plane()
{
  Oriented_points cloud;
  for (int i = 0; i < 50; ++i)
  {
    cloud.points.push_back(Vector(0.05 * i, 0, 0));
    cloud.normals.push_back(Vector::UnitX());
  }
  cloud.points.push_back(Vector(0, 7, 0));
  cloud.normals.push_back(Vector(0.6, 0, 0.8));
  const Refitted refitted(cloud);
  CHECK(refitted.after == refitted.before);
}

/// On a line, two variances are equal up to rounding, and which normal across it has the smaller
/// one says nothing: normals across it stay as they are.
void check_line()
{
  const Vector along = Vector(1, 2, -3).normalized(), across = along.unitOrthogonal();
  double worst = 0;
  for (int k = 0; k < 12; ++k)
  {
    Oriented_points cloud;
    for (int i = 0; i < 50; ++i)
    {
      cloud.points.push_back(0.05 * i * along);
      cloud.normals.push_back(Eigen::AngleAxisd(0.5 * k, along) * across);
    }
    const Refitted refitted(cloud);
    for (std::size_t i = 0; i < refitted.after.size(); ++i)
      worst = (std::max)(worst, (refitted.after[i] - refitted.before[i]).norm());
  }
  CHECK(worst < 1e-12);
}

/// The sign that a normal comes with does not matter to others, and stays.
void check_signs(Generator& generator)
{
  Oriented_points cloud = wedge_points(800, generator);
  cloud.normals = noisy_normals(cloud.normals, 0.1, generator);
  const Refitted one(cloud);
  std::vector<double> signs;
  for (Vector& n : cloud.normals)
  {
    signs.push_back(std::bernoulli_distribution()(generator) ? 1 : -1);
    n *= signs.back();
  }
  const Refitted other(cloud);
  bool are_equal = true;
  for (std::size_t i = 0; i < signs.size(); ++i)
    are_equal = are_equal && other.after[i] == signs[other.sorted.order[i]] * one.after[i];
  CHECK(are_equal);
}

int main()
{
  Generator generator(16);
  check_formula(generator);
  check_leaning_normals(generator);
  check_no_plane();
  check_line();
  check_signs(generator);
  return result();
}
