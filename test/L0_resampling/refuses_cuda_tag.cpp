// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Must not compile without the library for CUDA: nothing else runs instead of what was asked for.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <iterator>
#include <utility>
#include <vector>

int main()
{
  using Kernel = CGAL::Simple_cartesian<double>;
  const std::vector<Kernel::Point_3> points;
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result));
}
