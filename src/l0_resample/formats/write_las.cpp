// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/write_las.h"

#include "basis/Failure.h"
#include "basis/Number_type.h"
#include "basis/parse_numbers.h"
#include "formats/Las_extra_bytes.h"
#include "formats/Las_header.h"
#include "formats/Las_lattice.h"
#include "formats/Las_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace l0_tool {
namespace {

constexpr std::size_t max_returns = 15, max_old_returns = 5;

void append_padded(std::string_view text, std::size_t size, std::string& bytes)
{
  const std::string_view part = text.substr(0, size);
  bytes += part;
  bytes.append(size - part.size(), '\0');
}

/// What the header says of all points.
struct Summary
{
  std::array<double, 3> low = {}, high = {};
  std::array<std::uint64_t, max_returns> by_return = {};
};

Summary summary_of(const Point_rows& rows, const Las_layout& layout, const Las_lattice& lattice)
{
  Summary summary;
  const Las_column* const returns = layout.find_column("return_number");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double coordinate = lattice.coordinate(lattice.integer(rows.point(i)[int(axis)], axis),
                                                   axis);
      double &low = summary.low[axis], &high = summary.high[axis];
      low = i == 0 ? coordinate : (std::min)(low, coordinate);
      high = i == 0 ? coordinate : (std::max)(high, coordinate);
    }
    const double number = returns ? rows.value(i, returns->property) : 1;
    if (number >= 1) // else nobody counted
      ++summary.by_return[std::size_t(number) - 1];
  }
  return summary;
}

/// Of the environment variable SOURCE_DATE_EPOCH: the day of the year, from 1 on, and the year; 0
/// and 0 without it.
std::array<std::uint16_t, 2> creation_day()
{
  const char* const text = std::getenv("SOURCE_DATE_EPOCH");
  const std::optional<std::int64_t> seconds = parse_number<std::int64_t>(text ? text : "");
  constexpr std::int64_t year_10000 = 253402300800;
  if (!seconds || *seconds < 0 || *seconds >= year_10000)
    return {0, 0};
  std::int64_t day = *seconds / 86400, year = 1970;
  const auto days_of_year = [&] {
    return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0) ? 366 : 365;
  };
  for (; day >= days_of_year(); ++year)
    day -= days_of_year();
  return {std::uint16_t(day + 1), std::uint16_t(year)};
}

std::string record_bytes(const Las_record& record)
{
  std::string bytes(2, '\0');
  append_padded(record.user_id, 16, bytes);
  append_little_endian<std::uint16_t>(record.id, bytes);
  append_little_endian<std::uint16_t>(std::uint16_t(record.data.size()), bytes);
  append_padded(record.description, 32, bytes);
  return bytes + record.data;
}

std::vector<Las_record> records_of(const Las_layout& layout,
                                   const std::optional<Las_origin>& origin)
{
  std::vector<Las_record> records;
  if (origin)
    records = origin->coordinate_system;
  std::string data;
  if (layout.has_normals)
    for (const std::string_view name : las_normal_names)
      data += las_extra_bytes_record(name, Number_type::FLOAT32);
  for (const Output_column& column : layout.extra)
    data += las_extra_bytes_record(column.name, column.type);
  if (!data.empty())
    records.push_back({std::string(las_specification), std::uint16_t(las_extra_bytes_id),
                       "normals and properties", data});
  return records;
}

std::uint16_t global_encoding(const Las_layout& layout, const std::optional<Las_origin>& origin)
{
  if (!origin)
    return Las_origin::wkt; // which points of format 6 and above ask for
  const auto kept = std::uint16_t(layout.minor_version < 4
                                    ? Las_origin::standard_time
                                    : Las_origin::standard_time | Las_origin::synthetic_returns
                                        | Las_origin::wkt);
  return origin->global_encoding & kept;
}

std::string header_of(const Point_rows& rows, const Las_layout& layout, const Las_lattice& lattice,
                      const std::vector<Las_record>& records,
                      const std::optional<Las_origin>& origin)
{
  const Summary summary = summary_of(rows, layout, lattice);
  const std::size_t size = las_header_sizes[layout.minor_version];
  std::size_t offset_to_points = size;
  for (const Las_record& record : records)
    offset_to_points += las_record_head_size + record.data.size();

  std::string bytes = "LASF";
  const auto append_short = [&](std::uint16_t number) {
    append_little_endian<std::uint16_t>(number, bytes);
  };
  const auto append_int = [&](std::uint64_t number) {
    append_little_endian<std::uint32_t>(std::uint32_t(number), bytes);
  };
  const auto append_double = [&](double number) {
    append_little_endian<std::uint64_t>(number, bytes);
  };
  append_short(0); // no source
  append_short(global_encoding(layout, origin));
  bytes.append(16, '\0'); // no project
  bytes += {'\1', char(layout.minor_version)};
  append_padded("OTHER", 32, bytes);
  append_padded("l0_resample " L0_RESAMPLE_VERSION, 32, bytes);
  for (const std::uint16_t number : creation_day())
    append_short(number);
  append_short(std::uint16_t(size));
  append_int(offset_to_points);
  append_int(records.size());
  bytes += char(layout.point_format);
  append_short(std::uint16_t(layout.point_size()));
  const bool is_old = layout.point_format < 6; // whose numbers stand here
  append_int(is_old ? rows.size() : 0);
  for (std::size_t k = 0; k < max_old_returns; ++k)
    append_int(is_old ? summary.by_return[k] : 0);
  for (const double scale : lattice.scale)
    append_double(scale);
  for (const double offset : lattice.offset)
    append_double(offset);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    append_double(summary.high[axis]);
    append_double(summary.low[axis]);
  }
  if (layout.minor_version < 4)
    return bytes;
  bytes.append(8 + 8 + 4, '\0'); // neither waveforms nor extended records
  append_little_endian<std::uint64_t>(std::uint64_t(rows.size()), bytes);
  for (const std::uint64_t number : summary.by_return)
    append_little_endian<std::uint64_t>(number, bytes);
  return bytes;
}

/// The bytes of point `i`.
class Point_writer
{
  const Point_rows& m_rows;
  const Las_layout& m_layout;
  const Las_lattice& m_lattice;
  std::vector<Las_field> m_single_return; // fields that say so, unless properties have their names

public:
  Point_writer(const Point_rows& rows, const Las_layout& layout, const Las_lattice& lattice)
    : m_rows(rows), m_layout(layout), m_lattice(lattice)
  {
    for (const Las_field& field : layout.fields)
      if ((field.name == "return_number" || field.name == "number_of_returns")
          && !layout.find_column(field.name))
        m_single_return.push_back(field);
  }

  void write(std::size_t i, std::string& bytes) const
  {
    bytes.clear();
    for (std::size_t axis = 0; axis < 3; ++axis)
      append_little_endian<std::uint32_t>(m_lattice.integer(m_rows.point(i)[int(axis)], axis),
                                          bytes);
    bytes.resize(las_point_size(m_layout.point_format), '\0');
    for (const Las_field& field : m_single_return)
      field.set_value(1, bytes.data());
    for (const Las_column& column : m_layout.columns)
      column.field.set_value(m_rows.value(i, column.property) * column.factor, bytes.data());
    if (m_layout.has_normals)
      for (int axis = 0; axis < 3; ++axis)
        append_little_endian<std::uint32_t>(float(m_rows.normal(i)[axis]), bytes);
    const char* const properties = m_rows.property_row(i);
    for (const Output_column& column : m_layout.extra)
      for (const std::size_t byte : column.bytes)
        bytes += properties[byte];
  }
};

void check_finite(const std::string& path, const Point_rows& rows)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (!std::isfinite(rows.point(i)[axis]))
        throw Failure(OUTPUT_NOT_WRITTEN,
                      path + ": LAS cannot hold a coordinate that is not finite, as of point "
                        + std::to_string(i));
}

} // namespace

std::vector<std::string> write_las(Output_file& file, const std::string& path,
                                   const Point_rows& rows, bool has_normals,
                                   const std::optional<Las_origin>& origin)
{
  check_finite(path, rows);
  const Las_layout layout = choose_las_layout(rows, has_normals, origin);
  const Las_lattice lattice = choose_las_lattice(rows, origin);
  const std::vector<Las_record> records = records_of(layout, origin);
  file.write(header_of(rows, layout, lattice, records, origin));
  for (const Las_record& record : records)
    file.write(record_bytes(record));
  const Point_writer writer(rows, layout, lattice);
  std::string bytes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    writer.write(i, bytes);
    file.write(bytes);
  }
  return layout.left_out;
}

std::uint64_t maximum_las_size(std::uint64_t number_of_points, const Property_table& properties,
                               const std::optional<Las_origin>& origin)
{
  constexpr std::size_t largest_point_format = 8, number_of_normal_coordinates = 3;
  std::uint64_t size = las_header_sizes.back() + las_record_head_size
                       + las_extra_bytes_size
                           * (number_of_normal_coordinates + properties.properties().size());
  if (origin)
    for (const Las_record& record : origin->coordinate_system)
      size += las_record_head_size + record.data.size();
  return size
         + number_of_points
             * (las_point_size(largest_point_format) + number_of_normal_coordinates * sizeof(float)
                + properties.row_size());
}

} // namespace l0_tool
