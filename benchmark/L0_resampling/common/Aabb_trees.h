// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_AABB_TREES_H
#define CGAL_L0_RESAMPLING_BENCHMARK_AABB_TREES_H

#include "Triangle_mesh.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>

// CGAL 6 gave these classes other names.
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <vector>

namespace L0_benchmark {

using Segment_3 = Kernel::Segment_3;

using Triangle_iterator = std::vector<Triangle_3>::const_iterator;
using Segment_iterator = std::vector<Segment_3>::const_iterator;

#if CGAL_VERSION_NR >= 1060000000
template <class Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
using Triangle_primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangle_iterator>;
using Segment_primitive = CGAL::AABB_segment_primitive_3<Kernel, Segment_iterator>;
#else
template <class Primitive>
using Aabb_tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Triangle_primitive = CGAL::AABB_triangle_primitive<Kernel, Triangle_iterator>;
using Segment_primitive = CGAL::AABB_segment_primitive<Kernel, Segment_iterator>;
#endif

// Trees hold iterators into vectors, which must outlive them.
using Triangle_tree = Aabb_tree<Triangle_primitive>;
using Segment_tree = Aabb_tree<Segment_primitive>;

/// The triangles that have an area.
inline std::vector<Triangle_3> proper_triangles(const Triangle_mesh& mesh)
{
  std::vector<Triangle_3> triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!mesh.triangle(t).is_degenerate())
      triangles.push_back(mesh.triangle(t));
  return triangles;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_AABB_TREES_H
