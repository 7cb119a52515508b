// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Destination.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "system/files_of_system.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace l0_tool {
namespace {

namespace fs = std::filesystem;

constexpr int maximum_number_of_links = 40; // as for the system

/// Whether `folder`, without symbolic links, has the descriptors of this process.
bool has_own_descriptors(const fs::path& folder)
{
  std::error_code error;
  return folder == fs::canonical("/proc/self/fd", error) && !error;
}

/// Of the file behind a path or a descriptor.
std::optional<File_status> status_of(const Destination& destination)
{
  return destination.descriptor ? l0_tool::status_of(*destination.descriptor)
                                : l0_tool::status_of(destination.path);
}

/// The same for all ways to name a file, whether it exists or not.
fs::path canonical_path(const std::string& path, const Destination& destination)
{
  std::error_code error;
  fs::path canonical;
  if (destination.descriptor)
    canonical = fs::canonical("/proc/self/fd/" + std::to_string(*destination.descriptor), error);
  else
    canonical = fs::weakly_canonical(destination.path, error);
  return error ? fs::path(path) : canonical;
}

} // namespace

Destination destination_of(const std::string& path)
{
  if (path == standard_stream)
    return {standard_output, path};
  std::error_code error;
  fs::path place = fs::absolute(path, error);
  if (error)
    throw Failure(OUTPUT_NOT_WRITTEN, path + ": cannot be written: " + error.message());
  for (int links = 0; links <= maximum_number_of_links; ++links) {
    const fs::path folder = fs::canonical(place.parent_path(), error);
    if (error)
      return {std::nullopt, place.string()}; // whoever opens the file learns what is wrong
    const fs::path name = place.filename();
    const std::optional<int> number = parse_number<int>(name.string());
    if (number && has_own_descriptors(folder))
      return {number, path};
    place = folder / name;
    const fs::path target = fs::read_symlink(place, error);
    if (error)
      return {std::nullopt, place.string()}; // no link
    place = folder / target;
  }
  return {std::nullopt, path}; // a circle of links, which nothing can open
}

bool are_same_file(const std::string& path, const std::string& other)
{
  if (path.empty() || other.empty())
    return false;
  const Destination a = destination_of(path), b = destination_of(other);
  if (a.descriptor && b.descriptor)
    return *a.descriptor == *b.descriptor;
  return canonical_path(path, a) == canonical_path(other, b);
}

bool would_replace_file(const std::string& path)
{
  const Destination destination = destination_of(path);
  const std::optional<File_status> status = status_of(destination);
  return !destination.descriptor && status && status->kind == File_kind::REGULAR;
}

void check_nothing_is_replaced(const std::vector<std::string>& paths)
{
  std::vector<std::string> existing;
  std::copy_if(paths.begin(), paths.end(), std::back_inserter(existing), would_replace_file);
  if (existing.empty())
    return;
  const std::size_t others = existing.size() - 1;
  std::string what = "the file exists; --force replaces it";
  if (others > 0)
    what = "the file exists, as do " + std::to_string(others) + " others; --force replaces them";
  throw Failure(OUTPUT_NOT_WRITTEN, existing.front() + ": " + what);
}

bool is_standard_output(const std::string& path)
{
  const std::optional<File_status> file = status_of(destination_of(path)),
                                   output = l0_tool::status_of(standard_output);
  return file && output && file->number == output->number;
}

} // namespace l0_tool
