// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/run_as_one.h"

#include "basis/messages.h"
#include "basis/parse_numbers.h"
#include "basis/signals.h"
#include "system/peak_of_memory.h"
#include "tasks/Progress_bar.h"
#include "tasks/check_output.h"
#include "tasks/run.h"
#include "tiles/Tile_tasks.h"

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <mutex>
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
  Remarks_on_run m_remarks;
  Json m_phases = Json::array();
  double m_done = 0; // share of the whole
  std::size_t m_number_of_tiles = 0;

  /// A task of the running phase.
  struct Task
  {
    double share_done = 0;
    bool is_kept = false;
    std::string reason; ///< why a file that was there did not count
  };

  std::mutex m_mutex; // of the progress bar and what it shows
  std::vector<Task> m_running;

  void run(const Tile_phase& phase, std::size_t k, std::size_t at_once)
  {
    throw_if_interrupted();
    Task& task = m_running[k];
    const auto show_progress = [&](double share) {
      const std::lock_guard<std::mutex> lock(m_mutex);
      task.share_done = share;
      double sum = 0;
      for (const Task& any : m_running)
        sum += any.share_done;
      m_progress.update(phase.name, m_done + phase.share * sum / double(phase.number_of_tasks));
    };
    task.is_kept = m_tasks.is_done(phase.name, k, task.reason);
    if (!task.is_kept)
      m_tasks.run(phase.name, k, show_progress, at_once);
    show_progress(1);
  }

  /// All tasks of a phase; some at the same time, as far as they do not use several threads
  /// themselves.
  void run_tasks(const Tile_phase& phase)
  {
    const std::size_t n = phase.number_of_tasks,
                      threads = tbb::global_control::active_value(
                        tbb::global_control::max_allowed_parallelism),
                      at_once = (std::min)(
                        {m_tasks.maximum_number_at_once(phase.name), n, threads});
    if (at_once <= 1) {
      for (std::size_t k = 0; k < n; ++k)
        run(phase, k, 1);
      return;
    }
    tbb::task_arena arena{int(at_once)};
    arena.execute([&] {
      tbb::parallel_for(
        std::size_t(0), n, [&](std::size_t k) { run(phase, k, at_once); },
        tbb::simple_partitioner());
    });
  }

  void run(const Tile_phase& phase)
  {
    const Clock::time_point start = Clock::now();
    m_running.assign(phase.number_of_tasks, Task());
    run_tasks(phase);
    std::size_t number_kept = 0, number_remade = 0;
    std::uint64_t bytes = 0;
    for (std::size_t k = 0; k < phase.number_of_tasks; ++k) {
      const Task& task = m_running[k];
      number_kept += task.is_kept;
      number_remade += !task.reason.empty();
      if (!task.reason.empty())
        m_notes.push_back(task.reason);
      bytes += size_of_file(m_tasks.file_of(phase.name, k));
      if (phase.name == "shard")
        bytes += size_of_file(m_tasks.file_of("rows", k));
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
      if (phases[next].name == "finish") // which leaves nothing of the run but results
        m_remarks = m_tasks.remarks();
      run(phases[next]);
      if (next + 1 == phases.size() && phases[next].name != "finish")
        phases = m_tasks.phases(); // the tiles are known now
    }
    m_progress.clear();
    const Options& options = m_command.runs.front();
    if (m_remarks.viewpoint && !options.have_side())
      m_notes.push_back(
        line_of_viewpoint(m_command.output_directory, "the files", *m_remarks.viewpoint));
    char numbers[128];
    std::snprintf(numbers, sizeof numbers, "%.2f s, peak of memory %.0f MB", seconds_since(start),
                  double(peak_of_memory()) / (1 << 20));
    return on_one_line(m_command.output_directory) + ": " + std::to_string(m_command.runs.size())
           + " files, " + std::to_string(m_number_of_tiles) + " tiles, " + numbers
           + (are_outwards_assumed(options, m_remarks.viewpoint) ? outwards_are_assumed : "")
           + "\n";
  }

  const std::vector<std::string>& notes() const { return m_notes; }
  const std::vector<std::string>& warnings() const { return m_remarks.warnings; }

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
    record.warnings = run.warnings();
    if (!options.json.empty() && !is_interrupted())
      write_text(options.json, run.report(record));
  });
  if (!options.quiet) {
    if (record.status == SUCCESS)
      std::cout << summary << std::flush;
    print_notes(record.notes);
    print_warnings(record.warnings);
  }
  print_error(record.error);
  return record.status;
}

} // namespace l0_tool
