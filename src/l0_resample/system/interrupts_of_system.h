// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_INTERRUPTS_OF_SYSTEM_H
#define L0_RESAMPLE_INTERRUPTS_OF_SYSTEM_H

namespace l0_tool {

enum class Interrupt
{
  NONE,
  BY_USER,
  BY_SYSTEM,
  BY_TIMEOUT
};

/*!
From now on, `note` is called with the first request to end, wherever it comes from, and what blocks
in `read_some()` or `write_some()` returns. The second request kills. A write to a closed pipe or
beyond a limit of the file size becomes an error of that write.
\param note called in a signal handler or in another thread
\param timeout seconds after which `note` is called too; 0 for never
*/
void watch_interrupts(void (*note)(Interrupt), double timeout);

} // namespace l0_tool

#endif // L0_RESAMPLE_INTERRUPTS_OF_SYSTEM_H
