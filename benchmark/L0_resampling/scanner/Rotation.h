// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_ROTATION_H
#define CGAL_L0_RESAMPLING_BENCHMARK_ROTATION_H

#include "../common/Triangle_mesh.h"

#include <cmath>

namespace L0_benchmark {

inline Vector_3 normalized(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

/// Cosine and sine of an angle.
struct Rotation
{
  double cosine;
  double sine;

  /// Of so many full turns. By Taylor's series instead of the standard library's functions, whose
  /// last digit differs between platforms; the error is below 1e-15.
  static Rotation of_turns(double turns)
  {
    constexpr double pi = 3.14159265358979323846;
    const double quarters = std::floor(4 * turns + 0.5);
    const double x = 2 * pi * (turns - quarters / 4); // within pi / 4 of 0
    double cosine = 1, sine = 1;
    // n (n - 1) and n (n + 1) as numbers of a table, with which compilers unroll the loop
    constexpr double below[] = {240, 182, 132, 90, 56, 30, 12, 2};
    constexpr double above[] = {272, 210, 156, 110, 72, 42, 20, 6};
    for (int i = 0; i < 8; ++i) {
      cosine = 1 - x * x / below[i] * cosine;
      sine = 1 - x * x / above[i] * sine;
    }
    sine *= x;
    switch (int(quarters - 4 * std::floor(quarters / 4))) {
    case 0: return {cosine, sine};
    case 1: return {-sine, cosine};
    case 2: return {-cosine, -sine};
    default: return {sine, -cosine};
    }
  }

  static Rotation of_degrees(double degrees) { return of_turns(degrees / 360); }

  /// \param axis of unit length
  Vector_3 operator()(const Vector_3& v, const Vector_3& axis) const
  {
    return cosine * v + sine * CGAL::cross_product(axis, v) + (1 - cosine) * (axis * v) * axis;
  }
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_ROTATION_H
