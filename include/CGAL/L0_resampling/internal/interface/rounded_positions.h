// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ROUNDED_POSITIONS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ROUNDED_POSITIONS_H

#include <CGAL/L0_resampling/internal/cloud/separate_coincident_points.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The bounding box of the input grown by `margin`, as far as numbers reach.
template <typename FT>
std::array<std::array<FT, 3>, 2> box_of_result(const Input& input, double margin)
{
  const double largest = double((std::numeric_limits<FT>::max)());
  std::array<std::array<FT, 3>, 2> box;
  for (int axis = 0; axis < 3; ++axis)
  {
    box[0][std::size_t(axis)] = FT((std::max)(input.low[axis] - margin, -largest));
    box[1][std::size_t(axis)] = FT((std::min)(input.high[axis] + margin, largest));
  }
  return box;
}

/// The result's positions in the number type of the caller: inside the bounding box grown by
/// `margin`, and no two equal if `separate`.
template <typename ConcurrencyTag, typename FT>
Buffer<std::array<FT, 3>> rounded_positions(const Buffer<Vector>& positions, const Input& input,
                                            double margin, bool separate)
{
  const std::array<std::array<FT, 3>, 2> box = box_of_result<FT>(input, margin);
  const std::array<FT, 3>& low = box[0];
  const std::array<FT, 3>& high = box[1];
  Buffer<std::array<FT, 3>> rounded(positions.get_allocator());
  rounded.reserve(positions.size());
  for_each_in_order(positions.size(), [&](std::size_t i) {
    std::array<FT, 3> r;
    for (std::size_t a = 0; a < 3; ++a)
      r[a] = FT(
        (std::min)((std::max)(positions[i][Eigen::Index(a)], double(low[a])), double(high[a])));
    rounded.push_back(r);
  });
  if (separate)
    separate_coincident_points<ConcurrencyTag>(low, high, FT(margin), rounded);
  return rounded;
}

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template Buffer<std::array<float, 3>> rounded_positions<Sequential_tag, float>(
  const Buffer<Vector>&, const Input&, double, bool);
extern template Buffer<std::array<double, 3>> rounded_positions<Sequential_tag, double>(
  const Buffer<Vector>&, const Input&, double, bool);
#ifdef CGAL_LINKED_WITH_TBB
extern template Buffer<std::array<float, 3>> rounded_positions<Parallel_tag, float>(
  const Buffer<Vector>&, const Input&, double, bool);
extern template Buffer<std::array<double, 3>> rounded_positions<Parallel_tag, double>(
  const Buffer<Vector>&, const Input&, double, bool);
#endif
#endif

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ROUNDED_POSITIONS_H
