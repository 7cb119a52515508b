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
normal becomes a property, if properties are wanted. A type that is not given is found when all rows
are there: UINT8 for the channels of a color if all of them are whole numbers from 0 to 255, INT32
or UINT32 for other columns of whole numbers that fit, and FLOAT64 else.
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

  /// After the last row.
  void choose_types();

private:
  /// What the numbers of a property are whose type is not given.
  struct Numbers
  {
    bool is_channel; ///< of a color
    bool are_whole = true;
    double lowest = 0, highest = 0; ///< of them and 0, if they are whole

    void add(double number);
    bool lie_within(double low, double high) const;
  };

  Number_type type_of(const Numbers& numbers, bool are_channels_bytes) const;

  Point_collector& m_collector;
  std::vector<std::size_t> m_targets; // where columns go: into Point_row, nowhere, to a property
  std::vector<std::optional<Numbers>> m_numbers; // of the properties
  bool m_may_number_rows;                        // whether the first column may do it
  std::optional<double> m_first;                 // of the last row
};

} // namespace l0_tool

#endif // L0_RESAMPLE_NAMED_COLUMNS_H
