// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/report_json.h"

#include "basis/messages.h"
#include "command_line/Setting.h"

#include <CGAL/L0_resampling/warnings.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace l0_tool {
namespace {

using Json = nlohmann::ordered_json;
using CGAL::L0_resampling::Iteration_report;
using CGAL::L0_resampling::Report;
using CGAL::L0_resampling::Stage_report;

Json place_or_null(const Report& report)
{
  return report.unexplained_radius > 0
           ? Json{{"center", report.unexplained_center},
                  {"radius", report.unexplained_radius},
                  {"samples", report.number_of_unexplained_samples_there}}
           : Json(nullptr);
}

Json parameters_as_json(const Options& options, const Run_record& record)
{
  Json json = Json::object();
  for (const Setting& setting : *options.settings) {
    std::string name = setting.name;
    std::replace(name.begin(), name.end(), '-', '_');
    if (setting.told == Told::TO_ALL || setting.told == Told::TO_REPORT)
      json[name] = setting.value;
  }
  const auto& viewpoint = record.viewpoint_of_file ? record.viewpoint_of_file : options.viewpoint;
  json["viewpoint"] = viewpoint ? Json(*viewpoint) : Json();
  json["outwards_assumed"] = are_outwards_assumed(options, record.viewpoint_of_file);
  return json;
}

Json iteration_as_json(const Iteration_report& iteration)
{
  return {{"penalty", iteration.penalty},
          {"regularized", iteration.regularized},
          {"fit_energy", iteration.fit_energy},
          {"regularization_energy", iteration.regularization_energy},
          {"normal_energy", iteration.normal_energy},
          {"sparsity_energy", iteration.sparsity_energy},
          {"active_pair_share", iteration.active_pair_share},
          {"solver_iterations", iteration.solver.iterations},
          {"relative_residual", iteration.solver.relative_residual},
          {"converged", iteration.solver.converged}};
}

Json report_as_json(const Report& report)
{
  Json json = {{"neighbor_radius", report.neighbor_radius},
               {"least_neighbor_radius", report.least_neighbor_radius},
               {"median_neighbor_radius", report.median_neighbor_radius},
               {"largest_neighbor_radius", report.largest_neighbor_radius},
               {"normal_filter_radius", report.normal_filter_radius},
               {"estimated_spacing", report.estimated_spacing},
               {"estimated_noise", report.estimated_noise}};
  add_findings(report, json);
  json.update({{"self_neighbor_pairs", report.number_of_self_neighbor_pairs},
               {"oriented_share", report.oriented_share},
               {"right_side_share", report.right_side_share},
               {"hinted_share", report.hinted_share},
               {"extent_share", report.extent_share},
               {"warnings", Json::array()},
               {"converged", report.converged},
               {"peak_bytes", report.peak_bytes},
               {"stages", Json::array()},
               {"iterations", Json::array()}});
  for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(report))
    json["warnings"].push_back(CGAL::L0_resampling::name_of(warning));
  for (const Stage_report& stage : report.stages)
    json["stages"].push_back(
      {{"name", stage.name}, {"seconds", stage.seconds}, {"peak_bytes", stage.peak_bytes}});
  for (const Iteration_report& iteration : report.iterations)
    json["iterations"].push_back(iteration_as_json(iteration));
  return json;
}

} // namespace

std::vector<std::string> lines_of_warnings(const std::string& name, const Report& report)
{
  std::vector<std::string> lines;
  for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(report))
    lines.push_back(name + ": " + CGAL::L0_resampling::message_of(warning, report));
  return lines;
}

bool are_outwards_assumed(const Normal_options& options,
                          const std::optional<std::array<double, 3>>& viewpoint_of_file)
{
  return !options.have_side() && !viewpoint_of_file;
}

std::string line_of_viewpoint(const std::string& name, const std::string& source,
                              const std::array<double, 3>& viewpoint)
{
  const auto& [x, y, z] = viewpoint;
  std::ostringstream line;
  line << name << ": normals face the viewpoint of " << source << ", " << x << "," << y << "," << z
       << ", unless --viewpoint none is given";
  return line.str();
}

void add_findings(const Report& report, nlohmann::ordered_json& json)
{
  json["outliers"] = report.number_of_outliers;
  json["degenerate_neighborhoods"] = report.number_of_degenerate_neighborhoods;
  json["lonely_samples"] = report.number_of_lonely_samples;
  json["unexplained_samples"] = report.number_of_unexplained_samples;
  json["unexplained_place"] = place_or_null(report);
}

std::string report_as_json(const Options& options, const Run_record& record)
{
  const Report& report = record.report;
  Json json = {{"program", "l0_resample"},
               {"version", L0_RESAMPLE_VERSION},
               {"exit_status", int(record.status)}};
  if (!record.error.empty())
    json["error"] = record.error;
  json["warnings"] = record.warnings;
  json["notes"] = record.notes;
  json["input"] = {{"file", options.input},
                   {"points", report.number_of_input_points},
                   {"dropped_points", report.number_of_dropped_points}};
  json["output"] = {{"file", options.output}, {"points", report.number_of_output_points}};
  json["parameters"] = parameters_as_json(options, record);
  json["device"] = {{"used", report.device}, {"reason", report.device_reason}};
  json["seconds"] = {{"read", record.seconds_to_read},
                     {"resample", record.seconds_to_resample},
                     {"write", record.seconds_to_write}};
  json["resampling"] = report_as_json(report);
  // File names are bytes, JSON is UTF-8: what is not becomes U+FFFD
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summary_line(const Options& options, const Run_record& record)
{
  const Report& report = record.report;
  char numbers[96];
  const std::string input_points = std::to_string(report.number_of_input_points);
  std::string line = on_one_line(options.input_name()) + ": " + input_points + " points in, ";
  if (report.number_of_dropped_points > 0)
    line += std::to_string(report.number_of_dropped_points) + " dropped, ";
  if (report.number_of_outliers > 0)
    line += std::to_string(report.number_of_outliers) + " outliers left out, ";
  line += std::to_string(report.number_of_output_points)
          + (options.dry_run ? " would be written to " + on_one_line(options.output) + ", "
                             : " out, ");
  if (options.convert_only)
    return line + "converted\n";
  if (options.orient_only && options.dry_run)
    return line + "oriented\n";
  line += options.orient_only ? "oriented, " : "method " + name_of(options.method) + ", ";
  if (options.dry_run) {
    std::snprintf(numbers, sizeof numbers, "neighbor radius %.6g\n", report.neighbor_radius);
    return line + numbers;
  }
  if (report.number_of_output_points == 0) {
    std::snprintf(numbers, sizeof numbers, "%.2f s\n", record.seconds_to_resample);
    return line + numbers;
  }
  std::snprintf(numbers, sizeof numbers,
                "%.2f s, %.0f %% of the normals expected on the right side",
                record.seconds_to_resample, std::floor(100 * report.right_side_share));
  line += numbers;
  const double well_known_share = 0.9;
  if (report.right_side_share < well_known_share && report.hinted_share < 0.5)
    line += " (--viewpoint, --up or --orient-by-normals would tell)";
  else if (are_outwards_assumed(options, record.viewpoint_of_file))
    line += outwards_are_assumed;
  if (!report.converged)
    line += ", not converged";
  return line + "\n";
}

} // namespace l0_tool
