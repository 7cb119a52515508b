// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Must not compile: the test looks for the sentence that says what to do.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/l0_resample_point_set.h>

#include <iterator>
#include <utility>
#include <vector>

int main()
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const std::vector<Kernel::Point_3> points;
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(points, std::back_inserter(result));
}
