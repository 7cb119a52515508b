// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/stages.cuh"
#include "kernels/Plane_fit.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/local_surface.h>

#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// `refit_sample_normals()` on the CPU, which says why.
/// \param rows whose fourth numbers are where the rows of the samples begin
/// \param normals and the variances of the fit
__global__ void refit(Neighbor_lists neighbors, Fit_kernel<float> kernel, const int4* rows,
                      const double* positions, Range_of_pairs range, unsigned size,
                      const float4* normals, float4* refitted)
{
  const Query query(size);
  const Wide i = query.index;
  const double3 center = {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
  const float4 own = normals[i];
  const float3 normal = xyz(own);
  const float own_limit = range.limit(query.index);
  Plane_moments<float> moments;
  const uint2 row = neighbors.row(rows, size, query.index);
  for (Wide e = Wide(row.x) + query.lane; e < row.y; e += lanes)
  {
    const Wide k = neighbors.indices[e];
    const float3 d = to_float(double3{positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]}
                              - center);
    const float4 other = normals[k];
    const float squared_stretch = range.is_one_for_all()
                                    ? 1.f
                                    : kernel.squared_radius()
                                        / range.squared(own_limit, range.limit(unsigned(k)));
    Seen_point<float> point = seen_point(d, xyz(other), normal);
    point.height *= sqrtf(squared_stretch);
    moments.add(d.x, d.y, d.z,
                weight_in_ball(dot(d, d) * squared_stretch, point.cosine, point.height, kernel));
  }
  Plane_moments<double> all = sum_of_group<lanes>(moments);
  if (!query.writes)
    return;
  all.add(0, 0, 0, 1); // the sample itself
  const Triple leaning = lean_to_plane(all, {normal.x, normal.y, normal.z});
  refitted[i] = with_w(to_float(leaning), own.w);
}

} // namespace

void refit_sample_normals(const Workplace& workplace, const Fit_kernel<double>& kernel,
                          const Cell_grid& sample_grid, const Neighbor_lists& neighbors,
                          const Samples& samples)
{
  const Arena_scope scope(workplace.scratch);
  float4* const refitted = workplace.scratch.take<float4>(samples.size);
  refit<<<blocks_for_queries(samples.size), threads_per_block, 0, workplace.stream>>>(
    neighbors, kernel.as<float>(), sample_grid.points, samples.positions,
    {float(kernel.radius), samples.scales, samples.spreading_radii}, samples.size, samples.normals,
    refitted);
  check_launch("refit");
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(samples.normals, refitted, samples.size * sizeof(float4),
                                     cudaMemcpyDeviceToDevice, workplace.stream));
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
