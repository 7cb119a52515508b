// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_INITIALIZE_SAMPLES_H
#define CGAL_L0_RESAMPLING_INTERNAL_INITIALIZE_SAMPLES_H

#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Start_near_source.h>
#include <CGAL/L0_resampling/internal/kernels/exact_ball.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The first S: where the samples start, and the input point each takes its normal from.
struct Initial_samples
{
  Buffer<Vector> positions;
  Buffer<Index> sources;
};

/// The numbers of points in the order of the whole cloud, which random choices go by.
struct Cloud_indices
{
  Buffer<Index> of_points; ///< none if the points are the whole cloud

  Index operator()(Index i) const { return of_points.empty() ? i : of_points[i]; }
};

/// Moves each of the new samples, which start on their source, away from it as `Start_near_source`
/// says: part of the way to another point of its ball, if there is one.
/// \param isolated_radius of the ball around a source that is alone
template <typename ConcurrencyTag, typename T>
void move_near_sources(const Search_grid_3& grid, const Buffer<Vector>& points,
                       const Buffer<Eigen::Matrix<T, 3, 1>>& normals,
                       const Cloud_indices& cloud_index, double radius, double isolated_radius,
                       std::uint64_t seed, Progress& progress, Initial_samples& samples)
{
  const Buffer<Vector> starts = copy_of(samples.positions);
  const Buffer<float> start_scales = listed_scales(grid.scales(), samples.sources);
  const Search_grid_3 start_grid(starts, Cell_sizes(grid.cell_size(), start_scales));

  const auto make_visitor = [&]() {
    return [&](Search_grid_3::Range queries, const Local_points<T>& candidates,
               const Vector& origin) {
      for (Index e = queries.first; e < queries.second; ++e)
      {
        const Index source = samples.sources[e];
        const Eigen::Matrix<T, 3, 1> center = (starts[e] - origin).template cast<T>();
        const auto first = std::lower_bound(samples.sources.begin(), samples.sources.end(), source);
        const Start_near_source start(seed, cloud_index(source),
                                      e - std::uint64_t(first - samples.sources.begin()));
        Index partner = source;
        std::uint64_t best = 0;
        for (std::size_t k = 0; k < candidates.indices.size(); ++k)
        {
          const Index j = candidates.indices[k];
          const Eigen::Matrix<T, 3, 1> d =
            Eigen::Matrix<T, 3, 1>(candidates.x[k], candidates.y[k], candidates.z[k]) - center;
          const T squared_distance = d.squaredNorm();
          if (squared_distance >= T(square(radius * start_grid.scale(e))) || points[j] == starts[e])
            continue;
          const std::uint64_t rank = start.rank(cloud_index(j), normals[source].dot(normals[j]),
                                                normals[j].dot(d), squared_distance);
          if (rank > best)
          {
            best = rank;
            partner = j;
          }
        }
        if (best > 0)
        {
          samples.positions[e] += start.share_of_way() * (points[partner] - starts[e]);
          continue;
        }
        const Vector normal = normals[source].template cast<double>();
        const Triple offset = start.offset_from_lone({normal[0], normal[1], normal[2]},
                                                     isolated_radius * start_grid.scale(e));
        samples.positions[e] += Vector(offset.x, offset.y, offset.z);
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(start_grid, starts, grid, points,
                                   cells_in_reach(radius, grid.cell_size()), progress,
                                   make_visitor);
}

/// Where samples start: on a point, or near it.
struct Sources
{
  Buffer<Index> on_points, near_points;
};

/// How many of the m thresholds are below a sum of areas.
inline std::uint64_t thresholds_below(std::uint64_t sum, std::uint64_t m, std::uint64_t seed,
                                      std::uint64_t total)
{
  std::uint64_t k = 0;
  for (std::uint64_t count = m; count > 0;)
  {
    const std::uint64_t half = count / 2;
    const bool is_below = area_threshold(k + half, m, seed, total) < sum;
    k = is_below ? k + half + 1 : k;
    count = is_below ? count - half - 1 : half;
  }
  return k;
}

/// Shares the samples out by area: each point gets as many as there are thresholds, one at random
/// in each of m equal parts of the whole area, in the part of the area that is its own. The first
/// starts on it.
/// \param distinct some of the points of the cloud, which follow each other in its order
/// \param areas one number a point, positive, so that all processors add them up alike
/// \param sum of the areas before them
/// \param total of the areas of the cloud
inline void add_sources_by_area(const Buffer<Index>& distinct, const Buffer<std::uint64_t>& areas,
                                std::uint64_t sum, std::uint64_t total, std::uint64_t m,
                                std::uint64_t seed, Sources& sources)
{
  std::uint64_t k = thresholds_below(sum, m, seed, total);
  for_each_in_order(distinct.size(), [&](std::size_t d) {
    const Index i = distinct[d];
    sum += areas[i];
    // the last one takes what rounding leaves
    for (bool is_first = true; k < m && (sum == total || area_threshold(k, m, seed, total) < sum);
         is_first = false, ++k)
      (is_first ? sources.on_points : sources.near_points).push_back(i);
  });
}

/// Shares the samples out by points: no more than one each, one of each of m parts of nearly equal
/// length; or, if there are more samples than points, one at least.
/// \param distinct some of the points of the cloud, which follow each other in its order
/// \param rank of the first of them among the distinct points of the cloud
/// \param n how many these are
inline void add_sources_by_points(const Buffer<Index>& distinct, std::uint64_t rank,
                                  std::uint64_t n, std::uint64_t m, std::uint64_t seed,
                                  Sources& sources)
{
  // products are below 2^64, as all factors are below 2^32
  const std::uint64_t end = rank + distinct.size();
  const auto ceiling = [](std::uint64_t a, std::uint64_t b) { return (a + b - 1) / b; };
  if (m <= n)
  {
    const std::uint64_t first = ((rank + 1) * m - 1) / n, // the part that the first point is in
      behind = (std::min)(ceiling(end * m, n), m);
    for_each_in_order(behind - first, [&](std::uint64_t part) {
      const std::uint64_t k = first + part, begin_of_part = k * n / m,
                          end_of_part = (k + 1) * n / m,
                          place = begin_of_part
                                  + random_bits(seed, k) % (end_of_part - begin_of_part);
      if (place >= rank && place < end)
        sources.on_points.push_back(distinct[std::size_t(place - rank)]);
    });
    return;
  }
  sources.on_points.insert(sources.on_points.end(), distinct.begin(), distinct.end());
  const std::uint64_t number_of_new = m - n, first = ceiling(rank * number_of_new, n),
                      behind = ceiling(end * number_of_new, n);
  for_each_in_order(behind - first, [&](std::uint64_t e) {
    sources.near_points.push_back(distinct[std::size_t((first + e) * n / number_of_new - rank)]);
  });
}

/// Where samples start of a cloud.
/// \param areas none if samples spread as the points do
/// \param known_total of the areas: of a larger cloud, of which these are the first points, or
/// found here
inline Sources sources_of_samples(const Buffer<Index>& distinct, const Buffer<std::uint64_t>& areas,
                                  std::uint64_t m, std::uint64_t seed,
                                  std::optional<std::uint64_t>& known_total)
{
  Sources sources{Buffer<Index>(distinct.get_allocator()), Buffer<Index>(distinct.get_allocator())};
  sources.on_points.reserve((std::min)(std::size_t(m), distinct.size()));
  if (areas.empty())
  {
    sources.near_points.reserve(m > distinct.size() ? std::size_t(m) - distinct.size() : 0);
    add_sources_by_points(distinct, 0, distinct.size(), m, seed, sources);
    return sources;
  }
  const std::uint64_t total = known_or_found(known_total, [&]() {
    std::uint64_t sum = 0;
    for_each_in_order(distinct.size(), [&](std::size_t d) { sum += areas[distinct[d]]; });
    return sum;
  });
  add_sources_by_area(distinct, areas, 0, total, m, seed, sources);
  return sources;
}

/// The first of the points at each place.
/// \param points sorted, so that those at one place follow each other
inline Buffer<Index> distinct_points(const Buffer<Vector>& points)
{
  Buffer<Index> distinct(points.get_allocator());
  distinct.reserve(points.size());
  for_each_in_order(points.size(), [&](std::size_t j) {
    if (j == 0 || points[j] != points[j - 1])
      distinct.push_back(Index(j));
  });
  return distinct;
}

/// Lets samples start on their sources, or near them. No two start on one point: the further ones
/// of a point start between two points each, or around a point that is alone.
/// \param points sorted for `grid`, so that the starts do not depend on the order of the input
/// \param normals unoriented, one a point
/// \param cloud_index of the points
/// \param sources ascending, each of the two lists
/// \param radius how far apart the two points of a further sample may lie, at scale 1
/// \param isolated_radius of the ball around a point that is alone, at scale 1; 0 to start on it
/// \returns samples sorted for a grid of the same cell size
template <typename ConcurrencyTag, typename T>
Initial_samples start_samples(const Search_grid_3& grid, const Buffer<Vector>& points,
                              const Buffer<Eigen::Matrix<T, 3, 1>>& normals,
                              const Cloud_indices& cloud_index, Sources sources, double radius,
                              double isolated_radius, std::uint64_t seed, Progress& progress)
{
  const std::size_t number_of_samples = sources.on_points.size() + sources.near_points.size();
  Initial_samples samples{Buffer<Vector>(points.get_allocator()), std::move(sources.near_points)};
  samples.sources.reserve(number_of_samples);
  samples.positions.reserve(number_of_samples);
  const auto start_on_sources = [&]() {
    const std::size_t first = samples.positions.size();
    for_each_in_order(samples.sources.size() - first, [&](std::size_t i) {
      samples.positions.push_back(points[samples.sources[first + i]]);
    });
  };
  const bool is_sorted = samples.sources.empty();
  start_on_sources();
  if (!is_sorted)
    move_near_sources<ConcurrencyTag>(grid, points, normals, cloud_index, radius, isolated_radius,
                                      seed, progress, samples);
  samples.sources.insert(samples.sources.end(), sources.on_points.begin(), sources.on_points.end());
  start_on_sources();
  if (is_sorted)
    return samples;
  const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(
    samples.positions, Cell_sizes(grid.cell_size(), listed_scales(grid.scales(), samples.sources)));
  apply_order(order, samples.positions);
  apply_order(order, samples.sources);
  return samples;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_INITIALIZE_SAMPLES_H
