// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_PORTABLE_RANDOM_H
#define CGAL_L0_RESAMPLING_BENCHMARK_PORTABLE_RANDOM_H

#include <cmath>
#include <cstdint>
#include <random>

namespace L0_benchmark {

/// Random numbers that do not depend on the standard library: the standard fixes the bits of
/// `std::mt19937_64`, but leaves the distributions to the implementation. Only the rounding of
/// `std::log()` may differ between platforms.
class Portable_random
{
public:
  explicit Portable_random(std::uint64_t seed) : m_engine(seed) {}

  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return double(m_engine() >> 11) * 0x1p-53; }

  /// Mean 0, standard deviation 1, by the polar method of Marsaglia. The second value of each pair
  /// is thrown away, so that the state of the engine is the whole state.
  double normal()
  {
    double u, squared_radius;
    do {
      u = 2 * uniform() - 1;
      const double v = 2 * uniform() - 1;
      squared_radius = u * u + v * v;
    } while (squared_radius >= 1 || squared_radius == 0);
    return u * std::sqrt(-2 * std::log(squared_radius) / squared_radius);
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_PORTABLE_RANDOM_H
