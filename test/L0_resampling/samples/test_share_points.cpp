// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "samples/sorted_samples.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/kernels/cells_of_refinement.h>
#include <CGAL/L0_resampling/internal/samples/share_points.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace test;

/// Of scale 1: the noise of the points, the unit of the refinement, and the spacing of the samples.
const double noise = 0.03, unit = 0.1, spacing = 0.1, cell_size = 0.15;

double naive_squared_extent(double scale)
{
  return noise * noise + unit * scale * unit * scale / 4;
}

/// Whether a disk ends at the point but for roundings, so that these decide.
bool is_at_end(const Sorted_samples& samples, const Vector& point)
{
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double squared_reach = 9 * naive_squared_extent(samples.scale(i));
    if (std::abs((point - samples.position(i)).squaredNorm() / squared_reach - 1) < 1e-4)
      return true;
  }
  return false;
}

bool are_the_same(const Disk& a, const Disk& b)
{
  return a.weight == b.weight && a.height == b.height && a.squared_height == b.squared_height
         && a.variance == b.variance;
}

Buffer<Disk> shared(const Sorted_samples& samples, const std::vector<Vector>& points)
{
  const bool is_even = samples.scales_before.empty();
  const Sorted_samples sorted_points({points, std::vector<Vector>(points.size(), Vector::UnitZ())},
                                     cell_size, is_even);
  Buffer<Disk_kernel<Local>> kernels;
  for (std::size_t i = 0; i < samples.size(); ++i)
    kernels.push_back(disk_kernel(unit * samples.scale(i), noise, spacing));
  const int reach = cells_in_reach(3 * std::sqrt(naive_squared_extent(1)), cell_size);
  const Sample_disks disks = {samples.sorted.grid, samples.sorted.points, samples.normals, kernels};
  Unwatched unwatched;
  const Buffer<Disk> result = share_points<CGAL::Parallel_if_available_tag>(
                       sorted_points.sorted.grid, sorted_points.sorted.points, disks, reach,
                       unwatched.progress),
                     sequential = share_points<CGAL::Sequential_tag>(sorted_points.sorted.grid,
                                                                     sorted_points.sorted.points,
                                                                     disks, reach,
                                                                     unwatched.progress);
  CHECK(result.size() == samples.size());
  CHECK(std::equal(result.begin(), result.end(), sequential.begin(), sequential.end(),
                   [](const Disk& a, const Disk& b) { return are_the_same(a, b); }));
  return result;
}

/// The shares of a point, one a sample.
std::vector<double> naive_shares(const Sorted_samples& samples, const Vector& point)
{
  std::vector<double> shares;
  double sum = 0.01; // of outliers
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Vector d = point - samples.position(i);
    const double squared_extent = naive_squared_extent(samples.scale(i)),
                 h = d.dot(samples.normal(i)), squared_l = d.squaredNorm() - h * h;
    shares.push_back(
      d.squaredNorm() < 9 * squared_extent
        ? spacing * spacing / (2 * EIGEN_PI * squared_extent)
            * std::exp(-h * h / (2 * noise * noise) - squared_l / (2 * squared_extent))
        : 0);
    sum += shares.back();
  }
  for (double& share : shares)
    share /= sum;
  return shares;
}

/// Noisy points about samples that are not quite on the surface and not quite along it, with
/// outliers, and samples that nothing is near to.
void check_formula(bool have_even_scales, Generator& generator)
{
  Oriented_points cloud = even_samples(spacing, generator);
  for (const Vector& p : wedge_points(60, generator).points)
    cloud.points.push_back(p - Vector(0.5, 0.5, 0.1)), cloud.normals.push_back(Vector::UnitY());
  add_gaussian_noise(cloud.points, noise / 3, generator);
  cloud.normals = noisy_normals(cloud.normals, 0.1, generator);
  cloud.points.emplace_back(-1, 0, 1);
  cloud.normals.push_back(Vector::UnitX());
  const Sorted_samples samples(cloud, cell_size, have_even_scales);
  std::vector<Vector> points;
  for (const Vector& p : plane_points(1500, 2, generator).points)
    points.push_back(p + std::normal_distribution<>(0, noise)(generator) * Vector::UnitZ());
  for (int k = 0; k < 100; ++k)
    points.push_back(random_unit_vector(generator));
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const Vector& p) { return is_at_end(samples, p); }),
               points.end());
  CHECK(points.size() > 1400);

  std::vector<double> weights(samples.size()), heights = weights, squared_heights = weights,
                                               squares = weights;
  for (const Vector& p : points)
  {
    const std::vector<double> shares = naive_shares(samples, p);
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const double h = (p - samples.position(i)).dot(samples.normal(i));
      weights[i] += shares[i];
      squares[i] += shares[i] * shares[i];
      heights[i] += shares[i] * h;
      squared_heights[i] += shares[i] * h * h;
    }
  }
  const Buffer<Disk> disks = shared(samples, points);
  std::size_t number_of_empty = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Disk& disk = disks[i];
    if (weights[i] < 1e-4)
    {
      CHECK(disk.weight < 1e-4f);
      ++number_of_empty;
      continue;
    }
    const double w = weights[i], tolerance = 1e-4;
    CHECK(is_close(disk.weight, w, tolerance));
    CHECK(std::abs(disk.height - heights[i] / w) < tolerance * noise);
    CHECK(is_close(disk.squared_height, squared_heights[i] / w, 10 * tolerance));
    CHECK(is_close(disk.variance, squares[i] / (w * w), 10 * tolerance));
  }
  CHECK(number_of_empty > 0 && number_of_empty < samples.size() / 4);
}

/// A point is shared once: its shares sum up to 1 but for what outliers have, on a whole surface
/// to nearly 1, and for a point that is far off it to nearly 0.
void check_one_point(bool have_even_scales, Generator& generator)
{
  const Sorted_samples samples(even_samples(spacing, generator), cell_size, have_even_scales);
  const auto sum_of_shares = [&](const Vector& point) {
    double sum = 0;
    for (const Disk& disk : shared(samples, {point}))
      sum += double(disk.weight);
    return sum;
  };
  double largest = 0, least = 2;
  for (int k = 0; k < 40; ++k)
  {
    const Vector p(random_number(-0.5, 0.5, generator), random_number(-0.5, 0.5, generator),
                   random_number(-noise, noise, generator));
    const double sum = sum_of_shares(p);
    largest = (std::max)(largest, sum);
    least = (std::min)(least, sum);
  }
  CHECK(largest < 1 + 1e-5);
  CHECK(least > 0.96);
  CHECK(sum_of_shares({0.1, 0.1, 5 * noise}) < 0.01);
}

/// Over a surface that lies a little beside the samples, disks have its height, and the scatter of
/// the points.
void check_heights(Generator& generator)
{
  const Sorted_samples samples(even_samples(spacing, generator), cell_size, true);
  const double offset = 0.4 * noise;
  std::vector<Vector> points;
  for (const Vector& p : plane_points(40000, 2, generator).points)
    points.push_back(p + std::normal_distribution<>(offset, noise)(generator) * Vector::UnitZ());
  double height = 0, squared_height = 0, weight = 0;
  for (const Disk& disk : shared(samples, points))
  {
    height += double(disk.weight * disk.height);
    squared_height += double(disk.weight * disk.squared_height);
    weight += double(disk.weight);
  }
  CHECK(is_close(height / weight, offset, 0.1));
  CHECK(is_close(squared_height / weight, noise * noise + offset * offset, 0.1));
}

/// Of no samples there are no disks, and without points a disk knows nothing.
void check_few()
{
  CHECK(shared(Sorted_samples({}, cell_size, true), {Vector::Zero()}).empty());
  CHECK(shared(Sorted_samples({}, cell_size, true), {}).empty());
  const Sorted_samples one({{Vector::Zero()}, {Vector::UnitZ()}}, cell_size, true);
  CHECK(are_the_same(shared(one, {})[0], Disk()));
  CHECK(are_the_same(shared(one, {Vector(5, 0, 0)})[0], Disk()));
  const Disk disk = shared(one, {Vector(0, 0, noise / 2)})[0];
  CHECK(is_close(disk.weight, naive_shares(one, Vector(0, 0, noise / 2))[0], 1e-5));
  CHECK(is_close(disk.height, noise / 2, 1e-5) && is_close(disk.variance, 1, 1e-5));
}

/// Balls reach few cells, however small those of the points are, which follow a radius that the
/// caller may have chosen.
void check_cells()
{
  const Lengths_of_refinement lengths = {unit, noise, spacing};
  CHECK(cell_size_of_refinement(lengths, 4 * unit) == 4 * unit);
  for (const double of_points : {unit, 0.1 * unit, 1e-6, 1e-300})
  {
    const double size = cell_size_of_refinement(lengths, of_points);
    CHECK(is_reached_in_cells(radius_of_fit(first_scale_of_merged_disks - 1) * unit, size));
    CHECK(is_reached_in_cells(lengths.widened(widening_of_split).reach_of_disk(), size));
    CHECK(size <= 4 * unit);
  }
}

int main()
{
  Generator generator(20261128);
  for (const bool have_even_scales : {true, false})
  {
    check_formula(have_even_scales, generator);
    check_one_point(have_even_scales, generator);
  }
  check_heights(generator);
  check_few();
  check_cells();
  return result();
}
