// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Tile_rows.h"

#include "tiles/tile_files.h"

#include <algorithm>
#include <cmath>

namespace l0_tool {
namespace {

Vector unit_vector(const std::array<float, 3>& v, double sign)
{
  const Vector vector(sign * double(v[0]), sign * double(v[1]), sign * double(v[2]));
  return vector / std::sqrt(vector.squared_length());
}

} // namespace

Oriented_point oriented_point(const Moved_sample& sample)
{
  const auto& [x, y, z] = sample.position;
  return {Point(x, y, z), unit_vector(sample.normal, 1)};
}

Property_table with_marks(Property_table properties)
{
  for (const Property& property : properties.properties())
    if (property.name == name_of_crease_marks)
      return properties;
  properties.add_property(name_of_crease_marks, Number_type::UINT8);
  return properties;
}

Tile_rows::Tile_rows(std::uint64_t key, const Property_table& carried, bool has_marks)
  : m_key(key), m_carried_size(carried.row_size()),
    m_properties(has_marks ? with_marks(carried) : carried),
    m_row(has_marks ? m_properties.row_size() : 0)
{
  if (has_marks)
    for (const Property& property : m_properties.properties())
      if (property.name == name_of_crease_marks)
        m_mark = property;
}

void Tile_rows::add(const std::string& path, const std::string& path_of_properties,
                    const std::vector<signed char>& signs, std::size_t size,
                    std::vector<Moved_sample> moved)
{
  m_parts.push_back({path, path_of_properties, signs, std::move(moved), this->size() + size});
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
  const std::size_t begin = begin_of(number);
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

const Moved_sample* Tile_rows::moved(std::size_t i) const
{
  if (!m_mark) // no creases
    return nullptr;
  const auto part = std::partition_point(m_parts.begin(), m_parts.end(),
                                         [&](const Part& p) { return p.end <= i; });
  const std::uint64_t place = i - begin_of(std::size_t(part - m_parts.begin()));
  const auto found =
    std::partition_point(part->moved.begin(), part->moved.end(),
                         [&](const Moved_sample& sample) { return sample.place < place; });
  return found != part->moved.end() && found->place == place ? &*found : nullptr;
}

const char* Tile_rows::property_row(std::size_t i) const
{
  const char* carried = nullptr;
  if (m_carried_size > 0) {
    move(m_rows, &Part::path_of_properties, i, m_carried_size);
    carried = m_rows.values.data() + (i - m_rows.first) * m_carried_size;
  }
  if (!m_mark)
    return carried;
  std::copy_n(carried, m_carried_size, m_row.data());
  const Moved_sample* const other = moved(i);
  encode(other ? double(other->mark) : 0, m_mark->type, m_row.data() + m_mark->offset);
  return m_row.data();
}

const Point& Tile_rows::point(std::size_t i) const
{
  const Moved_sample* const other = moved(i);
  if (other)
    m_point = oriented_point(*other).first;
  else {
    const std::array<double, 3>& p = sample(i).position;
    m_point = Point(p[0], p[1], p[2]);
  }
  return m_point;
}

Vector Tile_rows::normal(std::size_t i) const
{
  const Moved_sample* const other = moved(i);
  if (other)
    return oriented_point(*other).second;
  const Tile_sample& s = sample(i);
  return unit_vector(s.normal, m_parts[m_samples.part].signs[s.tree]);
}

} // namespace l0_tool
