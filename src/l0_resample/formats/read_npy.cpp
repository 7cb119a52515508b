// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Number_type.h"
#include "basis/parse_numbers.h"
#include "formats/Named_columns.h"
#include "formats/Npy_header.h"
#include "formats/readers.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

/// The number of 16 bits, of which NumPy calls the type float16.
double half_of(std::uint64_t bits)
{
  const auto mantissa = double(bits & 0x3ff);
  const auto exponent = int(bits >> 10 & 0x1f);
  const double sign = (bits & 0x8000) != 0 ? -1 : 1;
  if (exponent == 0x1f)
    return mantissa == 0 ? sign * std::numeric_limits<double>::infinity()
                         : std::numeric_limits<double>::quiet_NaN();
  return sign
         * (exponent == 0 ? std::ldexp(mantissa, -24) : std::ldexp(mantissa + 1024, exponent - 25));
}

/// How the numbers of a field are stored.
class Npy_numbers
{
  char m_kind = 'V'; // as NumPy has it: floating, integer, unsigned, boolean; others are no numbers
  std::size_t m_size = 0; // of one, in bytes
  bool m_swap = false;

public:
  /// \param name as NumPy has it, such as "<f4"
  Npy_numbers(const Input_file& file, std::string_view name)
  {
    const auto refuse = [&]() {
      file.refuse("the numbers are of type " + printable(name)
                  + ", expected floating-point numbers or integers");
    };
    const std::string_view kind = name.substr((std::min)(name.size(), std::size_t(1)), 1);
    // behind the size of times stands their unit
    const std::string_view all = name.substr((std::min)(name.size(), std::size_t(2)));
    const std::optional<std::uint32_t> size = parse_number<std::uint32_t>(
      all.substr(0, all.find('[')));
    constexpr std::string_view orders = "<>|=", kinds = "fiubcSUVMmaO";
    if (kind.empty() || orders.find(name[0]) == std::string_view::npos
        || kinds.find(kind) == std::string_view::npos || kind == "O" || !size)
      refuse();
    constexpr std::uint32_t most = Input_file::max_block_length;
    m_size = (std::min)(*size, most) * (kind == "U" ? 4 : 1);
    const bool is_power = m_size == 1 || m_size == 2 || m_size == 4 || m_size == 8;
    const bool is_number = (kind == "f" && is_power && m_size > 1)
                           || ((kind == "i" || kind == "u") && is_power)
                           || (kind == "b" && m_size == 1);
    if (is_number && name[0] == '|' && m_size > 1)
      refuse();
    if (is_number)
      m_kind = kind[0];
    m_swap = (name[0] == '<' || name[0] == '>') && (name[0] == '<') != is_little_endian_machine();
  }

  std::size_t size() const { return m_size; }

  bool are_numbers() const { return m_kind != 'V'; }

  /// That holds them; nothing for integers of 64 bits, of which only values tell that.
  std::optional<Number_type> type() const
  {
    const bool is_signed = m_kind == 'i';
    if (m_kind == 'f')
      return m_size == 8 ? Number_type::FLOAT64 : Number_type::FLOAT32;
    switch (m_size) {
    case 1: return is_signed ? Number_type::INT8 : Number_type::UINT8;
    case 2: return is_signed ? Number_type::INT16 : Number_type::UINT16;
    case 4: return is_signed ? Number_type::INT32 : Number_type::UINT32;
    default: return std::nullopt;
    }
  }

  /// Integers of 64 bits are rounded to a double.
  double number_at(const char* bytes) const
  {
    if (type() && !(m_kind == 'f' && m_size == 2))
      return decode(bytes, *type(), m_swap);
    if (m_kind == 'f')
      return half_of(std::uint64_t(decode(bytes, Number_type::UINT16, m_swap)));
    return Wide_integer{m_kind == 'i'}.decode(bytes, m_swap);
  }
};

/// A column of numbers.
struct Npy_column
{
  Npy_numbers numbers;
  std::uint64_t offset; ///< of its first number
};

struct Npy_table
{
  std::uint64_t number_of_points = 1;
  std::vector<Npy_column> columns;
  Column_names names;            ///< of these
  std::uint64_t record_size = 0; ///< in bytes
  bool is_column_by_column = false;
};

std::uint64_t product(const Input_file& file, std::uint64_t a, std::uint64_t b)
{
  if (b != 0 && a > (std::numeric_limits<std::uint64_t>::max)() / b)
    file.refuse("the shape in the header is not one of numbers that fit");
  return a * b;
}

/// One column without a name for each that the shape has.
Npy_table plain_table(const Input_file& file, const Npy_header& header)
{
  // An image of points has them in rows of pixels
  std::vector<std::uint64_t> shape = *header.shape;
  for (; shape.size() > 2 && !*header.is_column_by_column; shape.erase(shape.begin()))
    shape[1] = product(file, shape[0], shape[1]);
  constexpr std::uint64_t maximum_for_transposed = 16; // columns that an array of 3 points may have
  if (shape.size() == 2 && shape[0] == 3 && shape[1] > maximum_for_transposed)
    file.refuse("the array is of shape (3, n), whose columns are the points: its transpose has "
                "them in rows");
  if (shape.size() != 2 || shape[1] < 3 || shape[1] > max_number_of_columns)
    file.refuse("the array is not of shape (n, 3), or (n, m) with more columns");
  const Npy_numbers numbers(file, header.fields->front().type);
  if (!numbers.are_numbers())
    file.refuse("the numbers are of type " + printable(header.fields->front().type)
                + ", expected floating-point numbers or integers");
  Npy_table table;
  table.number_of_points = shape[0];
  table.record_size = shape[1] * numbers.size();
  table.is_column_by_column = *header.is_column_by_column;
  // Of as many points as the file can hold, which is looked at before a point is read
  const std::uint64_t step = numbers.size() * (table.is_column_by_column ? shape[0] : 1);
  for (std::uint64_t k = 0; k < shape[1]; ++k)
    table.columns.push_back({numbers, step * k});
  return table;
}

/// The name of a field, with that of the record that it stands in where another one has it too.
std::string full_name(const Npy_field& field, const std::vector<Npy_field>& fields)
{
  const auto count = std::count_if(fields.begin(), fields.end(), [&](const Npy_field& other) {
    return other.name == field.name;
  });
  const std::string name = count > 1 && !field.parent.empty() ? field.parent + "_" + field.name
                                                              : field.name;
  return name.empty() ? "_" : name;
}

Npy_table table_of_records(const Input_file& file, const Npy_header& header,
                           Point_collector& collector)
{
  Npy_table table;
  for (const std::uint64_t number : *header.shape)
    table.number_of_points = product(file, table.number_of_points, number);
  for (const Npy_field& field : *header.fields) {
    const Npy_numbers numbers(file, field.type);
    std::string name = full_name(field, *header.fields);
    if (!numbers.are_numbers() && !is_left_out(name))
      leave_out_column(name, "of type " + field.type, collector);
    const std::uint64_t begin = table.record_size;
    table.record_size += product(file, numbers.size(), field.count);
    if (table.record_size > Input_file::max_block_length)
      file.refuse("the records have more than " + std::to_string(Input_file::max_block_length)
                  + " bytes");
    if (!numbers.are_numbers())
      continue;
    for (const std::string& each : names_of_values(name, std::size_t(field.count)))
      table.names.push_back(each);
    for (std::uint64_t k = 0; k < field.count; ++k)
      table.columns.push_back({numbers, begin + k * numbers.size()});
    if (table.columns.size() > max_number_of_columns)
      file.refuse("the records have more than " + std::to_string(max_number_of_columns)
                  + " numbers");
  }
  if (table.record_size == 0)
    file.refuse("the records have no fields");
  return table;
}

/// Names them as the caller wants, or as the file does, or as arrays of points mostly are.
/// \returns what nx, ny, nz are
Vectors name_columns(const Input_file& file, bool has_records, const Column_names& names,
                     Npy_table& table, Point_collector& collector)
{
  const std::size_t n = table.columns.size();
  if (!names.empty()) {
    if (names.size() != n)
      file.refuse("--columns names " + std::to_string(names.size()) + ", found " + std::to_string(n)
                  + " columns");
    table.names = names;
    return Vectors::NAMED_BY_CALLER;
  }
  if (!has_records) {
    for (std::size_t k = 0; k < n; ++k)
      table.names.emplace_back(k < 3 || n == 6 ? row_names[k] : "-");
    if (n > 3 && n != 6 && collector.wants_properties())
      collector.leave_out_rest("third");
    return Vectors::UNNAMED;
  }
  std::string all;
  for (const std::string& name : table.names)
    all += (all.empty() ? "" : ", ") + printable(name);
  table.names = usual_names(std::move(table.names));
  for (std::string& name : table.names)
    std::replace_if(
      name.begin(), name.end(), [](char c) { return c <= ' ' || c > '~'; }, '_');
  if (!have_coordinates(table.names))
    file.refuse("the records have no fields x, y and z; --columns can name theirs, which are "
                + all.substr(0, 200));
  check_column_names(file, table.names, collector);
  return Vectors::NAMED_BY_FILE;
}

/// In the order of Fortran: each column is needed before the first point.
std::vector<char> read_buffer(Input_file& file, std::uint64_t number_of_points,
                              std::uint64_t row_size, Point_collector& collector)
{
  file.check_count(number_of_points, row_size, "points");
  const std::uint64_t size = product(file, number_of_points, row_size);
  collector.announce_buffer(number_of_points, size);
  std::vector<char> buffer;
  if (file.bytes_left()) // of a pipe nothing backs the number
    buffer.reserve(std::size_t(size));
  for (std::uint64_t left = size; left > 0;) {
    const auto n = std::size_t((std::min)(left, std::uint64_t(Input_file::max_block_length)));
    const char* bytes = file.read_bytes(n);
    buffer.insert(buffer.end(), bytes, bytes + n);
    left -= n;
  }
  collector.reserve(number_of_points);
  return buffer;
}

void read_table(Input_file& file, const Npy_table& table, Vectors vectors,
                Point_collector& collector)
{
  std::vector<Named_column> names;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const std::optional<Number_type> type = table.columns[k].numbers.type();
    const auto in_row = std::find(row_names.begin(), row_names.end(), table.names[k]);
    if (in_row != row_names.end())
      collector.set_type_in_row(std::size_t(in_row - row_names.begin()), type);
    names.push_back({table.names[k], type});
  }
  Named_columns rows(names, vectors, collector);
  std::vector<double> values(table.columns.size());
  const auto add = [&](const char* bytes, std::uint64_t row) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto& [numbers, offset] = table.columns[k];
      if (rows.is_wanted(k))
        values[k] = numbers.number_at(bytes + offset + row * numbers.size());
    }
    rows.add(values);
  };
  const std::uint64_t n = table.number_of_points;
  if (table.is_column_by_column) {
    const std::vector<char> buffer = read_buffer(file, n, table.record_size, collector);
    for (std::uint64_t i = 0; i < n; ++i)
      add(buffer.data(), i);
  } else {
    collector.announce(n, table.record_size);
    for (std::uint64_t i = 0; i < n; ++i)
      add(file.read_bytes(std::size_t(table.record_size)), 0);
  }
  rows.refuse_row_numbers(file);
}

} // namespace

void read_npy(Input_file& file, Point_collector& collector, const Column_names& names)
{
  const Npy_header header = read_npy_header(file);
  Npy_table table = header.has_records ? table_of_records(file, header, collector)
                                       : plain_table(file, header);
  const Vectors vectors = name_columns(file, header.has_records, names, table, collector);
  read_table(file, table, vectors, collector);
  warn_of_rest(file, "number", collector);
}

} // namespace l0_tool
