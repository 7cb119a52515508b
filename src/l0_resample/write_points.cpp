// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_points.h"

#include "Output_file.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <cstring>

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

void write_binary_row(Output_file& file, const Row& row)
{
  std::array<char, sizeof(Row)> bytes;
  std::size_t k = 0;
  for (const double number : row) {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof(bits));
    for (int shift = 0; shift < 64; shift += 8)
      bytes[k++] = char(static_cast<unsigned char>(bits >> shift));
  }
  file.write({bytes.data(), bytes.size()});
}

std::string header(File_format format, std::size_t number_of_points)
{
  switch (format) {
  case File_format::PLY: {
    std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(number_of_points) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
      text += std::string("property double ") + name + "\n";
    return text + "end_header\n";
  }
  case File_format::OFF: return "NOFF\n" + std::to_string(number_of_points) + " 0 0\n";
  case File_format::XYZ: break;
  }
  return "";
}

} // namespace

void write_points(const std::string& path, File_format format, const std::vector<Oriented_point>& points)
{
  Output_file file(path);
  file.write(header(format, points.size()));
  for (const Oriented_point& point : points)
    if (format == File_format::PLY)
      write_binary_row(file, row_of(point));
    else
      write_text_row(file, row_of(point));
  file.commit();
}

std::uint64_t largest_file_size(File_format format, std::uint64_t number_of_points)
{
  constexpr std::uint64_t header_size = 1024;
  return header_size + number_of_points * (format == File_format::PLY ? sizeof(Row) : 6 * (longest_number + 1));
}

} // namespace l0_tool
