// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/parse_numbers.h"
#include "formats/Ply_header.h"
#include "formats/Row_targets.h"
#include "formats/readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

void keep_properties(const Ply_element& vertex, Targets& targets, Point_collector& collector)
{
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const Ply_property& property = vertex.properties[k];
    if (targets[k] != unused)
      continue;
    if (property.is_list)
      collector.warn("the lists " + printable(property.name) + " of the vertices are left out");
    else
      targets[k] = first_property + collector.add_property(property.name, property.type);
  }
}

Targets find_targets(const Input_file& file, const Ply_element& vertex)
{
  static constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};
  Targets targets;
  std::array<bool, 6> found = {};
  for (const Ply_property& property : vertex.properties) {
    const std::size_t target = std::size_t(std::find(names.begin(), names.end(), property.name)
                                           - names.begin());
    targets.push_back(target);
    if (target == unused)
      continue;
    if (property.is_list)
      file.refuse("the property " + property.name + " of the vertices is a list");
    if (found[target])
      file.refuse("the vertices have two properties " + property.name);
    found[target] = true;
  }
  for (std::size_t k = 0; k < 3; ++k)
    if (!found[k])
      file.refuse("the vertices have no property " + std::string(names[k]));
  if (!found[3] || !found[4] || !found[5])
    std::replace_if(
      targets.begin(), targets.end(), [](std::size_t target) { return target >= 3; }, unused);
  return targets;
}

bool is_single_precision(const Ply_element& vertex, const Targets& targets)
{
  for (std::size_t k = 0; k < targets.size(); ++k)
    if (targets[k] < unused && !fits_single_precision(vertex.properties[k].type))
      return false;
  return true;
}

class Binary_rows
{
  Input_file& m_file;
  bool m_swap;

public:
  Binary_rows(Input_file& file, Ply_header::Encoding encoding)
    : m_file(file),
      m_swap((encoding == Ply_header::Encoding::LITTLE_ENDIAN_BINARY) != is_little_endian_machine())
  {}

  std::uint64_t least_row_size(const Ply_element& element) const
  {
    return element.least_binary_size();
  }

  /// Entry k of `row` becomes the property whose target is k; `row` has one entry for `unused`.
  void read(const Ply_element& element, const Targets& targets, std::array<double, unused + 1>& row,
            Point_collector& collector)
  {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Ply_property& property = element.properties[k];
      if (property.is_list) {
        skip_list(property);
        continue;
      }
      const char* bytes = m_file.read_bytes(size_of(property.type));
      if (targets[k] >= first_property)
        copy_number(bytes, property.type, m_swap, collector.property(targets[k] - first_property));
      else
        row[targets[k]] = decode(bytes, property.type, m_swap);
    }
  }

  void skip(const Ply_element& element)
  {
    const std::uint64_t row_size = element.least_binary_size();
    if (row_size == 0)
      return;
    m_file.check_count(element.count, row_size, "rows of " + printable(element.name));
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const Ply_property& property : element.properties)
        if (property.is_list)
          skip_list(property);
        else
          m_file.read_bytes(size_of(property.type));
  }

private:
  void skip_list(const Ply_property& property)
  {
    const double length = decode(m_file.read_bytes(size_of(property.length_type)),
                                 property.length_type, m_swap);
    if (length < 0)
      m_file.refuse("a list of negative length");
    m_file.skip_bytes(std::uint64_t(length) * size_of(property.type)); // below 2^32 times 8
  }
};

class Ascii_rows
{
  Input_file& m_file;

  std::string_view read_line()
  {
    while (const std::optional<std::string_view> line = m_file.read_line()) {
      std::string_view rest = *line;
      if (!next_word(rest).empty())
        return *line;
    }
    m_file.refuse("the file ends here, where another row is expected");
  }

  std::string_view read_word(std::string_view& line, const Ply_property& property)
  {
    const std::string_view word = next_word(line);
    if (word.empty())
      m_file.refuse("the row ends before its property " + printable(property.name));
    return word;
  }

  void skip_list(std::string_view& line, const Ply_property& property)
  {
    const std::string_view word = read_word(line, property);
    const std::optional<std::uint32_t> length = parse_number<std::uint32_t>(word);
    if (!length)
      m_file.refuse(printable(word) + " is not the length of a list");
    for (std::uint32_t i = 0; i < *length; ++i)
      read_word(line, property);
  }

public:
  explicit Ascii_rows(Input_file& file) : m_file(file) {}

  // A digit and a blank for each value, but for the end of the last line.
  std::uint64_t least_row_size(const Ply_element& element) const
  {
    return 2 * element.properties.size() - 1;
  }

  void read(const Ply_element& element, const Targets& targets, std::array<double, unused + 1>& row,
            Point_collector& collector)
  {
    std::string_view line = read_line();
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Ply_property& property = element.properties[k];
      if (property.is_list) {
        skip_list(line, property);
        continue;
      }
      const std::string_view word = read_word(line, property);
      if (targets[k] == unused)
        continue;
      if (targets[k] >= first_property) {
        if (!parse_number_of(property.type, word, collector.property(targets[k] - first_property)))
          m_file.refuse(printable(word) + " is not a number of the type of "
                        + printable(property.name));
        continue;
      }
      const std::optional<double> number = parse_number<double>(word);
      if (!number)
        m_file.refuse(printable(word) + " is not a number");
      row[targets[k]] = *number;
    }
    if (!next_word(line).empty())
      m_file.refuse("the row has more values than its " + std::to_string(element.properties.size())
                    + " properties");
  }

  void skip(const Ply_element& element)
  {
    if (element.properties.empty())
      return;
    m_file.check_count(element.count, least_row_size(element),
                       "rows of " + printable(element.name));
    for (std::uint64_t i = 0; i < element.count; ++i)
      read_line();
  }
};

template <typename Rows>
void read_elements(Input_file& file, const Ply_header& header, Rows rows,
                   Point_collector& collector)
{
  for (const Ply_element& element : header.elements) {
    if (element.name != "vertex") {
      rows.skip(element);
      continue;
    }
    Targets targets = find_targets(file, element);
    if (std::count(targets.begin(), targets.end(), unused) + 6 == std::ptrdiff_t(targets.size()))
      collector.set_has_normals();
    if (is_single_precision(element, targets))
      collector.set_single_precision();
    if (collector.wants_properties())
      keep_properties(element, targets, collector);
    collector.announce(element.count, rows.least_row_size(element));
    std::array<double, unused + 1> row = {};
    for (std::uint64_t i = 0; i < element.count; ++i) {
      rows.read(element, targets, row, collector);
      collector.add({row[0], row[1], row[2], row[3], row[4], row[5]});
    }

    if (collector.wants_properties())
      for (const Ply_element& other : header.elements)
        if (&other != &element && other.count > 0)
          collector.warn("what is no vertex is left out: " + std::to_string(other.count) + " of "
                         + printable(other.name));
    const bool is_last = &element == &header.elements.back();
    if (is_last && file.bytes_left() > std::uint64_t(0))
      collector.warn(std::to_string(*file.bytes_left())
                     + " bytes after the last vertex are not looked at");
    return;
  }
  file.refuse("the header has no element \"vertex\"");
}

} // namespace

void read_ply(Input_file& file, Point_collector& collector)
{
  const Ply_header header = read_ply_header(file);
  if (header.encoding == Ply_header::Encoding::ASCII)
    read_elements(file, header, Ascii_rows(file), collector);
  else
    read_elements(file, header, Binary_rows(file, header.encoding), collector);
}

} // namespace l0_tool
