// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PARAMETERS_OF_H
#define L0_RESAMPLE_PARAMETERS_OF_H

#include "command_line/options.h"

#include <CGAL/L0_resampling/named_parameters.h>

#include <array>
#include <cstddef>
#include <optional>

namespace l0_tool {

/// The named parameters that the options tell, of a call for a whole cloud and of one for its
/// tiles: all that are no maps, iterators or solvers.
/// \param viewpoint that of the options, or of what was read
inline auto parameters_of(const Options& options, std::size_t number_of_output_points,
                          const std::optional<std::array<double, 3>>& viewpoint)
{
  return CGAL::parameters::resampling_method(options.method)
    .normal_weight(normal_weight_of(options))
    .number_of_output_points(number_of_output_points)
    .neighbor_radius(options.neighbor_radius)
    .noise(options.noise)
    .sharpness_angle(options.sharpness_angle)
    .random_seed(options.seed)
    .drop_outliers(options.keep_outliers ? std::optional<bool>(false) : std::nullopt)
    .outlier_sensitivity(options.outlier_sensitivity)
    .keep_density(options.keep_density)
    .maximum_memory(options.max_memory)
    .viewpoint(viewpoint)
    .up_direction(options.up_direction);
}

} // namespace l0_tool

#endif // L0_RESAMPLE_PARAMETERS_OF_H
