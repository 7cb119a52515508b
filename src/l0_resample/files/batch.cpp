// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/batch.h"

#include "basis/Failure.h"
#include "files/Destination.h"

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

/// Those with a known extension, in the order of their names.
/// \throws Failure with INPUT_REFUSED if there is none
std::vector<std::string> files_of(const std::string& folder)
{
  std::vector<std::string> files;
  bool has_texts = false;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code unknown; // what cannot be looked at is no regular file
    if (!it->is_regular_file(unknown) || !format_of(it->path().string()))
      continue;
    // what stands in texts beside scans are mostly notes
    const bool may_be_notes = lower_extension(it->path()) == ".txt";
    if (may_be_notes)
      has_texts = true;
    else
      files.push_back(it->path().string());
  }
  if (error)
    throw Failure(INPUT_REFUSED, folder + ": cannot be read: " + error.message());
  if (files.empty())
    throw Failure(INPUT_REFUSED, folder + ": the folder has no file with a known extension"
                                   + (has_texts ? ", but for .txt, which are read where they are "
                                                  "named one by one, as most are notes"
                                                : ""));
  std::sort(files.begin(), files.end());
  return files;
}

/// Files, and those of folders, without formats and outputs yet.
std::vector<Batch_item> items_of(const std::vector<std::string>& inputs)
{
  std::vector<Batch_item> items;
  const auto add = [&](const std::string& input, const std::string& refusal) {
    items.emplace_back();
    items.back().input = input;
    items.back().refusal = refusal;
  };
  for (const std::string& input : inputs) {
    std::error_code error;
    if (!fs::is_directory(input, error)) {
      add(input, "");
      continue;
    }
    try {
      for (const std::string& file : files_of(input))
        add(file, "");
    } catch (const Failure& failure) {
      add(input, failure.what());
    }
  }
  return items;
}

void check_nothing_is_overwritten(const std::vector<Batch_item>& items)
{
  std::map<std::string, std::string> inputs,
    outputs; // by canonical name, what the user calls the input
  for (const Batch_item& item : items)
    inputs.emplace(canonical_name(item.input), item.input);
  for (const Batch_item& item : items) {
    if (!item.refusal.empty())
      continue;
    const std::string name = canonical_name(item.output);
    const auto input = inputs.find(name);
    if (input != inputs.end())
      throw Failure(WRONG_USAGE,
                    item.output + ": would take the place of the input " + input->second);
    const auto [other, is_new] = outputs.emplace(name, item.input);
    if (!is_new)
      throw Failure(WRONG_USAGE, item.output + ": both " + other->second + " and " + item.input
                                   + " would go there");
  }
}

} // namespace

std::vector<Batch_item> parts_of_cloud(const std::vector<std::string>& inputs,
                                       std::optional<File_format> input_format)
{
  std::vector<Batch_item> items = items_of(inputs);
  for (Batch_item& item : items) {
    if (!item.refusal.empty())
      throw Failure(INPUT_REFUSED, item.refusal);
    const std::optional<File_format> format = input_format ? input_format : format_of(item.input);
    if (!format)
      throw Failure(INPUT_REFUSED, unknown_extension(item.input, "--input-format"));
    item.input_format = *format;
  }
  return items;
}

std::vector<Batch_item> plan_batch(const std::vector<std::string>& inputs,
                                   const std::string& directory,
                                   std::optional<File_format> input_format,
                                   std::optional<File_format> output_format)
{
  std::vector<Batch_item> items = items_of(inputs);
  for (Batch_item& item : items) {
    if (!item.refusal.empty())
      continue;
    if (item.input == standard_stream)
      throw Failure(WRONG_USAGE, "-: what is read from it would have no name in " + directory);
    const std::optional<File_format> by_extension = format_of(item.input);
    if (!by_extension && (!input_format || !output_format)) {
      const char* option = input_format ? "--output-format" : "--input-format";
      item.refusal = unknown_extension(item.input, option);
      continue;
    }
    item.input_format = input_format ? *input_format : *by_extension;
    item.output_format = output_format               ? *output_format
                         : is_written(*by_extension) ? *by_extension
                                                     : File_format::PLY;
    fs::path name = fs::path(item.input).filename();
    if (is_compressed(name.string()))
      name.replace_extension();
    if (output_format || item.output_format != *by_extension || is_laz(item.input))
      name.replace_extension(extension_of(item.output_format));
    item.output = (fs::path(directory) / name).string();
  }
  check_nothing_is_overwritten(items);
  return items;
}

} // namespace l0_tool
