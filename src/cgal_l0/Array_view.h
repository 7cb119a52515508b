// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_ARRAY_VIEW_H
#define CGAL_L0_PYTHON_ARRAY_VIEW_H

#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace l0_python {

/// An array of n rows of `float` or `double`, wherever its rows and columns lie in memory. It
/// belongs to somebody else.
struct Array_view
{
  const char* data = nullptr;
  std::ptrdiff_t row_stride = 0, column_stride = 0; // in bytes, of either sign
  std::size_t size = 0;                             // number of rows
  bool is_double = true;

  double at(std::size_t row, std::ptrdiff_t column) const
  {
    // Copied, since nothing says that a number begins where the processor wants it to.
    const char* bytes = data + std::ptrdiff_t(row) * row_stride + column * column_stride;
    if (is_double)
    {
      double number;
      std::memcpy(&number, bytes, sizeof(number));
      return number;
    }
    float number;
    std::memcpy(&number, bytes, sizeof(number));
    return double(number);
  }
};

/// Gives row i of an array for the key i, as a point, a vector or a number. `double` holds every
/// `float`.
template <typename Value>
struct Row_map
{
  using key_type = std::size_t;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  Array_view array;

  friend Value get(const Row_map& map, std::size_t row)
  {
    if constexpr (std::is_same<Value, double>::value)
      return map.array.at(row, 0);
    else
      return Value(map.array.at(row, 0), map.array.at(row, 1), map.array.at(row, 2));
  }
};

using Array_kernel = CGAL::Simple_cartesian<double>;
using Point_map = Row_map<Array_kernel::Point_3>;
using Normal_map = Row_map<Array_kernel::Vector_3>;
using Number_map = Row_map<double>;

} // namespace l0_python

#endif // CGAL_L0_PYTHON_ARRAY_VIEW_H
