// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/tasks.h"

#include <utility>

namespace l0_tool {

Read_options read_options_of(const Options& options)
{
  Read_options result;
  result.max_points = options.max_points;
  result.max_memory = options.max_memory;
  result.drop_non_finite = options.drop_non_finite;
  result.with_wide_colors = !options.info && options.output_format == File_format::LAS;
  result.classes = options.classes;
  result.only_first_returns = options.only_first_returns;
  result.decompression = options.decompression;
  result.columns = options.columns;
  result.has_decimal_commas = options.has_decimal_commas;
  // Where no length is measured, they do no harm
  const bool may_have_degrees = options.allows_degrees || options.info || options.convert_only;
  if (!may_have_degrees)
    result.degrees = Read_options::Degrees::REFUSE;
  return result;
}

Point_cloud read_input(const Options& options, bool with_normals,
                       Input_file::On_progress on_progress, Run_record& record)
{
  Read_options read_options = read_options_of(options);
  read_options.with_normals = with_normals;
  read_options.with_properties = true;
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
