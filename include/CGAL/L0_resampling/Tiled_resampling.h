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
#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/Tile_archive.h>
#include <CGAL/L0_resampling/Tile_counts.h>
#include <CGAL/L0_resampling/Tile_result.h>
#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/internal/cloud/areas_of_points.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/output_iterators.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/tiles/Blocks_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Counted_cloud.h>
#include <CGAL/L0_resampling/internal/tiles/Creases_of_tiles.h>
#include <CGAL/L0_resampling/internal/tiles/Facts_in_passes.h>
#include <CGAL/L0_resampling/internal/tiles/Samples_to_orient.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>
#include <CGAL/L0_resampling/tags.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>
#ifndef CGAL_L0_LINKED_WITH_COMPILED
#include <CGAL/L0_resampling/internal/tiles/facts_of_tile_impl.h>
#include <CGAL/L0_resampling/internal/tiles/find_creases_of_tiles_impl.h>
#include <CGAL/L0_resampling/internal/tiles/orient_tiles_impl.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile_impl.h>
#endif
#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/internal/tiles/tiles_on_device.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <new>
#include <stdexcept>
#include <type_traits>
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
class Tiled_resampling
{
  static constexpr bool is_on_device = std::is_same<ConcurrencyTag, CUDA_tag>::value;
  using Host_tag = std::conditional_t<is_on_device, Parallel_if_available_tag, ConcurrencyTag>;
  using Solver = Block_chebyshev_solver_traits<float, Host_tag>;
  using FT = typename Solver::FT;

  internal::Parameters m_parameters;
  std::function<bool(double)> m_callback;
  internal::Counted_cloud m_cloud;
  internal::Facts_of_cloud m_facts;
  bool m_has_all_facts = false;
  internal::Buffer<internal::Point_in_cloud> m_points; // of all blocks, if all facts are from here
  double m_radius = 0;                                 // in the unit of the input
  double m_halo_in_radii = halo_in_radii;
  std::vector<Tile> m_tiles;
  std::vector<internal::Buffer<internal::Point_in_cloud>> m_points_of_tiles; // that were set
  internal::Disks_of_tile m_disks;                // of the cloud, if not all facts were found
  std::vector<internal::Starts_of_runs> m_starts; // of the tiles, likewise
  double m_sample_spacing = 0;                    // in units of the radius
  bool m_orients_at_once = false;

  /// Around the blocks of a tile, and the points beyond them of runs of cells that are its own.
  std::int64_t halo_in_blocks() const
  {
    double radii = m_halo_in_radii;
    if (!has_all_facts())
      radii += internal::Search_grid_3::longest_run * plan_of(m_facts).cell_size;
    return m_cloud.halo_in_blocks(radii * m_radius);
  }

  internal::Own_blocks own_blocks_of(std::size_t tile) const
  {
    return {m_cloud.lattice(), m_tiles[tile].box};
  }

  internal::Blocks_of_tile blocks_of_tile(std::size_t tile) const
  {
    return {m_cloud, m_tiles[tile], halo_in_blocks()};
  }

  internal::Plan plan_of(const internal::Facts_of_cloud& facts) const
  {
    internal::Facts known = *facts.extents;
    known.scales = *facts.scales;
    return internal::make_plan(m_parameters, known);
  }

  /// Calls `f(progress, memory)`.
  /// \throws Cancelled if the callback says no
  template <typename F>
  void watched(Report& report, const F& f) const
  {
    internal::Memory_counter memory(is_on_device // whose limit it is then
                                      ? (std::numeric_limits<std::size_t>::max)()
                                      : m_parameters.maximum_memory);
    internal::Progress progress(m_callback, report, memory);
    try
    {
      f(progress, memory);
    }
    catch (const internal::Interrupted&)
    {
      progress.rethrow_exception_of_callback();
      throw Cancelled();
    }
  }

  double overlap_width() const { return 2 * m_radius; }

  /// By the limit of the caller, which with `CUDA_tag` is of the device.
  std::uint64_t limited(std::uint64_t bytes) const
  {
    return (std::min)(bytes, std::uint64_t(m_parameters.maximum_memory));
  }

public:
  /// Thrown where the callback has returned `false`.
  using Cancelled = internal::Tiles_cancelled;

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
  using Sums = internal::Sums_of_tiles; ///< over all tiles, with the `disks` of the cloud, plain
  using Creases = internal::Creases_of_tiles; ///< of the cloud, and the samples that they move
  /// @}

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

  /// \cond SKIP_IN_MANUAL
  Tiled_resampling(Tile_counts counts, const internal::Given_parameters& given)
    : m_parameters(internal::checked_parameters(given, 1)), m_callback(given.callback),
      m_cloud(std::move(counts))
  {
    if (m_parameters.method != Method::DEFAULT)
      throw std::invalid_argument("l0_resample_tiles: only the default method works by tiles");
    if (given.has_values_of_points())
      throw std::invalid_argument("l0_resample_tiles: tiles have positions and normals alone; "
                                  "property maps and outliers are those of a call for all "
                                  "points");
    if (m_parameters.keep_density
        && (number_of_points() >= many || m_parameters.number_of_output_points >= many))
      throw std::invalid_argument(
        "l0_resample_tiles: keep_density takes fewer than 2^32 points, and gives fewer");
  }
  /// \endcond

  const std::vector<std::pair<Block, std::uint64_t>>& blocks() const { return m_cloud.blocks(); }
  const Block_lattice& lattice() const { return m_cloud.lattice(); }
  std::uint64_t number_of_points() const { return m_cloud.number_of_points(); }
  std::uint64_t number_of_samples() const { return m_parameters.number_of_output_points; }
  double neighbor_radius() const { return m_radius; }
  double sample_spacing() const { return m_sample_spacing * m_radius; }
  const Facts& facts() const { return m_facts; }
  /// Whether these are the facts that a call for the whole cloud in memory finds. Then it is also
  /// known where samples start: tiles need neither shares nor sums.
  bool has_all_facts() const { return m_has_all_facts; }
  /// What `find_facts()` has found of each point, block after block; none if it has not found all
  /// facts.
  const Array<Point_facts>& points_in_cloud() const { return m_points; }
  const std::vector<Tile>& tiles() const { return m_tiles; }
  Source_box box_of_tile(std::size_t tile) const { return m_cloud.source_box(m_tiles[tile].box); }

  /// With `CUDA_tag`, what tiles may take of the current device, in bytes: what is free there, but
  /// for what the driver needs. Else there is no limit.
  /// \throws Device_error if no device can be used
  static std::uint64_t device_memory()
  {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    if constexpr (is_on_device)
      return internal::device_memory_for_tiles();
#endif
    return (std::numeric_limits<std::uint64_t>::max)();
  }

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
    if (can_find_all_facts(number_of_points(), number_of_samples(), bytes, device_bytes))
      set_facts(facts_of_all_points(source));
    else
      set_facts(facts_in_passes(source, bytes, halo));
    return m_facts;
  }

  /// Instead of `find_facts()`, which has found them another time.
  void set_facts(const Facts& facts)
  {
    m_facts = facts;
    m_radius = std::ldexp(plan_of(m_facts).unit, -m_facts.extents->exponent_of_input);
    m_has_all_facts = m_facts.area.has_value();
    if (m_has_all_facts)
      set_spacing();
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
    m_halo_in_radii = halo;
    bytes = limited(bytes);
    if (!is_on_device && m_facts.field)
      bytes -= (std::min)(bytes, std::uint64_t(m_facts.field->number_of_bytes()));
    const internal::Tiling tiling(blocks(), halo_in_blocks(), bytes_of_tile(of_call),
                                  double(bytes));
    m_tiles = tiling.tiles();
    if (tiling.most_bytes_of_tile() > double(bytes))
      throw std::bad_alloc();
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
    return number_of_samples <= (std::min)(bytes / per_sample, most_samples_to_orient);
  }
  bool orients_at_once() const { return m_orients_at_once; }

  /// Where the points that a tile reads stand in `points_in_cloud()`, in their order: the first of
  /// each block, and how many these are.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> ranges_of_tile(std::size_t tile) const
  {
    return blocks_of_tile(tile).ranges();
  }

  /// The scales of the points of a tile and around it, and how many neighbors those of the tile
  /// have. Not needed if `has_all_facts()`, as what follows until `set_starts()`.
  /// \param tile its number
  /// \param source of the points
  template <typename Source>
  Neighbors find_neighbors_of_tile(std::size_t tile, const Source& source) const
  {
    Neighbors found;
    with_points(tile, source, [&](auto& points, internal::Progress& progress) {
      Report unwanted_report;
      Neighbors counted = internal::find_neighbors_of_tile<Host_tag>(
        points, m_facts, m_parameters, own_blocks_of(tile), progress, unwanted_report);
      found.counts = std::move(counted.counts);
      found.scales.assign(counted.scales.begin(), counted.scales.end()); // outlives the counter
    });
    return found;
  }

  /// \param medians of the sum of what `find_neighbors_of_tile()` has counted for each tile
  void set_medians(const Medians& medians)
  {
    m_facts.range_of_scales = medians.scales;
    m_facts.median_number_of_neighbors = medians.number_of_neighbors;
  }

  /// What else is found of these points before it is known where samples start, once
  /// `set_medians()` was called.
  /// \param tile its number
  /// \param source of the points
  /// \param scales as `find_neighbors_of_tile()` has given; if none, they are found once more
  template <typename Source>
  Points find_points_of_tile(std::size_t tile, const Source& source, Array<float> scales = {}) const
  {
    Points found;
    with_points(tile, source, [&](auto& points, internal::Progress& progress) {
      found = find_points(tile, points, std::move(scales), progress);
    });
    return found;
  }

  /// \param disks sum over what `find_points_of_tile()` has given for each tile
  void set_disks(const Disks& disks)
  {
    m_disks = disks;
    m_facts.units_of_disks = m_disks.units;
    m_facts.has_plain_blocks = m_disks.number_of_others == 0
                               && (!m_facts.field || m_facts.field->is_even());
  }

  /// What `set_disks()` takes.
  static Disks add_up_disks(const std::vector<Disks>& of_tiles)
  {
    return internal::add_up_disks(of_tiles);
  }

  /// What a tile adds to the sums over all tiles, once `set_disks()` was called.
  /// \param points what `find_points_of_tile()` has given; areas are noted there
  Share share_of_tile(Points& points) const
  {
    return points.share(m_disks, plan_of(m_facts).area_radius(), number_of_samples());
  }

  /// Adds up the shares of all tiles.
  /// \param shares what `share_of_tile()` has given for each tile; out: with the runs that
  /// `set_starts()` takes
  /// \param disks what `add_up_disks()` has given
  static Sums add_up_shares(std::vector<Share>& shares, const Disks& disks)
  {
    Sums sums = internal::add_up_shares(shares);
    sums.disks = disks;
    return sums;
  }

  /// Decides how many samples start where.
  /// \param shares what `share_of_tile()` has given for each tile
  void set_shares(std::vector<Share> shares)
  {
    const Sums sums = add_up_shares(shares, m_disks);
    set_sums(sums);
    for (std::size_t tile = 0; tile < shares.size(); ++tile)
      set_starts(tile, std::move(shares[tile].runs), sums);
  }

  /// Instead of `set_disks()` and `set_shares()`: what these have found another time.
  void set_sums(const Sums& sums)
  {
    set_disks(sums.disks);
    m_facts.area = sums.area;
    m_facts.number_of_points = std::size_t(sums.sums.points);
    m_facts.number_of_places = std::size_t(sums.sums.distinct);
    m_facts.mean_number_of_neighbors = double(sums.sums.neighbors) / double(sums.sums.points);
    set_spacing();
  }

  /// As `set_sums()`, for a tile that is to be resampled.
  /// \param tile its number
  /// \param runs that `add_up_shares()` has left of the share of the tile
  /// \param sums over all tiles
  void set_starts(std::size_t tile, std::vector<Run> runs, const Sums& sums)
  {
    m_starts.resize(m_tiles.size());
    m_starts[tile] = {std::move(runs), sums.sums};
  }

  /// For a tile that is to be resampled, after `set_disks()`, and `set_starts()` for it: what
  /// `find_points_of_tile()` has given. Else that is found once more.
  void set_points_of_tile(std::size_t tile, Points points)
  {
    m_points_of_tiles.resize(m_tiles.size());
    m_points_of_tiles[tile] = placed(tile, std::move(points));
  }

  /// If `has_all_facts()`, instead of `find_facts()`, for a tile that is to be resampled: those of
  /// `points_in_cloud()` that are in its ranges.
  void set_points(std::size_t tile, Array<Point_facts> points)
  {
    blocks_of_tile(tile).mark_own(points);
    m_points_of_tiles.resize(m_tiles.size());
    m_points_of_tiles[tile] = std::move(points);
  }

  /// The samples that start in a tile.
  template <typename Source>
  Tile_result resample_tile(std::size_t tile, const Source& source) const
  {
    Tile_result result;
    watched(result.report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      internal::Input input = input_of_cloud(memory);
      const internal::Blocks_of_tile blocks = blocks_of_tile(tile);
      if (has_all_facts())
        blocks.read_by_blocks(source, input.points);
      else
        blocks.read_at_once(source, input.points);
      const bool are_points_set = tile < m_points_of_tiles.size()
                                  && !m_points_of_tiles[tile].empty();
      const Array<Point_facts> found_here = are_points_set
                                              ? Array<Point_facts>()
                                              : points_of_tile(tile, input.points, progress);
      const Array<Point_facts>& known = are_points_set ? m_points_of_tiles[tile] : found_here;
      result.report.number_of_input_points = input.points.size();
      if (plan_of(m_facts).drops_outliers())
        result.outliers = internal::own_outliers(input.points, known);
      if (!internal::are_there_starts(known))
        return;
      const internal::Samples_of_tile<FT> samples = resample_points(input.points, known, progress,
                                                                    result.report);
      const internal::Buffer<std::array<double, 3>> positions =
        internal::rounded_positions<Host_tag, double>(samples.points.positions, input, m_radius,
                                                      true);
      const internal::Found_samples<FT> found = {samples, positions, box_of_tile(tile),
                                                 overlap_width()};
      if (m_orients_at_once)
        internal::take_unoriented_samples(found, result);
      else
        internal::take_oriented_samples(found, result);
    });
    result.report.number_of_output_points = result.samples.size();
    result.findings = internal::findings_of(result.report);
    result.findings.number_of_outliers = result.outliers.size(); // those of its halo are others'
    return result;
  }

  /// If `orients_at_once()`: the sign of each tile and tree.
  /// \param unoriented of each tile; used up
  /// \param report out: what it took
  std::vector<std::vector<signed char>> sides(std::vector<Unoriented_samples> unoriented,
                                              Report& report) const
  {
    std::vector<std::vector<signed char>> signs;
    watched(report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      internal::Plan plan = plan_of(m_facts);
      plan.set_sample_spacing(m_sample_spacing);
      internal::Samples_to_orient samples(Host_tag(), std::move(unoriented), plan.sample_spacing,
                                          memory);
      if (!samples.places.empty())
        orient(plan, progress, report, samples);
      signs = samples.template signs<Host_tag>();
    });
    return signs;
  }

  /// What a call for the whole cloud in memory reports of it, as far as tiles know it: points and
  /// samples, and what `warnings()` follow from, but for the extent of the result.
  /// \param findings of all tiles, added up
  Report report(const Tile_findings& findings) const
  {
    Report report;
    report.number_of_input_points = std::size_t(number_of_points());
    report.number_of_outliers = std::size_t(findings.number_of_outliers);
    report.number_of_degenerate_neighborhoods = std::size_t(
      findings.number_of_degenerate_neighborhoods);
    report.number_of_output_points = std::size_t(findings.number_of_output_points);
    report.number_of_lonely_samples = std::size_t(findings.number_of_lonely_samples);
    report.number_of_unexplained_samples = std::size_t(findings.number_of_unexplained_samples);
    report.number_of_unexplained_samples_there = std::size_t(
      findings.number_of_unexplained_samples_there);
    report.unexplained_center = findings.unexplained_center;
    if (findings.number_of_unexplained_samples > 0)
      report.unexplained_radius = internal::unexplained_radius_factor * neighbor_radius();
    report.neighbor_radius = neighbor_radius();
    report.estimated_spacing = estimated_spacing();
    report.estimated_noise = estimated_noise();
    report.sample_spacing = m_parameters.keep_density ? 0 : sample_spacing();
    if (is_on_device)
      report.device = "cuda";
    return report;
  }

  bool finds_creases() const { return m_parameters.with_creases; }

  /// Once sides are known: the creases of the cloud, and the samples that they move; of the same
  /// samples the same bits, whatever the tiles are. Holds the samples of one tile and of those
  /// around it, 200 bytes for each of them, and what all samples beside creases see.
  /// \param samples_of called with a tile, several times: all of its samples, with normals on their
  /// sides, as a `std::vector<Tile_sample>`
  template <typename SamplesOf>
  Creases find_creases(const SamplesOf& samples_of) const
  {
    Creases found;
    Report unwanted_report;
    watched(unwanted_report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      const auto take_samples_of = [&](std::size_t tile, std::vector<Tile_sample>& samples) {
        samples = samples_of(tile);
      };
      found = internal::find_creases_of_tiles<Host_tag>(
        m_tiles.size(), internal::spacing_of_creases(sample_spacing(), estimated_spacing()),
        internal::Samples_of_tiles(take_samples_of), progress, memory);
      std::vector<internal::Sample_beside_crease>& moved = found.placed.moved;
      internal::Buffer<internal::Vector> positions(&memory);
      for (const internal::Sample_beside_crease& sample : moved)
        positions.push_back(sample.position);
      const internal::Buffer<std::array<double, 3>> rounded =
        internal::rounded_positions<Host_tag, double>(positions, input_of_cloud(memory), m_radius,
                                                      true);
      for (std::size_t k = 0; k < moved.size(); ++k)
        moved[k].position = internal::Vector(rounded[k].data());
    });
    return found;
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

  /// Writes creases and corners for `CGAL::Simple_cartesian<double>`.
  /// \param creases of `find_creases()`, whose samples are numbered tile after tile
  /// \param np `crease_output_iterator` and `corner_output_iterator`
  template <typename NamedParameters>
  static void write_creases(const Creases& creases, const NamedParameters& np)
  {
    internal::write_creases<CGAL::Simple_cartesian<double>>(np, creases.placed);
  }

  /// If not `orients_at_once()`: what turns the trees of all tiles to one side.
  /// \param evidence of each tile
  Stitching stitching(const std::vector<std::vector<double>>& evidence) const
  {
    return Stitching(sample_spacing(), evidence);
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

  /// Whether the sides of all samples are given, so that no tile turns another.
  bool are_sides_given() const { return m_parameters.has_viewpoint && !m_orients_at_once; }

private:
  static constexpr std::uint64_t bytes_per_point_to_find = 200;
  static constexpr std::uint64_t many = std::uint64_t(1) << 32, // more than an index can number
    most_samples_to_orient = is_on_device ? many / 2 - 1 : many - 1;

  internal::Bytes_of_tile bytes_of_tile(const Bytes_of_call& of_call) const
  {
    internal::Bytes_of_tile bytes = internal::Bytes_of_tile::of_cloud(
      blocks(), double(of_call.per_point), double(number_of_samples()) * double(of_call.per_sample),
      !m_parameters.keep_density);
    if (!has_all_facts())
      bytes.per_point_before = double(bytes_per_point_to_find);
    return bytes;
  }

  /// Without points.
  internal::Input input_of_cloud(internal::Memory_counter& memory) const
  {
    internal::Input input(&memory);
    input.low = internal::Vector(m_cloud.low().data());
    input.high = internal::Vector(m_cloud.high().data());
    return input;
  }

  void set_spacing() { m_sample_spacing = std::sqrt(*m_facts.area / double(number_of_samples())); }

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
    return plan_of(m_facts).is_noise_known ? m_parameters.noise
                                           : length_of_input(m_facts.scales->noise);
  }

  /// Calls `f(points, progress)` with the points of a tile and around it, to be used up.
  template <typename Source, typename F>
  void with_points(std::size_t tile, const Source& source, const F& f) const
  {
    Report unwanted_report;
    watched(unwanted_report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      internal::Buffer<internal::Vector> points(&memory);
      blocks_of_tile(tile).read_at_once(source, points);
      f(points, progress);
    });
  }

  /// \param points used up
  /// \param scales of them; none if they are to be found
  internal::Points_of_tile find_points(std::size_t tile, internal::Buffer<internal::Vector>& points,
                                       internal::Buffer<float> scales,
                                       internal::Progress& progress) const
  {
    Report unwanted_report;
    Solver solver;
    internal::Any_solver<FT> any_solver(solver);
    return internal::find_points_of_tile<Host_tag>(points, std::move(scales), m_facts, m_parameters,
                                                   own_blocks_of(tile), any_solver, progress,
                                                   unwanted_report);
  }

  internal::Buffer<internal::Point_in_cloud> placed(std::size_t tile,
                                                    internal::Points_of_tile points) const
  {
    share_of_tile(points);
    const internal::Plan plan = plan_of(m_facts);
    return std::move(points).placed(m_starts[tile], plan.number_of_samples, plan.random_seed,
                                    plan.starts_evenly);
  }

  /// What is to be known of the points of a tile and its halo.
  internal::Buffer<internal::Point_in_cloud> points_of_tile(
    std::size_t tile, const internal::Buffer<internal::Vector>& points,
    internal::Progress& progress) const
  {
    if (!has_all_facts())
    {
      internal::Buffer<internal::Vector> used_up = internal::copy_of(points);
      return placed(tile, find_points(tile, used_up, {}, progress));
    }
    const internal::Blocks_of_tile blocks = blocks_of_tile(tile);
    internal::Buffer<internal::Point_in_cloud> known;
    known.reserve(blocks.number_of_points());
    for (const auto& [first, count] : blocks.ranges())
      known.insert(known.end(), m_points.begin() + std::ptrdiff_t(first),
                   m_points.begin() + std::ptrdiff_t(first + count));
    blocks.mark_own(known);
    return known;
  }

  /// \param points used up
  internal::Samples_of_tile<FT> resample_points(
    internal::Buffer<internal::Vector>& points,
    const internal::Buffer<internal::Point_in_cloud>& known, internal::Progress& progress,
    Report& report) const
  {
    if constexpr (!is_on_device)
    {
      Solver solver;
      internal::Any_solver<FT> any_solver(solver);
      return internal::resample_tile<Host_tag>(points, known, m_facts, !m_orients_at_once,
                                               m_parameters, any_solver, progress, report);
    }
    else
    {
#ifdef CGAL_L0_LINKED_WITH_CUDA
      return internal::resample_tile_on_device(points, known, m_facts, !m_orients_at_once,
                                               m_parameters, m_callback, report);
#else
      static_assert(
        !is_on_device,
        "CUDA_tag needs a compiled library: link with the CMake target CGAL::L0_CUDA_support.");
#endif
    }
  }

  void orient(const internal::Plan& plan, internal::Progress& progress, Report& report,
              internal::Samples_to_orient& samples) const
  {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    if constexpr (is_on_device)
      return internal::orient_tiles_on_device(m_facts, plan, {m_cloud.low(), m_cloud.high()},
                                              m_parameters, m_callback, report, samples);
#endif
    (void)report;
    internal::orient_tiles<Host_tag>(m_facts, plan, m_parameters, progress, samples);
  }

  /// \param points used up
  internal::Facts_of_cloud facts_of_points(internal::Buffer<internal::Vector>& points,
                                           internal::Progress& progress, Report& report)
  {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    if constexpr (is_on_device)
      return internal::facts_on_device(points, m_parameters, m_callback, report, m_points);
#endif
    Solver solver;
    internal::Any_solver<FT> any_solver(solver);
    return internal::facts_of_points<Host_tag>(points, m_parameters, any_solver, progress, report,
                                               m_points);
  }

  template <typename Source>
  internal::Facts_of_cloud facts_of_all_points(const Source& source)
  {
    internal::Facts_of_cloud facts;
    Report report;
    watched(report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      internal::Buffer<internal::Vector> points(&memory);
      points.reserve(std::size_t(number_of_points()));
      for (const auto& [block, count] : blocks())
        m_cloud.read(source, {block, block}, points);
      facts = facts_of_points(points, progress, report);
    });
    return facts;
  }

  template <typename Source>
  internal::Facts_of_cloud facts_in_passes(const Source& source, std::uint64_t bytes,
                                           double halo) const
  {
    internal::Facts_of_cloud facts;
    Report report;
    watched(report, [&](internal::Progress&, internal::Memory_counter& memory) {
      facts = internal::Facts_in_passes<Host_tag, Source>(m_cloud, source, m_parameters, bytes,
                                                          m_callback, memory)
                .find(halo);
    });
    return facts;
  }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILED_RESAMPLING_H
