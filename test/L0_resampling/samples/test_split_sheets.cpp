// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "samples/sorted_samples.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/share_points.h>
#include <CGAL/L0_resampling/internal/samples/split_sheets.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

using namespace test;

/// Of points that are a spacing of 0.01 apart, whose unit is larger by 1.4.
const double noise = 0.02, unit = 0.014, spacing = 0.02, cell_size = 0.06;
const std::size_t number_of_points = 40000;

struct Split
{
  Buffer<Vector> positions;
  Buffer<Local_vector> normals;
  Buffer<float> noise_ratios;
  Buffer<signed char> sheets;

  std::size_t number_of_split() const
  {
    return std::size_t(std::count_if(sheets.begin(), sheets.end(), [](int s) { return s != 0; }));
  }
};

/// Of samples of one plane, some of which have their normals downwards.
/// \param height called for each point: over that plane
template <typename Height>
Split split(const Height& height, bool splits, Generator& generator)
{
  Oriented_points cloud = even_samples(spacing, generator);
  turn_some(generator, cloud.normals);
  const Sorted_samples samples(cloud, cell_size, true);
  std::vector<Vector> points = plane_points(number_of_points, 2, generator).points;
  for (Vector& p : points)
    p.z() += height();
  const Sorted_samples sorted_points({points, std::vector<Vector>(points.size(), Vector::UnitZ())},
                                     cell_size, true);
  const Lengths_of_refinement lengths = {unit, noise, spacing},
                              wide = lengths.widened(widening_of_split);
  const Buffer<Disk_kernel<Local>> kernels(samples.size(), wide.kernel_of_disk());
  Unwatched unwatched;
  const Buffer<Disk> disks = share_points<CGAL::Sequential_tag>(
    sorted_points.sorted.grid, sorted_points.sorted.points,
    {samples.sorted.grid, samples.sorted.points, samples.normals, kernels},
    cells_in_reach(wide.reach_of_disk(), cell_size), unwatched.progress);
  const auto run = [&](auto tag) {
    using Tag = decltype(tag);
    Split result = {
      copy_of(samples.sorted.points), copy_of(samples.normals), Buffer<float>(samples.size()), {}};
    result.sheets = Sheet_splitter<Tag>(lengths, samples.sorted.grid, {}, 0, disks,
                                        unwatched.progress, result.positions, result.normals,
                                        result.noise_ratios)(splits);
    return result;
  };
  Split result = run(CGAL::Parallel_if_available_tag());
  const Split sequential = run(CGAL::Sequential_tag());
  CHECK(result.positions == sequential.positions && result.normals == sequential.normals
        && result.noise_ratios == sequential.noise_ratios && result.sheets == sequential.sheets);
  if (result.number_of_split() == 0)
    CHECK(result.positions == samples.sorted.points && result.normals == samples.normals);
  return result;
}

auto gaussian(double deviation, Generator& generator)
{
  return [deviation, &generator]() { return std::normal_distribution<>(0, deviation)(generator); };
}

/// The points of two sheets, each with the noise.
/// \param distance of the two
auto two_sheets(double distance, Generator& generator)
{
  return [distance, &generator]() {
    const double side = std::bernoulli_distribution()(generator) ? 0.5 : -0.5;
    return side * distance + std::normal_distribution<>(0, noise)(generator);
  };
}

/// The noise away from the ends of the plane, per that of the cloud.
double median_of_ratios(const Split& split)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < split.positions.size(); ++i)
    if (split.positions[i].head<2>().lpNorm<Eigen::Infinity>() < 0.8)
      ratios.push_back(double(split.noise_ratios[i]));
  std::nth_element(ratios.begin(), ratios.begin() + std::ptrdiff_t(ratios.size() / 2),
                   ratios.end());
  return ratios[ratios.size() / 2];
}

/// Samples between two sheets go to either, by turns, and their normals look away from the other.
void check_two_sheets(Generator& generator)
{
  const double distance = 2.5 * noise;
  const Split result = split(two_sheets(distance, generator), true, generator);
  double number = 0, upwards = 0, squares = 0, around = 0, squared_sums = 0;
  for (std::size_t i = 0; i < result.sheets.size(); ++i)
  {
    if (result.sheets[i] == 0)
      continue;
    const Vector& p = result.positions[i];
    ++number;
    upwards += p.z() > 0;
    squares += square(std::abs(p.z()) - distance / 2);
    CHECK(double(result.normals[i].z()) * p.z() > 0);
    double sum = 0;
    for (std::size_t k = 0; k < result.sheets.size(); ++k)
      if (result.sheets[k] != 0 && (result.positions[k] - p).head<2>().norm() < 1.5 * spacing)
      {
        ++around;
        sum += result.positions[k].z() > 0 ? 1 : -1;
      }
    squared_sums += sum * sum;
  }
  CHECK(number > 0.8 * double(result.sheets.size()));
  CHECK(std::abs(upwards / number - 0.5) < 0.05);
  CHECK(std::sqrt(squares / number) < 0.15 * distance);
  CHECK(squared_sums < 0.5 * around); // by chance both are the same
}

/// One sheet stays one, with whatever noise, and two that points cannot tell do; and none is split
/// that the caller says is one.
void check_one_sheet(Generator& generator)
{
  const Split even = split(gaussian(noise, generator), true, generator);
  CHECK(even.number_of_split() == 0);
  CHECK(is_close(median_of_ratios(even), 1, 0.03));
  const Split noisy = split(gaussian(2.2 * noise, generator), true, generator);
  CHECK(noisy.number_of_split() == 0);
  // less than 2.2, as the disks do not reach all of the points
  CHECK(median_of_ratios(noisy) > 1.2 && median_of_ratios(noisy) < 2.2);
  const Split noisier = split(gaussian(1.4 * noise, generator), true, generator); // 0.9 %
  CHECK(double(noisier.number_of_split()) < 0.02 * double(noisier.positions.size()));
  const Split exact = split(gaussian(0.5 * noise, generator), true, generator);
  CHECK(exact.number_of_split() == 0);
  CHECK(is_close(median_of_ratios(exact), 0.5, 0.15));
  const auto rounded = [&]() { return random_number(-1.7 * noise, 1.7 * noise, generator); };
  CHECK(split(rounded, true, generator).number_of_split() == 0);
  CHECK(split(two_sheets(0.3 * unit, generator), true, generator).number_of_split() == 0);
  CHECK(split(two_sheets(2.5 * noise, generator), false, generator).number_of_split() == 0);
}

/// Exact points, of which the noise was taken for less than it is, and is not Gaussian.
void check_exact_points()
{
  const double deviation = 0.2 * unit;
  const auto half_distance = [&](double distance) {
    Scatter_in_ball ball({}, square(deviation));
    ball.variance = square(distance / 2) + square(deviation);
    ball.kurtosis = 1;
    return double(Split_of_sheet(ball, ball, square(deviation), unit).half_distance);
  };
  CHECK(half_distance(0.45 * unit) == 0);
  CHECK(is_close(half_distance(0.6 * unit), 0.3 * unit, 1e-5));
}

/// Noise that is larger than elsewhere has the tails of noise; heavier ones raise nothing.
void check_tails()
{
  const auto ratio = [&](double deviation, double kurtosis) {
    Scatter_in_ball ball({}, 1);
    ball.variance = square(deviation);
    ball.kurtosis = kurtosis;
    return double(noise_ratio(ball, ball, Split_of_sheet(), 1));
  };
  CHECK(is_close(ratio(2, 3), 2, 1e-6) && is_close(ratio(2, 3.2), 2, 1e-6));
  CHECK(ratio(2, 3.35) < 1.8 && ratio(2, 3.35) > 1.2);
  CHECK(ratio(2, 3.6) == 1 && ratio(2, 5) == 1);
  CHECK(is_close(ratio(0.5, 5), 0.5, 1e-6));
}

int main()
{
  Generator generator(20261129);
  check_two_sheets(generator);
  check_one_sheet(generator);
  check_exact_points();
  check_tails();
  return result();
}
