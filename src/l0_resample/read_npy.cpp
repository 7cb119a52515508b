// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parse_numbers.h"
#include "readers.h"

#include "Number_type.h"

#include <cstddef>
#include <cstdint>
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
          m_file.refuse(
            "the array has named columns; a plain one of float32 or float64 is expected");
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
  const char* bytes = file.read_bytes(size);
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < size; ++k)
    number |= std::uint64_t(static_cast<unsigned char>(bytes[k])) << (8 * k);
  return number;
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

} // namespace

void read_npy(Input_file& file, Point_collector& collector)
{
  const Npy_header header = read_npy_header(file);
  const std::string& type = *header.type;
  if (type != "<f4" && type != "<f8" && type != ">f4" && type != ">f8")
    file.refuse("the numbers are of type " + printable(type) + ", expected float32 or float64");
  const std::vector<std::uint64_t>& shape = *header.shape;
  if (shape.size() != 2 || (shape[1] != 3 && shape[1] != 6))
    file.refuse("the array is not of shape (n, 3) or (n, 6)");
  if (*header.is_column_by_column)
    file.refuse("the array is stored column by column; numpy.ascontiguousarray() brings it into "
                "the order of C");

  const Number_type number_type = type[2] == '4' ? Number_type::FLOAT32 : Number_type::FLOAT64;
  const bool swap = (type[0] == '<') != is_little_endian_machine();
  const std::size_t columns = std::size_t(shape[1]), number_size = size_of(number_type);
  if (columns == 6)
    collector.set_has_normals();
  if (fits_single_precision(number_type))
    collector.set_single_precision();
  collector.announce(shape[0], columns * number_size);
  Point_row row = {};
  for (std::uint64_t i = 0; i < shape[0]; ++i) {
    const char* bytes = file.read_bytes(columns * number_size);
    for (std::size_t k = 0; k < columns; ++k)
      row[k] = decode(bytes + k * number_size, number_type, swap);
    collector.add(row);
  }
  if (file.bytes_left() > std::uint64_t(0))
    collector.warn(std::to_string(*file.bytes_left()) + " bytes after the array are not looked at");
}

} // namespace l0_tool
