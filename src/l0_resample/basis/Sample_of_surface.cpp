// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Sample_of_surface.h"

#include <CGAL/L0_resampling/internal/kernels/Plane_moments.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace l0_tool {
namespace {

constexpr std::size_t largest_size = 100000, neighbors_of_spacing = 6;

std::vector<Point> every_nth(std::size_t size,
                             const std::function<const Point&(std::size_t)>& point,
                             std::size_t step)
{
  std::vector<Point> chosen;
  chosen.reserve(size / step + 1);
  for (std::size_t i = 0; i < size; i += step)
    chosen.push_back(point(i));
  return chosen;
}

} // namespace

Sample_of_surface::Sample_of_surface(std::size_t size,
                                     const std::function<const Point&(std::size_t)>& point)
  : m_step((size + largest_size - 1) / largest_size), m_points(every_nth(size, point, m_step)),
    m_point_map(CGAL::make_property_map(std::as_const(m_points))),
    m_tree(boost::counting_iterator<std::size_t>(0),
           boost::counting_iterator<std::size_t>(m_points.size()), Search::Splitter(),
           Search_traits(m_point_map))
{
  m_tree.build(); // from here on a search changes nothing
}

Sample_of_surface::Search Sample_of_surface::nearest(const Point& point, std::size_t count) const
{
  return {m_tree, point, unsigned(count), 0, true, Search::Distance(m_point_map)};
}

double Sample_of_surface::spacing(const Search& nearest) const
{
  double sum = 0;
  std::size_t count = 0;
  for (auto i = nearest.begin(); ++i != nearest.end() && count < neighbors_of_spacing; ++count)
    sum += std::sqrt(i->second);
  return sum / double(count) / std::sqrt(double(m_step));
}

Vector Sample_of_surface::normal_of_plane(const Search& nearest) const
{
  CGAL::L0_resampling::internal::Plane_moments<double> moments;
  double squared_radius = 0;
  const Point& center = m_points[nearest.begin()->first];
  for (const auto& [i, squared_distance] : nearest) {
    const Vector v = m_points[i] - center;
    moments.add(v.x(), v.y(), v.z(), 1);
    squared_radius = squared_distance;
  }
  const auto plane = moments.plane(squared_radius, std::numeric_limits<double>::epsilon());
  return plane.spans_plane ? Vector(plane.normal.x, plane.normal.y, plane.normal.z)
                           : CGAL::NULL_VECTOR;
}

} // namespace l0_tool
