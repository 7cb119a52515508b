// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PRECEDES_H
#define CGAL_L0_RESAMPLING_INTERNAL_PRECEDES_H

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// An order of vectors that depends on their coordinates only.
template <typename T>
bool precedes(const Eigen::Matrix<T, 3, 1>& a, const Eigen::Matrix<T, 3, 1>& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PRECEDES_H
