// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_START_NEAR_SOURCE_H
#define CGAL_L0_RESAMPLING_INTERNAL_START_NEAR_SOURCE_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>

#include <cmath>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Where a sample starts whose point, its source, is the start of another one already: part of the
/// way to a partner, a point of the source's ball; or somewhere around a source that is alone. All
/// is chosen at random, by numbers that depend on the source and the partner alone, so that a part
/// of a cloud makes the same choice as all of it.
class Start_near_source
{
  std::uint64_t m_seed, m_number;

  CGAL_L0_HOST_DEVICE double random_share(std::uint64_t counter) const
  {
    const double unit = 1. / (std::uint64_t(1) << 53);
    return double(random_bits(m_seed, (m_number << 32) | counter) >> 11) * unit;
  }

public:
  /// \param seed of the call
  /// \param source its number in the order of the cloud
  /// \param number of the samples before this one that start near the same source
  CGAL_L0_HOST_DEVICE Start_near_source(std::uint64_t seed, std::uint64_t source,
                                        std::uint64_t number)
    : m_seed(seed + source), m_number(number)
  {}

  /// The point of the highest rank is the partner. One of a similar normal comes before all others,
  /// so that the way does not cut an edge. Never 0.
  /// \param partner its number in the order of the cloud
  CGAL_L0_HOST_DEVICE std::uint64_t rank(std::uint64_t partner, bool is_similar) const
  {
    return (random_bits(m_seed, (m_number << 32) | partner) >> 1)
           | (std::uint64_t(is_similar) << 63) | 1;
  }

  /// Of the way to the partner: never the middle, where the way back from the partner would put
  /// another sample.
  CGAL_L0_HOST_DEVICE double share_of_way() const { return 0.2 + 0.25 * random_share(0xffffffff); }

  /// From a source that is alone in its ball.
  /// \param normal of the source, of unit length
  CGAL_L0_HOST_DEVICE Triple offset_from_lone(const Triple& normal, double radius) const
  {
    const double two_pi = 6.283185307179586, angle = two_pi * random_share(0xfffffffe),
                 distance = share_of_way() * radius;
    const Triple u = any_orthogonal(normal);
    return distance * std::cos(angle) * u + distance * std::sin(angle) * cross(normal, u);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_START_NEAR_SOURCE_H
