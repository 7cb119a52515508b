// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CHECKED_COUNT_H
#define CGAL_L0_RESAMPLING_INTERNAL_CHECKED_COUNT_H

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A sum of products of counts that refuses to leave the range of `Eigen::Index`, so that sizes of
/// matrices can be known to be right before anything is allocated.
class Checked_count
{
  std::size_t m_count = 0;

public:
  /// Adds `n * factor`, `factor` > 0.
  /// \throws std::length_error if the sum passes the range
  Checked_count& add(std::size_t n, std::size_t factor)
  {
    constexpr std::size_t limit = std::size_t((std::numeric_limits<Eigen::Index>::max)());
    if (n > (limit - m_count) / factor)
      throw std::length_error(
        "The quadratic problem has more rows or matrix entries than a 64-bit index counts.");
    m_count += n * factor;
    return *this;
  }

  Eigen::Index index() const { return Eigen::Index(m_count); }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CHECKED_COUNT_H
