// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/tasks.h"

#include "formats/read_points.h"

#include <utility>

namespace l0_tool {

Point_cloud read_input(const Options& options, bool with_normals,
                       Input_file::On_progress on_progress, Run_record& record)
{
  Read_options read_options;
  read_options.max_points = options.max_points;
  read_options.max_memory = options.max_memory;
  read_options.drop_non_finite = options.drop_non_finite;
  read_options.with_normals = with_normals;
  read_options.with_properties = true;
  read_options.with_wide_colors = !options.info && options.output_format == File_format::LAS;
  read_options.classes = options.classes;
  read_options.only_first_returns = options.only_first_returns;
  read_options.decompression = options.decompression;
  read_options.columns = options.columns;
  read_options.has_decimal_commas = options.has_decimal_commas;
  // Where no length is measured, they do no harm
  const bool may_have_degrees = options.allows_degrees || options.info || options.convert_only;
  if (!may_have_degrees)
    read_options.degrees = Read_options::Degrees::REFUSE;
  Point_cloud cloud = read_points(options.input, options.input_format, read_options,
                                  std::move(on_progress));
  record.warnings.insert(record.warnings.end(), cloud.warnings.begin(), cloud.warnings.end());
  record.notes.insert(record.notes.end(), cloud.notes.begin(), cloud.notes.end());
  const bool has_coordinate_system = cloud.las && !cloud.las->coordinate_system.empty();
  if (has_coordinate_system && !options.info && options.output_format != File_format::LAS)
    record.notes.push_back(options.output
                           + ": only LAS has a place for the coordinate system of the input");
  return cloud;
}

} // namespace l0_tool
