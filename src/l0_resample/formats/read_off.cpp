// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/parse_numbers.h"
#include "formats/readers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

// The next line that holds something, without its comment.
std::string_view read_content(Input_file& file, const char* expected)
{
  while (const std::optional<std::string_view> line = file.read_line()) {
    const std::string_view content = line->substr(0, line->find('#'));
    std::string_view rest = content;
    if (!next_word(rest).empty())
      return content;
  }
  file.refuse(std::string("the file ends here, where ") + expected + " expected");
}

bool remove_if_first(std::string_view& word, std::string_view prefix)
{
  if (word.substr(0, prefix.size()) != prefix)
    return false;
  word.remove_prefix(prefix.size());
  return true;
}

/// What the keyword says of the rows. Texture coordinates come after colors in a row, and colors
/// after the normal.
struct Row_layout
{
  bool has_texture_coordinates, has_normals, has_colors;
};

/// \param keyword in small letters, loses what is read
Row_layout read_keyword(const Input_file& file, std::string_view& keyword)
{
  Row_layout layout;
  layout.has_texture_coordinates = remove_if_first(keyword, "st");
  const bool has_normals = remove_if_first(keyword, "n");
  layout.has_colors = remove_if_first(keyword, "c");
  layout.has_normals = remove_if_first(keyword, "n") || has_normals;
  if (!remove_if_first(keyword, "off"))
    file.refuse("the file does not begin with OFF, with no prefix but ST, C or N");
  return layout;
}

/// The colors of the vertices, if the keyword says that they have some.
class Colors
{
  Input_file& m_file;
  Row_layout m_layout;
  Point_collector& m_collector;
  std::vector<Number_type> m_types; // of the channels
  bool m_is_first_row = true;

public:
  Colors(Input_file& file, const Row_layout& layout, Point_collector& collector)
    : m_file(file), m_layout(layout), m_collector(collector)
  {}

  void read(std::string_view row)
  {
    if (!m_is_first_row && m_types.empty())
      return;
    for (int k = 0; k < (m_layout.has_normals ? 6 : 3); ++k)
      next_word(row);
    if (m_is_first_row)
      find_channels(row);
    m_is_first_row = false;
    for (std::size_t k = 0; k < m_types.size(); ++k) {
      const std::string_view word = next_word(row);
      if (!parse_number_of(m_types[k], word, m_collector.property(k)))
        m_file.refuse(printable(word) + " is not a channel of a color as in the first row");
    }
  }

private:
  /// \param rest of the first row, behind the normal
  void find_channels(std::string_view rest)
  {
    static constexpr std::array<const char*, 4> names = {"red", "green", "blue", "alpha"};
    std::vector<std::string_view> words;
    split_words(rest, words);
    if (m_layout.has_texture_coordinates) {
      m_collector.warn("the texture coordinates are left out");
      words.resize(words.size() - (std::min)(words.size(), std::size_t(2)));
    }
    if (!m_layout.has_colors) {
      if (!words.empty())
        m_collector.warn("the last " + std::to_string(words.size())
                         + " numbers of the rows are left out, as the keyword does not say what "
                           "they are: COFF has colors, NOFF normals");
      return;
    }
    if (words.size() != 3 && words.size() != 4) {
      m_collector.warn("the colors are left out, as they have " + std::to_string(words.size())
                       + " channels");
      return;
    }
    // From 0 to 255, or else from 0 to 1
    const auto is_byte = [](std::string_view word) {
      return parse_number<std::uint8_t>(word).has_value();
    };
    const bool are_bytes = std::all_of(words.begin(), words.end(), is_byte);
    for (std::size_t k = 0; k < words.size(); ++k) {
      m_types.push_back(are_bytes ? Number_type::UINT8 : Number_type::FLOAT32);
      m_collector.add_property(names[k], m_types.back());
    }
  }
};

} // namespace

void read_off(Input_file& file, Point_collector& collector)
{
  std::string_view line = read_content(file, "the word OFF is");
  const std::string first_word = lower_case(next_word(line));
  std::string_view keyword = first_word;
  const Row_layout layout = read_keyword(file, keyword);
  if (layout.has_normals)
    collector.set_vectors(Vectors::NAMED_BY_FILE);

  // Some files lack the end of the line behind it
  std::string_view word = keyword.empty() ? next_word(line) : keyword;
  if (word == "BINARY")
    file.refuse("binary OFF is not supported");
  if (word.empty()) {
    line = read_content(file, "the number of vertices is");
    word = next_word(line);
  }
  const std::optional<std::uint64_t> number_of_vertices = parse_number<std::uint64_t>(word);
  if (!number_of_vertices)
    file.refuse(printable(word) + " is not a number of vertices");

  const std::uint64_t minimum_row_size = layout.has_normals
                                           ? 11
                                           : 5; // digits and blanks; the last line may lack its end
  collector.announce(*number_of_vertices, minimum_row_size);
  Colors colors(file, layout, collector);
  for (std::uint64_t i = 0; i < *number_of_vertices; ++i) {
    const std::string_view row = read_content(file, "another vertex is");
    const Point_row point = parse_row(file, row, layout.has_normals);
    if (collector.wants_properties())
      colors.read(row);
    collector.add(point);
  }
}

} // namespace l0_tool
