// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SUBSAMPLING_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SUBSAMPLING_H

#include "../common/Portable_random.h"
#include "../common/Triangle_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace L0_benchmark {

/// Keeps `count` of the elements, chosen at random, in random order.
template <typename T>
void keep_random_subset(std::vector<T>& values, std::size_t count, std::uint64_t seed)
{
  Portable_random random(seed);
  count = (std::min)(count, values.size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t rest = values.size() - i;
    std::swap(values[i],
              values[i + (std::min)(std::size_t(random.uniform() * double(rest)), rest - 1)]);
  }
  values.erase(values.begin() + std::ptrdiff_t(count), values.end());
}

/*!
KLOP's smaller input (Liao et al. 2013): draws from the kernel density estimate of the points, so
that the density of what is drawn tends to that of all points. To draw from the estimate is to
choose a point and to move it by the kernel.

\param bandwidth standard deviation of the Gaussian kernel, a length
*/
inline std::vector<Point_3> draw_from_kernel_density(const std::vector<Point_3>& points,
                                                     std::size_t count, double bandwidth,
                                                     std::uint64_t seed)
{
  std::vector<Point_3> drawn = points;
  keep_random_subset(drawn, count, seed);
  Portable_random random(seed + 1);
  for (Point_3& point : drawn) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    point = point + bandwidth * Vector_3(x, y, z);
  }
  return drawn;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SUBSAMPLING_H
