// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

// No include guard: included once for each thing that named_parameters.h makes of a name. The form
// is CGAL's own (STL_Extension/internal/parameters_interface.h), so that these lines can move
// there.
// clang-format takes the lines for one expression.
// clang-format off
CGAL_add_named_parameter(resampling_method_t, resampling_method, resampling_method)
CGAL_add_named_parameter(normal_weight_t, normal_weight, normal_weight)
CGAL_add_named_parameter(regularization_weight_t, regularization_weight, regularization_weight)
CGAL_add_named_parameter(initial_penalty_t, initial_penalty, initial_penalty)
CGAL_add_named_parameter(maximum_penalty_t, maximum_penalty, maximum_penalty)
CGAL_add_named_parameter(penalty_growth_t, penalty_growth, penalty_growth)
CGAL_add_named_parameter(normal_filter_radius_t, normal_filter_radius, normal_filter_radius)
CGAL_add_named_parameter(number_of_normal_filter_iterations_t, number_of_normal_filter_iterations,
                         number_of_normal_filter_iterations)
CGAL_add_named_parameter(number_of_orientation_neighbors_t, number_of_orientation_neighbors,
                         number_of_orientation_neighbors)
CGAL_add_named_parameter(drop_non_finite_t, drop_non_finite, drop_non_finite)
CGAL_add_named_parameter(drop_outliers_t, drop_outliers, drop_outliers)
CGAL_add_named_parameter(maximum_memory_t, maximum_memory, maximum_memory)
CGAL_add_named_parameter(resampling_report_t, resampling_report, resampling_report)
CGAL_add_named_parameter(source_index_map_t, source_index_map, source_index_map)
CGAL_add_named_parameter(feature_confidence_map_t, feature_confidence_map, feature_confidence_map)
CGAL_add_named_parameter(side_confidence_map_t, side_confidence_map, side_confidence_map)
CGAL_add_named_parameter(neighbor_radius_map_t, neighbor_radius_map, neighbor_radius_map)
CGAL_add_named_parameter(viewpoint_t, viewpoint, viewpoint)
CGAL_add_named_parameter(orientation_hint_map_t, orientation_hint_map, orientation_hint_map)
CGAL_add_named_parameter(keep_density_t, keep_density, keep_density)
CGAL_add_named_parameter(viewpoint_map_t, viewpoint_map, viewpoint_map)
CGAL_add_named_parameter(up_direction_t, up_direction, up_direction)
CGAL_add_named_parameter(outlier_sensitivity_t, outlier_sensitivity, outlier_sensitivity)
CGAL_add_named_parameter(noise_map_t, noise_map, noise_map)
CGAL_add_named_parameter(position_deviation_map_t, position_deviation_map, position_deviation_map)
CGAL_add_named_parameter(normal_deviation_map_t, normal_deviation_map, normal_deviation_map)
CGAL_add_named_parameter(crease_output_iterator_t, crease_output_iterator, crease_output_iterator)
CGAL_add_named_parameter(corner_output_iterator_t, corner_output_iterator, corner_output_iterator)
CGAL_add_named_parameter(noise_t, noise, noise)
CGAL_add_named_parameter(point_noise_map_t, point_noise_map, point_noise_map)
CGAL_add_named_parameter(outlier_output_iterator_t, outlier_output_iterator,
                         outlier_output_iterator)
