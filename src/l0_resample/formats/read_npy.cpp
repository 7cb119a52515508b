// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/little_endian.h"
#include "basis/parse_numbers.h"
#include "formats/readers.h"

#include "basis/Number_type.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

struct Npy_header
{
  std::optional<std::string> type;
  std::optional<bool> is_column_by_column;
  std::optional<std::vector<std::uint64_t>> shape;
};

/// Reads the one value that the header of an NPY file is: a dictionary, written as in Python.
class Npy_header_parser
{
  const Input_file& m_file;
  std::string_view m_rest;

  void skip_blanks()
  {
    while (!m_rest.empty() && (m_rest[0] == ' ' || m_rest[0] == '\n' || m_rest[0] == '\t'))
      m_rest.remove_prefix(1);
  }

  /// Takes the text if it comes next.
  bool take(std::string_view text)
  {
    skip_blanks();
    if (m_rest.substr(0, text.size()) != text)
      return false;
    m_rest.remove_prefix(text.size());
    return true;
  }

  void expect(std::string_view text)
  {
    if (!take(text))
      m_file.refuse("the header has " + printable(m_rest) + " where " + std::string(text)
                    + " is expected");
  }

  std::string parse_string()
  {
    expect("'");
    const std::size_t end = m_rest.find('\'');
    if (end == std::string_view::npos)
      m_file.refuse("a string of the header does not end");
    std::string text(m_rest.substr(0, end));
    m_rest.remove_prefix(end + 1);
    return text;
  }

  bool parse_bool()
  {
    if (take("True"))
      return true;
    expect("False");
    return false;
  }

  std::vector<std::uint64_t> parse_shape()
  {
    std::vector<std::uint64_t> shape;
    expect("(");
    while (!take(")")) {
      skip_blanks();
      const std::string_view digits = m_rest.substr(0, m_rest.find_first_not_of("0123456789"));
      const std::optional<std::uint64_t> number = parse_number<std::uint64_t>(digits);
      if (!number || shape.size() == 32)
        m_file.refuse("the shape in the header is not one of numbers that fit");
      shape.push_back(*number);
      m_rest.remove_prefix(digits.size());
      if (!take(",")) {
        expect(")");
        break;
      }
    }
    return shape;
  }

  template <typename T>
  void set(std::optional<T>& member, T value, const std::string& name)
  {
    if (member)
      m_file.refuse("the header has " + printable(name) + " twice");
    member = std::move(value);
  }

public:
  Npy_header_parser(const Input_file& file, std::string_view text) : m_file(file), m_rest(text) {}

  Npy_header parse()
  {
    Npy_header header;
    expect("{");
    while (!take("}")) {
      const std::string name = parse_string();
      expect(":");
      if (name == "descr") {
        if (take("["))
          m_file.refuse("the array has named columns; a plain one of numbers is expected");
        set(header.type, parse_string(), name);
      } else if (name == "fortran_order")
        set(header.is_column_by_column, parse_bool(), name);
      else if (name == "shape")
        set(header.shape, parse_shape(), name);
      else
        m_file.refuse(printable(name) + " is not a name of an NPY header");
      if (!take(",")) {
        expect("}");
        break;
      }
    }
    skip_blanks();
    if (!m_rest.empty())
      m_file.refuse("the header goes on after its end with " + printable(m_rest));
    if (!header.type || !header.is_column_by_column || !header.shape)
      m_file.refuse("the header lacks one of descr, fortran_order and shape");
    return header;
  }
};

std::uint64_t read_little_endian(Input_file& file, std::size_t size)
{
  return little_endian_at(file.read_bytes(size), size);
}

Npy_header read_npy_header(Input_file& file)
{
  constexpr std::string_view magic = "\x93NUMPY";
  if (std::string_view(file.read_bytes(magic.size()), magic.size()) != magic)
    file.refuse("the file does not begin as an NPY file does");
  const std::uint64_t version = read_little_endian(file, 1);
  if (version < 1 || version > 3)
    file.refuse("version 1, 2 or 3 of NPY expected, found " + std::to_string(version));
  read_little_endian(file, 1); // the minor version
  const std::uint64_t length = read_little_endian(file, version == 1 ? 2 : 4);
  if (length > Input_file::max_block_length)
    file.refuse("the header is longer than " + std::to_string(Input_file::max_block_length)
                + " bytes");
  const std::string text(file.read_bytes(std::size_t(length)), std::size_t(length));
  return Npy_header_parser(file, text).parse();
}

/// How the numbers of an array are stored.
class Npy_numbers
{
  bool m_are_floats;
  bool m_are_signed;
  std::size_t m_size; // of one, in bytes
  bool m_swap;

  std::optional<Number_type> type() const
  {
    switch (m_size) {
    case 1: return m_are_signed ? Number_type::INT8 : Number_type::UINT8;
    case 2: return m_are_signed ? Number_type::INT16 : Number_type::UINT16;
    case 4:
      return m_are_floats   ? Number_type::FLOAT32
             : m_are_signed ? Number_type::INT32
                            : Number_type::UINT32;
    default: return m_are_floats ? std::make_optional(Number_type::FLOAT64) : std::nullopt;
    }
  }

public:
  /// \param name as NumPy has it, such as "<f4"
  Npy_numbers(const Input_file& file, const std::string& name)
  {
    static constexpr std::array<std::string_view, 8> integers = {"i1", "u1", "i2", "u2",
                                                                 "i4", "u4", "i8", "u8"};
    const std::string_view kind = std::string_view(name).substr(
      (std::min)(name.size(), std::size_t(1)));
    const char order = name.empty() ? ' ' : name[0];
    const bool is_integer = std::find(integers.begin(), integers.end(), kind) != integers.end();
    m_are_floats = kind == "f4" || kind == "f8";
    if ((!is_integer && !m_are_floats)
        || (order != '<' && order != '>' && (order != '|' || kind[1] != '1')))
      file.refuse("the numbers are of type " + printable(name)
                  + ", expected float32, float64 or integers");
    m_are_signed = kind[0] != 'u';
    m_size = std::size_t(kind[1] - '0');
    m_swap = order != '|' && (order == '<') != is_little_endian_machine();
  }

  std::size_t size() const { return m_size; }

  bool fit_single_precision() const { return type() && fits_single_precision(*type()); }

  /// Integers of 64 bits are rounded to a double.
  double number_at(const char* bytes) const
  {
    if (type())
      return decode(bytes, *type(), m_swap);
    char copy[8];
    std::copy_n(bytes, sizeof copy, copy);
    if (m_swap)
      std::reverse(copy, copy + sizeof copy);
    std::uint64_t number;
    std::memcpy(&number, copy, sizeof number);
    return m_are_signed ? double(std::int64_t(number)) : double(number);
  }
};

void read_rows(Input_file& file, std::uint64_t number_of_points, std::size_t columns,
               const Npy_numbers& numbers, Point_collector& collector)
{
  collector.announce(number_of_points, columns * numbers.size());
  Point_row row = {};
  for (std::uint64_t i = 0; i < number_of_points; ++i) {
    const char* bytes = file.read_bytes(columns * numbers.size());
    for (std::size_t k = 0; k < columns; ++k)
      row[k] = numbers.number_at(bytes + k * numbers.size());
    collector.add(row);
  }
}

/// In the order of Fortran: each column is needed before the first point.
void read_columns(Input_file& file, std::uint64_t number_of_points, std::size_t columns,
                  const Npy_numbers& numbers, Point_collector& collector)
{
  const std::uint64_t row_size = columns * numbers.size();
  file.check_count(number_of_points, row_size, "points");
  if (number_of_points > (std::numeric_limits<std::uint64_t>::max)() / row_size)
    file.refuse("the shape in the header is not one of numbers that fit");
  collector.announce_buffer(number_of_points, number_of_points * row_size);
  std::vector<char> buffer;
  if (file.bytes_left()) // of a pipe nothing backs the number
    buffer.reserve(std::size_t(number_of_points * row_size));
  for (std::uint64_t left = number_of_points * row_size; left > 0;) {
    const auto n = std::size_t((std::min)(left, std::uint64_t(Input_file::max_block_length)));
    const char* bytes = file.read_bytes(n);
    buffer.insert(buffer.end(), bytes, bytes + n);
    left -= n;
  }
  collector.reserve(number_of_points);
  const std::size_t column_size = std::size_t(number_of_points) * numbers.size();
  Point_row row = {};
  for (std::size_t i = 0; i < number_of_points; ++i) {
    for (std::size_t k = 0; k < columns; ++k)
      row[k] = numbers.number_at(buffer.data() + k * column_size + i * numbers.size());
    collector.add(row);
  }
}

} // namespace

void read_npy(Input_file& file, Point_collector& collector)
{
  const Npy_header header = read_npy_header(file);
  const Npy_numbers numbers(file, *header.type);
  const std::vector<std::uint64_t>& shape = *header.shape;
  if (shape.size() != 2 || (shape[1] != 3 && shape[1] != 6))
    file.refuse("the array is not of shape (n, 3) or (n, 6)");
  if (shape[1] == 6)
    collector.set_has_normals();
  if (numbers.fit_single_precision())
    collector.set_single_precision();
  if (*header.is_column_by_column)
    read_columns(file, shape[0], std::size_t(shape[1]), numbers, collector);
  else
    read_rows(file, shape[0], std::size_t(shape[1]), numbers, collector);
  if (file.bytes_left() > std::uint64_t(0))
    collector.warn(std::to_string(*file.bytes_left()) + " bytes after the array are not looked at");
}

} // namespace l0_tool
