// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Point_collector.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "formats/degrees.h"
#include "formats/usual_names.h"

#include <algorithm>
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
  const bool has_normals = m_vectors && m_options.with_normals;
  const std::uint64_t point_size = sizeof(Point) + (has_normals ? sizeof(Vector) : 0)
                                   + m_cloud.properties.row_size();
  if (m_buffer_size > m_options.max_memory
      || number_of_points > (m_options.max_memory - m_buffer_size) / point_size)
    refuse_memory();
}

std::size_t Point_collector::add_property(const std::string& name, std::optional<Number_type> type)
{
  m_cloud.properties.add_property(name, type.value_or(Number_type::FLOAT64));
  m_next_properties.resize(m_cloud.properties.row_size());
  m_values.add_property(m_cloud.properties, !type);
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

void Point_collector::set_buffer_size(std::uint64_t size)
{
  m_buffer_size = size;
  check_limits(m_cloud.points.size());
}

void Point_collector::leave_out()
{
  if (m_are_normals_behind && m_options.with_normals)
    m_missing_rows.push_back(m_number_of_rows - 1);
}

void Point_collector::reserve(std::uint64_t count)
{
  if (m_options.on_point)
    return;
  m_cloud.points.reserve(count);
  if (m_vectors && m_options.with_normals)
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
    return leave_out();
  }
  if (!m_filter.keeps(m_file, m_cloud.properties, m_next_properties.data()))
    return leave_out();
  check_limits(m_cloud.points.size() + 1);
  Vector normal = CGAL::NULL_VECTOR;
  if (m_vectors)
    normal = unit_vector(Vector(row[3], row[4], row[5]));
  m_values.look(m_cloud.properties, m_next_properties.data());
  const Point point(row[0], row[1], row[2]);
  m_box += point.bbox();
  if (m_options.on_point) {
    m_options.on_point(point, m_cloud.properties, m_next_properties.data());
    return;
  }
  m_cloud.points.push_back(point);

  if (m_vectors && m_options.with_normals)
    m_cloud.normals.push_back(normal);
  m_cloud.properties.append(m_next_properties.data());
}

void Point_collector::set_types(const std::vector<Number_type>& types,
                                const std::vector<unsigned>& shifts)
{
  if (m_cloud.narrowed.empty())
    for (std::size_t k = 0; k < properties().size(); ++k)
      m_cloud.narrowed.push_back({properties()[k].type, shifts.empty() ? 0 : shifts[k]});
  m_cloud.properties.narrow(types, shifts);
}

void Point_collector::set_type_in_row(std::size_t index, std::optional<Number_type> type)
{
  const bool is_single = type && fits_single_precision(*type);
  m_is_single_precision = is_single && m_is_single_precision.value_or(true);
  m_cloud.coordinate_type = *m_is_single_precision ? Number_type::FLOAT32 : Number_type::FLOAT64;
  if (index < m_are_wide.size())
    m_are_wide[index] = !type;
}

void Point_collector::warn_of_rounding()
{
  std::vector<std::string> names;
  for (std::size_t axis = 0; axis < m_are_wide.size(); ++axis)
    if (m_are_wide[axis] && may_be_rounded(m_box.min(int(axis)), m_box.max(int(axis))))
      names.emplace_back(row_names[axis]);
  for (std::string& name : m_values.names_of_rounded(m_cloud.properties))
    names.push_back(std::move(name));
  for (const std::string& name : names)
    warn("numbers of " + printable(name)
         + " are rounded, as only whole ones up to 2^53 are kept exactly");
}

void Point_collector::choose_types()
{
  const std::vector<Number_type> types = m_values.types(m_cloud.properties);
  for (std::size_t k = 0; k < types.size(); ++k)
    if (types[k] != properties()[k].type)
      return set_types(types);
}

bool Point_collector::set(std::size_t index, const Type_in_file& type, std::string_view word)
{
  if (!type.wide)
    return parse_number_of(*type.number, word, property(index));
  const std::optional<double> number = type.wide->parse(word);
  if (number)
    set(index, *number);
  return number.has_value();
}

bool is_unit_length(double length)
{
  constexpr double tolerance = 0.01;
  return std::abs(length - 1) <= tolerance;
}

Vector Point_collector::unit_vector(const Vector& vector)
{
  const double length = length_of(vector);
  if (!std::isfinite(length))
    ++m_number_of_missing_vectors; // as PCL writes it where it has found none
  else if (is_unit_length(length)) {
    ++m_number_of_unit_vectors;
    look_at_direction(vector);
  } else if (length != 0) {
    ++m_number_of_other_vectors;
    return vector / length;
  }
  return vector;
}

void Point_collector::look_at_direction(const Vector& vector)
{
  for (int axis = 0; axis < 3; ++axis)
    if (vector[axis] == 1 && vector[(axis + 1) % 3] == 0 && vector[(axis + 2) % 3] == 0) {
      m_has_axes[std::size_t(axis)] = true;
      return;
    }
  m_has_directions = true;
}

/// Whether columns without names are red, green or blue in numbers of 0 and 1. A surface with
/// normals along several axes has others too, such as those against an axis, unless it is a corner
/// of a room; one with normals along one axis is flat.
bool Point_collector::look_like_colors() const
{
  constexpr std::uint64_t least = 10;   // points
  constexpr double minimum_depth = 0.1; // of what is not flat, in diagonals
  if (*m_vectors != Vectors::UNNAMED || m_has_directions || m_number_of_unit_vectors < least)
    return false;
  const auto number_of_axes = std::count(m_has_axes.begin(), m_has_axes.end(), true);
  const auto axis = int(std::find(m_has_axes.begin(), m_has_axes.end(), true) - m_has_axes.begin());
  const auto extent = [&](int k) { return m_box.max(k) - m_box.min(k); };
  return number_of_axes > 1
         || extent(axis) > minimum_depth * std::hypot(extent(0), extent(1), extent(2));
}

void Point_collector::check_vectors()
{
  constexpr std::uint64_t minimum_ratio = 19; // of unit vectors to others
  const bool is_empty = m_number_of_rows == m_cloud.number_of_dropped_points;
  const bool are_unit_vectors = m_number_of_unit_vectors > 0
                                && m_number_of_unit_vectors / minimum_ratio
                                     >= m_number_of_other_vectors;
  const bool are_normals = *m_vectors == Vectors::NAMED_BY_CALLER
                           || (*m_vectors == Vectors::NAMED_BY_FILE && is_empty)
                           || (are_unit_vectors && !look_like_colors());
  m_cloud.file_has_normals = are_normals;
  if (are_normals && m_number_of_missing_vectors > 0 && m_options.with_normals)
    note(std::to_string(m_number_of_missing_vectors)
         + " points have no normal, as theirs is not a number");
  if (are_normals && m_number_of_other_vectors > 0 && m_options.with_normals)
    warn(std::to_string(m_number_of_other_vectors)
         + " normals are no unit vectors, and are scaled to length 1");
  if (are_normals || is_empty)
    return;
  m_cloud.normals = {};
  if (!m_options.with_normals && !m_options.with_properties)
    return;
  const std::string what = are_unit_vectors ? "1 0 0, 0 1 0 or 0 0 1 alone, as colors may be,"
                                            : "no unit vectors";
  warn(*m_vectors == Vectors::UNNAMED
         ? "columns 4 to 6 are " + what + " and not taken for normals; "
             + m_options.how_to_name_columns
         : "the normals are left out, as they are no unit vectors");
}

void Point_collector::set_normals(std::vector<Vector>&& normals)
{
  m_vectors = Vectors::NAMED_BY_FILE;
  if (!m_options.with_normals)
    return;
  std::size_t end = 0;
  auto next_missing = m_missing_rows.begin();
  for (std::size_t i = 0; i < normals.size(); ++i)
    if (next_missing != m_missing_rows.end() && *next_missing == i)
      ++next_missing;
    else
      normals[end++] = normals[i];
  normals.resize(end);
  m_cloud.normals = std::move(normals);
}

void Point_collector::check_viewpoint()
{
  if (!m_cloud.viewpoint)
    return;
  // Writers turn the origin, which tells nothing, forth and back, with errors of rounding that grow
  // with the coordinates of the points
  constexpr double minimum_distance = 1e-6; // from the origin, in extents of the cloud with it
  const auto& [x, y, z] = *m_cloud.viewpoint;
  const bool has_points = m_box.xmin() <= m_box.xmax();
  const auto extent = [](double low, double high) {
    return (std::max)(high, 0.) - (std::min)(low, 0.);
  };
  const double diagonal = has_points ? std::hypot(extent(m_box.xmin(), m_box.xmax()),
                                                  extent(m_box.ymin(), m_box.ymax()),
                                                  extent(m_box.zmin(), m_box.zmax()))
                                     : 0;
  if (!(std::hypot(x, y, z) > minimum_distance * diagonal))
    m_cloud.viewpoint.reset();
}

void Point_collector::set_degrees(const std::string& reason)
{
  using Degrees = Read_options::Degrees;
  const std::string fault = m_file.path() + ": x and y are degrees of longitude and latitude, as "
                            + reason
                            + ", so that they are no lengths as heights are; project "
                              "them first (PDAL: filters.reprojection)";
  if (m_options.degrees == Degrees::REFUSE)
    throw Failure(INPUT_REFUSED, fault + ", or give --allow-degrees");
  if (m_options.degrees == Degrees::WARN && m_cloud.degrees.empty())
    m_cloud.warnings.push_back(fault);
  m_cloud.degrees = reason;
}

void Point_collector::leave_out_rest(const std::string& last, const std::string& hint)
{
  if (m_options.needs_names_of_rest)
    m_file.refuse("which of the columns are x, y and z is not told; " + how_to_name_columns()
                  + hint);
  warn("the columns behind the " + last + " are left out; " + how_to_name_columns());
}

/// Of a format without records that could tell it.
void Point_collector::warn_of_degrees()
{
  m_cloud.degrees = "it seems by its coordinates";
  if (m_options.degrees != Read_options::Degrees::ACCEPT)
    warn("x and y look like degrees of longitude and latitude, which are no lengths as heights "
         "are; project them first (PDAL: filters.reprojection)");
}

Point_cloud Point_collector::take()
{
  if (m_filter.number_left_out() > 0)
    note(std::to_string(m_filter.number_left_out())
         + " points are left out by --keep-classes or --first-returns");
  if (m_vectors)
    check_vectors();
  check_viewpoint();
  if (!m_cloud.las && look_like_degrees(m_box))
    warn_of_degrees();
  warn_of_rounding();
  choose_types();
  m_values.set_meanings(m_cloud.properties);
  return std::move(m_cloud);
}

} // namespace l0_tool
