// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Image.h"

#include "basis/Failure.h"
#include "files/Output_file.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace l0_tool {
namespace {

png_byte to_srgb(float linear)
{
  const float x = (std::clamp)(linear, 0.f, 1.f);
  const float encoded = x <= 0.0031308f ? 12.92f * x
                                        : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; // IEC 61966-2-1
  return png_byte(std::lround(255 * encoded));
}

} // namespace

std::vector<unsigned char> srgb_bytes(const Image& image)
{
  std::vector<unsigned char> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Color& pixel : image.pixels)
    for (const float channel : pixel)
      bytes.push_back(to_srgb(channel));
  return bytes;
}

void write_png(const std::string& path, const Image& image)
{
  const std::vector<unsigned char> bytes = srgb_bytes(image);

  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = png_uint_32(image.width);
  png.height = png_uint_32(image.height);
  png.format = PNG_FORMAT_RGB;
  std::string encoded(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = encoded.size();
  if (!png_image_write_to_memory(&png, encoded.data(), &size, 0, bytes.data(), 0, nullptr))
    throw Failure(OUTPUT_NOT_WRITTEN, path + ": cannot be encoded: " + png.message);
  encoded.resize(size);

  Output_file file(path);
  file.write(encoded);
  file.commit();
}

} // namespace l0_tool
