// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_POINT_ROWS_H
#define L0_RESAMPLE_POINT_ROWS_H

#include "basis/Point_cloud.h"

#include <cstddef>
#include <vector>

namespace l0_tool {

/// Points with normals and properties, whoever holds them. They are for one thread at a time, as
/// some are read from files when they are asked for; then a point, or a row of properties, stays
/// until the next one is.
class Point_rows
{
public:
  virtual ~Point_rows() = default;
  virtual std::size_t size() const = 0;
  virtual const Point& point(std::size_t i) const = 0;
  virtual Vector normal(std::size_t i) const = 0; ///< 0 if there are none
  /// What they are; with the rows where these are in memory.
  virtual const Property_table& properties() const = 0;
  virtual const char* property_row(std::size_t i) const { return properties().row(i); }

  double value(std::size_t i, const Property& property) const
  {
    return decode(property_row(i) + property.offset, property.type, false);
  }
};

/// What is written of a result.
class Oriented_rows : public Point_rows
{
  const std::vector<Oriented_point>& m_points;
  const Property_table& m_properties;

public:
  Oriented_rows(const std::vector<Oriented_point>& points, const Property_table& properties)
    : m_points(points), m_properties(properties)
  {}

  std::size_t size() const override { return m_points.size(); }
  const Point& point(std::size_t i) const override { return m_points[i].first; }
  Vector normal(std::size_t i) const override { return m_points[i].second; }
  const Property_table& properties() const override { return m_properties; }
};

/// What a file held.
class Cloud_rows : public Point_rows
{
  const Point_cloud& m_cloud;

public:
  explicit Cloud_rows(const Point_cloud& cloud) : m_cloud(cloud) {}

  std::size_t size() const override { return m_cloud.points.size(); }
  const Point& point(std::size_t i) const override { return m_cloud.points[i]; }
  Vector normal(std::size_t i) const override
  {
    return m_cloud.normals.empty() ? Vector(0, 0, 0) : m_cloud.normals[i];
  }
  const Property_table& properties() const override { return m_cloud.properties; }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_POINT_ROWS_H
