// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What links with the package rounds each product before it is added to something: the bits of a
// result do not depend on which of them a compiler would fuse.

#include "test_support.h"

#include <cmath>
#include <cstddef>

namespace {

/// Those of a product and a sum that have one rounding each.
double product_and_sum(const double* a, const double* b, const double* c, std::size_t i)
{
  return a[i] * b[i] + c[i];
}

} // namespace

int main()
{
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("fma"))
    return 77;
#endif
  const double epsilon = std::ldexp(1., -30); // whose square a product of the two cannot hold
  volatile double a = 1 + epsilon, b = 1 - epsilon, c = -1;
  const double values[] = {a, b, c};
  CHECK(product_and_sum(values, values + 1, values + 2, 0) == 0);
  CHECK(std::fma(a, b, c) != 0);
  return test::result();
}
