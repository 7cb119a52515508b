// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/splat_renderer.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace l0_tool {
namespace {

constexpr int samples_per_side = 3; // of a pixel, squared for the whole of it

/// How far the rim of a disc is bent away from the eye, in radii.
constexpr float bend = 1;

/// What is seen in rows of an image, a row of samples after the other.
struct Samples
{
  int width, y_begin, y_end;
  std::vector<float> depths;
  std::vector<Color> colors;

  Samples(int w, int begin, int end)
    : width(w), y_begin(begin), y_end(end),
      depths(std::size_t(w) * std::size_t(end - begin), std::numeric_limits<float>::lowest()),
      colors(depths.size(), Color{1, 1, 1})
  {}

  std::size_t index(int x, int y) const
  {
    return std::size_t(y - y_begin) * std::size_t(width) + std::size_t(x);
  }
};

/// \param dx,dy,dz from the center of the disc, in samples
bool lies_in_all(const std::array<Splat::Half_space, 2>& clips, float dx, float dy, float dz)
{
  return std::all_of(clips.begin(), clips.end(), [&](const Splat::Half_space& clip) {
    const Direction& n = clip.normal;
    return n[0] * dx + n[1] * dy + n[2] * dz <= clip.offset * samples_per_side;
  });
}

void draw_splat(const Splat& splat, Samples& samples)
{
  const float scale = samples_per_side;
  const float cx = splat.center.x * scale, cy = splat.center.y * scale, r = splat.radius * scale;
  if (!(cx + r > 0 && cx - r < float(samples.width) && cy + r > float(samples.y_begin)
        && cy - r < float(samples.y_end)))
    return; // also what is too far away for an int
  // A disc seen from its edge would be a line: it stays 2.4 pixels wide
  const float minimum_nz = (std::min)(1.2f / splat.radius, 1.f);
  const float nz = std::copysign((std::max)(std::abs(splat.normal[2]), minimum_nz),
                                 splat.normal[2]);
  const float slope_x = -splat.normal[0] / nz, slope_y = -splat.normal[1] / nz;

  const int x_begin = (std::max)(0, int(std::ceil(cx - r - 0.5f)));
  const int x_end = (std::min)(samples.width, int(std::ceil(cx + r + 0.5f)));
  const int y_begin = (std::max)(samples.y_begin, int(std::ceil(cy - r - 0.5f)));
  const int y_end = (std::min)(samples.y_end, int(std::ceil(cy + r + 0.5f)));
  for (int y = y_begin; y < y_end; ++y)
    for (int x = x_begin; x < x_end; ++x) {
      const float dx = float(x) + 0.5f - cx, dy = float(y) + 0.5f - cy,
                  dz = slope_x * dx + slope_y * dy;
      const float squared_share = (dx * dx + dy * dy + dz * dz) / (r * r);
      const float depth = splat.center.depth * scale + dz - bend * r * squared_share;
      const std::size_t i = samples.index(x, y);
      if (squared_share > 1 || depth <= samples.depths[i] || !lies_in_all(splat.clips, dx, dy, dz))
        continue;
      samples.depths[i] = depth;
      const float squared_colored_share = splat.colored_share * splat.colored_share;
      samples.colors[i] = squared_share <= squared_colored_share ? splat.color : Color{1, 1, 1};
    }
}

/// Draws the rows `begin` to `end` of the image.
void draw_rows(const std::vector<Splat>& splats, int begin, int end, Image& image)
{
  Samples samples(samples_per_side * image.width, samples_per_side * begin, samples_per_side * end);
  for (const Splat& splat : splats)
    draw_splat(splat, samples);

  for (int y = begin; y < end; ++y)
    for (int x = 0; x < image.width; ++x) {
      Color sum = {0, 0, 0};
      for (int dy = 0; dy < samples_per_side; ++dy)
        for (int dx = 0; dx < samples_per_side; ++dx) {
          const Color& color =
            samples.colors[samples.index(samples_per_side * x + dx, samples_per_side * y + dy)];
          for (std::size_t k = 0; k < 3; ++k)
            sum[k] += color[k];
        }
      for (std::size_t k = 0; k < 3; ++k)
        image.at(x, y)[k] = sum[k] / float(samples_per_side * samples_per_side);
    }
}

} // namespace

Image render_splats(const std::vector<Splat>& splats, int width, int height)
{
  constexpr int rows_per_band = 100; // bounds the memory of the samples
  Image image(width, height, {1, 1, 1});
  tbb::parallel_for(tbb::blocked_range<int>(0, height, rows_per_band),
                    [&](const tbb::blocked_range<int>& band) {
                      draw_rows(splats, band.begin(), band.end(), image);
                    });
  return image;
}

} // namespace l0_tool
