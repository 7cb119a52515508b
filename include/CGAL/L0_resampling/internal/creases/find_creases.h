// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/creases/Placed_creases.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Finds the creases and corners of samples, and puts some of the samples on them.

\param spacing `spacing_of_creases()`
\param normals unit vectors, all outwards
*/
template <typename ConcurrencyTag, typename FT>
Placed_creases find_creases(double spacing, Progress& progress, Buffer<Vector>& positions,
                            Buffer<Eigen::Matrix<FT, 3, 1>>& normals);

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIND_CREASES_H
