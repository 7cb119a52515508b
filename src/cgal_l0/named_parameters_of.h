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
  const Parameters defaults = default_parameters(parameters.resampling_method);
  return CGAL::parameters::resampling_method(parameters.resampling_method)
    .number_of_output_points(parameters.number_of_output_points)
    .select_percentage(parameters.select_percentage)
    .neighbor_radius(parameters.neighbor_radius)
    .noise(parameters.noise)
    .normal_filter_radius(parameters.normal_filter_radius)
    .sharpness_angle(parameters.sharpness_angle)
    .number_of_normal_filter_iterations(parameters.number_of_normal_filter_iterations)
    .normal_weight(parameters.normal_weight)
    .regularization_weight(parameters.regularization_weight)
    .initial_penalty(parameters.initial_penalty)
    .maximum_penalty(parameters.maximum_penalty)
    .penalty_growth(parameters.penalty_growth.value_or(*defaults.penalty_growth))
    .keep_density(parameters.keep_density)
    .viewpoint(parameters.viewpoint)
    .up_direction(parameters.up_direction)
    .number_of_orientation_neighbors(parameters.number_of_orientation_neighbors)
    .random_seed(parameters.random_seed)
    .drop_non_finite(parameters.drop_non_finite)
    .drop_outliers(parameters.drop_outliers)
    .outlier_sensitivity(parameters.outlier_sensitivity)
    .maximum_memory(parameters.maximum_memory)
    .callback(callback)
    .resampling_report(&report);
}

} // namespace l0_python

#endif // CGAL_L0_PYTHON_NAMED_PARAMETERS_OF_H
