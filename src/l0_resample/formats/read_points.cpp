// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/read_points.h"

#include "basis/parse_numbers.h"
#include "formats/Point_collector.h"
#include "formats/readers.h"

#include <cstddef>
#include <optional>
#include <utility>

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
      file.refuse(printable(word) + " is not a number");
    row[k] = *number;
  }
  return row;
}

Point_cloud read_points(const std::string& path, File_format format, const Read_options& options,
                        Input_file::On_progress on_progress)
{
  Input_file file(path, std::move(on_progress),
                  is_laz(path) ? options.decompression : std::string());
  Point_collector collector(file, options);
  switch (format) {
  case File_format::PLY: read_ply(file, collector); break;
  case File_format::OFF: read_off(file, collector); break;
  case File_format::XYZ: read_xyz(file, collector, options.columns); break;
  case File_format::PCD: read_pcd(file, collector); break;
  case File_format::NPY: read_npy(file, collector); break;
  case File_format::OBJ: read_obj(file, collector); break;
  case File_format::LAS: read_las(file, collector); break;
  case File_format::CSV: read_csv(file, collector, options.columns); break;
  }
  file.check_end();
  return collector.take();
}

} // namespace l0_tool
