// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgL0ResamplingConcepts

Stores what the tiles of a cloud give.

\cgalConcept
*/
class L0ResamplingTileSink
{
public:
  /// Stores what a tile has found. Tiles are numbered from 0.
  void put(std::size_t tile, CGAL::L0_resampling::Tile_result result);

  /// Gives it back, by value or by reference.
  CGAL::L0_resampling::Tile_result get(std::size_t tile);

  /// Takes the samples of a tile, with normals on their sides, and on creases if these are asked
  /// for. Tiles come in their order.
  void finish(std::size_t tile, const std::vector<CGAL::L0_resampling::Tile_sample>& samples);
};
