// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/run.h"

#include "basis/Failure.h"
#include "basis/messages.h"
#include "basis/parse_numbers.h"
#include "basis/signals.h"
#include "files/Output_file.h"
#include "formats/write_creases.h"
#include "formats/write_points.h"
#include "pictures/render_snapshot.h"
#include "pictures/Image.h"
#include "pictures/page.h"
#include "pictures/views_around.h"
#include "tasks/Progress_bar.h"
#include "tasks/check_output.h"
#include "tasks/tasks.h"
#include "tasks/resample.h"
#include "tasks/viewpoints.h"

#include <CGAL/L0_resampling/find_near_points.h>
#include <CGAL/L0_resampling/warnings.h>
#include <CGAL/property_map.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

class Stopwatch
{
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_start = Clock::now();

public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }
};

Point_cloud read_input(const Options& options, Progress_bar& progress, Run_record& record)
{
  const Stopwatch stopwatch;
  const bool with_normals = options.use_normals || options.orient_by_normals || options.orient_only
                            || !options.snapshot.empty() || !options.page.empty();
  Point_cloud cloud = read_input(
    options, with_normals, [&](double share) { progress.update("read", share); }, record);
  record.seconds_to_read = stopwatch.seconds();
  return cloud;
}

/// Calls `work` with a callback that moves the progress bar and ends it after a signal.
template <typename Work>
void watch(const Point_cloud& cloud, Progress_bar& progress, Run_record& record, const Work& work)
{
  const Stopwatch stopwatch;
  progress.restart();
  work([&](double share) {
    progress.update(record.report.stages.empty() ? "" : record.report.stages.back().name, share);
    return !is_interrupted();
  });
  throw_if_interrupted();
  record.report.number_of_dropped_points =
    cloud.number_of_dropped_points; // the reader drops them, not the library
  record.seconds_to_resample = stopwatch.seconds();
}

Resampled_points resample_input(const Point_cloud& cloud, const Sides& sides,
                                const Options& options, Progress_bar& progress, Run_record& record)
{
  Resampled_points result;
  watch(cloud, progress, record, [&](const std::function<bool(double)>& callback) {
    result = resample(cloud, sides, options, callback, record.report);
  });
  return result;
}

/// Those of --viewpoints, if it is given.
std::vector<Point> given_viewpoints(const Options& options, Run_record& record)
{
  if (options.viewpoints.empty())
    return {};
  return read_viewpoints(options.viewpoints, options.has_decimal_commas, record.warnings);
}

/// Where the points were seen from, as the options say, or else the file.
Sides find_sides(const Point_cloud& cloud, const std::vector<Point>& viewpoints,
                 const Options& options, Run_record& record)
{
  Sides sides;
  sides.viewpoint = options.viewpoint;
  if (!options.view_property.empty())
    sides.viewpoints = viewpoints_of_points(cloud, options.view_property, viewpoints,
                                            options.input_name());
  else if (!options.viewpoints.empty()) {
    Options by_default;
    by_default.input = options.input;
    by_default.threads = options.threads;
    const double noise = estimate_scales(cloud, by_default).estimated_noise;
    sides.viewpoints = best_viewpoints(cloud, viewpoints, noise, options.viewpoints);
    const std::string taken = options.input + ": each point is taken for seen from ";
    record.notes.push_back(viewpoints.size() == 1
                             ? taken + "the only viewpoint"
                             : taken + "that of the " + std::to_string(viewpoints.size())
                                 + " viewpoints which sees it best, as no --view-property says "
                                   "which");
  }
  if (options.have_side())
    return sides;
  if (cloud.viewpoint) {
    sides.viewpoint = record.viewpoint_of_file = cloud.viewpoint;
    record.notes.push_back(line_of_viewpoint(options.input, "the file", *cloud.viewpoint));
  } else if (cloud.file_has_normals)
    record.notes.push_back(
      options.input + ": the file has normals, which --orient-by-normals lets decide the side");
  return sides;
}

void note_weight_without_effect(const Options& options, Run_record& record)
{
  const double limit = CGAL::L0_resampling::largest_effective_normal_weight(record.report);
  if (!options.normal_weight || *options.normal_weight <= limit
      || options.method != CGAL::L0_resampling::Method::DEFAULT)
    return;
  char text[96];
  std::snprintf(text, sizeof text,
                ": --normal-weight %g acts as %.3g does, the largest one that the",
                *options.normal_weight, limit);
  record.notes.push_back(options.input + text + " default method has a use for here");
}

void warn_of_left_out(const std::string& path, const std::vector<std::string>& properties,
                      Run_record& record)
{
  for (const std::string& property : properties)
    record.warnings.push_back(path + ": the format has no place for the property "
                              + printable(property));
}

/// Some of the points, as they were read.
/// \param chosen which of them
Point_cloud chosen_points(const Point_cloud& cloud, const std::vector<std::size_t>& chosen)
{
  Point_cloud result;
  result.coordinate_type = cloud.coordinate_type;
  result.viewpoint = cloud.viewpoint;
  result.las = cloud.las;
  result.narrowed = cloud.narrowed;
  const std::vector<Property>& properties = cloud.properties.properties();
  for (std::size_t i = 0; i < properties.size(); ++i) {
    result.properties.add_property(properties[i].name, properties[i].type);
    result.properties.set_meaning(i, properties[i].is_measured, properties[i].no_data);
  }
  for (const std::size_t point : chosen) {
    result.points.push_back(cloud.points[point]);
    if (!cloud.normals.empty())
      result.normals.push_back(cloud.normals[point]);
    if (!properties.empty())
      result.properties.append(cloud.properties.row(point));
  }
  return result;
}

Known_sides known_sides_of(const Point_cloud& cloud, const Sides& sides, const Options& options)
{
  Known_sides known = {options.view, options.up_direction, sides.viewpoints};
  if (sides.viewpoint) {
    const auto& [x, y, z] = *sides.viewpoint;
    known.viewpoints = {Point(x, y, z)};
  }
  if (!known.up && cloud.las)
    known.up = {0, 0, 1};
  return known;
}

Image picture_of(const Point_cloud& cloud, const Resampled_points& result, const Known_sides& known,
                 const Report_options& options)
{
  return render_snapshot(cloud, result.points,
                         views_around(choose_view(result.points, known), options.snapshot_views),
                         known.viewpoints, result.feature_confidences,
                         lines_of_creases(result.creases, result.points), options.snapshot_colors);
}

/// How far the outliers are from the result, in radii.
std::vector<float> distances_of_outliers(const Point_cloud& cloud, const Resampled_points& result,
                                         double radius)
{
  std::vector<Point> outliers;
  for (const std::size_t i : result.outliers)
    outliers.push_back(cloud.points[i]);
  std::vector<float> distances;
  if (outliers.empty() || result.points.empty())
    return distances;
  const auto near = CGAL::L0_resampling::find_near_points<CGAL::Parallel_if_available_tag>(
    result.points, outliers, 1,
    CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>()));
  for (std::size_t i = 0; i < outliers.size(); ++i) {
    const Point& nearest = result.points[near.nearest(i)].first;
    distances.push_back(float(std::sqrt(CGAL::squared_distance(outliers[i], nearest)) / radius));
  }
  return distances;
}

void resample_file(const Options& options, Run_record& record)
{
  const std::string name = options.input_name();
  // What would spoil the end is found at the beginning
  check_device(options);
  check_output(options, 0);
  for (const std::string& path :
       {options.page, options.snapshot, options.creases, options.outliers, options.json})
    if (!path.empty() && !is_folder_missing(options, path))
      check_writable(path, 0);

  const std::vector<Point> viewpoints = given_viewpoints(options, record);

  Progress_bar progress(options.quiet);
  const Point_cloud cloud = read_input(options, progress, record);
  const std::size_t number_of_points = number_of_output_points(options, cloud.points.size());
  check_output(options, maximum_file_size(options.output_format, number_of_points, cloud.properties,
                                          cloud.las));

  const Sides sides = find_sides(cloud, viewpoints, options, record);
  if (options.dry_run) {
    record.report = estimate_scales(cloud, options);
    record.report.number_of_input_points = cloud.points.size();
    record.report.number_of_dropped_points = cloud.number_of_dropped_points;
    record.report.number_of_output_points = cloud.points.empty() ? 0 : number_of_points;
    return;
  }
  const Resampled_points result = resample_input(cloud, sides, options, progress, record);
  for (std::string& line : lines_of_warnings(options.input, record.report))
    record.warnings.push_back(std::move(line));
  note_weight_without_effect(options, record);
  if (options.strict && !record.report.converged)
    throw Failure(NOT_CONVERGED, name + ": a solve did not converge, nothing is written");

  const Stopwatch stopwatch;
  const std::vector<std::string> left_out = write_points(options.output, options.output_format,
                                                         result, options.existing_file());
  record.seconds_to_write = stopwatch.seconds();
  warn_of_left_out(options.output, left_out, record);
  if (!options.creases.empty())
    write_creases(options.creases, *crease_format_of(options.creases), result);
  if (!options.outliers.empty())
    warn_of_left_out(options.outliers,
                     write_point_cloud(options.outliers, *format_of(options.outliers),
                                       chosen_points(cloud, result.outliers)),
                     record);
  if (!options.snapshot.empty())
    write_png(options.snapshot,
              picture_of(cloud, result, known_sides_of(cloud, sides, options), options));
  if (!options.page.empty())
    write_text(options.page,
               page_of(cloud, result,
                       choose_view(result.points, known_sides_of(cloud, sides, options)),
                       distances_of_outliers(cloud, result, record.report.neighbor_radius),
                       report_as_json(options, record)));
}

void orient_file(const Options& options, Run_record& record)
{
  check_device(options);
  check_output(options, 0);
  if (!options.json.empty() && !is_folder_missing(options, options.json))
    check_writable(options.json, 0);
  const std::vector<Point> viewpoints = given_viewpoints(options, record);
  Progress_bar progress(options.quiet);
  Point_cloud cloud = read_input(options, progress, record);
  check_output(options, maximum_file_size(options.output_format, cloud.points.size(),
                                          cloud.properties, cloud.las));
  const Sides sides = find_sides(cloud, viewpoints, options, record);
  if (options.dry_run) {
    record.report.number_of_input_points = cloud.points.size();
    record.report.number_of_dropped_points = cloud.number_of_dropped_points;
    record.report.number_of_output_points = cloud.points.size();
    return;
  }
  watch(cloud, progress, record, [&](const std::function<bool(double)>& callback) {
    orient(sides, options, callback, cloud, record.report);
  });
  const Stopwatch stopwatch;
  warn_of_left_out(options.output,
                   write_point_cloud(options.output, options.output_format, cloud,
                                     options.existing_file()),
                   record);
  record.seconds_to_write = stopwatch.seconds();
}

void describe_file(const Options& options, Run_record& record)
{
  Progress_bar progress(options.quiet);
  const Point_cloud cloud = read_input(options, progress, record);
  progress.clear();
  record.description = describe(cloud, options);
}

void print_summary(const Options& options, const Run_record& record)
{
  const bool is_taken = (!options.output.empty() && is_standard_output(options.output))
                        || (!options.json.empty() && is_standard_output(options.json));
  std::ostream& stream = is_taken ? std::cerr : std::cout;
  stream << (options.info ? record.description : summary_line(options, record)) << std::flush;
  if (!stream)
    throw Failure(OUTPUT_NOT_WRITTEN, "standard output: the summary cannot be written");
}

} // namespace

void guarded(Run_record& record, const std::function<void()>& function)
{
  try {
    function();
  } catch (const Failure& failure) {
    record.status = failure.status();
    record.error = failure.what();
  } catch (const std::bad_alloc&) {
    record.status = RUN_TIME_FAILURE;
    record.error = "not enough memory";
  } catch (const std::exception& error) {
    record.status = RUN_TIME_FAILURE;
    record.error = error.what();
  }
}

Run_record run(const Options& options)
{
  Run_record record;
  guarded(record, [&]() {
    if (!options.refusal.empty())
      throw Failure(INPUT_REFUSED, options.refusal);
    if (options.info)
      return describe_file(options, record);
    if (options.orient_only)
      return orient_file(options, record);
    if (!options.convert_only)
      return resample_file(options, record);
    Progress_bar progress(options.quiet);
    convert_file(
      options, [&](double share) { progress.update("read", share); }, record);
  });
  return record;
}

void write_text(const std::string& path, const std::string& text)
{
  Output_file file(path);
  file.write(text);
  file.commit();
}

void print_outcome(const Options& options, Run_record& record)
{
  if (record.status == SUCCESS && (!options.quiet || options.info))
    guarded(record, [&]() { print_summary(options, record); });
  if (options.quiet)
    return;
  print_notes(record.notes);
  print_warnings(record.warnings);
}

} // namespace l0_tool
