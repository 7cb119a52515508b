// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEXT_COLUMNS_H
#define L0_RESAMPLE_TEXT_COLUMNS_H

#include "files/Input_file.h"
#include "formats/Point_collector.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {

constexpr std::size_t max_number_of_columns = 1000;

/*!
The names of columns in a list such as "x,y,z,red,green,blue,-,intensity": as those of properties in
PLY, and - or _ for a column that is left out.

\throws Failure with WRONG_USAGE unless x, y and z are among them, nx, ny and nz all or none, and no
        name is there twice, is empty, or has a blank or what is not ASCII
*/
Column_names parse_column_names(const std::string& list);

/*!
Reads the rows of a text whose columns have names. What is neither a coordinate nor a part of a
normal becomes a property, if properties are wanted. Its type is found when all rows are read:
UINT8 for the channels of a color if all of them are whole numbers from 0 to 255, INT32 or UINT32
for other columns of whole numbers that fit, and FLOAT64 else.
*/
class Text_columns
{
public:
  /// Only before the first row.
  /// \param names as of `parse_column_names()`
  Text_columns(const Column_names& names, Point_collector& collector);

  std::size_t size() const { return m_targets.size(); }

  /// Adds a row of `size()` words to the collector. An empty one is a value that is missing: NaN.
  /// \throws Failure if one that is needed is not a number
  void read(const Input_file& file, const std::vector<std::string_view>& words);

  /// After the last row.
  void choose_types();

private:
  /// What the numbers of a property are.
  struct Numbers
  {
    bool is_channel; ///< of a color
    bool are_whole = true;
    double lowest = 0, highest = 0; ///< of them and 0, if they are whole

    void add(double number);
    bool lie_within(double low, double high) const;
  };

  Point_collector& m_collector;
  std::vector<std::size_t> m_targets; // where columns go: into Point_row, nowhere, to a property
  std::vector<Numbers> m_numbers;     // of the properties
};

} // namespace l0_tool

#endif // L0_RESAMPLE_TEXT_COLUMNS_H
