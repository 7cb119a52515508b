// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_points.h"

#include "Output_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace l0_tool {
namespace {

using Row = std::array<double, 6>;

Row row_of(const Oriented_point& p)
{
  return {p.first.x(), p.first.y(), p.first.z(), p.second.x(), p.second.y(), p.second.z()};
}

constexpr std::size_t longest_number = 24;   // "-2.2250738585072014e-308"

void write_text_row(Output_file& file, const Row& row)
{
  std::array<char, 6 * (longest_number + 1)> text;
  char* end = text.data();
  for (const double number : row) {
    // The shortest text that reads as the same number
    end = std::to_chars(end, text.data() + text.size(), number).ptr;
    *end++ = ' ';
  }
  end[-1] = '\n';
  file.write({text.data(), std::size_t(end - text.data())});
}

template <typename Bits, typename Number>
void write_binary_row(Output_file& file, const Row& row)
{
  std::array<char, 6 * sizeof(Bits)> bytes;
  std::size_t k = 0;
  for (const double number : row) {
    const Number stored = Number(number);
    Bits bits;
    std::memcpy(&bits, &stored, sizeof(bits));
    for (std::size_t byte = 0; byte < sizeof(Bits); ++byte)
      bytes[k++] = char(static_cast<unsigned char>(bits >> (8 * byte)));
  }
  file.write({bytes.data(), bytes.size()});
}

/// Whether `float` holds the points to a millionth of their diagonal: not if they lie far from the origin, or beyond
/// its range.
bool is_single_precision_enough(const std::vector<Oriented_point>& points)
{
  constexpr double share = 1e-6;
  double largest = 0, squared_diagonal = 0;
  for (int axis = 0; axis < 3 && !points.empty(); ++axis) {
    const auto less = [axis](const Oriented_point& a, const Oriented_point& b)
    { return a.first[axis] < b.first[axis]; };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), less);
    largest = (std::max)({largest, std::abs(low->first[axis]), std::abs(high->first[axis])});
    squared_diagonal += (high->first[axis] - low->first[axis]) * (high->first[axis] - low->first[axis]);
  }
  using Limits = std::numeric_limits<float>;
  const double rounding = (std::max)(largest * double(Limits::epsilon()) / 2, double(Limits::denorm_min()));
  return largest < double((Limits::max)()) && rounding <= share * std::sqrt(squared_diagonal);
}

std::string ply_header(std::size_t number_of_points)
{
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(number_of_points) + "\n";
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    text += std::string("property double ") + name + "\n";
  return text + "end_header\n";
}

std::string pcd_header(std::size_t number_of_points, bool is_single)
{
  const std::string n = std::to_string(number_of_points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z\n"
         + std::string(is_single ? "SIZE 4 4 4 4 4 4\n" : "SIZE 8 8 8 8 8 8\n")
         + "TYPE F F F F F F\nCOUNT 1 1 1 1 1 1\nWIDTH " + n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n
         + "\nDATA binary\n";
}

std::string npy_header(std::size_t number_of_points)
{
  std::string text =
    "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(number_of_points) + ", 6), }";
  // The data begins at a multiple of 64 bytes, behind ten bytes of magic and length, the text and a line end.
  text.append(63 - (10 + text.size()) % 64, ' ');
  text += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + char(text.size()) + '\0' + text;
}

void write_rows(Output_file& file, const std::vector<Oriented_point>& points,
                void (*write_row)(Output_file&, const Row&))
{
  for (const Oriented_point& point : points)
    write_row(file, row_of(point));
}

} // namespace

void write_points(const std::string& path, File_format format, const std::vector<Oriented_point>& points)
{
  const auto write_single_row = write_binary_row<std::uint32_t, float>;
  const auto write_double_row = write_binary_row<std::uint64_t, double>;
  Output_file file(path);
  switch (format) {
  case File_format::PLY:
    file.write(ply_header(points.size()));
    write_rows(file, points, write_double_row);
    break;
  case File_format::OFF:
    file.write("NOFF\n" + std::to_string(points.size()) + " 0 0\n");
    write_rows(file, points, write_text_row);
    break;
  case File_format::XYZ:
    write_rows(file, points, write_text_row);
    break;
  case File_format::PCD: {
    const bool is_single = is_single_precision_enough(points);
    file.write(pcd_header(points.size(), is_single));
    write_rows(file, points, is_single ? write_single_row : write_double_row);
    break;
  }
  case File_format::NPY:
    file.write(npy_header(points.size()));
    write_rows(file, points, write_double_row);
    break;
  }
  file.commit();
}

std::uint64_t largest_file_size(File_format format, std::uint64_t number_of_points)
{
  constexpr std::uint64_t header_size = 1024;
  const bool is_text = format == File_format::OFF || format == File_format::XYZ;
  return header_size + number_of_points * (is_text ? 6 * (longest_number + 1) : sizeof(Row));
}

} // namespace l0_tool
