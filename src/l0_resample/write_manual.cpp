// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the man page and the completions of bash into a folder, for the build: write_manual FOLDER

#include "command_line.h"
#include "manual.h"

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
  const bool is_written = write(folder + "/l0_resample.1", l0_tool::man_page(app))
                          && write(folder + "/l0_resample", l0_tool::bash_completion(app));
  return is_written ? 0 : 1;
}
