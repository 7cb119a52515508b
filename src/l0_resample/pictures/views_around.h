// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_VIEWS_AROUND_H
#define L0_RESAMPLE_VIEWS_AROUND_H

#include "pictures/View.h"

#include <vector>

namespace l0_tool {

constexpr int maximum_number_of_views = 4;

/// A view and those that show what it hides: from the other side, half a turn around what is up,
/// from above and from below. In the last two, what is nearest to the first eye is at the bottom.
/// \param number of views, at most `maximum_number_of_views`
std::vector<View> views_around(const View& view, int number);

} // namespace l0_tool

#endif // L0_RESAMPLE_VIEWS_AROUND_H
