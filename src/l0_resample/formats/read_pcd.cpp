// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Number_type.h"
#include "basis/parse_numbers.h"
#include "formats/Pcd_header.h"
#include "formats/Row_targets.h"
#include "formats/decompress_lzf.h"
#include "formats/readers.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

constexpr std::size_t max_number_of_pcd_properties = 1000;
constexpr std::array<const char*, 4> packed_channels = {"red", "green", "blue", "alpha"};

std::vector<std::string> names_of(const Pcd_header& header)
{
  std::vector<std::string> names;
  for (const Pcd_field& field : header.fields)
    names.push_back(field.name);
  return names;
}

/// PCL gives the bytes between two fields this name.
bool is_padding(const Pcd_field& field) { return field.name == "_"; }

void keep_fields(const Pcd_header& header, const std::vector<std::string>& names, Targets& targets,
                 Point_collector& collector)
{
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const Pcd_field& field = header.fields[k];
    if (targets[k] != unused || is_padding(field) || field.count == 0)
      continue;
    if (!field.is_number()
        || field.count > max_number_of_pcd_properties - collector.number_of_properties()) {
      collector.warn("the field " + printable(field.name) + " is left out: "
                     + (field.is_number() ? std::to_string(field.count) + " values"
                                          : "type " + field.type_name));
      continue;
    }
    targets[k] = first_property + collector.number_of_properties();
    for (std::size_t channel = 0; channel < field.number_of_channels; ++channel)
      collector.add_property(packed_channels[channel], Number_type::UINT8);
    if (field.number_of_channels > 0)
      continue;
    for (std::uint64_t i = 0; i < field.count; ++i)
      collector.add_property(field.count == 1 ? names[k] : names[k] + "_" + std::to_string(i),
                             field.number);
  }
}

/// Value `i` of the field; its first property is the one of index `first`.
void store(const Pcd_field& field, std::size_t i, const char* bytes, bool swap, std::size_t first,
           Point_collector& collector)
{
  if (field.number_of_channels == 0)
    return collector.set(first + i, field, bytes, swap);
  char number[4];
  copy_number(bytes, *field.number, swap, number);
  std::uint32_t color; // 0xAARRGGBB
  std::memcpy(&color, number, sizeof color);
  for (std::size_t k = 0; k < field.number_of_channels; ++k)
    *collector.property(first + k) = char(
      static_cast<unsigned char>(color >> (k == 3 ? 24 : 16 - 8 * k)));
}

/// The same of a text.
/// \returns whether `word` is a number of the type
bool store(const Pcd_field& field, std::size_t i, std::string_view word, std::size_t first,
           Point_collector& collector)
{
  if (field.number_of_channels == 0)
    return collector.set(first + i, field, word);
  char number[4];
  if (!parse_number_of(*field.number, word, number))
    return false;
  store(field, i, number, false, first, collector);
  return true;
}

/// A value that is not `unused`.
void take_binary_value(const Pcd_field& field, std::size_t i, const char* bytes, std::size_t target,
                       Point_row& row, Point_collector& collector)
{
  const bool swap = !is_little_endian_machine();
  if (target < unused)
    row[target] = field.number_at(bytes, swap);
  else
    store(field, i, bytes, swap, target - first_property, collector);
}

void read_binary_row(Input_file& file, const Pcd_header& header, const Targets& targets,
                     Point_row& row, Point_collector& collector)
{
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const Pcd_field& field = header.fields[k];
    if (targets[k] == unused) {
      file.skip_bytes(field.count * field.size);
      continue;
    }
    for (std::size_t i = 0; i < std::size_t(field.count); ++i)
      take_binary_value(field, i, file.read_bytes(std::size_t(field.size)), targets[k], row,
                        collector);
  }
}

std::uint64_t read_size(Input_file& file) { return little_endian_at(file.read_bytes(4), 4); }

/// Of compressed data: all values of the first field come first, then those of the next one.
/// \returns the fields that are there: PCL leaves padding out
std::vector<std::size_t> find_columns(const Input_file& file, const Pcd_header& header,
                                      std::uint64_t size)
{
  const auto is_size = [&](std::uint64_t row_size) {
    return header.number_of_points == 0
             ? size == 0
             : size % header.number_of_points == 0 && size / header.number_of_points == row_size;
  };
  std::vector<std::size_t> all, columns;
  std::uint64_t row_size = 0;
  for (std::size_t k = 0; k < header.fields.size(); ++k) {
    all.push_back(k);
    if (is_padding(header.fields[k]))
      continue;
    columns.push_back(k);
    row_size += header.fields[k].count * header.fields[k].size;
  }
  if (!is_size(row_size) && !is_size(header.row_size()))
    file.refuse(std::to_string(size) + " bytes before compression are announced for "
                + std::to_string(header.number_of_points) + " points of " + std::to_string(row_size)
                + " bytes");
  return is_size(row_size) ? columns : all;
}

void read_compressed_rows(Input_file& file, const Pcd_header& header, const Targets& targets,
                          Point_collector& collector)
{
  const std::uint64_t compressed_size = read_size(file), size = read_size(file);
  const std::vector<std::size_t> columns = find_columns(file, header, size);
  collector.announce_buffer(header.number_of_points, size);
  const std::vector<char> bytes = decompress_lzf(file, compressed_size, size);
  collector.reserve(header.number_of_points);

  Point_row row = {};
  for (std::uint64_t point = 0; point < header.number_of_points; ++point) {
    const char* column = bytes.data();
    for (const std::size_t k : columns) {
      const Pcd_field& field = header.fields[k];
      if (targets[k] != unused)
        for (std::size_t i = 0; i < std::size_t(field.count); ++i)
          take_binary_value(
            field, i,
            column + (point * field.values_in_column + field.first_in_column + i) * field.size,
            targets[k], row, collector);
      if (field.first_in_column + field.count == field.values_in_column)
        column += header.number_of_points * field.values_in_column * field.size;
    }
    collector.add(row);
  }
}

void read_ascii_row(Input_file& file, const Pcd_header& header, const Targets& targets,
                    Point_row& row, Point_collector& collector)
{
  std::string_view line;
  for (std::string_view rest; next_word(rest).empty(); rest = line) {
    const std::optional<std::string_view> next = file.read_line();
    if (!next)
      file.refuse("the file ends here, where another row is expected");
    line = *next;
  }
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const Pcd_field& field = header.fields[k];
    for (std::uint64_t i = 0; i < field.count; ++i) {
      const std::string_view word = next_word(line);
      if (word.empty())
        file.refuse("the row ends before its field " + printable(field.name));
      if (targets[k] == unused)
        continue;
      if (targets[k] >= first_property) {
        if (!store(field, std::size_t(i), word, targets[k] - first_property, collector))
          file.refuse(printable(word) + " is not a number of the type of " + printable(field.name));
        continue;
      }
      const std::optional<double> number = parse_number<double>(word);
      if (!number)
        file.refuse(no_number(word));
      row[targets[k]] = *number;
    }
  }
  if (!next_word(line).empty())
    file.refuse("the row has more than its " + std::to_string(header.number_of_values())
                + " values");
}

void read_rows(Input_file& file, const Pcd_header& header, const Targets& targets,
               Point_collector& collector)
{
  const bool is_binary = header.encoding == Pcd_header::Encoding::BINARY;
  // In text a digit and a blank for each value, but for the end of the last line
  collector.announce(header.number_of_points,
                     is_binary ? header.row_size() : 2 * header.number_of_values() - 1);
  Point_row row = {};
  for (std::uint64_t i = 0; i < header.number_of_points; ++i) {
    if (is_binary)
      read_binary_row(file, header, targets, row, collector);
    else
      read_ascii_row(file, header, targets, row, collector);
    collector.add(row);
  }
}

} // namespace

void read_pcd(Input_file& file, Point_collector& collector)
{
  const Pcd_header header = read_pcd_header(file);
  const std::vector<std::string> own_names = names_of(header), names = usual_names(own_names);
  const auto reason_against = [&](std::size_t k) -> std::string {
    const Pcd_field& field = header.fields[k];
    return field.count != 1     ? "one of " + std::to_string(field.count) + " values"
           : !field.is_number() ? "of type " + field.type_name
                                : "";
  };
  Targets targets = find_targets(file, own_names, names, "field", reason_against);
  if (have_normals(targets))
    collector.set_vectors(Vectors::NAMED_BY_FILE);
  if (header.viewpoint)
    collector.set_viewpoint(*header.viewpoint);
  else if (header.has_viewpoint)
    collector.warn("VIEWPOINT does not begin with three numbers, so it is not used");
  if (header.is_organized)
    collector.set_organized();
  for (std::size_t k = 0; k < targets.size(); ++k)
    if (targets[k] < unused)
      collector.set_type_in_row(targets[k], header.fields[k].number);
  if (collector.wants_properties())
    keep_fields(header, names, targets, collector);

  if (header.encoding == Pcd_header::Encoding::COMPRESSED_BINARY)
    read_compressed_rows(file, header, targets, collector);
  else
    read_rows(file, header, targets, collector);
  warn_of_rest(file, "point", collector);
}

} // namespace l0_tool
