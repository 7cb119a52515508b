// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SIDES_OF_TILES_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_SIDES_OF_TILES_IMPL_H

#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/orientation/order_of_places.h>
#include <CGAL/L0_resampling/internal/orientation/orient_normals.h>
#include <CGAL/L0_resampling/internal/orientation/side_hints.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The signs of samples that were found a second time, in a halo: those of the samples nearest to
/// them, which mostly are the same to the last bit.
class Signs_elsewhere
{
  struct Nearest
  {
    const Tile_sample* sample;
    double squared_distance;
    signed char* sign;
  };
  using Cell = std::array<std::int64_t, 3>;

  double m_spacing;
  std::vector<Nearest> m_nearest;
  std::map<Cell, std::vector<std::size_t>> m_cells; // and those around the cell of each

  Cell cell_of(const Vector& p) const
  {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[std::size_t(axis)] = std::int64_t(std::floor(p[axis] / m_spacing));
    return cell;
  }

public:
  /// \param spacing of the samples: how far off the nearest is looked for
  explicit Signs_elsewhere(double spacing) : m_spacing(spacing) {}

  bool is_empty() const { return m_nearest.empty(); }

  /// \param sign out, once all samples have been looked at; kept if none is near
  void add(const Tile_sample& sample, signed char& sign)
  {
    const Cell middle = cell_of(Vector(sample.position.data()));
    for (int k = 0; k < 27; ++k)
      m_cells[{middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1}].push_back(
        m_nearest.size());
    m_nearest.push_back({&sample, m_spacing * m_spacing, &sign});
  }

  /// \param normal on its side
  template <typename T>
  void look_at(const Vector& place, const Eigen::Matrix<T, 3, 1>& normal)
  {
    const auto found = m_cells.find(cell_of(place));
    if (found == m_cells.end())
      return;
    for (const std::size_t k : found->second)
    {
      Nearest& nearest = m_nearest[k];
      const double distance = (place - Vector(nearest.sample->position.data())).squaredNorm();
      if (!(distance < nearest.squared_distance))
        continue;
      nearest.squared_distance = distance;
      const Eigen::Vector3f own(nearest.sample->normal.data());
      *nearest.sign = normal.template cast<float>().dot(own) < 0 ? -1 : 1;
    }
  }
};

template <typename ConcurrencyTag>
std::vector<std::vector<signed char>> sides_of_tiles(const std::vector<Unoriented_samples>& tiles,
                                                     const Facts_of_cloud& facts, const Plan& plan,
                                                     const Parameters& parameters,
                                                     Progress& progress, Memory_counter& memory)
{
  using Normal = Eigen::Vector3f;
  std::size_t m = 0;
  for (const Unoriented_samples& tile : tiles)
    m += tile.own.size();
  Buffer<Vector> places(&memory);
  Buffer<Normal> normals(&memory);
  places.reserve(m);
  normals.reserve(m);
  std::vector<std::vector<signed char>> signs;
  Signs_elsewhere elsewhere(plan.sample_spacing);
  for (const Unoriented_samples& tile : tiles)
  {
    for (const Tile_sample& sample : tile.own)
    {
      places.push_back(Vector(sample.position.data()));
      normals.push_back(Normal(sample.normal.data()));
    }
    const std::size_t size = tile.own.size() + tile.leaders_elsewhere.size();
    signs.emplace_back(size, static_cast<signed char>(1));
    for (std::size_t k = 0; k < tile.leaders_elsewhere.size(); ++k)
      elsewhere.add(tile.leaders_elsewhere[k], signs.back()[tile.own.size() + k]);
  }

  progress.begin_stage("orient normals", 1, m);
  Buffer<Index> order = order_of_places<ConcurrencyTag>(places, plan);
  apply_order<ConcurrencyTag>(order, places);
  apply_order<ConcurrencyTag>(order, normals);
  const Buffer<Normal> before = copy_of(normals);
  Working_frame frame;
  Buffer<Vector> no_points(&memory);
  const Buffer<Normal> no_hints(&memory);
  frame.enter<ConcurrencyTag>(no_points, *facts.frame);
  frame.set_unit<ConcurrencyTag>(plan.unit, no_points);
  orient_normals<ConcurrencyTag>(places, plan.number_of_orientation_neighbors, plan.sample_spacing,
                                 side_hints(parameters, frame, places, no_hints), progress,
                                 normals);

  Buffer<signed char> in_first_order(m, static_cast<signed char>(1), &memory);
  for_each_in_order(m, [&](std::size_t i) {
    in_first_order[order[i]] = static_cast<signed char>(normals[i].dot(before[i]) < 0 ? -1 : 1);
  });
  std::size_t first = 0;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
  {
    const auto begin = in_first_order.begin() + std::ptrdiff_t(first);
    const std::size_t size = tiles[tile].own.size();
    std::copy(begin, begin + std::ptrdiff_t(size), signs[tile].begin());
    first += size;
  }
  if (!elsewhere.is_empty())
    for_each_in_order(m, [&](std::size_t i) { elsewhere.look_at(places[i], normals[i]); });
  progress.end_stage();
  return signs;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SIDES_OF_TILES_IMPL_H
