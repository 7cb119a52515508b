// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRICS_H
#define CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRICS_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/Quadric_moments.h>
#include <CGAL/L0_resampling/internal/kernels/project_to_local_quadric.h>
#include <CGAL/L0_resampling/internal/normals/Local_normals.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The samples that planes and quadrics are fitted to.
struct Support_points
{
  Buffer<Vector> positions;
  Buffer<Vector> normals;
  Buffer<double> variances; ///< \f$ u_k \f$, `Samples::fit_variances`
  Buffer<float> scales;

  template <typename FT>
  explicit Support_points(const Samples<FT>& samples)
    : positions(samples.positions.get_allocator()), normals(positions.get_allocator()),
      variances(positions.get_allocator()), scales(positions.get_allocator())
  {
    for_each_in_order(samples.positions.size(), [&](std::size_t i) {
      if (!samples.are_support_points[i])
        return;
      positions.push_back(samples.positions[i]);
      normals.push_back(samples.normals[i].template cast<double>());
      variances.push_back(double(samples.fit_variances[i]));
      if (!samples.scales.empty())
        scales.push_back(samples.scales[i]);
    });
  }
};

/// Sums over the support points of a wide ball that agree with a sample, lengths in units of its
/// radius, in double precision: what the points scatter about a surface is a small difference of
/// them.
struct Agreeing_support_points
{
  Quadric_moments<double> moments;
  double variance; ///< \f$ \sum_k w_k u_k \f$
};

inline Agreeing_support_points sum_agreeing_support_points(const Vector& center,
                                                           const Tangent_frame& frame,
                                                           Local_points<double>& candidates,
                                                           const Local_normals<double>& normals,
                                                           const Aligned_vector<double>& variances,
                                                           const Fit_kernel<double>& kernel)
{
  using L = Lanes<double>;
  const double unit = 1 / kernel.radius;
  const Triple& normal = frame.normal;
  const auto dot = [](const L& x, const L& y, const L& z, const Triple& a) {
    return x * a.x + y * a.y + z * a.z;
  };
  Quadric_moments<L> lanes;
  L variance;
  candidates.for_each_run_in_ball(
    center, kernel.squared_radius(), [&](std::size_t k, const L& squared_distance) {
      const L dx = L::load(&candidates.x[k]) - center[0];
      const L dy = L::load(&candidates.y[k]) - center[1];
      const L dz = L::load(&candidates.z[k]) - center[2];
      const Seen_point<L> point(dx, dy, dz, L::load(&normals.x[k]), L::load(&normals.y[k]),
                                L::load(&normals.z[k]), normal.x, normal.y, normal.z);
      const L weight = weight_in_ball(squared_distance, point.cosine, point.height, kernel);
      lanes.add(dot(dx, dy, dz, frame.u) * unit, dot(dx, dy, dz, frame.v) * unit,
                point.own_height * unit, weight);
      variance += weight * L::load(&variances[k]);
    });
  return {Quadric_moments<double>(lanes, [](const L& sum) { return sum.sum(); }),
          variance.sum() / square(kernel.radius)};
}

/// `project_to_local_quadric()`, compiled by itself: where it is a part of what surrounds it,
/// compilers fuse other sums of products with it than without, and two programs of one source would
/// differ in the last bit.
BOOST_NOINLINE inline Projected_sample projected_sample(const Agreeing_support_points& sums,
                                                        const Tangent_frame& frame, double radius)
{
  return project_to_local_quadric(sums.moments, sums.variance, frame, radius);
}

/*!
Where the surface is flat, or bends evenly, a wider ball tells more of it than the fit's does. A
sample looks at the samples of a ball \f$ R = 4 r_p \f$ that agree with it, weighted by
\f$ w_k = \psi \, e^{-h_{ik}^2/H^2} \f$, and at two surfaces through them: the plane of least
squared distances, and the quadric of least squared heights over the sample's tangent plane. The
sample moves along its normal by the share of `share_of_surface()`, to the quadric first, then to
the plane, and its normal turns to the surface's by as much. What is believed is a variance of
\f$ (\rho \tau)^2 \f$, so that one factor of the share is

\f[ e^{-(s^2 / (\rho \tau)^2)^2}, \qquad s^2 = \sum_k w_k r_k^2 / W,
\quad \tau^2 = \sum_k w_k u_k / W, \quad W = \sum_k w_k, \quad \rho = 3. \f]

\f$ r_k \f$ are the residuals, so that s is how far they are from it, and \f$ \tau \f$ how far the
noise of the points lets the fit be: the choice between a small ball and a large one is Lepski's
(1991), who takes the largest estimate that does not contradict the smaller ones. Where detail
stands out from the noise, both shares are zero. Clean points have no \f$ \tau \f$, and stay.

Neighboring fits share most of their points, so few of the samples tell as much as all do: only
`Samples::are_support_points` are asked.

\param samples positions and normals, in and out
*/
template <typename ConcurrencyTag, typename FT>
void project_to_local_quadrics(const Fit_kernel<double>& kernel, double minimum_cell_size,
                               Progress& progress, Samples<FT>& samples)
{
  const double cell_size = (std::max)(kernel.radius / 2, minimum_cell_size);
  Support_points support_points(samples);
  {
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(
      support_points.positions, Cell_sizes(cell_size, support_points.scales));
    apply_order(order, support_points.positions);
    apply_order(order, support_points.normals);
    apply_order(order, support_points.variances);
    if (!support_points.scales.empty())
      apply_order(order, support_points.scales);
  }
  const Search_grid_3 support_grid(ConcurrencyTag(), support_points.positions,
                                   Cell_sizes(cell_size, support_points.scales));
  const Sorted_queries sorted_queries(ConcurrencyTag(), samples.positions,
                                      Cell_sizes(cell_size, samples.scales));

  const auto make_visitor = [&]() {
    return [&, normals = Local_normals<double>(), variances = Aligned_vector<double>()](
             Search_grid_3::Range queries, Local_points<double>& candidates,
             const Vector& origin) mutable {
      normals.gather(candidates, support_points.normals);
      variances.assign(candidates.padded_size(), 0);
      for (std::size_t k = 0; k < candidates.indices.size(); ++k)
        variances[k] = support_points.variances[candidates.indices[k]];
      for (Index q = queries.first; q < queries.second; ++q)
      {
        const Index i = sorted_queries.order[q];
        const Vector center = sorted_queries.points[q] - origin;
        const Vector normal = samples.normals[i].template cast<double>();
        const Fit_kernel<double> own_kernel = kernel.scaled(sorted_queries.grid.scale(q));
        const Tangent_frame frame({normal.x(), normal.y(), normal.z()});
        const Agreeing_support_points sums =
          sum_agreeing_support_points(center, frame, candidates, normals, variances, own_kernel);
        const Projected_sample settled = projected_sample(sums, frame, own_kernel.radius);
        samples.positions[i] += settled.height * normal;
        samples.normals[i] =
          Vector(settled.normal.x, settled.normal.y, settled.normal.z).template cast<FT>();
      }
    };
  };
  for_each_cell<double, ConcurrencyTag>(sorted_queries.grid, sorted_queries.points, support_grid,
                                        support_points.positions,
                                        cells_in_reach(kernel.radius, cell_size), progress,
                                        make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRICS_H
