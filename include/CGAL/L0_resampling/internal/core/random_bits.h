// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RANDOM_BITS_H
#define CGAL_L0_RESAMPLING_INTERNAL_RANDOM_BITS_H

#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The finalizer of the generator splitmix64 (Steele, Lea, Flood 2014): a number that looks random
/// for each pair of a seed and a counter, the same on every machine and in any order of evaluation.
CGAL_L0_HOST_DEVICE inline std::uint64_t random_bits(std::uint64_t seed, std::uint64_t counter)
{
  std::uint64_t z = (seed + 1) * 0x9E3779B97F4A7C15u + counter * 0xD1B54A32D192ED03u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RANDOM_BITS_H
