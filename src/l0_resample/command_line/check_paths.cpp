// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/check_paths.h"

#include "command_line/command_line.h"
#include "files/tile_folder.h"

#include <string>

namespace l0_tool {
namespace {

void check_differ(const std::string& path, const std::string& other)
{
  if (are_same_file(path, other))
    refuse_usage(path + ": is named twice");
}

std::string input_of(const Options& options)
{
  return options.input == standard_stream ? "/dev/stdin" : options.input;
}

void check_run(const Options& options, const std::string& config)
{
  const std::string input = input_of(options);
  const std::string written[] = {options.json,    options.page,     options.snapshot,
                                 options.creases, options.outliers, options.output};
  for (const std::string& path : written) {
    if (path != options.output)
      check_differ(path, input);
    for (const std::string& other : written)
      if (&other < &path)
        check_differ(path, other);
  }
  for (const std::string& path : written)
    for (const std::string& read : {config, options.viewpoints})
      check_differ(path, read);
}

// Tiles get their names, and those of an earlier run are removed, while inputs are still read.
void check_tiles(const Command& command, const std::string& config)
{
  const Options& options = command.runs.front();
  check_differ(options.json, command.merged_output);
  for (const std::string& path : {options.creases, options.outliers})
    check_differ(path, command.merged_output);
  check_differ(command.merged_output, config);
  const auto is_of_run = [&](const std::string& path) {
    return !path.empty()
           && is_file_of_run(command.output_directory, path, extension_of(options.output_format));
  };
  for (const std::string& path :
       {options.json, options.creases, options.outliers, command.merged_output})
    if (is_of_run(path))
      refuse_usage(path + ": is the name of a tile, or of what belongs to the tiles");
  for (const Options& part : command.runs)
    if (is_of_run(part.input) || are_same_file(command.merged_output, part.input))
      refuse_usage(part.input + ": a result would take the place of this input");
}

} // namespace

void check_paths(const Command& command, const std::string& config)
{
  for (const Options& options : command.runs)
    check_run(options, config);
  if (command.tiles.is_as_one)
    check_tiles(command, config);
}

} // namespace l0_tool
