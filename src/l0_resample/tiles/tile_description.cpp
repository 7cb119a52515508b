// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/tile_description.h"

#include "basis/Failure.h"
#include "files/file_formats.h"
#include "files/tile_folder.h"
#include "formats/Output_columns.h"
#include "system/files_of_system.h"
#include "tiles/Task_file.h"
#include "tiles/processor_of_tiles.h"

#include <CGAL/L0_resampling/instructions.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

namespace l0_tool {

extern const char* const hash_of_sources; // by hash_of_sources.cmake

namespace {

namespace fs = std::filesystem;

constexpr const char* begin_of_input = "input ";

/// Compilers order and fuse operations differently, each by its options.
std::string compiler()
{
#if defined(__clang__)
  return "clang++ " __clang_version__ ", " L0_RESAMPLE_COMPILER_OPTIONS;
#else
  return "g++ " __VERSION__ ", " L0_RESAMPLE_COMPILER_OPTIONS;
#endif
}

std::string line_of_input(const Options& options)
{
  const std::optional<File_status> status = status_of(options.input);
  if (!status)
    throw Failure(INPUT_REFUSED,
                  options.input + ": cannot be opened: " + std::generic_category().message(errno));
  if (status->kind != File_kind::REGULAR)
    throw Failure(INPUT_REFUSED,
                  options.input + ": --as-one reads its files twice, and this is no regular file");
  std::ostringstream line;
  line << begin_of_input << fs::absolute(options.input).string() << ": "
       << extension_of(options.input_format).substr(1) << ", " << status->size << " bytes of "
       << status->seconds << "." << status->nanoseconds;
  return line.str();
}

std::vector<std::string> lines_of(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

void put_vector(const char* name, const std::optional<std::array<double, 3>>& vector,
                std::ostream& stream)
{
  stream << name;
  if (vector)
    for (const double coordinate : *vector)
      stream << " " << coordinate;
  stream << "\n";
}

/// What the index of a run says; an empty object if there is none.
nlohmann::json read_index(const std::string& path)
{
  std::ifstream stream(path);
  const nlohmann::json json = nlohmann::json::parse(stream, nullptr, false);
  return json.is_object() ? json : nlohmann::json::object();
}

} // namespace

bool carries_properties(const Command& command)
{
  return holds_properties(command.runs.front().output_format)
         || (!command.merged_output.empty() && holds_properties(*format_of(command.merged_output)));
}

std::string describe_run(const Command& command)
{
  const Options& options = command.runs.front();
  std::ostringstream text;
  text.precision(17);
  text << "program " L0_RESAMPLE_VERSION "\n"
       << "sources " << hash_of_sources << "\n"
       << "compiler " << compiler() << "\n"
       << "instructions " << CGAL::L0_resampling::instructions_of_stages() << "\n"
       << "--points ";
  if (options.number_of_points)
    text << *options.number_of_points << "\n";
  else
    text << options.percentage << " %\n";
  text << "--memory " << command.tiles.memory << "\n"
       << "--halo " << command.tiles.halo << "\n"
       << "--device " << (are_tiles_on_device(options) ? "cuda" : "cpu") << "\n"
       << "--output-format " << extension_of(options.output_format) << "\n"
       << "properties " << carries_properties(command) << "\n"
       << "--neighbor-radius " << options.neighbor_radius.value_or(0) << "\n"
       << "--noise " << options.noise.value_or(0) << "\n"
       << "--normal-weight " << normal_weight_of(options) << "\n"
       << "--sharpness-angle " << options.sharpness_angle << "\n"
       << "--seed " << options.seed << "\n"
       << "--keep-density " << options.keep_density << "\n"
       << "--creases " << !options.creases.empty() << "\n"
       << "--outliers " << !options.outliers.empty() << "\n"
       << "--keep-outliers " << options.keep_outliers << "\n"
       << "--outlier-sensitivity " << options.outlier_sensitivity.value_or(1) << "\n"
       << "--drop-non-finite " << options.drop_non_finite << "\n"
       << "--first-returns " << options.only_first_returns << "\n"
       << "--decompress " << options.decompression << "\n"
       << "--keep-classes";
  for (const unsigned number : options.classes)
    text << " " << number;
  text << "\n--columns";
  for (const std::string& column : options.columns)
    text << " " << column;
  text << "\n"
       << "--decimal-comma " << options.has_decimal_commas << "\n"
       << "--allow-degrees " << options.allows_degrees << "\n";
  put_vector("--viewpoint", options.viewpoint, text);
  put_vector("--up", options.up_direction, text);
  for (const Options& input : command.runs)
    text << line_of_input(input) << "\n";
  return text.str();
}

std::uint64_t key_of_run(const std::string& description)
{
  Checksum checksum;
  checksum.add(description);
  return checksum.value();
}

std::string read_description(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (stream)
    text << stream.rdbuf();
  return text.str();
}

std::string read_finished(const std::string& index)
{
  const nlohmann::json json = read_index(index);
  return json.contains("run") && json["run"].is_string() ? json["run"].get<std::string>()
                                                         : std::string();
}

void check_same_run(const std::string& old, const std::string& now)
{
  const std::vector<std::string> then = lines_of(old), current = lines_of(now);
  for (std::size_t i = 0; i < (std::max)(then.size(), current.size()); ++i) {
    const std::string a = i < then.size() ? then[i] : "", b = i < current.size() ? current[i] : "";
    if (a == b)
      continue;
    if ((a.empty() ? b : a).rfind(begin_of_input, 0) == 0)
      throw Failure(INPUT_REFUSED, "--resume: the run began with "
                                     + (a.empty() ? "no such input" : a) + ", now it is "
                                     + (b.empty() ? "none" : b));
    throw Failure(WRONG_USAGE, "--resume: the run began with " + a + ", now it is " + b);
  }
}

std::vector<std::string> tiles_of_finished(const std::string& folder)
{
  std::vector<std::string> tiles;
  const nlohmann::json json = read_index((fs::path(folder) / index_name).string());
  if (json.contains("tiles"))
    for (const nlohmann::json& tile : json["tiles"])
      tiles.push_back((fs::path(folder) / fs::path(tile.value("file", "")).filename()).string());
  return tiles;
}

void remove_run(const std::string& folder)
{
  std::error_code error;
  fs::remove_all(fs::path(folder) / work_folder, error);
  for (const std::string& tile : tiles_of_finished(folder))
    fs::remove(tile, error);
  fs::remove(fs::path(folder) / index_name, error);
}

} // namespace l0_tool
