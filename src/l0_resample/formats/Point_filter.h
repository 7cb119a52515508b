// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_POINT_FILTER_H
#define L0_RESAMPLE_POINT_FILTER_H

#include "basis/Property_table.h"
#include "files/Input_file.h"
#include "formats/read_points.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace l0_tool {

/// Which points of a file `Read_options` keep, by the properties that these have.
class Point_filter
{
  std::vector<unsigned> m_classes;
  bool m_only_first_returns;
  bool m_is_complete = false; // whether the properties are known
  std::optional<Property> m_classification, m_return_number;
  std::uint64_t m_number_left_out = 0;

  void find_properties(const Input_file& file, const Property_table& table);

public:
  explicit Point_filter(const Read_options& options)
    : m_classes(options.classes), m_only_first_returns(options.only_first_returns)
  {}

  /// \param table the properties, from the first call on always the same
  /// \param row the values of the next point
  /// \throws Failure if the points have no property that a filter needs
  bool keeps(const Input_file& file, const Property_table& table, const char* row);

  std::uint64_t number_left_out() const { return m_number_left_out; }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_POINT_FILTER_H
