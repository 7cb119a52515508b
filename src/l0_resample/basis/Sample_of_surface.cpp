// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/Sample_of_surface.h"

#include <CGAL/Default_diagonalize_traits.h>
#include <CGAL/centroid.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace l0_tool {
namespace {

constexpr std::size_t maximum_size = 100000, neighbors_of_spacing = 6,
                      minimum_number_of_points_of_plane = 6; // any three span one

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
  : m_step((size + maximum_size - 1) / maximum_size), m_points(every_nth(size, point, m_step)),
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
  using Diagonalize_traits = CGAL::Default_diagonalize_traits<double, 3>;
  std::vector<Point> points;
  for (const auto& found : nearest)
    points.push_back(m_points[found.first]);
  if (points.size() < minimum_number_of_points_of_plane)
    return CGAL::NULL_VECTOR;
  const Point center = CGAL::centroid(points.begin(), points.end());
  Diagonalize_traits::Covariance_matrix sums = {{0, 0, 0, 0, 0, 0}};
  for (const Point& point : points) {
    const Vector v = point - center;
    const std::array<double, 6> products = {v.x() * v.x(), v.x() * v.y(), v.x() * v.z(),
                                            v.y() * v.y(), v.y() * v.z(), v.z() * v.z()};
    for (std::size_t k = 0; k < products.size(); ++k)
      sums[k] += products[k];
  }
  Diagonalize_traits::Vector values; // ascending
  Diagonalize_traits::Matrix vectors;
  const double rounding = 16 * std::numeric_limits<double>::epsilon(); // of a line's width
  if (!Diagonalize_traits::diagonalize_selfadjoint_covariance_matrix(sums, values, vectors)
      || !(values[1] > rounding * values[2]))
    return CGAL::NULL_VECTOR;
  return {vectors[0], vectors[1], vectors[2]};
}

double point_spacing(const std::vector<Point>& points)
{
  return point_spacing(points.size(), [&](std::size_t i) -> const Point& { return points[i]; });
}

double point_spacing(std::size_t size, const std::function<const Point&(std::size_t)>& point)
{
  constexpr std::size_t queries = 2000, neighbors = 6;
  if (size < 2)
    return 0;
  const Sample_of_surface sample(size, point);
  const std::size_t step = (sample.points().size() + queries - 1) / queries;
  std::vector<double> spacings;
  for (std::size_t i = 0; i < sample.points().size(); i += step)
    spacings.push_back(sample.spacing(sample.nearest(sample.points()[i], neighbors + 1)));
  return median(std::move(spacings));
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace l0_tool
