// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

// As each package of CGAL under the GPL has one. -DCGAL_LICENSE_WARNING and -DCGAL_LICENSE_ERROR
// tell who uses CGAL that a program with this package falls under it too. The value of
// CGAL_L0_RESAMPLING_COMMERCIAL_LICENSE is the day, YYYYMMDD, until which another license covers
// releases of CGAL.

#ifndef CGAL_LICENSE_L0_RESAMPLING_H
#define CGAL_LICENSE_L0_RESAMPLING_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#if !defined(CGAL_L0_RESAMPLING_COMMERCIAL_LICENSE)
#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("L0 Resampling of Point Sets is under the GPL, version 3 or later, as long as"
                    " CGAL_L0_RESAMPLING_COMMERCIAL_LICENSE names no other license.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "L0 Resampling of Point Sets is under the GPL, version 3 or later: \
CGAL_L0_RESAMPLING_COMMERCIAL_LICENSE names no other license, and CGAL_LICENSE_ERROR asks for one."
#endif
#elif CGAL_L0_RESAMPLING_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE
#ifdef CGAL_LICENSE_WARNING
CGAL_pragma_warning("This release of CGAL is younger than what your license of L0 Resampling of"
                    " Point Sets covers.")
#endif
#ifdef CGAL_LICENSE_ERROR
#error "This release of CGAL is younger than what your license of L0 Resampling of Point Sets \
covers, and CGAL_LICENSE_ERROR asks for one that covers it."
#endif
#endif

#endif // CGAL_LICENSE_L0_RESAMPLING_H
