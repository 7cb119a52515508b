// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEGLIGIBLE_DISPLACEMENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEGLIGIBLE_DISPLACEMENT_H

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A displacement that does not matter in the working frame, where the radius is 1. Samples that
/// lie closer together than this give a solver right-hand sides whose squares, or in `float` whose
/// products with a weight, are subnormal: what it makes of their last digits grows from iteration
/// to iteration.
constexpr double negligible_displacement = 1e-30;

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEGLIGIBLE_DISPLACEMENT_H
