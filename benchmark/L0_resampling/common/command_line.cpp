// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"

namespace L0_benchmark {

CLI::App& command_line(const std::string& description)
{
  static CLI::App app(description);
  return app;
}

std::optional<int> read_command_line(CLI::App& app, int argc, char** argv)
{
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  return std::nullopt;
}

} // namespace L0_benchmark
