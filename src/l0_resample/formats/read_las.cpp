// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/readers.h"

#include "basis/parse_numbers.h"
#include "formats/Las_header.h"
#include "formats/degrees.h"
#include "formats/usual_names.h"

#include <CGAL/L0_resampling/Near_points.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

/// What is made of the bytes of a point.
struct Point_plan
{
  std::vector<Las_field> properties;
  std::vector<Las_field> normal; ///< its three coordinates, or nothing
  Las_field flags;
};

/// Of extra bytes.
std::vector<Las_field> find_normal(const std::vector<Las_field>& fields)
{
  std::vector<std::string> own_names;
  for (const Las_field& field : fields)
    own_names.push_back(field.name);
  const std::vector<std::string> names = usual_names(own_names);
  std::vector<Las_field> normal;
  for (std::size_t axis = 3; axis < row_names.size(); ++axis)
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (names[k] == row_names[axis] && !is_name_of_other(own_names, names, k)) {
        normal.push_back(fields[k]);
        break; // the first one of that name
      }
  const auto is_floating = [](const Las_field& f) { return f.kind == Las_field::Kind::FLOATING; };
  if (normal.size() != 3 || !std::all_of(normal.begin(), normal.end(), is_floating))
    return {};
  return normal;
}

/// The extra bytes that lie within a point.
std::vector<Las_field> usable_extra_fields(const Las_header& header, Point_collector& collector)
{
  const std::size_t room = header.point_size - las_point_size(header.origin.point_format);
  const auto warn = [&](const std::string& what) {
    if (collector.wants_properties())
      collector.warn(what);
  };
  if (header.extra.size > room) {
    warn("the extra bytes are left out: " + std::to_string(header.extra.size)
         + " of them are described, but a point has " + std::to_string(room));
    return {};
  }
  if (header.extra.size < room)
    warn(std::to_string(room - header.extra.size)
         + " bytes of each point are left out, of which nothing says what they are");
  return header.extra.fields;
}

Point_plan plan_points(const Las_header& header, Point_collector& collector)
{
  Point_plan plan;
  const std::vector<Las_field> fields = las_fields(header.origin.point_format);
  plan.flags = *find_las_field(fields, "classification_flags");
  const std::vector<Las_field> extra = usable_extra_fields(header, collector);
  plan.normal = find_normal(extra);
  if (!plan.normal.empty())
    collector.set_vectors(Vectors::NAMED_BY_FILE);
  if (!collector.wants_properties())
    return plan;
  // Where both have a name, the format's field held less than what was to be written
  for (const Las_field& field : fields)
    if (!find_las_field(extra, field.name))
      plan.properties.push_back(field);
  for (const Las_field& field : extra)
    if (!find_las_field(plan.normal, field.name))
      plan.properties.push_back(field);
  for (const Las_field& field : plan.properties)
    collector.add_property(field.name,
                           field.is_wide_integer() ? std::nullopt : std::make_optional(field.type));
  return plan;
}

/// The channels of a color in 16 bits.
class Color_channels
{
  std::vector<std::size_t> m_channels; // among the properties
  // Of all values: the bits of both bytes, and those in which these differ
  unsigned m_high = 0, m_low = 0, m_difference = 0;

public:
  explicit Color_channels(const std::vector<Las_field>& fields)
  {
    for (std::size_t k = 0; k < fields.size(); ++k)
      if (fields[k].type == Number_type::UINT16
          && CGAL::L0_resampling::is_color_channel(fields[k].name))
        m_channels.push_back(k);
  }

  void add(const std::vector<Las_field>& fields, const char* point)
  {
    constexpr unsigned bits_of_byte = 8, low_byte = 255;
    for (const std::size_t k : m_channels) {
      const auto value = unsigned(fields[k].value(point));
      const unsigned high = value >> bits_of_byte, low = value & low_byte;
      m_high |= high;
      m_low |= low;
      m_difference |= high ^ low;
    }
  }

  /// After the last point. Many programs write bytes as they are, without scaling them.
  Las_colors colors() const
  {
    if (m_high == 0)
      return m_low == 0 ? Las_colors::NONE : Las_colors::BYTES;
    return m_low == 0 || m_difference == 0 ? Las_colors::SCALED_BYTES : Las_colors::FINE;
  }

  /// Makes bytes of them.
  void narrow(Point_collector& collector) const
  {
    if (m_channels.empty())
      return;
    // Exact for files that have a byte times 256, and for those that have it times 257
    const unsigned shift = m_high > 0 ? 8 : 0;
    std::vector<Number_type> types;
    for (const Property& property : collector.properties())
      types.push_back(property.type);
    std::vector<unsigned> shifts(types.size(), 0);
    for (const std::size_t k : m_channels) {
      types[k] = Number_type::UINT8;
      shifts[k] = shift;
    }
    collector.set_types(types, shifts);
  }
};

Point_row row_of(const char* point, const Las_origin& origin, const std::vector<Las_field>& normal)
{
  Point_row row = {};
  for (std::size_t axis = 0; axis < 3; ++axis)
    row[axis] = decode(point + 4 * axis, Number_type::INT32, !is_little_endian_machine())
                  * origin.scale[axis]
                + origin.offset[axis];
  for (std::size_t axis = 0; axis < normal.size(); ++axis)
    row[3 + axis] = normal[axis].value(point);
  return row;
}

void read_rows(Input_file& file, const Las_header& header, Point_collector& collector)
{
  const Point_plan plan = plan_points(header, collector);
  collector.announce(header.number_of_points, header.point_size);
  Color_channels channels(plan.properties);
  std::uint64_t number_withheld = 0;
  for (std::uint64_t i = 0; i < header.number_of_points; ++i) {
    const char* const point = file.read_bytes(header.point_size);
    if ((unsigned(plan.flags.value(point)) & las_withheld) != 0) {
      ++number_withheld;
      continue;
    }
    for (std::size_t k = 0; k < plan.properties.size(); ++k)
      encode(plan.properties[k].value(point), plan.properties[k].type, collector.property(k));
    channels.add(plan.properties, point);
    collector.add(row_of(point, header.origin, plan.normal));
  }
  collector.set_las_colors(channels.colors());
  if (!collector.wants_wide_colors())
    channels.narrow(collector);
  if (number_withheld > 0)
    collector.note(std::to_string(number_withheld)
                   + " points are left out, which the file has flagged as withheld");
}

/// Behind the points, where the file is a pipe or compressed.
void read_late_records(Input_file& file, Las_header& header, Point_collector& collector)
{
  const std::size_t number_of_fields = header.extra.fields.size();
  file.skip_bytes(header.first_extended_record - file.position());
  read_las_extended_records(file, header);
  if (header.extra.fields.size() > number_of_fields && collector.wants_properties())
    collector.warn("what the extra bytes are stands behind the points, where it comes too late: "
                   "a file that is no pipe and not compressed is read with them");
}

/// As soon as the records are read.
void check_system(const Las_header& header, Point_collector& collector)
{
  const Horizontal_system system = horizontal_system_of(header.origin);
  if (system.is_geographic)
    collector.set_degrees(system.told_by);
}

/// After the last point, where the records have not told it: some name a projection that the
/// coordinates have not.
void check_coordinates(const Las_header& header, Point_collector& collector)
{
  const Horizontal_system system = horizontal_system_of(header.origin);
  if (!system.is_geographic && look_like_degrees(collector.box(), header.origin))
    collector.set_degrees("its coordinates tell"
                          + (system.is_told ? ", whatever " + system.told_by : ""));
}

} // namespace

void read_las(Input_file& file, Point_collector& collector)
{
  Las_header header = read_las_header(file);
  const auto read_records = [&]() { read_las_extended_records(file, header); };
  const bool has_records = header.number_of_extended_records > 0;
  const bool is_complete = !has_records
                           || file.look_ahead(header.first_extended_record, read_records);
  check_system(header, collector);
  file.skip_bytes(header.offset_to_points - file.position());
  read_rows(file, header, collector);
  if (!is_complete) {
    read_late_records(file, header, collector);
    check_system(header, collector);
  }
  check_coordinates(header, collector);
  collector.set_las_origin(header.origin);

  if (!collector.wants_properties())
    return;
  const bool has_waveforms = has_las_waveforms(header.origin.point_format);
  if (has_waveforms)
    collector.note("the waveforms of the points are left out");
  if (header.number_of_long_records > 0)
    collector.warn("a record of the coordinate system is left out, as it is longer than "
                   + std::to_string(Las_record::max_data_size) + " bytes");
  if (!has_records && !has_waveforms && file.bytes_left() > std::uint64_t(0))
    collector.warn(std::to_string(*file.bytes_left())
                   + " bytes after the last point are not looked at");
}

} // namespace l0_tool
