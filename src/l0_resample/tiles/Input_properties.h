// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_INPUT_PROPERTIES_H
#define L0_RESAMPLE_INPUT_PROPERTIES_H

#include "basis/Las_origin.h"
#include "basis/Number_type.h"
#include "basis/Point_cloud.h"
#include "basis/Property_table.h"
#include "tiles/Task_file.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// A property that the points of all inputs have.
struct Input_property
{
  std::string name;
  Number_type type;                       ///< which holds the values of all inputs
  std::map<Number_type, unsigned> shifts; ///< of values that a reader gives in a type
  bool is_measured = true;                ///< in any input; as of `Property`
  std::vector<double> no_data = {};       ///< of all inputs; likewise
};

/// What goes along with the points of an input, or of several.
struct Input_properties
{
  std::string input; ///< its name, or that of the first that has points; empty if none has
  std::vector<Input_property> properties;
  std::optional<Las_origin> las; ///< of the first input in LAS, or that tells a coordinate system
  bool have_one_system = true;   ///< whether no two inputs tell different coordinate systems
  std::vector<std::string> inputs_of_bytes;               ///< whose colors are `Las_colors::BYTES`
  bool has_scaled_bytes = false, has_fine_colors = false; ///< whether any input has those
  std::vector<std::string> warnings;                      ///< of all

  /// With no rows.
  Property_table table() const;
};

/// \param cloud as `read_points()` gives it where points went elsewhere
/// \param has_points whether there were some
Input_properties properties_of_input(const std::string& input, const Point_cloud& cloud,
                                     bool has_points);

/// Adds what another input has: the names have to be the same. A type is one that holds the values
/// of both, and colors of 16 bits become bytes as one of the inputs needs it. The coordinate system
/// goes along if no input tells another one.
/// \throws Failure with INPUT_REFUSED
void add_input(const Input_properties& other, Input_properties& all);

/// Once all inputs are added: leaves `inputs_of_bytes` only if they are to be scaled as others are.
/// Beside fine colors they are taken for dark tiles, with warnings.
void choose_inputs_of_bytes(Input_properties& all);

/// Makes a row of `Input_properties` of what a reader gives.
class Row_converter
{
  struct Column
  {
    Property from, to;
    unsigned factor, shift;
  };

  const Input_properties& m_all;
  std::string m_input;
  bool m_is_complete = false; // whether the properties of the reader are known
  std::vector<Column> m_columns;
  std::vector<char> m_row;

  void find_columns(const Property_table& given);

public:
  /// \param all outlives this object
  /// \param input its name
  Row_converter(const Input_properties& all, const std::string& input);

  /// \param given the properties of the reader, always the same
  const std::vector<char>& operator()(const Property_table& given, const char* row);
};

void write_properties(const Input_properties& properties, Task_file_writer& file);
Input_properties read_properties(Task_file& file);

} // namespace l0_tool

#endif // L0_RESAMPLE_INPUT_PROPERTIES_H
