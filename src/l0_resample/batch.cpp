// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "batch.h"

#include "Failure.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

namespace l0_tool {
namespace {

namespace fs = std::filesystem;

/// The same for every way to name a file, whether it exists or not.
std::string canonical_name(const fs::path& path)
{
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(fs::absolute(path, error), error);
  return (error ? path.lexically_normal() : canonical).string();
}

std::vector<std::string> files_of(const std::string& folder)
{
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code unknown; // what cannot be looked at is no regular file
    if (it->is_regular_file(unknown) && format_of(it->path().string()))
      files.push_back(it->path().string());
  }
  if (error)
    throw Failure(INPUT_REFUSED, folder + ": cannot be read: " + error.message());
  if (files.empty())
    throw Failure(INPUT_REFUSED, folder + ": the folder has no file with a known extension");
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> without_folders(const std::vector<std::string>& inputs)
{
  std::vector<std::string> files;
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!fs::is_directory(input, error)) {
      files.push_back(input);
      continue;
    }
    const std::vector<std::string> inside = files_of(input);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

void check_nothing_is_overwritten(const std::vector<Batch_item>& items)
{
  std::map<std::string, std::string> inputs, outputs; // by canonical name, what the user calls the input
  for (const Batch_item& item : items)
    inputs.emplace(canonical_name(item.input), item.input);
  for (const Batch_item& item : items) {
    const std::string name = canonical_name(item.output);
    const auto input = inputs.find(name);
    if (input != inputs.end())
      throw Failure(WRONG_USAGE, item.output + ": would take the place of the input " + input->second);
    const auto [other, is_new] = outputs.emplace(name, item.input);
    if (!is_new)
      throw Failure(WRONG_USAGE, item.output + ": both " + other->second + " and " + item.input + " would go there");
  }
}

} // namespace

std::vector<Batch_item> plan_batch(const std::vector<std::string>& inputs, const std::string& directory,
                                   std::optional<File_format> input_format, std::optional<File_format> output_format)
{
  std::vector<Batch_item> items;
  for (const std::string& input : without_folders(inputs)) {
    const std::optional<File_format> by_extension = format_of(input);
    if (!by_extension && (!input_format || !output_format))
      throw Failure(WRONG_USAGE, unknown_extension(input, input_format ? "--output-format" : "--input-format"));
    fs::path name = fs::path(input).filename();
    if (output_format)
      name.replace_extension(extension_of(*output_format));
    items.push_back({input, (fs::path(directory) / name).string(), input_format ? *input_format : *by_extension,
                     output_format ? *output_format : *by_extension});
  }
  check_nothing_is_overwritten(items);
  return items;
}

} // namespace l0_tool
