// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_OPTION_VALUES_H
#define L0_RESAMPLE_OPTION_VALUES_H

#include <CLI/CLI.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace l0_tool {

/// Numbers are read as those in files are, so that a decimal comma or a "nan" is refused.
CLI::Validator number_within(double low, bool low_allowed, double high,
                             const std::string& description);

constexpr std::uint64_t any_count = (std::numeric_limits<std::uint64_t>::max)();

CLI::Validator count_within(std::uint64_t low, std::uint64_t high);

// These refuse as `refuse_usage()` does.

std::array<double, 3> parse_place(const std::string& option, const std::string& text);

std::array<double, 3> parse_direction(const std::string& option, const std::string& text);

/// Whole numbers separated by commas.
std::vector<unsigned> parse_classes(const std::string& option, const std::string& text);

/// A command of the shell with a place for the file.
std::string parse_decompression(const std::string& option, const std::string& command);

} // namespace l0_tool

#endif // L0_RESAMPLE_OPTION_VALUES_H
