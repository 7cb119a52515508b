// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/options.h"

#include "basis/Failure.h"
#include "basis/messages.h"
#include "command_line/check_paths.h"
#include "command_line/command_line.h"
#include "command_line/config_file.h"
#include "command_line/manual.h"
#include "files/batch.h"
#include "files/file_formats.h"
#include "formats/write_creases.h"

#include <CGAL/L0_resampling/tags.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace l0_tool {
namespace {

/// \param given by `option`
File_format choose_format(const std::string& path, const std::string& option,
                          const std::optional<File_format>& given)
{
  if (given)
    return *given;
  const std::optional<File_format> by_extension = format_of(path);
  std::error_code error;
  if (!by_extension && std::filesystem::is_directory(path, error))
    refuse_usage(path + ": is a folder; --output-directory resamples all files of folders");
  if (!by_extension)
    refuse_usage(path == standard_stream ? path + ": " + option + " tells what the points are"
                                         : unknown_extension(path, option));
  return *by_extension;
}

// Nothing that the command line asks for is ignored.
void check_effects(const CLI::App& app, const Options& options)
{
  if (app.count("--keep-outliers") > 0 && options.method != CGAL::L0_resampling::Method::DEFAULT)
    refuse_usage("--keep-outliers: " + name_of(options.method) + " keeps all points anyway");
  if (app.count("--solver-iterations") > 0 && options.solver == Solver::CHOLESKY)
    refuse_usage("--solver-iterations: cholesky has none");
  if (!options.creases.empty() && options.method != CGAL::L0_resampling::Method::DEFAULT)
    refuse_usage("--creases: " + name_of(options.method) + " finds none, the default method does");
  if (!options.creases.empty() && !crease_format_of(options.creases))
    refuse_usage(options.creases + ": the extension of creases is .obj, .ply or .dxf");
  if (!options.outliers.empty() && options.method != CGAL::L0_resampling::Method::DEFAULT
      && !options.outlier_sensitivity)
    refuse_usage("--outliers: " + name_of(options.method)
                 + " leaves none out without --outlier-sensitivity");
  if (!options.outliers.empty()) {
    const std::optional<File_format> format = format_of(options.outliers);
    if (!format)
      refuse_usage(options.outliers + ": the extension of --outliers is none of a format");
    const std::string reason = reason_against_output(options.outliers, *format);
    if (!reason.empty())
      refuse_usage(reason);
  }
  for (const char* option : {"--view", "--snapshot-views", "--snapshot-colors"})
    if (app.count(option) > 0 && options.snapshot.empty())
      refuse_usage(std::string(option) + ": there is no --snapshot to look at");
}

// Only a text and an array have columns to name; viewpoints are a text too.
void check_columns(const Options& options)
{
  const bool is_text = options.input_format == File_format::XYZ
                       || options.input_format == File_format::CSV || !options.refusal.empty();
  if (!options.columns.empty() && !is_text && options.input_format != File_format::NPY)
    refuse_usage("--columns: " + options.input_name()
                 + " is no text (XYZ or CSV) and no array (NPY)");
  if (options.has_decimal_commas && !is_text && options.viewpoints.empty())
    refuse_usage("--decimal-comma: " + options.input_name() + " is no text (XYZ or CSV)");
}

void check_no_file_is_replaced(const std::vector<Options>& runs)
{
  std::vector<std::string> outputs;
  for (const Options& options : runs)
    if (!options.force && !options.info && options.refusal.empty())
      outputs.push_back(options.output);
  check_nothing_is_replaced(outputs);
}

void set_files(Arguments& arguments)
{
  Options& options = arguments.options;
  const std::vector<std::string>& files = arguments.files;
  if (options.info) {
    if (files.size() > 1)
      refuse_usage("--info: one INPUT expected, found " + std::to_string(files.size()) + " files");
    options.input = files[0];
    options.input_format = choose_format(options.input, "--input-format", arguments.input_format);
    check_columns(options);
    return;
  }
  if (files.size() == 1)
    refuse_usage("OUTPUT is required");
  if (files.size() > 2)
    refuse_usage("INPUT and OUTPUT expected, found " + std::to_string(files.size())
                 + " files; --output-directory resamples them all");
  options.input = files[0];
  options.output = files[1];
  options.input_format = choose_format(options.input, "--input-format", arguments.input_format);
  options.output_format = choose_format(options.output, "--output-format", arguments.output_format);
  const std::string reason = reason_against_output(options.output, options.output_format);
  if (!reason.empty())
    refuse_usage(reason);
  if (!options.snapshot.empty() && lower_extension(options.snapshot) != ".png")
    refuse_usage(options.snapshot + ": the extension of a snapshot is .png");
  if (!options.page.empty() && lower_extension(options.page) != ".html")
    refuse_usage(options.page + ": the extension of a page is .html");
  check_columns(options);
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

std::vector<Options> batch_of(const Arguments& arguments)
{
  const Options& options = arguments.options;
  if (lower_extension(options.snapshot) == ".png")
    refuse_usage("--snapshot: in a batch a folder expected, found " + options.snapshot);
  for (const auto& [name, path] :
       {std::pair("--creases", options.creases), std::pair("--outliers", options.outliers)})
    if (!path.empty())
      refuse_usage(std::string(name) + " excludes --output-directory, but for --as-one");
  std::vector<Options> runs;
  for (const Batch_item& item : plan_batch(arguments.files, arguments.output_directory,
                                           arguments.input_format, arguments.output_format)) {
    runs.push_back(options);
    runs.back().input = item.input;
    runs.back().output = item.output;
    runs.back().input_format = item.input_format;
    runs.back().output_format = item.output_format;
    runs.back().refusal = item.refusal;
    runs.back().is_in_batch = true;
    runs.back().snapshot = snapshot_of(options.snapshot, item.output);
    check_columns(runs.back());
  }
  return runs;
}

std::vector<Options> parts_of(const CLI::App& app, const Arguments& arguments)
{
  for (const char* option : {"--max-points", "--max-memory"})
    if (app.count(option) > 0)
      refuse_usage(std::string(option) + " excludes --as-one");
  std::vector<Options> parts;
  for (const Batch_item& item : parts_of_cloud(arguments.files, arguments.input_format)) {
    parts.push_back(arguments.options);
    parts.back().input = item.input;
    parts.back().input_format = item.input_format;
    parts.back().output_format = arguments.output_format.value_or(File_format::PLY);
    check_columns(parts.back());
  }
  return parts;
}

void check_merged_output(const std::string& path, const Options& options)
{
  if (path.empty())
    return;
  const std::optional<File_format> format = format_of(path);
  if (!format)
    refuse_usage(unknown_extension(path, "--output"));
  const std::string reason = reason_against_output(path, *format);
  if (!reason.empty())
    refuse_usage(reason);
  if (!options.force)
    check_nothing_is_replaced({path});
}

std::shared_ptr<const std::vector<Setting>> settings_of(const Arguments& arguments)
{
  auto settings = std::make_shared<std::vector<Setting>>();
  for (const std::function<Setting()>& setting : arguments.settings)
    settings->push_back(setting());
  return settings;
}

/// \param command_line without what a file adds
Command command_of(const CLI::App& app, const CLI::App& command_line, Arguments& arguments)
{
  Command command;
  std::vector<std::string>& files = arguments.files;
  command.output_directory = arguments.output_directory;
  if (app.count("--output-directory") > 0 && command.output_directory.empty())
    refuse_usage("--output-directory: the name is empty");
  if (files.empty())
    refuse_usage("INPUT is required");
  if (app.count("--output") > 0 && !command.output_directory.empty() && !arguments.tiles.is_as_one)
    refuse_usage("--output excludes --output-directory");
  if (app.count("--output") > 0 && arguments.tiles.is_as_one)
    command.merged_output = arguments.output;
  else if (app.count("--output") > 0) {
    if (files.size() > 1)
      refuse_usage("--output: one INPUT expected, found " + std::to_string(files.size())
                   + " files");
    files.push_back(arguments.output);
  }
  check_effects(command_line, arguments.options);
  command.tiles = arguments.tiles;
  arguments.options.settings = settings_of(arguments);
  if (command.tiles.is_as_one) {
    command.runs = parts_of(app, arguments);
    if (!command.tiles.resumes && command.tiles.task.empty())
      check_merged_output(command.merged_output, arguments.options);
  } else if (command.is_batch())
    command.runs = batch_of(arguments);
  else {
    set_files(arguments);
    command.runs.push_back(arguments.options);
  }
  check_paths(command, arguments.config);
  return command;
}

} // namespace

std::optional<int> parse_command_line(int argc, char** argv, Command& command)
{
  Arguments arguments;
  CLI::App app("", "l0_resample");
  add_options(app, arguments);
  try {
    app.parse(argc, argv);
    if (app.count("--config") == 0)
      command = command_of(app, app, arguments);
    else {
      std::vector<std::string> words = read_config(arguments.config, app);
      words.insert(words.end(), argv + 1, argv + argc);
      std::reverse(words.begin(), words.end()); // as CLI11 wants them
      Arguments all;
      CLI::App with_config("", "l0_resample");
      add_options(with_config, all);
      with_config.parse(words);
      command = command_of(with_config, app, all);
    }
    if (!command.tiles.is_as_one)
      check_no_file_is_replaced(command.runs);
    return std::nullopt;
  } catch (const Failure& failure) {
    print_error(failure.what());
    return failure.status();
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == int(CLI::ExitCodes::Success)) {
      std::cout << (app.count("--help") > 0 ? help_text(app) : error.what() + std::string("\n"))
                << std::flush; // --help, --version
      return std::cout ? SUCCESS : OUTPUT_NOT_WRITTEN;
    }
    print_error(error.what() + std::string(" (see --help)"));
    return WRONG_USAGE;
  }
}

} // namespace l0_tool
