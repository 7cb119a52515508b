// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NORMALS_OF_FACES_H
#define L0_RESAMPLE_NORMALS_OF_FACES_H

#include "basis/Point_cloud.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace l0_tool {

/// Which normals the corners of faces give to the vertices, as OBJ has it. Each normal of a vertex
/// counts once, however many faces name it.
class Normals_of_faces
{
  using Corner = std::pair<std::uint64_t, std::uint64_t>; // a vertex and its normal

  std::vector<Corner> m_corners;
  std::size_t m_number_of_different = 0; // at the begin, in their order

  void remove_equal_ones();

public:
  void add(std::uint64_t vertex, std::uint64_t normal);

  bool are_there() const { return !m_corners.empty(); }

  /// In bytes.
  std::uint64_t size() const { return m_corners.capacity() * sizeof(Corner); }

  /// The mean of the normals of each vertex, with length 1: 0 for a vertex without any.
  /// \param number_left_out of corners that name a vertex or a normal that is not there
  std::vector<Vector> means(const std::vector<Vector>& normals, std::size_t number_of_vertices,
                            std::uint64_t& number_left_out);
};

} // namespace l0_tool

#endif // L0_RESAMPLE_NORMALS_OF_FACES_H
