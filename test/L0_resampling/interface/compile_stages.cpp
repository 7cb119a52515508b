// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The file of a program of several that compiles the stages.

#include <CGAL/L0_resampling/compile_stages.h>

CGAL_L0_COMPILE_STAGES()
CGAL_L0_COMPILE_STAGES_FOR(CGAL::Sequential_tag)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_L0_COMPILE_STAGES_FOR(CGAL::Parallel_tag)
#endif
