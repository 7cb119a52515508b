// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SAMPLES_TO_ORIENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_SAMPLES_TO_ORIENT_H

#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/side_of_normal.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
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

  /// Whether `look_at()` would compare a sample there with any.
  bool are_any_near(const Vector& place) const { return m_cells.count(cell_of(place)) > 0; }

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
  void look_at(const Vector& place, const Eigen::Vector3f& normal)
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
      *nearest.sign = normal.dot(own) < 0 ? -1 : 1;
    }
  }
};

/// The samples of all tiles whose sides are to be found. Whoever finds them turns `normals`, and
/// leaves each sample in its place.
class Samples_to_orient
{
  std::vector<std::size_t> m_sizes;                          // of the tiles
  std::vector<std::vector<Tile_sample>> m_leaders_elsewhere; // of each
  Buffer<unsigned char> m_were_negative; // of the samples, before they were turned
  double m_spacing;

  static constexpr std::size_t samples_per_block = 16384;

  static bool is_negative(const Eigen::Vector3f& v)
  {
    return internal::is_negative(v[0], v[1], v[2]);
  }

public:
  Buffer<Vector> places;           ///< in the frame of the cloud, tile by tile
  Buffer<Eigen::Vector3f> normals; ///< unit vectors of any sign, on their sides in the end

  /// \param tiles what is to be oriented of each; used up
  /// \param spacing of the samples
  template <typename ConcurrencyTag>
  Samples_to_orient(ConcurrencyTag, std::vector<Unoriented_samples> tiles, double spacing,
                    Memory_counter& memory)
    : m_were_negative(&memory), m_spacing(spacing), places(&memory), normals(&memory)
  {
    std::size_t m = 0;
    for (const Unoriented_samples& tile : tiles)
      m += tile.own.size();
    resize_to_overwrite(m, places);
    resize_to_overwrite(m, normals);
    resize_to_overwrite(m, m_were_negative);
    std::size_t first = 0;
    for (Unoriented_samples& tile : tiles)
    {
      for_each_block<ConcurrencyTag>(
        tile.own.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
          {
            const Tile_sample& sample = tile.own[i];
            places[first + i] = Vector(sample.position.data());
            normals[first + i] = Eigen::Vector3f(sample.normal.data());
            m_were_negative[first + i] = is_negative(normals[first + i]);
          }
        });
      first += tile.own.size();
      m_sizes.push_back(tile.own.size());
      std::vector<Tile_sample>().swap(tile.own);
      m_leaders_elsewhere.push_back(std::move(tile.leaders_elsewhere));
    }
  }

  /// Once normals are on their sides.
  /// \returns of each tile: 1, for those whose sides are known, the signs of its own samples, and
  /// of the leaders that it has elsewhere
  template <typename ConcurrencyTag>
  std::vector<std::vector<signed char>> signs() const
  {
    std::vector<std::vector<signed char>> signs(m_sizes.size());
    Signs_elsewhere elsewhere(m_spacing);
    std::size_t first = 0;
    for (std::size_t tile = 0; tile < m_sizes.size(); ++tile)
    {
      std::vector<signed char>& of_tile = signs[tile];
      const std::vector<Tile_sample>& leaders = m_leaders_elsewhere[tile];
      of_tile.assign(1 + m_sizes[tile] + leaders.size(), 1);
      for_each_block<ConcurrencyTag>(
        m_sizes[tile], samples_per_block, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
          {
            const bool is_turned = is_negative(normals[first + i])
                                   != (m_were_negative[first + i] != 0);
            of_tile[1 + i] = static_cast<signed char>(is_turned ? -1 : 1);
          }
        });
      first += m_sizes[tile];
      for (std::size_t k = 0; k < leaders.size(); ++k)
        elsewhere.add(leaders[k], of_tile[1 + m_sizes[tile] + k]);
    }
    if (elsewhere.is_empty())
      return signs;
    const Buffer<std::size_t> near = append_by_blocks<ConcurrencyTag, std::size_t>(
      places.size(), samples_per_block, places.get_allocator(),
      [&](std::size_t begin, std::size_t end, Buffer<std::size_t>& of_block) {
        for (std::size_t i = begin; i < end; ++i)
          if (elsewhere.are_any_near(places[i]))
            of_block.push_back(i);
      });
    for (const std::size_t i : near)
      elsewhere.look_at(places[i], normals[i]);
    return signs;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SAMPLES_TO_ORIENT_H
