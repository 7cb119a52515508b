// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CHOOSE_SAMPLES_H
#define CGAL_L0_RESAMPLING_INTERNAL_CHOOSE_SAMPLES_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/cloud/areas_of_points.h>
#include <CGAL/L0_resampling/internal/cloud/prepare_points.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/L0_resampling/internal/samples/Duplicate_samples.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>
#include <CGAL/L0_resampling/internal/samples/initialize_samples.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Samples can start in crowds: where points do, or where many more samples are asked for than
/// there are points. Removes the samples of each crowd but for a few, which the others follow.
/// \param scales of the points; none if all are 1
/// \param samples sorted for a grid of cells of size `plan.cell_size`, before and after
/// \param spreading_radii of the samples, where they have their own, before and after
template <typename ConcurrencyTag>
Duplicate_samples take_followers(const Plan& plan, const Buffer<float>& scales,
                                 Initial_samples& samples, Buffer<float>& spreading_radii)
{
  const std::size_t m = samples.positions.size();
  Duplicate_samples followers(samples.positions.get_allocator());
  // a crowd in the smaller cells is one in these too
  if (scales.empty() && spreading_radii.empty()
      && !Crowded_cells(Search_grid_3(samples.positions, plan.cell_size), samples.positions,
                        maximum_number_of_samples_of_subcell)
            .are_there_any<ConcurrencyTag>())
    return followers;
  const Sorted_queries sorted(ConcurrencyTag(), samples.positions,
                              Cell_sizes(plan.self_cell_size(), spreading_radii));
  const Buffer<Index>& order = sorted.order;
  const Representatives kept = thin_crowds<ConcurrencyTag>(sorted.grid, sorted.points,
                                                           maximum_number_of_samples_of_subcell);
  if (kept.are_all_points())
    return followers;

  Representatives in_old_order{filled_buffer(m, Index(0), order.get_allocator())};
  for_each_in_order(m, [&](std::size_t i) {
    in_old_order.of_points[order[i]] = order[kept.of_points[i]];
  });
  Buffer<Index> places(order.get_allocator()); // of the kept ones among themselves
  places.reserve(m);
  Index number_of_kept = 0;
  for_each_in_order(m, [&](std::size_t i) {
    places.push_back(in_old_order.is_kept(i) ? number_of_kept++ : 0);
  });
  followers.leaders.reserve(m - number_of_kept);
  followers.offsets.reserve(m - number_of_kept);
  followers.sources.reserve(m - number_of_kept);
  for_each_in_order(m, [&](std::size_t i) {
    const Index leader = in_old_order.of_points[i];
    if (leader == i)
      return;
    followers.leaders.push_back(places[leader]);
    followers.offsets.push_back(samples.positions[i] - samples.positions[leader]);
    followers.sources.push_back(samples.sources[i]);
  });
  followers.numbers_of_samples = in_old_order.numbers_of_points();
  in_old_order.keep(samples.positions);
  in_old_order.keep(samples.sources);
  in_old_order.keep(spreading_radii);
  return followers;
}

/// The samples where they start, and those that are not worked on.
struct Placed_samples
{
  Initial_samples start;
  Buffer<float> spreading_radii; ///< where the density of the input is kept; else none
  Duplicate_samples followers;
};

/// Finds how far the samples spread, where that differs, and which of them follow others.
/// \param areas that the points stand for, if the plan uses them
/// \param facts the number of points: given, or found here
template <typename ConcurrencyTag>
Placed_samples with_followers(const Plan& plan, const Prepared_points& input, const Areas& areas,
                              Facts_of_cloud& facts, Initial_samples start)
{
  Buffer<float> spreading_radii(input.points.get_allocator());
  if (plan.keeps_spacings)
  {
    const std::size_t n = known_or_found(facts.number_of_points,
                                         [&]() { return input.points.size(); });
    const double points_per_sample = double(n) / double(plan.number_of_samples);
    for_each_in_order(start.sources.size(), [&](std::size_t i) {
      const double area = areas.of_point(start.sources[i]) * points_per_sample;
      spreading_radii.push_back(spreading_radius_of(area, plan.spreading_radius()));
    });
  }
  Duplicate_samples followers = take_followers<ConcurrencyTag>(plan, input.scales, start,
                                                               spreading_radii);
  return {std::move(start), std::move(spreading_radii), std::move(followers)};
}

/// The points that samples start on, or near.
/// \param areas that the points stand for, if the plan uses them
/// \param facts the area that samples start on, and the number of places: given, or found here
inline Sources choose_sources(const Plan& plan, const Prepared_points& input, const Areas& areas,
                              Facts_of_cloud& facts)
{
  const Buffer<std::uint64_t> no_areas(input.points.get_allocator());
  const Buffer<Index> distinct = distinct_points(input.points);
  known_or_found(facts.number_of_places, [&]() { return distinct.size(); });
  return sources_of_samples(distinct, plan.starts_evenly ? areas.units : no_areas,
                            plan.number_of_samples, plan.random_seed, facts.units_of_starts);
}

/// Where samples start.
/// Parameters are those of `with_followers()`.
/// \param sources what `choose_sources()` has found
template <typename ConcurrencyTag>
Placed_samples place_samples(const Plan& plan, const Prepared_points& input, const Areas& areas,
                             Facts_of_cloud& facts, Sources sources, Progress& progress)
{
  const Cloud_indices own_indices{Buffer<Index>(input.points.get_allocator())};
  return with_followers<ConcurrencyTag>(
    plan, input, areas, facts,
    start_samples<ConcurrencyTag>(input.grid, input.points, input.normals, own_indices,
                                  std::move(sources), plan.radius, plan.isolated_radius,
                                  plan.random_seed, progress));
}

/// Section 3.2: the first S, where they are placed.
/// \param cloud_index of the points
/// \param facts the number of places is known
/// \param hints used up
/// \param samples out: all but what the fit finds
/// \returns the samples that follow others
template <typename FT>
Duplicate_samples take_samples(const Plan& plan, const Prepared_points& input,
                               const Cloud_indices& cloud_index, Placed_samples placed,
                               const Facts_of_cloud& facts, Buffer<Local_vector>& hints,
                               Samples<FT>& samples)
{
  const Buffer<Vector>& points = input.points;
  Initial_samples& start = placed.start;
  samples.positions = std::move(start.positions);
  const std::size_t size = samples.positions.size();
  samples.normals.reserve(size);
  const auto for_each_source = [&](const auto& f) {
    for_each_in_order(size, [&](std::size_t i) { f(start.sources[i]); });
  };
  for_each_source([&](Index source) {
    samples.normals.push_back(input.normals[source].cast<FT>().normalized());
  });
  if (!input.scales.empty())
    for_each_source([&](Index source) { samples.scales.push_back(input.scales[source]); });
  if (!input.noise_ratios.empty())
    for_each_source(
      [&](Index source) { samples.noise_ratios.push_back(input.noise_ratios[source]); });
  samples.spreading_radii = std::move(placed.spreading_radii);
  if (plan.refines)
  {
    const auto starts_on_point = [&](std::size_t i) {
      return samples.positions[i] == points[start.sources[i]];
    };
    const Support_subset choice(plan.random_seed, plan.radius, plan.sample_spacing,
                                plan.number_of_samples, *facts.number_of_places);
    samples.are_support_points.reserve(size);
    for_each_in_order(size, [&](std::size_t i) {
      samples.are_support_points.push_back(starts_on_point(i)
                                           && choice.takes(cloud_index(start.sources[i])));
    });
    fill_buffer(size, FT(0), samples.fit_variances);
    fill_buffer(size, typename Samples<FT>::Local_vector(Samples<FT>::Local_vector::Zero()),
                samples.outward_directions);
  }
  if (!hints.empty())
    for_each_source(
      [&](Index source) { samples.hints.push_back(hints[source].template cast<FT>()); });
  release(hints);
  if (!placed.followers.is_empty())
    for_each_in_order(size, [&](std::size_t i) { samples.start_indices.push_back(Index(i)); });
  fill_buffer(size, FT(0), samples.fit_weights);
  samples.fit_centroids = copy_of(samples.positions);
  return std::move(placed.followers);
}

/// Section 3.2: the first S. Parameters and result are those of `place_samples()` and
/// `take_samples()`.
template <typename ConcurrencyTag, typename FT>
Duplicate_samples choose_samples(const Plan& plan, const Prepared_points& input, const Areas& areas,
                                 Facts_of_cloud& facts, Sources sources,
                                 Buffer<Local_vector>& hints, Progress& progress,
                                 Samples<FT>& samples)
{
  const Cloud_indices own_indices{Buffer<Index>(input.points.get_allocator())};
  return take_samples(plan, input, own_indices,
                      place_samples<ConcurrencyTag>(plan, input, areas, facts, std::move(sources),
                                                    progress),
                      facts, hints, samples);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CHOOSE_SAMPLES_H
