// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NAMED_COLUMNS_H
#define L0_RESAMPLE_NAMED_COLUMNS_H

#include "basis/Number_type.h"
#include "formats/Point_collector.h"
#include "formats/read_points.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

constexpr std::size_t max_number_of_columns = 1000;

/*!
Parses the names of columns in a list such as "x,y,z,red,green,blue,-,intensity": as those of
properties in PLY, after `usual_names()`, and - or _ for a column that is left out.

\throws Failure with WRONG_USAGE unless x, y and z are among them, nx, ny and nz all or none, and no
        name is there twice, is empty, or has a blank or what is not ASCII
*/
Column_names parse_column_names(const std::string& list);

/// Whether a column of this name is left out.
bool is_left_out(const std::string& name);

bool have_coordinates(const Column_names& names);

/// Leaves a column out, and warns of it if properties are wanted.
void leave_out_column(std::string& name, const std::string& reason, Point_collector& collector);

/// Leaves names that a file has as `parse_column_names()` would have them: without those that are
/// there twice, and without a part of a normal.
/// \throws Failure if there are two of a coordinate
void check_column_names(const Input_file& file, Column_names& names, Point_collector& collector);

struct Named_column
{
  std::string name;                ///< as of `parse_column_names()`
  std::optional<Number_type> type; ///< of its values; nothing if these have to tell
};

/*!
Takes the rows of a table whose columns have names. What is neither a coordinate nor a part of a
normal becomes a property, if properties are wanted.
*/
class Named_columns
{
public:
  /// Only before the first row.
  /// \param vectors what nx, ny, nz are, if they are there
  Named_columns(const std::vector<Named_column>& columns, Vectors vectors,
                Point_collector& collector);

  std::size_t size() const { return m_targets.size(); }

  /// Whether anybody wants the numbers of this column.
  bool is_wanted(std::size_t column) const;

  /// Adds a row to the collector.
  /// \param values `size()` numbers
  void add(const std::vector<double>& values);

  /// After the last row. Of columns that have no names, the first is no coordinate if it numbers
  /// the rows.
  void refuse_row_numbers(const Input_file& file) const;

private:
  Point_collector& m_collector;
  std::vector<std::size_t> m_targets; // where columns go: into Point_row, nowhere, to a property
  bool m_may_number_rows;             // whether the first column may do it
  std::optional<double> m_first;      // of the last row
};

} // namespace l0_tool

#endif // L0_RESAMPLE_NAMED_COLUMNS_H
