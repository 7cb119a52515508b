// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TILED_RESAMPLING_H
#define CGAL_L0_RESAMPLING_TILED_RESAMPLING_H

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/tiles/Tiling.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/compiled_templates.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>
#include <CGAL/L0_resampling/internal/tiles/stitch_tiles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// A box of points that are read together: coordinates from `low` on and below `high`.
struct Source_box
{
  std::array<double, 3> low, high;
};

/*!
\ingroup PkgL0ResamplingRef

The number of points around each place, by which a cloud is cut into tiles. Points may come in any
order, and counts of several parts of a cloud may be added up: the result is the same.
*/
using Tile_counts = internal::Block_counts;

/// \ingroup PkgL0ResamplingRef
/// A point of the result, as a tile has found it. `Tiled_resampling::signs()` turns its normal.
using Tile_sample = internal::Tile_sample;

/// \ingroup PkgL0ResamplingRef
/// What a tile gives.
struct Tile_result
{
  std::vector<Tile_sample> samples;       ///< those that the tile keeps
  std::vector<Tile_sample> near_border;   ///< those of them that are near to other tiles
  std::vector<Tile_sample> beyond_border; ///< the same of its halo, which others keep
  std::vector<double> evidence;           ///< of each tree: for the sides of its samples
  Report report;
};

/*!
\ingroup PkgL0ResamplingRef

Resamples a cloud that does not fit into memory, tile by tile, by the default method. The steps are
functions of their arguments alone: a program may store what they give and go on another day, run
the tiles in any order, and on several machines. `CGAL::l0_resample_tiles()` runs them one after
the other.

A source is a class with a function `for_each_point(box, f)`, which calls `f` with each point of a
`Source_box`, as a `std::array<double, 3>`: concept `L0ResamplingTileSource`.
*/
template <typename ConcurrencyTag>
class Tiled_resampling
{
  using Solver = Block_chebyshev_solver_traits<float, ConcurrencyTag>;
  using FT = typename Solver::FT;

  internal::Parameters m_parameters;
  std::function<bool(double)> m_callback;
  internal::Block_lattice m_lattice;
  std::vector<std::pair<internal::Block, std::uint64_t>> m_blocks;
  std::array<double, 3> m_low, m_high;
  internal::Cloud_facts m_facts;
  double m_radius = 0; // in the unit of the input
  std::vector<internal::Tile> m_tiles;
  std::vector<std::uint64_t> m_numbers; // of samples, of the blocks
  double m_sample_spacing = 0;          // in units of the radius

  Source_box source_box(const internal::Block_box& box) const
  {
    Source_box source;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      source.low[axis] = double(box.low[axis]) * m_lattice.side();
      source.high[axis] = double(box.high[axis] + 1) * m_lattice.side();
    }
    return source;
  }

  /// In the outermost blocks samples do not start where those of their own tile do: these know the
  /// areas of all points around.
  std::int64_t halo_in_blocks() const
  {
    const double most = 1e6; // no tile is as wide
    return 1
           + std::int64_t(std::ceil((std::min)(halo_in_radii * m_radius / m_lattice.side(), most)));
  }

  /// \param size the number of points
  template <typename Source>
  void read(const Source& source, const internal::Block_box& box, std::uint64_t size,
            internal::Buffer<internal::Vector>& points) const
  {
    points.reserve(points.size() + std::size_t(size));
    source.for_each_point(source_box(box), [&](const std::array<double, 3>& p) {
      points.push_back(internal::Vector(p[0], p[1], p[2]));
    });
  }

  /// Of those that hold points.
  std::vector<std::size_t> blocks_in(const internal::Block_box& box) const
  {
    std::vector<std::size_t> places;
    for (std::size_t b = 0; b < m_blocks.size(); ++b)
      if (box.contains(m_blocks[b].first))
        places.push_back(b);
    return places;
  }

  void set_radius()
  {
    const internal::Facts facts = {std::size_t(m_facts.number_of_points), m_facts.box_diagonal,
                                   m_facts.robust_diagonal, 0, m_facts.scales};
    m_radius = internal::make_plan(m_parameters, facts).unit;
    const double cells = 1024; // of the largest, whose sizes are the radius times powers of two
    m_facts.step_of_origins = cells * m_radius;
  }

  /// Calls `f(progress, memory)`.
  /// \throws Cancelled if the callback says no
  template <typename F>
  void watched(Report& report, const F& f) const
  {
    internal::Memory_counter memory(m_parameters.maximum_memory);
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

  /// \param margin by which the box is larger on each side, or smaller if it is negative
  static bool is_within(const Tile_sample& sample, const Source_box& box, double margin)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (sample.position[axis] < box.low[axis] - margin
          || sample.position[axis] > box.high[axis] + margin)
        return false;
    return true;
  }

  double overlap_width() const { return 2 * m_radius; }

public:
  /// Thrown where the callback has returned `false`.
  struct Cancelled
  {};

  /// The points around a tile that decide on its samples lie within so many radii. Beyond, their
  /// influence is below what a number of single precision holds.
  static constexpr double halo_in_radii = 18;
  /// What a call holds for each point that it reads, at least: the input, and its stages.
  static constexpr std::uint64_t bytes_per_point = 330, bytes_per_sample = 330;

  /// \param counts of all points
  /// \param np as those of `CGAL::l0_resample_point_set()`: `number_of_output_points`,
  /// `neighbor_radius`, `sharpness_angle`, `normal_weight`, `random_seed`, `drop_outliers`,
  /// `keep_density`, `viewpoint`, `up_direction`, `callback`
  template <typename NamedParameters>
  Tiled_resampling(Tile_counts counts, const NamedParameters& np)
    : m_parameters(internal::checked_parameters(np, 1))
  {
    internal::read_parameter(np, internal_np::callback, m_callback);
    if (m_parameters.method != Method::DEFAULT)
      throw std::invalid_argument("l0_resample_tiles: only the default method works by tiles");
    counts.finish();
    m_lattice = counts.lattice();
    m_blocks = counts.blocks();
    m_low = counts.low();
    m_high = counts.high();
    m_facts.number_of_points = counts.number_of_points();
    if (m_blocks.empty())
      return;
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += internal::square(m_high[axis] - m_low[axis]);
    m_facts.box_diagonal = std::sqrt(sum);
    m_facts.robust_diagonal = internal::robust_diagonal_of_blocks(counts);
  }

  const std::vector<std::pair<internal::Block, std::uint64_t>>& blocks() const { return m_blocks; }
  const internal::Block_lattice& lattice() const { return m_lattice; }
  std::uint64_t number_of_points() const { return m_facts.number_of_points; }
  std::uint64_t number_of_samples() const { return m_parameters.number_of_output_points; }
  double neighbor_radius() const { return m_radius; }
  double sample_spacing() const { return m_sample_spacing * m_radius; }
  const internal::Cloud_facts& facts() const { return m_facts; }
  const std::vector<internal::Tile>& tiles() const { return m_tiles; }
  Source_box box_of_tile(std::size_t tile) const { return source_box(m_tiles[tile].box); }

  /// Estimates spacing and noise from regions all over the cloud: from as many as `bytes` hold, if
  /// that is not all of them.
  template <typename Source>
  internal::Scales estimate_scales(const Source& source, std::uint64_t bytes)
  {
    const std::uint64_t most_points = bytes / bytes_per_point_of_regions;
    std::vector<std::size_t> cores;
    std::vector<internal::Block_box> boxes;
    std::vector<unsigned char> is_core(m_blocks.size(), 0), is_read(m_blocks.size(), 0);
    std::uint64_t number_of_read = 0;
    const auto read_around = [&](std::size_t core) {
      const internal::Block_box around =
        internal::Block_box{m_blocks[core].first, m_blocks[core].first}.grown(1);
      std::uint64_t number_of_new = 0;
      const std::vector<std::size_t> places = blocks_in(around);
      for (const std::size_t b : places)
        number_of_new += is_read[b] ? 0 : m_blocks[b].second;
      if (!cores.empty() && number_of_read + number_of_new > most_points)
        return;
      number_of_read += number_of_new;
      cores.push_back(core);
      is_core[core] = 1;
      for (const std::size_t b : places)
        is_read[b] = 1;
    };
    // the block of one in so many points, so that places count by their points
    const std::uint64_t stride = (std::max)(m_facts.number_of_points / number_of_regions,
                                            std::uint64_t(1));
    std::uint64_t sum = 0, next = 0;
    for (std::size_t b = 0; b < m_blocks.size(); ++b)
    {
      sum += m_blocks[b].second;
      if (next >= sum)
        continue;
      read_around(b);
      next = (sum / stride + 1) * stride;
    }
    Report report;
    watched(report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      internal::Buffer<internal::Vector> points(&memory);
      points.reserve(std::size_t(number_of_read));
      for (std::size_t b = 0; b < m_blocks.size(); ++b)
        if (is_read[b])
          read(source, {m_blocks[b].first, m_blocks[b].first}, 0, points);
      const auto is_in_core = [&](const internal::Vector& p) {
        const internal::Block block = m_lattice.block_of(p);
        const auto place = std::lower_bound(m_blocks.begin(), m_blocks.end(), block,
                                            [](const auto& counted, const internal::Block& other) {
                                              return counted.first < other;
                                            });
        return place != m_blocks.end() && place->first == block
               && is_core[std::size_t(place - m_blocks.begin())] != 0;
      };
      m_facts.scales = internal::scales_of_regions<ConcurrencyTag>(points, is_in_core, m_facts,
                                                                   progress);
    });
    set_radius();
    return m_facts.scales;
  }

  /// Instead of `estimate_scales()`, which has given them another time.
  void set_scales(const internal::Scales& scales)
  {
    m_facts.scales = scales;
    set_radius();
  }

  /// Cuts the cloud into tiles, which with their halos take no more than so many bytes.
  /// \throws std::bad_alloc if a single block takes more
  void make_tiles(std::uint64_t bytes)
  {
    const double samples_per_point = double(number_of_samples()) / double(number_of_points());
    const double bytes_of_point = double(bytes_per_point)
                                  + double(bytes_per_sample) * samples_per_point;
    const internal::Tiling tiling(m_blocks, halo_in_blocks(),
                                  std::uint64_t(double(bytes) / bytes_of_point));
    m_tiles = tiling.tiles();
    if (double(tiling.most_points_of_tile()) * bytes_of_point > double(bytes))
      throw std::bad_alloc();
  }

  /// What the blocks of a tile add to the sums over all blocks, in their order.
  template <typename Source>
  std::vector<internal::Block_share> shares_of_tile(std::size_t tile, const Source& source) const
  {
    const internal::Tile& of_tile = m_tiles[tile];
    std::vector<internal::Block> blocks;
    for (const std::size_t b : blocks_in(of_tile.box))
      blocks.push_back(m_blocks[b].first);
    internal::Parameters parameters = m_parameters;
    parameters.number_of_output_points = (std::max)(
      std::size_t(1), std::size_t(double(of_tile.number_of_points_with_halo)
                                  / double(number_of_points()) * double(number_of_samples())));
    std::vector<internal::Block_share> shares;
    Report report;
    watched(report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      internal::Buffer<internal::Vector> points(&memory);
      read(source, of_tile.box.grown(halo_in_blocks()), of_tile.number_of_points_with_halo, points);
      Solver solver;
      internal::Any_solver<FT> any_solver(solver);
      shares = internal::shares_of_tile<ConcurrencyTag>(points, m_facts, parameters, m_lattice,
                                                        blocks, any_solver, progress, report);
    });
    return shares;
  }

  /// Decides how many samples start where.
  /// \param shares what `shares_of_tile()` has given for each tile
  void set_shares(const std::vector<std::vector<internal::Block_share>>& shares)
  {
    std::vector<std::uint64_t> weights(m_blocks.size(), 0);
    std::vector<double> areas(m_blocks.size(), 0.);
    for (std::size_t tile = 0; tile < m_tiles.size(); ++tile)
    {
      std::size_t k = 0;
      for (const std::size_t b : blocks_in(m_tiles[tile].box))
      {
        weights[b] = shares[tile][k].weight;
        areas[b] = shares[tile][k++].area;
      }
    }
    double area = 0;
    for (const double of_block : areas)
      area += of_block;
    m_numbers = internal::samples_of_blocks(weights, number_of_samples());
    m_sample_spacing = std::sqrt(area / double(number_of_samples()));
  }

  /// The samples that start in a tile.
  template <typename Source>
  Tile_result resample_tile(std::size_t tile, const Source& source) const
  {
    Tile_result result;
    const internal::Block_box box = m_tiles[tile].box, reach = box.grown(halo_in_blocks());
    internal::Samples_of_blocks wanted{m_lattice, {}, {}, m_sample_spacing};
    std::vector<unsigned char> is_own;
    std::uint64_t number_of_own = 0;
    internal::Parameters parameters = m_parameters;
    parameters.number_of_output_points = 0;
    for (const std::size_t b : blocks_in(reach))
    {
      wanted.blocks.push_back(m_blocks[b].first);
      wanted.numbers.push_back(m_numbers[b]);
      is_own.push_back(box.contains(m_blocks[b].first));
      number_of_own += is_own.back() ? m_numbers[b] : 0;
      parameters.number_of_output_points += std::size_t(m_numbers[b]);
    }
    if (number_of_own == 0)
      return result;
    watched(result.report, [&](internal::Progress& progress, internal::Memory_counter& memory) {
      internal::Input input(&memory);
      read(source, reach, m_tiles[tile].number_of_points_with_halo, input.points);
      for (int axis = 0; axis < 3; ++axis)
      {
        input.low[axis] = m_low[std::size_t(axis)];
        input.high[axis] = m_high[std::size_t(axis)];
      }
      result.report.number_of_input_points = input.points.size();
      Solver solver;
      internal::Any_solver<FT> any_solver(solver);
      const internal::Samples_of_tile<FT> samples = internal::resample_tile<ConcurrencyTag>(
        input.points, m_facts, parameters, wanted, any_solver, progress, result.report);
      const internal::Buffer<std::array<double, 3>> positions =
        internal::rounded_positions<ConcurrencyTag, double>(samples.points.positions, input,
                                                            m_radius, true);
      take(samples, positions, is_own, source_box(box), result);
    });
    result.report.number_of_output_points = result.samples.size();
    return result;
  }

  /// What turns the trees of all tiles to one side.
  /// \param evidence of each tile
  internal::Stitching stitching(const std::vector<std::vector<double>>& evidence) const
  {
    return internal::Stitching(sample_spacing(), evidence);
  }

  /// Whether samples of both may lie where the tiles overlap.
  bool are_neighbors(std::size_t a, std::size_t b) const
  {
    const Source_box one = source_box(m_tiles[a].box), other = source_box(m_tiles[b].box);
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
    const Source_box box = source_box(m_tiles[owner].box);
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
  bool are_sides_given() const { return m_parameters.has_viewpoint; }

private:
  static constexpr std::uint64_t number_of_regions = 64;
  static constexpr std::uint64_t bytes_per_point_of_regions = 100;

  void take(const internal::Samples_of_tile<FT>& samples,
            const internal::Buffer<std::array<double, 3>>& positions,
            const std::vector<unsigned char>& is_own, const Source_box& box,
            Tile_result& result) const
  {
    std::vector<std::uint32_t> numbers(positions.size(),
                                       (std::numeric_limits<std::uint32_t>::max)());
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      const auto& normal = samples.points.normals[i];
      Tile_sample sample = {positions[i], {normal[0], normal[1], normal[2]}, 0};
      const bool is_kept = samples.blocks[i] < is_own.size() && is_own[samples.blocks[i]] != 0;
      if (!is_kept && !is_within(sample, box, overlap_width()))
        continue;
      std::uint32_t& number = numbers[samples.trees[i]];
      if (number == (std::numeric_limits<std::uint32_t>::max)())
      {
        number = std::uint32_t(result.evidence.size());
        result.evidence.push_back(0);
      }
      sample.tree = number;
      if (!is_kept)
      {
        result.beyond_border.push_back(sample);
        continue;
      }
      result.evidence[number] += double(samples.confidences[i]) - 0.5;
      result.samples.push_back(sample);
      if (!is_within(sample, box, -overlap_width()))
        result.near_border.push_back(sample);
    }
  }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILED_RESAMPLING_H
