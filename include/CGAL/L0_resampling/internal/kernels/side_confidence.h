// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SIDE_CONFIDENCE_H
#define CGAL_L0_RESAMPLING_INTERNAL_SIDE_CONFIDENCE_H

#include <CGAL/L0_resampling/internal/core/Orientation_hints.h>
#include <CGAL/L0_resampling/internal/core/host_device.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
What the other dipoles of a tree say of the side of one of them.

The winding number of a closed surface jumps from 0 outside to 1 inside; without the dipole's own
part it is 1/2 on the surface, whatever the sign of its own normal. It is less where the surface is
open, about 0 on a sheet that has no inside, such as a plate both sides of which have become one,
and -1/2 where the surface is turned inside out.
*/
struct Side_evidence
{
  double winding_number = 0;
  /// with the others that are not too near, per the sum of the absolute values; in [-1, 1]
  double agreement = 0;
};

/// From which squared distance on two dipoles are evidence of each other's sides. Those of one flat
/// sheet disagree when they are nearer than this: each is in the core of the other.
CGAL_L0_HOST_DEVICE inline double minimum_squared_distance_of_evidence(double squared_core)
{
  return 2 * squared_core;
}

CGAL_L0_HOST_DEVICE inline double logistic(double x)
{
  using std::exp;
  return 1 / (1 + exp(-x));
}

/// Whether a tree is turned that no hints turn: as the flux through it says, unless that makes the
/// mean winding number negative, beyond rounding.
CGAL_L0_HOST_DEVICE inline bool is_turned_by_windings(bool is_turned_inwards,
                                                      double mean_winding_number)
{
  const double minimum_winding_number = -0.01;
  const double winding_number = is_turned_inwards ? -mean_winding_number : mean_winding_number;
  return (winding_number < minimum_winding_number) != is_turned_inwards;
}

/// Of a sample whose tree has no dipole.
constexpr double guessed_confidence = 0.5;

/// How sure it is that a tree that no hints turn has its outside out. Terrain, and walls that are
/// seen from within, have mean winding numbers as large as views of an object have, and no outside
/// to be known by: the less all normals face one way, the more does the surface enclose of what is
/// around it or within it, and the larger has the number to be.
/// \param facing_share length of the mean of its normals
CGAL_L0_HOST_DEVICE inline double confidence_of_tree(double mean_winding_number,
                                                     double facing_share)
{
  const double middle_of_view = 0.092, facing_share_of_view = 0.7, middle_per_share = 0.2,
               slope = 150;
  const double turning = facing_share < facing_share_of_view ? facing_share_of_view - facing_share
                                                             : 0;
  const double confidence = logistic(
    slope * (mean_winding_number - middle_of_view - middle_per_share * turning));
  return confidence > 0.5 ? confidence : 0.5;
}

/// How sure it is that a dipole has the side that its tree has as a whole. A logistic regression
/// over resampled closed meshes, with noise of 0 to 1.2 % of the diagonal, and views of them; see
/// the page on accuracy.
CGAL_L0_HOST_DEVICE inline double confidence_within_tree(const Side_evidence& evidence,
                                                         double mean_winding_number)
{
  const auto within = [](double x, double low, double high) {
    return x < low ? low : x > high ? high : x;
  };
  const double mean = within(mean_winding_number, 0.05, 1);
  return logistic(-1.98 + 4.32 * within(evidence.winding_number / mean, -1, 0.7)
                  + 4.86 * within(evidence.agreement, -1, 0.7)
                  - 5.93 * within(evidence.winding_number - 0.55, 0, 1));
}

/// How sure the side of a sample is, from how sure that of its tree is, and it within the tree.
CGAL_L0_HOST_DEVICE inline double confidence_of_side(double of_tree, double within_tree)
{
  return of_tree * within_tree + (1 - of_tree) * (1 - within_tree);
}

/// How sure the side of a sample is that was seen from a known place: a guess where it was seen
/// edge-on, certain from half of the cosine on from which `certain_side()` is, linear in between.
/// Winding numbers know less, as a scan is an open surface.
/// \param cosine of the angle between normal and direction to the viewpoint
CGAL_L0_HOST_DEVICE inline double confidence_of_viewpoint(double cosine)
{
  const double confidence = 0.5 + cosine / minimum_certain_cosine;
  return confidence < 0 ? 0 : confidence > 1 ? 1 : confidence;
}

/// How sure it is that hints turn a tree to the right side: for certain, where any of them is.
CGAL_L0_HOST_DEVICE inline double confidence_of_hints(const Side_votes& votes)
{
  using std::abs;
  return votes.certain_sum != 0 ? 1 : (1 + abs(votes.sum) / votes.total) / 2;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SIDE_CONFIDENCE_H
