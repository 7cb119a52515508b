// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"

#include <CGAL/L0_resampling/internal/samples/fit_compatible_points.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>

using namespace test;

const double radius = 0.4, bandwidth = 0.6 * radius, squared_sheet_height = 0.08 * 0.08;

/// What the stage makes of each sample.
struct Fitted
{
  std::vector<Vector> normals, centroids, outward;
  std::vector<double> weights, variances;
  std::size_t number_of_scattered =
    0; ///< samples with a sheet that is lower, but not by as much as it may
};

/// The stage, for input and samples in any order.
template <typename T>
Fitted fit(const Oriented_points& input, const std::vector<double>& densities,
           const Oriented_points& start, const std::vector<Vector>& last_centroids)
{
  const Gridded_points sorted(input.points, radius / 2);
  const auto normals = to_local_vectors<T>(permuted(sorted.order, input.normals));
  Buffer<T> density_weights;
  for (Index j : sorted.order)
    density_weights.push_back(T(densities[j]));

  Samples<double> samples{Counting_allocator<Vector>()};
  samples.positions = to_buffer(start.points);
  samples.normals = to_buffer(start.normals);
  samples.fit_weights.resize(start.points.size());
  samples.fit_variances.resize(start.points.size());
  samples.fit_centroids = to_buffer(last_centroids);
  samples.outward_directions.resize(start.points.size());
  Unwatched unwatched;
  fit_compatible_points<CGAL::Parallel_if_available_tag>(
    Fit_input<T>{sorted.grid,
                 sorted.points,
                 normals,
                 density_weights,
                 {radius, bandwidth * bandwidth, naive_normal_bandwidth(25), squared_sheet_height}},
    unwatched.progress, samples);
  CHECK(samples.positions == to_buffer(start.points));
  const auto vector = [](const Buffer<Vector>& b) {
    return std::vector<Vector>(b.begin(), b.end());
  };
  return {vector(samples.normals),
          vector(samples.fit_centroids),
          vector(samples.outward_directions),
          {samples.fit_weights.begin(), samples.fit_weights.end()},
          {samples.fit_variances.begin(), samples.fit_variances.end()},
          0};
}

template <typename T>
Fitted fit(const Oriented_points& input, const Oriented_points& start)
{
  return fit<T>(input, std::vector<double>(input.points.size(), 1), start, start.points);
}

/// The mean of `f(r)` over a disk, by quadrature.
template <typename F>
double mean_over_disk(const F& f)
{
  double sum = 0, total = 0;
  const int steps = 100000;
  for (int k = 0; k < steps; ++k)
  {
    const double r = (k + 0.5) / steps * radius,
                 weight = r * std::exp(-r * r / (bandwidth * bandwidth));
    sum += f(r) * weight;
    total += weight;
  }
  return sum / total;
}

/// How far from its straight side the mean of half a disk lies.
double half_disk_distance()
{
  static const double distance = mean_over_disk([](double r) { return 2 / EIGEN_PI * r; });
  return distance;
}

/// Of the points of half a disk, across that side.
double half_disk_variance()
{
  static const double second_moment = mean_over_disk([](double r) { return r * r / 2; });
  return second_moment - half_disk_distance() * half_disk_distance();
}

/// The distance in standard deviations.
double half_disk_offset() { return half_disk_distance() / std::sqrt(half_disk_variance()); }

/// What is added to the variance of some points: that of the mean of as many on a border.
double added_variance(double total, double squared_weights)
{
  return half_disk_variance() * squared_weights / (total * total);
}

/// Of a push outwards.
/// \param deviations that the mean of the points is away
double naive_share_held_back(double deviations)
{
  return clamped((deviations / half_disk_offset() - 0.15) / 0.35);
}

/// The sums of the docstring for a sample.
struct Naive_sums
{
  double all = 0, total = 0, squared_weights = 0, height = 0, squared_heights = 0;
  Vector mean = Vector::Zero(), normal = Vector::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero(), normals = Eigen::Matrix3d::Zero();
};

Naive_sums sum_naively(const Oriented_points& input, const std::vector<double>& densities,
                       const std::vector<Index>& neighbors, const Vector& p, const Vector& n,
                       double squared_height)
{
  Naive_sums sums;
  for (Index j : neighbors)
  {
    const Vector d = input.points[j] - p;
    const double cosine = n.dot(input.normals[j]);
    const Vector turned = (cosine < 0 ? -1 : 1) * input.normals[j];
    const double h = 0.5 * (n + turned).dot(d);
    const double share = clamped((1 - d.squaredNorm() / (radius * radius)) / 0.1) / densities[j];
    const double near = share * std::exp(-d.squaredNorm() / (bandwidth * bandwidth));
    const double w = near
                     * std::exp(-std::pow(1 - std::abs(cosine), 2) / naive_normal_bandwidth(25))
                     * std::exp(-h * h / squared_height);
    sums.all += share;
    sums.total += w;
    sums.squared_weights += w * w;
    sums.squared_heights += w * h * h;
    sums.height += w * h;
    sums.mean += w * d;
    sums.products += w * d * d.transpose();
    sums.normal += w * turned;
    sums.normals += near * turned * turned.transpose();
  }
  return sums;
}

/// The formulas of the docstring, sample by sample.
Fitted fit_naively(const Oriented_points& input, const std::vector<double>& densities,
                   const Oriented_points& start)
{
  Fitted result{start.normals, start.points, {}, {}, {}, 0};
  const auto neighbors = brute_force_neighbors(start.points, input.points, radius);
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    Vector n = start.normals[i];
    Naive_sums sums = sum_naively(input, densities, neighbors[i], start.points[i], n,
                                  squared_sheet_height);
    const double unsupported = sums.all > 0 ? clamped((0.08 - sums.total / sums.all) / 0.04) : 0;
    if (unsupported > 0)
    {
      sums.normals += (1 / unsupported - 1) * sums.all * n * n.transpose();
      n = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sums.normals).eigenvectors().col(2);
      n *= n.dot(start.normals[i]) < 0 ? -1 : 1;
      const double squared_height = std::pow(squared_sheet_height, 1 - unsupported)
                                    * std::pow(radius, 2 * unsupported);
      sums = sum_naively(input, densities, neighbors[i], start.points[i], n, squared_height);
    }
    else if (sums.total > 0)
    {
      const double mean = sums.height / sums.total,
                   variance = sums.squared_heights / sums.total - mean * mean;
      const double scattered = clamped((variance / squared_sheet_height - 1. / 6)
                                       / (1. / 5 - 1. / 6));
      result.number_of_scattered += scattered > 0 && scattered < 1;
      sums = sum_naively(input, densities, neighbors[i], start.points[i], n,
                         squared_sheet_height * (1 - scattered * (1 - 0.7 * 0.7)));
    }
    result.weights.push_back(sums.total > 1e-3 ? sums.total : 1);
    const double mean_height = sums.height / sums.total;
    result.variances.push_back(sums.total > 1e-3
                                 ? (sums.squared_heights / sums.total - mean_height * mean_height)
                                     * sums.squared_weights / (sums.total * sums.total)
                                 : 0);
    result.outward.push_back(Vector::Zero());
    if (sums.total <= 1e-3)
      continue;
    result.normals[i] = sums.normal.normalized();
    const Vector mean = sums.mean / sums.total, offset = mean - n.dot(mean) * n;
    const Eigen::Matrix3d tangential = Eigen::Matrix3d::Identity() - n * n.transpose(),
                          covariance = sums.products / sums.total - mean * mean.transpose();
    const Vector whitened = (tangential * covariance * tangential
                             + added_variance(sums.total, sums.squared_weights)
                                 * Eigen::Matrix3d::Identity())
                              .inverse()
                            * offset;
    const double deviations = std::sqrt(whitened.dot(offset));
    const Vector inwards = whitened.normalized();
    result.centroids[i] += sums.height / sums.total * n
                           + inwards.dot(offset)
                               * (std::max)(1 - half_disk_offset() / deviations, 0.) * inwards;
    result.outward[i] = -std::sqrt(naive_share_held_back(deviations)) * inwards;
  }
  return result;
}

template <typename T>
void check_formulas(double tolerance, Generator& generator)
{
  Oriented_points input = wedge_points(1500, generator);
  add_gaussian_noise(input.points, 0.02, generator);
  for (Vector& p : input.points)
    if (p.x() < 0.5)
      p.z() += random_number(-0.1, 0.1, generator);
  input.normals = noisy_normals(input.normals, 0.2, generator);
  std::vector<double> densities;
  for (Vector& n : input.normals)
  {
    n *= std::bernoulli_distribution()(generator) ? 1 : -1;
    densities.push_back(random_number(1, 3, generator));
  }
  Oriented_points start{std::vector<Vector>(input.points.begin(), input.points.begin() + 300),
                        std::vector<Vector>(input.normals.begin(), input.normals.begin() + 300)};
  for (std::size_t i = 0; i < 20; ++i) // is unsupported
    start.normals[i] = start.normals[i].unitOrthogonal();
  start.points.push_back(Vector(9, 9, 9)); // sees nobody
  start.normals.push_back(Vector::UnitX());

  std::vector<Vector> last_centroids = start.points;
  last_centroids.back() = Vector(1, 2, 3);
  const Fitted fitted = fit<T>(input, densities, start, last_centroids);
  Fitted naive = fit_naively(input, densities, start);
  naive.centroids.back() = last_centroids.back();
  double worst = 0;
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    worst = (std::max)(worst, std::abs(fitted.weights[i] / naive.weights[i] - 1));
    worst = (std::max)(worst, std::abs(fitted.variances[i] - naive.variances[i]));
    // Outward directions begin as a square root, and a push takes them twice.
    worst = (std::max)(
      {worst, (fitted.centroids[i] - naive.centroids[i]).norm(),
       Eigen::MatrixXd(fitted.normals[i] * fitted.normals[i].transpose()
                       - naive.normals[i] * naive.normals[i].transpose())
         .norm(),
       (fitted.outward[i].norm() * fitted.outward[i] - naive.outward[i].norm() * naive.outward[i])
         .norm()});
  }
  CHECK(worst < tolerance);
  CHECK(naive.number_of_scattered > 10);
  // who sees nobody is drawn to where it was last fitted
  CHECK(fitted.centroids.back() == last_centroids.back()
        && fitted.normals.back() == start.normals.back());
}

/// A sample with the normal of nobody around takes that of the face; one with that of a few points,
/// those of a rim, keeps it. One that is as far off the face as another sheet finds it.
void check_unsupported_samples(Generator& generator)
{
  Oriented_points input;
  for (int i = 0; i < 4000; ++i)
  {
    input.points.push_back(random_vector(Vector(1, 1, 0), generator));
    input.normals.push_back(Vector::UnitZ());
  }
  const Vector rim = Vector(0.5, 0.5, 0);
  for (int i = 0; i < 60; ++i)
  {
    input.points.push_back(rim + random_vector(Vector(0, 0.2, 0.05), generator));
    input.normals.push_back(Vector::UnitX());
  }
  Oriented_points start;
  start.points = {Vector(-0.4, 0.1, 0.05), Vector(-0.4, 0.1, 0.05), rim,
                  Vector(-0.4, 0.1, 0.9 * radius)};
  start.normals = {Vector(0.6, -0.8, 0), Vector(0.6, 0, -0.8), Vector::UnitX(), Vector::UnitZ()};
  const Fitted fitted = fit<float>(input, start);
  CHECK(angle_of_lines(fitted.normals[0], Vector::UnitZ()) < 1e-3);
  CHECK(std::abs(fitted.centroids[0][2]) < 1e-5);
  CHECK(angle_of_lines(fitted.normals[1], Vector::UnitZ()) < 1e-3);
  CHECK(angle_of_lines(fitted.normals[2], Vector::UnitX()) < 1e-3);
  CHECK(std::abs(fitted.centroids[3][2]) < 1e-5);
}

/// A sample becomes unsupported by and by: turned a little further, it is drawn a little further.
void check_no_step(Generator& generator)
{
  const Oriented_points plane = plane_points(4000, 2, generator);
  const int steps = 4000;
  Oriented_points start;
  for (int k = 0; k < steps; ++k)
  {
    const double angle = EIGEN_PI / 2 * k / steps;
    start.points.emplace_back(0.1, 0.2, 0.05);
    start.normals.emplace_back(std::sin(angle), 0, std::cos(angle));
  }
  const Fitted fitted = fit<double>(plane, start);
  double largest_step = 0;
  for (int k = 1; k < steps; ++k)
    largest_step = (std::max)(largest_step, (fitted.centroids[k] - fitted.centroids[k - 1]).norm());
  CHECK(largest_step < 0.001);
  CHECK(std::abs(fitted.centroids[steps - 1][2]) < 1e-6); // is unsupported
}

/// Two points of a sphere are at distance 0 in the symmetric sense: a sphere does not shrink.
void check_sphere(Generator& generator)
{
  const Oriented_points sphere = sphere_points(4000, 1, generator),
                        start = sphere_points(100, 1, generator);
  const Fitted fitted = fit<float>(sphere, start);
  double worst = 0;
  for (std::size_t i = 0; i < start.points.size(); ++i)
    worst = (std::max)(worst,
                       std::abs(start.normals[i].dot(fitted.centroids[i] - start.points[i])));
  CHECK(worst < 1e-6);
}

/// Beside an edge, a sample off its face is drawn back onto it and not towards the other face.
void check_edge(Generator& generator)
{
  const Oriented_points wedge = wedge_points(3000, generator);
  Oriented_points start = wedge_points(200, generator);
  for (std::size_t i = 0; i < start.points.size(); ++i)
    start.points[i] += random_number(-0.05, 0.05, generator) * start.normals[i];
  const Fitted fitted = fit<float>(wedge, start);
  double off_face = 0, turned = 0;
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    off_face = (std::max)(off_face, std::abs(fitted.centroids[i].dot(start.normals[i])));
    turned = (std::max)(turned, angle_of_lines(fitted.normals[i], start.normals[i]));
  }
  CHECK(off_face < 1e-5);
  CHECK(turned < 0.01);
}

/// On the border of half a plane a sample stays, and further in too; from further out it comes back
/// to there. It knows where the border is, less and less of it further in.
void check_border()
{
  Oriented_points half_plane;
  for (const Vector& p : lattice_points(81, 1))
    if (p[2] == 0)
    {
      half_plane.points.push_back(0.02 * (p - Vector(-0.5, 40, 0)));
      half_plane.normals.push_back(Vector::UnitZ());
    }
  const std::vector<double> places{0, 0.05, 0.12, 0.25, 0.8, -0.02, -0.05};
  Oriented_points start;
  for (double x : places)
  {
    start.points.emplace_back(x, 0, 0);
    start.normals.push_back(Vector::UnitZ());
  }
  const Fitted fitted = fit<float>(half_plane, start);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double expected = (std::max)(places[i], 0.);
    CHECK(std::abs(fitted.centroids[i][0] - expected)
          < 0.01 * radius + 0.15 * (expected - places[i]));
    CHECK(std::abs(fitted.centroids[i][1]) < 1e-6);
    Vector sum = Vector::Zero();
    double total = 0, squares = 0, squared_weights = 0;
    for (const Vector& p : half_plane.points)
    {
      const Vector d = p - start.points[i];
      const double weight = clamped((1 - d.squaredNorm() / (radius * radius)) / 0.1)
                            * std::exp(-d.squaredNorm() / (bandwidth * bandwidth));
      sum += weight * d;
      squares += weight * d.x() * d.x();
      total += weight;
      squared_weights += weight * weight;
    }
    const double distance = sum.norm() / total,
                 variance = squares / total - distance * distance
                            + added_variance(total, squared_weights),
                 held_back = naive_share_held_back(distance / std::sqrt(variance));
    CHECK(places[i] == 0.12 ? held_back > 0.1 && held_back < 0.9 : held_back == (places[i] < 0.1));
    CHECK((fitted.outward[i] - Vector(-std::sqrt(held_back), 0, 0)).norm() < 1e-5);
  }
}

/// A strip that is narrower than the ball ends where its points do, and so does a line, the more so
/// the more points it has.
void check_strips(Generator& generator)
{
  for (const double half_width : {0., 0.04, 0.1})
  {
    Oriented_points strip, start;
    for (int k = 0; k < 6000; ++k)
    {
      strip.points.push_back(random_vector(Vector(4, half_width, 0), generator));
      strip.normals.push_back(Vector::UnitZ());
    }
    const double width_of_line = half_disk_offset() * std::sqrt(half_disk_variance() / 200),
                 wide = 0.3;
    for (int k = 0; k <= 40; ++k)
    {
      start.points.emplace_back(random_number(-2, 2, generator), wide * (k / 20. - 1), 0);
      start.normals.push_back(Vector::UnitZ());
    }
    const Fitted fitted = fit<float>(strip, start);
    for (std::size_t i = 0; i < start.points.size(); ++i)
    {
      const double y = start.points[i].y(), fitted_y = fitted.centroids[i].y();
      CHECK(std::abs(fitted_y) < half_width + 1.2 * width_of_line);
      if (std::abs(y) < 0.5 * half_width)
        CHECK(fitted_y == y);
      if (std::abs(y) > 0.9 * half_width + width_of_line + 0.4 * half_disk_distance())
        CHECK(fitted.outward[i].y() * y > 0.9 * std::abs(y));
    }
  }
}

/// A single point does not draw all samples to its own place.
void check_lone_point()
{
  const Oriented_points lone{{Vector::Zero()}, {Vector::UnitZ()}};
  Oriented_points start;
  for (const double x : {0.01, 0.05, 0.1, 0.2, 0.3})
  {
    start.points.emplace_back(x, 0, 0);
    start.normals.push_back(Vector::UnitZ());
  }
  const Fitted fitted = fit<float>(lone, start);
  const double nearest = half_disk_distance();
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    const Vector expected = (std::min)(start.points[i].x(), nearest) * Vector::UnitX();
    CHECK((fitted.centroids[i] - expected).norm() < 1e-5);
  }
}

/// Holes hold samples back as borders do. Where points are dense, it is no border that their mean
/// lies off by chance.
void check_holes(Generator& generator)
{
  const double side = 8, inside = 6, points_per_ball = 160;
  const Oriented_points face = plane_points(
    std::size_t(points_per_ball / (EIGEN_PI * radius * radius) * side * side), side, generator);
  Oriented_points with_holes;
  for (const Vector& p : face.points)
    if ((Vector(p.x() - std::round(p.x()), p.y() - std::round(p.y()), 0)).norm() > 0.75 * radius)
    {
      with_holes.points.push_back(p);
      with_holes.normals.push_back(Vector::UnitZ());
    }
  const Oriented_points start = plane_points(2000, inside, generator);
  const auto mean_share_held_back = [&](const Oriented_points& points) {
    double sum = 0;
    for (const Vector& outward : fit<float>(points, start).outward)
      sum += outward.squaredNorm() / double(start.points.size());
    return sum;
  };
  CHECK(mean_share_held_back(face) < 0.05);
  CHECK(mean_share_held_back(with_holes) > 0.3);
}

/// On a plate thinner than the radius, a sample is drawn to its own sheet and the other one does
/// not move it.
void check_plate(Generator& generator)
{
  Oriented_points plate = plane_points(2000, 2, generator);
  const std::size_t n = plate.points.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    plate.points.push_back(plate.points[i] - Vector(0, 0, 0.25));
    plate.normals.push_back(-plate.normals[i]);
  }
  Oriented_points start = plane_points(100, 1, generator);
  for (Vector& p : start.points)
    p[2] = random_number(-0.02, 0.02, generator);
  const Fitted fitted = fit<float>(plate, start);
  double worst = 0;
  for (const Vector& c : fitted.centroids)
    worst = (std::max)(worst, std::abs(c[2]));
  CHECK(worst < 0.001);
}

/// Where two sheets are so near that each weighs much in the other, their points scatter more than
/// those of one, and the sheets draw each other less.
void check_close_sheets(Generator& generator)
{
  Oriented_points sheets = plane_points(6000, 2, generator);
  const double distance = 0.09;
  for (std::size_t i = 0; i < sheets.points.size(); ++i)
    sheets.points[i].z() = (i % 2 ? distance : 0) + std::normal_distribution<>(0, 0.02)(generator);
  Oriented_points start = plane_points(100, 1, generator);
  const Fitted fitted = fit<float>(sheets, start);
  const auto neighbors = brute_force_neighbors(start.points, sheets.points, radius);
  double drawn = 0, drawn_by_all = 0;
  for (std::size_t i = 0; i < start.points.size(); ++i)
  {
    const Naive_sums all = sum_naively(sheets, std::vector<double>(sheets.points.size(), 1),
                                       neighbors[i], start.points[i], Vector::UnitZ(),
                                       squared_sheet_height);
    drawn += fitted.centroids[i].z();
    drawn_by_all += all.height / all.total;
  }
  CHECK(drawn_by_all > 0.01 * double(start.points.size()));
  CHECK(drawn < 0.5 * drawn_by_all);
}

int main()
{
  Generator generator(15);
  check_formulas<double>(1e-10, generator);
  check_formulas<float>(1e-4, generator);
  check_unsupported_samples(generator);
  check_no_step(generator);
  check_sphere(generator);
  check_edge(generator);
  check_border();
  check_strips(generator);
  check_lone_point();
  check_holes(generator);
  check_plate(generator);
  check_close_sheets(generator);
  return result();
}
