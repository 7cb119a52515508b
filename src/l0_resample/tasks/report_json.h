// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_REPORT_JSON_H
#define L0_RESAMPLE_REPORT_JSON_H

#include "basis/Failure.h"
#include "command_line/options.h"

#include <CGAL/L0_resampling/Report.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// What a run of the program did, as far as it came.
struct Run_record
{
  Exit_status status = SUCCESS;
  std::string error;                        ///< the line on standard error, empty if all went well
  std::vector<std::string> warnings, notes; ///< one line each, with the name of the file
  std::optional<std::array<double, 3>>
    viewpoint_of_file;     ///< which the normals face, as the options say nothing of sides
  std::string description; ///< what `--info` prints
  double seconds_to_read = 0;
  double seconds_to_resample = 0;
  double seconds_to_write = 0; ///< the result, without snapshot and report
  CGAL::L0_resampling::Report report;
};

/// A line for each warning of the report, with the name of what was resampled.
std::vector<std::string> lines_of_warnings(const std::string& name,
                                           const CGAL::L0_resampling::Report& report);

/// Whether only the shape tells the side of the normals, so that outwards is taken for right.
/// \param viewpoint_of_file that counts if the options say nothing of sides
bool are_outwards_assumed(const Normal_options& options,
                          const std::optional<std::array<double, 3>>& viewpoint_of_file);

/// What a summary says of it.
constexpr const char* outwards_are_assumed =
  ", taking outwards for right (--viewpoint for a room seen from within)";

/// \param source what has the viewpoint: the file, or files
std::string line_of_viewpoint(const std::string& name, const std::string& source,
                              const std::array<double, 3>& viewpoint);

/// Adds what was found of points and samples, which a run by tiles reports too.
void add_findings(const CGAL::L0_resampling::Report& report, nlohmann::ordered_json& json);

/// One JSON object; lengths are in the unit of the input, times in seconds, memory in bytes.
std::string report_as_json(const Options& options, const Run_record& record);

/// "kitten.xyz: 5210 points in, 2605 out, method lor, 0.21 s, 98 % of the normals expected on the
/// right side"
std::string summary_line(const Options& options, const Run_record& record);

} // namespace l0_tool

#endif // L0_RESAMPLE_REPORT_JSON_H
