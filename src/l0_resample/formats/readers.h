// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_READERS_H
#define L0_RESAMPLE_READERS_H

#include "files/Input_file.h"
#include "formats/Point_collector.h"

#include <string>
#include <string_view>

namespace l0_tool {

/// The first three words of `line` as a point, the next three as its normal if there is one.
/// Further words do not matter.
/// \throws Failure if there are fewer words, or one is not a number
Point_row parse_row(const Input_file& file, std::string_view line, bool has_normal);

/// Warns of what stands behind the last one of what is read, unless these are blanks and line ends.
void warn_of_rest(Input_file& file, const std::string& last, Point_collector& collector);

// One for each format; the contract is that of read_points().
void read_ply(Input_file& file, Point_collector& collector);
void read_off(Input_file& file, Point_collector& collector);
void read_pcd(Input_file& file, Point_collector& collector);
void read_npy(Input_file& file, Point_collector& collector, const Column_names& names);
void read_obj(Input_file& file, Point_collector& collector);
void read_las(Input_file& file, Point_collector& collector);
/// \param names of the columns, or none for those that the file tells
/// \param needs_names whether a file that tells none is refused
void read_text(Input_file& file, Point_collector& collector, const Column_names& names,
               bool needs_names);

} // namespace l0_tool

#endif // L0_RESAMPLE_READERS_H
