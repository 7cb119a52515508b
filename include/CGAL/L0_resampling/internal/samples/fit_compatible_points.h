// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIT_COMPATIBLE_POINTS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIT_COMPATIBLE_POINTS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Border_of_ball.h>
#include <CGAL/L0_resampling/internal/kernels/Compatible_points.h>
#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>
#include <CGAL/L0_resampling/internal/normals/Local_normals.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the points around a sample are to it.
enum class Outcome_of_fit : unsigned char
{
  EXPLAINED,   ///< those of one sheet
  UNEXPLAINED, ///< see `is_unexplained()`
  LONELY,      ///< none is compatible
};

/// The input as the fit sees it.
template <typename T>
struct Fit_input
{
  const Search_grid_3& grid;
  const Buffer<Vector>& points;
  const Buffer<Eigen::Matrix<T, 3, 1>>& normals;
  const Buffer<T>& density_weights; ///< \f$ v_j \f$
  Fit_kernel<double> kernel;        ///< at scale 1
};

/// \param scales \f$ 1/v_j \f$ of the candidates
template <typename T>
Compatible_points<double> sum_compatible_points(const Eigen::Matrix<T, 3, 1>& center,
                                                const Eigen::Matrix<T, 3, 1>& normal,
                                                Local_points<T>& candidates,
                                                const Local_normals<T>& normals,
                                                const Aligned_vector<T>& scales,
                                                const Fit_kernel<T>& kernel)
{
  using L = Lanes<T>;
  Compatible_points<L> sums;
  candidates.for_each_run_in_ball(
    center, kernel.squared_radius(), [&](std::size_t k, const L& squared_distance) {
      sums.add(L::load(&candidates.x[k]) - center[0], L::load(&candidates.y[k]) - center[1],
               L::load(&candidates.z[k]) - center[2], squared_distance, L::load(&normals.x[k]),
               L::load(&normals.y[k]), L::load(&normals.z[k]),
               share_in_ball(squared_distance, kernel.squared_radius()) * L::load(&scales[k]),
               normal[0], normal[1], normal[2], kernel);
    });
  return sums.template transformed<double>([](const L& lanes) { return lanes.sum(); });
}

/// The unit normal that most of the points of a ball agree with, of any sign, and the sample's own:
/// the largest eigenvector of \f$ w n_i n_i^T + \sum_j \theta n_j n_j^T / v_j \f$.
/// \param weight \f$ w \f$ of the sample's own
template <typename T>
Vector normal_of_most(const Eigen::Matrix<T, 3, 1>& center, const Vector& normal, double weight,
                      Local_points<T>& candidates, const Local_normals<T>& normals,
                      const Aligned_vector<T>& scales, const Fit_kernel<T>& kernel)
{
  using L = Lanes<T>;
  Plane_moments<L> lanes;
  candidates.for_each_run_in_ball(
    center, kernel.squared_radius(), [&](std::size_t k, const L& squared_distance) {
      const L scale = share_in_ball(squared_distance, kernel.squared_radius())
                      * L::load(&scales[k]);
      lanes.add(L::load(&normals.x[k]), L::load(&normals.y[k]), L::load(&normals.z[k]),
                scale * gaussian_weight(squared_distance, kernel.squared_bandwidth));
    });
  Plane_moments<double> moments = sum_of_lanes(lanes);
  moments.add(normal.x(), normal.y(), normal.z(), weight);
  const Triple most = moments.main_direction();
  return {most.x, most.y, most.z};
}

/*!
The fit term of the default method. Where the paper draws a sample to the mean of all points of its
ball, which cuts corners and shrinks what is curved, this one looks at points of its own side of an
edge and its own sheet only, each weighted by \f$ w_j = \theta \psi e^{-h_{ij}^2/H^2} / v_j \f$, and
at their `symmetric_height()` over it,

\f[ h_i = \sum_j w_j h_{ij} / \sum_j w_j, \qquad h_{ij} = \tfrac12 (n_i + n_j)^T (q_j - p_i). \f]

The sample is drawn to \f$ c_i = p_i + h_i n_i \f$: along its normal, so that it does not retreat
from edges and borders. Only beyond them, where the weighted mean of the points lies more of their
standard deviations off in the plane than that of half a ball, is it drawn back (`Border_of_ball`).
A sample that hardly any of its points agree with, as one that began at the noisiest of them or at
an outlier, takes the normal of most of them before, and a sheet as high as the ball, in which it
finds the others (`Unsupported_sample`). One whose points scatter more than those of one sheet do
looks again at a lower sheet (`squared_sheet_height_among()`). Where there still are no compatible
points, it is drawn to the last \f$ c_i \f$ it had. All transitions are continuous, so rounding
errors are not amplified.

The normal of the sample becomes the weighted mean of those points' normals.

\param samples in: positions, normals and the last fit centroids; out: normals, fit weights and
variances, fit centroids and outward directions
\param noises out, unless null: of the points around each sample, see `noise_of_fit()`; as many as
samples
\param outcomes out, unless null: where they are not `EXPLAINED`; as many as samples
*/
template <typename ConcurrencyTag, typename T, typename FT>
void fit_compatible_points(const Fit_input<T>& input, Progress& progress, Samples<FT>& samples,
                           Buffer<float>* noises = nullptr,
                           Buffer<Outcome_of_fit>* outcomes = nullptr)
{
  const double cell_size = input.grid.cell_size();
  const Sorted_queries sorted_queries(ConcurrencyTag(), samples.positions,
                                      Cell_sizes(cell_size, samples.scales));

  const Fit_kernel<T> kernel_of_one = input.kernel.template as<T>();
  const Border_of_ball border(input.kernel.radius, input.kernel.squared_bandwidth);
  const auto make_visitor = [&]() {
    return [&, normals = Local_normals<T>(),
            scales = Aligned_vector<T>()](Search_grid_3::Range queries, Local_points<T>& candidates,
                                          const Vector& origin) mutable {
      normals.gather(candidates, input.normals);
      scales.assign(candidates.padded_size(), T(0));
      for (std::size_t k = 0; k < candidates.indices.size(); ++k)
        scales[k] = 1 / input.density_weights[candidates.indices[k]];

      for (Index q = queries.first; q < queries.second; ++q)
      {
        const Index i = sorted_queries.order[q];
        const Eigen::Matrix<T, 3, 1> center =
          (sorted_queries.points[q] - origin).template cast<T>();
        Vector old_normal = samples.normals[i].template cast<double>();
        const double scale = sorted_queries.grid.scale(q);
        const Fit_kernel<T> kernel = kernel_of_one.scaled(T(scale));
        const auto sums_with = [&](const Fit_kernel<T>& own_kernel) {
          return sum_compatible_points<T>(center, old_normal.cast<T>(), candidates, normals, scales,
                                          own_kernel);
        };
        Compatible_points<double> sums = sums_with(kernel);
        const Unsupported_sample support(sums.weight(), sums.all, kernel.squared_sheet_height,
                                         kernel.squared_radius());
        const double own_sheet_height = squared_height_of_second_look(support, sums,
                                                                      kernel.squared_sheet_height);
        if (outcomes && is_unexplained(support, sums, kernel.squared_sheet_height))
          (*outcomes)[i] = Outcome_of_fit::UNEXPLAINED;
        if (noises) // now, as a lower sheet has less of it
          (*noises)[i] = float(noise_of_fit(sums, kernel));
        if (support.is_unsupported)
          old_normal = normal_of_most(center, old_normal, support.weight_of_own_normal, candidates,
                                      normals, scales, kernel);
        if (own_sheet_height != kernel.squared_sheet_height)
        {
          Fit_kernel<T> own_kernel = kernel;
          own_kernel.squared_sheet_height = T(own_sheet_height);
          sums = sums_with(own_kernel);
          if (noises && support.is_unsupported)
            (*noises)[i] = float(noise_of_fit(sums, own_kernel));
        }

        const Fit_of_sample fit(sums, {old_normal.x(), old_normal.y(), old_normal.z()}, border,
                                scale);
        const auto vector_of = [](const Triple& v) { return Vector(v.x, v.y, v.z); };
        samples.outward_directions[i] = vector_of(fit.outward).template cast<FT>();
        samples.fit_variances[i] = FT(fit.variance);
        if (!fit.has_points)
        {
          if (outcomes)
            (*outcomes)[i] = Outcome_of_fit::LONELY;
          samples.fit_weights[i] = 1;
          continue;
        }
        samples.fit_weights[i] = FT(sums.weight());
        samples.fit_centroids[i] = samples.positions[i] + vector_of(fit.to_centroid);
        if (fit.has_new_normal)
          samples.normals[i] = vector_of(fit.normal).template cast<FT>();
      }
    };
  };
  for_each_cell<T, ConcurrencyTag>(sorted_queries.grid, sorted_queries.points, input.grid,
                                   input.points, cells_in_reach(input.kernel.radius, cell_size),
                                   progress, make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIT_COMPATIBLE_POINTS_H
