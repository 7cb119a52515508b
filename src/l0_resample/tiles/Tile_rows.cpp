// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Tile_rows.h"

#include "tiles/tile_files.h"

#include <algorithm>
#include <cmath>

namespace l0_tool {

void Tile_rows::add(const std::string& path, const std::string& path_of_properties,
                    const std::vector<signed char>& signs, std::size_t size)
{
  m_parts.push_back({path, path_of_properties, signs, this->size() + size});
}

template <typename Value>
void Tile_rows::move(Window<Value>& window, std::string Part::*path, std::size_t i,
                     std::size_t per_row) const
{
  if (i >= window.first && i < window.end)
    return;
  const auto part = std::partition_point(m_parts.begin(), m_parts.end(),
                                         [&](const Part& p) { return p.end <= i; });
  const std::size_t number = std::size_t(part - m_parts.begin());
  const std::size_t begin = number == 0 ? 0 : m_parts[number - 1].end;
  if (!window.file || number != window.part)
    window.file = std::make_unique<Task_file>((*part).*path, m_key);
  window.part = number;
  window.first = i;
  window.end = (std::min)(i + rows_at_once, part->end);
  window.file->read_some(sizeof(std::uint64_t), // behind their number
                         (i - begin) * per_row, (window.end - i) * per_row, window.values);
}

const Tile_sample& Tile_rows::sample(std::size_t i) const
{
  move(m_samples, &Part::path, i, 1);
  return m_samples.values[i - m_samples.first];
}

const char* Tile_rows::property_row(std::size_t i) const
{
  const std::size_t row_size = m_properties.row_size();
  if (row_size == 0)
    return nullptr;
  move(m_rows, &Part::path_of_properties, i, row_size);
  return m_rows.values.data() + (i - m_rows.first) * row_size;
}

const Point& Tile_rows::point(std::size_t i) const
{
  const std::array<double, 3>& p = sample(i).position;
  m_point = Point(p[0], p[1], p[2]);
  return m_point;
}

Vector Tile_rows::normal(std::size_t i) const
{
  const Tile_sample& s = sample(i);
  const double sign = m_parts[m_samples.part].signs[s.tree];
  const Vector normal(sign * double(s.normal[0]), sign * double(s.normal[1]),
                      sign * double(s.normal[2]));
  return normal / std::sqrt(normal.squared_length());
}

} // namespace l0_tool
