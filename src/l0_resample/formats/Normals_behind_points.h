// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NORMALS_BEHIND_POINTS_H
#define L0_RESAMPLE_NORMALS_BEHIND_POINTS_H

#include "basis/Point_cloud.h"
#include "formats/Named_columns.h"
#include "formats/Point_collector.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace l0_tool {

/// Rows of three numbers behind the points that a text has announced: their normals if there are as
/// many rows, all of length 1, 0 or NaN, and else further points.
class Normals_behind_points
{
  Point_collector& m_collector;
  Named_columns& m_rows;
  std::optional<std::uint64_t> m_number_of_points; // unless there can be no normals
  std::vector<Vector> m_vectors;

public:
  /// Before the first row.
  /// \param number_of_points those announced, or nothing if there can be no normals
  Normals_behind_points(Point_collector& collector, Named_columns& rows,
                        std::optional<std::uint64_t> number_of_points);

  /// \returns whether the row is kept as one that may be a normal; else it is a point
  bool take(const std::vector<double>& row);

  /// Says that all rows so far are points.
  void give_up();

  /// After the last row.
  void hand_over();
};

} // namespace l0_tool

#endif // L0_RESAMPLE_NORMALS_BEHIND_POINTS_H
