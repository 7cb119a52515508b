// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_COUNTER_RANDOM_H
#define CGAL_L0_RESAMPLING_BENCHMARK_COUNTER_RANDOM_H

#include <cstdint>

namespace L0_benchmark {

/// Random numbers that are a function of a key and of how many were drawn before: each ray of each
/// view has a generator of its own, so that any part of a scan can be made without the others. Uses
/// additions, multiplications and shifts only, so the numbers are the same on every machine.
class Counter_random
{
public:
  /// \param seed of the scan
  /// \param view,ray which of the seed's generators this is
  Counter_random(std::uint64_t seed, std::uint64_t view, std::uint64_t ray)
    : m_key(mixed(mixed(mixed(seed) + view) + ray))
  {}

  /// In [0, 1), a multiple of 2^-53.
  double uniform() { return double(mixed(m_key + golden_ratio * ++m_count) >> 11) * 0x1p-53; }

  /// Mean 0, standard deviation 1: the sum of twelve uniform numbers, less 6. Nothing lies beyond
  /// 6, and tails are thinner than those of a Gaussian from about 3 on.
  double normal()
  {
    double sum = -6;
    for (int i = 0; i < 12; ++i)
      sum += uniform();
    return sum;
  }

private:
  /// 2^64 divided by the golden ratio: the step of SplitMix64.
  static constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15;

  /// The output function of SplitMix64 (Steele, Lea and Flood 2014).
  static std::uint64_t mixed(std::uint64_t x)
  {
    x += golden_ratio;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
  }

  std::uint64_t m_key;
  std::uint64_t m_count = 0;
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_COUNTER_RANDOM_H
