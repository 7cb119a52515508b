// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parse_numbers.h"
#include "readers.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace l0_tool {
namespace {

std::size_t count_words(std::string_view line)
{
  std::size_t n = 0;
  while (!next_word(line).empty())
    ++n;
  return n;
}

bool is_empty_or_comment(std::string_view line)
{
  const std::string_view word = next_word(line);
  return word.empty() || word[0] == '#';
}

} // namespace

void read_xyz(Input_file& file, Point_collector& collector)
{
  std::optional<std::uint64_t> announced;
  std::size_t columns = 0; // as in the first row
  while (std::optional<std::string_view> line = file.read_line()) {
    if (is_empty_or_comment(*line))
      continue;

    const std::size_t n = count_words(*line);
    if (columns == 0) {
      if (n == 1 && !announced) {
        announced = parse_number<std::uint64_t>(next_word(*line));
        if (announced) {
          collector.announce(*announced, 6); // three digits, two blanks, a line end
          continue;
        }
      }
      if (n < 3)
        file.refuse("a point needs 3 numbers, found " + std::to_string(n));
      columns = n;
      if (columns == 6)
        collector.set_has_normals();
      else if (columns > 3 && collector.wants_properties())
        collector.warn("the columns behind the third have no names and are left out");
    }
    if (n != columns)
      file.refuse(std::to_string(columns) + " columns expected as in the lines before, found " + std::to_string(n));

    collector.add(parse_row(file, *line, columns == 6));
  }
  if (announced && collector.number_of_rows() < *announced)
    file.refuse("the file ends after " + std::to_string(collector.number_of_rows())
                + " points, its first line announced " + std::to_string(*announced));
  if (announced && collector.number_of_rows() > *announced)
    collector.warn("more points than the " + std::to_string(*announced) + " that the first line announced; all are used");
}

} // namespace l0_tool
