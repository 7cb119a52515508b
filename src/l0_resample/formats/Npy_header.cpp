// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Npy_header.h"

#include "basis/Number_type.h"
#include "basis/parse_numbers.h"
#include "formats/Named_columns.h"

#include <cstddef>
#include <string_view>
#include <utility>

namespace l0_tool {
namespace {

constexpr int max_depth = 8; // of records within records

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
    const char quote = next_is("\"") ? '"' : '\'';
    expect(std::string_view(&quote, 1));
    const std::size_t end = m_rest.find(quote);
    if (end == std::string_view::npos)
      m_file.refuse("a string of the header does not end");
    std::string text(m_rest.substr(0, end));
    m_rest.remove_prefix(end + 1);
    return text;
  }

  /// What a shape counts.
  std::uint64_t parse_count()
  {
    std::uint64_t count = 1;
    for (const std::uint64_t number : parse_shape()) {
      if (number == 0 || number > max_number_of_columns / count)
        m_file.refuse("a field of a record has more than " + std::to_string(max_number_of_columns)
                      + " values, or none");
      count *= number;
    }
    return count;
  }

  /// The fields of a record, behind their bracket: pairs of a name, maybe one with a title, and a
  /// type, which may be those of another record; maybe with a shape.
  void parse_fields(const std::string& parent, int depth, std::vector<Npy_field>& fields)
  {
    if (depth == max_depth)
      m_file.refuse("the records are nested more than " + std::to_string(max_depth) + " deep");
    while (!take("]")) {
      expect("(");
      std::string name;
      if (take("(")) {
        parse_string();
        expect(",");
        name = parse_string();
        expect(")");
      } else
        name = parse_string();
      expect(",");
      const std::size_t first_inner = fields.size();
      const bool is_record = take("[");
      if (is_record)
        parse_fields(name, depth + 1, fields);
      else
        fields.push_back({name, parent, parse_string(), 1});
      const std::uint64_t count = take(",") && !next_is(")") ? parse_count() : 1;
      if (is_record)
        repeat(first_inner, count, fields);
      else
        fields.back().count = count;
      if (fields.size() > max_number_of_columns)
        m_file.refuse("more than " + std::to_string(max_number_of_columns) + " fields");
      expect(")");
      if (!take(",")) {
        expect("]");
        break;
      }
    }
  }

  void repeat(std::size_t first, std::uint64_t count, std::vector<Npy_field>& fields)
  {
    const std::vector<Npy_field> once(fields.begin() + std::ptrdiff_t(first), fields.end());
    if (once.size() * count > max_number_of_columns)
      m_file.refuse("more than " + std::to_string(max_number_of_columns) + " fields");
    for (std::uint64_t k = 1; k < count; ++k)
      fields.insert(fields.end(), once.begin(), once.end());
  }

  bool next_is(std::string_view text)
  {
    skip_blanks();
    return m_rest.substr(0, text.size()) == text;
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
      take("L"); // of a long number of Python 2
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
        header.has_records = take("[");
        std::vector<Npy_field> fields;
        if (header.has_records)
          parse_fields("", 0, fields);
        else
          fields.push_back({"", "", parse_string(), 1});
        set(header.fields, std::move(fields), name);
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
    if (!header.fields || !header.is_column_by_column || !header.shape)
      m_file.refuse("the header lacks one of descr, fortran_order and shape");
    return header;
  }
};

std::uint64_t read_little_endian(Input_file& file, std::size_t size)
{
  return little_endian_at(file.read_bytes(size), size);
}

} // namespace

Npy_header read_npy_header(Input_file& file)
{
  constexpr std::string_view magic = "\x93NUMPY";
  if (std::string_view(file.read_bytes(magic.size()), magic.size()) != magic)
    file.refuse("the file does not begin as an NPY file does; of an NPZ, which is a ZIP of "
                "these, unzip takes one out");
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

} // namespace l0_tool
