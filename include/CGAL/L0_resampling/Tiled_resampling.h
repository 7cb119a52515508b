// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TILED_RESAMPLING_H
#define CGAL_L0_RESAMPLING_TILED_RESAMPLING_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/Tile_archive.h>
#include <CGAL/L0_resampling/Tile_counts.h>
#include <CGAL/L0_resampling/Tile_findings.h>
#include <CGAL/L0_resampling/Tile_result.h>
#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/Tiled_cloud.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/interface/Steps_of_tiles.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/output_iterators.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/*!
\ingroup PkgL0ResamplingRef

Resamples a cloud that does not fit into memory, tile by tile, by the default method. The steps are
functions of their arguments alone: a program may store what they give and go on another day, run
the tiles in any order, and on several machines. `CGAL::l0_resample_tiles()` runs them one after
the other.

A source is a class with a function `for_each_point(box, f)`, which calls `f` with each point of a
`Source_box`, as a `std::array<double, 3>`: concept `L0ResamplingTileSource`.

\tparam ConcurrencyTag as for `CGAL::l0_resample_point_set()`. With `CUDA_tag`, `resample_tile()`
and `sides()` work on the current device, and `find_facts()` if it finds all; the other steps work
on the CPU, by all of its threads.
*/
template <typename ConcurrencyTag>
class Tiled_resampling : public Tiled_cloud
{
  using Steps = internal::Steps_of_tiles<ConcurrencyTag, Block_chebyshev_solver_traits>;
  static constexpr bool is_on_device = Steps::is_on_device;
  static constexpr std::uint64_t many = std::uint64_t(1) << 32, // more than an index can number
    maximum_number_of_samples_to_orient = is_on_device ? many / 2 - 1 : many - 1;

  std::function<bool(double)> m_callback;
  internal::Known_points m_points;
  bool m_orients_at_once = false;

  Steps steps() const { return {*this, m_callback}; }

  /// By the limit of the caller, which with `CUDA_tag` is of the device.
  std::uint64_t limited(std::uint64_t bytes) const
  {
    return (std::min)(bytes, std::uint64_t(parameters().maximum_memory));
  }

  Tiled_resampling(Tile_counts counts, const internal::Given_parameters& given)
    : Tiled_cloud(internal::checked_parameters(given, 1), std::move(counts)),
      m_callback(given.callback)
  {
    if (parameters().method != Method::DEFAULT)
      throw std::invalid_argument("l0_resample_tiles: only the default method works by tiles");
    if (given.has_values_of_points())
      throw std::invalid_argument("l0_resample_tiles: tiles have positions and normals alone; "
                                  "property maps and outliers are those of a call for all "
                                  "points");
    if (parameters().keep_density && (number_of_points() >= many || number_of_samples() >= many))
      throw std::invalid_argument(
        "l0_resample_tiles: keep_density takes fewer than 2^32 points, and gives fewer");
  }

public:
  /// Thrown where the callback has returned `false`.
  using Cancelled = internal::Tiles_cancelled;

  /// A `std::vector` with an allocator of the package.
  template <typename T>
  using Array = internal::Buffer<T>;

  /// The points around a tile that decide on its samples lie within so many radii: half of them
  /// for the refinement, whose balls are finite, and half for the energy. Beyond, its influence is
  /// below what a number of single precision holds.
  static constexpr double halo_in_radii = 40;
  /// What `resample_tile()` holds for each point that it reads, and for each sample, at most; with
  /// `CUDA_tag`, on the device, and less than that here.
  static constexpr std::uint64_t bytes_per_point = is_on_device ? 370 : 100,
                                 bytes_per_sample = is_on_device ? 520 : 480;
  /// The same as one.
  static constexpr Bytes_of_call bytes_of_call = {bytes_per_point, bytes_per_sample};
  /// The same, where all facts of a cloud are found; with `CUDA_tag`, here, and on the device.
  static constexpr std::uint64_t bytes_per_point_of_facts = is_on_device ? 60 : 200,
                                 bytes_per_sample_of_facts = is_on_device ? 0 : 100,
                                 bytes_per_point_of_facts_on_device = is_on_device ? 175 : 0,
                                 bytes_per_sample_of_facts_on_device = is_on_device ? 16 : 0;
  /// What `find_neighbors_of_tile()` and `find_points_of_tile()` give for each point, in bytes.
  static constexpr std::uint64_t bytes_per_point_of_tile = Neighbors::bytes_per_point
                                                           + Points::bytes_per_point;
  /// What `sides()` holds for each sample, with what it is given; with `CUDA_tag`, on the device,
  /// and less than that here.
  static constexpr std::uint64_t bytes_per_sample_of_sides = is_on_device ? 300 : 220;

  /// \param counts of all points
  /// \param np as those of `CGAL::l0_resample_point_set()`: `number_of_output_points`,
  /// `neighbor_radius`, `noise`, `sharpness_angle`, `normal_weight`, `random_seed`,
  /// `drop_outliers`, `outlier_sensitivity`, `keep_density`, `viewpoint`, `up_direction`,
  /// `crease_output_iterator` and `corner_output_iterator`, which get nothing from here: whether
  /// one is given is what `finds_creases()` tells; `callback`; `maximum_memory`, which with
  /// `CUDA_tag` is of the device: `find_facts()` and `make_tiles()` keep to it, and to what they
  /// are given
  /// \throws std::invalid_argument for property maps, and for outliers
  template <typename NamedParameters>
  Tiled_resampling(Tile_counts counts, const NamedParameters& np)
    : Tiled_resampling(std::move(counts), internal::Given_parameters(np))
  {}

  /// What `find_facts()` has found of each point, block after block; none if it has not found all
  /// facts.
  const Array<Point_facts>& points_in_cloud() const { return m_points.of_cloud; }

  /// With `CUDA_tag`, what tiles may take of the current device, in bytes: what is free there, but
  /// for what the driver needs. Else there is no limit.
  /// \throws Device_error if no device can be used
  static std::uint64_t device_memory() { return Steps::device_memory(); }

  /// Whether `bytes`, and with `CUDA_tag` `device_bytes` of the device, hold what it takes to find
  /// all facts of so many points.
  static bool can_find_all_facts(std::uint64_t number_of_points, std::uint64_t number_of_samples,
                                 std::uint64_t bytes, std::uint64_t device_bytes)
  {
    const auto hold = [&](std::uint64_t memory, std::uint64_t per_point, std::uint64_t per_sample) {
      return double(number_of_points) * double(per_point)
               + double(number_of_samples) * double(per_sample)
             <= double(memory);
    };
    return number_of_points < many
           && hold(bytes, bytes_per_point_of_facts, bytes_per_sample_of_facts)
           && hold(device_bytes, bytes_per_point_of_facts_on_device,
                   bytes_per_sample_of_facts_on_device);
  }

  /// Finds the facts of the whole cloud, those that a call for all of it in memory finds: at once,
  /// if memory holds all of the points; else in passes over the cloud, all but what follows from
  /// what tiles find of their points.
  /// \param source of the points
  /// \param bytes of memory
  /// \param device_bytes of that of the device, with `CUDA_tag`
  /// \param halo of the tiles in these passes, in radii
  /// \throws std::bad_alloc if a single block takes more
  template <typename Source>
  const Facts& find_facts(const Source& source, std::uint64_t bytes,
                          std::uint64_t device_bytes = (std::numeric_limits<std::uint64_t>::max)(),
                          double halo = halo_in_radii)
  {
    std::uint64_t& with_limit = is_on_device ? device_bytes : bytes;
    with_limit = limited(with_limit);
    const bool at_once = can_find_all_facts(number_of_points(), number_of_samples(), bytes,
                                            device_bytes);
    set_facts(steps().find_facts(source, at_once, bytes, halo, m_points.of_cloud));
    return facts();
  }

  /// Cuts the cloud into tiles.
  /// \param bytes that a tile and its halo may take, beside what is kept of all blocks
  /// \param halo in radii, rounded up to whole blocks; longer by a run of cells, 5.7 radii, if not
  /// `has_all_facts()`
  /// \param of_call that resamples them, of this class or for another processor
  /// \throws std::bad_alloc if a single block takes more
  void make_tiles(std::uint64_t bytes, double halo = halo_in_radii,
                  const Bytes_of_call& of_call = bytes_of_call)
  {
    bytes = limited(bytes);
    if (!is_on_device && facts().field)
      bytes -= (std::min)(bytes, std::uint64_t(facts().field->number_of_bytes()));
    cut(bytes, halo, of_call);
  }

  /// Lets the sides of all samples be found at once, by `sides()`, if `bytes`, and with `CUDA_tag`
  /// the device as well, hold what that takes. If not, each tile finds its own, and `stitching()`
  /// turns them.
  /// \param bytes of memory, and of the device
  /// \param per_sample of the `sides()` of this class, or for another processor
  void choose_how_to_orient(std::uint64_t bytes,
                            std::uint64_t per_sample = bytes_per_sample_of_sides)
  {
    m_orients_at_once = can_orient_at_once(number_of_samples(), limited(bytes), per_sample);
  }
  static bool can_orient_at_once(std::uint64_t number_of_samples, std::uint64_t bytes,
                                 std::uint64_t per_sample = bytes_per_sample_of_sides)
  {
    return number_of_samples <= (std::min)(bytes / per_sample, maximum_number_of_samples_to_orient);
  }
  bool orients_at_once() const { return m_orients_at_once; }
  /// Whether the sides of all samples are given, so that no tile turns another.
  bool are_sides_given() const { return parameters().has_viewpoint && !m_orients_at_once; }

  /// The scales of the points of a tile and around it, and how many neighbors those of the tile
  /// have. Not needed if `has_all_facts()`, as what follows until `set_starts()`.
  /// \param tile its number
  /// \param source of the points
  template <typename Source>
  Neighbors find_neighbors_of_tile(std::size_t tile, const Source& source) const
  {
    return steps().find_neighbors_of_tile(tile, source);
  }

  /// What else is found of these points before it is known where samples start, once
  /// `set_medians()` was called.
  /// \param tile its number
  /// \param source of the points
  /// \param scales as `find_neighbors_of_tile()` has given; if none, they are found once more
  template <typename Source>
  Points find_points_of_tile(std::size_t tile, const Source& source, Array<float> scales = {}) const
  {
    return steps().find_points_of_tile(tile, source, std::move(scales));
  }

  /// Decides how many samples start where.
  /// \param shares what `share_of_tile()` has given for each tile
  void set_shares(std::vector<Share> shares)
  {
    const Sums sums = add_up_shares(shares, disks());
    set_sums(sums);
    for (std::size_t tile = 0; tile < shares.size(); ++tile)
      set_starts(tile, std::move(shares[tile].runs), sums);
  }

  /// As `set_sums()`, for a tile that is to be resampled.
  /// \param tile its number
  /// \param runs that `add_up_shares()` has left of the share of the tile
  /// \param sums over all tiles
  void set_starts(std::size_t tile, std::vector<Run> runs, const Sums& sums)
  {
    m_points.starts[tile] = {std::move(runs), sums.sums};
  }

  /// For a tile that is to be resampled, after `set_disks()`, and `set_starts()` for it: what
  /// `find_points_of_tile()` has given. Else that is found once more.
  void set_points_of_tile(std::size_t tile, Points points)
  {
    m_points.of_tiles[tile] = steps().placed(std::move(points), m_points.starts.at(tile));
  }

  /// If `has_all_facts()`, instead of `find_facts()`, for a tile that is to be resampled: those of
  /// `points_in_cloud()` that are in its ranges.
  void set_points(std::size_t tile, Array<Point_facts> points)
  {
    blocks_of_tile(tile).mark_own(points);
    m_points.of_tiles[tile] = std::move(points);
  }

  /// The samples that start in a tile.
  template <typename Source>
  Tile_result resample_tile(std::size_t tile, const Source& source) const
  {
    return steps().resample_tile(tile, source, m_points, !m_orients_at_once);
  }

  /// If `orients_at_once()`: the sign of each tile and tree.
  /// \param unoriented of each tile; used up
  /// \param report out: what it took
  std::vector<std::vector<signed char>> sides(std::vector<Unoriented_samples> unoriented,
                                              Report& report) const
  {
    return steps().sides(std::move(unoriented), report);
  }

  /// Once sides are known: the creases of the cloud, and the samples that they move; of the same
  /// samples the same bits, whatever the tiles are. Holds the samples of one tile and of those
  /// around it, 200 bytes for each of them, and what all samples beside creases see.
  /// \param samples_of called with a tile, several times: all of its samples, with normals on their
  /// sides, as a `std::vector<Tile_sample>`
  template <typename SamplesOf>
  Creases find_creases(const SamplesOf& samples_of) const
  {
    return steps().find_creases(samples_of);
  }

  /// Writes creases and corners for `CGAL::Simple_cartesian<double>`.
  /// \param creases of `find_creases()`, whose samples are numbered tile after tile
  /// \param np `crease_output_iterator` and `corner_output_iterator`
  template <typename NamedParameters>
  static void write_creases(const Creases& creases, const NamedParameters& np)
  {
    internal::write_creases<CGAL::Simple_cartesian<double>>(np, creases.placed);
  }

  /// What a call for the whole cloud in memory reports of it, as far as tiles know it: points and
  /// samples, and what `warnings()` follow from, but for the extent of the result.
  /// \param findings of all tiles, added up
  Report report(const Tile_findings& findings) const { return steps().report(findings); }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILED_RESAMPLING_H
