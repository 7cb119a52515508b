// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TAGS_H
#define CGAL_L0_RESAMPLING_TAGS_H

#include <CGAL/license/L0_resampling.h>

namespace CGAL {

/// \ingroup PkgL0ResamplingRef
/// Concurrency tag that runs every stage of `CGAL::l0_resample_point_set()` on a CUDA device.
struct CUDA_tag
{};

namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// The ways to resample, see the named parameter `resampling_method`.
enum class Method
{
  DEFAULT, ///< what this package recommends
  LOR,     ///< Section 3 of the paper: Eq. (6) by Algorithm 1, every term in every iteration
  /// Section 4 of the paper: two passes of local half-sampling, regularization every second
  /// iteration
  ALOR
};

/// \ingroup PkgL0ResamplingRef
/// The default of the named parameter `normal_weight`, for programs that show it.
constexpr double default_normal_weight = 0.9;

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TAGS_H
