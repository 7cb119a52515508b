// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/run_as_one.h"

#include "basis/messages.h"
#include "basis/parse_numbers.h"
#include "basis/signals.h"
#include "tasks/Progress_bar.h"
#include "tasks/check_output.h"
#include "tasks/run.h"
#include "tiles/Tile_tasks.h"

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Of this program so far, in bytes; 0 if the system does not tell. `getrusage()` would count what
/// the process was before it became this program.
std::uint64_t peak_of_memory()
{
  const std::string field = "VmHWM:";
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, field.size(), field) == 0)
      return std::stoull(line.substr(field.size())) * 1024;
  return 0;
}

std::uint64_t size_of_file(const std::string& path)
{
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : std::uint64_t(size);
}

/// All phases, one task after the other.
class Run_of_tiles
{
  const Command& m_command;
  const Tile_tasks m_tasks;
  Progress_bar m_progress;
  std::vector<std::string> m_notes;
  Json m_phases = Json::array();
  double m_done = 0; // share of the whole
  std::size_t m_number_of_tiles = 0;

  void run(const Tile_phase& phase)
  {
    const Clock::time_point start = Clock::now();
    std::size_t number_kept = 0, number_remade = 0;
    std::uint64_t bytes = 0;
    for (std::size_t k = 0; k < phase.number_of_tasks; ++k) {
      throw_if_interrupted();
      std::string reason;
      if (m_tasks.is_done(phase.name, k, reason))
        ++number_kept;
      else {
        if (!reason.empty()) {
          ++number_remade;
          m_notes.push_back(reason);
        }
        m_tasks.run(phase.name, k, [&](double share) {
          m_progress.update(
            phase.name, m_done + phase.share * (double(k) + share) / double(phase.number_of_tasks));
        });
      }
      bytes += size_of_file(m_tasks.file_of(phase.name, k));
    }
    m_done += phase.share;
    m_phases.push_back({{"name", phase.name},
                        {"tasks", phase.number_of_tasks},
                        {"kept", number_kept},
                        {"remade", number_remade},
                        {"bytes", bytes},
                        {"seconds", seconds_since(start)}});
    if (phase.name == "solve")
      m_number_of_tiles = phase.number_of_tasks;
  }

public:
  explicit Run_of_tiles(const Command& command)
    : m_command(command), m_tasks(command), m_progress(command.runs.front().quiet)
  {}

  /// \returns the line that says what was done
  std::string operator()()
  {
    const Clock::time_point start = Clock::now();
    if (m_command.tiles.resumes && m_tasks.is_finished())
      return on_one_line(m_command.output_directory) + ": all was done already\n";
    m_tasks.begin();
    std::vector<Tile_phase> phases = m_tasks.phases();
    for (std::size_t next = 0; next < phases.size(); ++next) {
      run(phases[next]);
      if (next + 1 == phases.size() && phases[next].name != "finish")
        phases = m_tasks.phases(); // the tiles are known now
    }
    m_progress.clear();
    char numbers[128];
    std::snprintf(numbers, sizeof numbers, "%.2f s, peak of memory %.0f MB", seconds_since(start),
                  double(peak_of_memory()) / (1 << 20));
    return on_one_line(m_command.output_directory) + ": " + std::to_string(m_command.runs.size())
           + " files, " + std::to_string(m_number_of_tiles) + " tiles, " + numbers + "\n";
  }

  const std::vector<std::string>& notes() const { return m_notes; }

  std::string report(const Run_record& record) const
  {
    Json json = {{"program", "l0_resample"},
                 {"version", L0_RESAMPLE_VERSION},
                 {"exit_status", int(record.status)}};
    if (!record.error.empty())
      json["error"] = record.error;
    json["output_directory"] = m_command.output_directory;
    json["tiles"] = m_number_of_tiles;
    json["peak_bytes"] = peak_of_memory();
    json["phases"] = m_phases;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }
};

/// \param task such as solve:3
void run_task(const Command& command)
{
  const Tile_tasks tasks(command);
  if (command.tiles.task == "begin")
    return tasks.begin();
  if (command.tiles.task == "list") {
    for (const Tile_phase& phase : tasks.phases())
      std::cout << phase.name << " " << phase.number_of_tasks << "\n";
    return;
  }
  const std::size_t colon = command.tiles.task.find(':');
  const std::string name = command.tiles.task.substr(0, colon);
  const std::optional<std::size_t> number =
    colon == std::string::npos ? std::optional<std::size_t>(0)
                               : parse_number<std::size_t>(command.tiles.task.substr(colon + 1));
  for (const Tile_phase& phase : tasks.phases())
    if (phase.name == name && number && *number < phase.number_of_tasks) {
      std::string reason;
      if (!tasks.is_done(name, *number, reason))
        tasks.run(name, *number, [](double) {});
      return;
    }
  throw Failure(WRONG_USAGE,
                "--task: " + printable(command.tiles.task) + " is no task of this run");
}

} // namespace

Exit_status run_as_one(const Command& command)
{
  const Options& options = command.runs.front();
  std::optional<tbb::global_control> limit;
  if (options.threads)
    limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(*options.threads));
  Run_record record;
  if (!command.tiles.task.empty()) {
    guarded(record, [&]() { run_task(command); });
    print_error(record.error);
    return record.status;
  }
  std::string summary;
  guarded(record, [&]() {
    if (!options.json.empty())
      check_writable(options.json, 0);
    Run_of_tiles run(command);
    guarded(record, [&]() { summary = run(); });
    record.notes = run.notes();
    if (!options.json.empty() && !is_interrupted())
      write_text(options.json, run.report(record));
  });
  if (!options.quiet) {
    if (record.status == SUCCESS)
      std::cout << summary << std::flush;
    print_notes(record.notes);
  }
  print_error(record.error);
  return record.status;
}

} // namespace l0_tool
