// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_TILE_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_TILE_IMPL_H

#include <CGAL/L0_resampling/internal/cloud/estimate_scale_field.h>
#include <CGAL/L0_resampling/internal/cloud/estimate_scales.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/keep_one_of_each.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/tiles/Runs_of_codes.h>
#include <CGAL/L0_resampling/internal/tiles/facts_of_tile.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The seeds among some places of a cloud.
/// \param are_wanted called with the key of a run: whether its seeds are to be found
template <typename ConcurrencyTag, typename Wanted>
std::vector<Placed_seed> seeds_among(const Morton_places& places, const Runs_of_codes& runs,
                                     const Ranks_of_runs& ranks, const Wanted& are_wanted,
                                     Progress& progress)
{
  const Morton_points view = places.view();
  std::vector<std::size_t> seeds; // of the places
  runs.for_each(view.codes, view.size, [&](std::uint64_t key, std::size_t first, std::size_t end) {
    if (!are_wanted(key))
      return;
    const std::uint64_t rank = *ranks.first_of(key), stride = points_of_seed;
    for (std::uint64_t i = first + (stride - rank % stride) % stride; i < end; i += stride)
      seeds.push_back(std::size_t(i));
  });
  std::vector<Placed_seed> found(seeds.size());
  for_each_seed<ConcurrencyTag>(seeds.size(), progress, [&](std::size_t k) {
    found[k] = {view.codes[seeds[k]], seed_at(One_thread(), view, seeds[k])};
  });
  return found;
}

/// The values of some points, mostly each of them once.
/// \param value_of called with the index of a point; gives nothing for some
template <typename ConcurrencyTag, typename ValueOf>
Buffer<std::uint64_t> values_of_points(std::size_t number_of_points, const ValueOf& value_of)
{
  const std::size_t points_per_block = 65536;
  return append_by_blocks<ConcurrencyTag>(
    number_of_points, points_per_block, Counting_allocator<std::uint64_t>(),
    [&](std::size_t begin, std::size_t end, Buffer<std::uint64_t>& values) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::optional<std::uint64_t> value = value_of(i);
        if (value && (values.empty() || values.back() != *value)) // as for most points
          values.push_back(*value);
      }
      keep_one_of_each(values);
    });
}

/// The keys of some runs.
class Set_of_runs
{
  Buffer<std::uint64_t> m_keys; // ascending

public:
  /// \param key_of called with the index of a point; gives the key of its run, if that is wanted
  template <typename ConcurrencyTag, typename KeyOf>
  Set_of_runs(ConcurrencyTag, std::size_t number_of_points, const KeyOf& key_of)
    : m_keys(values_of_points<ConcurrencyTag>(number_of_points, key_of))
  {
    keep_one_of_each(m_keys);
  }

  bool holds(std::uint64_t key) const
  {
    return std::binary_search(m_keys.begin(), m_keys.end(), key);
  }
};

/// The runs of `Points_of_scales` that have points of a tile's own.
/// \param points in the frame
/// \param radius the paper's
template <typename ConcurrencyTag>
Set_of_runs own_runs_of_balls(const Buffer<Vector>& points, const Buffer<unsigned char>& are_own,
                              double radius)
{
  return {ConcurrencyTag(), points.size(), [&](std::size_t i) -> std::optional<std::uint64_t> {
            if (are_own[i] == 0)
              return std::nullopt;
            return Search_grid_3::key_of_run(
              points[i].unaryExpr([&](double x) { return x / radius; }), cell_size_of_scales);
          }};
}

/// The runs of codes that have points of a tile's own.
/// \param points in the frame
template <typename ConcurrencyTag>
Set_of_runs own_runs_of_field(const Buffer<Vector>& points, const Buffer<unsigned char>& are_own,
                              const Runs_of_codes& runs)
{
  return {ConcurrencyTag(), points.size(), [&](std::size_t i) -> std::optional<std::uint64_t> {
            if (are_own[i] == 0)
              return std::nullopt;
            return runs.key_of(runs.cells().code(points[i].data()));
          }};
}

/// The codes of a tile's own points in the outermost runs.
/// \param points in the frame
template <typename ConcurrencyTag>
Buffer<std::uint64_t> own_outermost_codes(const Buffer<Vector>& points,
                                          const Buffer<unsigned char>& are_own,
                                          const Runs_of_codes& runs)
{
  return values_of_points<ConcurrencyTag>(
    points.size(), [&](std::size_t i) -> std::optional<std::uint64_t> {
      if (are_own[i] == 0)
        return std::nullopt;
      const std::uint64_t code = runs.cells().code(points[i].data());
      return runs.is_outermost(runs.key_of(code)) ? std::optional<std::uint64_t>(code)
                                                  : std::nullopt;
    });
}

template <typename ConcurrencyTag>
Places_of_tile count_places(Buffer<Vector>& points, const Own_blocks& own,
                            const Facts_of_cloud& facts)
{
  Places_of_tile found;
  const double radius = paper_radius(*facts.extents);
  const Runs_of_codes runs_of_codes(*facts.extents);
  const Buffer<unsigned char> are_own = own.flags_of<ConcurrencyTag>(points);
  Working_frame().enter<ConcurrencyTag>(points, *facts.frame);
  {
    const Set_of_runs own_runs = own_runs_of_balls<ConcurrencyTag>(points, are_own, radius);
    const Points_of_scales of_scales(ConcurrencyTag(), points, radius);
    for_each_run(of_scales.grid(), [&](std::uint64_t key, const Search_grid_3::Range& range) {
      if (own_runs.holds(key))
        found.of_balls.push_back({key, range.second - range.first});
    });
  }
  const Buffer<std::uint64_t> outermost = own_outermost_codes<ConcurrencyTag>(points, are_own,
                                                                              runs_of_codes);
  found.outermost.assign(outermost.begin(), outermost.end());
  const Set_of_runs own_runs = own_runs_of_field<ConcurrencyTag>(points, are_own, runs_of_codes);
  const Morton_places places = places_of<ConcurrencyTag>(points, runs_of_codes.cells());
  const Morton_points view = places.view();
  runs_of_codes.for_each(view.codes, view.size,
                         [&](std::uint64_t key, std::size_t first, std::size_t end) {
                           if (own_runs.holds(key) && !runs_of_codes.is_outermost(key))
                             found.of_field.push_back({key, end - first});
                         });
  return found;
}

template <typename ConcurrencyTag>
std::vector<Ball_sample> look_at_balls(Buffer<Vector>& points, const Own_blocks& own,
                                       const Facts_of_cloud& facts, const Ranks_of_runs& of_balls,
                                       std::size_t number_of_reaches, Progress& progress)
{
  std::vector<Ball_sample> found;
  const double radius = paper_radius(*facts.extents);
  const Buffer<unsigned char> are_own = own.flags_of<ConcurrencyTag>(points);
  Working_frame().enter<ConcurrencyTag>(points, *facts.frame);
  const Set_of_runs own_runs = own_runs_of_balls<ConcurrencyTag>(points, are_own, radius);
  const Points_of_scales of_scales(ConcurrencyTag(), points, radius);
  Buffer<Vector> queries(points.get_allocator());
  const std::uint64_t stride = stride_of_balls(of_balls.total());
  for_each_run(of_scales.grid(), [&](std::uint64_t key, const Search_grid_3::Range& range) {
    if (!own_runs.holds(key))
      return;
    std::uint64_t rank = *of_balls.first_of(key);
    for (Index i = range.first; i < range.second; ++i, ++rank)
      if (rank % stride == 0)
      {
        queries.push_back(of_scales.points()[i]);
        found.push_back({rank, {}});
      }
  });
  for (std::size_t k = 0; k < number_of_reaches; ++k)
  {
    Buffer<Vector> of_reach(points.get_allocator());
    std::vector<Ball_of_points*> balls_of_reach;
    for (std::size_t i = 0; i < queries.size(); ++i)
      if (found[i].has_ball(k, stride))
      {
        of_reach.push_back(queries[i]);
        balls_of_reach.push_back(&found[i].balls[k]);
      }
    if (of_reach.empty())
      continue;
    const std::vector<Ball_of_points> balls =
      of_scales.balls_around<ConcurrencyTag, Local>(of_reach, reaches_of_balls[k], progress);
    for (std::size_t i = 0; i < balls.size(); ++i)
      *balls_of_reach[i] = balls[i];
  }
  return found;
}

template <typename ConcurrencyTag>
std::vector<Placed_seed> look_at_seeds(Buffer<Vector>& points, const Own_blocks& own,
                                       const Facts_of_cloud& facts, const Ranks_of_runs& of_field,
                                       Progress& progress)
{
  const Runs_of_codes runs_of_codes(*facts.extents);
  const Buffer<unsigned char> are_own = own.flags_of<ConcurrencyTag>(points);
  Working_frame().enter<ConcurrencyTag>(points, *facts.frame);
  const Set_of_runs own_runs = own_runs_of_field<ConcurrencyTag>(points, are_own, runs_of_codes);
  return seeds_among<ConcurrencyTag>(
    places_of<ConcurrencyTag>(points, runs_of_codes.cells()), runs_of_codes, of_field,
    [&](std::uint64_t key) { return own_runs.holds(key) && !runs_of_codes.is_outermost(key); },
    progress);
}

template <typename ConcurrencyTag>
std::vector<Placed_seed> seeds_of_outermost(const std::vector<std::uint64_t>& codes,
                                            const Facts_of_cloud& facts,
                                            const Ranks_of_runs& of_field, Progress& progress)
{
  const Runs_of_codes runs(*facts.extents);
  return seeds_among<ConcurrencyTag>(
    Morton_places(runs.cells(), Buffer<std::uint64_t>(codes.begin(), codes.end())), runs, of_field,
    [](std::uint64_t) { return true; }, progress);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FACTS_OF_TILE_IMPL_H
