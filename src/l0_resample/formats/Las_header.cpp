// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Las_header.h"

#include "basis/Number_type.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace l0_tool {
namespace {

constexpr std::string_view signature = "LASF";

// Where the number of the format is, and its bits where points are compressed.
constexpr std::size_t place_of_format = 104;
constexpr unsigned compression_bits = 0xc0;
constexpr std::string_view compression_user = "laszip encoded";

// All records of the coordinate system that are kept, in bytes.
constexpr std::size_t max_size_of_coordinate_system = 1024 * 1024;

constexpr const char* laz_refusal =
  "LAZ is not read: give a command with --decompress that writes LAS, and "
  "a file that is no pipe, or decompress it first (laszip, PDAL)";

/// Numbers in the block that a file begins with.
class Header_block
{
  std::string m_bytes;

public:
  explicit Header_block(std::string bytes) : m_bytes(std::move(bytes)) {}

  std::uint64_t integer(std::size_t position, std::size_t size) const
  {
    return little_endian_at(m_bytes.data() + position, size);
  }

  double number(std::size_t position) const
  {
    return decode(m_bytes.data() + position, Number_type::FLOAT64, !is_little_endian_machine());
  }
};

std::string read_string(Input_file& file, std::size_t size)
{
  return std::string(file.read_bytes(size), size);
}

/// The first block, of which the version tells the least size.
Header_block read_block(Input_file& file, Las_header& header)
{
  std::string bytes = read_string(file, las_header_sizes[0]);
  if (std::string_view(bytes).substr(0, signature.size()) != signature)
    file.refuse("the file does not begin as a LAS file does");
  const Header_block begin(bytes);
  const std::uint64_t major = begin.integer(24, 1), minor = begin.integer(25, 1);
  if (major != 1 || minor >= las_header_sizes.size())
    file.refuse("LAS 1.0 to 1.4 expected, found " + std::to_string(major) + "."
                + std::to_string(minor));
  header.origin.minor_version = unsigned(minor);
  header.size = std::size_t(begin.integer(94, 2));
  const std::size_t least = las_header_sizes[minor];
  if (header.size < least)
    file.refuse("the header has " + std::to_string(header.size) + " bytes, but that of LAS 1."
                + std::to_string(minor) + " has " + std::to_string(least));
  bytes += read_string(file, least - bytes.size());
  file.skip_bytes(header.size - least);
  return Header_block(std::move(bytes));
}

void take_scale(const Input_file& file, const Header_block& block, Las_origin& origin)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    origin.scale[axis] = block.number(131 + 8 * axis);
    origin.offset[axis] = block.number(155 + 8 * axis);
    if (!std::isfinite(origin.scale[axis]) || origin.scale[axis] == 0)
      file.refuse("a scale of the coordinates is 0 or not finite");
    if (!std::isfinite(origin.offset[axis]))
      file.refuse("an offset of the coordinates is not finite");
  }
}

void take_points(const Input_file& file, const Header_block& block, Las_header& header)
{
  const auto format = unsigned(block.integer(place_of_format, 1));
  if ((format & compression_bits) != 0)
    file.refuse(laz_refusal);
  if (format > max_las_point_format)
    file.refuse("point data record format 0 to " + std::to_string(max_las_point_format)
                + " expected, found " + std::to_string(format));
  header.origin.point_format = format;
  header.point_size = std::size_t(block.integer(105, 2));
  if (header.point_size < las_point_size(format))
    file.refuse("a point of format " + std::to_string(format) + " has "
                + std::to_string(las_point_size(format)) + " bytes, not "
                + std::to_string(header.point_size));
  header.number_of_points = block.integer(107, 4);
  if (header.origin.minor_version >= 4 && block.integer(247, 8) > 0)
    header.number_of_points = block.integer(247, 8);
  header.offset_to_points = block.integer(96, 4);
  if (header.offset_to_points < header.size)
    file.refuse("the points begin at byte " + std::to_string(header.offset_to_points)
                + ", within the header");
  constexpr std::uint64_t most = (std::numeric_limits<std::uint64_t>::max)();
  if (header.number_of_points > (most - header.offset_to_points) / header.point_size)
    file.refuse(std::to_string(header.number_of_points)
                + " points are announced, more than a file can hold");
}

void take_extended_records(const Input_file& file, const Header_block& block, Las_header& header)
{
  if (header.origin.minor_version < 4)
    return;
  header.number_of_extended_records = std::uint32_t(block.integer(243, 4));
  header.first_extended_record = block.integer(235, 8);
  if (header.number_of_extended_records > 0
      && header.first_extended_record < header.end_of_points())
    file.refuse("the extended records begin at byte " + std::to_string(header.first_extended_record)
                + ", before the points end");
}

/// Of both kinds, but for the length.
Las_record record_of(std::string_view head, std::size_t size_of_length)
{
  Las_record record;
  record.user_id = head.substr(2, 16);
  record.id = std::uint16_t(little_endian_at(head.data() + 18, 2));
  record.description = head.substr(20 + size_of_length, 32);
  return record;
}

bool is_of(const Las_record& record, std::string_view user)
{
  return std::string_view(record.user_id).substr(0, record.user_id.find('\0')) == user;
}

void keep_coordinate_system(Input_file& file, Las_record&& record, std::uint64_t length,
                            Las_header& header)
{
  header.size_of_coordinate_system += las_record_head_size + std::size_t(length);
  if (header.size_of_coordinate_system > max_size_of_coordinate_system)
    file.refuse("the records of the coordinate system have more than "
                + std::to_string(max_size_of_coordinate_system) + " bytes");
  record.data = read_string(file, std::size_t(length));
  header.origin.coordinate_system.push_back(std::move(record));
}

/// The data of a record, which comes next.
void read_data(Input_file& file, Las_record&& record, std::uint64_t length, Las_header& header)
{
  const bool is_projection = is_of(record, las_projection);
  const bool is_short = length <= Las_record::max_data_size;
  if (is_of(record, compression_user))
    file.refuse(laz_refusal);
  if (is_projection && is_short)
    return keep_coordinate_system(file, std::move(record), length, header);
  if (is_of(record, las_specification) && record.id == las_extra_bytes_id) {
    if (!is_short)
      file.refuse("the record of extra bytes has " + std::to_string(length) + " bytes");
    return add_las_extra_bytes(file, read_string(file, std::size_t(length)),
                               las_point_size(header.origin.point_format), header.extra);
  }
  header.number_of_long_records += is_projection ? 1 : 0;
  file.skip_bytes(length);
}

void read_records(Input_file& file, Las_header& header)
{
  std::uint64_t left = header.offset_to_points - header.size;
  for (std::uint32_t k = 0; k < header.number_of_records; ++k) {
    const std::uint64_t count = header.number_of_records - k;
    if (count > left / las_record_head_size)
      file.refuse(std::to_string(count) + " more records are announced, but the points begin after "
                  + std::to_string(left) + " bytes");
    const std::string head = read_string(file, las_record_head_size);
    left -= las_record_head_size;
    const std::uint64_t length = little_endian_at(head.data() + 20, 2);
    if (length > left)
      file.refuse("a record of " + std::to_string(length) + " bytes, but the points begin after "
                  + std::to_string(left));
    read_data(file, record_of(head, 2), length, header);
    left -= length;
  }
}

} // namespace

bool is_compressed_las(Input_file& file)
{
  const std::string_view begin = file.next_bytes(las_header_sizes[0]);
  return begin.size() == las_header_sizes[0] && begin.substr(0, signature.size()) == signature
         && (static_cast<unsigned char>(begin[place_of_format]) & compression_bits) != 0;
}

Las_header read_las_header(Input_file& file)
{
  Las_header header;
  const Header_block block = read_block(file, header);
  if (header.origin.minor_version >= 2) // before, these bytes had no meaning
    header.origin.global_encoding = std::uint16_t(block.integer(6, 2));
  header.number_of_records = std::uint32_t(block.integer(100, 4));
  take_points(file, block, header);
  take_scale(file, block, header.origin);
  take_extended_records(file, block, header);
  read_records(file, header);
  return header;
}

void read_las_extended_records(Input_file& file, Las_header& header)
{
  for (std::uint32_t k = 0; k < header.number_of_extended_records; ++k) {
    file.check_count(header.number_of_extended_records - k, las_extended_record_head_size,
                     "extended records");
    const std::string head = read_string(file, las_extended_record_head_size);
    const std::uint64_t length = little_endian_at(head.data() + 20, 8);
    file.check_count(length, 1, "bytes of an extended record");
    read_data(file, record_of(head, 8), length, header);
  }
}

} // namespace l0_tool
