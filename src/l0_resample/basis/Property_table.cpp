// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Property_table.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace l0_tool {

const Property* Property_table::find(const std::string& name) const
{
  for (const Property& property : m_properties)
    if (property.name == name)
      return &property;
  return nullptr;
}

void Property_table::narrow(const std::vector<Number_type>& types,
                            const std::vector<unsigned>& shifts)
{
  Property_table narrow;
  for (std::size_t k = 0; k < m_properties.size(); ++k) {
    narrow.add_property(m_properties[k].name, types[k]);
    if (is_floating(types[k]))
      narrow.set_meaning(k, m_properties[k].is_measured, m_properties[k].no_data);
  }

  // In place, as no row begins later than before
  const std::size_t number_of_rows = m_row_size == 0 ? 0 : m_rows.size() / m_row_size;
  std::vector<char> next(narrow.m_row_size);
  for (std::size_t i = 0; i < number_of_rows; ++i) {
    for (std::size_t k = 0; k < m_properties.size(); ++k)
      encode(shifted(value(i, m_properties[k]), shifts.empty() ? 0 : shifts[k]), types[k],
             next.data() + narrow.m_properties[k].offset);
    std::copy(next.begin(), next.end(), m_rows.begin() + std::ptrdiff_t(i * narrow.m_row_size));
  }
  m_rows.resize(number_of_rows * narrow.m_row_size);
  m_properties = std::move(narrow.m_properties);
  m_row_size = narrow.m_row_size;
}

} // namespace l0_tool
