// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"

#include <CGAL/L0_resampling/internal/normals/filter_normals.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace test;

/// The stage, for points and normals in any order.
template <typename T>
std::vector<Vector> filter(const Oriented_points& cloud, double radius, double sharpness_angle,
                           std::size_t number_of_iterations)
{
  const Gridded_points sorted(cloud.points, radius / 2);
  Buffer<Eigen::Matrix<T, 3, 1>> normals = to_local_vectors<T>(
    permuted(sorted.order, cloud.normals));
  const Normal_filter<T> settings{radius, T(radius * radius / 4),
                                  T(naive_normal_bandwidth(sharpness_angle))};
  Unwatched unwatched;
  Facts_of_cloud facts;
  for (std::size_t i = 0; i < number_of_iterations; ++i)
    filter_normals<CGAL::Parallel_if_available_tag>(sorted.grid, sorted.points, settings, facts,
                                                    unwatched.progress, normals);
  std::vector<Vector> result(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    result[sorted.order[i]] = normals[i].template cast<double>();
  return result;
}

/// The cloud with each normal turned or not, by chance.
Oriented_points with_random_signs(Oriented_points cloud, Generator& generator)
{
  for (Vector& n : cloud.normals)
    if (std::bernoulli_distribution()(generator))
      n = -n;
  return cloud;
}

Oriented_points noisy_wedge(Generator& generator)
{
  Oriented_points wedge = wedge_points(1500, generator);
  wedge.normals = noisy_normals(wedge.normals, 0.2, generator);
  return wedge;
}

/// The wedge leaning on its edge: the cosines between the normals of its sides are sums of a number
/// and its negative, which have a sign of their own.
Oriented_points roof_points(std::size_t n, Generator& generator)
{
  const double half = std::sqrt(0.5);
  Oriented_points roof = wedge_points(n, generator);
  for (std::vector<Vector>* vectors : {&roof.points, &roof.normals})
    for (Vector& v : *vectors)
      v = Vector(v[0], half * (v[1] - v[2]), half * (v[1] + v[2]));
  return roof;
}

/// One round is Eq. (1) and (2), with the square of EAR in psi.
template <typename T>
void check_equation(double tolerance, Generator& generator)
{
  const Oriented_points wedge = with_random_signs(noisy_wedge(generator), generator);
  for (double sharpness_angle : {15., 40.})
  {
    const double bandwidth = naive_normal_bandwidth(sharpness_angle);
    const auto psi = [&](double cosine) { return std::exp(-std::pow(1 - cosine, 2) / bandwidth); };
    const std::vector<Vector> once = filter_normals_naively(wedge.points, wedge.normals, 0.2, 0.1,
                                                            psi);
    const std::vector<Vector> twice = filter_normals_naively(wedge.points, once, 0.2, 0.1, psi);
    double worst = 0;
    for (std::size_t rounds : {1, 2})
    {
      const std::vector<Vector> filtered = filter<T>(wedge, 0.2, sharpness_angle, rounds);
      for (std::size_t i = 0; i < filtered.size(); ++i)
        worst = (std::max)(worst, (filtered[i] - (rounds == 1 ? once : twice)[i]).norm());
    }
    CHECK(worst < tolerance);
  }
}

/// Exact normals of two faces stay as they are, up to the edge.
void check_edge(Generator& generator)
{
  const Oriented_points wedge = wedge_points(1500, generator);
  const std::vector<Vector> filtered = filter<float>(wedge, 0.2, 15, 5);
  double worst = 0;
  for (std::size_t i = 0; i < filtered.size(); ++i)
    worst = (std::max)(worst, (filtered[i] - wedge.normals[i]).norm());
  CHECK(worst < 1e-6);
}

/// Noise shrinks with every round, on both sides of an edge.
void check_noise(Generator& generator)
{
  const Oriented_points noisy = noisy_wedge(generator);
  std::vector<Vector> truth;
  for (const Vector& p : noisy.points)
    truth.push_back(p[2] == 0 ? Vector::UnitZ() : Vector::UnitY());
  double last = mean_angle(noisy.normals, truth);
  const double before = last;
  for (std::size_t rounds = 1; rounds <= 5; ++rounds)
  {
    const double now = mean_angle(filter<float>(noisy, 0.2, 15, rounds), truth);
    CHECK(now < last);
    last = now;
  }
  CHECK(last < 0.25 * before);
}

/// The sign of a normal means nothing: turning some turns their results and changes nothing else,
/// bit by bit.
void check_signs(const Oriented_points& cloud, double radius, double sharpness_angle,
                 Generator& generator)
{
  const std::vector<Vector> filtered = filter<float>(cloud, radius, sharpness_angle, 3);
  const Oriented_points turned = with_random_signs(cloud, generator);
  const std::vector<Vector> turned_filtered = filter<float>(turned, radius, sharpness_angle, 3);
  bool are_equal = true;
  for (std::size_t i = 0; i < filtered.size(); ++i)
    are_equal = are_equal
                && turned_filtered[i]
                     == (turned.normals[i] == cloud.normals[i] ? 1 : -1) * filtered[i];
  CHECK(are_equal);
}

/// As `filter()`, looking at one ball after the other.
std::vector<Vector> filter_ball_by_ball(const Oriented_points& cloud, double radius,
                                        double sharpness_angle, std::size_t number_of_iterations)
{
  const Gridded_points sorted(cloud.points, radius / 2);
  Buffer<Vector> normals = to_buffer(permuted(sorted.order, cloud.normals));
  const Normal_filter<double> settings{radius, radius * radius / 4,
                                       naive_normal_bandwidth(sharpness_angle)};
  Unwatched unwatched;
  for (std::size_t round = 0; round < number_of_iterations; ++round)
    update_normals<CGAL::Sequential_tag>(
      sorted.grid, sorted.points, radius, unwatched.progress, normals,
      [&](const Vector& center, float, const Vector& normal, Local_points<double>& candidates,
          const Local_normals<double>& candidate_normals) {
        return filtered_normal(center, normal, candidates, candidate_normals, settings);
      });
  std::vector<Vector> result(normals.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    result[sorted.order[i]] = normals[i];
  return result;
}

/// Pairs give what balls give. A crowd, of which balls take every so manieth point, and a point so
/// far away that it shares an outermost cell, are left to balls.
void check_unusual_cells(Generator& generator)
{
  const Oriented_points wedge = noisy_wedge(generator);
  const std::vector<Vector> filtered = filter<double>(wedge, 0.2, 15, 2),
                            ball_by_ball = filter_ball_by_ball(wedge, 0.2, 15, 2);
  double worst = 0;
  for (std::size_t i = 0; i < filtered.size(); ++i)
    worst = (std::max)(worst, (filtered[i] - ball_by_ball[i]).norm());
  CHECK(worst < 1e-12);

  Oriented_points with_outlier = wedge, with_crowd = wedge;
  with_outlier.points.push_back(Vector(1e9, 0, 0));
  with_outlier.normals.push_back(Vector::UnitX());
  for (std::size_t i = 0; i < 6000; ++i)
  {
    with_crowd.points.push_back(Vector(50, 0, 0) + 0.01 * random_unit_vector(generator));
    with_crowd.normals.push_back(
      (Vector::UnitZ() + 0.3 * random_unit_vector(generator)).normalized());
  }
  for (const Oriented_points& cloud : {with_outlier, with_crowd})
    CHECK(filter<double>(cloud, 0.2, 15, 2) == filter_ball_by_ball(cloud, 0.2, 15, 2));
}

/// A point that nobody agrees with keeps its normal, and no number of rounds keeps all.
void check_loners(Generator& generator)
{
  const Oriented_points wedge = noisy_wedge(generator);
  const std::vector<Vector> unfiltered = filter<double>(wedge, 0.2, 15, 0),
                            alone = filter<double>(wedge, 1e-6, 15, 5);
  CHECK(unfiltered == wedge.normals);
  double worst = 0;
  for (std::size_t i = 0; i < alone.size(); ++i)
    worst = (std::max)(worst, (alone[i] - wedge.normals[i]).norm());
  CHECK(worst < 1e-12);
}

int main()
{
  Generator generator(5);
  check_equation<float>(2e-5, generator);
  check_equation<double>(1e-11, generator);
  check_edge(generator);
  check_noise(generator);
  check_signs(noisy_wedge(generator), 0.2, 15, generator);
  check_signs(roof_points(500, generator), 0.2, 60, generator);
  check_loners(generator);
  check_unusual_cells(generator);
  return result();
}
