// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Tile_tasks.h"

#include "basis/Failure.h"
#include "basis/signals.h"
#include "files/tile_folder.h"
#include "tasks/check_output.h"
#include "tasks/resample.h"
#include "tasks/run.h"
#include "tiles/Shard.h"
#include "tiles/Tiles_of_run.h"
#include "tiles/processor_of_tiles.h"
#include "tiles/tile_description.h"
#include "tiles/tile_files.h"

#include <CGAL/l0_resample_tiles.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace l0_tool {
namespace {

namespace fs = std::filesystem;
using CGAL::L0_resampling::Report;
using CGAL::L0_resampling::Tile_result;
using Tiles_on_cpu = Tiles_of_run<CGAL::Parallel_if_available_tag>;

/// What the program takes beside the points: code, tables of the blocks, buffers of files.
constexpr std::uint64_t base_memory = std::uint64_t(96) << 20;

} // namespace

Tile_tasks::Tile_tasks(const Command& command)
  : m_command(command), m_options(command.runs.front()),
    m_work((fs::path(command.output_directory) / work_folder).string()),
    m_description(describe_run(command)), m_key(key_of_run(m_description))
{}

std::string Tile_tasks::file_of(const std::string& phase, std::size_t number) const
{
  if (phase == "write")
    return result_of(number);
  if (phase == "merge")
    return m_command.merged_output;
  if (phase == "finish")
    return index_file();
  return (fs::path(m_work) / (phase + "_" + std::to_string(number))).string();
}

std::string Tile_tasks::result_of(std::size_t tile) const
{
  return (fs::path(m_command.output_directory)
          / tile_name(tile, extension_of(m_options.output_format)))
    .string();
}

std::string Tile_tasks::index_file() const
{
  return (fs::path(m_command.output_directory) / index_name).string();
}

/// Of a folder whose run makes place for another one.
void Tile_tasks::check_inputs_stay() const
{
  std::error_code error;
  std::set<fs::path> inputs;
  for (const Options& part : m_command.runs)
    inputs.insert(fs::weakly_canonical(part.input, error));
  for (const std::string& tile : tiles_of_finished(m_command.output_directory))
    if (inputs.count(fs::weakly_canonical(tile, error)) > 0)
      throw Failure(WRONG_USAGE,
                    tile + ": --force would remove this input, a tile of an earlier run");
}

void Tile_tasks::begin() const
{
  check_device(m_options);
  const std::string note = (fs::path(m_work) / "run").string();
  const std::string begun = read_description(note),
                    old = begun.empty() ? read_finished(index_file()) : begun;
  if (!old.empty()) {
    if (m_command.tiles.resumes)
      check_same_run(old, m_description);
    else if (m_options.force) {
      check_inputs_stay();
      remove_run(m_command.output_directory);
    } else
      throw Failure(OUTPUT_NOT_WRITTEN,
                    m_command.output_directory
                      + (old == m_description ? ": has an earlier run of --as-one: --resume goes "
                                                "on with it, --force begins anew"
                                              : ": has a run of --as-one with other options or "
                                                "inputs: --force begins anew"));
  } else
    check_directory_of_new_run(m_command.output_directory, extension_of(m_options.output_format),
                               m_options.force);
  for (const std::string& path : {m_options.creases, m_options.outliers})
    if (!path.empty())
      check_writable(path, 0);
  make_folder(m_options, m_work);
  write_text(note, m_description);
}

bool Tile_tasks::is_finished() const { return read_finished(index_file()) == m_description; }

std::uint64_t Tile_tasks::memory_for_points() const
{
  if (m_command.tiles.memory <= base_memory)
    throw Failure(NOT_ENOUGH_MEMORY, "--memory: more than " + std::to_string(base_memory >> 20)
                                       + " MB are needed, for any input");
  return m_command.tiles.memory - base_memory;
}

std::vector<Tile_phase> Tile_tasks::phases() const
{
  const std::size_t n = m_command.runs.size();
  std::vector<Tile_phase> phases = {
    {"count", n, 0.05}, {"blocks", 1, 0}, {"shard", n, 0.05}, {"scales", 1, 0.07}};
  std::string reason;
  if (!is_task_file(file_of("scales", 0), m_key, reason))
    return phases;
  Tiles_on_cpu tiles(*this, [](double) {});
  tiles.cut();
  const std::size_t number_of_tiles = tiles.resampling.tiles().size();
  const bool needs_shares = !tiles.resampling.has_all_facts();
  if (needs_shares) {
    phases.push_back({"neighbors", number_of_tiles, 0.07});
    phases.push_back({"medians", 1, 0});
    phases.push_back({"balls", number_of_tiles, 0.1});
    phases.push_back({"share", number_of_tiles, 0.01});
    phases.push_back({"samples", 1, 0});
  }
  const bool carries = !tiles.properties().properties.empty();
  const double share_to_carry = carries ? 0.05 : 0;
  const double share_of_creases = finds_creases() ? 0.05 : 0;
  const double share_of_sides = tiles.resampling.orients_at_once() ? 0.1 : 0.01;
  phases.push_back(
    {"solve", number_of_tiles,
     (needs_shares ? 0.61 : 0.79) - share_to_carry - share_of_sides - share_of_creases});
  if (carries)
    phases.push_back({"carry", number_of_tiles, share_to_carry});
  phases.push_back({"stitch", 1, share_of_sides});
  if (finds_creases())
    phases.push_back({"creases", 1, share_of_creases});
  phases.push_back({"write", number_of_tiles, 0.02});
  if (!m_command.merged_output.empty())
    phases.push_back({"merge", 1, 0.02});
  phases.push_back({"finish", 1, 0});
  return phases;
}

bool Tile_tasks::is_done(const std::string& phase, std::size_t number, std::string& reason) const
{
  // what has the format that was asked for does not say whose it is
  if (phase == "write" || phase == "merge" || phase == "finish")
    return false;
  if (!is_task_file(file_of(phase, number), m_key, reason))
    return false;
  if (phase == "shard")
    return read_counts(file_of("blocks", 0), m_key).properties.properties.empty()
           || is_task_file(file_of("rows", number), m_key, reason);
  if (phase == "creases")
    return fs::exists(m_options.creases);
  return phase != "scales" || !read_facts(file_of("scales", 0), m_key).of_cloud.area
         || is_task_file(file_of("points", 0), m_key, reason);
}

std::size_t Tile_tasks::maximum_number_at_once(const std::string& phase) const
{
  if (phase != "count" && phase != "shard" && phase != "write")
    return 1;
  const std::uint64_t of_task = std::uint64_t(256) << 20; // for its blocks, and a run of points
  return std::size_t((std::max)(memory_for_points() / of_task, std::uint64_t(1)));
}

void Tile_tasks::run(const std::string& phase, std::size_t number, const On_progress& on_progress,
                     std::size_t at_once) const
{
  try {
    if (phase == "count")
      count(number, on_progress, at_once);
    else if (phase == "blocks")
      merge_counts();
    else if (phase == "shard")
      shard(number, on_progress, at_once);
    else if (phase == "scales")
      run_on(m_options, [&](auto tag) { find_scales<decltype(tag)>(on_progress); });
    else if (phase == "neighbors")
      find_neighbors(number, on_progress);
    else if (phase == "medians")
      find_medians();
    else if (phase == "balls")
      find_balls(number, on_progress);
    else if (phase == "share")
      find_share(number);
    else if (phase == "samples")
      share_samples();
    else if (phase == "solve")
      run_on(m_options, [&](auto tag) { solve<decltype(tag)>(number, on_progress); });
    else if (phase == "carry")
      carry(number, on_progress);
    else if (phase == "stitch")
      stitch(on_progress);
    else if (phase == "creases")
      find_creases(on_progress);
    else if (phase == "write")
      write(number);
    else if (phase == "merge")
      merge();
    else
      finish();
  } catch (const std::bad_alloc&) {
    throw Failure(NOT_ENOUGH_MEMORY, phase + " " + std::to_string(number)
                                       + ": not enough memory; with a smaller --memory, --force "
                                         "begins anew with smaller tiles");
  } catch (const std::invalid_argument& error) {
    throw Failure(INPUT_REFUSED, error.what());
  } catch (const std::length_error& error) {
    throw Failure(INPUT_REFUSED, error.what());
  } catch (const Tiled_on_cpu::Cancelled&) {
    throw_if_interrupted();
  }
}

template <typename ConcurrencyTag>
void Tile_tasks::find_scales(const On_progress& on_progress) const
{
  Tiles_of_run<ConcurrencyTag> tiles(*this, on_progress);
  const std::uint64_t of_device = memory_of_device(m_options),
                      memory = (std::min)(memory_for_points(), of_device);
  try {
    tiles.resampling.find_facts(tiles.shards(), memory_for_points(), of_device, halo());
    tiles.make(memory);
  } catch (const std::bad_alloc&) {
    throw Failure(NOT_ENOUGH_MEMORY, "--memory: " + std::to_string(memory)
                                       + " bytes do not hold a part of the cloud and what is "
                                         "around it, within --halo");
  }
  if (tiles.resampling.has_all_facts())
    write_points_in_cloud(file_of("points", 0), m_key, tiles.resampling.points_in_cloud());
  write_facts(file_of("scales", 0), m_key, {tiles.resampling.facts(), memory});
}

void Tile_tasks::find_neighbors(std::size_t tile, const On_progress& on_progress) const
{
  Tiles_on_cpu tiles(*this, on_progress);
  tiles.cut();
  write_neighbors(file_of("neighbors", tile), m_key,
                  tiles.resampling.find_neighbors_of_tile(tile, tiles.shards()));
}

void Tile_tasks::find_medians() const
{
  Tiles_on_cpu tiles(*this, [](double) {});
  tiles.cut();
  Tiled_on_cpu::Neighbor_counts counts;
  for (std::size_t tile = 0; tile < tiles.resampling.tiles().size(); ++tile)
    counts += read_neighbor_counts(file_of("neighbors", tile), m_key);
  write_medians(file_of("medians", 0), m_key, counts.medians());
}

void Tile_tasks::find_balls(std::size_t tile, const On_progress& on_progress) const
{
  Tiles_on_cpu tiles(*this, on_progress);
  tiles.cut();
  tiles.take_medians();
  write_points_of_tile(file_of("balls", tile), m_key,
                       tiles.resampling.find_points_of_tile(
                         tile, tiles.shards(), read_scales(file_of("neighbors", tile), m_key)));
}

void Tile_tasks::find_share(std::size_t tile) const
{
  Tiles_on_cpu tiles(*this, [](double) {});
  tiles.cut();
  tiles.resampling.set_disks(tiles.disks());
  Tiled_on_cpu::Points points = read_points_of_tile(file_of("balls", tile), m_key);
  write_share(file_of("share", tile), m_key, tiles.resampling.share_of_tile(points));
}

void Tile_tasks::share_samples() const
{
  Tiles_on_cpu tiles(*this, [](double) {});
  tiles.cut();
  std::vector<Tiled_on_cpu::Share> shares;
  for (std::size_t tile = 0; tile < tiles.resampling.tiles().size(); ++tile)
    shares.push_back(read_share(file_of("share", tile), m_key));
  const Tiled_on_cpu::Sums sums = Tiled_on_cpu::add_up_shares(shares, tiles.disks());
  write_starts(file_of("samples", 0), m_key, sums, shares);
}

template <typename ConcurrencyTag>
void Tile_tasks::solve(std::size_t tile, const On_progress& on_progress) const
{
  Tiles_of_run<ConcurrencyTag> tiles(*this, on_progress);
  tiles.cut();
  tiles.take_sums();
  tiles.take_starts(tile);
  Tile_result result = tiles.resampling.resample_tile(tile, tiles.shards());
  double seconds = 0;
  for (const auto& stage : result.report.stages)
    seconds += stage.seconds;
  write_found(file_of("solve", tile), m_key, result.samples,
              {std::move(result.near_border),
               std::move(result.beyond_border),
               std::move(result.evidence),
               std::move(result.unoriented),
               std::move(result.outliers),
               {result.findings, seconds}});
}

void Tile_tasks::carry(std::size_t tile, const On_progress& on_progress) const
{
  const Tiles_on_cpu tiles(*this, on_progress);
  const Shards shards = tiles.shards();
  std::vector<std::string> paths_of_rows;
  for (std::size_t k = 0; k < number_of_inputs(); ++k)
    paths_of_rows.push_back(file_of("rows", k));
  Property_interpolator interpolator(shards, paths_of_rows, m_key, tiles.resampling.lattice(),
                                     tiles.resampling.blocks(), tiles.properties().table(),
                                     memory_for_points());
  std::vector<Tile_sample> samples;
  Task_file(file_of("solve", tile), m_key).read_all(samples);
  Task_file_writer file(file_of("carry", tile), m_key);
  file.write_all(interpolator.carry(samples, on_progress));
  file.commit();
}

template <typename ConcurrencyTag>
std::vector<std::vector<signed char>> Tile_tasks::find_sides(const On_progress& on_progress) const
{
  Tiles_of_run<ConcurrencyTag> tiles(*this, on_progress);
  tiles.cut();
  tiles.take_sums();
  std::vector<Unoriented_samples> unoriented(tiles.resampling.tiles().size());
  tbb::parallel_for(std::size_t(0), unoriented.size(), [&](std::size_t tile) {
    unoriented[tile] = read_unoriented(file_of("solve", tile), m_key);
  });
  Report unwanted_report;
  return tiles.resampling.sides(std::move(unoriented), unwanted_report);
}

void Tile_tasks::stitch(const On_progress& on_progress) const
{
  Tiles_on_cpu tiles(*this, on_progress);
  tiles.cut();
  tiles.take_sums();
  const Tiled_on_cpu& resampling = tiles.resampling;
  const std::size_t number_of_tiles = resampling.tiles().size();
  Signs_of_tiles all;
  std::vector<std::vector<double>> evidence;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile) {
    Found_in_tile found = read_found(file_of("solve", tile), m_key, false);
    evidence.push_back(std::move(found.evidence));
    all.summaries.push_back(found.summary);
  }
  CGAL::L0_resampling::Stitching stitching = resampling.stitching(evidence);
  for (std::size_t a = 0; a < number_of_tiles; ++a) {
    throw_if_interrupted();
    if (!resampling.orients_at_once())
      on_progress(double(a) / double(number_of_tiles));
    const Found_in_tile owner = read_found(file_of("solve", a), m_key, true);
    for (std::size_t b = 0; b < number_of_tiles; ++b)
      if (resampling.are_neighbors(a, b))
        stitching.add_overlap(a, owner.near_border, b,
                              resampling.samples_of_owner(
                                read_found(file_of("solve", b), m_key, true).beyond_border, a));
  }
  all.signs = stitching.signs();
  if (resampling.are_sides_given())
    for (std::vector<signed char>& of_tile : all.signs)
      of_tile.assign(of_tile.size(), 1);
  all.seams = stitching.report(all.signs);
  if (resampling.orients_at_once()) {
    run_on(m_options, [&](auto tag) { all.signs = find_sides<decltype(tag)>(on_progress); });
    all.seams.number_of_opposed = 0; // as one decision holds for all
  }
  write_signs(file_of("stitch", 0), m_key, all);
}

} // namespace l0_tool
