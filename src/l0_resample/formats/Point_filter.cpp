// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Point_filter.h"

#include "basis/Failure.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <string>

namespace l0_tool {
namespace {

Property find_property(const Input_file& file, const Property_table& table,
                       const std::string& option, const std::string& name)
{
  for (const Property& property : table.properties())
    if (property.name == name)
      return property;
  for (const Property& property : table.properties())
    if (without_prefix(property.name) == folded(name))
      return property;
  throw Failure(INPUT_REFUSED, file.path() + ": " + option
                                 + " is given, but the points have no property '" + name + "'");
}

double value_of(const Property& property, const char* row)
{
  return decode(row + property.offset, property.type, false);
}

} // namespace

void Point_filter::find_properties(const Input_file& file, const Property_table& table)
{
  if (!m_classes.empty())
    m_classification = find_property(file, table, "--keep-classes", "classification");
  if (m_only_first_returns)
    m_return_number = find_property(file, table, "--first-returns", "return_number");
  m_is_complete = true;
}

bool Point_filter::keeps(const Input_file& file, const Property_table& table, const char* row)
{
  if (!m_is_complete)
    find_properties(file, table);
  bool is_kept = true;
  if (m_classification)
    is_kept = std::find(m_classes.begin(), m_classes.end(), value_of(*m_classification, row))
              != m_classes.end();
  if (m_return_number) // of some files 0, where nobody counted
    is_kept = is_kept && value_of(*m_return_number, row) <= 1;
  m_number_left_out += is_kept ? 0 : 1;
  return is_kept;
}

} // namespace l0_tool
