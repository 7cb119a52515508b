// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/parse_numbers.h"
#include "formats/Text_columns.h"
#include "formats/readers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

using Cells = std::vector<std::string_view>;

void remove_prefix(std::string_view& text, std::string_view prefix)
{
  if (text.substr(0, prefix.size()) == prefix)
    text.remove_prefix(prefix.size());
}

/// The one that the line has most of, or a blank: then any number of them separates two cells.
char find_separator(std::string_view line)
{
  char separator = ' ';
  std::ptrdiff_t most = 0;
  for (const char candidate : {',', ';', '\t'}) {
    const std::ptrdiff_t n = std::count(line.begin(), line.end(), candidate);
    if (n > most) {
      most = n;
      separator = candidate;
    }
  }
  return separator;
}

/// Cuts a cell in quotes off `line`; nothing if it does not end.
std::optional<std::string_view> take_quoted_cell(std::string_view& line)
{
  std::size_t end = line.find('"', 1);
  while (end != std::string_view::npos && line.substr(end + 1, 1) == "\"")
    end = line.find('"', end + 2); // two of them stand for one
  if (end == std::string_view::npos)
    return std::nullopt;
  const std::string_view cell = line.substr(1, end - 1);
  line.remove_prefix(end + 1);
  return cell;
}

/// Finds the cells of a line, without their quotes and blanks.
/// \returns what is wrong with the line, or nothing
std::string split_cells(std::string_view line, char separator, Cells& cells)
{
  cells.clear();
  line = separator == '\t' ? line : trimmed(line);
  for (;;) {
    line.remove_prefix((std::min)(line.find_first_not_of(' '), line.size()));
    std::optional<std::string_view> quoted;
    if (line.substr(0, 1) == "\"") {
      quoted = take_quoted_cell(line);
      if (!quoted)
        return "a cell in quotes does not end in its line";
    }
    const std::size_t end = line.find(separator);
    const std::string_view plain = trimmed(line.substr(0, end));
    if (quoted && !plain.empty())
      return printable(plain) + " stands behind a cell in quotes";
    if (cells.size() == max_number_of_columns)
      return "more than " + std::to_string(max_number_of_columns) + " columns";
    cells.push_back(quoted.value_or(plain));
    if (end == std::string_view::npos)
      return "";
    line.remove_prefix(end + 1);
  }
}

std::string lower_case(std::string_view text)
{
  std::string lower;
  std::transform(text.begin(), text.end(), std::back_inserter(lower),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return lower;
}

/// What columns have other names for, in lower case; the second ones are those of ParaView.
constexpr std::array<std::pair<std::string_view, std::string_view>, 19> synonyms = {
  {{"alpha", "alpha"},
   {"x", "x"},
   {"y", "y"},
   {"z", "z"},
   {"points:0", "x"},
   {"points:1", "y"},
   {"points:2", "z"},
   {"nx", "nx"},
   {"ny", "ny"},
   {"nz", "nz"},
   {"normal_x", "nx"},
   {"normal_y", "ny"},
   {"normal_z", "nz"},
   {"normals:0", "nx"},
   {"normals:1", "ny"},
   {"normals:2", "nz"},
   {"red", "red"},
   {"green", "green"},
   {"blue", "blue"}}};

/// As Text_columns knows it: a column without a name is left out.
std::string name_of(std::string_view cell)
{
  const std::string lower = lower_case(cell);
  for (const auto& [synonym, name] : synonyms)
    if (lower == synonym)
      return std::string(name);
  std::string name(cell.empty() ? "-" : cell);
  std::replace_if(
    name.begin(), name.end(), [](char c) { return c <= ' ' || c > '~' || c == '"'; }, '_');
  return name;
}

/// The three names that follow from the first letters, if all of them are there.
void expand_letters(Column_names& names)
{
  static constexpr std::array<std::pair<const char*, const char*>, 4> letters = {
    {{"r", "red"}, {"g", "green"}, {"b", "blue"}, {"a", "alpha"}}};
  const auto find = [&](const std::string& letter) {
    return std::find_if(names.begin(), names.end(),
                        [&](const std::string& name) { return lower_case(name) == letter; });
  };
  if (find("r") == names.end() || find("g") == names.end() || find("b") == names.end())
    return;
  for (const auto& [letter, name] : letters) {
    const auto found = find(letter);
    if (found != names.end())
      *found = name;
  }
}

bool has(const Column_names& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The names in the header, or nothing if the line is none.
std::optional<Column_names> parse_header(std::string_view line, char separator)
{
  Cells cells;
  if (!split_cells(line, separator, cells).empty())
    return std::nullopt;
  Column_names names;
  std::transform(cells.begin(), cells.end(), std::back_inserter(names), name_of);
  expand_letters(names);
  if (has(names, "x") && has(names, "y") && has(names, "z"))
    return names;
  return std::nullopt;
}

/// The next line that is not empty.
std::optional<std::string_view> read_content(Input_file& file)
{
  while (const std::optional<std::string_view> line = file.read_line())
    if (!trimmed(*line).empty())
      return line;
  return std::nullopt;
}

bool is_comment(std::string_view line)
{
  const std::string_view text = trimmed(line);
  return text.substr(0, 1) == "#" || text.substr(0, 2) == "//";
}

class Csv_reader
{
  Input_file& m_file;
  Point_collector& m_collector;
  Column_names m_names;
  char m_separator = ',';
  Cells m_cells;

  void warn_of_column(std::size_t k, const std::string& reason)
  {
    if (m_collector.wants_properties())
      m_collector.warn("the column " + printable(m_names[k]) + " is left out: " + reason);
    m_names[k] = "-";
  }

  /// Leaves the names as Text_columns needs them.
  void check_names()
  {
    const bool has_normals = has(m_names, "nx") && has(m_names, "ny") && has(m_names, "nz");
    for (std::size_t k = 0; k < m_names.size(); ++k) {
      const std::string& name = m_names[k];
      const bool is_again = std::find(m_names.begin(), m_names.begin() + std::ptrdiff_t(k), name)
                            != m_names.begin() + std::ptrdiff_t(k);
      const bool is_normal = name == "nx" || name == "ny" || name == "nz";
      if (is_again && (name == "x" || name == "y" || name == "z" || is_normal))
        m_file.refuse("two columns " + name);
      if (is_again && name != "-")
        warn_of_column(k, "another one has that name");
      else if (is_normal && !has_normals)
        warn_of_column(k, "a normal needs nx, ny and nz");
    }
  }

  /// Reads to behind the header, which may look like a comment.
  /// \returns the first row
  std::optional<std::string_view> read_header()
  {
    std::optional<std::string_view> line = read_content(m_file);
    if (line)
      remove_prefix(*line, "\xef\xbb\xbf"); // the mark of UTF-8
    for (; line; line = read_content(m_file)) {
      std::string_view text = trimmed(*line);
      remove_prefix(text, text.substr(0, 1) == "#" ? "#" : "//");
      m_separator = find_separator(text);
      const std::optional<Column_names> names = parse_header(text, m_separator);
      if (names && m_names.empty())
        m_names = *names;
      if (names)
        return read_row();
      if (is_comment(*line))
        continue;
      if (m_names.empty())
        m_file.refuse("the line does not name columns x, y and z; --columns can name them");
      split(*line);
      const auto x = std::find(m_names.begin(), m_names.end(), "x") - m_names.begin();
      return parse_number<double>(m_cells[std::size_t(x)]) ? line : read_row();
    }
    m_file.refuse("the file has no line that names columns x, y and z");
  }

  std::optional<std::string_view> read_row()
  {
    std::optional<std::string_view> line = read_content(m_file);
    while (line && is_comment(*line))
      line = read_content(m_file);
    return line;
  }

  void split(std::string_view line)
  {
    const std::string fault = split_cells(line, m_separator, m_cells);
    if (!fault.empty())
      m_file.refuse(fault);
    if (m_cells.size() != m_names.size())
      m_file.refuse(std::to_string(m_names.size()) + " columns have names, found "
                    + std::to_string(m_cells.size()));
  }

  /// Those whose first value is a text.
  void leave_out_texts()
  {
    static constexpr std::array<const char*, 6> coordinates = {"x", "y", "z", "nx", "ny", "nz"};
    for (std::size_t k = 0; k < m_names.size(); ++k) {
      const bool is_needed = std::find(coordinates.begin(), coordinates.end(), m_names[k])
                             != coordinates.end();
      if (!is_needed && m_names[k] != "-" && m_names[k] != "_" && !m_cells[k].empty()
          && !parse_number<double>(m_cells[k]))
        warn_of_column(k, printable(m_cells[k]) + " is not a number");
    }
  }

public:
  Csv_reader(Input_file& file, Point_collector& collector, const Column_names& names)
    : m_file(file), m_collector(collector), m_names(names)
  {}

  void read()
  {
    std::optional<std::string_view> line = read_header();
    check_names();
    if (line) {
      split(*line);
      leave_out_texts();
    }
    Text_columns columns(m_names, m_collector);
    while (line) {
      columns.read(m_file, m_cells);
      line = read_row();
      if (line)
        split(*line);
    }
    columns.choose_types();
  }
};

} // namespace

void read_csv(Input_file& file, Point_collector& collector, const Column_names& names)
{
  Csv_reader(file, collector, names).read();
}

} // namespace l0_tool
