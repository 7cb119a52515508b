// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_ORIENT_H
#define CGAL_L0_PYTHON_ORIENT_H

#include "Array_view.h"
#include "resample.h"

#include <CGAL/L0_resampling/Report.h>

#include <functional>
#include <vector>

namespace l0_python {

/// Normals, xyz interleaved.
template <typename FT>
struct Oriented_normals
{
  std::vector<FT> normals;
  CGAL::L0_resampling::Report report;
};

/*!
Calls `CGAL::l0_orient_normals()`; all normals are estimated if none are given.

\tparam FT `float` or `double`, the number type of the result
\throws what the function throws
*/
template <typename FT>
Oriented_normals<FT> orient(const Array_view& points, const Vectors_of_points<Array_view>& vectors,
                            const Parameters& parameters,
                            const std::function<bool(double)>& callback);

} // namespace l0_python

#endif // CGAL_L0_PYTHON_ORIENT_H
