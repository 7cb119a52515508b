// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_support.h"

#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

using namespace CGAL::L0_resampling::internal;
using namespace test;

/// The values are those the matrix was made of, and the vector is one of the smallest: A v = value
/// v, of length 1.
void check(double smallest, double middle, double largest, Generator& generator)
{
  const Eigen::Matrix3d rotation = random_rotation(generator);
  const Eigen::Matrix3d a = rotation * Eigen::Vector3d(smallest, middle, largest).asDiagonal()
                            * rotation.transpose();
  const Eigen_decomposition found = decompose(
    {a(0, 0), a(0, 1), a(0, 2), a(1, 1), a(1, 2), a(2, 2)});
  const Eigen::Vector3d v(found.smallest_vector.x, found.smallest_vector.y,
                          found.smallest_vector.z);
  const double scale = std::abs(smallest) + std::abs(middle) + std::abs(largest);
  // roots that are nearly double lose half of the digits
  CHECK(std::abs(found.values[0] - smallest) <= 1e-7 * scale);
  CHECK(std::abs(found.values[1] - middle) <= 1e-7 * scale);
  CHECK(std::abs(found.values[2] - largest) <= 1e-7 * scale);
  CHECK(is_close(v.norm(), 1, 1e-12));
  CHECK((a * v - smallest * v).norm() <= 1e-7 * scale);
}

/// Values that differ by rounding only: any vector will do, but it has to be one.
void check_nearly_equal_values()
{
  for (double value : {1e-20, 1., 86.2, 3e9})
    for (int i = 0; i < 64; ++i)
    {
      const double unit = value * std::numeric_limits<double>::epsilon();
      const Eigen_decomposition found = decompose(
        {value + i % 4 * unit, 0, 0, value + i / 4 % 4 * unit, 0, value + i / 16 * unit});
      CHECK(is_close(dot(found.smallest_vector, found.smallest_vector), 1, 1e-12));
      CHECK(is_close(found.values[0], value, 1e-12) && is_close(found.values[2], value, 1e-12));
    }
}

int main()
{
  Generator generator(5);
  for (int round = 0; round < 200; ++round)
  {
    const double scale = std::pow(10., random_number(-30, 30, generator));
    const double a = random_number(0, 1, generator), b = a + random_number(0, 1, generator),
                 c = b + random_number(0, 1, generator);
    check(scale * a, scale * b, scale * c, generator);
    check(0, scale * b, scale * c, generator); // a plane
    check(scale * 1e-9, scale, scale * (1 + c), generator);
    check(0, 0, scale * c, generator);                 // a line
    check(scale * a, scale * b, scale * b, generator); // round
    check(scale * a, scale * a, scale * c, generator);
    check(scale * c, scale * c, scale * c, generator);
    check(-scale * c, scale * a, scale * b, generator);
  }
  check_nearly_equal_values();
  const Eigen_decomposition of_zero = decompose({0, 0, 0, 0, 0, 0});
  CHECK(of_zero.values[0] == 0 && of_zero.values[2] == 0 && of_zero.smallest_vector.z == 1);
  return result();
}
