// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SPACING_TO_ORIENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_SPACING_TO_ORIENT_H

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The spacing of points that stand for all others, where the noise is larger than the spacing of
/// the points. Neighbors that are nearer to each other than the noise tell little of the surface;
/// with one and a half deviations, points take the sides of others too often.
/// \param spacing of the points
/// \param noise its standard deviation
inline double spacing_of_representatives(double spacing, double noise)
{
  return (std::max)(spacing, noise);
}

/// Whether the scales of places have a say in sides: in the balls that normals are estimated in,
/// and in which points stand for others within the noise.
/// \param spacing, noise as for `spacing_of_representatives()`
inline bool needs_scales_to_orient(bool are_all_normals_given, double spacing, double noise)
{
  return !are_all_normals_given || spacing_of_representatives(spacing, noise) > spacing;
}

/// The spacing of an even set of `number_of_samples` on the surface of `n` points of that spacing.
/// Noise is thicker than its spacing: it keeps more representatives than a surface would.
inline double spacing_on_surface(double spacing, std::size_t n, std::size_t number_of_samples)
{
  return spacing * std::sqrt(double(n) / double(number_of_samples));
}

/// Heights of points over each other's tangent planes tell nothing of a fold as long as they are
/// within so many standard deviations of the noise. With fewer, single points of a smooth surface
/// turn against all around them; with six, the two sheets of thin plates mix.
constexpr double deviations_of_heights = 4;

inline double noise_of_heights(double noise) { return deviations_of_heights * noise; }

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SPACING_TO_ORIENT_H
