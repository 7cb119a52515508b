// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_USUAL_NAMES_H
#define L0_RESAMPLE_USUAL_NAMES_H

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {

/// The names of what a `Point_row` holds, in its order.
inline constexpr std::array<std::string_view, 6> row_names = {"x", "y", "z", "nx", "ny", "nz"};

/// Letters and digits alone, in lower case, of ASCII: what of a name does matter.
std::string folded(std::string_view name);

/// The same without the word that CloudCompare puts before the names of scalar fields.
std::string without_prefix(std::string_view name);

/*!
The names that this program has for the columns of a file, whatever its format: those of coordinates
become x, y, z, those of a normal nx, ny, nz, and those of a color red, green, blue and maybe alpha.
Three of a kind do so together, if all are there in one of the spellings of the table in
`usual_names.cpp`. Case, blanks and punctuation do not matter to these, but where there are x and X,
x is the coordinate. Where there are none, those with the word "scalar" before them do. Other names
stay as they are.
*/
std::vector<std::string> usual_names(std::vector<std::string> names);

/// Whether column `k` has a usual name of itself, while another one has got that name: then the
/// other one is meant, as its two companions are there.
/// \param names those that `usual_names()` has made of `own_names`
bool is_name_of_other(const std::vector<std::string>& own_names,
                      const std::vector<std::string>& names, std::size_t k);

/// The names of the values of a column that has several: x, y, z of points, nx, ny, nz of normals,
/// and red, green, blue of colors, if it is called so; else its name with their numbers, from 0.
std::vector<std::string> names_of_values(const std::string& name, std::size_t number_of_values);

} // namespace l0_tool

#endif // L0_RESAMPLE_USUAL_NAMES_H
