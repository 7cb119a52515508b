// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/tasks.h"

#include "basis/parse_numbers.h"
#include "files/Output_file.h"
#include "formats/write_points.h"
#include "tasks/check_output.h"

#include <string>
#include <utility>
#include <vector>

namespace l0_tool {

void convert_file(const Options& options, Input_file::On_progress on_progress, Run_record& record)
{
  check_output(options, 0);
  const Point_cloud cloud = read_input(options, true, std::move(on_progress), record);
  record.report.number_of_input_points = cloud.points.size();
  record.report.number_of_dropped_points = cloud.number_of_dropped_points;

  check_output(options, maximum_file_size(options.output_format, cloud.points.size(),
                                          cloud.properties, cloud.las));
  record.report.number_of_output_points = cloud.points.size();
  if (options.dry_run)
    return;
  const std::vector<std::string> left_out = write_point_cloud(options.output, options.output_format,
                                                              cloud, options.existing_file());
  for (const std::string& name : left_out)
    record.warnings.push_back(options.output + ": the format has no place for the property "
                              + printable(name));
}

} // namespace l0_tool
