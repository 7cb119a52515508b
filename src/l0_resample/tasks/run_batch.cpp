// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/run.h"

#include "basis/messages.h"
#include "basis/signals.h"
#include "files/Output_file.h"
#include "tasks/check_output.h"
#include "tasks/resample.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace l0_tool {
namespace {

/// What would make every run fail is found at the beginning.
void prepare(const Command& command)
{
  const Options& options = command.runs.front();
  check_device(options);
  make_folder(options, command.output_directory);
  const auto has_snapshot = [](const Options& run) { return !run.snapshot.empty(); };
  const auto first = std::find_if(command.runs.begin(), command.runs.end(), has_snapshot);
  if (first != command.runs.end()) // all of them go to one folder
    make_folder(options, std::filesystem::path(first->snapshot).parent_path().string());
  if (!options.json.empty())
    check_writable(options.json, 0);
}

/// The errors that are about no file in particular say which one was at work.
std::string error_of(const Options& options, const Run_record& record)
{
  const bool names_file = record.error.find(options.input) != std::string::npos
                          || record.error.find(options.output) != std::string::npos;
  return names_file ? record.error : options.input + ": " + record.error;
}

void print_failures(const std::vector<std::string>& errors, std::size_t number_of_runs,
                    std::size_t number_of_runs_left)
{
  for (const std::string& error : errors)
    print_error(error);
  if (!errors.empty() || number_of_runs_left > 0)
    print_error(
      std::to_string(errors.size()) + " of " + std::to_string(number_of_runs) + " files failed"
      + (number_of_runs_left > 0 ? ", " + std::to_string(number_of_runs_left) + " not begun" : ""));
}

Exit_status common_status(const std::vector<Exit_status>& statuses)
{
  const auto differs = [&](Exit_status status) { return status != statuses.front(); };
  if (statuses.empty())
    return SUCCESS;
  return std::any_of(statuses.begin(), statuses.end(), differs) ? RUN_TIME_FAILURE
                                                                : statuses.front();
}

} // namespace

Exit_status run_batch(const Command& command)
{
  Run_record batch; // what concerns no single file
  guarded(batch, [&]() { prepare(command); });
  if (batch.status != SUCCESS) {
    print_error(batch.error);
    return batch.status;
  }

  const std::string& json = command.runs.front().json;
  std::string reports = "[";
  std::vector<std::string> errors;
  std::vector<Exit_status> statuses;
  std::size_t number_of_runs_left = command.runs.size();
  for (const Options& options : command.runs) {
    if (is_interrupted())
      break;
    Run_record record = run(options);
    print_outcome(options, record);
    if (!json.empty())
      reports += (number_of_runs_left == command.runs.size() ? "\n" : ",\n")
                 + report_as_json(options, record);
    --number_of_runs_left;
    if (record.status != SUCCESS) {
      errors.push_back(error_of(options, record));
      statuses.push_back(record.status);
    }
  }

  if (is_interrupted())
    guarded(batch, []() { throw_if_interrupted(); });
  else if (!json.empty() && !command.runs.front().dry_run)
    guarded(batch, [&]() { write_text(json, reports + "]\n"); });
  print_failures(errors, command.runs.size(), number_of_runs_left);
  print_error(batch.error);
  return batch.status != SUCCESS ? batch.status : common_status(statuses);
}

} // namespace l0_tool
