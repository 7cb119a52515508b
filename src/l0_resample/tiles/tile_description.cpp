// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/tile_description.h"

#include "basis/Failure.h"
#include "command_line/Setting.h"
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
#include <charconv>
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
using Json = nlohmann::ordered_json;

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

std::string line_of_input(const Input_options& options)
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

std::string text_of(const Json& value)
{
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_boolean())
    return value.get<bool>() ? "1" : "0";
  if (value.is_array()) {
    std::string list;
    for (const Json& item : value)
      list += (list.empty() ? "" : ",") + text_of(item);
    return list;
  }
  if (!value.is_number_float())
    return value.dump();
  char digits[32]; // as many as tell the number from all others, and 50 instead of 50.0
  return {digits, std::to_chars(digits, digits + sizeof digits, value.get<double>()).ptr};
}

/// As on the command line: "--noise 0.1", or "no --noise"; of a flag whether it is given.
std::string line_of_setting(const Setting& setting)
{
  const Json& value = setting.value;
  const std::string option = "--" + setting.name;
  const bool is_there = !value.is_null() && value != "" && value != Json::array();
  return is_there ? option + " " + text_of(value) : "no " + option;
}

/// What the index of a run says; an empty object if there is none.
Json read_index(const std::string& path)
{
  std::ifstream stream(path);
  const Json json = Json::parse(stream, nullptr, false);
  return json.is_object() ? json : Json::object();
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
  text << "program " L0_RESAMPLE_VERSION "\n"
       << "sources " << hash_of_sources << "\n"
       << "compiler " << compiler() << "\n"
       << "instructions " << CGAL::L0_resampling::instructions_of_stages() << "\n";
  for (const Setting& setting : *options.settings)
    if (setting.told == Told::TO_ALL || setting.told == Told::TO_KEY)
      text << line_of_setting(setting) << "\n";
  text << "--device " << (are_tiles_on_device(options) ? "cuda" : "cpu") << "\n"
       << "--output-format " << extension_of(options.output_format) << "\n"
       << "properties " << carries_properties(command) << "\n";
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
  const Json json = read_index(index);
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
  const Json json = read_index((fs::path(folder) / index_name).string());
  if (json.contains("tiles"))
    for (const Json& tile : json["tiles"])
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
