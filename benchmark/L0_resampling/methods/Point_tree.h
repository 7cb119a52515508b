// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_POINT_TREE_H
#define CGAL_L0_RESAMPLING_BENCHMARK_POINT_TREE_H

#include "../common/Triangle_mesh.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <iterator>
#include <vector>

namespace L0_benchmark {

/// Finds the indices of points in balls, and of the nearest ones. The points have to outlive the
/// tree, unchanged.
class Point_tree
{
  using Map = CGAL::Pointer_property_map<Point_3>::const_type;
  using Traits = CGAL::Search_traits_adapter<std::size_t, Map, CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  using Tree = Search::Tree;

  Map m_map;
  Tree m_tree;

public:
  explicit Point_tree(const std::vector<Point_3>& points)
    : m_map(CGAL::make_property_map(points)),
      m_tree(boost::counting_iterator<std::size_t>(0),
             boost::counting_iterator<std::size_t>(points.size()), Tree::Splitter(), Traits(m_map))
  {}

  std::vector<std::size_t> in_ball(const Point_3& center, double radius) const
  {
    std::vector<std::size_t> found;
    m_tree.search(std::back_inserter(found),
                  CGAL::Fuzzy_sphere<Traits>(center, radius, 0, Traits(m_map)));
    return found;
  }

  /// A point of the tree is among its own nearest.
  std::vector<std::size_t> nearest(const Point_3& center, unsigned count) const
  {
    const Search search(m_tree, center, count, 0, true, Search::Distance(m_map));
    std::vector<std::size_t> found;
    for (const auto& [index, squared_distance] : search)
      found.push_back(index);
    return found;
  }
};

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_POINT_TREE_H
