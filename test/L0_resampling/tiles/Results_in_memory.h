// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_TEST_RESULTS_IN_MEMORY_H
#define L0_TEST_RESULTS_IN_MEMORY_H

#include <CGAL/l0_resample_tiles.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace test {

/// A model of `L0ResamplingTileSink`.
struct Results_in_memory
{
  std::map<std::size_t, CGAL::L0_resampling::Tile_result> results;
  std::map<std::size_t, std::vector<CGAL::L0_resampling::Tile_sample>> finished;

  void put(std::size_t tile, CGAL::L0_resampling::Tile_result result)
  {
    results[tile] = std::move(result);
  }
  const CGAL::L0_resampling::Tile_result& get(std::size_t tile) const { return results.at(tile); }
  void finish(std::size_t tile, const std::vector<CGAL::L0_resampling::Tile_sample>& samples)
  {
    finished[tile] = samples;
  }
};

} // namespace test

#endif // L0_TEST_RESULTS_IN_MEMORY_H
