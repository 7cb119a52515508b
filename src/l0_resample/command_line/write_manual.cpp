// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes into a folder, for the build, what is made of the table of options: the man page, the
// completions of bash, and tables for the manual:  write_manual FOLDER

#include "command_line/command_line.h"
#include "command_line/manual.h"

#include <CLI/CLI.hpp>

#include <fstream>
#include <iostream>
#include <string>

namespace {

bool write(const std::string& path, const std::string& text)
{
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file)
    std::cerr << path << ": cannot be written\n";
  return bool(file);
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2) {
    std::cerr << "usage: write_manual FOLDER\n";
    return 2;
  }
  const std::string folder = argv[1];
  CLI::App app;
  l0_tool::Arguments arguments;
  l0_tool::add_options(app, arguments);
  bool is_written = write(folder + "/l0_resample.1", l0_tool::man_page(app))
                    && write(folder + "/l0_resample", l0_tool::bash_completion(app));
  for (const auto& [name, table] : l0_tool::option_tables(app))
    is_written = is_written && write(folder + "/table_of_" + name + "_options.txt", table);
  return is_written ? 0 : 1;
}
