// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Normals_of_faces.h"

#include <algorithm>
#include <cmath>

namespace l0_tool {

void Normals_of_faces::remove_equal_ones()
{
  const auto middle = m_corners.begin() + std::ptrdiff_t(m_number_of_different);
  std::sort(middle, m_corners.end());
  std::inplace_merge(m_corners.begin(), middle, m_corners.end());
  m_corners.erase(std::unique(m_corners.begin(), m_corners.end()), m_corners.end());
  m_number_of_different = m_corners.size();
}

void Normals_of_faces::add(std::uint64_t vertex, std::uint64_t normal)
{
  // A vertex of a mesh has six corners, mostly with one normal: they are put together so seldom
  // that it takes little time, and so often that they take little memory
  constexpr std::size_t minimum_number = 1 << 16;
  if (m_corners.size() >= 2 * m_number_of_different + minimum_number)
    remove_equal_ones();
  m_corners.emplace_back(vertex, normal);
}

std::vector<Vector> Normals_of_faces::means(const std::vector<Vector>& normals,
                                            std::size_t number_of_vertices,
                                            std::uint64_t& number_left_out)
{
  remove_equal_ones();
  std::vector<Vector> means(number_of_vertices, CGAL::NULL_VECTOR);
  number_left_out = 0;
  for (const auto& [vertex, normal] : m_corners)
    if (vertex < number_of_vertices && normal < normals.size())
      means[std::size_t(vertex)] += normals[std::size_t(normal)];
    else
      ++number_left_out;
  for (Vector& mean : means) {
    const double length = std::sqrt(mean.squared_length());
    mean = length > 0 ? Vector(mean / length) : Vector(CGAL::NULL_VECTOR);
  }
  return means;
}

} // namespace l0_tool
