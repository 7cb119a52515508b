// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILES_OF_RUN_H
#define L0_RESAMPLE_TILES_OF_RUN_H

#include "basis/signals.h"
#include "command_line/options.h"
#include "tasks/parameters_of.h"
#include "tasks/resample.h"
#include "tiles/Shard.h"
#include "tiles/Tile_tasks.h"
#include "tiles/processor_of_tiles.h"
#include "tiles/tile_files.h"

#include <CGAL/iterator.h>
#include <CGAL/l0_resample_tiles.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {

/// The tiles of a run as far as earlier tasks have found out about them.
/// \tparam ConcurrencyTag that of what resamples a tile here
template <typename ConcurrencyTag>
class Tiles_of_run
{
  const Tile_tasks& m_tasks;
  Counted_input m_input; // without the counts, which are of the blocks

public:
  using On_progress = Tile_tasks::On_progress;
  using Tiled_resampling = CGAL::L0_resampling::Tiled_resampling<ConcurrencyTag>;

  Tiled_resampling resampling;

  Tiles_of_run(const Tile_tasks& tasks, const On_progress& on_progress)
    : m_tasks(tasks), m_input(read_counts(tasks.file_of("blocks", 0), tasks.key())),
      resampling(tiled_resampling(tasks.options(), m_input, on_progress))
  {}

  const Counted_input& input() const { return m_input; }
  const Input_properties& properties() const { return m_input.properties; }

  Shards shards() const
  {
    std::vector<std::string> paths;
    for (std::size_t k = 0; k < m_tasks.number_of_inputs(); ++k)
      paths.push_back(m_tasks.file_of("shard", k));
    return Shards(paths, m_tasks.key(), resampling.lattice());
  }

  void cut()
  {
    const Facts_of_run facts = read_facts(m_tasks.file_of("scales", 0), m_tasks.key());
    resampling.set_facts(facts.of_cloud);
    make(facts.memory_of_tile);
  }

  /// \param memory of a tile, in bytes
  void make(std::uint64_t memory)
  {
    static_assert(Tile_options::practical_halo == Tiled_resampling::halo_in_radii,
                  "the default of --halo is that of the package");
    resampling.make_tiles(memory, m_tasks.halo(),
                          bytes_of_tile(m_tasks.options(), properties().table().row_size()));
    resampling.choose_how_to_orient(memory, bytes_per_sample_of_sides(m_tasks.options()));
  }

  /// What the points of all tiles are compared with.
  void take_medians()
  {
    resampling.set_medians(read_medians(m_tasks.file_of("medians", 0), m_tasks.key()));
  }

  /// What all tiles have found of their points.
  typename Tiled_resampling::Disks disks() const
  {
    std::vector<typename Tiled_resampling::Disks> disks;
    for (std::size_t tile = 0; tile < resampling.tiles().size(); ++tile)
      disks.push_back(read_disks(m_tasks.file_of("balls", tile), m_tasks.key()));
    return Tiled_resampling::add_up_disks(disks);
  }

  /// What is known of the samples of all tiles.
  void take_sums()
  {
    if (resampling.has_all_facts())
      return;
    take_medians();
    resampling.set_sums(read_sums(m_tasks.file_of("samples", 0), m_tasks.key()));
  }

  /// What a tile has to know of them.
  void take_starts(std::size_t tile)
  {
    if (resampling.has_all_facts())
      resampling.set_points(tile, read_points_in_cloud(m_tasks.file_of("points", 0), m_tasks.key(),
                                                       resampling.ranges_of_tile(tile)));
    else {
      const std::string file = m_tasks.file_of("samples", 0);
      resampling.set_starts(tile, read_starts(file, m_tasks.key(), tile),
                            read_sums(file, m_tasks.key()));
      resampling.set_points_of_tile(tile, read_points_of_tile(m_tasks.file_of("balls", tile),
                                                              m_tasks.key()));
    }
  }

private:
  /// \param input whose counts move
  static Tiled_resampling tiled_resampling(const Options& options, Counted_input& input,
                                           const On_progress& on_progress)
  {
    const std::size_t number_of_samples =
      number_of_output_points(options, std::size_t(input.counts.number_of_points()));
    return Tiled_resampling(
      std::move(input.counts),
      parameters_of(options, number_of_samples, input.viewpoint)
        .crease_output_iterator(
          options.creases.empty() ? std::nullopt : std::make_optional(CGAL::Emptyset_iterator()))
        .callback(std::function<bool(double)>([on_progress](double share) {
          on_progress(share);
          return !is_interrupted();
        })));
  }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_TILES_OF_RUN_H
