// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PEAK_OF_MEMORY_H
#define L0_RESAMPLE_PEAK_OF_MEMORY_H

#include <cstdint>

namespace l0_tool {

/// Of this program so far, in bytes; 0 if the system does not tell.
std::uint64_t peak_of_memory();

} // namespace l0_tool

#endif // L0_RESAMPLE_PEAK_OF_MEMORY_H
