// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/command_line.h"

#include "basis/Failure.h"
#include "command_line/Option_table.h"
#include "command_line/option_values.h"
#include "formats/Named_columns.h"
#include "pictures/views_around.h"

#include <CGAL/L0_resampling/tags.h>
#include <CGAL/version.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::Method;
using Json = Option_table::Json;

const std::map<std::string, Method> methods = {
  {"default", Method::DEFAULT}, {"lor", Method::LOR}, {"alor", Method::ALOR}};
const std::map<std::string, Solver> solvers = {{"chebyshev", Solver::BLOCK_CHEBYSHEV},
                                               {"block-cg", Solver::BLOCK_CG},
                                               {"cholesky", Solver::CHOLESKY},
                                               {"rows-cg", Solver::ROWS_CG}};
const std::map<std::string, Device> devices = {
  {"cpu", Device::CPU}, {"cuda", Device::CUDA}, {"auto", Device::AUTO}};
const std::map<std::string, Snapshot_colors> snapshot_colors = {
  {"shaded", Snapshot_colors::SHADED}, {"normals", Snapshot_colors::NORMALS}};
const std::map<std::string, File_format> formats = {
  {"ply", File_format::PLY}, {"off", File_format::OFF}, {"xyz", File_format::XYZ},
  {"pcd", File_format::PCD}, {"npy", File_format::NPY}, {"csv", File_format::CSV},
  {"obj", File_format::OBJ}, {"las", File_format::LAS}};

std::map<std::string, File_format> written_formats()
{
  std::map<std::string, File_format> written;
  for (const auto& [name, format] : formats)
    if (is_written(format))
      written.emplace(name, format);
  return written;
}

/// Empty if there is no value.
template <typename Value, typename Maybe_value>
std::string key_of(const std::map<std::string, Value>& names, const Maybe_value& value)
{
  for (const auto& [name, named] : names)
    if (named == value)
      return name;
  return "";
}

template <typename Value>
std::vector<std::string> keys_of(const std::map<std::string, Value>& names)
{
  std::vector<std::string> keys;
  keys.reserve(names.size());
  for (const auto& [name, value] : names)
    keys.push_back(name);
  return keys;
}

std::string in_words(const std::vector<std::string>& words)
{
  std::string list;
  for (std::size_t i = 0; i < words.size(); ++i)
    list += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return list;
}

/// An option whose value is one of `names`, which its description lists.
/// \param value of the type of these, or optional
template <typename Value, typename Maybe_value>
CLI::Option* add_choice(Option_table& table, const std::string& option, const std::string& type,
                        const std::map<std::string, Value>& names, Maybe_value& value,
                        const std::string& description, Told told = Told::TO_ALL)
{
  const auto choose = [names, &value](const std::string& name) {
    value = names.at(CLI::detail::to_lower(name));
  };
  const auto setting = [names, &value]() {
    const std::string name = key_of(names, value);
    return name.empty() ? Json() : Json(name);
  };
  return table
    .add_text(option, choose, description + ": " + in_words(keys_of(names)), told, setting)
    ->check(CLI::IsMember(keys_of(names), CLI::ignore_case).description(""))
    ->type_name(type)
    ->default_str(key_of(names, value));
}

/// A file that is written if there is a name: what is told is whether.
CLI::Option* add_result(Option_table& table, const std::string& option, std::string& path,
                        const std::string& description)
{
  return table
    .add_option(option, path, description, Told::TO_ALL, [&path]() { return Json(!path.empty()); })
    ->type_name("FILE");
}

// In the order of --help, which has room for 67 characters a line.

void add_options_on_result(Option_table& table, Arguments& arguments)
{
  Options& options = arguments.options;
  table
    .add_option("-o,--output", arguments.output, "instead of OUTPUT behind INPUT", Told::TO_NOBODY)
    ->type_name("OUTPUT");
  auto* directory =
    table
      .add_option("--output-directory", arguments.output_directory,
                  "a batch: results of all FILES, and of folders, under their names",
                  Told::TO_NOBODY)
      ->type_name("FOLDER");
  table
    .add_flag("--as-one", arguments.tiles.is_as_one,
              "FILES are parts of one cloud of any size, and results tiles of it", Told::TO_NOBODY)
    ->needs(directory);
  add_choice(table, "--output-format", "FORMAT", written_formats(), arguments.output_format,
             "of OUTPUT", Told::TO_REPORT)
    ->default_str("by extension");
  table.add_flag("--force", options.force, "replace an OUTPUT that exists", Told::TO_NOBODY);
  auto* points = table.add_option("-n,--points", options.number_of_points, "points to write")
                   ->check(count_within(1, max_number_of_output_points))
                   ->type_name("M");
  table
    .add_option(
      "--percentage", options.percentage, "points to write, in percent of those read", Told::TO_ALL,
      [&options]() { return options.number_of_points ? Json() : Json(options.percentage); })
    ->check(number_within(0, false, 1e6, "a percentage in (0, 1000000]"))
    ->type_name("P")
    ->capture_default_str()
    ->excludes(points);
  auto* keep_density = table.add_flag("--keep-density", options.keep_density,
                                      "as dense here and there as INPUT is, instead of even");
  table.add_flag("--source-index", options.with_source_indices,
                 "a property source_index: the nearest point of INPUT, from 0");
  table.add_flag("--feature-confidence", options.with_feature_confidences,
                 "a property feature_confidence: 0 if smooth, 1 on an edge");
  table.add_flag("--side-confidence", options.with_side_confidences,
                 "a property side_confidence: 0.5 if the side is a guess, 1 if sure");
  table.add_flag("--point-radius", options.with_neighbor_radii,
                 "a property neighbor_radius: that which a point was fitted with");
  table.add_flag("--point-noise", options.with_noises,
                 "a property noise: standard deviation of the points around");
  table.add_flag("--point-deviation", options.with_deviations,
                 "two properties: how far a point and its normal may be off");
  add_result(table, "--creases", options.creases,
             "OBJ, PLY or DXF: lines along which faces meet, and points on them")
    ->excludes(keep_density);
}

void add_options_on_input(Option_table& table, Arguments& arguments)
{
  Options& options = arguments.options;
  add_choice(table, "--input-format", "FORMAT", formats, arguments.input_format, "of INPUT",
             Told::TO_REPORT)
    ->default_str("by extension");
  table
    .add_parsed("--columns", options.columns,
                "names of the columns of a text or array, - to leave one out",
                [](const std::string&, const std::string& all) { return parse_column_names(all); })
    ->type_name("x,y,z,red,...");
  table.add_flag("--decimal-comma", options.has_decimal_commas,
                 "numbers of a text have a comma for the point: 0,5");
  table.add_flag("--allow-degrees", options.allows_degrees,
                 "read x and y though they are degrees, which are no lengths");
  table.add_flag("--drop-non-finite", options.drop_non_finite,
                 "leave out points with a NaN or infinite coordinate");
  table
    .add_parsed("--keep-classes", options.classes,
                "only points of these classifications, as LAS has them", parse_classes)
    ->type_name("2,6,...");
  table.add_flag("--first-returns", options.only_first_returns,
                 "only points that are no second or later return, as LAS has them");
  table
    .add_parsed("--decompress", options.decompression,
                "what writes a .laz file, for which {} stands, as LAS", parse_decompression)
    ->type_name("COMMAND");
  auto* keep_outliers = table.add_flag("--keep-outliers", options.keep_outliers,
                                       "keep points off the cloud, which the default method leaves "
                                       "out");
  table
    .add_option("--outlier-sensitivity", options.outlier_sensitivity,
                "how readily these are left out, 0 to 3; also by lor and alor")
    ->check(number_within(0, true, 3, "a number in [0, 3]"))
    ->type_name("S")
    ->default_str("1")
    ->excludes(keep_outliers);
  add_result(table, "--outliers", options.outliers,
             "write the points that are left out, to look at them")
    ->excludes(keep_outliers);
}

void add_options_on_method(Option_table& table, Arguments& arguments)
{
  Method_options& options = arguments.options;
  constexpr double any = (std::numeric_limits<double>::max)();
  add_choice(table, "--method", "METHOD", methods, options.method, "how to resample");
  table
    .add_option("--neighbor-radius", options.neighbor_radius, "of a neighborhood, a length",
                Told::TO_KEY)
    ->check(number_within(0, false, any, "a length above 0"))
    ->type_name("R")
    ->default_str("from spacing and noise");
  auto* noise =
    table.add_option("--noise", options.noise, "of the points across the surface, a length")
      ->check(number_within(0, false, any, "a length above 0"))
      ->type_name("LENGTH")
      ->default_str("estimated");
  table
    .add_option("--noise-property", options.noise_property,
                "the property of INPUT that is the noise of each point")
    ->type_name("NAME")
    ->excludes(noise);
  table
    .add_option("--normal-weight", options.normal_weight,
                "larger: sharper edges up to a limit; smaller: nearer to INPUT", Told::TO_ALL,
                [&options]() { return Json(normal_weight_of(options)); })
    ->check(number_within(0, true, any, "a number, 0 or above"))
    ->type_name("L")
    ->default_str(CLI::detail::to_string(normal_weight_of(options)));
  table
    .add_option("--sharpness-angle", options.sharpness_angle,
                "normals that differ by more degrees are of two faces")
    ->check(number_within(0, false, 90, "an angle in (0, 90] degrees"))
    ->type_name("A")
    ->capture_default_str();
  table.add_option("--seed", options.seed, "chooses where the points start")
    ->check(count_within(0, any_count))
    ->type_name("K")
    ->capture_default_str();
  add_choice(table, "--solver", "SOLVER", solvers, options.solver, "how to solve");
  table
    .add_option("--solver-iterations", options.solver_iterations,
                "most iterations of a solve, but for cholesky")
    ->check(count_within(1, any_count))
    ->type_name("N");
}

void add_options_on_normals(Option_table& table, Arguments& arguments)
{
  Normal_options& options = arguments.options;
  table.add_flag("--use-normals", options.use_normals,
                 "start from the normals of INPUT instead of estimating them");
  auto* by_normals = table.add_flag("--orient-by-normals", options.orient_by_normals,
                                    "turn the result as the normals of INPUT, instead of outwards");
  const auto set_viewpoint = [&options](const std::string& text) {
    options.ignore_viewpoint_of_file = text == "none";
    if (text != "none")
      options.viewpoint = parse_place("--viewpoint", text);
  };
  auto* viewpoint = table
                      .add_text("--viewpoint", set_viewpoint,
                                "what normals face: where all was seen from [that of PCD, PLY]",
                                Told::TO_ALL,
                                [&options]() {
                                  return options.viewpoint ? Json(*options.viewpoint)
                                         : options.ignore_viewpoint_of_file ? Json("none")
                                                                            : Json();
                                })
                      ->type_name("X,Y,Z|none")
                      ->excludes(by_normals);
  auto* viewpoints =
    table
      .add_option("--viewpoints", options.viewpoints,
                  "places that points were seen from, in lines x y z: the best view")
      ->type_name("FILE")
      ->excludes(by_normals)
      ->excludes(viewpoint);
  table
    .add_option("--view-property", options.view_property,
                "the property of INPUT that says which line it is, from 0")
    ->type_name("NAME")
    ->needs(viewpoints);
  table
    .add_parsed("--up", options.up_direction, "of points that were seen from above: the way up",
                parse_direction)
    ->type_name("X,Y,Z")
    ->excludes(by_normals)
    ->excludes(viewpoint)
    ->excludes(viewpoints);
}

// Of these, results depend on none.
void add_options_on_reports(Option_table& table, Arguments& arguments)
{
  Report_options& options = arguments.options;
  table.add_option("--json", options.json, "write what was done, stage by stage", Told::TO_NOBODY)
    ->type_name("FILE");
  table
    .add_option("--page", options.page,
                "a page for the browser: INPUT and result as points that turn", Told::TO_NOBODY)
    ->type_name("FILE.html")
    ->excludes(table.get_option("--output-directory"));
  table
    .add_option("--snapshot", options.snapshot,
                "draw INPUT and result; in a batch a folder for pictures", Told::TO_NOBODY)
    ->type_name("FILE.png");
  table
    .add_parsed("--view", options.view, "where the eye of the snapshot is, such as 1,-2,0.5",
                parse_direction, Told::TO_NOBODY)
    ->type_name("X,Y,Z");
  table
    .add_option("--snapshot-views", options.snapshot_views,
                "2 adds the other side, 3 the view from above, 4 that from below", Told::TO_NOBODY)
    ->check(count_within(1, maximum_number_of_views))
    ->type_name("N")
    ->capture_default_str();
  add_choice(table, "--snapshot-colors", "COLORS", snapshot_colors, options.snapshot_colors,
             "how to color points", Told::TO_NOBODY);
  table.add_flag("--quiet", options.quiet, "no summary, no progress bar, no warnings",
                 Told::TO_NOBODY);
  table.add_flag("--strict", options.strict, "write nothing if a solve did not converge",
                 Told::TO_NOBODY);
}

void add_options_on_machine(Option_table& table, Arguments& arguments)
{
  Machine_options& options = arguments.options;
  add_choice(table, "--device", "DEVICE", devices, options.device, "where to compute",
             Told::TO_REPORT);
  table
    .add_option("--threads", options.threads, "most threads to use", Told::TO_REPORT,
                [&options]() { return options.threads ? Json(*options.threads) : Json("all"); })
    ->check(count_within(1, 4096))
    ->type_name("N")
    ->default_str("all");
  table
    .add_option("--max-points", options.max_points, "refuse an INPUT of more points",
                Told::TO_NOBODY)
    ->check(count_within(0, any_count))
    ->type_name("N");
  table
    .add_option("--max-memory", options.max_memory,
                "fail rather than take more, in bytes or as in 4GB", Told::TO_NOBODY)
    ->transform(CLI::AsSizeValue(false).description(""))
    ->type_name("SIZE");
  auto* as_one = table.get_option("--as-one");
  auto* memory = table
                   .add_option("--memory", arguments.tiles.memory,
                               "with --as-one: what it may take, which decides on the tiles",
                               Told::TO_KEY)
                   ->transform(CLI::AsSizeValue(false).description(""))
                   ->type_name("SIZE")
                   ->needs(as_one);
  as_one->needs(memory);
  table
    .add_option("--halo", arguments.tiles.halo,
                "with --as-one: how far around it a tile sees points", Told::TO_KEY)
    ->check(number_within(1, true, 1000, "a number in [1, 1000]"))
    ->type_name("RADII")
    ->needs(as_one)
    ->capture_default_str();
  table.add_option("--timeout", options.timeout, "fail after so many seconds", Told::TO_NOBODY)
    ->check(number_within(0, false, 1e8, "a number of seconds above 0"))
    ->type_name("SECONDS");
}

void add_other_tasks(Option_table& table, Arguments& arguments)
{
  Task_options& options = arguments.options;
  auto* as_one = table.get_option("--as-one");
  table
    .add_flag("--resume", arguments.tiles.resumes,
              "with --as-one: go on where an earlier run has ended", Told::TO_NOBODY)
    ->needs(as_one);
  // for programs that run steps in an order and on machines of their own; hidden
  table.add_option("--task", arguments.tiles.task, "", Told::TO_NOBODY)->needs(as_one)->group("");
  table.add_flag("--info", options.info,
                 "tell what INPUT is and what the defaults would be; write nothing",
                 Told::TO_NOBODY);
  table.add_flag("--dry-run", options.dry_run,
                 "read INPUT, check all that can be, and write nothing", Told::TO_NOBODY);
  table.add_flag("--convert-only", options.convert_only,
                 "write the points of INPUT as they are, in the format of OUTPUT", Told::TO_NOBODY);
  table.add_flag("--orient-only", options.orient_only,
                 "the same, but turn normals to their side; estimate missing ones");
  table
    .add_option("--config", arguments.config,
                "read lines option = value; the command line goes before them", Told::TO_NOBODY)
    ->type_name("FILE");
}

// What a task has no use for is refused with it.
void exclude_others(CLI::App& app, const std::string& task,
                    const std::vector<std::string_view>& useful)
{
  static constexpr std::array<std::string_view, 18> always = {
    "help",          "version",         "config",       "FILES",         "input-format",
    "columns",       "drop-non-finite", "quiet",        "max-points",    "max-memory",
    "timeout",       "threads",         "keep-classes", "first-returns", "decompress",
    "decimal-comma", "allow-degrees",   "force"};
  const auto has = [](const auto& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name();
    if (name != task && !has(always, name) && !has(useful, name))
      app.get_option("--" + task)->excludes(option);
  }
}

} // namespace

void refuse_usage(const std::string& message)
{
  throw CLI::ValidationError(message, int(WRONG_USAGE));
}

void add_options(CLI::App& app, Arguments& arguments)
{
  app.add_option("FILES", arguments.files)->group("");
  using Adder = void (*)(Option_table&, Arguments&);
  static constexpr std::array<std::pair<const char*, Adder>, 7> groups = {
    {{"Result", add_options_on_result},
     {"Input", add_options_on_input},
     {"Method", add_options_on_method},
     {"Normals", add_options_on_normals},
     {"Reports", add_options_on_reports},
     {"Machine", add_options_on_machine},
     {"Other tasks", add_other_tasks}}};
  app.set_help_flag();
  Option_table table(app, arguments.settings);
  for (const auto& [name, add] : groups) {
    app.option_defaults()->group(name);
    add(table, arguments);
  }
  app.set_help_flag("-h,--help", "print this page");
  app.set_version_flag("-V,--version",
                       std::string("l0_resample " L0_RESAMPLE_VERSION ", CGAL " CGAL_VERSION_STR),
                       "print the version");
  exclude_others(app, "convert-only", {"output", "output-directory", "output-format", "dry-run"});
  exclude_others(app, "orient-only",
                 {"output", "output-directory", "output-format", "dry-run", "json", "device",
                  "neighbor-radius", "orient-by-normals", "viewpoint", "viewpoints",
                  "view-property", "up"});
  exclude_others(app, "as-one",
                 {"output-directory",
                  "output-format",
                  "points",
                  "percentage",
                  "keep-density",
                  "keep-outliers",
                  "outlier-sensitivity",
                  "neighbor-radius",
                  "noise",
                  "normal-weight",
                  "sharpness-angle",
                  "seed",
                  "viewpoint",
                  "up",
                  "creases",
                  "outliers",
                  "json",
                  "memory",
                  "halo",
                  "device",
                  "resume",
                  "output",
                  "task"});
  exclude_others(app, "info",
                 {"points", "percentage", "method", "neighbor-radius", "keep-outliers",
                  "outlier-sensitivity"});
}

std::vector<std::string> choices_of(const std::string& option)
{
  static const std::map<std::string, std::vector<std::string>> choices = {
    {"method", keys_of(methods)},
    {"solver", keys_of(solvers)},
    {"device", keys_of(devices)},
    {"input-format", keys_of(formats)},
    {"output-format", keys_of(written_formats())}};
  const auto found = choices.find(option);
  return found == choices.end() ? std::vector<std::string>() : found->second;
}

double normal_weight_of(const Method_options& options)
{
  return options.normal_weight.value_or(CGAL::L0_resampling::default_normal_weight);
}

std::string name_of(Method method) { return key_of(methods, method); }

} // namespace l0_tool
