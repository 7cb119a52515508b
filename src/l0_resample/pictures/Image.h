// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_IMAGE_H
#define L0_RESAMPLE_IMAGE_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace l0_tool {

/// Red, green, blue in [0, 1], linear in light.
using Color = std::array<float, 3>;

/// Row by row from the top left.
struct Image
{
  int width, height;
  std::vector<Color> pixels;

  Image(int w, int h, const Color& background)
    : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), background)
  {}

  Color& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const Color& at(int x, int y) const
  {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

/// Red, green and blue of each pixel, sRGB, row by row from the top.
std::vector<unsigned char> srgb_bytes(const Image& image);

/// As a whole or not at all, see `Output_file`. 8 bits a channel, sRGB.
void write_png(const std::string& path, const Image& image);

/// How a picture of points is colored.
enum class Snapshot_colors
{
  SHADED, ///< gray, blue where the normal is turned away from the eye
  NORMALS ///< by the direction of the normal, as in the figures of the paper
};

} // namespace l0_tool

#endif // L0_RESAMPLE_IMAGE_H
