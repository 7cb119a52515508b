// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/command_line.h"

#include "basis/Failure.h"
#include "command_line/option_values.h"
#include "files/Command_output.h"
#include "formats/Named_columns.h"
#include "pictures/views_around.h"

#include <CGAL/L0_resampling/tags.h>
#include <CGAL/version.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::Method;

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

template <typename Value>
std::string key_of(const std::map<std::string, Value>& names, Value value)
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
template <typename Value>
CLI::Option* add_choice(CLI::App& app, const std::string& option, const std::string& type,
                        const std::map<std::string, Value>& names, Value& value,
                        const std::string& description)
{
  const auto choose = [names, &value](const std::string& name) {
    value = names.at(CLI::detail::to_lower(name));
  };
  return app
    .add_option_function<std::string>(option, choose, description + ": " + in_words(keys_of(names)))
    ->check(CLI::IsMember(keys_of(names), CLI::ignore_case).description(""))
    ->type_name(type)
    ->default_str(key_of(names, value));
}

// In the order of --help, which has room for 67 characters a line.

void add_options_on_result(CLI::App& app, Arguments& arguments)
{
  Options& options = arguments.options;
  app.add_option("-o,--output", arguments.output, "instead of OUTPUT behind INPUT")
    ->type_name("OUTPUT");
  app
    .add_option("--output-directory", arguments.output_directory,
                "a batch: results of all FILES, and of folders, under their names")
    ->type_name("FOLDER");
  app
    .add_flag("--as-one", arguments.tiles.is_as_one,
              "FILES are parts of one cloud of any size, and results tiles of it")
    ->needs(app.get_option("--output-directory"));
  add_choice(app, "--output-format", "FORMAT", written_formats(), options.output_format,
             "of OUTPUT")
    ->default_str("by extension");
  app.add_flag("--force", options.force, "replace an OUTPUT that exists");
  auto* points = app.add_option("-n,--points", options.number_of_points, "points to write")
                   ->check(count_within(1, max_number_of_output_points))
                   ->type_name("M");
  app.add_option("--percentage", options.percentage, "points to write, in percent of those read")
    ->check(number_within(0, false, 1e6, "a percentage in (0, 1000000]"))
    ->type_name("P")
    ->capture_default_str()
    ->excludes(points);
  app.add_flag("--keep-density", options.keep_density,
               "as dense here and there as INPUT is, instead of even");
  app.add_flag("--source-index", options.with_source_indices,
               "a property source_index: the nearest point of INPUT, from 0");
  app.add_flag("--feature-confidence", options.with_feature_confidences,
               "a property feature_confidence: 0 if smooth, 1 on an edge");
  app.add_flag("--side-confidence", options.with_side_confidences,
               "a property side_confidence: 0.5 if the side is a guess, 1 if sure");
  app.add_flag("--point-radius", options.with_neighbor_radii,
               "a property neighbor_radius: that which a point was fitted with");
  app.add_flag("--point-noise", options.with_noises,
               "a property noise: standard deviation of the points around");
  app.add_flag("--point-deviation", options.with_deviations,
               "two properties: how far a point and its normal may be off");
  app
    .add_option("--creases", options.creases,
                "OBJ, PLY or DXF: lines along which faces meet, and points on them")
    ->type_name("FILE")
    ->excludes(app.get_option("--keep-density"));
}

void add_options_on_input(CLI::App& app, Arguments& arguments)
{
  Options& options = arguments.options;
  add_choice(app, "--input-format", "FORMAT", formats, options.input_format, "of INPUT")
    ->default_str("by extension");
  const auto set_names = [&](const std::string& all) { options.columns = parse_column_names(all); };
  app
    .add_option_function<std::string>("--columns", set_names,
                                      "names of the columns of a text or array, - to leave one out")
    ->type_name("x,y,z,red,...");
  app.add_flag("--decimal-comma", options.has_decimal_commas,
               "numbers of a text have a comma for the point: 0,5");
  app.add_flag("--allow-degrees", options.allows_degrees,
               "read x and y though they are degrees, which are no lengths");
  app.add_flag("--drop-non-finite", options.drop_non_finite,
               "leave out points with a NaN or infinite coordinate");
  const auto set_classes = [&](const std::string& all) {
    options.classes = parse_classes("--keep-classes", all);
  };
  app
    .add_option_function<std::string>("--keep-classes", set_classes,
                                      "only points of these classifications, as LAS has them")
    ->type_name("2,6,...");
  app.add_flag("--first-returns", options.only_first_returns,
               "only points that are no second or later return, as LAS has them");
  const auto set_decompression = [&](const std::string& command) {
    if (command.find(Command_output::placeholder) == std::string::npos)
      refuse_usage("--decompress: " + command + " has no {}, which stands for the file");
    options.decompression = command;
  };
  app
    .add_option_function<std::string>("--decompress", set_decompression,
                                      "what writes a .laz file, for which {} stands, as LAS")
    ->type_name("COMMAND");
  auto* keep_outliers = app.add_flag("--keep-outliers", options.keep_outliers,
                                     "keep points off the cloud, which the default method leaves "
                                     "out");
  app
    .add_option("--outlier-sensitivity", options.outlier_sensitivity,
                "how readily these are left out, 0 to 3; also by lor and alor")
    ->check(number_within(0, true, 3, "a number in [0, 3]"))
    ->type_name("S")
    ->default_str("1")
    ->excludes(keep_outliers);
  app
    .add_option("--outliers", options.outliers,
                "write the points that are left out, to look at them")
    ->type_name("FILE")
    ->excludes(keep_outliers);
}

void add_options_on_method(CLI::App& app, Arguments& arguments)
{
  Options& options = arguments.options;
  constexpr double any = (std::numeric_limits<double>::max)();
  add_choice(app, "--method", "METHOD", methods, options.method, "how to resample");
  app.add_option("--neighbor-radius", options.neighbor_radius, "of a neighborhood, a length")
    ->check(number_within(0, false, any, "a length above 0"))
    ->type_name("R")
    ->default_str("from spacing and noise");
  auto* noise =
    app.add_option("--noise", options.noise, "of the points across the surface, a length")
      ->check(number_within(0, false, any, "a length above 0"))
      ->type_name("LENGTH")
      ->default_str("estimated");
  app
    .add_option("--noise-property", options.noise_property,
                "the property of INPUT that is the noise of each point")
    ->type_name("NAME")
    ->excludes(noise);
  app
    .add_option("--normal-weight", options.normal_weight,
                "larger: sharper edges up to a limit; smaller: nearer to INPUT")
    ->check(number_within(0, true, any, "a number, 0 or above"))
    ->type_name("L")
    ->default_str(CLI::detail::to_string(normal_weight_of(options)));
  app
    .add_option("--sharpness-angle", options.sharpness_angle,
                "normals that differ by more degrees are of two faces")
    ->check(number_within(0, false, 90, "an angle in (0, 90] degrees"))
    ->type_name("A")
    ->capture_default_str();
  app.add_option("--seed", options.seed, "chooses where the points start")
    ->check(count_within(0, any_count))
    ->type_name("K")
    ->capture_default_str();
  add_choice(app, "--solver", "SOLVER", solvers, options.solver, "how to solve");
  app
    .add_option("--solver-iterations", options.solver_iterations,
                "most iterations of a solve, but for cholesky")
    ->check(count_within(1, any_count))
    ->type_name("N");
}

void add_options_on_normals(CLI::App& app, Arguments& arguments)
{
  Options& options = arguments.options;
  app.add_flag("--use-normals", options.use_normals,
               "start from the normals of INPUT instead of estimating them");
  auto* by_normals = app.add_flag("--orient-by-normals", options.orient_by_normals,
                                  "turn the result as the normals of INPUT, instead of outwards");
  const auto set_viewpoint = [&options](const std::string& text) {
    options.ignore_viewpoint_of_file = text == "none";
    if (text != "none")
      options.viewpoint = parse_place("--viewpoint", text);
  };
  auto* viewpoint = app
                      .add_option_function<std::string>(
                        "--viewpoint", set_viewpoint,
                        "what normals face: where all was seen from [that of PCD, PLY]")
                      ->type_name("X,Y,Z|none")
                      ->excludes(by_normals);
  auto* viewpoints =
    app
      .add_option("--viewpoints", options.viewpoints,
                  "places that points were seen from, in lines x y z: the best view")
      ->type_name("FILE")
      ->excludes(by_normals)
      ->excludes(viewpoint);
  app
    .add_option("--view-property", options.view_property,
                "the property of INPUT that says which line it is, from 0")
    ->type_name("NAME")
    ->needs(viewpoints);
  const auto set_up = [&options](const std::string& text) {
    options.up_direction = parse_direction("--up", text);
  };
  app
    .add_option_function<std::string>("--up", set_up,
                                      "of points that were seen from above: the way up")
    ->type_name("X,Y,Z")
    ->excludes(by_normals)
    ->excludes(viewpoint)
    ->excludes(viewpoints);
}

void add_options_on_reports(CLI::App& app, Arguments& arguments)
{
  Options& options = arguments.options;
  app.add_option("--json", options.json, "write what was done, stage by stage")->type_name("FILE");
  app
    .add_option("--page", options.page,
                "a page for the browser: INPUT and result as points that turn")
    ->type_name("FILE.html")
    ->excludes(app.get_option("--output-directory"));
  app
    .add_option("--snapshot", options.snapshot,
                "draw INPUT and result; in a batch a folder for pictures")
    ->type_name("FILE.png");
  const auto set_view = [&options](const std::string& text) {
    options.view = parse_direction("--view", text);
  };
  app
    .add_option_function<std::string>("--view", set_view,
                                      "where the eye of the snapshot is, such as 1,-2,0.5")
    ->type_name("X,Y,Z");
  app
    .add_option("--snapshot-views", options.snapshot_views,
                "2 adds the other side, 3 the view from above, 4 that from below")
    ->check(count_within(1, most_views))
    ->type_name("N")
    ->capture_default_str();
  add_choice(app, "--snapshot-colors", "COLORS", snapshot_colors, options.snapshot_colors,
             "how to color points");
  app.add_flag("--quiet", options.quiet, "no summary, no progress bar, no warnings");
  app.add_flag("--strict", options.strict, "write nothing if a solve did not converge");
}

void add_options_on_machine(CLI::App& app, Arguments& arguments)
{
  Options& options = arguments.options;
  add_choice(app, "--device", "DEVICE", devices, options.device, "where to compute");
  app.add_option("--threads", options.threads, "most threads to use")
    ->check(count_within(1, 4096))
    ->type_name("N")
    ->default_str("all");
  app.add_option("--max-points", options.max_points, "refuse an INPUT of more points")
    ->check(count_within(0, any_count))
    ->type_name("N");
  app
    .add_option("--max-memory", options.max_memory,
                "fail rather than take more, in bytes or as in 4GB")
    ->transform(CLI::AsSizeValue(false).description(""))
    ->type_name("SIZE");
  auto* as_one = app.get_option("--as-one");
  auto* memory = app
                   .add_option("--memory", arguments.tiles.memory,
                               "with --as-one: what it may take, which decides on the tiles")
                   ->transform(CLI::AsSizeValue(false).description(""))
                   ->type_name("SIZE")
                   ->needs(as_one);
  as_one->needs(memory);
  app
    .add_option("--halo", arguments.tiles.halo,
                "with --as-one: how far around it a tile sees points")
    ->check(number_within(1, true, 1000, "a number in [1, 1000]"))
    ->type_name("RADII")
    ->needs(as_one)
    ->capture_default_str();
  app.add_option("--timeout", options.timeout, "fail after so many seconds")
    ->check(number_within(0, false, 1e8, "a number of seconds above 0"))
    ->type_name("SECONDS");
}

void add_other_tasks(CLI::App& app, Arguments& arguments)
{
  auto* as_one = app.get_option("--as-one");
  app
    .add_flag("--resume", arguments.tiles.resumes,
              "with --as-one: go on where an earlier run has ended")
    ->needs(as_one);
  // for programs that run steps in an order and on machines of their own; hidden
  app.add_option("--task", arguments.tiles.task)->needs(as_one)->group("");
  app.add_flag("--info", arguments.options.info,
               "tell what INPUT is and what the defaults would be; write nothing");
  app.add_flag("--dry-run", arguments.options.dry_run,
               "read INPUT, check all that can be, and write nothing");
  app.add_flag("--convert-only", arguments.options.convert_only,
               "write the points of INPUT as they are, in the format of OUTPUT");
  app.add_flag("--orient-only", arguments.options.orient_only,
               "the same, but turn normals to their side; estimate missing ones");
  app
    .add_option("--config", arguments.config,
                "read lines option = value; the command line goes before them")
    ->type_name("FILE");
  app.set_help_flag("-h,--help", "print this page");
  app.set_version_flag("-V,--version",
                       std::string("l0_resample " L0_RESAMPLE_VERSION ", CGAL " CGAL_VERSION_STR),
                       "print the version");
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
  using Adder = void (*)(CLI::App&, Arguments&);
  static constexpr std::array<std::pair<const char*, Adder>, 7> groups = {
    {{"Result", add_options_on_result},
     {"Input", add_options_on_input},
     {"Method", add_options_on_method},
     {"Normals", add_options_on_normals},
     {"Reports", add_options_on_reports},
     {"Machine", add_options_on_machine},
     {"Other tasks", add_other_tasks}}};
  app.set_help_flag();
  for (const auto& [name, add] : groups) {
    app.option_defaults()->group(name);
    add(app, arguments);
  }
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

std::string name_of(Solver solver) { return key_of(solvers, solver); }

} // namespace l0_tool
