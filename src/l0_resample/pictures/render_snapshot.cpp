// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/render_snapshot.h"

#include "pictures/Camera.h"
#include "pictures/splat_renderer.h"
#include "pictures/surroundings_of_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>

namespace l0_tool {
namespace {

constexpr int panel_width = 800, panel_height = 800;
// Of discs, in spacings: large enough to leave no gap where points lie unevenly. Those near an edge
// are cut there, and may have to reach it.
constexpr double radius_in_spacings = 1.25, radius_at_edges = 1.75, radius_of_dots = 0.4;
constexpr double minimum_radius = 0.7, maximum_radius = 0.1 * panel_width; // pixels

float to_linear(float srgb) { return std::pow(srgb, 2.2f); }

Color color_of_direction(const Vector& n)
{
  return {to_linear(float(0.5 + 0.5 * n.x())), to_linear(float(0.5 + 0.5 * n.y())),
          to_linear(float(0.5 + 0.5 * n.z()))};
}

/// Light gray to red.
Color color_of_confidence(float confidence)
{
  const float light = to_linear(0.95f);
  return {light, light * (1 - confidence), light * (1 - confidence)};
}

/// Of what is turned away from the eye.
const Color blue = {to_linear(0.45f), to_linear(0.6f), to_linear(0.85f)};

Direction seen_by(const Camera& camera, const Vector& v)
{
  const Vector seen = camera.rotate(v);
  return {float(seen.x()), float(seen.y()), float(seen.z())};
}

/// How bright a surface is that faces the eye: a lamp at the eye's upper left, whose light is soft.
float brightness(const Direction& normal, float lamp_share)
{
  constexpr Direction to_lamp = {-0.36f, -0.48f, 0.8f};
  const float cosine = normal[0] * to_lamp[0] + normal[1] * to_lamp[1] + normal[2] * to_lamp[2];
  const float light = (1 + cosine) / 2;
  return 1 - lamp_share + lamp_share * light * light;
}

Color lit(const Color& color, float light)
{
  return {light * color[0], light * color[1], light * color[2]};
}

/// What is drawn in a half of a row.
struct Panel
{
  const std::vector<Point>& points;
  const std::vector<Vector>& normals;    ///< one for each point, or none at all
  const std::vector<float>& confidences; ///< likewise
  Snapshot_colors colors;
  bool as_dots;
  const std::vector<Point>* viewpoints = nullptr;         ///< of a panel without normals
  const std::vector<std::vector<Point>>* lines = nullptr; ///< drawn on the points
  std::vector<Surroundings> surroundings = surroundings_of_points(points, normals);

  /// Whether the surface that was seen at a point, of this normal or its opposite, is turned away.
  bool is_turned_away(std::size_t i, const Vector& normal, double towards_eye) const
  {
    const Vector side = !normals.empty() ? normals[i]
                        : viewpoints ? (*viewpoints)[viewpoints->size() == 1 ? 0 : i] - points[i]
                                     : normal;
    return (side * normal < 0) != (towards_eye < 0);
  }

  /// Of a disc, lit.
  /// \param normal of the surface at that point
  Color color_of(std::size_t i, const Vector& normal, const Direction& seen) const
  {
    // Along the rim of a round surface, discs that are hardly turned away still stick out
    const bool is_oriented = !normals.empty();
    const bool is_back = seen[2] < (is_oriented ? -0.2f : 0.f);
    const Direction lit_side = is_back ? Direction{-seen[0], -seen[1], -seen[2]}
                                       : Direction{seen[0], seen[1], std::abs(seen[2])};
    if (is_oriented && colors == Snapshot_colors::NORMALS)
      return lit(color_of_direction(normal), brightness(lit_side, 0.4f)); // colors show shape too
    return lit(
      is_oriented && is_back ? blue : color_of_confidence(confidences.empty() ? 0 : confidences[i]),
      brightness(lit_side, 0.9f));
  }
};

/// Whether the disc of a point that is turned away lies behind an edge whose other side is seen:
/// what is drawn of it could only stick out.
bool lies_behind_edge(const Surroundings& place, const std::vector<Surroundings>& all,
                      const Camera& camera)
{
  return std::any_of(place.across_edges.begin(), place.across_edges.end(),
                     [&](const auto& j) { return j && camera.rotate(all[*j].normal).z() > 0; });
}

/// As rows of dots, before the discs of the points on them.
void add_lines(const std::vector<std::vector<Point>>& lines, const Camera& camera,
               std::vector<Splat>& splats)
{
  const float radius = 1.8f, step = 1, nearer = 6; // pixels
  for (const std::vector<Point>& line : lines)
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Projected_point a = camera.project(line[k - 1]), b = camera.project(line[k]);
      const int count = 1 + int(std::hypot(b.x - a.x, b.y - a.y) / step);
      for (int i = 0; i < count; ++i) {
        const float t = float(i) / float(count);
        Splat dot;
        dot.center = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
                      a.depth + t * (b.depth - a.depth) + nearer};
        dot.radius = radius;
        dot.normal = {0, 0, 1};
        dot.color = {0, 0, 0};
        splats.push_back(dot);
      }
    }
}

Image render_panel(const Panel& panel, const Camera& camera, bool is_cut_open)
{
  const std::vector<Point>& points = panel.points;
  const std::vector<Surroundings>& surroundings = panel.surroundings;
  const double scale = camera.pixels_per_length();
  std::vector<Splat> splats;
  splats.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Surroundings& place = surroundings[i];
    Splat splat;
    splat.normal = place.normal == CGAL::NULL_VECTOR ? Direction{0, 0, 1}
                                                     : seen_by(camera, place.normal);
    if (splat.normal[2] < 0 && lies_behind_edge(place, surroundings, camera))
      continue;
    if (is_cut_open && panel.is_turned_away(i, place.normal, double(splat.normal[2])))
      continue;
    splat.center = camera.project(points[i]);
    const double spacings = place.across_edges[0] ? radius_at_edges : radius_in_spacings;
    splat.radius = float(
      (std::clamp)(spacings * place.spacing * scale, minimum_radius, maximum_radius));
    if (panel.as_dots)
      splat.colored_share = float(radius_of_dots / spacings);
    splat.color = panel.color_of(i, place.normal, splat.normal);
    for (std::size_t k = 0; k < place.across_edges.size(); ++k)
      if (const std::optional<std::size_t> j = place.across_edges[k]) {
        const Vector& normal_across = surroundings[*j].normal;
        const double offset = (std::max)((points[*j] - points[i]) * normal_across, 0.);
        splat.clips[k] = {seen_by(camera, normal_across), float(offset * scale)};
      }
    splats.push_back(splat);
  }
  if (panel.lines)
    add_lines(*panel.lines, camera, splats);
  return render_splats(splats, panel_width, panel_height);
}

Image render_both(const Point_cloud& input, const std::vector<Oriented_point>& result,
                  const std::vector<View>& views, const std::vector<Point>& viewpoints,
                  const std::vector<float>& feature_confidences,
                  const std::vector<std::vector<Point>>& lines, Snapshot_colors colors,
                  bool as_dots)
{
  // A point on a line has the normal of none of the faces that meet there, so its disc would stick
  // out.
  std::set<Point> on_lines;
  for (const std::vector<Point>& line : lines)
    on_lines.insert(line.begin(), line.end());
  std::vector<Point> result_points;
  std::vector<Vector> result_normals;
  std::vector<float> confidences;
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (on_lines.count(result[i].first) > 0)
      continue;
    result_points.push_back(result[i].first);
    result_normals.push_back(result[i].second);
    if (!feature_confidences.empty())
      confidences.push_back(feature_confidences[i]);
  }

  const std::vector<float> no_confidences;
  const std::array<Panel, 2> panels = {
    {{input.points, input.normals, no_confidences, colors, as_dots,
      viewpoints.empty() ? nullptr : &viewpoints},
     {result_points, result_normals, confidences, colors, as_dots, nullptr, &lines}}};

  Image image(int(panels.size()) * panel_width, int(views.size()) * panel_height, {1, 1, 1});
  for (std::size_t row = 0; row < views.size(); ++row) {
    const View& view = views[row];
    Camera camera(view.towards_eye, panel_width, panel_height, view.up);
    camera.fit({&input.points, &result_points});
    for (std::size_t column = 0; column < panels.size(); ++column) {
      const Image drawn = render_panel(panels[column], camera, view.is_cut_open);
      for (int y = 0; y < panel_height; ++y)
        std::copy_n(&drawn.at(0, y), panel_width,
                    &image.at(int(column) * panel_width, int(row) * panel_height + y));
    }
  }
  return image;
}

} // namespace

Image render_snapshot(const Point_cloud& input, const std::vector<Oriented_point>& result,
                      const std::optional<std::array<double, 3>>& towards_eye,
                      const std::vector<float>& feature_confidences, Snapshot_colors colors,
                      bool as_dots, const std::vector<std::vector<Point>>& lines)
{
  View view;
  if (towards_eye)
    view.towards_eye = Vector((*towards_eye)[0], (*towards_eye)[1], (*towards_eye)[2]);
  return render_both(input, result, {view}, {}, feature_confidences, lines, colors, as_dots);
}

Image render_snapshot(const Point_cloud& input, const std::vector<Oriented_point>& result,
                      const std::vector<View>& views, const std::vector<Point>& viewpoints,
                      const std::vector<float>& feature_confidences,
                      const std::vector<std::vector<Point>>& lines, Snapshot_colors colors)
{
  return render_both(input, result, views, viewpoints, feature_confidences, lines, colors, false);
}

std::vector<std::vector<Point>> lines_of_creases(const std::vector<Crease>& creases,
                                                 const std::vector<Oriented_point>& result)
{
  std::vector<std::vector<Point>> lines;
  for (const Crease& crease : creases) {
    lines.emplace_back();
    for (const std::size_t point : crease.points)
      lines.back().push_back(result[point].first);
    if (crease.is_closed)
      lines.back().push_back(lines.back().front());
  }
  return lines;
}

} // namespace l0_tool
