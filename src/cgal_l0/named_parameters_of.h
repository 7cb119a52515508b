// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_NAMED_PARAMETERS_OF_H
#define CGAL_L0_PYTHON_NAMED_PARAMETERS_OF_H

#include "resample.h"

#include <CGAL/l0_resample_point_set.h>

#include <functional>

namespace l0_python {

/// The named parameters that do not depend on where the points are.
inline auto named_parameters_of(const Parameters& parameters,
                                const std::function<bool(double)>& callback,
                                CGAL::L0_resampling::Report& report)
{
  return CGAL::parameters::resampling_method(parameters.resampling_method)
#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED) .X(parameters.X)
#define CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED) .X(parameters.X)
#include <CGAL/L0_resampling/value_parameters.h>
    .callback(callback)
    .resampling_report(&report);
}

} // namespace l0_python

#endif // CGAL_L0_PYTHON_NAMED_PARAMETERS_OF_H
