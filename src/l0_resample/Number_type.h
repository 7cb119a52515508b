// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NUMBER_TYPE_H
#define L0_RESAMPLE_NUMBER_TYPE_H

#include <cstddef>

namespace l0_tool {

/// The types of numbers in binary files.
enum class Number_type { INT8, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32, FLOAT64 };

/// In bytes.
std::size_t size_of(Number_type type);

/// The number whose `size_of(type)` bytes begin at `bytes`, wherever that is.
/// \param swap whether the bytes are in the other order than this machine's
double decode(const char* bytes, Number_type type, bool swap);

bool is_little_endian_machine();

} // namespace l0_tool

#endif // L0_RESAMPLE_NUMBER_TYPE_H
