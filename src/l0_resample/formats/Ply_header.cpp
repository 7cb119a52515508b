// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Ply_header.h"

#include "basis/parse_numbers.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace l0_tool {
namespace {

constexpr std::size_t max_ply_header_length = 1024 * 1024;
constexpr std::size_t max_number_of_properties = 1000;
constexpr std::size_t max_number_of_elements = 100;

Ply_type parse_type(const Input_file& file, std::string_view word)
{
  if (word.empty())
    file.refuse("a property without a type");
  std::string lower = lower_case(word);
  constexpr std::string_view ending = "_t"; // of types of C, as int64_t
  if (lower.size() > ending.size() && lower.substr(lower.size() - ending.size()) == ending)
    lower.resize(lower.size() - ending.size());
  static constexpr std::pair<std::string_view, Number_type> types[] = {
    {"char", Number_type::INT8},      {"int8", Number_type::INT8},
    {"uchar", Number_type::UINT8},    {"uint8", Number_type::UINT8},
    {"short", Number_type::INT16},    {"int16", Number_type::INT16},
    {"ushort", Number_type::UINT16},  {"uint16", Number_type::UINT16},
    {"int", Number_type::INT32},      {"int32", Number_type::INT32},
    {"uint", Number_type::UINT32},    {"uint32", Number_type::UINT32},
    {"float", Number_type::FLOAT32},  {"float32", Number_type::FLOAT32},
    {"double", Number_type::FLOAT64}, {"float64", Number_type::FLOAT64}};
  for (const auto& [name, type] : types)
    if (name == lower)
      return {{type}, size_of(type), std::string(name)};
  // What some programs write beside the types of PLY
  static constexpr std::pair<std::string_view, bool> wide[] = {
    {"int64", true}, {"longlong", true}, {"uint64", false}, {"ulonglong", false}};
  for (const auto& [name, is_signed] : wide)
    if (name == lower)
      return {{std::nullopt, Wide_integer{is_signed}}, sizeof(std::int64_t), std::string(word)};
  // Not kept, but no obstacle to the others
  static constexpr std::pair<std::string_view, std::size_t> sizes[] = {
    {"bool", 1}, {"half", 2}, {"float16", 2}};
  for (const auto& [name, size] : sizes)
    if (name == lower)
      return {{}, size, std::string(word)};
  return {{}, 0, std::string(word)};
}

/// Only texts may have values of any type, as these are words there whatever they mean.
void check_types(const Input_file& file, const Ply_header& header)
{
  for (const Ply_element& element : header.elements)
    for (const Ply_property& property : element.properties)
      if (property.type.size == 0
          && (property.is_list || header.encoding != Ply_header::Encoding::ASCII))
        file.refuse(printable(property.type.name)
                    + " is not a type of PLY; one of its size, such as int or int64, can take its "
                      "place in the header");
}

Ply_header::Encoding parse_encoding(const Input_file& file, std::string_view words)
{
  const std::string_view name = next_word(words);
  const std::string_view version = next_word(words);
  if (version != "1.0")
    file.refuse("version 1.0 of PLY expected, found " + printable(version));
  if (name == "ascii")
    return Ply_header::Encoding::ASCII;
  if (name == "binary_little_endian")
    return Ply_header::Encoding::LITTLE_ENDIAN_BINARY;
  if (name == "binary_big_endian")
    return Ply_header::Encoding::BIG_ENDIAN_BINARY;
  file.refuse(printable(name) + " is not a format of PLY");
}

Ply_element parse_element(const Input_file& file, std::string_view words)
{
  const std::string_view name = next_word(words);
  const std::string_view count_word = next_word(words);
  const std::optional<std::uint64_t> count = parse_number<std::uint64_t>(count_word);
  if (!count)
    file.refuse(printable(count_word) + " is not a number of elements");
  return {std::string(name), *count, {}};
}

Ply_property parse_property(const Input_file& file, std::string_view words)
{
  Ply_property property;
  std::string_view word = next_word(words);
  if (word == "list") {
    property.is_list = true;
    property.length_type = parse_type(file, next_word(words));
    const Ply_type& length = property.length_type;
    if (length.number ? is_floating(*length.number) : !length.wide)
      file.refuse("the length of a list is of type " + printable(length.name)
                  + ", which is no integer");
    word = next_word(words);
  }
  property.type = parse_type(file, word);
  property.name = next_word(words);
  if (property.name.empty())
    file.refuse("a property without a name");
  return property;
}

} // namespace

bool Ply_element::has_lists() const
{
  return std::any_of(properties.begin(), properties.end(),
                     [](const Ply_property& p) { return p.is_list; });
}

std::uint64_t Ply_element::minimum_binary_size() const
{
  std::uint64_t size = 0;
  for (const Ply_property& property : properties)
    size += (property.is_list ? property.length_type : property.type).size;
  return size;
}

Ply_header read_ply_header(Input_file& file)
{
  std::optional<std::string_view> line = file.read_line();
  if (!line || (trimmed(*line) != "ply" && trimmed(*line) != "PLY"))
    file.refuse("the file does not begin with the line \"ply\"");

  Ply_header header;
  std::optional<Ply_header::Encoding> encoding;
  std::size_t number_of_properties = 0;
  for (std::size_t length = 0; length <= max_ply_header_length;) {
    line = file.read_line();
    if (!line)
      file.refuse("the file ends within its header");
    length += line->size() + 1;

    std::string_view words = *line;
    const std::string_view keyword = next_word(words);
    if (keyword == "end_header") {
      if (!encoding)
        file.refuse("the header has no line that begins with \"format\"");
      header.encoding = *encoding;
      check_types(file, header);
      return header;
    }
    if (keyword == "format")
      encoding = parse_encoding(file, words);
    else if (keyword == "element") {
      if (header.elements.size() == max_number_of_elements)
        file.refuse("more than " + std::to_string(max_number_of_elements) + " elements");
      header.elements.push_back(parse_element(file, words));
    } else if (keyword == "property") {
      if (header.elements.empty())
        file.refuse("a property before the first element");
      if (++number_of_properties > max_number_of_properties)
        file.refuse("more than " + std::to_string(max_number_of_properties) + " properties");
      header.elements.back().properties.push_back(parse_property(file, words));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
      file.refuse(printable(keyword) + " is not a keyword of a PLY header");
  }
  file.refuse("the header is longer than " + std::to_string(max_ply_header_length) + " bytes");
}

} // namespace l0_tool
