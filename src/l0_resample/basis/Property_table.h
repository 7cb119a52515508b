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
  std::size_t offset;          ///< of its value in a row, in bytes
  bool is_measured = true;     ///< whether there are means of values; there are none of labels
  std::vector<double> no_data; ///< values of measurements that stand for none
};

/// The values of all further properties, one row for each point, in the types of the file and the
/// byte order of this machine.
class Property_table
{
  std::vector<Property> m_properties;
  std::size_t m_row_size = 0;
  std::vector<char> m_rows;

public:
  /// Only before the first row. Numbers of floating-point types are measurements until somebody
  /// says that they are labels.
  void add_property(const std::string& name, Number_type type)
  {
    m_properties.push_back({name, type, m_row_size, is_floating(type), {}});
    m_row_size += size_of(type);
  }

  /// Gives the properties other types, none of them wider than before, and rounds as encode() does.
  /// \param shifts the bits that values lose at their lower end; empty for none
  void narrow(const std::vector<Number_type>& types, const std::vector<unsigned>& shifts = {});

  /// Says what the values of a property of a floating-point type are, as of `Property`.
  void set_meaning(std::size_t index, bool is_measured, const std::vector<double>& no_data)
  {
    m_properties[index].is_measured = is_measured;
    m_properties[index].no_data = no_data;
  }

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
