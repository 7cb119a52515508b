// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Normals_behind_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace l0_tool {

Normals_behind_points::Normals_behind_points(Point_collector& collector, Named_columns& rows,
                                             std::optional<std::uint64_t> number_of_points)
  : m_collector(collector), m_rows(rows), m_number_of_points(number_of_points)
{
  if (number_of_points)
    collector.set_normals_behind();
}

bool Normals_behind_points::take(const std::vector<double>& row)
{
  if (!m_number_of_points || m_collector.number_of_rows() < *m_number_of_points)
    return false;
  if (m_vectors.size() == *m_number_of_points) {
    give_up();
    return false;
  }
  m_vectors.emplace_back(row[0], row[1], row[2]);
  m_collector.set_buffer_size(m_vectors.size() * sizeof(Vector));
  return true;
}

void Normals_behind_points::give_up()
{
  m_number_of_points.reset();
  for (const Vector& vector : m_vectors)
    m_rows.add({vector.x(), vector.y(), vector.z()});
  m_vectors = std::vector<Vector>(); // frees the memory, which clear() keeps
  m_collector.set_buffer_size(0);
}

void Normals_behind_points::hand_over()
{
  const auto is_unit_vector = [](const Vector& vector) {
    return is_unit_length(length_of(vector));
  };
  const auto may_be_normal = [&](const Vector& vector) {
    return vector == CGAL::NULL_VECTOR || is_unit_vector(vector)
           || !std::isfinite(vector.squared_length());
  };
  const bool are_normals = m_vectors.size() == m_number_of_points
                           && std::all_of(m_vectors.begin(), m_vectors.end(), may_be_normal)
                           && std::any_of(m_vectors.begin(), m_vectors.end(), is_unit_vector);
  if (!are_normals)
    return give_up();
  for (Vector& vector : m_vectors)
    vector = m_collector.unit_vector(vector);
  m_collector.set_normals(std::move(m_vectors));
}

} // namespace l0_tool
