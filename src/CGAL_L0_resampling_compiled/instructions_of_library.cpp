// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "instructions_of_library.h"

namespace CGAL {
namespace L0_resampling {
namespace internal {

std::string instructions_of_library()
{
#if defined(__AVX512F__)
  std::string names = "AVX-512";
#elif defined(__AVX2__)
  std::string names = "AVX2";
#elif defined(__AVX__)
  std::string names = "AVX";
#else
  std::string names = "plain";
#endif
#if defined(__FMA__)
  names += ", FMA";
#endif
  return names;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
