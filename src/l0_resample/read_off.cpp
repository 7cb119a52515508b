// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parse_numbers.h"
#include "readers.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

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

bool remove_prefix(std::string_view& word, std::string_view prefix)
{
  if (word.substr(0, prefix.size()) != prefix)
    return false;
  word.remove_prefix(prefix.size());
  return true;
}

} // namespace

void read_off(Input_file& file, Point_collector& collector)
{
  std::string_view line = read_content(file, "the word OFF is");
  std::string_view keyword = next_word(line);
  remove_prefix(keyword, "ST");        // texture coordinates and colors come after the normal in a row
  remove_prefix(keyword, "C");
  const bool has_normals = remove_prefix(keyword, "N");
  if (keyword != "OFF")
    file.refuse("the file does not begin with OFF, with no prefix but ST, C or N");
  if (has_normals)
    collector.set_has_normals();

  std::string_view word = next_word(line);
  if (word == "BINARY")
    file.refuse("binary OFF is not supported");
  if (word.empty()) {
    line = read_content(file, "the number of vertices is");
    word = next_word(line);
  }
  const std::optional<std::uint64_t> number_of_vertices = parse_number<std::uint64_t>(word);
  if (!number_of_vertices)
    file.refuse(printable(word) + " is not a number of vertices");

  const std::uint64_t least_row_size = has_normals ? 11 : 5;   // digits and blanks; the last line may lack its end
  collector.announce(*number_of_vertices, least_row_size);
  for (std::uint64_t i = 0; i < *number_of_vertices; ++i)
    collector.add(parse_row(file, read_content(file, "another vertex is"), has_normals));
}

} // namespace l0_tool
