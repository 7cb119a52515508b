// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/naive_plane.h"
#include "normals/naive_normal_filter.h"

#include <CGAL/L0_resampling/internal/samples/project_to_local_quadrics.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace test;

const double radius = 0.8, squared_sheet_height = 0.2 * 0.2;

/// Of what noise leaves of the fit.
const double deviation = 0.01;

Samples<double> make_samples(const Oriented_points& points, const std::vector<double>& variances,
                             const std::vector<unsigned char>& are_support_points)
{
  Samples<double> samples{Counting_allocator<Vector>()};
  samples.positions = to_buffer(points.points);
  samples.normals = to_buffer(points.normals);
  samples.fit_variances = to_buffer(variances);
  samples.are_support_points = to_buffer(are_support_points);
  return samples;
}

template <typename ConcurrencyTag = CGAL::Parallel_if_available_tag>
Samples<double> settled(Samples<double> samples)
{
  Unwatched unwatched;
  project_to_local_quadrics<ConcurrencyTag>({radius, std::numeric_limits<double>::infinity(),
                                             naive_normal_bandwidth(30), squared_sheet_height},
                                            0, unwatched.progress, samples);
  return samples;
}

/// All of them are asked.
Samples<double> all_support_points(const Oriented_points& points, double own_deviation)
{
  return make_samples(points,
                      std::vector<double>(points.points.size(), own_deviation * own_deviation),
                      std::vector<unsigned char>(points.points.size(), 1));
}

Samples<double> settled(const Oriented_points& points, double own_deviation = deviation)
{
  return settled(all_support_points(points, own_deviation));
}

/// What the docstring's formulas make of a sample.
struct Naively_settled
{
  Vector position, normal;
  double share_of_quadric, share_of_plane;
};

Naively_settled settled_naively(const Samples<double>& samples, std::size_t i)
{
  const Vector n = samples.normals[i], u = n.unitOrthogonal(), v = n.cross(u);
  double total = 0, variance = 0, squares = 0;
  Vector mean = Vector::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  for (std::size_t k = 0; k < samples.positions.size(); ++k)
  {
    const Vector d = samples.positions[k] - samples.positions[i];
    const double cosine = n.dot(samples.normals[k]);
    const double h = 0.5 * (n + (cosine < 0 ? -1 : 1) * samples.normals[k]).dot(d);
    const double w = samples.are_support_points[k]
                     * clamped((1 - d.squaredNorm() / (radius * radius)) / 0.1)
                     * std::exp(-std::pow(1 - std::abs(cosine), 2) / naive_normal_bandwidth(30))
                     * std::exp(-h * h / squared_sheet_height);
    const double x = u.dot(d) / radius, y = v.dot(d) / radius, z = n.dot(d);
    const Eigen::Matrix<double, 6, 1> row =
      (Eigen::Matrix<double, 6, 1>() << 1, x, y, x * x, x * y, y * y).finished();
    total += w;
    variance += w * samples.fit_variances[k];
    mean += w * d;
    covariance += w * d * d.transpose();
    matrix += w * row * row.transpose();
    right += w * z * row;
    squares += w * z * z;
  }
  Naively_settled result = {samples.positions[i], n, 0, 0};
  if (!(total > 0))
    return result;
  mean /= total;
  const double believed = 9 * variance / total;
  // what the support points leave open is as small as can be
  matrix.diagonal() += 1e-6 * total
                       * (Eigen::Matrix<double, 6, 1>() << 0, 1, 1, 1, 0.5, 1).finished();
  const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factors(matrix);
  const Eigen::Matrix<double, 6, 1> quadric = factors.solve(right);
  const double leverage = total * factors.solve(Eigen::Matrix<double, 6, 1>::Unit(0))[0];
  const Vector of_quadric = (n - quadric[1] / radius * u - quadric[2] / radius * v).normalized();
  if (total > 5)
    result.share_of_quadric = naive_share_of_surface(
      total, 5, leverage, of_quadric.dot(n), (squares - quadric.dot(right)) / total / believed);
  const Naive_plane plane(covariance / total - mean * mean.transpose(), mean, total, n, believed);
  result.share_of_plane = plane.share;

  const double rest = 1 - result.share_of_plane;
  const double height = rest * result.share_of_quadric * quadric[0]
                        + (plane.share > 0 ? plane.share * plane.height : 0);
  result.position += height * n;
  result.normal = (rest * ((1 - result.share_of_quadric) * n + result.share_of_quadric * of_quadric)
                   + result.share_of_plane * plane.normal)
                    .normalized();
  return result;
}

double maximum_distance(const Buffer<Vector>& a, const Buffer<Vector>& b)
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

/// What share of the samples planes and quadrics count for, and in part only.
struct Occurrences
{
  double planes = 0, quadrics = 0, in_part = 0;
};

/// \param points rough where x is more than 1.5, with support points of all kinds
Occurrences check_formulas(Oriented_points points, double tolerance, Generator& generator)
{
  for (std::size_t i = 0; i < points.points.size(); ++i)
    points.points[i] += random_number(-1, 1, generator) * (points.points[i].x() < 1.5 ? 0.01 : 0.2)
                        * points.normals[i];
  points.normals = noisy_normals(points.normals, 0.1, generator);
  std::vector<double> variances;
  std::vector<unsigned char> are_support_points;
  for (Vector& n : points.normals)
  {
    n *= std::bernoulli_distribution()(generator) ? 1 : -1;
    variances.push_back(random_number(2.5e-5, 2.5e-4, generator));
    are_support_points.push_back(std::bernoulli_distribution(0.4)(generator));
  }
  const Samples<double> samples = make_samples(points, variances, are_support_points),
                        result = settled(samples);
  double off = 0;
  Occurrences occurrences;
  const double share = 1 / double(points.points.size());
  for (std::size_t i = 0; i < points.points.size(); ++i)
  {
    const Naively_settled naive = settled_naively(samples, i);
    off = (std::max)({off, (result.positions[i] - naive.position).norm(),
                      (result.normals[i] - naive.normal).norm()});
    const double plane = naive.share_of_plane, quadric = naive.share_of_quadric;
    occurrences.planes += plane > 0.9 ? share : 0;
    occurrences.quadrics += plane < 0.1 && quadric > 0.9 ? share : 0;
    occurrences.in_part += plane < 0.1 && quadric > 0.1 && quadric < 0.9 ? share : 0;
  }
  CHECK(off < tolerance);
  return occurrences;
}

/// On a wedge, where samples are some of them flat, some few, some rough, some beside the edge; and
/// on a sphere, on which there are no planes.
void check_formulas(double tolerance, Generator& generator)
{
  Oriented_points wedge = wedge_points(1200, generator);
  for (Vector& p : wedge.points)
    p *= 3;
  CHECK(check_formulas(wedge, tolerance, generator).planes > 0.1);
  const Occurrences on_sphere = check_formulas(sphere_points(4000, 2, generator), tolerance,
                                               generator);
  CHECK(on_sphere.planes < 0.01 && on_sphere.quadrics > 0.3 && on_sphere.in_part > 0.03);
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
  const Samples<double> result = settled(plane);
  CHECK(mean_height(result) < 0.002);
  double turned = 0;
  for (const Vector& n : result.normals)
    turned = (std::max)(turned, angle_of_lines(n, Vector::UnitZ()));
  CHECK(turned < 1);
}

/// What noise leaves of a sphere and of a saddle becomes less, and neither becomes flatter.
void check_curved(Generator& generator)
{
  const double size = 2;
  Oriented_points sphere = sphere_points(12000, size, generator);
  for (Vector& p : sphere.points)
    p *= 1 + std::normal_distribution<>(0, 0.01)(generator) / size;
  double off = 0, shrunk = 0, turned = 0;
  const Samples<double> on_sphere = settled(sphere);
  for (std::size_t i = 0; i < sphere.points.size(); ++i)
  {
    const double height = on_sphere.positions[i].norm() - size;
    off += std::abs(height) / double(sphere.points.size());
    shrunk += height / double(sphere.points.size());
    turned = (std::max)(turned,
                        angle_of_lines(on_sphere.normals[i], sphere.points[i].normalized()));
  }
  CHECK(off < 0.003);
  CHECK(std::abs(shrunk) < 0.001);
  CHECK(turned < 3);

  Oriented_points saddle = plane_points(6000, 2, generator);
  const auto height_at = [](const Vector& p) { return 0.2 * p.x() * p.y(); };
  for (std::size_t i = 0; i < saddle.points.size(); ++i)
  {
    Vector& p = saddle.points[i];
    saddle.normals[i] = Vector(-0.2 * p.y(), -0.2 * p.x(), 1).normalized();
    p.z() = height_at(p) + std::normal_distribution<>(0, 0.01)(generator);
  }
  const Samples<double> on_saddle = settled(saddle);
  double off_saddle = 0;
  for (const Vector& p : on_saddle.positions)
    off_saddle += std::abs(p.z() - height_at(p)) / double(saddle.points.size());
  CHECK(off_saddle < 0.003);
}

/// Beyond the support points a plane or a quadric goes anywhere: a sample there stays.
void check_extrapolation(Generator& generator)
{
  Oriented_points plane = plane_points(3000, 2, generator);
  std::vector<unsigned char> are_support_points;
  for (Vector& p : plane.points)
  {
    p.z() = std::normal_distribution<>(0, 0.02)(generator);
    are_support_points.push_back(p.x() > 0);
  }
  const Samples<double> result = settled(
    make_samples(plane, std::vector<double>(are_support_points.size(), deviation * deviation),
                 are_support_points));
  double highest = 0;
  for (std::size_t i = 0; i < plane.points.size(); ++i)
    if (plane.points[i].x() < -0.3)
      highest = (std::max)(highest, std::abs(result.positions[i].z() - plane.points[i].z())
                                      - std::abs(plane.points[i].z()));
  CHECK(highest < 0.02);
}

/// A quadric through points of one; of no points there is none.
void check_quadric()
{
  Quadric_moments<double> moments;
  CHECK(!moments.quadric().is_determined);
  const auto height_at = [](double u, double v) {
    return 0.25 + 0.5 * u - 0.125 * v + u * u - 2 * u * v + 0.5 * v * v;
  };
  for (double u : {-1., -0.5, 0., 0.5, 1.})
    for (double v : {-0.75, 0., 0.25, 1.})
      moments.add(u, v, height_at(u, v), 1 + u * v / 2);
  const Fitted_quadric quadric = moments.quadric();
  CHECK(quadric.is_determined);
  CHECK(std::abs(quadric.height - 0.25) < 1e-4);
  CHECK(std::abs(quadric.slope_u - 0.5) < 1e-4 && std::abs(quadric.slope_v + 0.125) < 1e-4);
  CHECK(quadric.variance < 1e-4);
}

/// Nothing moves where points are clean, nor of two points, through which there is always a plane.
void check_what_stays(Generator& generator)
{
  const Oriented_points wedge = wedge_points(1000, generator);
  CHECK(settled(wedge, 0).positions == to_buffer(wedge.points));

  for (int k = 0; k < 20; ++k)
  {
    const Oriented_points two = {{random_vector(0.1, generator), random_vector(0.1, generator)},
                                 {Vector::UnitZ(), Vector::UnitZ()}};
    CHECK(settled(two).positions == to_buffer(two.points));
  }
  std::vector<unsigned char> nobody(wedge.points.size(), 0);
  const Samples<double> unasked = make_samples(wedge, std::vector<double>(nobody.size(), 1e-4),
                                               nobody);
  CHECK(are_the_same(settled(unasked), unasked));
}

/// Detail that stands out from the noise stays; less noise, more of it.
void check_detail(Generator& generator)
{
  Oriented_points waves = plane_points(3000, 2, generator);
  for (std::size_t i = 0; i < waves.points.size(); ++i)
  {
    const double x = 8 * waves.points[i].x();
    waves.points[i].z() += 0.1 * std::sin(x);
    waves.normals[i] = Vector(-0.8 * std::cos(x), 0, 1).normalized();
  }
  CHECK(maximum_distance(settled(waves, deviation / 5).positions, to_buffer(waves.points)) < 1e-3);
  CHECK(maximum_distance(settled(waves, 20 * deviation).positions, to_buffer(waves.points)) > 0.05);
}

/// Each side of an edge keeps its plane, and the edge its place.
void check_edge(Generator& generator)
{
  Oriented_points wedge = wedge_points(3000, generator);
  const Oriented_points clean = wedge;
  for (std::size_t i = 0; i < wedge.points.size(); ++i)
    wedge.points[i] += std::normal_distribution<>(0, 0.01)(generator) * wedge.normals[i];
  const Samples<double> result = settled(wedge);
  double off_face = 0, turned = 0;
  for (std::size_t i = 0; i < clean.points.size(); ++i)
  {
    off_face += std::abs((result.positions[i] - clean.points[i]).dot(clean.normals[i]))
                / double(clean.points.size());
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
  CHECK(maximum_distance(settled(sheets).positions, to_buffer(sheets.points))
        < 0.6 * std::exp(-9) * 2);
}

/// A narrow strip has no plane across it, so that a rounding would turn its normals.
void check_strip(Generator& generator)
{
  Oriented_points strip;
  for (int i = 0; i < 400; ++i)
  {
    strip.points.push_back(random_vector(Vector(2, 1e-3, 1e-3), generator));
    strip.normals.push_back(Vector::UnitZ());
  }
  double turned = 0;
  for (const Vector& n : settled(strip).normals)
    turned = (std::max)(turned, angle_of_lines(n, Vector::UnitZ()));
  CHECK(turned < 0.5);
}

void check_threads(Generator& generator)
{
  Oriented_points wedge = wedge_points(3000, generator);
  add_gaussian_noise(wedge.points, 0.01, generator);
  const Samples<double> samples = all_support_points(wedge, deviation);
  CHECK(are_the_same(settled<CGAL::Sequential_tag>(samples),
                     settled<CGAL::Parallel_if_available_tag>(samples)));
}

/// About as many in every ball, however dense the samples are, if only there are enough; never none
/// that start on a point.
void check_choice()
{
  for (double spacing : {0.001, 0.01, 0.1, 0.3})
  {
    const double in_ball = EIGEN_PI * 16 / (spacing * spacing);
    for (double share_on_points : {1., 0.25})
    {
      const Support_subset choice(7, 1, spacing, 1000, std::size_t(1000 * share_on_points));
      const double asked = in_ball * share_on_points / double(choice.stride);
      CHECK((choice.stride == 1 && asked < 320) || (asked >= 160 && asked < 320));
      std::size_t taken = 0;
      const std::size_t count = 4000 * choice.stride;
      for (std::size_t source = 0; source < (std::min)(count, std::size_t(20000000)); ++source)
        taken += choice.takes(source);
      CHECK(std::abs(double(taken) * double(choice.stride)
                       / double((std::min)(count, std::size_t(20000000)))
                     - 1)
            < 0.1);
    }
  }
  CHECK(Support_subset(7, 1, 2, 1, 1).takes(0));
  CHECK(Support_subset(7, 1, 1e-9, 1000, 1000).stride
        == std::uint64_t(1) << 20); // a length of no samples
}

int main()
{
  Generator generator(20261122);
  check_formulas(1e-9, generator);
  check_quadric();
  check_plane(generator);
  check_curved(generator);
  check_extrapolation(generator);
  check_what_stays(generator);
  check_detail(generator);
  check_edge(generator);
  check_two_sheets(generator);
  check_strip(generator);
  check_threads(generator);
  check_choice();
  return result();
}
