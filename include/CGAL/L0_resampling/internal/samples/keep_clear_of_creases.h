// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_KEEP_CLEAR_OF_CREASES_H
#define CGAL_L0_RESAMPLING_INTERNAL_KEEP_CLEAR_OF_CREASES_H

#include <CGAL/L0_resampling/internal/kernels/clearance.h>
#include <CGAL/L0_resampling/internal/normals/Local_normals.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Slides samples that are nearer to the other face of a crease than `clearance_per_spacing`, or beyond
it, back on their own: a sample on the edge counts for either face, and one beyond it has the wrong
normal.

\param bends of the surface at each sample
\param spacing of the samples
\param positions, normals of the samples, in and out
*/
template <typename ConcurrencyTag>
void keep_clear_of_creases(const Buffer<Bend>& bends, double spacing, double minimum_cell_size,
                           Progress& progress, Buffer<Vector>& positions,
                           Buffer<Local_vector>& normals)
{
  using L = Lanes<Local>;
  const double range = reach_of_clearance * spacing,
               cell_size = (std::max)(range, minimum_cell_size);
  const Sorted_queries sorted(ConcurrencyTag(), positions, Cell_sizes(cell_size));
  const Buffer<Local_vector> sorted_normals = values_in_order<ConcurrencyTag>(sorted.order,
                                                                              normals);
  const auto triple = [](const auto& v) {
    return Triple{double(v[0]), double(v[1]), double(v[2])};
  };
  const auto make_visitor = [&]() {
    return [&, around = Local_normals<Local>()](Search_grid_3::Range queries,
                                                Local_points<Local>& candidates,
                                                const Vector& origin) mutable {
      around.gather(candidates, sorted_normals);
      for (Index q = queries.first; q < queries.second; ++q)
      {
        const Eigen::Matrix<Local, 3, 1> center =
                                           (sorted.points[q] - origin).template cast<Local>(),
                                         normal = sorted_normals[q];
        Faces_around faces;
        L own_x, own_y, own_z, own_weight;
        const Local per_squared_range = Local(1 / square(range));
        candidates.for_each_run_in_ball(
          center, Local(square(range)), [&](std::size_t first, const L& squared_distances) {
            const L cosines = abs(L::load(&around.x[first]) * normal[0]
                                  + L::load(&around.y[first]) * normal[1]
                                  + L::load(&around.z[first]) * normal[2]);
            const L near = at_least(L(Local(1)) - squared_distances * per_squared_range, 0),
                    own = where_less(-cosines, -maximum_cosine_across_crease, near);
            own_x += own * (L::load(&candidates.x[first]) - center[0]);
            own_y += own * (L::load(&candidates.y[first]) - center[1]);
            own_z += own * (L::load(&candidates.z[first]) - center[2]);
            own_weight += own;
            if (!any_less(cosines, maximum_cosine_across_crease))
              return;
            Local cosine[L::size], squared_distance[L::size];
            cosines.store(cosine);
            squared_distances.store(squared_distance);
            for (int lane = 0; lane < L::size; ++lane)
            {
              const std::size_t k = first + std::size_t(lane);
              const double weight = 1 - double(squared_distance[lane]) / square(range);
              if (weight > 0 && cosine[lane] < maximum_cosine_across_crease)
                faces.add({around.x[k], around.y[k], around.z[k]},
                          {double(center[0] - candidates.x[k]), double(center[1] - candidates.y[k]),
                           double(center[2] - candidates.z[k])},
                          weight);
            }
          });
        const double weight = double(own_weight.sum());
        if (weight > 0)
          faces.set_own_face({double(own_x.sum()) / weight, double(own_y.sum()) / weight,
                              double(own_z.sum()) / weight});
        const Triple way = faces.way_out(triple(normal), spacing);
        if (!(dot(way, way) > 0))
          continue;
        const Index i = sorted.order[q];
        const Slide slide(way, triple(normal), bends[i]);
        positions[i] += Vector(slide.way.x, slide.way.y, slide.way.z);
        normals[i] = Vector(slide.normal.x, slide.normal.y, slide.normal.z).cast<Local>();
      }
    };
  };
  for_each_cell<Local, ConcurrencyTag>(sorted.grid, sorted.points, sorted.grid, sorted.points, 1,
                                       progress, make_visitor);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_KEEP_CLEAR_OF_CREASES_H
