// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_support.h"

#include <CGAL/L0_resampling/internal/kernels/shrinkage.h>

#include <cmath>
#include <limits>

using namespace test;
using CGAL::L0_resampling::internal::shrink;
using CGAL::L0_resampling::internal::shrinkage_threshold;
using CGAL::L0_resampling::internal::Shrunk_jumps;

/// One term of Eq. (8).
double cost(double distance, double offset, double normal_weight, double penalty)
{
  return penalty * std::pow(distance - offset, 2) + normal_weight * (offset != 0);
}

/// No offset costs less than that of Eq. (9), for distances of either sign.
void check_minimum(double normal_weight, double penalty, Generator& generator)
{
  const double threshold = std::sqrt(normal_weight / penalty);
  const Shrunk_jumps<double> jumps(threshold, 0);
  for (int n = 0; n < 200; ++n)
  {
    const double distance = threshold * random_number(-3, 3, generator);
    const double offset = shrink(distance, jumps);
    const double least = cost(distance, offset, normal_weight, penalty);
    bool is_minimum = cost(distance, 0, normal_weight, penalty) >= least;
    for (int step = -400; step <= 400; ++step)
      is_minimum = is_minimum
                   && cost(distance, threshold * step / 100, normal_weight, penalty) >= least;
    CHECK(is_minimum);
    CHECK(offset == 0 || offset == distance);
    CHECK(shrink(-distance, jumps) == -offset);
    CHECK(shrink(float(distance), Shrunk_jumps<float>(threshold, 0))
          == (offset == 0 ? 0 : float(distance)));
  }
}

/// Firm shrinkage keeps and zeroes what Eq. (9) does but near the threshold, and has no step there:
/// neighboring numbers stay neighbors.
void check_firm_shrinkage()
{
  const Shrunk_jumps<double> jumps(2, 0.1);
  CHECK(shrink(1.8, jumps) == 0);
  CHECK(shrink(2.2, jumps) == 2.2);
  const double steepest = 2.2 / 0.4, step = 1e-4;
  double last = 0;
  bool rises = true, has_no_step = true, is_odd = true;
  for (double distance = 1.7; distance < 2.3; distance += step)
  {
    const double offset = shrink(distance, jumps);
    rises = rises && offset >= last && offset <= distance;
    has_no_step = has_no_step && offset - last <= 1.001 * steepest * step;
    is_odd = is_odd && shrink(-distance, jumps) == -offset;
    last = offset;
  }
  CHECK(rises);
  CHECK(has_no_step);
  CHECK(is_odd);
}

int main()
{
  Generator generator(3);
  for (double penalty : {0.1, 0.5, 2.}) // where Algorithm 1 starts, passes and ends
    for (double normal_weight : {0.01, 0.9, 30.})
      check_minimum(normal_weight, penalty, generator);

  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(is_close(shrinkage_threshold(0.9, 0.1, 0.5, infinity), 1.5, 1e-15));
  CHECK(shrinkage_threshold(0.9, 0.1, 0.5, 1.4) == 1.4);
  CHECK(is_close(shrinkage_threshold(0.9, 0.4, 0.5, 1.4), 0.75,
                 1e-15)); // the bound matters only while the penalty is small

  // Without a price nothing is zeroed, and just below and at the threshold the two candidates
  // change places.
  CHECK(shrink(1e-300, Shrunk_jumps<double>(0, 0)) == 1e-300);
  const Shrunk_jumps<double> jumps(2, 0);
  CHECK(shrink(std::nextafter(2., 0.), jumps) == 0);
  CHECK(shrink(-std::nextafter(2., 0.), jumps) == 0);
  CHECK(shrink(2., jumps) == 2);

  check_firm_shrinkage();
  return result();
}
