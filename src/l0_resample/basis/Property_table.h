// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PROPERTY_TABLE_H
#define L0_RESAMPLE_PROPERTY_TABLE_H

#include "basis/Number_type.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace l0_tool {

/// A further number of each point: an intensity, a channel of a color, ...
struct Property
{
  std::string name;
  Number_type type;
  std::size_t offset;        ///< of its value in a row, in bytes
  bool has_fractions = true; ///< whether a value may have digits behind the point; a label has none
};

/// The values of all further properties, one row for each point, in the types of the file and the
/// byte order of this machine.
class Property_table
{
  std::vector<Property> m_properties;
  std::size_t m_row_size = 0;
  std::vector<char> m_rows;

public:
  /// Only before the first row. Numbers of floating-point types may have fractions until somebody
  /// says that they have none.
  void add_property(const std::string& name, Number_type type)
  {
    m_properties.push_back({name, type, m_row_size, is_floating(type)});
    m_row_size += size_of(type);
  }

  /// Gives the properties other types, none of them wider than before, and rounds as encode() does.
  /// \param shifts the bits that values lose at their lower end; empty for none
  void narrow(const std::vector<Number_type>& types, const std::vector<unsigned>& shifts = {});

  /// Says that all values of a property of a floating-point type are whole numbers.
  void set_whole(std::size_t index) { m_properties[index].has_fractions = false; }

  const std::vector<Property>& properties() const { return m_properties; }

  /// In bytes.
  std::size_t row_size() const { return m_row_size; }

  void reserve(std::size_t number_of_rows) { m_rows.reserve(number_of_rows * m_row_size); }
  /// \param row of `row_size()` bytes
  void append(const char* row) { m_rows.insert(m_rows.end(), row, row + m_row_size); }
  /// New rows are to be written.
  void resize(std::size_t number_of_rows) { m_rows.resize(number_of_rows * m_row_size); }
  const char* row(std::size_t i) const { return m_rows.data() + i * m_row_size; }
  char* row(std::size_t i) { return m_rows.data() + i * m_row_size; }

  /// The property of a name; null if there is none.
  const Property* find(const std::string& name) const;

  double value(std::size_t row_index, const Property& property) const
  {
    return decode(row(row_index) + property.offset, property.type, false);
  }
};

/// A whole number without its lowest bits.
inline double shifted(double value, unsigned shift)
{
  return shift == 0 ? value : std::floor(std::ldexp(value, -int(shift)));
}

} // namespace l0_tool

#endif // L0_RESAMPLE_PROPERTY_TABLE_H
