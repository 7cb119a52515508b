// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/parse_numbers.h"
#include "formats/Normals_of_faces.h"
#include "formats/readers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
      file.refuse(no_number(word));
  }
}

class Obj_reader
{
  Input_file& m_file;
  Point_collector& m_collector;
  std::uint64_t m_number_of_normals = 0;
  std::vector<Vector> m_normals; // if they are wanted
  Normals_of_faces m_corners;    // likewise
  bool m_has_corners = false;    // with normals
  std::string m_joined;          // a line of the format that goes on in the next one

  /// The next line, with those that a backslash at its end adds.
  std::optional<std::string_view> read_line()
  {
    std::optional<std::string_view> line = m_file.read_line();
    if (!line || line->empty() || line->back() != '\\')
      return line;
    m_joined.clear();
    while (line && !line->empty() && line->back() == '\\') {
      m_joined.append(line->substr(0, line->size() - 1)).append(" ");
      if (m_joined.size() > Input_file::max_line_length)
        m_file.refuse("the line, with those that go on with it, is longer than "
                      + std::to_string(Input_file::max_line_length) + " bytes");
      line = m_file.read_line();
    }
    if (line)
      m_joined.append(*line);
    return m_joined;
  }

  void read_normal(std::string_view line)
  {
    const Point_row row = parse_row(m_file, line, false);
    const Vector normal = m_collector.unit_vector(Vector(row[0], row[1], row[2]));
    ++m_number_of_normals;
    if (!m_collector.wants_normals())
      return;
    m_normals.push_back(normal);
    check_memory();
  }

  void check_memory()
  {
    m_collector.set_buffer_size(m_normals.size() * sizeof(Vector) + m_corners.size());
  }

  /// Counted from 1, or from the last one back. One that cannot be becomes one that is not there.
  static std::uint64_t index_of(std::string_view word, std::uint64_t number)
  {
    constexpr std::uint64_t none = (std::numeric_limits<std::uint64_t>::max)();
    const std::optional<std::int64_t> index = parse_number<std::int64_t>(word);
    if (!index || *index == 0 || (*index < 0 && std::uint64_t(-(*index + 1)) >= number))
      return none;
    return *index > 0 ? std::uint64_t(*index) - 1 : number - std::uint64_t(-(*index + 1)) - 1;
  }

  /// Its corners are v, v/vt, v//vn or v/vt/vn.
  void read_face(std::string_view line)
  {
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const std::size_t first = word.find('/'), second = first == std::string_view::npos
                                                           ? first
                                                           : word.find('/', first + 1);
      if (second == std::string_view::npos || second + 1 == word.size())
        continue;
      m_has_corners = true;
      if (m_collector.wants_normals())
        m_corners.add(index_of(word.substr(0, first), m_collector.number_of_rows()),
                      index_of(word.substr(second + 1), m_number_of_normals));
    }
    check_memory();
  }

  void hand_over_normals()
  {
    const std::uint64_t n = m_collector.number_of_rows();
    if (m_number_of_normals == 0)
      return;
    if (!m_has_corners && m_number_of_normals != n) {
      if (m_collector.wants_normals() || m_collector.wants_properties())
        m_collector.warn("the " + std::to_string(m_number_of_normals)
                         + " normals are left out, as there are " + std::to_string(n)
                         + " points, and no face says which belong together");
      return;
    }
    if (m_has_corners && m_collector.wants_normals()) {
      m_collector.set_buffer_size((m_normals.size() + n) * sizeof(Vector) + m_corners.size());
      std::uint64_t number_left_out = 0;
      m_normals = m_corners.means(m_normals, std::size_t(n), number_left_out);
      if (number_left_out > 0)
        m_collector.warn(std::to_string(number_left_out)
                         + " corners of faces are left out, as they name a vertex or a normal "
                           "that is not there");
    }
    m_collector.set_normals(std::move(m_normals));
  }

public:
  Obj_reader(Input_file& file, Point_collector& collector) : m_file(file), m_collector(collector)
  {
    collector.set_normals_behind();
  }

  void read()
  {
    while (std::optional<std::string_view> line = read_line()) {
      const std::string_view keyword = next_word(*line);
      if (keyword == "vn")
        read_normal(*line);
      else if (keyword == "f")
        read_face(*line);
      else if (keyword == "v") {
        const Point_row row = parse_row(m_file, *line, false);
        if (m_collector.wants_properties())
          read_color(m_file, *line, m_collector);
        m_collector.add(row);
      }
    }
    if (m_collector.number_of_rows() == 0)
      m_file.refuse("the file has no vertex, a line that begins with v");
    hand_over_normals();
  }
};

} // namespace

void read_obj(Input_file& file, Point_collector& collector) { Obj_reader(file, collector).read(); }

} // namespace l0_tool
