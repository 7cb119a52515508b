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
#include <CGAL/L0_resampling/internal/samples/Gathered_values.h>
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
  Buffer<Local_vector> normals;
  Buffer<Local> variances; ///< \f$ u_k \f$, `Samples::fit_variances`
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
      normals.push_back(samples.normals[i].template cast<Local>());
      variances.push_back(Local(samples.fit_variances[i]));
      if (!samples.scales.empty())
        scales.push_back(samples.scales[i]);
    });
  }
};

/// Sums over the support points of a wide ball that agree with a sample, lengths in units of its
/// radius.
struct Agreeing_support_points
{
  Quadric_moments<double> moments;
  double variance; ///< \f$ \sum_k w_k u_k \f$
};

inline Agreeing_support_points sum_agreeing_support_points(
  const Local_vector& center, const Tangent_frame& frame, Local_points<Local>& candidates,
  const Local_normals<Local>& normals, const Gathered_values<Local, 1>& variances,
  const Fit_kernel<Local>& kernel)
{
  using L = Lanes<Local>;
  const Local unit = 1 / kernel.radius;
  const auto in_single_precision = [](const Triple& a) {
    return Local_vector(Local(a.x), Local(a.y), Local(a.z));
  };
  const Local_vector u = in_single_precision(frame.u), v = in_single_precision(frame.v),
                     normal = in_single_precision(frame.normal);
  const auto dot = [](const L& x, const L& y, const L& z, const Local_vector& a) {
    return x * a[0] + y * a[1] + z * a[2];
  };
  Quadric_moments<L> lanes;
  L variance;
  candidates.for_each_run_in_ball(
    center, kernel.squared_radius(), [&](std::size_t k, const L& squared_distance) {
      const L dx = L::load(&candidates.x[k]) - center[0];
      const L dy = L::load(&candidates.y[k]) - center[1];
      const L dz = L::load(&candidates.z[k]) - center[2];
      const Seen_point<L> point(dx, dy, dz, L::load(&normals.x[k]), L::load(&normals.y[k]),
                                L::load(&normals.z[k]), normal[0], normal[1], normal[2]);
      const L weight = weight_in_ball(squared_distance, point.cosine, point.height, kernel);
      lanes.add(dot(dx, dy, dz, u) * unit, dot(dx, dy, dz, v) * unit, point.own_height * unit,
                weight);
      variance += weight * variances.load(0, k);
    });
  return {Quadric_moments<double>(lanes, [](const L& sum) { return double(sum.sum()); }),
          double(variance.sum()) / square(double(kernel.radius))};
}

/// `project_to_local_quadric()`, compiled by itself: where it is a part of what surrounds it,
/// compilers fuse other sums of products with it than without, and two programs of one source would
/// differ in the last bit.
BOOST_NOINLINE inline Settled_sample settled_sample(const Agreeing_support_points& sums,
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
void project_to_local_quadrics(const Fit_kernel<double>& kernel, double smallest_cell_size,
                               Progress& progress, Samples<FT>& samples)
{
  const double cell_size = (std::max)(kernel.radius / 2, smallest_cell_size);
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
    return [&, normals = Local_normals<Local>(), variances = Gathered_values<Local, 1>()](
             Search_grid_3::Range queries, Local_points<Local>& candidates,
             const Vector& origin) mutable {
      normals.gather(candidates, support_points.normals);
      variances.gather(candidates,
                       [&](Index k, Local(&own)[1]) { own[0] = support_points.variances[k]; });
      for (Index q = queries.first; q < queries.second; ++q)
      {
        const Index i = sorted_queries.order[q];
        const Local_vector center = (sorted_queries.points[q] - origin).template cast<Local>();
        const Vector normal = samples.normals[i].template cast<double>();
        const Fit_kernel<double> own_kernel = kernel.scaled(sorted_queries.grid.scale(q));
        const Tangent_frame frame({normal.x(), normal.y(), normal.z()});
        const Agreeing_support_points sums = sum_agreeing_support_points(
          center, frame, candidates, normals, variances, own_kernel.template as<Local>());
        const Settled_sample settled = settled_sample(sums, frame, own_kernel.radius);
        samples.positions[i] += settled.height * normal;
        samples.normals[i] =
          Vector(settled.normal.x, settled.normal.y, settled.normal.z).template cast<FT>();
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(sorted_queries.grid, sorted_queries.points, support_grid,
                                       support_points.positions,
                                       cells_in_reach(kernel.radius, cell_size), progress,
                                       make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PROJECT_TO_LOCAL_QUADRICS_H
