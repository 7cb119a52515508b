// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The watcher of the library's loops, and of those of the programs that link with it.

#include <CGAL/L0_resampling/internal/core/parallel_for.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

template Loop_watcher*& loop_watcher<void>();

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
