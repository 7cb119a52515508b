// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/tile_folder.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "files/Destination.h"

#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>
#include <vector>

namespace l0_tool {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view begin_of_name = "tile_";

fs::path canonical(const fs::path& path)
{
  std::error_code error;
  return fs::weakly_canonical(fs::absolute(path, error), error);
}

bool is_name_of_run(const std::string& name, const std::string& extension)
{
  if (name == index_name || name == work_folder)
    return true;
  if (name.rfind(begin_of_name, 0) != 0)
    return false;
  const std::string_view rest = std::string_view(name).substr(begin_of_name.size());
  const std::size_t end = rest.rfind(extension);
  const auto number = parse_number<std::size_t>(rest.substr(0, end));
  return number && name == tile_name(*number, extension);
}

} // namespace

std::string tile_name(std::size_t tile, const std::string& extension)
{
  return std::string(begin_of_name) + std::to_string(tile) + extension;
}

bool is_file_of_run(const std::string& directory, const std::string& path,
                    const std::string& extension)
{
  const fs::path place = canonical(path).lexically_relative(canonical(directory));
  if (place.empty())
    return false;
  const bool is_below = std::next(place.begin()) != place.end();
  const std::string first = place.begin()->string();
  return is_below ? first == work_folder : is_name_of_run(first, extension);
}

void check_directory_of_new_run(const std::string& directory, const std::string& extension,
                                bool may_replace)
{
  const fs::path work = fs::path(directory) / work_folder;
  std::error_code error;
  if (fs::exists(work, error) && !fs::is_empty(work, error))
    throw Failure(OUTPUT_NOT_WRITTEN,
                  work.string() + ": has something that is of no run of --as-one");
  if (may_replace)
    return;
  std::vector<std::string> files;
  for (fs::directory_iterator it(directory, error), end; !error && it != end; it.increment(error))
    if (is_name_of_run(it->path().filename().string(), extension))
      files.push_back(it->path().string());
  check_nothing_is_replaced(files);
}

} // namespace l0_tool
