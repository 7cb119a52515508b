// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RUNS_OF_CELLS_H
#define CGAL_L0_RESAMPLING_INTERNAL_RUNS_OF_CELLS_H

#include <CGAL/L0_resampling/internal/tiles/Disks_of_tile.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Sums over points in the order of the whole cloud.
struct Sums_over_points
{
  std::uint64_t units = 0; ///< areas of the distinct points
  std::uint64_t points = 0;
  std::uint64_t distinct = 0;     ///< points, one of each place
  std::uint64_t units_of_all = 0; ///< areas of all points, also those at one place
  std::uint64_t neighbors = 0;    ///< of all points, in the balls of the normal filter

  Sums_over_points& operator+=(const Sums_over_points& other)
  {
    units += other.units;
    points += other.points;
    distinct += other.distinct;
    units_of_all += other.units_of_all;
    neighbors += other.neighbors;
    return *this;
  }
};

/// A few cells of a row, whose points follow each other in the order of the whole cloud.
struct Run_of_cells
{
  std::uint64_t key; ///< `Search_grid_3::key_of_run()`
  Sums_over_points sums;

  bool operator<(const Run_of_cells& other) const { return key < other.key; }
};

/// What a tile counts.
struct Share_of_tile
{
  /// Ascending: those that are the tile's own, with what is in them, and others with nothing.
  std::vector<Run_of_cells> runs;
  double area_per_unit = 0; ///< in units of \f$ r_p^2 \f$
};

/// What comes before the runs of cells of a tile, in the order of the whole cloud.
struct Run_prefix_sums
{
  std::vector<Run_of_cells> runs;
  Sums_over_points all; ///< of the cloud
};

/// What all tiles have counted.
struct Cloud_totals
{
  Disks_of_tile disks; ///< of the cloud, as shares were found with them
  Sums_over_points sums;
  double area = 0; ///< in units of \f$ r_p^2 \f$
};

/*!
Adds up the shares of all tiles in the order of the whole cloud, so that each tile knows which of
the samples start in its runs, and which number each of its points has in the cloud.

\param shares in: what is in the runs. Out: what comes before each; those of halos of which nothing
is left are removed
\throws std::length_error as `sum_of_areas()`
*/
inline Cloud_totals add_up_shares(std::vector<Share_of_tile>& shares)
{
  Cloud_totals result;
  std::vector<Run_of_cells> all;
  double area_per_unit = 0;
  for (const Share_of_tile& share : shares)
  {
    std::copy_if(share.runs.begin(), share.runs.end(), std::back_inserter(all),
                 [](const Run_of_cells& run) { return run.sums.points > 0; });
    area_per_unit = (std::max)(area_per_unit,
                               share.area_per_unit); // all the same, if they are known
  }
  std::sort(all.begin(), all.end());
  all.erase(
    std::unique(all.begin(), all.end(),
                [](const Run_of_cells& a, const Run_of_cells& b) { return a.key == b.key; }),
    all.end());
  for (Run_of_cells& run : all)
  {
    const Sums_over_points own = run.sums;
    run.sums = result.sums;
    result.sums += own;
    // the largest of the sums
    result.sums.units_of_all = sum_of_areas(run.sums.units_of_all, own.units_of_all);
  }
  result.area = double(result.sums.units_of_all) * area_per_unit;
  for (Share_of_tile& share : shares)
  {
    auto place = all.begin();
    auto end = share.runs.begin();
    for (const Run_of_cells& run : share.runs)
    {
      place = std::lower_bound(place, all.end(), run);
      if (place != all.end() && place->key == run.key)
        *end++ = *place;
    }
    share.runs.erase(end, share.runs.end());
  }
  return result;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RUNS_OF_CELLS_H
