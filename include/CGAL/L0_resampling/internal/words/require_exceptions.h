// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_REQUIRE_EXCEPTIONS_H
#define CGAL_L0_RESAMPLING_INTERNAL_REQUIRE_EXCEPTIONS_H

#ifndef __cpp_exceptions
#error "L0 resampling says by exceptions what it refuses: compile it without -fno-exceptions"
#endif

#endif // CGAL_L0_RESAMPLING_INTERNAL_REQUIRE_EXCEPTIONS_H
