// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The stages for `Sequential_tag`, with the default solver.

#include <CGAL/L0_resampling/compile_stages.h>

CGAL_L0_COMPILE_STAGES_FOR(CGAL::Sequential_tag)
