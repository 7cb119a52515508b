// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORHOODS_H
#define CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORHOODS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

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

/// How far apart two samples may be to be neighbors: no further than one radius for all, than r_p
/// around either, beyond which the surface may bend away, and than the spreading radius of either,
/// where the density of the input is kept.
struct Range_of_pairs
{
  double radius;
  Scales_view scales, spreading_radii;

  Range_of_pairs(double largest, const Scales_view& scales_of_samples = Scales_view(),
                 const Scales_view& spreading_radii_of_samples = Scales_view())
    : radius(largest), scales(scales_of_samples), spreading_radii(spreading_radii_of_samples)
  {} // not explicit: one radius for all is usual

  bool is_one_for_all() const { return !scales.values && !spreading_radii.values; }

  double squared(std::size_t i, std::size_t k) const
  {
    double range = radius;
    for (const Scales_view* limits : {&scales, &spreading_radii})
      if (limits->values)
        range = (std::min)(range, double(limits->smaller_of_pair(i, k)));
    return square(range);
  }
};

/*!
Finds, for each sample, the other samples within the range of the pair, ascending and symmetric.

Where more than `maximum_number_of_self_candidates` samples share a block of cells, a sample keeps
those whose rank in their cell equals its own rank modulo a power of two, the larger one of the two
samples'. This keeps the lists symmetric, bounds their length, and does not depend on the rest of
the cloud.
*/
class Self_neighbor_search
{
  using Ranges = std::vector<Search_grid_3::Range>;
  static constexpr Index queries_per_look = 1024; ///< at the caller, in a cell of any number

  const Search_grid_3& m_grid;
  const Buffer<Vector>& m_samples;
  const Range_of_pairs m_range_of;
  Progress& m_progress;

  /// Of a sample.
  struct Place
  {
    Index rank : 27; // in its cell, modulo a larger power of two than any stride
    Index shift : 5; // the stride is 2 to this power

    Index stride() const { return Index(1) << shift; }
    /// Whether this sample may be a neighbor of one with this rank.
    bool is_chosen(Index other_rank) const { return ((rank - other_rank) & (stride() - 1)) == 0; }
  };
  Buffer<Place> m_places;

public:
  /// \param samples sorted for `grid`, whose cells are no smaller than the range of their samples
  template <typename ConcurrencyTag>
  Self_neighbor_search(ConcurrencyTag, const Search_grid_3& grid, const Buffer<Vector>& samples,
                       const Range_of_pairs& range_of, Progress& progress)
    : m_grid(grid), m_samples(samples), m_range_of(range_of), m_progress(progress),
      m_places(filled_buffer(samples.size(), Place{0, 0}, samples.get_allocator()))
  {
    for_each_cell_block<ConcurrencyTag>(grid, grid, 1, progress, [&]() {
      return [&](Index cell, const Ranges&, std::size_t count) {
        Place place = {0, 0};
        while (count / place.stride() > maximum_number_of_self_candidates)
          ++place.shift;
        const Search_grid_3::Range queries = grid.points_of_cell(cell);
        for (Index i = queries.first; i < queries.second; ++i, ++place.rank)
          m_places[i] = place;
      };
    });
  }

  /// Calls `f(i, neighbors, count)` for each sample of the rows `[begin_row, end_row)`.
  template <typename F>
  void for_each_of_rows(std::size_t begin_row, std::size_t end_row, const F& f) const
  {
    Search_grid_3::Block_cursor cursor(m_grid, 1);
    Ranges ranges;
    std::vector<Index> found;
    const auto visit_cell = [&](Index cell, const Ranges& around, std::size_t number_around) {
      found.resize(number_around + 1);
      const Search_grid_3::Range queries = m_grid.points_of_cell(cell);
      for (Index i = queries.first; i < queries.second; ++i)
      {
        const Vector center = m_samples[i];
        const Place place = m_places[i];
        const Index stride = place.stride();
        std::size_t count = 0;
        // Which candidates are near is beyond any branch prediction: each is written, and
        // overwritten by the next unless it is.
        const auto look_at = [&](Index first, Index end) {
          for (Index k = first; k < end; k += stride)
          {
            found[count] = k;
            count += std::size_t((center - m_samples[k]).squaredNorm() < m_range_of.squared(i, k))
                     & std::size_t(k != i) & std::size_t(m_places[k].is_chosen(place.rank));
          }
        };
        for (const Search_grid_3::Range& range : around)
          if (stride == 1)
            look_at(range.first, range.second);
          else
            m_grid.for_each_cell_of_range(range, [&](const Search_grid_3::Range& cell_range) {
              look_at(cell_range.first + (place.rank & (stride - 1)), cell_range.second);
            });
        f(i, found.data(), count);
        if ((i - queries.first + 1) % queries_per_look == 0)
          m_progress.advance(queries_per_look);
      }
      m_progress.advance((queries.second - queries.first) % queries_per_look);
    };
    for (std::size_t row = begin_row; row < end_row; ++row)
      for_each_cell_of_row(m_grid, row, cursor, ranges, visit_cell);
  }
};

/// Lists the self neighbors \f$ N_{p_i} \f$ of each sample, as `Self_neighbor_search` finds them.
template <typename ConcurrencyTag>
Neighborhoods find_self_neighbors(const Search_grid_3& grid, const Buffer<Vector>& samples,
                                  const Range_of_pairs& range_of, Progress& progress)
{
  const Self_neighbor_search search(ConcurrencyTag(), grid, samples, range_of, progress);
  Neighborhoods neighbors{filled_buffer(samples.size() + 1, std::size_t(0),
                                        samples.get_allocator()),
                          Buffer<Index>(samples.get_allocator())};
  const auto append_neighbors = [&](std::size_t begin_row, std::size_t end_row,
                                    Buffer<Index>& indices) {
    search.for_each_of_rows(begin_row, end_row,
                            [&](Index i, const Index* found, std::size_t count) {
                              indices.insert(indices.end(), found, found + count);
                              neighbors.offsets[i + 1] = count;
                            });
  };
  neighbors.indices = append_by_blocks<ConcurrencyTag>(
    grid.number_of_rows(), rows_per_block, neighbors.indices.get_allocator(), append_neighbors);
  for_each_in_order(samples.size(),
                    [&](std::size_t i) { neighbors.offsets[i + 1] += neighbors.offsets[i]; });
  return neighbors;
}

/// What `find_self_neighbors()` would list, in numbers of neighbors.
struct Counted_neighbors
{
  std::size_t listed = 0;              ///< in all lists
  std::size_t maximum_number_held = 0; ///< in all arrays, while the lists are made

  /// Of one block of samples, whose array grows as `std::vector` does and is shrunk at the end.
  class Of_block
  {
    std::size_t m_size = 0, m_capacity = 0, m_maximum_number_held = 0;

  public:
    void append(std::size_t count)
    {
      if (m_size + count > m_capacity)
      {
        const std::size_t larger = m_size + (std::max)(m_size, count);
        m_maximum_number_held = (std::max)(m_maximum_number_held, m_capacity + larger);
        m_capacity = larger;
      }
      m_size += count;
    }
    Counted_neighbors sum() const
    {
      return {m_size, (std::max)(m_maximum_number_held, m_capacity + m_size)};
    }
  };

  /// Appends a block that is listed next.
  Counted_neighbors& operator+=(const Counted_neighbors& block)
  {
    maximum_number_held = (std::max)(maximum_number_held, listed + block.maximum_number_held);
    listed += block.listed;
    return *this;
  }
};

/// Counts what `find_self_neighbors()` would list.
template <typename ConcurrencyTag>
Counted_neighbors count_self_neighbors(const Search_grid_3& grid, const Buffer<Vector>& samples,
                                       const Range_of_pairs& range_of, Progress& progress)
{
  const Self_neighbor_search search(ConcurrencyTag(), grid, samples, range_of, progress);
  Counted_neighbors sum = block_sum<ConcurrencyTag>(
    grid.number_of_rows(), rows_per_block, [&](std::size_t begin_row, std::size_t end_row) {
      Counted_neighbors::Of_block block;
      search.for_each_of_rows(begin_row, end_row,
                              [&](Index, const Index*, std::size_t count) { block.append(count); });
      return block.sum();
    });
  sum.maximum_number_held = (std::max)(sum.maximum_number_held,
                                       2 * sum.listed); // all blocks, and all in one array
  return sum;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_NEIGHBORHOODS_H
