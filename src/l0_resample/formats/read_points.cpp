// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/read_points.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "files/file_formats.h"
#include "formats/Las_header.h"
#include "formats/Point_collector.h"
#include "formats/readers.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace l0_tool {

Point_row parse_row(const Input_file& file, std::string_view line, bool has_normal)
{
  Point_row row = {};
  const std::size_t columns = has_normal ? 6 : 3;
  for (std::size_t k = 0; k < columns; ++k) {
    const std::string_view word = next_word(line);
    if (word.empty())
      file.refuse(std::to_string(columns) + " numbers expected, found " + std::to_string(k));
    const std::optional<double> number = parse_number<double>(word);
    if (!number)
      file.refuse(no_number(word));
    row[k] = *number;
  }
  return row;
}

void warn_of_rest(Input_file& file, const std::string& last, Point_collector& collector)
{
  const std::uint64_t left = file.bytes_left().value_or(0);
  const bool are_few = left <= Input_file::max_block_length;
  const std::size_t size = are_few ? std::size_t(left) : 0;
  const std::string_view rest(size > 0 ? file.read_bytes(size) : "", size);
  if (are_few && rest.find_first_not_of(" \t\r\n") == std::string_view::npos)
    return;
  collector.warn(std::to_string(left) + " bytes after the last " + last + " are not looked at");
}

namespace {

/// Names the format of a file that has the name of another one.
void check_begin(Input_file& file, File_format format)
{
  constexpr std::size_t length = 8;
  const std::string_view begin = file.next_bytes(length);
  const bool is_text = format == File_format::XYZ || format == File_format::CSV
                       || format == File_format::OBJ;
  if (begin.empty() && !is_text)
    throw Failure(INPUT_REFUSED, file.path() + ": the file is empty");
  const std::optional<File_format> told = format_that_begins_with(begin);
  if (!told || *told == format)
    return;
  const std::string name = extension_of(*told).substr(1);
  std::string capitals = name;
  std::transform(name.begin(), name.end(), capitals.begin(), [](char c) { return c - 'a' + 'A'; });
  throw Failure(INPUT_REFUSED, file.path() + ": the file begins as one of " + capitals
                                 + ", which --input-format " + name + " reads");
}

/// With the command for LAZ, if there is one and the name or the content is that of LAZ.
std::unique_ptr<Input_file> open_points(const std::string& path, File_format format,
                                        const std::string& command,
                                        const Input_file::On_progress& on_progress)
{
  const bool has_name = is_laz(path);
  auto file = std::make_unique<Input_file>(path, on_progress, has_name ? command : std::string());
  const bool may_be_laz = !has_name && !command.empty() && format == File_format::LAS;
  // The command opens it anew, which no pipe allows
  if (may_be_laz && path != "-" && is_compressed_las(*file) && file->bytes_left())
    file = std::make_unique<Input_file>(path, on_progress, command);
  return file;
}

} // namespace

Point_cloud read_points(const std::string& path, File_format format, const Read_options& options,
                        const Input_file::On_progress& on_progress)
{
  const std::unique_ptr<Input_file> opened = open_points(path, format, options.decompression,
                                                         on_progress);
  Input_file& file = *opened;
  Point_collector collector(file, options);
  check_begin(file, format);
  switch (format) {
  case File_format::PLY: read_ply(file, collector); break;
  case File_format::OFF: read_off(file, collector); break;
  case File_format::XYZ: read_text(file, collector, options.columns, false); break;
  case File_format::PCD: read_pcd(file, collector); break;
  case File_format::NPY: read_npy(file, collector, options.columns); break;
  case File_format::OBJ: read_obj(file, collector); break;
  case File_format::LAS: read_las(file, collector); break;
  case File_format::CSV: read_text(file, collector, options.columns, true); break;
  }
  file.check_end();
  return collector.take();
}

} // namespace l0_tool
