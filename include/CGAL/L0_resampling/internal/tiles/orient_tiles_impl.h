// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENT_TILES_IMPL_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENT_TILES_IMPL_H

#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/orientation/order_of_places.h>
#include <CGAL/L0_resampling/internal/orientation/orient_normals.h>
#include <CGAL/L0_resampling/internal/orientation/side_hints.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Puts the value in place `i` to place `order[i]`: what `apply_order()` has done is undone.
template <typename T>
void undo_order(const Buffer<Index>& order, Buffer<T>& values)
{
  Buffer<T> before(values.size(), values.get_allocator());
  for_each_in_order(values.size(), [&](std::size_t i) { before[order[i]] = values[i]; });
  values.swap(before);
}

template <typename ConcurrencyTag>
void orient_tiles(const Facts_of_cloud& facts, const Plan& plan, const Parameters& parameters,
                  Progress& progress, Samples_to_orient& samples)
{
  Buffer<Vector>& places = samples.places;
  Buffer<Eigen::Vector3f>& normals = samples.normals;
  progress.begin_stage("orient normals", 1, places.size());
  const Buffer<Index> order = order_of_places<ConcurrencyTag>(places, plan);
  apply_order<ConcurrencyTag>(order, places);
  apply_order<ConcurrencyTag>(order, normals);
  Working_frame frame;
  Buffer<Vector> no_points(places.get_allocator());
  const Buffer<Eigen::Vector3f> no_hints(places.get_allocator());
  frame.enter<ConcurrencyTag>(no_points, *facts.frame);
  frame.set_unit<ConcurrencyTag>(plan.unit, no_points);
  orient_normals<ConcurrencyTag>(places, plan.number_of_orientation_neighbors, plan.sample_spacing,
                                 side_hints(parameters, frame, places, no_hints), progress,
                                 normals);
  undo_order(order, places);
  undo_order(order, normals);
  progress.end_stage();
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENT_TILES_IMPL_H
