// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_CARRY_PROPERTIES_H
#define L0_RESAMPLE_CARRY_PROPERTIES_H

#include "basis/Point_cloud.h"

#include <CGAL/L0_resampling/Near_points.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace l0_tool {

/// The properties of a result: those of the input, of numbers with fractions and of colors the mean
/// of near points, and of others, which may be labels, that of the nearest, as of times and angles
/// of a scanner and of colors in the bits of one number; then `source_index`, where there is one,
/// and the columns that are written. These go before properties of the input of the same name.
/// \param near_points of the result, unless `properties` has none
/// \param size of the result
Property_table carried_properties(const Property_table& properties,
                                  const CGAL::L0_resampling::Near_points& near_points,
                                  const std::vector<std::uint32_t>& source_indices,
                                  const std::vector<Result_column>& columns, std::size_t size);

} // namespace l0_tool

#endif // L0_RESAMPLE_CARRY_PROPERTIES_H
