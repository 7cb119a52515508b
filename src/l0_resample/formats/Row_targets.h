// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_ROW_TARGETS_H
#define L0_RESAMPLE_ROW_TARGETS_H

#include "files/Input_file.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace l0_tool {

/// Where each value of a row goes: index 0 to 5 in Point_row, `unused`, or from `first_property` on
/// the properties.
using Targets = std::vector<std::size_t>;
inline constexpr std::size_t unused = 6, first_property = 7;

/*!
Finds which columns of a file are coordinates and normals.

\param own_names of the columns
\param names what `usual_names()` has made of them
\param kind what a column is called in the format
\param reason_against says why a column is none; empty if it may be
\throws Failure unless there is one of each coordinate, and at most one of each of a normal
*/
Targets find_targets(const Input_file& file, const std::vector<std::string>& own_names,
                     const std::vector<std::string>& names, const std::string& kind,
                     const std::function<std::string(std::size_t)>& reason_against);

/// Of `find_targets()`.
bool have_normals(const Targets& targets);

} // namespace l0_tool

#endif // L0_RESAMPLE_ROW_TARGETS_H
