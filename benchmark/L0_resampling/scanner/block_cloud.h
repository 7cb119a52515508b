// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_BLOCK_CLOUD_H
#define CGAL_L0_RESAMPLING_BENCHMARK_BLOCK_CLOUD_H

#include "Scene_stream.h"

#include <basis/Point_cloud.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace L0_benchmark {

/// The points of a scan with the properties classification, of `Surface_kind`, and view, the number
/// of the station.
/// \param with_truth also nx, ny, nz, the normal of the surface, and true_dx, true_dy, true_dz, the
/// way to what the ray met; all are 0 for an outlier
inline l0_tool::Point_cloud cloud_of_points(const Scene_stream& stream, std::uint64_t first,
                                            std::uint64_t last, bool with_truth)
{
  using l0_tool::Number_type;
  l0_tool::Point_cloud cloud;
  cloud.properties.add_property("classification", Number_type::UINT8);
  cloud.properties.add_property("view", Number_type::UINT32);
  if (with_truth)
    for (const char* name : {"true_dx", "true_dy", "true_dz"})
      cloud.properties.add_property(name, Number_type::FLOAT32);
  const std::size_t size = std::size_t(last - first);
  cloud.points.reserve(size);
  cloud.normals.reserve(with_truth ? size : 0);
  cloud.properties.reserve(size);

  std::vector<char> row(cloud.properties.row_size());
  stream.for_each(first, last, [&](const Streamed_point& point) {
    const Vector_3 way = point.exact.point - point.position;
    const double values[] = {double(point.kind), double(point.view), way.x(), way.y(), way.z()};
    for (std::size_t k = 0; k < cloud.properties.properties().size(); ++k) {
      const l0_tool::Property& property = cloud.properties.properties()[k];
      l0_tool::encode(values[k], property.type, row.data() + property.offset);
    }
    cloud.points.push_back(point.position);
    if (with_truth)
      cloud.normals.push_back(point.exact.normal);
    cloud.properties.append(row.data());
  });

  // All blocks are on one lattice.
  l0_tool::Las_origin lattice;
  lattice.global_encoding = l0_tool::Las_origin::wkt;
  lattice.scale.fill(Scene_stream::resolution);
  cloud.las = lattice;
  return cloud;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_BLOCK_CLOUD_H
