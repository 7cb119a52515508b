// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What programs that link with the library see.
#define CGAL_L0_LINKED_WITH_COMPILED

#include <CGAL/L0_resampling/instructions.h>

namespace CGAL {
namespace L0_resampling {

std::string instructions_of_stages() { return internal::instructions_of_compiler(); }

} // namespace L0_resampling
} // namespace CGAL
