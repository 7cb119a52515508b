// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SIGNALS_H
#define L0_RESAMPLE_SIGNALS_H

namespace l0_tool {

/*!
From now on the first SIGINT or SIGTERM is only noted, for `throw_if_interrupted()`; the second one
kills. A write to a closed pipe or beyond a file size limit becomes an error of that write instead
of a signal.
\param timeout seconds after which the program is interrupted in the same way; 0 for never
*/
void catch_signals(double timeout);

/// Whether a signal was noted or the time is over.
bool is_interrupted();

/// \throws Failure if `is_interrupted()`, with the status that tells why
void throw_if_interrupted();

} // namespace l0_tool

#endif // L0_RESAMPLE_SIGNALS_H
