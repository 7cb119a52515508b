// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/parse_numbers.h"
#include "formats/Named_columns.h"
#include "formats/Normals_behind_points.h"
#include "formats/readers.h"
#include "formats/text_cells.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A line that names columns x, y and z.
struct Header
{
  Column_names names;
  char separator;
  bool is_comment; ///< so that it may be one that has these words by chance
};

/// The names in the line, or nothing if it is no header.
std::optional<Header> parse_header(std::string_view line, bool is_comment, char separator)
{
  Header header = {{}, separator, is_comment};
  Cells cells;
  if (!split_cells(line, header.separator, cells).empty())
    return std::nullopt;
  header.names = usual_names(Column_names(cells.begin(), cells.end()));
  for (std::string& name : header.names) {
    std::replace_if(
      name.begin(), name.end(), [](char c) { return c <= ' ' || c > '~' || c == '"'; }, '_');
    if (name.empty())
      name = "-";
  }
  if (have_coordinates(header.names))
    return header;
  return std::nullopt;
}

/// The same with the separator that the line has.
std::optional<Header> find_header(std::string_view line, bool is_comment, bool has_decimal_commas)
{
  std::optional<Header> header = parse_header(line, is_comment,
                                              find_separator(line, has_decimal_commas));
  // Names have no decimal commas, and may stand without the quotes that numbers with these need
  return header || !has_decimal_commas ? header : parse_header(line, is_comment, ',');
}

/// What programs write for a value that is not there, beside NaN and nothing at all.
bool is_missing(std::string_view cell)
{
  const std::string text = folded(cell);
  return text == "na" || text == "null" || text == "none";
}

/// Whether the line tells the separator, as that before the table does which a spreadsheet opens.
bool tells_separator(std::string_view line)
{
  const std::string_view text = trimmed(line);
  return text.size() == 5 && folded(text.substr(0, 3)) == "sep" && text[3] == '=';
}

/// Takes off what begins a comment, if the line is one.
bool remove_comment_mark(std::string_view& line)
{
  const std::string_view text = trimmed(line);
  for (const std::string_view mark : {"#", "//", "%", "!", ";"})
    if (text.substr(0, mark.size()) == mark) {
      // else a separator behind an empty cell
      const bool is_mark = mark != ";" || text.find(mark, 1) == std::string_view::npos;
      if (is_mark)
        line = text.substr(mark.size());
      return is_mark;
    }
  return false;
}

/// The number of points that the line is, maybe behind what it is called, as in "Points: 1200".
std::optional<std::uint64_t> parse_count(std::string_view line)
{
  const std::string_view text = trimmed(line);
  const std::size_t colon = text.rfind(':');
  const bool has_name = colon != std::string_view::npos && lower_case(text)[0] >= 'a'
                        && lower_case(text)[0] <= 'z';
  return parse_number<std::uint64_t>(has_name ? trimmed(text.substr(colon + 1)) : text);
}

class Text_reader
{
  Input_file& m_file;
  Point_collector& m_collector;
  Column_names m_names;
  const bool m_are_names_given; // by the caller
  const bool m_needs_names;
  std::vector<Header> m_headers; // that may be that of the rows
  bool m_has_header = false;     // a line without the mark of a comment
  char m_separator = ' ';
  Vectors m_vectors = Vectors::NAMED_BY_FILE;
  Cells m_cells;
  std::vector<double> m_values;
  std::optional<std::uint64_t> m_announced; // of the block
  std::uint64_t m_rows_before = 0;          // the block

  bool has_decimal_commas() const { return m_collector.has_decimal_commas(); }

  /// What a refusal says of a line that may have decimal commas.
  std::string hint_of_commas(std::string_view line) const
  {
    const bool may_have_commas = !has_decimal_commas() && line.find(',') != std::string_view::npos;
    return may_have_commas ? "; --decimal-comma reads numbers such as 0,5" : "";
  }

  [[noreturn]] void refuse(std::string_view line, const std::string& what) const
  {
    const bool may_be_comment = m_collector.number_of_rows() == 0 && !m_cells.empty()
                                && !parse(m_cells.front());
    m_file.refuse(what + hint_of_commas(line)
                  + (may_be_comment ? "; a line that is no point has to begin with #" : ""));
  }

  std::optional<double> parse(std::string_view cell) const
  {
    std::optional<double> number;
    if (!has_decimal_commas() || cell.find('.') != std::string_view::npos)
      number = parse_number<double>(cell);
    else {
      std::string with_point(cell);
      std::replace(with_point.begin(), with_point.end(), ',', '.');
      number = parse_number<double>(with_point);
    }
    if (!number && is_missing(cell))
      number = missing;
    return number;
  }

  /// The next line that is neither empty nor a comment.
  std::optional<std::string_view> read_row()
  {
    while (std::optional<std::string_view> line = m_file.read_line()) {
      std::string_view text = *line;
      if (!trimmed(text).empty() && !remove_comment_mark(text))
        return line;
    }
    return std::nullopt;
  }

  void begin_block(std::uint64_t count)
  {
    const bool is_first = m_collector.number_of_rows() == 0;
    m_announced = count;
    m_rows_before = m_collector.number_of_rows();
    const std::size_t columns = (std::max)(m_names.size(), std::size_t(3));
    const std::uint64_t minimum_row_size = 2 * columns; // digits, blanks, a line end
    if (is_first)
      m_collector.announce(count, minimum_row_size);
    else
      m_file.check_count(count, minimum_row_size, "points");
  }

  void end_block()
  {
    const std::uint64_t n = m_collector.number_of_rows() - m_rows_before;
    if (!m_announced && n == 0 && !m_needs_names)
      m_file.refuse("the file has no points");
    if (m_announced && n < *m_announced)
      m_file.refuse("the file ends after " + std::to_string(n)
                    + " points, its first line announced " + std::to_string(*m_announced));
    if (m_announced && n > *m_announced)
      m_collector.warn("more points than the " + std::to_string(*m_announced)
                       + ", which the first line announced; all of them are used");
  }

  /// Whether the line has as many cells as there are names, and none of them is a number.
  bool is_line_of_names(std::string_view line)
  {
    const char separator = find_separator(line, has_decimal_commas());
    if (!split_cells(line, separator, m_cells).empty() || m_cells.size() != m_names.size()
        || std::any_of(m_cells.begin(), m_cells.end(),
                       [&](std::string_view cell) { return parse(cell).has_value(); }))
      return false;
    m_headers.push_back({m_names, separator, false});
    return true;
  }

  /// Reads to behind the header, which may look like a comment, and the number of points.
  /// \returns the first row
  std::optional<std::string_view> read_to_first_row()
  {
    while (std::optional<std::string_view> line = m_file.read_line()) {
      std::string_view text = *line;
      if (trimmed(text).empty() || tells_separator(text))
        continue;
      const bool is_comment = remove_comment_mark(text);
      std::optional<Header> header = m_has_header
                                       ? std::nullopt
                                       : find_header(text, is_comment, has_decimal_commas());
      if (header) {
        m_has_header = !is_comment;
        constexpr std::size_t most = 16;
        if (m_headers.size() < most)
          m_headers.push_back(std::move(*header));
        continue;
      }
      if (is_comment)
        continue;
      const bool may_begin = !m_announced || *m_announced == 0; // the first block, or an empty one
      const std::optional<std::uint64_t> count = may_begin ? parse_count(text) : std::nullopt;
      if (count) {
        begin_block(*count);
        continue;
      }
      if (m_are_names_given && !m_has_header && is_line_of_names(text)) {
        m_has_header = true;
        continue;
      }
      return line;
    }
    return std::nullopt;
  }

  /// Into cells, without an empty one behind the last separator if there is one for each column.
  /// \returns what is wrong with the row, or nothing
  std::string split_row(std::string_view row, char separator, std::size_t number_of_columns)
  {
    std::string fault = split_cells(row, separator, m_cells);
    if (fault.empty() && m_cells.size() == number_of_columns + 1 && m_cells.back().empty())
      m_cells.pop_back();
    return fault;
  }

  bool has_cells(std::string_view row, char separator, std::size_t number_of_columns)
  {
    return split_row(row, separator, number_of_columns).empty()
           && m_cells.size() == number_of_columns;
  }

  /// Of the rows, whose first one is given.
  void find_columns(std::string_view row)
  {
    const char separator_of_row = find_separator(row, has_decimal_commas());
    for (auto header = m_headers.rbegin(); header != m_headers.rend(); ++header) {
      // Names may be separated as rows are not, such as by commas over blanks.
      const bool fits = has_cells(row, header->separator, header->names.size()),
                 fits_as_row = !fits && has_cells(row, separator_of_row, header->names.size());
      if (!fits && !fits_as_row && header->is_comment)
        continue;
      m_separator = fits_as_row ? separator_of_row : header->separator;
      if (m_are_names_given)
        return;
      m_names = header->names;
      return check_column_names(m_file, m_names, m_collector);
    }
    m_separator = separator_of_row;
    if (m_separator == '\t' && !m_needs_names)
      m_separator = ' '; // which may stand beside others
    if (m_are_names_given)
      return;
    guess_names(row);
    if (!m_headers.empty() && m_headers.back().separator != ' ') // else it may be a sentence
      m_collector.warn("a comment names " + std::to_string(m_headers.back().names.size())
                       + " columns, x, y and z among them, where a row has "
                       + std::to_string(m_names.size()) + ": it was not used");
  }

  void guess_names(std::string_view row)
  {
    if (m_needs_names)
      m_file.refuse("the line does not name columns x, y and z; --columns can name them, and "
                    "--input-format xyz needs no names");
    const std::string fault = split_cells(row, m_separator, m_cells);
    const bool ends_with_separator = !m_cells.empty() && m_cells.back().empty();
    const std::size_t n = m_cells.size() - (ends_with_separator ? 1 : 0);
    if (!fault.empty() || n < 3)
      refuse(row, fault.empty() ? "a point needs 3 numbers, found " + std::to_string(n) : fault);
    m_vectors = Vectors::UNNAMED;
    const bool has_labels = begins_with_label(n);
    const std::size_t first = has_labels ? 1 : 0, coordinates = 3;
    if (has_labels)
      m_names.emplace_back("-");
    for (std::size_t k = 0; k < n - first; ++k)
      m_names.emplace_back(k < coordinates || n - first == 6 ? row_names[k] : "-");
    const bool has_rest = n - first > coordinates && n - first != 6;
    if (!m_collector.wants_properties())
      return;
    if (has_labels)
      m_collector.note("the first column is left out, as it is one of texts");
    if (has_rest)
      m_collector.leave_out_rest(has_labels ? "fourth" : "third", hint_of_commas(row));
  }

  /// Whether the first of `n` cells is the name of a point, as of a station.
  bool begins_with_label(std::size_t n) const
  {
    return n > 3 && !m_cells[0].empty() && !parse(m_cells[0]) && parse(m_cells[1])
           && parse(m_cells[2]) && parse(m_cells[3]);
  }

  void split(std::string_view line)
  {
    const std::string fault = split_row(line, m_separator, m_names.size());
    if (!fault.empty())
      refuse(line, fault);
    if (m_cells.size() == m_names.size())
      return;
    const std::string found = ", found " + std::to_string(m_cells.size()),
                      expected = std::to_string(m_names.size());
    if (m_are_names_given)
      refuse(line, "--columns names " + expected + found);
    refuse(line, m_vectors == Vectors::UNNAMED
                   ? expected + " columns expected as in the lines before" + found
                   : expected + " columns have names" + found);
  }

  /// Those whose first value is a text.
  void leave_out_texts()
  {
    for (std::size_t k = 0; k < m_names.size(); ++k) {
      const bool is_needed = std::find(row_names.begin(), row_names.end(), m_names[k])
                             != row_names.end();
      if (!is_needed && !is_left_out(m_names[k]) && !m_cells[k].empty() && !parse(m_cells[k]))
        leave_out_column(m_names[k], printable(m_cells[k]) + " is not a number", m_collector);
    }
  }

  /// Finds the numbers of the cells.
  void parse_row(std::string_view line, const Named_columns& columns)
  {
    m_values.resize(columns.size());
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (!columns.is_wanted(k))
        continue;
      const std::optional<double> number = m_cells[k].empty() ? missing : parse(m_cells[k]);
      if (!number)
        refuse(line, printable(m_cells[k]) + " is not a number"
                       + (m_collector.number_of_rows() == 0 && m_vectors == Vectors::UNNAMED
                            ? ", and no line names columns x, y and z; "
                                + m_collector.how_to_name_columns()
                            : ""));
      m_values[k] = *number;
    }
  }

  /// Whether a block begins with the line that the first one has begun with.
  bool is_header_again(std::string_view line) const
  {
    const std::optional<Header> header = m_has_header
                                           ? find_header(line, false, has_decimal_commas())
                                           : std::nullopt;
    return header && header->names == m_headers.back().names;
  }

  void read_rows(std::string_view first)
  {
    split(first);
    if (m_needs_names || !m_are_names_given)
      leave_out_texts();
    std::vector<Named_column> columns;
    for (const std::string& name : m_names)
      columns.push_back({name, std::nullopt});
    Named_columns rows(columns, m_vectors, m_collector);
    const bool may_have_normals = m_vectors == Vectors::UNNAMED && m_names.size() == 3;
    Normals_behind_points normals(m_collector, rows, may_have_normals ? m_announced : std::nullopt);
    parse_row(first, rows);
    rows.add(m_values);
    bool is_behind_count = false;
    while (const std::optional<std::string_view> line = read_row()) {
      const bool may_end = m_announced
                           && m_collector.number_of_rows() - m_rows_before >= *m_announced;
      const std::optional<std::uint64_t> count = may_end ? parse_count(*line) : std::nullopt;
      if (count) {
        normals.give_up();
        end_block();
        begin_block(*count);
        is_behind_count = true;
        continue;
      }
      if (is_behind_count && is_header_again(*line))
        continue;
      is_behind_count = false;
      split(*line);
      parse_row(*line, rows);
      if (!normals.take(m_values))
        rows.add(m_values);
    }
    normals.hand_over();
    rows.refuse_row_numbers(m_file);
  }

public:
  /// \param needs_names whether somebody has to name the columns
  Text_reader(Input_file& file, Point_collector& collector, const Column_names& names,
              bool needs_names)
    : m_file(file), m_collector(collector), m_names(names), m_are_names_given(!names.empty()),
      m_needs_names(needs_names)
  {
    if (m_are_names_given)
      m_vectors = Vectors::NAMED_BY_CALLER;
  }

  void read()
  {
    const std::optional<std::string_view> first = read_to_first_row();
    if (first) {
      const std::string row(*first);
      find_columns(row);
      read_rows(row);
    } else if (m_needs_names && m_headers.empty())
      m_file.refuse("the file has no line that names columns x, y and z");
    end_block();
  }
};

} // namespace

void read_text(Input_file& file, Point_collector& collector, const Column_names& names,
               bool needs_names)
{
  Text_reader(file, collector, names, needs_names).read();
}

} // namespace l0_tool
