// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORHOODS_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORHOODS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/ball_queries.h>
#include <CGAL/L0_resampling/internal/weights.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Owns the lists that `Neighborhoods_view` shows.
struct Neighborhoods
{
  Buffer<std::size_t> offsets;
  Buffer<Index> indices;

  Neighborhoods_view view() const { return {offsets.size() - 1, offsets.data(), indices.data()}; }
};

/// How far apart two samples may be to be neighbors: no further than one radius for all, and than
/// r_p around either, beyond which the surface may bend away.
struct Range_of_pairs
{
  double radius;
  Scales_view scales;

  Range_of_pairs(double largest, const Scales_view& scales_of_samples = Scales_view())
    : radius(largest), scales(scales_of_samples)
  {} // not explicit: one radius for all is usual

  double squared(std::size_t i, std::size_t k) const
  {
    return scales.values ? square((std::min)(radius, double(scales.smaller_of_pair(i, k))))
                         : square(radius);
  }
};

/*!
Lists, for each sample, the other samples within the range of the pair: the self neighbors
\f$ N_{p_i} \f$, ascending and symmetric.

Where more than `maximum_number_of_candidates` samples share a block of cells, a sample keeps those
whose index equals its own modulo a power of two, the larger one of the two samples', which keeps
the lists symmetric and bounds their length.

\param samples sorted for `grid`, whose cells are no smaller than the range of their samples
*/
template <typename ConcurrencyTag>
Neighborhoods find_self_neighbors(const Search_grid_3& grid, const Buffer<Vector>& samples,
                                  const Range_of_pairs& range_of, Progress& progress)
{
  const std::size_t maximum_number_of_candidates = 1024;
  using Ranges = std::vector<Search_grid_3::Range>;

  Buffer<Index> strides = filled_buffer(samples.size(), Index(1), samples.get_allocator());
  for_each_cell_block<ConcurrencyTag>(grid, grid, 1, progress, [&]() {
    return [&](Index cell, const Ranges&, std::size_t count) {
      Index stride = 1;
      while (count / stride > maximum_number_of_candidates)
        stride *= 2;
      const Search_grid_3::Range queries = grid.points_of_cell(cell);
      std::fill(strides.begin() + queries.first, strides.begin() + queries.second, stride);
    };
  });

  Neighborhoods neighbors{filled_buffer(samples.size() + 1, std::size_t(0),
                                        samples.get_allocator()),
                          Buffer<Index>(samples.get_allocator())};
  const auto append_neighbors = [&](std::size_t begin_row, std::size_t end_row,
                                    Buffer<Index>& indices) {
    Search_grid_3::Block_cursor cursor(grid, 1);
    Ranges ranges;
    std::vector<Index> found;
    for (std::size_t row = begin_row; row < end_row; ++row)
      for_each_cell_of_row(
        grid, row, cursor, ranges,
        [&](Index cell, const Ranges& around, std::size_t number_around) {
          found.resize(number_around + 1);
          const Search_grid_3::Range queries = grid.points_of_cell(cell);
          for (Index i = queries.first; i < queries.second; ++i)
          {
            const Vector center = samples[i];
            const Index stride = strides[i];
            std::size_t count = 0;
            // Which candidates are near is beyond any branch prediction: each is written, and
            // overwritten by the next unless it is.
            for (const Search_grid_3::Range& range : around)
              for (Index k = range.first + ((i - range.first) & (stride - 1)); k < range.second;
                   k += stride)
              {
                found[count] = k;
                count += std::size_t((center - samples[k]).squaredNorm() < range_of.squared(i, k))
                         & std::size_t(k != i) & std::size_t(((k - i) & (strides[k] - 1)) == 0);
              }
            indices.insert(indices.end(), found.begin(), found.begin() + std::ptrdiff_t(count));
            neighbors.offsets[i + 1] = count;
          }
          progress.advance(queries.second - queries.first);
        });
  };
  neighbors.indices = append_by_blocks<ConcurrencyTag>(
    grid.number_of_rows(), rows_per_block, neighbors.indices.get_allocator(), append_neighbors);
  for_each_in_order(samples.size(),
                    [&](std::size_t i) { neighbors.offsets[i + 1] += neighbors.offsets[i]; });
  return neighbors;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORHOODS_H
