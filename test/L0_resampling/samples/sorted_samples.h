// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_SORTED_SAMPLES_H
#define CGAL_L0_RESAMPLING_TEST_SORTED_SAMPLES_H

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/kernels/surface_of_disks.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <vector>

namespace test {

inline Triple triple(const Vector& v) { return {v.x(), v.y(), v.z()}; }

/// None, which means 1 for all; or scales that double along x from -1 to 1.
inline Buffer<float> make_scales(const std::vector<Vector>& points, bool are_even)
{
  Buffer<float> scales;
  if (!are_even)
    for (const Vector& p : points)
      scales.push_back(float(1 + p.x() / 3));
  return scales;
}

/// Points with normals, sorted for a grid whose cells have the scales of the points.
struct Sorted_samples
{
  const Buffer<float> scales_before;
  const Sorted_queries sorted;
  Buffer<Local_vector> normals;

  Sorted_samples(const Oriented_points& samples, double cell_size, bool have_even_scales)
    : scales_before(make_scales(samples.points, have_even_scales)),
      sorted(CGAL::Sequential_tag(), to_buffer(samples.points),
             Cell_sizes(cell_size, scales_before)),
      normals(to_local_vectors<Local>(permuted(sorted.order, samples.normals)))
  {}

  std::size_t size() const { return sorted.points.size(); }
  const Vector& position(std::size_t i) const { return sorted.points[i]; }
  Vector normal(std::size_t i) const { return normals[i].cast<double>(); }
  double scale(std::size_t i) const { return double(sorted.grid.scale(i)); }
};

/// Samples a spacing apart on the square [-1, 1]^2 of the plane z = 0, each moved a little.
inline Oriented_points even_samples(double spacing, Generator& generator)
{
  Oriented_points samples;
  const int n = int(1 / spacing);
  for (int i = -n; i <= n; ++i)
    for (int k = -n; k <= n; ++k)
    {
      samples.points.push_back(spacing
                               * (Vector(i, k, 0) + random_vector(Vector(0.2, 0.2, 0), generator)));
      samples.normals.push_back(Vector::UnitZ());
    }
  return samples;
}

inline bool are_the_same(const Surface_of_disks& a, const Surface_of_disks& b)
{
  return a.height == b.height && a.slope_u == b.slope_u && a.slope_v == b.slope_v && a.uu == b.uu
         && a.uv == b.uv && a.vv == b.vv && a.height_variance == b.height_variance
         && a.slope_variance == b.slope_variance;
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_SORTED_SAMPLES_H
