// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_DECOMPRESS_LZF_H
#define L0_RESAMPLE_DECOMPRESS_LZF_H

#include "files/Input_file.h"

#include <cstdint>
#include <vector>

namespace l0_tool {

/// Reads `compressed_size` bytes in the format of LibLZF, the compression of PCD.
/// \param size of what they stand for, in bytes
/// \throws Failure if the file ends earlier, or if they do not stand for `size` bytes. No memory is
/// taken for a size that so many compressed bytes cannot stand for.
std::vector<char> decompress_lzf(Input_file& file, std::uint64_t compressed_size,
                                 std::uint64_t size);

} // namespace l0_tool

#endif // L0_RESAMPLE_DECOMPRESS_LZF_H
