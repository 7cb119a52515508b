// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_SOURCE_BOX_H
#define CGAL_L0_RESAMPLING_SOURCE_BOX_H

#include <CGAL/license/L0_resampling.h>

#include <array>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// A box of points that are read together: coordinates from `low` on and below `high`.
struct Source_box
{
  std::array<double, 3> low, high;
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_SOURCE_BOX_H
