// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "render_snapshot.h"

#include "Camera.h"
#include "point_spacing.h"
#include "splat_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace l0_tool {
namespace {

constexpr int panel_width = 800, panel_height = 800;

float to_linear(float srgb) { return std::pow(srgb, 2.2f); }

Color color_of(const Vector& n)
{
  return {to_linear(float(0.5 + 0.5 * n.x())), to_linear(float(0.5 + 0.5 * n.y())),
          to_linear(float(0.5 + 0.5 * n.z()))};
}

/// Light gray to red.
Color color_of_confidence(float confidence)
{
  const float gray = to_linear(0.8f), red = to_linear(0.85f);
  return {gray + confidence * (red - gray), gray * (1 - confidence), gray * (1 - confidence)};
}

Image render_panel(const std::vector<Point>& points, const std::vector<Vector>& normals,
                   const std::vector<float>& confidences, const Camera& camera)
{
  const bool has_normals = !normals.empty();
  std::vector<Splat> splats;
  const float gray = to_linear(0.72f);
  splats.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Splat splat{camera.project(points[i]), {0, 0, 1}, {gray, gray, gray}};
    const double length = has_normals ? std::sqrt(normals[i].squared_length()) : 0;
    if (length > 0 && std::isfinite(length)) {
      const Vector n = normals[i] / length;
      const Vector seen = camera.rotate(n);
      splat.normal = {float(seen.x()), float(seen.y()), float(seen.z())};
      splat.color = confidences.empty() ? color_of(n) : color_of_confidence(confidences[i]);
    }
    splats.push_back(splat);
  }
  return render_splats(splats, float(point_spacing(points) * camera.pixels_per_length()),
                       has_normals, panel_width, panel_height);
}

} // namespace

Image render_snapshot(const Point_cloud& input, const std::vector<Oriented_point>& result,
                      const std::optional<std::array<double, 3>>& towards_eye,
                      const std::vector<float>& feature_confidences)
{
  std::vector<Point> result_points;
  std::vector<Vector> result_normals;
  for (const Oriented_point& point : result) {
    result_points.push_back(point.first);
    result_normals.push_back(point.second);
  }

  const std::array<double, 3> eye = towards_eye.value_or(std::array<double, 3>{0.6, 0.55, 1});
  Camera camera(Vector(eye[0], eye[1], eye[2]), panel_width, panel_height);
  camera.fit({&input.points, &result_points});

  const Image left = render_panel(input.points, input.normals, {}, camera);
  const Image right = render_panel(result_points, result_normals, feature_confidences, camera);
  Image image(2 * panel_width, panel_height, {1, 1, 1});
  for (int y = 0; y < panel_height; ++y) {
    std::copy_n(&left.at(0, y), panel_width, &image.at(0, y));
    std::copy_n(&right.at(0, y), panel_width, &image.at(panel_width, y));
  }
  return image;
}

} // namespace l0_tool
