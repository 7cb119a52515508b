// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Tile_rows.h"

#include <algorithm>
#include <cmath>

namespace l0_tool {

void Tile_rows::add(const std::string& path, const std::vector<signed char>& signs,
                    std::size_t size)
{
  m_parts.push_back({path, signs, this->size() + size});
}

const Tile_sample& Tile_rows::sample(std::size_t i) const
{
  if (m_file && i >= m_first && i < m_first + m_samples.size())
    return m_samples[i - m_first];
  const auto part = std::partition_point(m_parts.begin(), m_parts.end(),
                                         [&](const Part& p) { return p.end <= i; });
  const std::size_t number = std::size_t(part - m_parts.begin());
  const std::size_t begin = number == 0 ? 0 : m_parts[number - 1].end;
  if (!m_file || number != m_part)
    m_file = std::make_unique<Task_file>(part->path, m_key);
  m_part = number;
  m_first = i;
  m_samples.resize((std::min)(rows_at_once, part->end - i));
  m_file->seek(sizeof(std::uint64_t) + (i - begin) * sizeof(Tile_sample)); // behind their number
  m_file->read_bytes(m_samples.size() * sizeof(Tile_sample),
                     reinterpret_cast<char*>(m_samples.data()));
  return m_samples.front();
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
  const double sign = m_parts[m_part].signs[s.tree];
  const Vector normal(sign * double(s.normal[0]), sign * double(s.normal[1]),
                      sign * double(s.normal[2]));
  return normal / std::sqrt(normal.squared_length());
}

} // namespace l0_tool
