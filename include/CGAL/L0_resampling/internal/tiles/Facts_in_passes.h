// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FACTS_IN_PASSES_H
#define CGAL_L0_RESAMPLING_INTERNAL_FACTS_IN_PASSES_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/cloud/estimate_scale_field.h>
#include <CGAL/L0_resampling/internal/cloud/estimate_scales.h>
#include <CGAL/L0_resampling/internal/core/keep_one_of_each.h>
#include <CGAL/L0_resampling/internal/tiles/Blocks_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Counted_cloud.h>
#include <CGAL/L0_resampling/internal/tiles/Runs_of_codes.h>
#include <CGAL/L0_resampling/internal/tiles/extents_of_source.h>
#include <CGAL/L0_resampling/internal/tiles/facts_of_tile.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Finds the facts of a cloud that is not in memory which its tiles have to know before they look at
its points: in passes over the cloud, tile by tile. They are those that a call for all of it in
memory finds, as what is around a point is in its tile or the halo of that.

\tparam Source model of `L0ResamplingTileSource`
*/
template <typename ConcurrencyTag, typename Source>
class Facts_in_passes
{
  const Counted_cloud& m_cloud;
  const Source& m_source;
  const Parameters& m_parameters;
  double m_bytes; // for the points of a tile
  std::function<bool(double)> m_callback;
  Memory_counter& m_memory;
  Facts_of_cloud m_facts;
  double m_passes_done = 0;

  /// \param passes done since
  bool goes_on(double passes) const
  {
    return !m_callback || m_callback((std::min)((m_passes_done + passes) / number_of_passes, 1.));
  }

  /// Calls `f(progress)`.
  /// \param begin, length of this part, in passes
  template <typename F>
  void watched(double begin, double length, const F& f)
  {
    Report unwanted_report;
    Progress progress([&](double share) { return goes_on(begin + share * length); },
                      unwanted_report, m_memory);
    try
    {
      f(progress);
    }
    catch (const Interrupted&)
    {
      progress.rethrow_exception_of_callback();
      throw;
    }
  }

  /// A pass: calls `f(points, own, progress)` for each of some tiles of the cloud, with the points
  /// of it and around.
  /// \param halo a length, in the unit of the input
  /// \param length as which it counts
  template <typename F>
  void for_each_tile(double halo, const F& f, double length = 1)
  {
    const std::int64_t halo_in_blocks = m_cloud.halo_in_blocks(halo);
    const Tiling tiling(m_cloud.blocks(), halo_in_blocks, {double(bytes_per_point)}, m_bytes);
    if (tiling.maximum_bytes_of_tile() > m_bytes)
      throw std::bad_alloc();
    const std::size_t number_of_tiles = tiling.tiles().size();
    for (std::size_t k = 0; k < number_of_tiles; ++k)
    {
      const Tile& tile = tiling.tiles()[k];
      watched(length * double(k) / double(number_of_tiles), length / double(number_of_tiles),
              [&](Progress& progress) {
                Buffer<Vector> points(&m_memory);
                Blocks_of_tile(m_cloud, tile, halo_in_blocks).read_at_once(m_source, points);
                f(points, Own_blocks{m_cloud.lattice(), tile.box}, progress);
              });
    }
    m_passes_done += length;
  }

  double length_of_input(double length) const
  {
    return std::ldexp(length, -m_facts.extents->exponent_of_input);
  }
  double paper_radius_of_input() const { return length_of_input(paper_radius(*m_facts.extents)); }

  Plan plan() const
  {
    Facts known = *m_facts.extents;
    known.scales = *m_facts.scales;
    return make_plan(m_parameters, known);
  }

  /// The places that tell the scales, in the order of the whole cloud.
  struct Places
  {
    Ranks_of_runs of_balls, of_field;
    std::vector<std::uint64_t> outermost; // of the field
  };

  Places find_places()
  {
    Places places;
    for_each_tile(2 * paper_radius_of_input(),
                  [&](Buffer<Vector>& points, const Own_blocks& own, Progress&) {
                    const Places_of_tile found = count_places<ConcurrencyTag>(points, own, m_facts);
                    places.of_balls.add(found.of_balls);
                    places.of_field.add(found.of_field);
                    places.outermost.insert(places.outermost.end(), found.outermost.begin(),
                                            found.outermost.end());
                  });
    std::vector<std::uint64_t>& codes = places.outermost;
    keep_one_of_each(codes);
    Runs_of_codes(*m_facts.extents)
      .for_each(codes.data(), codes.size(),
                [&](std::uint64_t key, std::size_t first, std::size_t end) {
                  places.of_field.add({{key, end - first}});
                });
    places.of_balls.add_up();
    places.of_field.add_up();
    return places;
  }

  void find_scales(const Ranks_of_runs& ranks)
  {
    const std::size_t few = 6, all = reaches_of_balls.size(); // mostly enough, in narrower halos
    const double end = m_passes_done + 1;
    for (const std::size_t number_of_reaches : {few, all})
    {
      std::vector<Ball_sample> balls;
      const double halo = (reaches_of_balls[number_of_reaches - 1] + 2) * cell_size_of_scales;
      const auto look = [&](Buffer<Vector>& points, const Own_blocks& own, Progress& progress) {
        const std::vector<Ball_sample> found =
          look_at_balls<ConcurrencyTag>(points, own, m_facts, ranks, number_of_reaches, progress);
        balls.insert(balls.end(), found.begin(), found.end());
      };
      for_each_tile(halo * paper_radius_of_input(), look, 0.5); // the other half may be needed
      m_facts.scales = scales_of(balls, stride_of_balls(ranks.total()), number_of_reaches);
      if (m_facts.scales)
        break;
    }
    m_passes_done = end;
  }

  /// \param stride of the smallest balls
  /// \returns nothing if more reaches are needed
  static std::optional<Scales> scales_of(std::vector<Ball_sample>& balls, std::uint64_t stride,
                                         std::size_t number_of_reaches)
  {
    keep_one_of_each([](const Ball_sample& of_place) { return of_place.rank; }, balls);
    std::size_t number_of_looks = 0;
    const Scales scales = scales_of_growing_balls(cell_size_of_scales, [&](int, double) {
      const std::size_t k = (std::min)(number_of_looks++, number_of_reaches - 1);
      std::vector<Ball_of_points> of_reach;
      for (const Ball_sample& of_place : balls)
        if (of_place.has_ball(k, stride))
          of_reach.push_back(of_place.balls[k]);
      return of_reach;
    });
    return number_of_looks <= number_of_reaches ? std::optional<Scales>(scales) : std::nullopt;
  }

  /// Finds the field of scales.
  void find_field(const Places& places, double halo)
  {
    const Plan plan = this->plan();
    if (!plan.follows_scales)
    {
      ++m_passes_done;
      return;
    }
    std::vector<Placed_seed> seeds;
    watched(0, 0, [&](Progress& progress) {
      seeds = seeds_of_outermost<ConcurrencyTag>(places.outermost, m_facts, places.of_field,
                                                 progress);
    });
    for_each_tile(halo, [&](Buffer<Vector>& points, const Own_blocks& own, Progress& progress) {
      const std::vector<Placed_seed> found =
        look_at_seeds<ConcurrencyTag>(points, own, m_facts, places.of_field, progress);
      seeds.insert(seeds.end(), found.begin(), found.end());
    });
    keep_one_of_each([](const Placed_seed& seed) { return seed.code; }, seeds);
    Buffer<std::uint64_t> codes; // what is left of them outlives the call
    Buffer<Seed> known;
    codes.reserve(seeds.size());
    known.reserve(seeds.size());
    for (const Placed_seed& placed : seeds)
    {
      codes.push_back(placed.code);
      known.push_back(placed.seed);
    }
    seeds = {};
    Facts facts = *m_facts.extents;
    facts.scales = *m_facts.scales;
    Morton_places of_seeds(cells_of_places(facts.robust_diagonal), std::move(codes));
    watched(0, 0, [&](Progress& progress) {
      m_facts.field = std::make_shared<const Scale_field>(field_of_seeds<ConcurrencyTag>(
        std::move(of_seeds), known, reference_scales(m_parameters, plan, facts), progress));
    });
  }

public:
  /// What a pass holds for each point of a tile and its halo, and for each of the cloud.
  static constexpr std::uint64_t bytes_per_point = 110, bytes_per_point_of_cloud = 6;
  static constexpr int number_of_passes = 4;

  /// \param bytes for all
  /// \param callback of the user, or none
  /// \throws std::bad_alloc if that is too little for a single tile
  Facts_in_passes(const Counted_cloud& cloud, const Source& source, const Parameters& parameters,
                  std::uint64_t bytes, std::function<bool(double)> callback, Memory_counter& memory)
    : m_cloud(cloud), m_source(source), m_parameters(parameters),
      m_bytes(double(bytes) - double(bytes_per_point_of_cloud) * double(cloud.number_of_points())),
      m_callback(std::move(callback)), m_memory(memory)
  {}

  /// \param halo_in_radii around a tile, once the radius is known
  Facts_of_cloud find(double halo_in_radii)
  {
    m_facts = extents_of_source(m_cloud, m_source, [&](double share) {
      if (!goes_on(share))
        throw Interrupted();
    });
    ++m_passes_done;
    const Places places = find_places();
    find_scales(places.of_balls);
    find_field(places, halo_in_radii * length_of_input(plan().unit));
    return std::move(m_facts);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FACTS_IN_PASSES_H
