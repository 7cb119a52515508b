// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Point_collector.h"

#include "basis/Failure.h"

#include <cmath>
#include <utility>
#include <vector>

namespace l0_tool {

void Point_collector::refuse_memory() const
{
  throw Failure(RUN_TIME_FAILURE,
                m_file.path() + ": the points alone take more than the "
                  + std::to_string(m_options.max_memory) + " bytes that "
                  + (m_options.on_point ? "--memory leaves for them" : "--max-memory allows"));
}

void Point_collector::check_limits(std::uint64_t number_of_points) const
{
  if (number_of_points > m_options.max_points)
    throw Failure(INPUT_REFUSED, m_file.path() + ": more than the "
                                   + std::to_string(m_options.max_points)
                                   + " points that --max-points allows");
  if (m_options.on_point) {
    if (m_buffer_size > m_options.max_memory)
      refuse_memory();
    return;
  }
  const std::uint64_t point_size = sizeof(Point)
                                   + (m_has_normals && m_options.with_normals ? sizeof(Vector) : 0)
                                   + m_cloud.properties.row_size();
  const std::uint64_t others =
    m_buffer_size + (m_are_normals_apart ? m_cloud.normals.size() : 0) * sizeof(Vector);
  if (others > m_options.max_memory
      || number_of_points > (m_options.max_memory - others) / point_size)
    refuse_memory();
}

std::size_t Point_collector::add_property(const std::string& name, Number_type type)
{
  m_cloud.properties.add_property(name, type);
  m_next_properties.resize(m_cloud.properties.row_size());
  return number_of_properties() - 1;
}

void Point_collector::announce(std::uint64_t count, std::uint64_t row_size)
{
  m_file.check_count(count, row_size, "points");
  check_limits(count);
  if (m_file.bytes_left()) // of a pipe nothing backs the count
    reserve(count);
}

void Point_collector::announce_buffer(std::uint64_t count, std::uint64_t buffer_size)
{
  m_buffer_size = buffer_size;
  check_limits(count);
}

void Point_collector::reserve(std::uint64_t count)
{
  if (m_options.on_point)
    return;
  m_cloud.points.reserve(count);
  if (m_has_normals && m_options.with_normals)
    m_cloud.normals.reserve(count);
  m_cloud.properties.reserve(count);
}

void Point_collector::add(const Point_row& row)
{
  ++m_number_of_rows;
  if (!std::isfinite(row[0]) || !std::isfinite(row[1]) || !std::isfinite(row[2])) {
    if (!m_options.drop_non_finite)
      m_file.refuse(
        std::string("a coordinate is not finite")
        + (m_is_organized ? ", as an organized cloud has it where nothing was measured" : "")
        + "; --drop-non-finite leaves such points out");
    ++m_cloud.number_of_dropped_points;
    if (m_are_normals_apart)
      m_dropped_rows.push_back(std::size_t(m_number_of_rows - 1));
    return;
  }
  if (!m_filter.keeps(m_file, m_cloud.properties, m_next_properties.data()))
    return;
  check_limits(m_cloud.points.size() + 1);
  if (m_are_normals_unnamed)
    measure_vector(row);
  if (m_options.on_point) {
    m_options.on_point(Point(row[0], row[1], row[2]), m_cloud.properties, m_next_properties.data());
    return;
  }
  m_cloud.points.emplace_back(row[0], row[1], row[2]);
  if (m_has_normals && m_options.with_normals)
    m_cloud.normals.emplace_back(row[3], row[4], row[5]);
  m_cloud.properties.append(m_next_properties.data());
}

void Point_collector::set_types(const std::vector<Number_type>& types,
                                const std::vector<double>& factors)
{
  for (std::size_t k = 0; k < properties().size(); ++k)
    m_cloud.narrowed.push_back({properties()[k].type, factors.empty() ? 1 : factors[k]});
  m_cloud.properties.narrow(types, factors);
}

void Point_collector::add_normal(const Vector& normal)
{
  ++m_number_of_normals_apart;
  if (!m_options.with_normals)
    return;
  m_cloud.normals.push_back(normal);
  check_limits(m_cloud.points.size());
}

void Point_collector::measure_vector(const Point_row& row)
{
  constexpr double tolerance = 0.01;
  const double length = std::sqrt(row[3] * row[3] + row[4] * row[4] + row[5] * row[5]);
  if (std::abs(length - 1) <= tolerance)
    ++m_number_of_unit_vectors;
  else if (length != 0)
    ++m_number_of_other_vectors; // NaN too
}

void Point_collector::drop_other_vectors()
{
  constexpr std::uint64_t least_ratio = 19; // of unit vectors to others
  const bool are_normals = m_number_of_unit_vectors > 0
                           && m_number_of_unit_vectors / least_ratio >= m_number_of_other_vectors;
  m_cloud.file_has_normals = are_normals;
  if (are_normals || m_cloud.points.empty())
    return;
  m_cloud.normals = {};
  if (m_options.with_normals || m_options.with_properties)
    warn("columns 4 to 6 are no unit vectors and not taken for normals; --columns can name them");
}

void Point_collector::match_normals()
{
  std::vector<Vector>& normals = m_cloud.normals;
  m_cloud.file_has_normals = m_number_of_normals_apart > 0
                             && m_number_of_normals_apart == m_number_of_rows;
  if (m_cloud.file_has_normals) {
    std::size_t end = 0, next_dropped = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
      if (next_dropped < m_dropped_rows.size() && m_dropped_rows[next_dropped] == i)
        ++next_dropped;
      else
        normals[end++] = normals[i];
    normals.resize(end);
    return;
  }
  normals = {};
  if (m_number_of_normals_apart > 0 && (m_options.with_normals || m_options.with_properties))
    warn("the " + std::to_string(m_number_of_normals_apart) + " normals are left out, as there are "
         + std::to_string(m_number_of_rows) + " points");
}

Point_cloud Point_collector::take()
{
  if (m_filter.number_left_out() > 0)
    note(std::to_string(m_filter.number_left_out())
         + " points are left out by --keep-classes or --first-returns");
  if (m_are_normals_apart)
    match_normals();
  if (m_are_normals_unnamed)
    drop_other_vectors();
  return std::move(m_cloud);
}

} // namespace l0_tool
