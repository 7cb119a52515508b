// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEST_TOOL_LAS_H
#define L0_RESAMPLE_TEST_TOOL_LAS_H

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include "formats/write_points.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace tool_test {

// LAS files byte by byte, by the tables of the specification and not by those of the reader.

template <typename T>
std::string le(T number)
{
  return bytes_of(number, false);
}

inline std::string padded(const std::string& text, std::size_t size)
{
  return text + std::string(size - text.size(), '\0');
}

/// The fields of a point, in the units of the file. The defaults are within the range of all
/// formats.
struct Las_point
{
  std::int32_t x = 0, y = 0, z = 0;
  unsigned intensity = 40000, return_number = 2, number_of_returns = 3, direction = 1, edge = 0;
  unsigned classification = 17, flags = 3, channel = 2; ///< flags: synthetic 1, key 2, withheld 4
  unsigned user_data = 201, source = 50001;
  int angle = -15;
  double time = 123456.78125;
  std::array<unsigned, 3> color = {65535, 1000, 256};
  unsigned infrared = 60000;

  std::string bytes(unsigned format) const
  {
    const auto byte = [](unsigned value) { return std::string(1, char(value)); };
    const auto color_bytes = [&]() {
      return le(std::uint16_t(color[0])) + le(std::uint16_t(color[1]))
             + le(std::uint16_t(color[2]));
    };
    const std::string wave(29, '\7');
    std::string all = le(x) + le(y) + le(z) + le(std::uint16_t(intensity));
    if (format < 6)
    {
      all += byte(return_number | number_of_returns << 3 | direction << 6 | edge << 7)
             + byte(classification | flags << 5) + byte(unsigned(angle)) + byte(user_data)
             + le(std::uint16_t(source));
      if (format == 1 || format >= 3)
        all += le(time);
      if (format == 2 || format == 3 || format == 5)
        all += color_bytes();
      return format >= 4 ? all + wave : all;
    }
    all += byte(return_number | number_of_returns << 4)
           + byte(flags | channel << 4 | direction << 6 | edge << 7) + byte(classification)
           + byte(user_data) + le(std::int16_t(angle)) + le(std::uint16_t(source)) + le(time);
    if (format == 7 || format == 8 || format == 10)
      all += color_bytes();
    if (format == 8 || format == 10)
      all += le(std::uint16_t(infrared));
    return format >= 9 ? all + wave : all;
  }
};

inline std::string las_record(const std::string& user, unsigned id, const std::string& data)
{
  return std::string(2, '\0') + padded(user, 16) + le(std::uint16_t(id))
         + le(std::uint16_t(data.size())) + padded("a record", 32) + data;
}

inline std::string las_extended_record(const std::string& user, unsigned id,
                                       const std::string& data)
{
  return std::string(2, '\0') + padded(user, 16) + le(std::uint16_t(id))
         + le(std::uint64_t(data.size())) + padded("a record", 32) + data;
}

/// What describes one field of extra bytes.
inline std::string extra_bytes(const std::string& name, unsigned type, unsigned options = 0,
                               const std::array<double, 3>& scale = {},
                               const std::array<double, 3>& shift = {})
{
  std::string text = std::string(2, '\0') + char(type) + char(options) + padded(name, 32)
                     + std::string(76, '\0');
  for (const double number : scale)
    text += le(number);
  for (const double number : shift)
    text += le(number);
  return text + std::string(32, '\0');
}

struct Las_file
{
  unsigned minor = 2, format = 0;
  std::vector<std::string> points; ///< bytes
  std::vector<std::string> records, extended_records;
  std::string before_points; ///< what no record has
  unsigned encoding = 0;
  std::array<double, 3> scale = {0.01, 0.01, 0.001}, offset = {1000, 2000, -5};

  std::string bytes() const
  {
    static constexpr std::array<std::size_t, 5> sizes = {227, 227, 227, 235, 375};
    std::string body, extended;
    for (const std::string& record : records)
      body += record;
    const std::size_t begin = sizes[minor] + body.size() + before_points.size();
    body += before_points;
    for (const std::string& point : points)
      body += point;
    for (const std::string& record : extended_records)
      extended += record;
    const std::size_t point_size = points.empty() ? Las_point().bytes(format).size()
                                                  : points[0].size();
    const auto count = std::uint32_t(points.size());
    std::string head = "LASF" + le(std::uint16_t(7)) + le(std::uint16_t(encoding))
                       + std::string(16, 'g') + '\1' + char(minor) + padded("made", 32)
                       + padded("for a test", 32) + le(std::uint16_t(100)) + le(std::uint16_t(2020))
                       + le(std::uint16_t(sizes[minor])) + le(std::uint32_t(begin))
                       + le(std::uint32_t(records.size())) + char(format)
                       + le(std::uint16_t(point_size)) + le(minor < 4 ? count : 0u)
                       + std::string(20, '\0');
    for (const auto& numbers : {scale, offset})
      for (const double number : numbers)
        head += le(number);
    head += std::string(48, '\0'); // the extent, which is not needed
    if (minor >= 3)
      head += le(std::uint64_t(0));
    if (minor >= 4)
      head += le(std::uint64_t(extended.empty() ? 0 : sizes[minor] + body.size()))
              + le(std::uint32_t(extended_records.size())) + le(std::uint64_t(count))
              + std::string(120, '\0');
    return head + body + extended;
  }
};

/// The file with other bytes from `position` on.
inline std::string with_bytes(std::string file, std::size_t position, const std::string& bytes)
{
  return file.replace(position, bytes.size(), bytes);
}

inline l0_tool::Read_options everything()
{
  l0_tool::Read_options options;
  options.with_normals = true;
  options.with_properties = true;
  options.with_wide_colors = true;
  return options;
}

inline l0_tool::Point_cloud read_las(const std::string& bytes,
                                     const l0_tool::Read_options& options = everything())
{
  return read(".las", bytes, options);
}

inline std::string written(const l0_tool::Point_cloud& cloud,
                           const std::vector<std::string>& left_out = {})
{
  const std::string path = scratch.file("written.las");
  CHECK(l0_tool::write_point_cloud(path, l0_tool::File_format::LAS, cloud) == left_out);
  std::string bytes = read_bytes(path);
  CHECK(bytes.size() <= l0_tool::maximum_file_size(l0_tool::File_format::LAS, cloud.points.size(),
                                                   cloud.properties, cloud.las));
  return bytes;
}

inline std::map<std::string, double> values(const l0_tool::Point_cloud& cloud, std::size_t row)
{
  std::map<std::string, double> all;
  for (const l0_tool::Property& property : cloud.properties.properties())
    CHECK(all.emplace(property.name, cloud.properties.value(row, property)).second);
  return all;
}

// Numbers of a written file, where the specification has them.
inline std::uint64_t integer_at(const std::string& file, std::size_t position, std::size_t size)
{
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < size; ++k)
    number |= std::uint64_t(static_cast<unsigned char>(file.at(position + k))) << 8 * k;
  return number;
}

inline double double_at(const std::string& file, std::size_t position)
{
  const std::uint64_t bits = integer_at(file, position, sizeof(double));
  double number;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}

inline std::string point_bytes(const std::string& file, std::size_t i)
{
  const std::size_t size = integer_at(file, 105, 2);
  return file.substr(integer_at(file, 96, 4) + i * size, size);
}

/// What stands between header and points.
inline std::string records_of(const std::string& file)
{
  const std::size_t begin = integer_at(file, 94, 2);
  return file.substr(begin, integer_at(file, 96, 4) - begin);
}

} // namespace tool_test

#endif // L0_RESAMPLE_TEST_TOOL_LAS_H
