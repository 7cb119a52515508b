// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/parse_numbers.h"
#include "formats/readers.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

constexpr std::array<const char*, 3> channels = {"red", "green", "blue"};

/// Behind three coordinates, and maybe a weight.
bool has_color(std::size_t number_of_words) { return number_of_words == 6 || number_of_words == 7; }

void read_color(const Input_file& file, std::string_view line, Point_collector& collector)
{
  std::vector<std::string_view> words;
  split_words(line, words);
  if (collector.number_of_rows() == 0 && has_color(words.size()))
    for (const char* channel : channels)
      collector.add_property(channel, Number_type::FLOAT32);
  if (collector.number_of_properties() == 0)
    return;
  if (!has_color(words.size()))
    file.refuse("a vertex with a color expected as the first one is, found "
                + std::to_string(words.size()) + " numbers");
  for (std::size_t k = 0; k < channels.size(); ++k) {
    const std::string_view word = words[words.size() - channels.size() + k];
    if (!parse_number_of(Number_type::FLOAT32, word, collector.property(k)))
      file.refuse(printable(word) + " is not a number");
  }
}

} // namespace

void read_obj(Input_file& file, Point_collector& collector)
{
  collector.set_normals_apart();
  while (std::optional<std::string_view> line = file.read_line()) {
    const std::string_view keyword = next_word(*line);
    if (keyword != "v" && keyword != "vn")
      continue;
    const Point_row row = parse_row(file, *line, false);
    if (keyword == "vn") {
      collector.add_normal(Vector(row[0], row[1], row[2]));
      continue;
    }
    if (collector.wants_properties())
      read_color(file, *line, collector);
    collector.add(row);
  }
  if (collector.number_of_rows() == 0)
    file.refuse("the file has no vertex, a line that begins with v");
}

} // namespace l0_tool
