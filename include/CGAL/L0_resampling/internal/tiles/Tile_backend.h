// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H
#define CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H

#include <CGAL/L0_resampling/internal/tiles/Block_counts.h>
#include <CGAL/L0_resampling/internal/driver/Cpu_backend.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What a tile has to know of the whole cloud. Lengths in the unit of the input.
struct Cloud_facts
{
  std::uint64_t number_of_points = 0;
  double box_diagonal = 0;
  double robust_diagonal = 0; ///< without far outliers
  Scales scales = {0, 0};     ///< usual ones, in units of the paper's radius
  double step_of_origins = 0; ///< of the frames of tiles: many cells of their grids
};

/// How many samples start in each block of a tile and its halo.
struct Samples_of_blocks
{
  Block_lattice lattice;
  std::vector<Block> blocks; ///< sorted
  std::vector<std::uint64_t> numbers;
  double sample_spacing; ///< of the whole cloud, in units of r_p

  /// Its place in the list, or the size of the list.
  std::size_t find(const Block& block) const
  {
    const auto place = std::lower_bound(blocks.begin(), blocks.end(), block);
    return std::size_t((place != blocks.end() && *place == block ? place : blocks.end())
                       - blocks.begin());
  }
};

/// What a block adds to the sums over all blocks.
struct Block_share
{
  std::uint64_t weight = 0; ///< of its samples among all
  double area = 0;          ///< in units of \f$ r_p^2 \f$
};

/*!
The stages for a part of a cloud: what they have to know of the whole is given, and so many samples
start in each block as is given. `run()` calls them as those of `Cpu_backend`.
*/
template <typename ConcurrencyTag, typename FT>
class Tile_backend : public Cpu_backend<ConcurrencyTag, FT>
{
  using Base = Cpu_backend<ConcurrencyTag, FT>;
  using Base::m_areas;
  using Base::m_followers;
  using Base::m_frame;
  using Base::m_hints;
  using Base::m_input;
  using Base::m_progress;
  using Base::m_report;
  using Base::m_samples;

  const Cloud_facts& m_cloud;
  const Samples_of_blocks* m_samples_of_blocks = nullptr;
  Buffer<Index> m_start_blocks; // of the samples in their first order
  Buffer<Index> m_blocks;       // of the samples of the result
  Buffer<Index> m_trees;        // likewise: those of the orientation
  Buffer<float> m_confidences;  // likewise

  /// Those that do not depend on the frame, which each tile has its own of.
  static Facts_of_cloud known_facts(const Cloud_facts& cloud)
  {
    Facts_of_cloud facts;
    facts.scales = cloud.scales;
    return facts;
  }

  Block block_of(const Block_lattice& lattice, std::size_t i) const
  {
    return lattice.block_of(m_frame.leave(m_input.points[i]));
  }

  /// The distinct points by blocks, the place of which is looked up.
  template <typename PlaceOf>
  std::vector<std::vector<Index>> points_by_blocks(const Block_lattice& lattice,
                                                   std::size_t number_of_blocks,
                                                   const Buffer<Index>& distinct,
                                                   const PlaceOf& place_of) const
  {
    std::vector<std::vector<Index>> lists(number_of_blocks);
    for (const Index i : distinct)
    {
      const std::size_t place = place_of(block_of(lattice, i));
      if (place < number_of_blocks)
        lists[place].push_back(i);
    }
    return lists;
  }

  /// Puts the points of a block into an order that is the same in each tile: that of the cells of a
  /// lattice in the block, along a Morton curve.
  void sort_by_places(const Block_lattice& lattice, std::vector<Index>& points) const
  {
    const int bits = 10; // of each axis
    const Block_lattice cells(lattice.exponent() - bits);
    std::vector<std::pair<std::uint64_t, Index>> keys;
    keys.reserve(points.size());
    for (const Index i : points)
    {
      std::uint64_t key = 0;
      const Block cell = block_of(cells, i);
      for (int bit = bits - 1; bit >= 0; --bit)
        for (const std::int64_t place : cell)
          key = key << 1 | (std::uint64_t(place) >> bit & 1);
      keys.emplace_back(key, i);
    }
    std::sort(keys.begin(), keys.end(), [&](const auto& a, const auto& b) {
      const Vector &p = m_input.points[a.second], &q = m_input.points[b.second];
      return a.first != b.first
               ? a.first < b.first
               : std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    });
    for (std::size_t k = 0; k < points.size(); ++k)
      points[k] = keys[k].second;
  }

  Sources sources_of_block(const Plan& plan, const Buffer<Index>& points, std::uint64_t m,
                           const Block& block) const
  {
    std::uint64_t seed = plan.random_seed;
    for (const std::int64_t place : block)
      seed = random_bits(seed, std::uint64_t(place));
    std::optional<std::uint64_t> total; // of this block
    return plan.starts_evenly ? sources_by_area(points, m_areas.units, m, seed, total)
                              : sources_by_points(points, m, seed);
  }

public:
  Tile_backend(const Cloud_facts& facts, Buffer<Vector>& points, Buffer<Local_vector>& no_normals,
               Buffer<Local_vector>& hints, const Parameters& parameters, Any_solver<FT>& solver,
               Progress& progress, Report& report)
    : Base(points, no_normals, hints, parameters, solver, progress, report, known_facts(facts)),
      m_cloud(facts), m_start_blocks(points.get_allocator()), m_blocks(points.get_allocator()),
      m_trees(points.get_allocator()), m_confidences(points.get_allocator())
  {}

  /// Before `run()`.
  void set_samples_of_blocks(const Samples_of_blocks& samples) { m_samples_of_blocks = &samples; }

  Facts find_facts()
  {
    Facts facts = Base::find_facts(m_cloud.step_of_origins);
    facts.number_of_points = std::size_t(m_cloud.number_of_points);
    facts.box_diagonal = std::ldexp(m_cloud.box_diagonal, facts.exponent_of_input);
    facts.robust_diagonal = std::ldexp(m_cloud.robust_diagonal, facts.exponent_of_input);
    return facts;
  }

  /// What each block adds to the whole; for the points as they are once they are prepared.
  /// \param blocks sorted
  std::vector<Block_share> shares_of_blocks(const Plan& plan, const Block_lattice& lattice,
                                            const std::vector<Block>& blocks)
  {
    Base::total_area(plan);
    const Samples_of_blocks places{lattice, blocks, {}, 0};
    const std::vector<std::vector<Index>> lists =
      points_by_blocks(lattice, blocks.size(), distinct_points(m_input.points),
                       [&](const Block& block) { return places.find(block); });
    std::vector<Block_share> shares(blocks.size());
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      std::uint64_t units = 0;
      for (const Index i : lists[b])
        units += m_areas.units[i];
      shares[b] = {plan.starts_evenly ? units : lists[b].size(),
                   double(units) * m_areas.area_per_unit};
    }
    return shares;
  }

  /// That of as many samples as start here, in the density that they have everywhere.
  double total_area(const Plan& plan)
  {
    Base::total_area(plan);
    return square(m_samples_of_blocks->sample_spacing) * double(plan.number_of_samples);
  }

  void choose_samples(const Plan& plan)
  {
    const auto allocator = m_input.points.get_allocator();
    const Samples_of_blocks& wanted = *m_samples_of_blocks;
    const Buffer<Index> distinct = distinct_points(m_input.points);
    std::vector<std::vector<Index>> lists =
      points_by_blocks(wanted.lattice, wanted.blocks.size(), distinct,
                       [&](const Block& block) { return wanted.find(block); });
    Sources sources{Buffer<Index>(allocator), Buffer<Index>(allocator)};
    Buffer<Index> block_of_point = filled_buffer(m_input.points.size(), Index(wanted.blocks.size()),
                                                 allocator);
    for (std::size_t b = 0; b < lists.size(); ++b)
    {
      if (lists[b].empty() || wanted.numbers[b] == 0)
        continue;
      sort_by_places(wanted.lattice, lists[b]);
      const Buffer<Index> points(lists[b].begin(), lists[b].end(), allocator);
      for (const Index i : points)
        block_of_point[i] = Index(b);
      const Sources of_block = sources_of_block(plan, points, wanted.numbers[b], wanted.blocks[b]);
      for (const auto& [from, to] :
           {std::make_pair(&of_block.on_points, &sources.on_points),
            std::make_pair(&of_block.between_points, &sources.between_points)})
        to->insert(to->end(), from->begin(), from->end());
    }
    std::sort(sources.on_points.begin(), sources.on_points.end());
    std::sort(sources.between_points.begin(), sources.between_points.end());

    Initial_samples start =
      start_samples<ConcurrencyTag>(m_input.grid, m_input.points, m_input.normals, distinct,
                                    std::move(sources), plan.radius, plan.random_seed, m_progress);
    Placed_samples placed = with_followers<ConcurrencyTag>(plan, m_input, m_areas,
                                                           std::move(start));
    m_start_blocks.reserve(placed.start.sources.size());
    for (const Index source : placed.start.sources)
      m_start_blocks.push_back(block_of_point[source]);
    m_blocks.reserve(placed.start.sources.size() + placed.followers.sources.size());
    for (const Index source : placed.followers.sources)
      m_blocks.push_back(block_of_point[source]); // the others come before them at the end
    m_followers = take_samples(plan, m_input, std::move(placed), m_hints, m_samples);
    if (m_samples.start_indices.empty())
      for_each_in_order(m_samples.positions.size(),
                        [&](std::size_t i) { m_samples.start_indices.push_back(Index(i)); });
    release(m_areas.units);
  }

  void orient_normals(const Plan& plan)
  {
    const Orientation orientation = Base::orient_normals(plan);
    m_confidences = copy_of(orientation.confidences);
    m_trees.reserve(m_confidences.size());
    for_each_in_order(m_confidences.size(), [&](std::size_t i) {
      m_trees.push_back(orientation.trees.find(Index(i)).first);
    });
  }

  void append_followers()
  {
    const Buffer<Index> of_followers = std::move(m_blocks);
    m_blocks = Buffer<Index>(m_trees.get_allocator());
    m_blocks.reserve(m_samples.start_indices.size() + of_followers.size());
    for (const Index start : m_samples.start_indices)
      m_blocks.push_back(m_start_blocks[start]);
    m_blocks.insert(m_blocks.end(), of_followers.begin(), of_followers.end());
    m_followers.append_values(m_samples.start_indices, m_trees);
    m_followers.append_values(m_samples.start_indices, m_confidences);
    Base::append_followers();
  }

  const Buffer<Index>& blocks() const { return m_blocks; }
  const Buffer<Index>& trees() const { return m_trees; }
  const Buffer<float>& confidences() const { return m_confidences; }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_TILE_BACKEND_H
