// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SAMPLE_OF_SURFACE_H
#define L0_RESAMPLE_SAMPLE_OF_SURFACE_H

#include "basis/Point_cloud.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace l0_tool {

/// Every so many of the points of a cloud, enough to see what its surface is like, and a tree of
/// them. Several threads may search at once.
class Sample_of_surface
{
  using Points_by_index = CGAL::Pointer_property_map<Point>::const_type;
  using Search_traits =
    CGAL::Search_traits_adapter<std::size_t, Points_by_index, CGAL::Search_traits_3<Kernel>>;

public:
  using Search = CGAL::Orthogonal_k_neighbor_search<Search_traits>;

  /// Of `size` points.
  Sample_of_surface(std::size_t size, const std::function<const Point&(std::size_t)>& point);

  const std::vector<Point>& points() const { return m_points; }

  /// The place of a point of the sample among all points.
  std::size_t index_in_cloud(std::size_t i) const { return i * m_step; }

  bool has(std::size_t index_in_cloud) const { return index_in_cloud % m_step == 0; }

  /// Points of the sample by index and squared distance, the nearest first. It may be the point
  /// itself.
  Search nearest(const Point& point, std::size_t count) const;

  /// How far apart the points of the cloud are, as for a surface: half as many points lie sqrt(2)
  /// as far apart.
  /// \param nearest of a place, 7 or more if there are so many
  double spacing(const Search& nearest) const;

  /// The plane through points.
  /// \returns its normal, of unit length and any sign, or zero if there is none
  Vector normal_of_plane(const Search& nearest) const;

private:
  std::size_t m_step;
  std::vector<Point> m_points;
  Points_by_index m_point_map;
  Search::Tree m_tree;
};

/// Median over the points of the mean distance to their six nearest, a length; 0 for fewer than two
/// distinct points. Estimated from a part of a large cloud, as for a surface: half as many points
/// lie sqrt(2) as far apart.
double point_spacing(const std::vector<Point>& points);

/// Of `size` points.
double point_spacing(std::size_t size, const std::function<const Point&(std::size_t)>& point);

/// \param values at least one
double median(std::vector<double> values);

} // namespace l0_tool

#endif // L0_RESAMPLE_SAMPLE_OF_SURFACE_H
