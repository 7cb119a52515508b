// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_REFIT_SAMPLE_NORMALS_H
#define CGAL_L0_RESAMPLING_INTERNAL_REFIT_SAMPLE_NORMALS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/lanes.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/kernels/local_surface.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>
#include <CGAL/L0_resampling/internal/search/Neighborhoods.h>

#include <Eigen/Core>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Corrects the normals of the samples by their positions. A fit leaves a sample the mean normal of the
points in a ball \f$ r_p \f$; where the surface bends within that ball, the samples themselves, a
fraction of \f$ r_p \f$ apart, know its direction better. Each normal leans halfway to that of the
plane through the samples around that agree with it, about the smallest eigenvector of

\f[ \sum_k w_k (p_k - \bar p)(p_k - \bar p)^T, \qquad w_k
= \theta(\|p_k - p_i\|) \, \psi(n_i, n_k) \, e^{-h_{ik}^2/H^2}, \f]

over the self neighbors and the sample, with `symmetric_height()`, see `lean_to_plane()`.

\param neighbors may have moved since they were found
\param samples normals in and out
*/
template <typename ConcurrencyTag, typename FT>
void refit_sample_normals(const Fit_kernel<double>& kernel, const Neighborhoods& neighbors,
                          Samples<FT>& samples)
{
  using Local_vector = Eigen::Matrix<FT, 3, 1>;
  using Numbers = Lanes<FT, false>;
  const Fit_kernel<FT> fit_kernel = kernel.as<FT>();
  const Range_of_pairs range = {kernel.radius, view_of_scales(samples.scales),
                                view_of_scales(samples.spreading_radii)};
  const std::size_t samples_per_block = 1024;
  Buffer<Local_vector> refitted = copy_of(samples.normals);
  for_each_block<ConcurrencyTag>(
    samples.positions.size(), samples_per_block, [&](std::size_t begin, std::size_t end) {
      const std::size_t first_pair = neighbors.offsets[begin],
                        size = padded_to_lanes(neighbors.offsets[end] - first_pair);
      Buffer<Local_vector> differences(size);
      Aligned_vector<FT> squared_distances(size, FT(0)), cosines = squared_distances,
                                                         heights = cosines, weights(size);
      // what shortens the range of a pair shortens the kernel
      Aligned_vector<FT> squared_stretches(size, FT(1));
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
        {
          const Index k = neighbors.indices[e];
          const std::size_t pair = e - first_pair;
          const Local_vector d = (samples.positions[k] - samples.positions[i]).template cast<FT>();
          const Local_vector &own = samples.normals[i], &other = samples.normals[k];
          const Seen_point<FT> point(d[0], d[1], d[2], other[0], other[1], other[2], own[0], own[1],
                                     own[2]);
          differences[pair] = d;
          squared_distances[pair] = d.squaredNorm();
          cosines[pair] = point.cosine;
          heights[pair] = point.height;
          if (!range.is_one_for_all())
            squared_stretches[pair] = fit_kernel.squared_radius() / FT(range.squared(i, k));
        }
      for (std::size_t k = 0; k < size; k += Numbers::size)
      {
        const Numbers stretch = Numbers::load(&squared_stretches[k]);
        weight_in_ball(Numbers::load(&squared_distances[k]) * stretch, Numbers::load(&cosines[k]),
                       Numbers::load(&heights[k]) * sqrt(stretch), fit_kernel)
          .store(&weights[k]);
      }
      for (std::size_t i = begin; i < end; ++i)
      {
        Plane_moments<double> moments;
        moments.add(0, 0, 0, 1); // the sample itself
        for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
        {
          const std::size_t pair = e - first_pair;
          const Local_vector& d = differences[pair];
          moments.add(d[0], d[1], d[2], double(weights[pair]));
        }
        const Local_vector& normal = samples.normals[i];
        const Triple leaning = lean_to_plane(moments, {normal[0], normal[1], normal[2]});
        refitted[i] = Vector(leaning.x, leaning.y, leaning.z).template cast<FT>();
      }
    });
  samples.normals.swap(refitted);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_REFIT_SAMPLE_NORMALS_H
