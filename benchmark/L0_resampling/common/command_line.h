// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_COMMAND_LINE_H
#define CGAL_L0_RESAMPLING_BENCHMARK_COMMAND_LINE_H

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace L0_benchmark {

/// The command line of this program, to which it adds its options. That of the first call, as a
/// program has one. What makes and reads it is compiled once for all programs.
CLI::App& command_line(const std::string& description);

/// \returns the status to exit with, if the program is not to go on: after `--help`, or a command
/// line that is wrong, of which it has been told
std::optional<int> read_command_line(CLI::App& app, int argc, char** argv);

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_COMMAND_LINE_H
