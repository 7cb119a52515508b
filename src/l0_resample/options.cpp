// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"

#include "Failure.h"
#include "Text_columns.h"
#include "batch.h"
#include "parse_numbers.h"

#include <CGAL/L0_resampling/internal/Parameters.h>
#include <CGAL/version.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <string_view>
#include <vector>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::Method;

const std::map<std::string, Method> methods = {
  {"default", Method::DEFAULT}, {"lor", Method::LOR}, {"alor", Method::ALOR}};
const std::map<std::string, Solver> solvers = {
  {"block-cg", Solver::BLOCK_CG}, {"cholesky", Solver::CHOLESKY}, {"rows-cg", Solver::ROWS_CG}};
const std::map<std::string, Device> devices = {
  {"cpu", Device::CPU}, {"cuda", Device::CUDA}, {"auto", Device::AUTO}};
const std::map<std::string, File_format> formats = {
  {"ply", File_format::PLY}, {"off", File_format::OFF}, {"xyz", File_format::XYZ},
  {"pcd", File_format::PCD}, {"npy", File_format::NPY}, {"csv", File_format::CSV},
  {"obj", File_format::OBJ}};

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

/// An option whose value is one of `names`.
template <typename Value>
CLI::Option* add_choice(CLI::App& app, const std::string& option,
                        const std::map<std::string, Value>& names, Value& value,
                        const std::string& description)
{
  const auto choose = [names, &value](const std::string& name) {
    value = names.at(CLI::detail::to_lower(name));
  };
  return app.add_option_function<std::string>(option, choose, description)
    ->check(CLI::IsMember(keys_of(names), CLI::ignore_case))
    ->default_str(key_of(names, value));
}

/// Numbers are read as those in files are, so that a decimal comma or a "nan" is refused.
CLI::Validator number_within(double low, bool low_allowed, double high,
                             const std::string& description)
{
  return CLI::Validator(
    [=](std::string& text) {
      const std::optional<double> number = parse_number<double>(text);
      const bool is_good = number && std::isfinite(*number)
                           && (low_allowed ? *number >= low : *number > low) && *number <= high;
      return is_good ? std::string() : text + " is not " + description;
    },
    "");
}

CLI::Validator count_within(std::uint64_t low, std::uint64_t high)
{
  return CLI::Validator(
    [=](std::string& text) {
      const std::optional<std::uint64_t> number = parse_number<std::uint64_t>(text);
      const bool is_good = number && *number >= low && *number <= high;
      if (is_good)
        return std::string();
      return text + " is not a whole number from " + std::to_string(low) + " to "
             + std::to_string(high);
    },
    "");
}

constexpr std::uint64_t any_count = (std::numeric_limits<std::uint64_t>::max)();

[[noreturn]] void refuse_usage(const std::string& message)
{
  throw CLI::ValidationError(message, int(WRONG_USAGE));
}

/// Three numbers separated by commas.
std::array<double, 3> parse_coordinates(const std::string& option, const std::string& text)
{
  std::string words = text;
  std::replace(words.begin(), words.end(), ',', ' ');
  std::string_view rest = words;
  std::array<double, 3> numbers;
  for (double& number : numbers) {
    number =
      parse_number<double>(next_word(rest)).value_or(std::numeric_limits<double>::quiet_NaN());
    if (!std::isfinite(number))
      refuse_usage(option + ": " + text + " is not three numbers separated by commas");
  }
  if (!next_word(rest).empty())
    refuse_usage(option + ": " + text + " is more than three numbers");
  return numbers;
}

std::array<double, 3> parse_direction(const std::string& option, const std::string& text)
{
  const std::array<double, 3> direction = parse_coordinates(option, text);
  if (std::all_of(direction.begin(), direction.end(), [](double number) { return number == 0; }))
    refuse_usage(option + ": " + text + " is not a direction");
  return direction;
}

void choose_format(const std::string& path, const std::string& option, const CLI::App& app,
                   File_format& format)
{
  if (app.count(option) > 0)
    return;
  const std::optional<File_format> by_extension = format_of(path);
  if (!by_extension)
    refuse_usage(path == standard_stream ? path + ": " + option + " tells what the points are"
                                         : unknown_extension(path, option));
  format = *by_extension;
}

// Input and output may be one file; nothing else may.
void check_paths_differ(const Options& options)
{
  const std::string input = options.input == standard_stream ? "/dev/stdin" : options.input;
  for (const std::string& path : {options.json, options.snapshot})
    if (are_same_file(path, input) || are_same_file(path, options.output))
      refuse_usage(path + ": is named twice");
  if (are_same_file(options.json, options.snapshot))
    refuse_usage(options.json + ": is named twice");
}

const char* description = "Turns a noisy point set into clean, evenly spread, oriented points that "
                          "keep sharp features, by L0 minimization.\n"
                          "\n"
                          "  l0_resample [OPTIONS] INPUT OUTPUT\n"
                          "  l0_resample [OPTIONS] INPUT... --output-directory FOLDER\n"
                          "  l0_resample --convert-only INPUT OUTPUT";

const char* footer =
  R"(Files: PLY and PCD (ASCII, binary and compressed), OFF, XYZ, NPY, CSV and OBJ are read; PLY and
PCD (binary), OFF, XYZ and NPY are written with normals, as a whole or not at all. What gzip has
compressed (.ply.gz, ...) is read as what it stands for. LAS is not read: convert it first. A name that begins with a dash goes behind --.

A file is not replaced without --force: if OUTPUT exists, also if it is INPUT, or a result of a
batch, nothing is done. Reports (--json) and pictures (--snapshot) of an earlier run are replaced.
INPUT - is standard input; OUTPUT - and --json - are standard output. That, a pipe, and what leads
to a descriptor, such as /dev/stdout, /dev/fd/3 or /proc/self/fd/3, is written to as it is open,
also if it is redirected to a file.

XYZ, a text, has coordinates in its first three columns and, if it has six, normals in the others.
Where these are no unit vectors a warning says so, and they are left out. --columns tells what the
columns are: x, y, z, nx, ny, nz, red, green, blue, alpha as in PLY, any other name for a property
of the points, - or _ for a column to leave out. CSV, a table, names its columns in its first line.

--convert-only keeps the points as they are: PLY and PCD (binary) get all that INPUT tells of each,
OFF normals and colors, XYZ and NPY normals; warnings say what else INPUT had. It takes no option on
resampling.

Exit status: 0 good, 1 failed at run time (memory, time, solver, device), 2 wrong usage, 3 input
refused, 4 output not written, 5 not converged (with --strict), 130 and 143 cancelled by SIGINT and
SIGTERM. Standard output gets one line of summary; if points or a report go there, standard error
gets it.

In a batch, standard output gets one line for each file that was resampled, and standard error, at
the end, one for each that failed, also one of no known format, and their number; the others are not
harmed. The exit status is that of the failures if they all have the same, else 1. After SIGINT,
SIGTERM or --timeout no other file is begun. A result never takes the place of an input, or of
another result.
)";

// What a conversion has no use for is refused with it.
void exclude_resampling(CLI::App& app, CLI::Option& convert_only)
{
  static constexpr std::array<std::string_view, 15> allowed = {
    "help",   "version",       "FILES",           "output-directory", "input-format",
    "output", "output-format", "drop-non-finite", "convert-only",     "columns",
    "force",  "quiet",         "max-points",      "max-memory",       "timeout"};
  for (CLI::Option* option : app.get_options())
    if (std::find(allowed.begin(), allowed.end(), option->get_single_name()) == allowed.end())
      convert_only.excludes(option);
}

void add_options(CLI::App& app, Options& options, std::vector<std::string>& files,
                 std::string& output, std::string& output_directory)
{
  app.add_option("FILES", files, "INPUT, points to read, and OUTPUT, points with normals to write")
    ->type_name("FILE");
  app
    .add_option(
      "--output-directory", output_directory,
      "a batch: all FILES are read, and those of folders; results go here, under the same names")
    ->type_name("FOLDER")
    ->excludes(app.add_option("-o,--output", output, "OUTPUT, behind which is one INPUT alone")
                 ->type_name("OUTPUT"));

  auto* points = app
                   .add_option("-n,--points", options.number_of_points, "how many points to write")
                   ->check(count_within(1, max_number_of_output_points))
                   ->type_name("M");
  app
    .add_option("--percentage", options.percentage,
                "how many points to write, in percent of those read")
    ->check(number_within(0, false, 1e6, "a percentage in (0, 1000000]"))
    ->type_name("P")
    ->capture_default_str()
    ->excludes(points);
  add_choice(app, "--method", methods, options.method,
             "the paper's LOR or ALOR, or what is recommended");
  app
    .add_option("--neighbor-radius", options.neighbor_radius,
                "radius of a neighborhood, a length [from spacing and noise; lor, alor: diagonal / "
                "cube root of points]")
    ->check(number_within(0, false, (std::numeric_limits<double>::max)(), "a length above 0"))
    ->type_name("R");
  app
    .add_option(
      "--normal-weight", options.normal_weight,
      "larger: sharper edges, flatter faces; smaller: closer to the input; in the default "
      "method values beyond a limit, which grows with the noise, act as the limit does")
    ->check(number_within(0, true, (std::numeric_limits<double>::max)(), "a number, 0 or above"))
    ->type_name("L")
    ->default_str("0.9");
  app
    .add_option("--sharpness-angle", options.sharpness_angle,
                "normals that differ by much more, in degrees, are of two faces")
    ->check(number_within(0, false, 90, "an angle in (0, 90] degrees"))
    ->type_name("A")
    ->capture_default_str();
  app.add_option("--seed", options.seed, "chooses where the points start")
    ->check(count_within(0, any_count))
    ->type_name("K")
    ->capture_default_str();
  app.add_flag("--use-normals", options.use_normals,
               "start from the normals of INPUT instead of estimating them");
  auto* by_normals =
    app.add_flag("--orient-by-normals", options.orient_by_normals,
                 "turn the result to the side of the normals of INPUT, instead of outwards");
  const auto set_viewpoint = [&options](const std::string& text) {
    options.ignore_viewpoint_of_file = text == "none";
    if (text != "none")
      options.viewpoint = parse_coordinates("--viewpoint", text);
  };
  auto* viewpoint =
    app
      .add_option_function<std::string>(
        "--viewpoint", set_viewpoint,
        "where all points were seen from, which normals face [the VIEWPOINT of PCD, unless none]")
      ->type_name("X,Y,Z")
      ->excludes(by_normals);
  auto* viewpoints =
    app
      .add_option("--viewpoints", options.viewpoints,
                  "several places that points were seen from: a text with lines x y z")
      ->type_name("FILE")
      ->excludes(by_normals)
      ->excludes(viewpoint);
  auto* view_property =
    app
      .add_option("--view-property", options.view_property,
                  "the property of INPUT that says from which line of these, counted from 0")
      ->type_name("NAME")
      ->needs(viewpoints);
  viewpoints->needs(view_property);
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
  app.add_flag("--keep-density", options.keep_density,
               "as dense here and there as INPUT is, instead of even");
  app.add_flag("--drop-non-finite", options.drop_non_finite,
               "leave out points with a NaN or infinite coordinate");
  app.add_flag("--keep-outliers", options.keep_outliers,
               "let points off the cloud take part, which the default method leaves out");

  add_choice(app, "--device", devices, options.device, "where to compute");
  add_choice(app, "--solver", solvers, options.solver, "how to solve the linear systems");
  app
    .add_option("--solver-iterations", options.solver_iterations,
                "most iterations of a solve by block-cg or rows-cg")
    ->check(count_within(1, any_count))
    ->type_name("N");
  app.add_option("--threads", options.threads, "most threads to use [all]")
    ->check(count_within(1, 4096))
    ->type_name("N");

  app.add_flag("--source-index", options.with_source_indices,
               "one more property, source_index: which point of INPUT is nearest, counted from 0");
  app.add_flag("--feature-confidence", options.with_feature_confidences,
               "a property feature_confidence more: from 0 on a smooth surface to 1 on an edge");
  app.add_option("--json", options.json, "write what was done, stage by stage")->type_name("FILE");
  app
    .add_option("--snapshot", options.snapshot,
                "draw input and result side by side, colored by normal direction; in a batch into "
                "this folder, as NAME.png of each result NAME")
    ->type_name("FILE.png");
  const auto set_view = [&options](const std::string& text) {
    options.view = parse_direction("--view", text);
  };
  app
    .add_option_function<std::string>("--view", set_view,
                                      "where the eye of the snapshot is, such as 1,-2,0.5")
    ->type_name("X,Y,Z");
  auto* convert_only =
    app.add_flag("--convert-only", options.convert_only,
                 "do not resample: write the points of INPUT in the format of OUTPUT");
  app.add_flag("--force", options.force, "replace an OUTPUT that exists");
  app.add_flag("--quiet", options.quiet, "no summary, no progress bar, no warnings");
  app.add_flag("--strict", options.strict, "write nothing if a solve did not converge");

  add_choice(app, "--input-format", formats, options.input_format, "what INPUT is")
    ->default_str("by extension");
  add_choice(app, "--output-format", written_formats(), options.output_format, "what OUTPUT is")
    ->default_str("by extension");
  const auto set_names = [&](const std::string& all) { options.columns = parse_column_names(all); };
  app.add_option_function<std::string>("--columns", set_names, "what the columns of a text are")
    ->type_name("x,y,z,red,...");
  app.add_option("--max-points", options.max_points, "refuse an INPUT of more points")
    ->check(count_within(0, any_count))
    ->type_name("N");
  app
    .add_option("--max-memory", options.max_memory,
                "fail rather than take more, in bytes or as in 4GB")
    ->transform(CLI::AsSizeValue(false))
    ->type_name("SIZE");
  app.add_option("--timeout", options.timeout, "fail after so many seconds")
    ->check(number_within(0, false, 1e8, "a number of seconds above 0"))
    ->type_name("SECONDS");
  exclude_resampling(app, *convert_only);
}

// Nothing that is asked for is ignored.
void check_effects(const CLI::App& app, const Options& options)
{
  if (options.keep_outliers && options.method != Method::DEFAULT)
    refuse_usage("--keep-outliers: " + name_of(options.method) + " keeps all points anyway");
  if (options.solver_iterations && options.solver == Solver::CHOLESKY)
    refuse_usage("--solver-iterations: cholesky has none");
  if (options.view && app.count("--snapshot") == 0)
    refuse_usage("--view: there is no --snapshot to look at");
}

// Only a text has columns to name.
void check_columns(const Options& options)
{
  const bool is_text = options.input_format == File_format::XYZ
                       || options.input_format == File_format::CSV || !options.refusal.empty();
  if (!options.columns.empty() && !is_text)
    refuse_usage("--columns: " + options.input_name() + " is no text (XYZ or CSV)");
}

void check_no_file_is_replaced(const std::vector<Options>& runs)
{
  std::vector<std::string> outputs;
  for (const Options& options : runs)
    if (!options.force && options.refusal.empty())
      outputs.push_back(options.output);
  check_nothing_is_replaced(outputs);
}

void set_files(const CLI::App& app, const std::vector<std::string>& files, Options& options)
{
  if (files.size() == 1)
    refuse_usage("OUTPUT is required");
  if (files.size() > 2)
    refuse_usage("INPUT and OUTPUT expected, found " + std::to_string(files.size())
                 + " files; --output-directory resamples them all");
  options.input = files[0];
  options.output = files[1];
  choose_format(options.input, "--input-format", app, options.input_format);
  choose_format(options.output, "--output-format", app, options.output_format);
  const std::string reason = reason_against_output(options.output, options.output_format);
  if (!reason.empty())
    refuse_usage(reason);
  if (!options.snapshot.empty() && std::filesystem::path(options.snapshot).extension() != ".png")
    refuse_usage(options.snapshot + ": the extension of a snapshot is .png");
  check_columns(options);
  check_paths_differ(options);
}

/// Of a result of a batch, whose name goes on in that of its picture: others may differ in the
/// extension alone.
std::string snapshot_of(const std::string& folder, const std::string& output)
{
  if (folder.empty() || output.empty())
    return "";
  return (std::filesystem::path(folder) / std::filesystem::path(output).filename()).string()
         + ".png";
}

std::vector<Options> batch_of(const CLI::App& app, const std::vector<std::string>& inputs,
                              const std::string& directory, const Options& options)
{
  if (std::filesystem::path(options.snapshot).extension() == ".png")
    refuse_usage("--snapshot: in a batch a folder expected, found " + options.snapshot);
  const auto given = [&app](const std::string& option, File_format format) {
    return app.count(option) > 0 ? std::optional<File_format>(format) : std::nullopt;
  };
  std::vector<Options> runs;
  for (const Batch_item& item :
       plan_batch(inputs, directory, given("--input-format", options.input_format),
                  given("--output-format", options.output_format))) {
    runs.push_back(options);
    runs.back().input = item.input;
    runs.back().output = item.output;
    runs.back().input_format = item.input_format;
    runs.back().output_format = item.output_format;
    runs.back().refusal = item.refusal;
    runs.back().snapshot = snapshot_of(options.snapshot, item.output);
    check_columns(runs.back());
    check_paths_differ(runs.back());
  }
  return runs;
}

} // namespace

std::optional<int> parse_command_line(int argc, char** argv, Command& command)
{
  Options options;
  std::vector<std::string> files;
  CLI::App app(description, "l0_resample");
  app.footer(footer);
  app.set_version_flag("-V,--version",
                       std::string("l0_resample " L0_RESAMPLE_VERSION ", CGAL " CGAL_VERSION_STR));
  app.get_formatter()->column_width(34);
  std::string output;
  add_options(app, options, files, output, command.output_directory);
  try {
    app.parse(argc, argv);
    if (app.count("--output-directory") > 0 && command.output_directory.empty())
      refuse_usage("--output-directory: the name is empty");
    if (files.empty())
      refuse_usage("INPUT is required");
    if (app.count("--output") > 0) {
      if (files.size() > 1)
        refuse_usage("--output: one INPUT expected, found " + std::to_string(files.size())
                     + " files");
      files.push_back(output);
    }
    check_effects(app, options);
    if (command.is_batch())
      command.runs = batch_of(app, files, command.output_directory, options);
    else {
      set_files(app, files, options);
      command.runs.push_back(options);
    }
    check_no_file_is_replaced(command.runs);
    return std::nullopt;
  } catch (const Failure& failure) {
    std::cerr << "l0_resample: " << failure.what() << std::endl;
    return failure.status();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == int(CLI::ExitCodes::Success)) {
      app.exit(error); // --help, --version
      return SUCCESS;
    }
    std::cerr << "l0_resample: " << error.what() << " (see --help)" << std::endl;
    return WRONG_USAGE;
  }
}

double normal_weight_of(const Options& options)
{
  return options.normal_weight.value_or(CGAL::L0_resampling::internal::Parameters().normal_weight);
}

std::string name_of(Method method) { return key_of(methods, method); }

std::string name_of(Solver solver) { return key_of(solvers, solver); }

} // namespace l0_tool
