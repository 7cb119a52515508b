// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_ROW_TARGETS_H
#define L0_RESAMPLE_ROW_TARGETS_H

#include <cstddef>
#include <vector>

namespace l0_tool {

/// Where each value of a row goes: index 0 to 5 in Point_row, `unused`, or from `first_property` on
/// the properties.
using Targets = std::vector<std::size_t>;
inline constexpr std::size_t unused = 6, first_property = 7;

} // namespace l0_tool

#endif // L0_RESAMPLE_ROW_TARGETS_H
