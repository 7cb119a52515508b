// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TILE_STITCHING_H
#define CGAL_L0_RESAMPLING_TILE_STITCHING_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/internal/core/Signed_union_find.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// A point of the result, as a tile has found it: with the side that the tile has chosen.
/// `Tiled_resampling::sides()` or `Stitching` says whether its normal has to be turned.
struct Tile_sample
{
  std::array<double, 3> position;
  std::array<float, 3> normal;
  std::uint32_t tree; ///< samples of one tree of a tile have sides relative to each other
};

/// \ingroup PkgL0ResamplingRef
/// The samples of a tile whose sides are found together with those of all tiles: in the frame of
/// the cloud, before they are projected.
struct Unoriented_samples
{
  std::vector<Tile_sample> own;
  std::vector<Tile_sample> leaders_elsewhere; ///< other tiles keep them, this one their followers
};

/// \ingroup PkgL0ResamplingRef
/// How well the samples agree that two tiles have both found.
struct Seam_report
{
  std::uint64_t number_of_samples = 0; ///< of halos, near to the tile that owns the place
  std::uint64_t number_of_matches = 0; ///< of these: with a sample of the owner nearby
  std::uint64_t number_of_opposed = 0; ///< of the matches: opposite sides, once all are turned
  double sum_of_squared_distances = 0; ///< of the matches, in squared spacings of the samples
};

/*!
\ingroup PkgL0ResamplingRef

Turns the trees of all tiles relative to each other: where tiles overlap, both have found the same
samples, and their normals vote. Trees join by the strongest votes first. What is joined is turned
as most of its samples have it, by how sure their tiles are of it.
*/
class Stitching
{
  struct Votes
  {
    double sum = 0;
    std::uint64_t same = 0, opposite = 0;
  };

  double m_spacing;
  std::vector<Index> m_first_nodes; // of the tiles, and the number of all
  std::vector<double> m_evidence;   // of the nodes: for the sides that their tiles have chosen
  std::map<std::pair<Index, Index>, Votes> m_votes;
  Seam_report m_report;

  using Cell = std::array<std::int64_t, 3>;
  struct Hash
  {
    std::size_t operator()(const Cell& cell) const
    {
      return std::size_t(std::uint64_t(cell[0]) * 0x9e3779b97f4a7c15u
                         ^ std::uint64_t(cell[1]) * 0xc2b2ae3d27d4eb4fu
                         ^ std::uint64_t(cell[2]) * 0x165667b19e3779f9u);
    }
  };

  Cell cell_of(const Tile_sample& sample) const
  {
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell[axis] = std::int64_t(std::floor(sample.position[axis] / m_spacing));
    return cell;
  }

  static double squared_distance(const Tile_sample& a, const Tile_sample& b)
  {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      sum += (a.position[axis] - b.position[axis]) * (a.position[axis] - b.position[axis]);
    return sum;
  }

  void match(Index first_a, Index first_b, const Tile_sample& a, const Tile_sample& b,
             double distance)
  {
    double cosine = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cosine += double(a.normal[axis]) * double(b.normal[axis]);
    ++m_report.number_of_matches;
    m_report.sum_of_squared_distances += distance / (m_spacing * m_spacing);
    Votes& votes = m_votes[{first_a + a.tree, first_b + b.tree}];
    votes.sum += cosine;
    ++(cosine >= 0 ? votes.same : votes.opposite);
  }

public:
  /// \param spacing of the samples
  /// \param evidence of each tile and tree: the sum over its samples of how much more than a guess
  /// their sides are
  Stitching(double spacing, const std::vector<std::vector<double>>& evidence) : m_spacing(spacing)
  {
    for (const std::vector<double>& of_tile : evidence)
    {
      m_first_nodes.push_back(Index(m_evidence.size()));
      m_evidence.insert(m_evidence.end(), of_tile.begin(), of_tile.end());
    }
    m_first_nodes.push_back(Index(m_evidence.size()));
  }

  /// Lets samples vote: those that tile `a` keeps, near its border, and those that tile `b` has
  /// found there too, in its halo. Matches are the nearest ones, within half a spacing.
  void add_overlap(std::size_t a, const std::vector<Tile_sample>& kept, std::size_t b,
                   const std::vector<Tile_sample>& in_halo)
  {
    std::unordered_map<Cell, std::vector<std::uint32_t>, Hash> cells;
    for (std::size_t i = 0; i < kept.size(); ++i)
      cells[cell_of(kept[i])].push_back(std::uint32_t(i));
    for (const Tile_sample& sample : in_halo)
    {
      const Tile_sample* nearest = nullptr;
      double least = m_spacing * m_spacing / 4;
      const Cell middle = cell_of(sample);
      for (int k = 0; k < 27; ++k)
      {
        const auto found = cells.find(
          {middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1});
        if (found == cells.end())
          continue;
        for (const std::uint32_t i : found->second)
          if (squared_distance(sample, kept[i]) < least)
          {
            least = squared_distance(sample, kept[i]);
            nearest = &kept[i];
          }
      }
      ++m_report.number_of_samples;
      if (nearest)
        match(m_first_nodes[a], m_first_nodes[b], *nearest, sample, least);
    }
  }

  /// The same of all tiles and their neighbors. Each result is asked for once, and of those whose
  /// neighbors are to come only the samples near the border are kept.
  /// \param tiles tells which are neighbors, and where samples belong, as `Tiled_resampling` does
  /// \param sink model of `L0ResamplingTileSink`
  template <typename Tiles, typename Sink>
  void add_overlaps(const Tiles& tiles, Sink& sink)
  {
    struct Borders
    {
      std::vector<Tile_sample> kept, in_halo;
      std::size_t last; ///< of the tile and its neighbors
    };
    std::map<std::size_t, Borders> borders;
    const std::size_t number_of_tiles = m_first_nodes.size() - 1;
    const auto borders_of = [&](std::size_t tile) -> const Borders& {
      const auto found = borders.find(tile);
      if (found != borders.end())
        return found->second;
      std::size_t last = tile;
      for (std::size_t other = tile + 1; other < number_of_tiles; ++other)
        if (tiles.are_neighbors(tile, other))
          last = other;
      const auto& result = sink.get(tile); // a value lives as long
      return borders[tile] = {result.near_border, result.beyond_border, last};
    };
    for (std::size_t a = 0; a < number_of_tiles; ++a)
    {
      for (std::size_t b = 0; b < number_of_tiles; ++b)
        if (tiles.are_neighbors(a, b))
          add_overlap(a, borders_of(a).kept, b, tiles.samples_of_owner(borders_of(b).in_halo, a));
      for (auto of_tile = borders.begin(); of_tile != borders.end();)
        of_tile = of_tile->second.last <= a ? borders.erase(of_tile) : std::next(of_tile);
    }
  }

  /// The sign of each tile and tree.
  std::vector<std::vector<signed char>> signs() const
  {
    using Edge = std::pair<std::pair<Index, Index>, Votes>;
    std::vector<Edge> edges(m_votes.begin(), m_votes.end());
    std::stable_sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::abs(a.second.sum) > std::abs(b.second.sum);
    });
    internal::Signed_union_find sets(m_evidence.size(), {});
    for (const auto& [nodes, votes] : edges)
      sets.join(nodes.first, nodes.second, votes.sum < 0 ? -1 : 1);
    std::vector<double> evidence(m_evidence.size(), 0.);
    for (std::size_t node = 0; node < m_evidence.size(); ++node)
    {
      const auto [root, sign] = sets.find(Index(node));
      evidence[root] += sign * m_evidence[node];
    }
    std::vector<std::vector<signed char>> signs;
    for (std::size_t tile = 0; tile + 1 < m_first_nodes.size(); ++tile)
    {
      signs.emplace_back();
      for (Index node = m_first_nodes[tile]; node < m_first_nodes[tile + 1]; ++node)
      {
        const auto [root, sign] = sets.find(node);
        signs.back().push_back(static_cast<signed char>(evidence[root] < 0 ? -sign : sign));
      }
    }
    return signs;
  }

  /// \param signs of each tile and tree
  Seam_report report(const std::vector<std::vector<signed char>>& signs) const
  {
    std::vector<signed char> of_nodes;
    for (const std::vector<signed char>& of_tile : signs)
      of_nodes.insert(of_nodes.end(), of_tile.begin(), of_tile.end());
    Seam_report report = m_report;
    for (const auto& [nodes, votes] : m_votes)
      report.number_of_opposed += of_nodes[nodes.first] == of_nodes[nodes.second] ? votes.opposite
                                                                                  : votes.same;
    return report;
  }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILE_STITCHING_H
