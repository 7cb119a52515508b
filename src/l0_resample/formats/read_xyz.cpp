// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/parse_numbers.h"
#include "formats/Text_columns.h"
#include "formats/readers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

/// What columns without names are.
void guess_columns(std::size_t number_of_columns, Point_collector& collector)
{
  if (number_of_columns == 6)
    collector.set_may_have_normals();
  else if (number_of_columns > 3 && collector.wants_properties())
    collector.warn("the columns behind the third are left out; --columns can name them");
}

void check_count(const Input_file& file, Point_collector& collector,
                 std::optional<std::uint64_t> announced)
{
  const std::uint64_t n = collector.number_of_rows();
  if (!announced && n == 0)
    file.refuse("the file has no points");
  if (announced && n < *announced)
    file.refuse("the file ends after " + std::to_string(n) + " points, its first line announced "
                + std::to_string(*announced));
  if (announced && n > *announced)
    collector.warn("more points than the " + std::to_string(*announced)
                   + ", which the first line announced; all of them are used");
}

} // namespace

void read_xyz(Input_file& file, Point_collector& collector, const Column_names& names)
{
  std::optional<std::uint64_t> announced;
  std::optional<Text_columns> named;
  if (!names.empty())
    named.emplace(names, collector);
  std::vector<std::string_view> words;
  std::size_t columns = 0; // as in the first row
  while (std::optional<std::string_view> line = file.read_line()) {
    if (is_empty_or_comment(*line))
      continue;

    split_words(*line, words);
    const std::size_t n = words.size();
    if (columns == 0) {
      if (n == 1 && !announced) {
        announced = parse_number<std::uint64_t>(words.front());
        if (announced) {
          // Digits, blanks, a line end
          collector.announce(*announced, 2 * (std::max)(names.size(), std::size_t(3)));
          continue;
        }
      }
      if (n < 3)
        file.refuse("a point needs 3 numbers, found " + std::to_string(n));
      if (named && n != named->size())
        file.refuse("--columns names " + std::to_string(named->size()) + ", found "
                    + std::to_string(n));
      columns = n;
      if (!named)
        guess_columns(columns, collector);
    }
    if (n != columns)
      file.refuse(std::to_string(columns) + " columns expected as in the lines before, found "
                  + std::to_string(n));

    if (named)
      named->read(file, words);
    else
      collector.add(parse_row(file, *line, columns == 6));
  }
  check_count(file, collector, announced);
  if (named)
    named->choose_types();
}

} // namespace l0_tool
