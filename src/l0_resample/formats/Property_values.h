// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PROPERTY_VALUES_H
#define L0_RESAMPLE_PROPERTY_VALUES_H

#include "basis/Number_type.h"
#include "basis/Property_table.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace l0_tool {

/// Whether a double may have rounded one of the integers of 64 bits that lie within this range.
bool may_be_rounded(double lowest, double highest);

/*!
Looks at the values of properties of floating-point types, to tell what only all of them do.

- Values are labels, of which there is no mean, if they are whole, or if there are few: 256
  different ones at most, and ten points for each.
- Others are measurements. A value that several points have stands for none, such as -9999, if all
  others lie on one side of it, farther away than they are from each other: nothing else lies where
  a mean with it would.
*/
class Property_values
{
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// The value that is farthest on one side.
  struct Extreme
  {
    int side;                             ///< 1 for the highest value, -1 for the lowest
    double value = -side * infinity;      ///< infinite if there is none
    double next_value = -side * infinity; ///< the next one that differs from it
    std::uint64_t number = 0;             ///< of points with the first one

    void add(double other);
  };

  struct Values
  {
    std::size_t property;  ///< its index
    bool is_type_open;     ///< whether they have to tell the type
    bool is_channel;       ///< of a color
    bool are_whole = true; ///< those that are finite
    bool are_finite = true;
    std::uint64_t number = 0;           ///< of those that are finite
    std::vector<double> different = {}; ///< of those, in ascending order, or too many
    Extreme lowest{-1}, highest{1};     ///< of those

    void add(double value);
    bool are_whole_within(double low, double high) const;
    bool are_few() const;
    std::vector<double> no_data() const;
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
