// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TILED_CLOUD_H
#define CGAL_L0_RESAMPLING_TILED_CLOUD_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/Tile_counts.h>
#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>
#include <CGAL/L0_resampling/internal/tiles/Blocks_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Creases_of_tiles.h>
#include <CGAL/L0_resampling/internal/tiles/Neighbors_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Own_blocks.h>
#include <CGAL/L0_resampling/internal/tiles/Points_of_tile.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

template <typename ConcurrencyTag, template <typename, typename> class Solver_traits>
class Steps_of_tiles;

} // namespace internal

/*!
\ingroup PkgL0ResamplingRef

A cloud that does not fit into memory, and its tiles: what is known of all of it, and what follows
from that. `Tiled_resampling`, which is one, finds it out.
*/
class Tiled_cloud
{
  template <typename ConcurrencyTag, template <typename, typename> class Solver_traits>
  friend class internal::Steps_of_tiles;

  static constexpr std::uint64_t bytes_per_point_to_find = 200;

  internal::Parameters m_parameters;
  internal::Counted_cloud m_cloud;
  internal::Facts_of_cloud m_facts;
  bool m_has_all_facts = false;
  internal::Disks_of_tile m_disks; // of the cloud, if not all facts were found
  double m_radius = 0;             // in the unit of the input
  double m_sample_spacing = 0;     // in units of the radius
  double m_halo_in_radii = 0;
  std::vector<Tile> m_tiles;

  void set_spacing() { m_sample_spacing = std::sqrt(*m_facts.area / double(number_of_samples())); }

  /// Around the blocks of a tile, and the points beyond them of runs of cells that are its own.
  std::int64_t halo_in_blocks() const
  {
    double radii = m_halo_in_radii;
    if (!m_has_all_facts)
      radii += internal::Search_grid_3::longest_run * plan().cell_size;
    return m_cloud.halo_in_blocks(radii * m_radius);
  }

public:
  /// \name What steps give to each other
  /// They can be copied, stored by `write_tile_value()`, and read back by `read_tile_value()`.
  /// @{
  using Facts = internal::Facts_of_cloud;        ///< of the cloud
  using Point_facts = internal::Point_in_cloud;  ///< of a point, plain
  using Neighbors = internal::Neighbors_of_tile; ///< of the points of a tile: `counts`, `scales`
  using Neighbor_counts = internal::Neighbor_counts; ///< which `+=` adds up
  using Medians = internal::Medians_of_cloud;        ///< `medians()` of all counts
  using Points = internal::Points_of_tile;           ///< those of a tile, with their `disks`
  using Disks = internal::Disks_of_tile;             ///< of a tile or a cloud, plain
  using Share = internal::Share_of_tile;             ///< what a tile adds to all, with its `runs`
  using Run = internal::Run_of_cells;                ///< some of the points of a tile, plain
  using Sums = internal::Cloud_totals; ///< over all tiles, with the `disks` of the cloud, plain
  using Creases = internal::Creases_of_tiles; ///< of the cloud, and the samples that they move
  /// @}

  const std::vector<std::pair<Block, std::uint64_t>>& blocks() const { return m_cloud.blocks(); }
  const Block_lattice& lattice() const { return m_cloud.lattice(); }
  std::uint64_t number_of_points() const { return m_cloud.number_of_points(); }
  std::uint64_t number_of_samples() const { return m_parameters.number_of_output_points; }
  double neighbor_radius() const { return m_radius; }
  double sample_spacing() const { return m_sample_spacing * m_radius; }
  bool finds_creases() const { return m_parameters.with_creases; }
  const Facts& facts() const { return m_facts; }
  /// Whether these are the facts that a call for the whole cloud in memory finds. Then it is also
  /// known where samples start: tiles need neither shares nor sums.
  bool has_all_facts() const { return m_has_all_facts; }
  const std::vector<Tile>& tiles() const { return m_tiles; }
  Source_box box_of_tile(std::size_t tile) const { return m_cloud.source_box(m_tiles[tile].box); }

  /// Where the points that a tile reads stand in `Tiled_resampling::points_in_cloud()`, in their
  /// order: the first of each block, and how many these are.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges_of_tile(std::size_t tile) const
  {
    return blocks_of_tile(tile).ranges();
  }

  /// Instead of `Tiled_resampling::find_facts()`, which has found them another time.
  void set_facts(const Facts& facts)
  {
    m_facts = facts;
    m_radius = std::ldexp(plan().unit, -m_facts.extents->exponent_of_input);
    m_has_all_facts = m_facts.area.has_value();
    if (m_has_all_facts)
      set_spacing();
  }

  /// \param medians of the sum of what `Tiled_resampling::find_neighbors_of_tile()` has counted for
  /// each tile
  void set_medians(const Medians& medians)
  {
    m_facts.range_of_scales = medians.scales;
    m_facts.median_number_of_neighbors = medians.number_of_neighbors;
  }

  /// What `set_disks()` takes.
  static Disks add_up_disks(const std::vector<Disks>& of_tiles)
  {
    return internal::add_up_disks(of_tiles);
  }

  /// \param disks sum over what `Tiled_resampling::find_points_of_tile()` has given for each tile
  void set_disks(const Disks& disks)
  {
    m_disks = disks;
    m_facts.units_of_disks = m_disks.units;
    m_facts.has_plain_blocks = m_disks.number_of_thinned_blocks == 0
                               && (!m_facts.field || m_facts.field->is_even());
  }

  /// What a tile adds to the sums over all tiles, once `set_disks()` was called.
  /// \param points what `Tiled_resampling::find_points_of_tile()` has given; areas are noted there
  Share share_of_tile(Points& points) const
  {
    return points.share(m_disks, plan().area_radius(), number_of_samples());
  }

  /// Adds up the shares of all tiles.
  /// \param shares what `share_of_tile()` has given for each tile; out: with the runs that
  /// `Tiled_resampling::set_starts()` takes
  /// \param disks what `add_up_disks()` has given
  static Sums add_up_shares(std::vector<Share>& shares, const Disks& disks)
  {
    Sums sums = internal::add_up_shares(shares);
    sums.disks = disks;
    return sums;
  }

  /// Instead of `set_disks()` and `Tiled_resampling::set_shares()`: what these have found another
  /// time.
  void set_sums(const Sums& sums)
  {
    set_disks(sums.disks);
    m_facts.area = sums.area;
    m_facts.number_of_points = std::size_t(sums.sums.points);
    m_facts.number_of_places = std::size_t(sums.sums.distinct);
    m_facts.mean_number_of_neighbors = double(sums.sums.neighbors) / double(sums.sums.points);
    set_spacing();
  }

  /// Whether samples of both may lie where the tiles overlap.
  bool are_neighbors(std::size_t a, std::size_t b) const
  {
    const Source_box one = box_of_tile(a), other = box_of_tile(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (one.low[axis] > other.high[axis] + overlap_width()
          || other.low[axis] > one.high[axis] + overlap_width())
        return false;
    return a != b;
  }

  /// Those of the samples beyond the border of a tile that lie where `owner` keeps samples.
  std::vector<Tile_sample> samples_of_owner(const std::vector<Tile_sample>& beyond_border,
                                            std::size_t owner) const
  {
    const Source_box box = box_of_tile(owner);
    std::vector<Tile_sample> samples;
    for (const Tile_sample& sample : beyond_border)
    {
      bool is_inside = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
        is_inside = is_inside && sample.position[axis] >= box.low[axis]
                    && sample.position[axis] < box.high[axis];
      if (is_inside)
        samples.push_back(sample);
    }
    return samples;
  }

  /// If not `Tiled_resampling::orients_at_once()`: what turns the trees of all tiles to one side.
  /// \param evidence of each tile
  Stitching stitching(const std::vector<std::vector<double>>& evidence) const
  {
    return Stitching(sample_spacing(), evidence);
  }

  /// Moves those of the samples of a tile that creases move.
  static void move_samples(const Creases& creases, std::size_t tile,
                           std::vector<Tile_sample>& samples)
  {
    creases.for_each_moved(tile, [&](const internal::Sample_beside_crease& moved,
                                     std::size_t place) {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        samples[place].position[axis] = moved.position[Eigen::Index(axis)];
        samples[place].normal[axis] = float(moved.normal[Eigen::Index(axis)]);
      }
    });
  }

protected: // and of the steps
  /// \cond SKIP_IN_MANUAL
  /// \param parameters of the call for the whole cloud, checked
  /// \param counts of all points
  Tiled_cloud(const internal::Parameters& parameters, Tile_counts counts)
    : m_parameters(parameters), m_cloud(std::move(counts))
  {}

  const internal::Parameters& parameters() const { return m_parameters; }
  const internal::Counted_cloud& counted() const { return m_cloud; }
  const Disks& disks() const { return m_disks; }
  double spacing_in_radii() const { return m_sample_spacing; }
  double overlap_width() const { return 2 * m_radius; }

  internal::Plan plan() const
  {
    internal::Facts known = *m_facts.extents;
    known.scales = *m_facts.scales;
    return internal::make_plan(m_parameters, known);
  }

  /// \param length in units of the paper's radius
  double length_of_input(double length) const
  {
    CGAL_precondition(m_facts.extents.has_value());
    return std::ldexp(length * internal::paper_radius(*m_facts.extents),
                      -m_facts.extents->exponent_of_input);
  }

  /// `Report::estimated_spacing`
  double estimated_spacing() const { return length_of_input(m_facts.scales->spacing); }
  /// `Report::estimated_noise`
  double estimated_noise() const
  {
    return plan().is_noise_known ? m_parameters.noise : length_of_input(m_facts.scales->noise);
  }

  internal::Own_blocks own_blocks_of_tile(std::size_t tile) const
  {
    return {lattice(), m_tiles[tile].box};
  }

  internal::Blocks_of_tile blocks_of_tile(std::size_t tile) const
  {
    return {m_cloud, m_tiles[tile], halo_in_blocks()};
  }

  /// \param bytes that a tile and its halo may take
  /// \param halo in radii
  /// \throws std::bad_alloc if a single block takes more
  void cut(std::uint64_t bytes, double halo, const Bytes_of_call& of_call)
  {
    m_halo_in_radii = halo;
    auto of_tile = internal::Bytes_of_tile::of_cloud(
      blocks(), double(of_call.per_point), double(number_of_samples()) * double(of_call.per_sample),
      !m_parameters.keep_density);
    if (!m_has_all_facts)
      of_tile.per_point_before = double(bytes_per_point_to_find);
    const internal::Tiling tiling(blocks(), halo_in_blocks(), of_tile, double(bytes));
    m_tiles = tiling.tiles();
    if (tiling.maximum_bytes_of_tile() > double(bytes))
      throw std::bad_alloc();
  }
  /// \endcond
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILED_CLOUD_H
