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

#include <CGAL/L0_resampling/internal/core/Parameters.h>
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

  /// The point of the highest rank is the partner. First come those whose plane the source lies
  /// near, so that the way does not lead off the surface to the other side of a wall; among them
  /// those of a similar normal, so that it does not cut an edge. The plane is that of the partner:
  /// where the normal of the source is the worst one around, its plane would lead off the surface.
  /// Never 0.
  /// \param partner its number in the order of the cloud
  /// \param cosine of the angle between the normals of source and partner
  /// \param height of the source over the plane of the partner, of any sign
  template <typename T>
  CGAL_L0_HOST_DEVICE std::uint64_t rank(std::uint64_t partner, T cosine, T height,
                                         T squared_distance) const
  {
    const T squared_cosine = T(cosine_of_similar_normals * cosine_of_similar_normals);
    const bool is_similar = cosine * cosine > squared_cosine,
               is_near_plane = height * height < (1 - squared_cosine) * squared_distance;
    return (random_bits(m_seed, (m_number << 32) | partner) >> 2)
           | (std::uint64_t(is_near_plane) << 63) | (std::uint64_t(is_similar) << 62) | 1;
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
