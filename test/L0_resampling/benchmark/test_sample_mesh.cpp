// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The sampler that makes the benchmarks' input

#include "mesh_support.h"

#include "../../../benchmark/L0_resampling/quality/metrics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace L0_benchmark;
using namespace L0_benchmark_test;

namespace {

// The standard fixes the 10000th number of std::mt19937_64 seeded with 5489.
void test_portable_random()
{
  Portable_random random(5489);
  for (int i = 1; i < 10000; ++i)
    random.uniform();
  check_close(random.uniform(), double(9981545732273789042u >> 11) / 9007199254740992., 0);

  const int n = 200000;
  double sum = 0, squares = 0, fourth_powers = 0;
  for (int i = 0; i < n; ++i)
  {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    fourth_powers += x * x * x * x;
  }
  check_close(sum / n, 0, 0.01);
  check_close(squares / n, 1, 0.015);
  check_close(fourth_powers / n, 3, 0.15);
}

void test_area_uniform_sampling()
{
  // Every point is on the surface, a sixth of them on each side.
  const Ground_truth truth(cube());
  const std::vector<Point_3> points = sample_mesh(cube(), {60000, 0, 0, 1, 3});
  check(points.size() == 60000, "the count is exact");
  double sums[3] = {0, 0, 0};
  std::size_t number_on_top = 0;
  for (const Point_3& p : points)
  {
    check_close(truth.distance(p), 0, 1e-15);
    number_on_top += p.z() > 1 - 1e-12;
    for (int i = 0; i < 3; ++i)
      sums[i] += p[i];
  }
  check_close(double(number_on_top) / 10000, 1, 0.04);
  for (double sum : sums)
    check_close(sum / 60000, 0.5, 0.008);

  // A large and a small triangle: 9 to 1. Within the triangle the mean is the centroid.
  const Triangle_mesh two = {{Point_3(0, 0, 0), Point_3(3, 0, 0), Point_3(0, 3, 0),
                              Point_3(-1, 0, 0), Point_3(0, -1, 0)},
                             {{0, 1, 2}, {0, 3, 4}}};
  std::size_t number_in_large = 0;
  double sum = 0;
  for (const Point_3& p : sample_mesh(two, {50000, 0, 0, 1, 4}))
    if (p.x() >= 0)
    {
      ++number_in_large;
      sum += p.x();
    }
  check_close(double(number_in_large) / 50000, 0.9, 0.006);
  check_close(sum / double(number_in_large), 1, 0.015);

  check(sample_mesh(two, {100, 1, 10, 2, 5}) == sample_mesh(two, {100, 1, 10, 2, 5}),
        "same seed, same points");
  check(sample_mesh(two, {100, 1, 10, 2, 5}) != sample_mesh(two, {100, 1, 10, 2, 6}),
        "another seed, other points");
}

// Noise ten times the diagonal: the square itself adds less than 0.1 % to the spread of x and y.
void test_noise()
{
  const double expected = 10 * std::sqrt(2.);
  const std::vector<Point_3> points = sample_mesh(rectangle(1, 1), {20000, 1000, 0, 1, 7});
  for (int axis = 0; axis < 3; ++axis)
  {
    double sum = 0, squares = 0;
    for (const Point_3& p : points)
    {
      sum += p[axis];
      squares += p[axis] * p[axis];
    }
    const double average = sum / double(points.size());
    check_close(average, axis < 2 ? 0.5 : 0, 0.03 * expected);
    check_close(std::sqrt(squares / double(points.size()) - average * average) / expected, 1, 0.03);
  }
}

void test_outliers()
{
  // The box of the 4 x 3 rectangle has the diagonal 5; grown by 0.5 it is 4.5 x 3.5 x 0.5.
  const std::vector<Point_3> points = sample_mesh(rectangle(4, 3), {100000, 0, 30, 1, 8});
  check(points.size() == 100000, "the count includes the outliers");
  const std::vector<Point_3> outliers(points.begin() + 70000, points.end());
  for (std::size_t i = 0; i < 70000; ++i)
    check(points[i].z() == 0, "the points of the surface come first");
  const double lower[] = {-0.25, -0.25, -0.25}, upper[] = {4.25, 3.25, 0.25};
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> positions;
    for (const Point_3& p : outliers)
      positions.push_back((p[axis] - lower[axis]) / (upper[axis] - lower[axis]));
    check(*std::min_element(positions.begin(), positions.end()) >= 0,
          "an outlier is below the box");
    check(*std::max_element(positions.begin(), positions.end()) <= 1,
          "an outlier is above the box");
    for (double share : {0.001, 0.25, 0.5, 0.75, 0.999})
      check_close(quantile(positions, share), share, 0.012);
  }
}

// Along the longest axis, here y, the density is proportional to 8^height: a share of (8^h - 1) / 7
// lies below h.
void test_density_gradient()
{
  const double ratio = 8;
  std::vector<double> heights, widths;
  for (const Point_3& p : sample_mesh(rectangle(2, 5), {100000, 0, 0, ratio, 9}))
  {
    heights.push_back(p.y() / 5);
    widths.push_back(p.x() / 2);
  }
  const auto share_below = [](const std::vector<double>& values, double bound) {
    const auto is_below = [bound](double value) { return value < bound; };
    return double(std::count_if(values.begin(), values.end(), is_below)) / double(values.size());
  };
  for (double h : {0.1, 0.25, 0.5, 0.75})
    check_close(share_below(heights, h), (std::pow(ratio, h) - 1) / (ratio - 1), 0.006);
  check_close((1 - share_below(heights, 0.9)) / share_below(heights, 0.1) / std::pow(ratio, 0.9), 1,
              0.06);
  check_close(share_below(widths, 0.5), 0.5, 0.006);
}

} // namespace

int main()
{
  test_portable_random();
  test_area_uniform_sampling();
  test_noise();
  test_outliers();
  test_density_gradient();
  return number_of_failures == 0 ? 0 : 1;
}
