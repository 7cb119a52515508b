// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_WRITE_PNG_H
#define L0_RESAMPLE_WRITE_PNG_H

#include "pictures/Image.h"

#include <string>
#include <vector>

namespace l0_tool {

/// Red, green and blue of each pixel, sRGB, row by row from the top.
std::vector<unsigned char> srgb_bytes(const Image& image);

/// As a whole or not at all, see `Output_file`. 8 bits a channel, sRGB.
void write_png(const std::string& path, const Image& image);

} // namespace l0_tool

#endif // L0_RESAMPLE_WRITE_PNG_H
