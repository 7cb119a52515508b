// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/check_output.h"

#include "basis/Failure.h"
#include "files/Output_file.h"
#include "system/files_of_system.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace l0_tool {
namespace {

namespace fs = std::filesystem;

std::error_code can_be_made(const std::string& folder)
{
  std::error_code error;
  fs::path place = fs::absolute(folder, error).lexically_normal();
  while (!fs::exists(place, error) && place.has_relative_path())
    place = place.parent_path();
  if (!fs::is_directory(place, error))
    return std::make_error_code(std::errc::not_a_directory);
  if (!may_write_into(place.string()))
    return {errno, std::generic_category()};
  return {};
}

} // namespace

bool is_folder_missing(const Options& options, const std::string& path)
{
  std::error_code error;
  return options.dry_run && options.is_in_batch
         && !fs::exists(fs::absolute(path, error).parent_path(), error);
}

void check_output(const Options& options, std::uint64_t size)
{
  if (!is_folder_missing(options, options.output))
    check_writable(options.output, size);
}

void make_folder(const Task_options& options, const std::string& folder)
{
  std::error_code error;
  if (options.dry_run)
    error = can_be_made(folder);
  else
    fs::create_directories(folder, error);
  if (error)
    throw Failure(OUTPUT_NOT_WRITTEN, folder + ": cannot be made: " + error.message());
}

} // namespace l0_tool
