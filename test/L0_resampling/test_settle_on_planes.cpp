// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "naive_normal_filter.h"

#include <CGAL/L0_resampling/internal/settle_on_planes.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

using namespace test;

const double radius = 0.8, squared_sheet_height = 0.2 * 0.2;

/// Of what noise leaves of the fit.
const double deviation = 0.01;

Samples<double> make_samples(const Oriented_points& points, const std::vector<double>& variances,
                             const std::vector<unsigned char>& are_voters)
{
  Samples<double> samples{Counting_allocator<Vector>()};
  samples.positions = to_buffer(points.points);
  samples.normals = to_buffer(points.normals);
  samples.fit_variances = to_buffer(variances);
  samples.are_voters = to_buffer(are_voters);
  return samples;
}

template <typename T, typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
Samples<double> settled(Samples<double> samples)
{
  Unwatched unwatched;
  settle_on_planes<ConcurrencyTag, T>({radius, normal_bandwidth(30), squared_sheet_height}, 0, unwatched.progress,
                                      samples);
  return samples;
}

/// All of them are asked.
Samples<double> all_voters(const Oriented_points& points, double own_deviation)
{
  return make_samples(points, std::vector<double>(points.points.size(), own_deviation * own_deviation),
                      std::vector<unsigned char>(points.points.size(), 1));
}

template <typename T>
Samples<double> settled(const Oriented_points& points, double own_deviation = deviation)
{
  return settled<T>(all_voters(points, own_deviation));
}

/// The formulas of the docstring, sample by sample.
Samples<double> settled_naively(Samples<double> samples)
{
  const Samples<double> before = samples;
  for (std::size_t i = 0; i < samples.positions.size(); ++i)
  {
    const Vector n = before.normals[i];
    double total = 0, variance = 0;
    Vector mean = Vector::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (std::size_t k = 0; k < samples.positions.size(); ++k)
    {
      const Vector d = before.positions[k] - before.positions[i];
      const double cosine = n.dot(before.normals[k]);
      const double h = 0.5 * (n + (cosine < 0 ? -1 : 1) * before.normals[k]).dot(d);
      const double w = before.are_voters[k] * clamped((1 - d.squaredNorm() / (radius * radius)) / 0.1)
                       * std::exp(-std::pow(1 - std::abs(cosine), 2) / normal_bandwidth(30))
                       * std::exp(-h * h / squared_sheet_height);
      total += w;
      variance += w * before.fit_variances[k];
      mean += w * d;
      covariance += w * d * d.transpose();
    }
    if (total <= 8)
      continue;
    mean /= total;
    covariance = covariance / total - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
    Vector plane = eigen.eigenvectors().col(0);
    plane *= plane.dot(n) < 0 ? -1 : 1;
    const Vector values = eigen.eigenvalues();
    if (plane.dot(n) <= 0.5)
      continue;
    const double ratio = values[0] * total / (total - 3) / (9 * variance / total);
    const double share = clamped((total - 8) / 8) * clamped((values[1] - values[0]) / (0.1 * values[2]))
                         * std::exp(-ratio * ratio);
    samples.positions[i] += share * plane.dot(mean) / plane.dot(n) * n;
    samples.normals[i] = ((1 - share) * n + share * plane).normalized();
  }
  return samples;
}

double largest_distance(const Buffer<Vector>& a, const Buffer<Vector>& b)
{
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = (std::max)(largest, (a[i] - b[i]).norm());
  return largest;
}

bool are_the_same(const Samples<double>& a, const Samples<double>& b)
{
  return a.positions == b.positions && a.normals == b.normals;
}

/// A wedge whose samples are some of them flat, some few, some rough, some beside the edge; with voters of all kinds.
template <typename T>
void check_formulas(double tolerance, Generator& generator)
{
  Oriented_points points = wedge_points(1200, generator);
  for (std::size_t i = 0; i < points.points.size(); ++i)
  {
    points.points[i] *= 3;
    points.points[i] += random_number(-1, 1, generator) * (points.points[i].x() < 1.5 ? 0.01 : 0.2) * points.normals[i];
  }
  points.normals = noisy_normals(points.normals, 0.1, generator);
  std::vector<double> variances;
  std::vector<unsigned char> are_voters;
  for (Vector& n : points.normals)
  {
    n *= std::bernoulli_distribution()(generator) ? 1 : -1;
    variances.push_back(random_number(2.5e-5, 2.5e-4, generator));
    are_voters.push_back(std::bernoulli_distribution(0.4)(generator));
  }
  const Samples<double> samples = make_samples(points, variances, are_voters);
  const Samples<double> result = settled<T>(samples), naive = settled_naively(samples);
  CHECK(largest_distance(result.positions, naive.positions) < tolerance);
  CHECK(largest_distance(result.normals, naive.normals) < tolerance);
  std::size_t full = 0, partly = 0; // so that the inputs are what they are said to be
  for (std::size_t i = 0; i < points.points.size(); ++i)
  {
    const double moved = (naive.positions[i] - samples.positions[i]).norm();
    full += moved > 0.005;
    partly += moved > 0 && moved < 1e-4;
  }
  CHECK(full > 100 && partly > 100);
}

double mean_height(const Samples<double>& samples)
{
  double sum = 0;
  for (const Vector& p : samples.positions)
    sum += std::abs(p.z());
  return sum / double(samples.positions.size());
}

/// What noise leaves of a plane becomes less by far; its normals turn up.
void check_plane(Generator& generator)
{
  Oriented_points plane = plane_points(3000, 2, generator);
  for (Vector& p : plane.points)
    p.z() += std::normal_distribution<>(0, 0.01)(generator);
  plane.normals = noisy_normals(plane.normals, 0.05, generator);
  const Samples<double> result = settled<float>(plane);
  CHECK(mean_height(result) < 0.002);
  double turned = 0;
  for (const Vector& n : result.normals)
    turned = (std::max)(turned, angle_of_lines(n, Vector::UnitZ()));
  CHECK(turned < 1);
}

/// Nothing moves where points are clean, nor for so few that there is always a plane.
void check_what_stays(Generator& generator)
{
  const Oriented_points wedge = wedge_points(1000, generator);
  CHECK(settled<float>(wedge, 0).positions == to_buffer(wedge.points));

  Oriented_points few;
  for (int k = 0; k < 8; ++k)
  {
    few.points.push_back(0.1 * random_unit_vector(generator));
    few.normals.push_back(Vector::UnitZ());
  }
  CHECK(settled<double>(few).positions == to_buffer(few.points));
  std::vector<unsigned char> nobody(wedge.points.size(), 0);
  const Samples<double> unasked = make_samples(wedge, std::vector<double>(nobody.size(), 1e-4), nobody);
  CHECK(are_the_same(settled<double>(unasked), unasked));
}

/// Detail that stands out from the noise stays; less noise, more of it.
void check_detail(Generator& generator)
{
  Oriented_points waves = plane_points(3000, 2, generator);
  for (std::size_t i = 0; i < waves.points.size(); ++i)
  {
    const double x = 4 * waves.points[i].x();
    waves.points[i].z() += 0.1 * std::sin(x);
    waves.normals[i] = Vector(-0.4 * std::cos(x), 0, 1).normalized();
  }
  CHECK(largest_distance(settled<float>(waves, deviation / 5).positions, to_buffer(waves.points)) < 1e-3);
  CHECK(largest_distance(settled<float>(waves, 20 * deviation).positions, to_buffer(waves.points)) > 0.05);
}

/// Each side of an edge keeps its plane, and the edge its place.
void check_edge(Generator& generator)
{
  Oriented_points wedge = wedge_points(3000, generator);
  const Oriented_points clean = wedge;
  for (std::size_t i = 0; i < wedge.points.size(); ++i)
    wedge.points[i] += std::normal_distribution<>(0, 0.01)(generator) * wedge.normals[i];
  const Samples<double> result = settled<float>(wedge);
  double off_face = 0, turned = 0;
  for (std::size_t i = 0; i < clean.points.size(); ++i)
  {
    off_face += std::abs((result.positions[i] - clean.points[i]).dot(clean.normals[i])) / double(clean.points.size());
    turned = (std::max)(turned, angle_of_lines(result.normals[i], clean.normals[i]));
  }
  CHECK(off_face < 0.002);
  CHECK(turned < 1);
}

/// Two sheets at three times H, where each weighs e^-9 in the other, stay where they are.
void check_two_sheets(Generator& generator)
{
  Oriented_points sheets = plane_points(4000, 2, generator);
  for (std::size_t i = 0; i < sheets.points.size(); ++i)
    sheets.points[i].z() += i % 2 ? 0.6 : 0;
  CHECK(largest_distance(settled<float>(sheets).positions, to_buffer(sheets.points)) < 0.6 * std::exp(-9) * 2);
}

/// A narrow strip has no plane across it, so that a rounding would turn its normals.
void check_strip(Generator& generator)
{
  Oriented_points strip;
  for (int i = 0; i < 400; ++i)
  {
    strip.points.emplace_back(random_number(-2, 2, generator), random_number(-1e-3, 1e-3, generator),
                              random_number(-1e-3, 1e-3, generator));
    strip.normals.push_back(Vector::UnitZ());
  }
  double turned = 0;
  for (const Vector& n : settled<double>(strip).normals)
    turned = (std::max)(turned, angle_of_lines(n, Vector::UnitZ()));
  CHECK(turned < 0.5);
}

void check_threads(Generator& generator)
{
  Oriented_points wedge = wedge_points(3000, generator);
  add_gaussian_noise(wedge.points, 0.01, generator);
  const Samples<double> samples = all_voters(wedge, deviation);
  CHECK(are_the_same(settled<float, CGAL::Sequential_tag>(samples),
                     settled<float, CGAL::Parallel_if_available_tag>(samples)));
}

/// About as many in every ball, however dense the samples are, if only there are enough; never none that start on a point.
void check_choice()
{
  for (double spacing : {0.001, 0.01, 0.1, 0.3})
  {
    const double in_ball = EIGEN_PI * 16 / (spacing * spacing);
    for (double share_on_points : {1., 0.25})
    {
      const Choice_of_voters choice(7, 1, spacing, 1000, std::size_t(1000 * share_on_points));
      const double asked = in_ball * share_on_points / double(choice.stride);
      CHECK((choice.stride == 1 && asked < 128) || (asked >= 64 && asked < 128));
      std::size_t taken = 0;
      const std::size_t count = 4000 * choice.stride;
      for (std::size_t source = 0; source < (std::min)(count, std::size_t(20000000)); ++source)
        taken += choice.takes(source);
      CHECK(std::abs(double(taken) * double(choice.stride) / double((std::min)(count, std::size_t(20000000))) - 1) < 0.1);
    }
  }
  CHECK(Choice_of_voters(7, 1, 2, 1, 1).takes(0));
  CHECK(Choice_of_voters(7, 1, 1e-9, 1000, 1000).stride == std::uint64_t(1) << 20); // a length of no samples
}

int main()
{
  Generator generator(20261122);
  check_formulas<double>(1e-9, generator);
  check_formulas<float>(2e-4, generator);
  check_plane(generator);
  check_what_stays(generator);
  check_detail(generator);
  check_edge(generator);
  check_two_sheets(generator);
  check_strip(generator);
  check_threads(generator);
  check_choice();
  return result();
}
