// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Input_properties.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"

#include <CGAL/L0_resampling/Near_points.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace l0_tool {
namespace {

struct Integers
{
  Number_type type;
  double lowest, highest;
};

constexpr Integers integer_types[] = {
  {Number_type::UINT8, 0, 255},         {Number_type::INT8, -128, 127},
  {Number_type::UINT16, 0, 65535},      {Number_type::INT16, -32768, 32767},
  {Number_type::UINT32, 0, 4294967295}, {Number_type::INT32, -2147483648, 2147483647}};

const Integers* find_integers(Number_type type)
{
  for (const Integers& integers : integer_types)
    if (integers.type == type)
      return &integers;
  return nullptr;
}

/// The smallest type that holds the numbers of both.
Number_type type_for_both(Number_type a, Number_type b)
{
  if (a == b)
    return a;
  const Integers *const one = find_integers(a), *const other = find_integers(b);
  if (one && other) {
    for (const Integers& integers : integer_types)
      if (integers.lowest <= (std::min)(one->lowest, other->lowest)
          && integers.highest >= (std::max)(one->highest, other->highest))
        return integers.type;
    return Number_type::FLOAT64;
  }
  return fits_single_precision(a) && fits_single_precision(b) ? Number_type::FLOAT32
                                                              : Number_type::FLOAT64;
}

Input_property* find_property(std::vector<Input_property>& properties, const std::string& name)
{
  for (Input_property& property : properties)
    if (property.name == name)
      return &property;
  return nullptr;
}

[[noreturn]] void refuse(const std::string& input, const std::string& name,
                         const std::string& other)
{
  throw Failure(INPUT_REFUSED, input + ": the points have no property " + printable(name)
                                 + ", as those of " + other
                                 + " have: with --as-one all files need the same ones");
}

bool is_same_system(const Las_origin& a, const Las_origin& b)
{
  return std::equal(a.coordinate_system.begin(), a.coordinate_system.end(),
                    b.coordinate_system.begin(), b.coordinate_system.end(),
                    [](const Las_record& one, const Las_record& other) {
                      return one.id == other.id && one.data == other.data;
                    });
}

void add_las_origin(const Input_properties& other, Input_properties& all)
{
  const bool tells_system = !other.las->coordinate_system.empty();
  if (!all.las || (tells_system && all.have_one_system && all.las->coordinate_system.empty()))
    all.las = other.las;
  else if (tells_system && all.have_one_system && !is_same_system(*all.las, *other.las)) {
    all.have_one_system = false;
    all.las->coordinate_system.clear();
    all.warnings.push_back(other.input
                           + ": has another coordinate system than files before it, "
                             "so that the result tells none");
  }
}

void warn_of_types_of_colors(std::vector<std::string>& warnings)
{
  const std::string warning =
    "some inputs have colors in another type of numbers than others, such "
    "as bytes beside 16 bits: all are kept as they are, not scaled";
  if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
    warnings.push_back(warning);
}

void write_string(const std::string& text, Task_file_writer& file)
{
  file.write_all(std::vector<char>(text.begin(), text.end()));
}

std::string read_string(Task_file& file)
{
  std::vector<char> text;
  file.read_all(text);
  return {text.begin(), text.end()};
}

void write_type(Number_type type, Task_file_writer& file) { file.write(std::uint8_t(type)); }

Number_type read_type(Task_file& file)
{
  return Number_type(file.read_number_below(std::uint8_t(number_of_types)));
}

void write_las_origin(const Las_origin& las, Task_file_writer& file)
{
  file.write(las.minor_version);
  file.write(las.point_format);
  file.write(las.global_encoding);
  file.write(las.scale);
  file.write(las.offset);
  file.write(std::uint64_t(las.coordinate_system.size()));
  for (const Las_record& record : las.coordinate_system) {
    write_string(record.user_id, file);
    file.write(record.id);
    write_string(record.description, file);
    write_string(record.data, file);
  }
}

Las_origin read_las_origin(Task_file& file)
{
  Las_origin las;
  las.minor_version = file.read<unsigned>();
  las.point_format = file.read<unsigned>();
  las.global_encoding = file.read<std::uint16_t>();
  las.scale = file.read<std::array<double, 3>>();
  las.offset = file.read<std::array<double, 3>>();
  for (std::uint64_t n = file.read<std::uint64_t>(); n > 0; --n) {
    Las_record record;
    record.user_id = read_string(file);
    record.id = file.read<std::uint16_t>();
    record.description = read_string(file);
    record.data = read_string(file);
    las.coordinate_system.push_back(std::move(record));
  }
  return las;
}

} // namespace

Property_table Input_properties::table() const
{
  Property_table table;
  for (const Input_property& property : properties) {
    table.add_property(property.name, property.type);
    table.set_meaning(table.properties().size() - 1, property.is_measured, property.no_data);
  }
  return table;
}

Input_properties properties_of_input(const std::string& input, const Point_cloud& cloud,
                                     bool has_points)
{
  Input_properties result;
  result.warnings = cloud.warnings;
  if (!has_points)
    return result;
  result.input = input;
  result.las = cloud.las;
  if (cloud.las_colors == Las_colors::BYTES)
    result.inputs_of_bytes = {input};
  result.has_scaled_bytes = cloud.las_colors == Las_colors::SCALED_BYTES;
  result.has_fine_colors = cloud.las_colors == Las_colors::FINE;
  for (std::size_t k = 0; k < cloud.properties.properties().size(); ++k) {
    const Property& property = cloud.properties.properties()[k];
    if (find_property(result.properties, property.name))
      continue; // as no reader of the result could tell which it is
    const bool is_narrowed = k < cloud.narrowed.size();
    const Number_type given = is_narrowed ? cloud.narrowed[k].type : property.type;
    result.properties.push_back({property.name,
                                 property.type,
                                 {{given, is_narrowed ? cloud.narrowed[k].shift : 0}},
                                 property.is_measured,
                                 property.no_data});
  }
  return result;
}

void add_input(const Input_properties& other, Input_properties& all)
{
  all.warnings.insert(all.warnings.end(), other.warnings.begin(), other.warnings.end());
  if (other.input.empty())
    return;
  if (all.input.empty()) {
    std::vector<std::string> warnings = std::move(all.warnings);
    all = other;
    all.warnings = std::move(warnings);
    return;
  }
  std::vector<Input_property> properties = other.properties;
  for (Input_property& property : all.properties) {
    const Input_property* const same = find_property(properties, property.name);
    if (!same)
      refuse(other.input, property.name, all.input);
    if (property.type != same->type && CGAL::L0_resampling::is_color_channel(property.name))
      warn_of_types_of_colors(all.warnings);
    property.type = type_for_both(property.type, same->type);
    for (const auto& [type, shift] : same->shifts) {
      const auto [known, is_new] = property.shifts.emplace(type, shift);
      known->second = (std::max)(known->second, shift);
    }
    property.is_measured = property.is_measured || same->is_measured;
    std::vector<double>& no_data = property.no_data;
    for (const double value : same->no_data)
      if (std::find(no_data.begin(), no_data.end(), value) == no_data.end())
        no_data.push_back(value);
  }
  for (const Input_property& property : properties)
    if (!find_property(all.properties, property.name))
      refuse(all.input, property.name, other.input);
  if (other.las)
    add_las_origin(other, all);
  all.inputs_of_bytes.insert(all.inputs_of_bytes.end(), other.inputs_of_bytes.begin(),
                             other.inputs_of_bytes.end());
  all.has_scaled_bytes = all.has_scaled_bytes || other.has_scaled_bytes;
  all.has_fine_colors = all.has_fine_colors || other.has_fine_colors;
}

void choose_inputs_of_bytes(Input_properties& all)
{
  if (all.has_fine_colors)
    for (const std::string& input : all.inputs_of_bytes)
      all.warnings.push_back(input
                             + ": the colors are at most 255 where those of other files have 16 "
                               "bits: they are taken for dark ones; read a file of bytes alone");
  if (all.has_fine_colors || !all.has_scaled_bytes)
    all.inputs_of_bytes.clear();
}

Row_converter::Row_converter(const Input_properties& all, const std::string& input)
  : m_all(all), m_input(input), m_row(all.table().row_size())
{}

void Row_converter::find_columns(const Property_table& given)
{
  const Property_table table = m_all.table();
  const bool is_of_bytes = std::find(m_all.inputs_of_bytes.begin(), m_all.inputs_of_bytes.end(),
                                     m_input)
                           != m_all.inputs_of_bytes.end();
  for (std::size_t k = 0; k < m_all.properties.size(); ++k) {
    const Input_property& property = m_all.properties[k];
    for (const Property& from : given.properties()) {
      if (from.name != property.name)
        continue;
      const auto shift = property.shifts.find(from.type);
      const bool is_byte = is_of_bytes && from.type == Number_type::UINT16
                           && CGAL::L0_resampling::is_color_channel(from.name);
      if (shift != property.shifts.end())
        m_columns.push_back({from, table.properties()[k], is_byte ? 257u : 1u, shift->second});
      break;
    }
  }
  if (m_columns.size() != m_all.properties.size())
    throw Failure(INPUT_REFUSED, m_input + ": has changed since its points were counted");
  m_is_complete = true;
}

const std::vector<char>& Row_converter::operator()(const Property_table& given, const char* row)
{
  if (!m_is_complete)
    find_columns(given);
  for (const Column& column : m_columns)
    encode(shifted(column.factor * decode(row + column.from.offset, column.from.type, false),
                   column.shift),
           column.to.type, m_row.data() + column.to.offset);
  return m_row;
}

void write_properties(const Input_properties& properties, Task_file_writer& file)
{
  write_string(properties.input, file);
  file.write(std::uint64_t(properties.properties.size()));
  for (const Input_property& property : properties.properties) {
    write_string(property.name, file);
    write_type(property.type, file);
    file.write(std::uint64_t(property.shifts.size()));
    for (const auto& [type, shift] : property.shifts) {
      write_type(type, file);
      file.write(shift);
    }
    file.write(property.is_measured);
    file.write_all(property.no_data);
  }
  file.write(properties.have_one_system);
  file.write(std::uint64_t(properties.inputs_of_bytes.size()));
  for (const std::string& input : properties.inputs_of_bytes)
    write_string(input, file);
  file.write(properties.has_scaled_bytes);
  file.write(properties.has_fine_colors);
  file.write(properties.las.has_value());
  if (properties.las)
    write_las_origin(*properties.las, file);
  file.write(std::uint64_t(properties.warnings.size()));
  for (const std::string& warning : properties.warnings)
    write_string(warning, file);
}

Input_properties read_properties(Task_file& file)
{
  Input_properties properties;
  properties.input = read_string(file);
  for (std::uint64_t n = file.read<std::uint64_t>(); n > 0; --n) {
    Input_property property;
    property.name = read_string(file);
    property.type = read_type(file);
    for (std::uint64_t m = file.read<std::uint64_t>(); m > 0; --m) {
      const Number_type type = read_type(file);
      property.shifts[type] = file.read<unsigned>();
    }
    property.is_measured = file.read<bool>();
    file.read_all(property.no_data);
    properties.properties.push_back(std::move(property));
  }
  properties.have_one_system = file.read<bool>();
  for (std::uint64_t n = file.read<std::uint64_t>(); n > 0; --n)
    properties.inputs_of_bytes.push_back(read_string(file));
  properties.has_scaled_bytes = file.read<bool>();
  properties.has_fine_colors = file.read<bool>();
  if (file.read<bool>())
    properties.las = read_las_origin(file);
  for (std::uint64_t n = file.read<std::uint64_t>(); n > 0; --n)
    properties.warnings.push_back(read_string(file));
  return properties;
}

} // namespace l0_tool
