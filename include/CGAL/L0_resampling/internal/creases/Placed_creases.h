// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PLACED_CREASES_H
#define CGAL_L0_RESAMPLING_INTERNAL_PLACED_CREASES_H

#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The unit of the lengths of creases. Where samples are denser than the points, creases are known
/// as coarsely as the points are.
inline double spacing_of_creases(double sample_spacing, double point_spacing)
{
  return (std::max)(sample_spacing, point_spacing);
}

struct Crease_vertex
{
  Vector position, tangent;      ///< the tangent in the direction of the line
  std::array<Vector, 2> normals; ///< of the face to the left, seen from outside, and to the right
  double angle;                  ///< between the normals
};

/// In the unit of the input.
struct Sample_beside_crease
{
  std::size_t number;
  Vector position, normal;
};

/// A crease of samples.
struct Placed_crease
{
  std::vector<std::size_t> samples;
  std::vector<Crease_vertex> vertices; ///< one a sample, whose positions are not used any more
  bool is_closed, is_convex;
  double confidence;
};

struct Placed_corner
{
  std::size_t sample;
  std::vector<Vector> normals;
};

struct Placed_creases
{
  std::vector<Placed_crease> creases;
  std::vector<Placed_corner> corners;
  std::vector<Sample_beside_crease> moved; ///< on creases and beside them, by their numbers
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PLACED_CREASES_H
