// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orient.h"

#include "named_parameters_of.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_orient_normals.h>
#include <CGAL/property_map.h>

#include <boost/range/irange.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace l0_python {

template <typename FT>
Oriented_normals<FT> orient(const Array_view& points, const Vectors_of_points<Array_view>& vectors,
                            const Parameters& parameters,
                            const std::function<bool(double)>& callback)
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  std::vector<typename Kernel::Vector_3> normals(points.size, CGAL::NULL_VECTOR);
  for (std::size_t i = 0; vectors.normals && i < points.size; ++i)
    normals[i] = {FT(vectors.normals->at(i, 0)), FT(vectors.normals->at(i, 1)),
                  FT(vectors.normals->at(i, 2))};
  Oriented_normals<FT> result;
  const auto hints = vectors.orientation_hints
                       ? std::make_optional(Normal_map{*vectors.orientation_hints})
                       : std::nullopt;
  const auto viewpoints = vectors.viewpoints ? std::make_optional(Point_map{*vectors.viewpoints})
                                             : std::nullopt;
  auto range = boost::irange(std::size_t(0), points.size);
  const auto orient_with = [&](auto tag) {
    CGAL::l0_orient_normals<decltype(tag)>(range,
                                           named_parameters_of(parameters, callback, result.report)
                                             .orientation_hint_map(hints)
                                             .viewpoint_map(viewpoints)
                                             .point_map(Point_map{points})
                                             .normal_map(CGAL::make_property_map(normals))
                                             .geom_traits(Kernel()));
  };
  const auto on_device = [&] {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    orient_with(CGAL::CUDA_tag());
#endif
  };
  in_arena(parameters, [&] {
    const std::string reason =
      l0_common::run_on_chosen({parameters.device, "device='cuda'", ""}, on_device,
                               [&] { orient_with(CGAL::Parallel_if_available_tag()); });
    result.report.device_reason = reason;
  });
  result.normals.reserve(3 * normals.size());
  for (const auto& n : normals)
    result.normals.insert(result.normals.end(), {n.x(), n.y(), n.z()});
  return result;
}

template Oriented_normals<float> orient(const Array_view&, const Vectors_of_points<Array_view>&,
                                        const Parameters&, const std::function<bool(double)>&);
template Oriented_normals<double> orient(const Array_view&, const Vectors_of_points<Array_view>&,
                                         const Parameters&, const std::function<bool(double)>&);

} // namespace l0_python
