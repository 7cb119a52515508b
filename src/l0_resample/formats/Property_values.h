// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PROPERTY_VALUES_H
#define L0_RESAMPLE_PROPERTY_VALUES_H

#include "basis/Number_type.h"
#include "basis/Property_table.h"

#include <CGAL/L0_resampling/Attribute_values.h>

#include <cstddef>
#include <string>
#include <vector>

namespace l0_tool {

/// Whether a double may have rounded one of the integers of 64 bits that lie within this range.
bool may_be_rounded(double lowest, double highest);

/// Looks at the values of properties of floating-point types, to tell what only all of them do: of
/// open types which one they have, and what `Attribute_values` tells.
class Property_values
{
  struct Values : CGAL::L0_resampling::Attribute_values
  {
    std::size_t property; ///< its index
    bool is_type_open;    ///< whether they have to tell the type
    bool is_channel;      ///< of a color

    bool are_whole_within(double low, double high) const;
  };

  std::vector<Values> m_values;

public:
  /// \param property the last one of a table
  /// \param is_type_open whether its values have to tell the type
  void add_property(const Property_table& table, bool is_type_open);

  /// Looks at the values of a point.
  void look(const Property_table& table, const char* row);

  /// The types of all properties. Open ones are UINT8 for the channels of a color if all of them
  /// are whole numbers from 0 to 255, INT32 or UINT32 for other whole numbers that fit, and FLOAT64
  /// else.
  std::vector<Number_type> types(const Property_table& table) const;

  /// Names of properties of open types with whole numbers that a double may have rounded.
  std::vector<std::string> names_of_rounded(const Property_table& table) const;

  /// Says which properties are labels, and which values stand for none.
  void set_meanings(Property_table& table) const;
};

} // namespace l0_tool

#endif // L0_RESAMPLE_PROPERTY_VALUES_H
