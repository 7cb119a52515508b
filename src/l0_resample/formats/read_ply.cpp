// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Number_type.h"
#include "basis/parse_numbers.h"
#include "formats/Ply_header.h"
#include "formats/Row_targets.h"
#include "formats/readers.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

void keep_properties(const Ply_element& vertex, const std::vector<std::string>& names,
                     Targets& targets, Point_collector& collector)
{
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const Ply_property& property = vertex.properties[k];
    if (targets[k] != unused)
      continue;
    if (property.is_list)
      collector.warn("the lists " + printable(property.name) + " of the vertices are left out");
    else if (!property.type.is_number())
      collector.warn("the property " + printable(property.name) + " is left out: numbers of type "
                     + printable(property.type.name));
    else
      targets[k] = first_property + collector.add_property(names[k], property.type.number);
  }
}

std::vector<std::string> names_of(const Ply_element& element)
{
  std::vector<std::string> names;
  for (const Ply_property& property : element.properties)
    names.push_back(property.name);
  return names;
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

  std::uint64_t minimum_row_size(const Ply_element& element) const
  {
    return element.minimum_binary_size();
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
      const char* bytes = m_file.read_bytes(property.type.size);
      if (targets[k] == unused)
        continue;
      if (targets[k] < unused)
        row[targets[k]] = property.type.number_at(bytes, m_swap);
      else
        collector.set(targets[k] - first_property, property.type, bytes, m_swap);
    }
  }

  void skip(const Ply_element& element)
  {
    const std::uint64_t row_size = element.minimum_binary_size();
    if (row_size == 0)
      return;
    m_file.check_count(element.count, row_size, "rows of " + printable(element.name));
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const Ply_property& property : element.properties)
        if (property.is_list)
          skip_list(property);
        else
          m_file.read_bytes(property.type.size);
  }

private:
  void skip_list(const Ply_property& property)
  {
    const Ply_type& type = property.length_type;
    const double length = type.number_at(m_file.read_bytes(type.size), m_swap);
    constexpr double largest = 1e15; // far from the end of 64 bits
    if (length < 0 || length > largest)
      m_file.refuse("a list of a length that cannot be");
    m_file.skip_bytes(std::uint64_t(length) * property.type.size);
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
  std::uint64_t minimum_row_size(const Ply_element& element) const
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
        if (!collector.set(targets[k] - first_property, property.type, word))
          m_file.refuse(printable(word) + " is not a number of the type of "
                        + printable(property.name));
        continue;
      }
      const std::optional<double> number = parse_number<double>(word);
      if (!number)
        m_file.refuse(no_number(word));
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
    m_file.check_count(element.count, minimum_row_size(element),
                       "rows of " + printable(element.name));
    for (std::uint64_t i = 0; i < element.count; ++i)
      read_line();
  }
};

template <typename Rows>
void read_vertices(Input_file& file, const Ply_element& vertex, Rows& rows,
                   Point_collector& collector)
{
  const std::vector<std::string> own_names = names_of(vertex), names = usual_names(own_names);
  const auto reason_against = [&](std::size_t k) -> std::string {
    const Ply_property& property = vertex.properties[k];
    return property.is_list             ? "a list"
           : !property.type.is_number() ? "of type " + printable(property.type.name)
                                        : "";
  };
  Targets targets = find_targets(file, own_names, names, "property", reason_against);
  if (have_normals(targets))
    collector.set_vectors(Vectors::NAMED_BY_FILE);
  for (std::size_t k = 0; k < targets.size(); ++k)
    if (targets[k] < unused)
      collector.set_type_in_row(targets[k], vertex.properties[k].type.number);
  if (collector.wants_properties())
    keep_properties(vertex, names, targets, collector);
  collector.announce(vertex.count, rows.minimum_row_size(vertex));
  std::array<double, unused + 1> row = {};
  for (std::uint64_t i = 0; i < vertex.count; ++i) {
    rows.read(vertex, targets, row, collector);
    collector.add({row[0], row[1], row[2], row[3], row[4], row[5]});
  }
}

/// The place of a camera: as PCL and others write it, who give the points the coordinates of a
/// scanner. A camera without one, and one of several, tell nothing of all points.
std::optional<Targets> find_camera(const Ply_element& element)
{
  static constexpr std::array<std::string_view, 3> names = {"view_px", "view_py", "view_pz"};
  Targets targets;
  for (const Ply_property& property : element.properties) {
    const bool is_number = !property.is_list && property.type.is_number();
    targets.push_back(
      is_number ? std::size_t(std::find(names.begin(), names.end(), property.name) - names.begin())
                : unused);
    if (targets.back() == names.size())
      targets.back() = unused;
  }
  for (std::size_t k = 0; k < names.size(); ++k)
    if (std::count(targets.begin(), targets.end(), k) != 1)
      return std::nullopt;
  if (element.name != "camera" || element.count != 1)
    return std::nullopt;
  return targets;
}

template <typename Rows>
void read_elements(Input_file& file, const Ply_header& header, Rows rows,
                   Point_collector& collector)
{
  const auto has_usual_name = [](const Ply_element& e) { return e.name == "vertex"; };
  const auto is_vertex = [](const Ply_element& e) {
    const std::string name = folded(e.name);
    return name == "vertex" || name == "vertices" || name == "point" || name == "points";
  };
  const auto is_camera = [](const Ply_element& element) {
    return find_camera(element).has_value();
  };
  const auto begin = header.elements.begin(), end = header.elements.end();
  auto vertex = std::find_if(begin, end, has_usual_name);
  if (vertex == end)
    vertex = std::find_if(begin, end, is_vertex);
  if (vertex == end)
    file.refuse("the header has no element \"vertex\"");
  const auto camera = std::find_if(begin, end, is_camera);
  const auto last = camera == end ? vertex : (std::max)(vertex, camera);
  for (auto element = begin; element <= last; ++element)
    if (element == vertex)
      read_vertices(file, *vertex, rows, collector);
    else if (element == camera) {
      std::array<double, unused + 1> row = {};
      rows.read(*camera, *find_camera(*camera), row, collector);
      if (std::isfinite(row[0]) && std::isfinite(row[1]) && std::isfinite(row[2]))
        collector.set_viewpoint({row[0], row[1], row[2]});
      else
        collector.warn("the place of the camera is not finite, so it is not used");
    } else
      rows.skip(*element);

  if (collector.wants_properties())
    for (auto element = begin; element != end; ++element)
      if (element != vertex && element != camera && element->count > 0)
        collector.warn("what is no vertex is left out: " + std::to_string(element->count) + " of "
                       + printable(element->name));
  if (last + 1 == end)
    warn_of_rest(file, last == vertex ? "vertex" : "camera", collector);
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
