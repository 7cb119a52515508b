// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_COMMAND_LINE_H
#define L0_RESAMPLE_COMMAND_LINE_H

#include "command_line/Setting.h"
#include "command_line/options.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {

class App;

} // namespace CLI

namespace l0_tool {

/// What the command line says, not yet put together.
struct Arguments
{
  std::vector<std::string> files;
  std::string output;
  std::string output_directory;
  std::string config;
  std::optional<File_format> input_format, output_format; ///< by extension, if not given
  Options options;
  Tile_options tiles;
  std::vector<std::function<Setting()>> settings; ///< what is here once all is parsed
};

/// The table of all options: what parses the command line, and what --help, the man page and the
/// completions of the shell are made of.
/// \param arguments what parsing fills
void add_options(CLI::App& app, Arguments& arguments);

/// What may be the value of an option, if that is a choice; else nothing.
/// \param option its long name without dashes
std::vector<std::string> choices_of(const std::string& option);

/// As the parser refuses.
[[noreturn]] void refuse_usage(const std::string& message);

} // namespace l0_tool

#endif // L0_RESAMPLE_COMMAND_LINE_H
