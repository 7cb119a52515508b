// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORDER_OF_PLACES_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORDER_OF_PLACES_H

#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The order that samples have when their sides are found. It follows from the set of their places
/// alone, and so do the sides.
template <typename ConcurrencyTag>
Buffer<Index> order_of_places(const Buffer<Vector>& places, const Plan& plan)
{
  return Search_grid_3::sorted_order<ConcurrencyTag>(places, plan.cell_size_of_places());
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORDER_OF_PLACES_H
