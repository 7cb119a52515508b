// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/extents.h>
#include <CGAL/L0_resampling/internal/kernels/share_of_extent.h>

#include <vector>

using namespace test;

double extent_share(const Vector& of_input, double noise, const Vector& of_result, double spacing)
{
  return share_of_extent(of_input.data(), noise, of_result.data(), spacing);
}

Vector trimmed(const std::vector<Vector>& points)
{
  const Vector extent = trimmed_extent<CGAL::Parallel_if_available_tag>(to_buffer(points));
  CHECK(trimmed_extent<CGAL::Sequential_tag>(to_buffer(points)) == extent);
  return extent;
}

/// Half a percent of the points may be anywhere, and more of them count.
void check_far_points(const std::vector<Vector>& cube)
{
  const Vector extent = trimmed(cube);
  CHECK(extent.minCoeff() > 0.98 && extent.maxCoeff() <= 1);
  for (std::size_t size : {cube.size() / 250, cube.size() / 100})
  {
    std::vector<Vector> with_far_points = cube;
    with_far_points.insert(with_far_points.end(), size, Vector(7, 0, 0));
    const double reach = trimmed(with_far_points).x();
    CHECK(size < cube.size() / 200 ? reach <= 1 : reach > 7);
  }
  const std::vector<Vector> few = {Vector(0, 0, 0), Vector(1, 2, 3), Vector(-1, 5, 4)};
  CHECK(trimmed(few) == Vector(2, 5, 4) && plain_extent(to_buffer(few)) == Vector(2, 5, 4));
}

/// A cube that is whole has its whole extent, whatever the noise of the input.
void check_noise(const std::vector<Vector>& cube, Generator& generator)
{
  for (double noise : {0., 0.01, 0.1})
  {
    std::vector<Vector> noisy = cube;
    add_gaussian_noise(noisy, noise, generator);
    CHECK(extent_share(trimmed(noisy), noise, Vector(1, 1, 1), 0) == 1);
    CHECK(extent_share(trimmed(noisy), 0, Vector(1, 1, 1), 0) > (noise > 0 ? 0. : 0.99));
    CHECK(noise < 0.1 || extent_share(trimmed(noisy), 0, Vector(1, 1, 1), 0) < 0.9);
  }
}

int main()
{
  Generator generator(21);
  const std::vector<Vector> cube = cube_points(20000, 1, generator).points;
  check_far_points(cube);
  check_noise(cube, generator);

  // shares of a diagonal; half a spacing at either end counts
  const Vector plate(3, 4, 0);
  CHECK(is_close(extent_share(plate, 0, 0.9 * plate, 0), 0.9, 1e-12));
  CHECK(is_close(extent_share(plate, 0, Vector(2.9, 3.9, 0), 0.1), 1, 1e-3));
  CHECK(extent_share(plate, 0, 2 * plate, 0) == 1);

  // without an extent, and too large for a square
  CHECK(extent_share(Vector::Zero(), 0, Vector::Zero(), 0) == 1);
  CHECK(extent_share(Vector(1e300, 0, 0), 0, Vector(1e300, 0, 0), 0) == 1);
  return result();
}
