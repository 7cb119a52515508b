// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "splat_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace l0_tool {
namespace {

constexpr int samples_per_side = 4; // of a pixel, squared for the whole of it
constexpr float rim_darkness = 0.35f;
constexpr float nothing = std::numeric_limits<float>::lowest();

struct Depth_map
{
  int width, height;
  std::vector<float> depths;

  Depth_map(int w, int h) : width(w), height(h), depths(std::size_t(w) * std::size_t(h), nothing) {}

  float& at(int x, int y) { return depths[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  float at(int x, int y) const
  {
    return depths[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }

  bool contains(float x, float y) const
  {
    return x >= 0 && y >= 0 && x < float(width) && y < float(height);
  }
};

struct Rectangle
{
  int x_begin, y_begin, x_end, y_end;
};

/// Calls `visit(x, y, depth, squared share of the radius)` for every cell in `region`, of a grid
/// with `cells` cells a pixel, whose center lies in the disc.
template <typename Visitor>
void for_each_cell(const Splat& splat, float radius, int cells, const Rectangle& region,
                   const Visitor& visit)
{
  const float cx = splat.center.x * float(cells), cy = splat.center.y * float(cells),
              r = radius * float(cells);
  if (!(cx + r > float(region.x_begin) && cx - r < float(region.x_end)
        && cy + r > float(region.y_begin) && cy - r < float(region.y_end)))
    return; // also what is too far away for an int
  // A disc seen from its edge would be a line: it stays 2.4 pixels wide, and a third of its height
  const float least_nz = (std::clamp)(1.2f / radius, 0.33f, 1.f);
  const float nz = std::copysign((std::max)(std::abs(splat.normal[2]), least_nz), splat.normal[2]);
  const float slope_x = -splat.normal[0] / nz, slope_y = -splat.normal[1] / nz;

  const int x_begin = (std::max)(region.x_begin, int(std::ceil(cx - r - 0.5f)));
  const int x_end = (std::min)(region.x_end, int(std::ceil(cx + r + 0.5f)));
  const int y_begin = (std::max)(region.y_begin, int(std::ceil(cy - r - 0.5f)));
  const int y_end = (std::min)(region.y_end, int(std::ceil(cy + r + 0.5f)));
  for (int y = y_begin; y < y_end; ++y)
    for (int x = x_begin; x < x_end; ++x) {
      const float dx = float(x) + 0.5f - cx, dy = float(y) + 0.5f - cy,
                  dz = slope_x * dx + slope_y * dy;
      const float squared_share = (dx * dx + dy * dy + dz * dz) / (r * r);
      if (squared_share <= 1)
        visit(x, y, splat.center.depth + dz / float(cells), squared_share);
    }
}

Depth_map closed_surface(const std::vector<Splat>& splats, float radius, int width, int height)
{
  Depth_map surface(width, height);
  for (const Splat& splat : splats)
    for_each_cell(splat, radius, 1, Rectangle{0, 0, width, height},
                  [&](int x, int y, float depth, float) {
                    surface.at(x, y) = (std::max)(surface.at(x, y), depth);
                  });
  return surface;
}

/// The normal of the plane that fits the depths around a pixel best.
std::array<float, 3> normal_of_surface(const Depth_map& surface, const Projected_point& center,
                                       int reach, float tolerance)
{
  float n = 0, x_sum = 0, y_sum = 0, z_sum = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;
  for (int y = (std::max)(0, int(center.y) - reach);
       y <= (std::min)(surface.height - 1, int(center.y) + reach); ++y)
    for (int x = (std::max)(0, int(center.x) - reach);
         x <= (std::min)(surface.width - 1, int(center.x) + reach); ++x) {
      const float dx = float(x) - center.x, dy = float(y) - center.y,
                  dz = surface.at(x, y) - center.depth;
      if (std::abs(dz) > tolerance)
        continue; // background, or another part of the object
      n += 1;
      x_sum += dx;
      y_sum += dy;
      z_sum += dz;
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
      xz += dx * dz;
      yz += dy * dz;
    }
  xx -= x_sum * x_sum / n;
  xy -= x_sum * y_sum / n;
  yy -= y_sum * y_sum / n;
  xz -= x_sum * z_sum / n;
  yz -= y_sum * z_sum / n;
  const float determinant = xx * yy - xy * xy;
  if (!(n >= 3 && determinant > 0))
    return {0, 0, 1};
  const float slope_x = (xz * yy - yz * xy) / determinant,
              slope_y = (yz * xx - xz * xy) / determinant;
  const float length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1);
  return {-slope_x / length, -slope_y / length, 1 / length};
}

/// How bright a surface is, seen from either side: a lamp at the eye's upper left, and light from
/// everywhere.
float brightness(std::array<float, 3> normal, float lamp_share)
{
  constexpr std::array<float, 3> to_lamp = {-0.36f, -0.48f, 0.8f};
  const float side = normal[2] < 0 ? -1.f : 1.f;
  const float cosine = side
                       * (normal[0] * to_lamp[0] + normal[1] * to_lamp[1] + normal[2] * to_lamp[2]);
  return 1 - lamp_share + lamp_share * (std::max)(cosine, 0.f);
}

/// The splats on the surface that is seen, lit.
std::vector<Splat> visible_splats(const std::vector<Splat>& splats, float spacing, bool has_normals,
                                  int width, int height)
{
  const float closing_radius = (std::max)((has_normals ? 1.4f : 1.1f) * spacing, 1.5f);
  // Discs without a normal face the eye, and so miss slopes
  const float tolerance = has_normals ? (std::max)(spacing, 1.f) : 2 * closing_radius;
  const Depth_map surface = closed_surface(splats, closing_radius, width, height);
  // What shows its back is rarely meant to be seen, unless all around it does: gaps in front of it
  // may be wider.
  const Depth_map wide_surface = closed_surface(splats, 3 * closing_radius, width, height);

  std::vector<Splat> visible;
  for (Splat splat : splats) {
    const Projected_point& center = splat.center;
    const Depth_map& hiding = splat.normal[2] < 0 ? wide_surface : surface;
    if (!surface.contains(center.x, center.y)
        || center.depth < hiding.at(int(center.x), int(center.y)) - tolerance)
      continue;
    if (!has_normals) {
      const int reach = (std::clamp)(int(3 * spacing), 3, 24);
      splat.normal = normal_of_surface(surface, center, reach, 4 * float(reach));
    }
    const float light = brightness(splat.normal,
                                   has_normals ? 0.25f : 0.8f); // colors show the shape already
    for (float& channel : splat.color)
      channel *= light;
    visible.push_back(splat);
  }
  return visible;
}

/// Draws the rows `begin` to `end` of the image.
void draw_band(const std::vector<Splat>& splats, float radius, int begin, int end, Image& image)
{
  const Rectangle band{0, samples_per_side * begin, samples_per_side * image.width,
                       samples_per_side * end};
  const std::size_t n = std::size_t(band.x_end) * std::size_t(band.y_end - band.y_begin);
  std::vector<float> depths(n, nothing);
  std::vector<Color> colors(n, Color{1, 1, 1});
  for (const Splat& splat : splats)
    for_each_cell(splat, radius, samples_per_side, band,
                  [&](int x, int y, float depth, float squared_share) {
                    const std::size_t i = std::size_t(y - band.y_begin) * std::size_t(band.x_end)
                                          + std::size_t(x);
                    if (depth <= depths[i])
                      return;
                    depths[i] = depth;
                    const float shade = 1
                                        - rim_darkness * squared_share
                                            * squared_share; // tells discs apart that touch
                    for (std::size_t k = 0; k < 3; ++k)
                      colors[i][k] = shade * splat.color[k];
                  });

  for (int y = begin; y < end; ++y)
    for (int x = 0; x < image.width; ++x) {
      Color sum = {0, 0, 0};
      for (int dy = 0; dy < samples_per_side; ++dy)
        for (int dx = 0; dx < samples_per_side; ++dx) {
          const std::size_t row = std::size_t(samples_per_side) * std::size_t(y - begin)
                                  + std::size_t(dy);
          const Color& color =
            colors[row * std::size_t(band.x_end) + std::size_t(samples_per_side * x + dx)];
          for (std::size_t k = 0; k < 3; ++k)
            sum[k] += color[k];
        }
      for (std::size_t k = 0; k < 3; ++k)
        image.at(x, y)[k] = sum[k] / float(samples_per_side * samples_per_side);
    }
}

} // namespace

Image render_splats(const std::vector<Splat>& splats, float spacing, bool has_normals, int width,
                    int height)
{
  const std::vector<Splat> visible = visible_splats(splats, spacing, has_normals, width, height);
  const float disc_radius = (std::clamp)(0.5f * spacing + 0.25f, 0.7f, 0.02f * float(width));

  constexpr int rows_per_band = 50; // bounds the memory of the fine samples
  Image image(width, height, {1, 1, 1});
  for (int begin = 0; begin < height; begin += rows_per_band)
    draw_band(visible, disc_radius, begin, (std::min)(begin + rows_per_band, height), image);
  return image;
}

} // namespace l0_tool
