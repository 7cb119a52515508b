// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PAGE_H
#define L0_RESAMPLE_PAGE_H

#include "basis/Point_cloud.h"
#include "pictures/View.h"

#include <string>
#include <vector>

namespace l0_tool {

/// One file of HTML that asks for no other: input and result as points that turn together, the
/// result in the colors of its columns, what was left out, and the report. Of large clouds it has
/// 150000 points each, evenly chosen from first to last.
/// \param input its outliers are those of the result
/// \param distances of the outliers from the result, in radii
/// \param report what `report_as_json()` says
std::string page_of(const Point_cloud& input, const Resampled_points& result, const View& view,
                    const std::vector<float>& distances, const std::string& report);

} // namespace l0_tool

#endif // L0_RESAMPLE_PAGE_H
