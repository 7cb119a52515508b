// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_COMPILED_INSTRUCTIONS_OF_LIBRARY_H
#define CGAL_L0_RESAMPLING_COMPILED_INSTRUCTIONS_OF_LIBRARY_H

#include <string>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the stages are compiled for, which the loader of a program may have chosen. Libraries with
/// other instructions round differently.
std::string instructions_of_library();

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_COMPILED_INSTRUCTIONS_OF_LIBRARY_H
