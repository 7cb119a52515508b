// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "samples/sorted_samples.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/fit_disks.h>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace test;

/// Of a ball at scale 1.
const double radius = 0.4, cell_size = 0.3;

struct Input
{
  Sorted_samples samples;
  Merged_disks disks{Counting_allocator<Vector>()};
  double noise, deviation = 0.01;

  /// Disks where the samples are, of the heights that noise leaves of as many points.
  Input(const Oriented_points& cloud, bool have_even_scales, double given_noise,
        Generator& generator)
    : samples(cloud, cell_size, have_even_scales), noise(given_noise)
  {
    disks.positions = copy_of(samples.sorted.points);
    disks.normals = copy_of(samples.normals);
    disks.scales = copy_of(samples.sorted.scales);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      disks.informations.push_back(float(random_number(1, 4, generator)));
      disks.heights.push_back(
        float(std::normal_distribution<>(0, noise / std::sqrt(disks.informations[i]))(generator)));
    }
  }

  double radius_of(std::size_t i) const { return radius * samples.scale(i); }
};

struct Fits
{
  Buffer<Surface_of_disks> predictions;
  Buffer<Surfaces_of_scale> surfaces;
};

Fits fitted(const Input& input, const Buffer<Surface_of_disks>& predictions, int scale)
{
  const auto run = [&](auto tag) {
    using Tag = decltype(tag);
    Fits fits = {copy_of(predictions), Buffer<Surfaces_of_scale>(input.samples.size())};
    const Search_grid_3 grid(tag, input.disks.positions, Cell_sizes(cell_size, input.disks.scales));
    Unwatched unwatched;
    fit_disks<Tag>(
      {input.samples.sorted.grid, input.samples.sorted.points, nullptr, input.samples.normals},
      grid, input.disks.view(), cells_in_reach(radius, cell_size),
      [&](std::size_t i) { return input.radius_of(i); },
      [&](std::size_t) { return input.deviation; }, input.noise, scale, unwatched.progress,
      fits.predictions, fits.surfaces);
    return fits;
  };
  Fits fits = run(CGAL::Parallel_if_available_tag());
  const Fits sequential = run(CGAL::Sequential_tag());
  for (std::size_t i = 0; i < fits.surfaces.size(); ++i)
    CHECK(are_the_same(fits.surfaces[i].plane, sequential.surfaces[i].plane)
          && are_the_same(fits.surfaces[i].quadric, sequential.surfaces[i].quadric)
          && are_the_same(fits.predictions[i], sequential.predictions[i]));
  return fits;
}

Fits fitted(const Input& input)
{
  return fitted(input, Buffer<Surface_of_disks>(input.samples.size()), 1);
}

/// What the docstrings' formulas make of the disks around a sample.
class Naive_fit
{
  using Unknowns = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> m_products = Eigen::Matrix<double, 6, 6>::Zero(),
                              m_squared_products = m_products;
  Unknowns m_heights = Unknowns::Zero();
  std::size_t m_number = 0, m_number_for_sure = 0;
  double m_squared_noise, m_squared_radius;

public:
  Naive_fit(const Input& input, std::size_t i, const Surface_of_disks& prediction)
    : m_squared_noise(square(input.noise)), m_squared_radius(square(input.radius_of(i)))
  {
    const Tangent_frame frame(triple(input.samples.normal(i)));
    const auto vector = [](const Triple& t) { return Vector(t.x, t.y, t.z); };
    const Vector u = vector(frame.u), v = vector(frame.v), n = vector(frame.normal);
    const auto positive = [](double x) { return (std::max)(x, 0.); };
    for (std::size_t k = 0; k < input.disks.positions.size(); ++k)
    {
      const Vector d = input.disks.positions[k] - input.samples.position(i),
                   normal = input.disks.normals[k].cast<double>(),
                   foot = d + double(input.disks.heights[k]) * normal;
      const double x = u.dot(foot), y = v.dot(foot), h = n.dot(foot);
      const Surface_of_disks& s = prediction;
      const double of_surface = s.height + s.slope_u * x + s.slope_v * y + s.uu * x * x
                                + s.uv * x * y + s.vv * y * y,
                   slope_x = s.slope_u + 2 * s.uu * x + s.uv * y,
                   slope_y = s.slope_v + s.uv * x + 2 * s.vv * y;
      const Vector gradient = n - slope_x * u - slope_y * v;
      const double residual = (h - of_surface) / gradient.norm(),
                   reach = 6 * input.deviation + 0.02 * input.radius_of(i),
                   opening = 1 - std::cos(35 * EIGEN_PI / 180);
      const double root = positive(1 - d.squaredNorm() / m_squared_radius)
                          * positive(1
                                     - (1 - std::abs(normal.dot(gradient.normalized()))) / opening)
                          * positive(1 - square(residual / reach)),
                   w = root * root, of_points = w * double(input.disks.informations[k]);
      const Unknowns row = (Unknowns() << 1, x, y, x * x, x * y, y * y).finished();
      m_products += of_points * row * row.transpose();
      m_squared_products += w * of_points * row * row.transpose();
      m_heights += of_points * h * row;
      m_number += w > 0;
      m_number_for_sure += w > 1e-8;
    }
  }

  struct Surface
  {
    bool is_determined = false, is_at_limit = false;
    Unknowns unknowns = Unknowns::Zero();
    double height_variance = 0, slope_variance = 0;
  };

  /// \param n of unknowns
  Surface surface(int n) const
  {
    const std::size_t fewest = n == 3 ? 5 : 10;
    Surface result;
    result.is_at_limit = (m_number >= fewest) != (m_number_for_sure >= fewest)
                         || std::abs(m_products(0, 0) - 3) < 1e-3;
    if (m_number < fewest || m_products(0, 0) < 3)
      return result;
    const Eigen::LDLT<Eigen::MatrixXd> factors(m_products.topLeftCorner(n, n));
    const Eigen::MatrixXd inverse = factors.solve(Eigen::MatrixXd::Identity(n, n)),
                          covariance = inverse * m_squared_products.topLeftCorner(n, n) * inverse
                                       * m_squared_noise * (m_squared_radius / 8)
                                       / (m_squared_radius / 8 + m_squared_noise);
    result.unknowns.head(n) = inverse * m_heights.head(n);
    result.height_variance = covariance(0, 0);
    result.slope_variance = (covariance(1, 1) + covariance(2, 2)) / 2;
    result.is_determined = result.height_variance <= m_squared_noise;
    result.is_at_limit |= is_close(result.height_variance, m_squared_noise, 0.01);
    return result;
  }
};

/// \returns whether there is such a surface
bool check_surface(const Surface_of_disks& surface, const Naive_fit::Surface& expected,
                   double of_radius)
{
  if (expected.is_at_limit)
    return false;
  if (!CHECK(surface.is_determined() == expected.is_determined) || !expected.is_determined)
    return false;
  // where a fit is ill-conditioned, roundings are as large as its deviations
  const double deviation = std::sqrt(expected.height_variance),
               deviation_of_slope = std::sqrt(expected.slope_variance);
  const auto& c = expected.unknowns;
  CHECK(std::abs(surface.height - c[0]) < 0.01 * deviation);
  CHECK(std::abs(surface.slope_u - c[1]) < 0.01 * deviation_of_slope);
  CHECK(std::abs(surface.slope_v - c[2]) < 0.01 * deviation_of_slope);
  for (const double difference : {surface.uu - c[3], surface.uv - c[4], surface.vv - c[5]})
    CHECK(std::abs(difference) * of_radius < 0.05 * deviation_of_slope);
  CHECK(is_close(surface.height_variance, expected.height_variance, 0.01));
  CHECK(is_close(surface.slope_variance, expected.slope_variance, 0.01));
  return true;
}

/// On a wedge and around a sphere, where some samples have few disks around them; and once more
/// with the surfaces that were found, and those of chance, as predictions.
void check_formula(bool have_even_scales, Generator& generator)
{
  Oriented_points cloud = sphere_points(500, 0.7, generator);
  const Oriented_points wedge = wedge_points(400, generator);
  cloud.points.insert(cloud.points.end(), wedge.points.begin(), wedge.points.end());
  cloud.normals.insert(cloud.normals.end(), wedge.normals.begin(), wedge.normals.end());
  for (int k = 0; k < 30; ++k) // a sparse part
  {
    cloud.points.push_back(random_vector(Vector(-1, -3, 0), Vector(1, -2, 0), generator));
    cloud.normals.push_back(Vector::UnitZ());
  }
  cloud.normals = noisy_normals(cloud.normals, 0.1, generator);
  turn_some(generator, cloud.normals);
  const Input input(cloud, have_even_scales, 0.03, generator);
  Buffer<Surface_of_disks> predictions(input.samples.size());
  for (int scale = 0; scale < 3; ++scale)
  {
    const Fits fits = fitted(input, predictions, scale);
    std::size_t number_of_planes = 0, number_of_quadrics = 0, number_of_none = 0;
    for (std::size_t i = 0; i < input.samples.size(); ++i)
    {
      const Naive_fit naive(input, i, predictions[i]);
      const Surfaces_of_scale& s = fits.surfaces[i];
      number_of_planes += check_surface(s.plane, naive.surface(3), input.radius_of(i));
      number_of_quadrics += check_surface(s.quadric, naive.surface(6), input.radius_of(i));
      number_of_none += !s.plane.is_determined();
      const bool takes_quadric = scale > 0 && s.quadric.is_determined();
      CHECK(are_the_same(fits.predictions[i], takes_quadric             ? s.quadric
                                              : s.plane.is_determined() ? s.plane
                                                                        : predictions[i]));
    }
    CHECK(number_of_planes > 700 && number_of_quadrics > 500 && number_of_none > 0);
    predictions = copy_of(fits.predictions);
    if (scale == 1) // any others
      for (Surface_of_disks& s : predictions)
      {
        s.height += float(random_number(-0.02, 0.02, generator));
        s.slope_u += float(random_number(-0.2, 0.2, generator));
        s.uu = float(random_number(-0.5, 0.5, generator));
        s.uv = float(random_number(-0.5, 0.5, generator));
      }
  }
}

/// Samples in another order than that of their grid.
void check_order(Generator& generator)
{
  const Input input(sphere_points(600, 0.7, generator), true, 0.03, generator);
  const Fits expected = fitted(input);
  const std::size_t m = input.samples.size();
  Buffer<Local_vector> normals(m);
  Buffer<Index> order(m);
  for (std::size_t q = 0; q < m; ++q)
  {
    order[q] = Index(m - 1 - q);
    normals[order[q]] = input.samples.normals[q];
  }
  Fits fits = {Buffer<Surface_of_disks>(m), Buffer<Surfaces_of_scale>(m)};
  Unwatched unwatched;
  fit_disks<CGAL::Parallel_if_available_tag>(
    {input.samples.sorted.grid, input.samples.sorted.points, order.data(), normals},
    input.samples.sorted.grid, input.disks.view(), cells_in_reach(radius, cell_size),
    [&](std::size_t) { return radius; }, [&](std::size_t) { return input.deviation; }, input.noise,
    1, unwatched.progress, fits.predictions, fits.surfaces);
  for (std::size_t q = 0; q < m; ++q)
    CHECK(are_the_same(fits.surfaces[order[q]].quadric, expected.surfaces[q].quadric)
          && are_the_same(fits.predictions[order[q]], expected.predictions[q]));
}

/// Noisy disks of a plane have planes and quadrics of it, up to what the surfaces say of their own
/// variances; and less noise than the disks.
void check_plane(Generator& generator)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector(1, 2, 3).normalized()).toRotationMatrix();
  Oriented_points plane = even_samples(0.05, generator);
  for (Vector& p : plane.points)
    p = turn * p;
  for (Vector& n : plane.normals)
    n = turn * n;
  const Input input(plane, true, 0.02, generator);
  const Fits fits = fitted(input);
  double worst = 0, squares = 0, bend = 0;
  for (const Surfaces_of_scale& s : fits.surfaces)
    for (const Surface_of_disks& surface : {s.plane, s.quadric})
    {
      CHECK(surface.is_determined());
      const double of_height = std::abs(double(surface.height))
                               / std::sqrt(double(surface.height_variance)),
                   of_slope = std::abs(double(surface.slope_u))
                              / std::sqrt(double(surface.slope_variance));
      worst = (std::max)({worst, of_height, of_slope});
      squares += square(surface.height) / double(2 * fits.surfaces.size());
      bend = (std::max)(bend, std::abs(double(surface.uu)));
    }
  CHECK(worst < 5);
  CHECK(std::sqrt(squares) < input.noise / 4);
  CHECK(bend < 1); // 0.16 of height at the end of the ball, at the ends of the plane
}

/// The variances that fits tell are those of fits to other noise of the same surface.
void check_variances(Generator& generator)
{
  struct Sums
  {
    double squared_heights = 0, squared_slopes = 0, height_variance = 0, slope_variance = 0;

    void add(const Surface_of_disks& s)
    {
      squared_heights += square(s.height);
      squared_slopes += (square(s.slope_u) + square(s.slope_v)) / 2;
      height_variance += double(s.height_variance);
      slope_variance += double(s.slope_variance);
    }
  };
  const Oriented_points plane = even_samples(0.1, generator);
  for (const double noise : {0.01, 0.03})
  {
    Sums of_planes, of_quadrics;
    for (int seed = 0; seed < 200; ++seed)
    {
      Generator own(std::uint64_t(seed) + 1);
      Input input(plane, true, noise, own);
      input.deviation = noise;
      const Fits fits = fitted(input);
      // far from each other, and from the ends of the plane
      for (std::size_t i = 0; i < input.samples.size(); ++i)
        for (const Vector& place : {Vector(-0.5, -0.5, 0), Vector(0.5, 0.5, 0),
                                    Vector(-0.5, 0.5, 0), Vector(0.5, -0.5, 0)})
          if ((input.samples.position(i) - place).lpNorm<Eigen::Infinity>() < 0.05)
          {
            of_planes.add(fits.surfaces[i].plane);
            of_quadrics.add(fits.surfaces[i].quadric);
          }
    }
    for (const Sums& sums : {of_planes, of_quadrics})
    {
      CHECK(sums.height_variance > 0);
      CHECK(is_close(sums.squared_heights, sums.height_variance, 0.2));
      CHECK(is_close(sums.squared_slopes, sums.slope_variance, 0.2));
    }
  }
}

/// Across an edge of a right angle disks do not count, nor do those of the other sheet of a plate.
void check_other_faces(Generator& generator)
{
  const auto without_noise = [&](const Oriented_points& cloud) {
    Input input(cloud, true, 0.01, generator);
    std::fill(input.disks.heights.begin(), input.disks.heights.end(), 0.f);
    return fitted(input);
  };
  double off = 0;
  for (const Surfaces_of_scale& s : without_noise(wedge_points(1500, generator)).surfaces)
    for (const Surface_of_disks& surface : {s.plane, s.quadric})
      off = (std::max)({off, std::abs(double(surface.height)), std::abs(double(surface.slope_u)),
                        std::abs(double(surface.slope_v))});
  CHECK(off < 1e-4);
  Oriented_points plate = even_samples(0.05, generator);
  for (std::size_t i = 0; i < plate.points.size(); i += 2)
  {
    plate.points[i].z() = -0.08;
    plate.normals[i] = -Vector::UnitZ();
  }
  off = 0;
  for (const Surfaces_of_scale& s : without_noise(plate).surfaces)
    off = (std::max)({off, std::abs(double(s.plane.height)), std::abs(double(s.quadric.height))});
  CHECK(off < 1e-4);
}

/// Of fewer than five disks there is no surface, and the prediction stays.
void check_few(Generator& generator)
{
  CHECK(fitted(Input({}, true, 0.01, generator)).surfaces.empty());
  Oriented_points four;
  for (int k = 0; k < 4; ++k)
  {
    four.points.push_back(0.1 * Vector(k % 2, k / 2, 0));
    four.normals.push_back(Vector::UnitZ());
    const Input input(four, true, 0.01, generator);
    Buffer<Surface_of_disks> predictions(four.points.size());
    for (Surface_of_disks& s : predictions)
      s.slope_u = 0.125f;
    const Fits fits = fitted(input, predictions, 1);
    for (std::size_t i = 0; i < four.points.size(); ++i)
      CHECK(!fits.surfaces[i].plane.is_determined() && !fits.surfaces[i].quadric.is_determined()
            && are_the_same(fits.predictions[i], predictions[i]));
  }
  Input without_disks(four, true, 0.01, generator);
  without_disks.disks = Merged_disks(Counting_allocator<Vector>());
  for (const Surfaces_of_scale& s : fitted(without_disks).surfaces)
    CHECK(!s.plane.is_determined() && !s.quadric.is_determined());
}

int main()
{
  Generator generator(20261128);
  for (const bool have_even_scales : {true, false})
    check_formula(have_even_scales, generator);
  check_order(generator);
  check_plane(generator);
  check_variances(generator);
  check_other_faces(generator);
  check_few(generator);
  return result();
}
