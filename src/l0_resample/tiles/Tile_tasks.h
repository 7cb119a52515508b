// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILE_TASKS_H
#define L0_RESAMPLE_TILE_TASKS_H

#include "basis/Point_cloud.h"
#include "command_line/options.h"
#include "tiles/Input_properties.h"
#include "tiles/Tile_rows.h"

#include <CGAL/L0_resampling/Report.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// A step of `--as-one`, whose tasks do not need each other.
struct Tile_phase
{
  std::string name;
  std::size_t number_of_tasks;
  double share; ///< of the time of all, roughly
};

/// What is said of a run, beside its results.
struct Remarks_on_run
{
  /// What is not as one may expect of the inputs, of what goes along with their points, and of the
  /// result.
  std::vector<std::string> warnings;
  std::optional<std::array<double, 3>> viewpoint; ///< of normals, by the options or all files
};

/*!
The tasks of `--as-one`. Each reads files that tasks of earlier phases have written, and writes one:
what is there needs not be done again. Any program that keeps the phases in their order may run
them, on any machine that sees the folder.
*/
class Tile_tasks
{
public:
  using On_progress = std::function<void(double)>;

  /// \param command with `--as-one`
  explicit Tile_tasks(const Command& command);

  /// Makes the folder, and notes what the run is; or, with `--resume`, sees whether it is the same.
  /// \throws Failure with INPUT_REFUSED if an input is another one now, with WRONG_USAGE if options
  /// are others, with OUTPUT_NOT_WRITTEN if there is a run and nothing says what to do with it
  void begin() const;

  /// Whether all was done already.
  bool is_finished() const;

  /// The phases in their order, up to the first whose number of tasks is not known yet.
  std::vector<Tile_phase> phases() const;

  /// Whether the task needs not be done, as its file is there.
  /// \param reason out: why a file that is there does not count
  bool is_done(const std::string& phase, std::size_t number, std::string& reason) const;

  /// How many tasks of a phase may run at the same time in one process: those that read or write
  /// files one number at a time, on one thread each, as far as there is memory.
  std::size_t maximum_number_at_once(const std::string& phase) const;

  /// \param phase one of `phases()`
  /// \param number below that of its tasks
  /// \param at_once tasks that share the memory
  void run(const std::string& phase, std::size_t number, const On_progress& on_progress,
           std::size_t at_once = 1) const;

  std::string file_of(const std::string& phase, std::size_t number) const;

  /// Before the phase `finish`.
  Remarks_on_run remarks() const;

  const Options& options() const { return m_options; }
  std::size_t number_of_inputs() const { return m_command.runs.size(); }
  double halo() const { return m_command.tiles.halo; }
  /// What files of this run are known by.
  std::uint64_t key() const { return m_key; }

private:
  const Command& m_command;
  const Options& m_options;
  std::string m_work;        // the folder of what is in between
  std::string m_description; // of the run, one line for each thing
  std::uint64_t m_key;

  std::string result_of(std::size_t tile) const;
  std::string index_file() const;
  void check_inputs_stay() const;
  bool finds_creases() const { return !m_options.creases.empty(); }
  Property_table properties_of_samples(const Input_properties& properties) const;
  void check_disk(std::uint64_t number_of_points, const Input_properties& properties) const;
  void warn_of_left_out(Input_properties& properties) const;
  std::vector<std::string> warnings_of(const Input_properties& properties,
                                       const CGAL::L0_resampling::Report& report) const;
  std::uint64_t memory_for_points() const;
  using On_point =
    std::function<void(const std::array<double, 3>&, const Property_table&, const char* row)>;
  Point_cloud read_input(std::size_t number, const On_point& f, std::uint64_t memory,
                         const On_progress& on_progress) const;

  void count(std::size_t number, const On_progress& on_progress, std::size_t at_once) const;
  void merge_counts() const;
  void shard(std::size_t number, const On_progress& on_progress, std::size_t at_once) const;
  template <typename ConcurrencyTag>
  void find_scales(const On_progress& on_progress) const;
  void find_neighbors(std::size_t tile, const On_progress& on_progress) const;
  void find_medians() const;
  void find_balls(std::size_t tile, const On_progress& on_progress) const;
  void find_share(std::size_t tile) const;
  void share_samples() const;
  template <typename ConcurrencyTag>
  void solve(std::size_t tile, const On_progress& on_progress) const;
  void carry(std::size_t tile, const On_progress& on_progress) const;
  template <typename ConcurrencyTag>
  std::vector<std::vector<signed char>> find_sides(const On_progress& on_progress) const;
  void stitch(const On_progress& on_progress) const;
  void find_creases(const On_progress& on_progress) const;
  std::vector<Moved_sample> moved_samples(std::size_t tile) const;
  void write(std::size_t tile) const;
  void merge() const;
  void write_outliers(std::size_t number_of_tiles) const;
  void finish() const;
};

} // namespace l0_tool

#endif // L0_RESAMPLE_TILE_TASKS_H
