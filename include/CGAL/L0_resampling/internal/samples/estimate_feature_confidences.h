// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_FEATURE_CONFIDENCES_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_FEATURE_CONFIDENCES_H

#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/search/nearest_samples.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// As many nearest neighbors of a sample lie within two or three spacings: the width of a feature
/// line. More would widen it, fewer tear it.
constexpr std::size_t number_of_feature_neighbors = 18;

/*!
How sure it is that each sample lies on an edge or a corner, in [0, 1]: twice the share of its pairs
that are active, at most 1. A pair is active as far as \f$ \psi \f$ of Eq. (2) tells its normals
apart, which is the jump that the L0 term pays for; the heights of the pairs themselves, which Eq.
(9) looks at, do not tell a jump of a few spacings from noise where the radius is larger. On an edge
half of the neighbors lie beyond it, on a corner more.

\param normals unit vectors, of any sign
\param spacing of the samples, roughly
\param normal_bandwidth \f$ (1 - \cos\sigma_n)^2 \f$ of the difference that makes two normals those
of two faces
\param confidences out: one number a sample
*/
template <typename ConcurrencyTag, typename T>
void estimate_feature_confidences(const Buffer<Vector>& positions,
                                  const Buffer<Eigen::Matrix<T, 3, 1>>& normals, double spacing,
                                  double normal_bandwidth, Progress& progress,
                                  Buffer<float>& confidences)
{
  const double radius_of_that_many = spacing * std::sqrt(double(number_of_feature_neighbors) / 3);
  const Nearest_samples nearest = find_nearest_samples<ConcurrencyTag>(
    positions, number_of_feature_neighbors, number_of_feature_neighbors, radius_of_that_many,
    progress);
  fill_buffer(positions.size(), 0.f, confidences);
  const std::size_t samples_per_block = 4096;
  for_each_block<ConcurrencyTag>(
    positions.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        // in integers, as the neighbors come in no particular order
        const double steps = 65536;
        std::size_t sum = 0;
        for (const Index* other = nearest.begin(Index(i)); other != nearest.end(Index(i)); ++other)
        {
          const double cosine = (std::min)(std::abs(double(normals[i].dot(normals[*other]))), 1.);
          sum += std::size_t(steps * (1 - bilateral_weight(0., 1., cosine, normal_bandwidth)));
        }
        const double count = double(nearest.end(Index(i)) - nearest.begin(Index(i)));
        confidences[i] = count > 0 ? float((std::min)(2 * double(sum) / (steps * count), 1.)) : 0.f;
      }
    });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_FEATURE_CONFIDENCES_H
