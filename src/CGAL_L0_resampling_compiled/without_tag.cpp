// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What programs that link with the library see.
#define CGAL_L0_LINKED_WITH_COMPILED

#include <CGAL/L0_resampling/compile_stages.h>

CGAL_L0_COMPILE_STAGES()
