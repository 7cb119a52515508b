// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIT_DISKS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIT_DISKS_H

#include <CGAL/L0_resampling/internal/kernels/project_to_local_quadric.h>
#include <CGAL/L0_resampling/internal/kernels/surface_of_disks.h>
#include <CGAL/L0_resampling/internal/normals/Local_normals.h>
#include <CGAL/L0_resampling/internal/samples/Gathered_values.h>
#include <CGAL/L0_resampling/internal/samples/merge_disks.h>

#include <boost/config.hpp>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The two fits, compiled by themselves: where they are a part of what surrounds them, compilers
/// fuse other sums of products, and two programs of one source would differ in the last bit.
BOOST_NOINLINE inline Surfaces_of_scale surfaces_of(const Moments_of_disks<double>& moments,
                                                    double radius, double squared_noise)
{
  return {moments.surface<3>(radius, squared_noise), moments.surface<6>(radius, squared_noise)};
}

/// Sums over the disks of a ball.
/// \param prediction the surface of the next smaller ball
inline Moments_of_disks<double> sum_disks(const Eigen::Matrix<Local, 3, 1>& center,
                                          const Tangent_frame& frame, double radius,
                                          const Surface_of_disks& prediction,
                                          const Weight_in_fit<Local>& weight_of,
                                          Local_points<Local>& candidates,
                                          const Local_normals<Local>& normals,
                                          const Gathered_values<Local, 2>& values)
{
  using L = Lanes<Local>;
  const auto dot = [](const L& x, const L& y, const L& z, const Triple& a) {
    return x * Local(a.x) + y * Local(a.y) + z * Local(a.z);
  };
  const Local unit = Local(1 / radius);
  Moments_of_disks<L> sums;
  candidates.for_each_run_in_ball(
    center, Local(radius * radius), [&](std::size_t k, const L& squared_distance) {
      const L nx = L::load(&normals.x[k]), ny = L::load(&normals.y[k]), nz = L::load(&normals.z[k]),
              height = values.load(0, k), fx = L::load(&candidates.x[k]) - center[0] + nx * height,
              fy = L::load(&candidates.y[k]) - center[1] + ny * height,
              fz = L::load(&candidates.z[k]) - center[2] + nz * height;
      const Seen_disk<L> disk = {
        dot(fx, fy, fz, frame.u), dot(fx, fy, fz, frame.v), dot(fx, fy, fz, frame.normal),
        dot(nx, ny, nz, frame.u), dot(nx, ny, nz, frame.v), dot(nx, ny, nz, frame.normal),
        squared_distance};
      sums.add(disk.u * unit, disk.v * unit, disk.h * unit, weight_of(disk, prediction),
               values.load(1, k));
    });
  return Moments_of_disks<double>(sums, [](const L& lanes) { return double(lanes.sum()); });
}

/// The samples that surfaces are fitted around, sorted for cells of the sizes of those of the
/// disks.
struct Samples_to_fit
{
  const Search_grid_3& grid;
  const Buffer<Vector>& positions;
  const Index* order; ///< which sample stands where in the grid; null if each in its own place
  const Buffer<Local_vector>& normals;
};

/*!
Fits a plane and a quadric to the disks of a ball around each sample.

\param reach of the largest ball, in cells
\param radius_of of the ball of a sample
\param deviation_of of the height of the disk of a sample
\param noise of a point
\param scale which of the radii
\param predictions in: the surface of the next smaller ball at each sample; out: of this one
*/
template <typename ConcurrencyTag, typename Radius, typename Deviation>
void fit_disks(const Samples_to_fit& samples, const Search_grid_3& disk_grid,
               const Fitted_disks& disks, int reach, const Radius& radius_of,
               const Deviation& deviation_of, double noise, int scale, Progress& progress,
               Buffer<Surface_of_disks>& predictions, Buffer<Surfaces_of_scale>& surfaces)
{
  const auto make_visitor = [&]() {
    return [&, normals = Local_normals<Local>(), values = Gathered_values<Local, 2>()](
             Search_grid_3::Range queries, Local_points<Local>& candidates,
             const Vector& origin) mutable {
      normals.gather(candidates, disks.normals);
      values.gather(candidates, [&](Index k, Local(&own)[2]) {
        own[0] = disks.heights[k];
        own[1] = disks.informations[k];
      });
      for (Index q = queries.first; q < queries.second; ++q)
      {
        const Index i = samples.order ? samples.order[q] : q;
        const double radius = radius_of(i);
        const Vector normal = samples.normals[i].template cast<double>();
        const Tangent_frame frame({normal.x(), normal.y(), normal.z()});
        const Moments_of_disks<double> moments = sum_disks(
          (samples.positions[q] - origin).template cast<Local>(), frame, radius, predictions[i],
          Weight_in_fit<Local>(radius, deviation_of(i)), candidates, normals, values);
        surfaces[i] = surfaces_of(moments, radius, noise * noise);
        predictions[i] = surfaces[i].prediction(scale, predictions[i]);
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(samples.grid, samples.positions, disk_grid, disks.positions,
                                       reach, progress, make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIT_DISKS_H
