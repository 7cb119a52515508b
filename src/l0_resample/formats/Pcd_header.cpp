// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Pcd_header.h"

#include "basis/parse_numbers.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <string_view>

namespace l0_tool {
namespace {

constexpr std::size_t max_pcd_header_length = 1024 * 1024;
constexpr std::size_t max_number_of_fields = 1000;
constexpr std::uint64_t max_count =
  0xffffffff; // keeps the size of a row far from the end of 64 bits

std::uint64_t parse_count(const Input_file& file, std::string_view word, std::uint64_t least,
                          std::uint64_t most, const std::string& what)
{
  const std::optional<std::uint64_t> count = parse_number<std::uint64_t>(word);
  if (!count || *count < least || *count > most)
    file.refuse(printable(word) + " is not " + what);
  return *count;
}

/// The lines of the header but for comments, each of which begins with another keyword.
class Pcd_lines
{
  std::map<std::string, std::vector<std::string>> m_lines;

public:
  /// Reads to the line DATA. PCL takes COLUMNS, of older versions, for FIELDS.
  explicit Pcd_lines(Input_file& file)
  {
    static constexpr std::string_view keywords[] = {"VERSION", "FIELDS", "SIZE",   "TYPE",
                                                    "COUNT",   "WIDTH",  "HEIGHT", "VIEWPOINT",
                                                    "POINTS",  "DATA"};
    for (std::size_t length = 0; length <= max_pcd_header_length;) {
      const std::optional<std::string_view> line = file.read_line();
      if (!line)
        file.refuse("the file ends within its header");
      length += line->size() + 1;

      std::string_view rest = *line;
      std::string_view keyword = next_word(rest);
      if (keyword == "COLUMNS")
        keyword = "FIELDS";
      if (keyword.empty() || keyword[0] == '#')
        continue;
      if (std::find(std::begin(keywords), std::end(keywords), keyword) == std::end(keywords))
        file.refuse(printable(keyword) + " is not a keyword of a PCD header"
                    + (m_lines.empty() ? ", with which the file should begin" : ""));
      const auto [words, is_new] = m_lines.try_emplace(std::string(keyword));
      if (!is_new)
        file.refuse("a second line " + std::string(keyword));
      for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
        if (words->second.size() == max_number_of_fields)
          file.refuse("more than " + std::to_string(max_number_of_fields) + " fields");
        words->second.emplace_back(word);
      }
      if (keyword == "DATA")
        return;
    }
    file.refuse("the header is longer than " + std::to_string(max_pcd_header_length) + " bytes");
  }

  bool has(const std::string& keyword) const { return m_lines.count(keyword) > 0; }

  /// The words behind the keyword.
  const std::vector<std::string>& words(const Input_file& file, const std::string& keyword) const
  {
    const auto line = m_lines.find(keyword);
    if (line == m_lines.end())
      file.refuse("the header has no line " + keyword);
    return line->second;
  }

  /// As many words as there are fields.
  const std::vector<std::string>& column(const Input_file& file, const std::string& keyword,
                                         std::size_t number_of_fields) const
  {
    const std::vector<std::string>& found = words(file, keyword);
    if (found.size() != number_of_fields)
      file.refuse(std::to_string(number_of_fields) + " fields, but " + keyword + " has "
                  + std::to_string(found.size()) + " words");
    return found;
  }

  std::string word(const Input_file& file, const std::string& keyword) const
  {
    const std::vector<std::string>& found = words(file, keyword);
    return found.empty() ? std::string() : found.front();
  }
};

Type_in_file type_of(const std::string& word, std::uint64_t size)
{
  const std::string letter = lower_case(word);
  if (letter == "f" && size == 4)
    return {Number_type::FLOAT32};
  if (letter == "f" && size == 8)
    return {Number_type::FLOAT64};
  if (letter != "i" && letter != "u")
    return {};
  const bool is_signed = letter == "i";
  switch (size) {
  case 1: return {is_signed ? Number_type::INT8 : Number_type::UINT8};
  case 2: return {is_signed ? Number_type::INT16 : Number_type::UINT16};
  case 4: return {is_signed ? Number_type::INT32 : Number_type::UINT32};
  default: return {std::nullopt, Wide_integer{is_signed}};
  }
}

/// 3 for rgb, 4 for rgba, as other names in upper or lower case, and 0 for what is no packed color.
std::size_t number_of_channels_of(const Pcd_field& field)
{
  const std::string name = folded(field.name);
  const bool is_packed = (name == "rgb" || name == "rgba") && field.size == 4 && field.count == 1;
  return is_packed ? name.size() : 0;
}

/// One of points, normals or colors, all in one, as those that it holds.
void add_field(Pcd_field field, std::vector<Pcd_field>& fields)
{
  constexpr std::uint64_t least = 3, most = 4;
  field.values_in_column = field.count;
  const std::vector<std::string> names = field.count >= least && field.count <= most
                                           ? names_of_values(field.name, std::size_t(field.count))
                                           : std::vector<std::string>();
  const bool are_usual = !names.empty() && names.front() != field.name + "_0";
  if (!are_usual)
    fields.push_back(field);
  for (std::size_t k = 0; are_usual && k < names.size(); ++k) {
    field.name = names[k];
    field.count = 1;
    field.first_in_column = k;
    fields.push_back(field);
  }
}

std::vector<Pcd_field> parse_fields(const Input_file& file, const Pcd_lines& lines)
{
  const std::vector<std::string>& names = lines.words(file, "FIELDS");
  const std::vector<std::string>& sizes = lines.column(file, "SIZE", names.size());
  const std::vector<std::string>& types = lines.column(file, "TYPE", names.size());
  std::vector<Pcd_field> fields;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::uint64_t size = parse_count(file, sizes[k], 1, 8, "a size of PCD");
    if (size != 1 && size != 2 && size != 4 && size != 8)
      file.refuse(printable(sizes[k]) + " is not a size of PCD");
    Pcd_field field{type_of(types[k], size), names[k], size,
                    printable(types[k]) + " of " + std::to_string(size) + " bytes"};
    if (lines.has("COUNT"))
      field.count = parse_count(file, lines.column(file, "COUNT", names.size())[k], 0, max_count,
                                "a number of values");
    field.number_of_channels = number_of_channels_of(field);
    add_field(field, fields);
  }
  return fields;
}

std::uint64_t parse_number_of_points(const Input_file& file, const Pcd_lines& lines)
{
  constexpr std::uint64_t any = (std::numeric_limits<std::uint64_t>::max)();
  // PCL does not need all of them either
  const bool has_points = lines.has("POINTS"), has_width = lines.has("WIDTH");
  if (!has_points && !has_width)
    file.refuse("the header has no line POINTS and no line WIDTH");
  const std::uint64_t height = lines.has("HEIGHT") ? parse_count(file, lines.word(file, "HEIGHT"),
                                                                 0, any, "a number of rows")
                                                   : 1;
  std::uint64_t points = 0, width = 0;
  if (has_points)
    points = parse_count(file, lines.word(file, "POINTS"), 0, any, "a number of points");
  if (has_width)
    width = parse_count(file, lines.word(file, "WIDTH"), 0, any, "a number of columns");
  if (!has_points) {
    if (height > 0 && width > any / height)
      file.refuse("WIDTH times HEIGHT is more than a file can hold");
    return width * height;
  }
  if (!has_width)
    return points;
  const bool is_product = height == 0 || width == 0
                            ? points == 0
                            : points / width == height && points % width == 0;
  if (!is_product)
    file.refuse("WIDTH times HEIGHT is not the number of POINTS");
  return points;
}

/// The first three words of VIEWPOINT are the place, those behind them its rotation.
std::optional<std::array<double, 3>> parse_viewpoint(const Input_file& file, const Pcd_lines& lines)
{
  if (!lines.has("VIEWPOINT"))
    return std::nullopt;
  return first_coordinates(lines.words(file, "VIEWPOINT"));
}

} // namespace

std::uint64_t Pcd_header::number_of_values() const
{
  std::uint64_t n = 0;
  for (const Pcd_field& field : fields)
    n += field.count;
  return n;
}

std::uint64_t Pcd_header::row_size() const
{
  std::uint64_t size = 0;
  for (const Pcd_field& field : fields)
    size += field.count * field.size;
  return size;
}

Pcd_header read_pcd_header(Input_file& file)
{
  const Pcd_lines lines(file);
  std::string version = lines.has("VERSION") ? lines.word(file, "VERSION") : "0.7";
  if (version.substr(0, 1) == ".")
    version = "0" + version;
  if (version != "0.5" && version != "0.6" && version != "0.7")
    file.refuse("version 0.7 of PCD or an older one expected, found " + printable(version));

  Pcd_header header;
  header.fields = parse_fields(file, lines);
  header.number_of_points = parse_number_of_points(file, lines);
  header.has_viewpoint = lines.has("VIEWPOINT");
  header.viewpoint = parse_viewpoint(file, lines);
  header.is_organized = lines.has("HEIGHT") && lines.word(file, "HEIGHT") != "1";
  const std::string word = lines.word(file, "DATA"), data = lower_case(word);
  if (data == "ascii")
    header.encoding = Pcd_header::Encoding::ASCII;
  else if (data == "binary")
    header.encoding = Pcd_header::Encoding::BINARY;
  else if (data == "binary_compressed")
    header.encoding = Pcd_header::Encoding::COMPRESSED_BINARY;
  else
    file.refuse(printable(word) + " is not a kind of DATA of PCD");
  return header;
}

} // namespace l0_tool
