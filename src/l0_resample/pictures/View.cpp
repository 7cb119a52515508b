// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/View.h"

#include "pictures/Camera.h"
#include "pictures/vertical_axis.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>

namespace l0_tool {
namespace {

CGAL::Bbox_3 box_of(const std::vector<Oriented_point>& points)
{
  CGAL::Bbox_3 box;
  for (const Oriented_point& point : points)
    box += point.first.bbox();
  return box;
}

bool is_within(const CGAL::Bbox_3& box, const Point& p)
{
  for (int axis = 0; axis < 3; ++axis)
    if (p[axis] <= box.min(axis) || p[axis] >= box.max(axis))
      return false;
  return true;
}

Point middle_of(const CGAL::Bbox_3& box)
{
  return {box.xmin() / 2 + box.xmax() / 2, box.ymin() / 2 + box.ymax() / 2,
          box.zmin() / 2 + box.zmax() / 2};
}

/// On which side of the points their ground is: the offset along a horizontal direction, in extents
/// of the points, of what is horizontal in the lowest tenth of their height. It is 0 where nothing
/// is horizontal there, and small where fewer than a tenth of the points are, as outliers may be.
double side_of_ground(const std::vector<Oriented_point>& points, const Vector& up,
                      const Vector& direction)
{
  constexpr double tenth = 0.1;
  const auto height = [&](const Point& p) { return (p - CGAL::ORIGIN) * up; };
  const auto place = [&](const Point& p) { return (p - CGAL::ORIGIN) * direction; };
  double bottom = height(points.front().first), top = bottom, first = place(points.front().first),
         last = first, mean = 0;
  for (const Oriented_point& point : points) {
    const double x = place(point.first), z = height(point.first);
    bottom = (std::min)(bottom, z);
    top = (std::max)(top, z);
    first = (std::min)(first, x);
    last = (std::max)(last, x);
    mean += x / double(points.size());
  }
  if (first == last)
    return 0;
  double sum = 0, number = 0;
  for (const auto& [point, normal] : points)
    if (height(point) <= bottom + tenth * (top - bottom)) {
      sum += std::abs(normal * up) * (place(point) - mean);
      ++number;
    }
  return sum / (std::max)(number, tenth * double(points.size())) / (last - first);
}

/// The horizontal direction from which there is most to see.
/// \param front of two opposite directions the one that is preferred
Vector broad_side(const std::vector<Oriented_point>& points, const CGAL::Bbox_3& box,
                  const Vector& up, const Vector& front)
{
  const Vector right = CGAL::cross_product(up, front);
  const double scale = (std::max)(
    {box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  const Point middle = middle_of(box);
  for (const auto& [point, normal] : points) {
    x += normal * right;
    y += normal * front;
    const Vector v = scale > 0 ? (point - middle) / scale : Vector(CGAL::NULL_VECTOR);
    xx += (v * right) * (v * right);
    xy += (v * right) * (v * front);
    yy += (v * front) * (v * front);
  }
  // Of a surface that was seen from one side, that one. Without a viewpoint all of its normals may
  // be turned to the other side, but the ground that was seen with a facade lies before it.
  constexpr double minimum_mean = 0.4, minimum_imbalance = 0.05;
  const Vector mean = (x * right + y * front) / double(points.size());
  if (mean.squared_length() > minimum_mean * minimum_mean) {
    const Vector side = normalized(mean);
    return side_of_ground(points, up, side) < -minimum_imbalance ? Vector(-side) : side;
  }
  // Else across the longest extent, if one is clearly longer
  constexpr double minimum_ratio = 1.3;
  const double middle_of_both = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  if (middle_of_both + half < minimum_ratio * minimum_ratio * (middle_of_both - half))
    return front;
  const double angle = std::atan2(2 * xy, xx - yy) / 2; // of the longest one
  const Vector across = -std::sin(angle) * right + std::cos(angle) * front;
  // From the side that more normals face, and before which the ground lies. Where these are
  // balanced, a direction decides that is not across the long sides of what lies along the axes, as
  // roundings would decide then.
  const Vector preferred = mean + minimum_imbalance * (front + 0.5 * right);
  return across * preferred + side_of_ground(points, up, across) < 0 ? Vector(-across) : across;
}

/// Whether there are points below all viewpoints, as the ground is below a tripod.
bool has_ground(const std::vector<Oriented_point>& points, const std::vector<Point>& viewpoints,
                const Vector& up)
{
  const auto height = [&](const Point& p) { return (p - CGAL::ORIGIN) * up; };
  double lowest = height(viewpoints.front());
  for (const Point& p : viewpoints)
    lowest = (std::min)(lowest, height(p));
  return std::any_of(points.begin(), points.end(),
                     [&](const Oriented_point& point) { return height(point.first) < lowest; });
}

/// Which way is up for an eye that looks along z, where z cannot be. A camera is at the origin of
/// its axes, of which y points down if it looks along z, and up if it looks against z.
/// \param front from the points towards the eye
Vector up_along_z(const std::vector<Point>& viewpoints, const Vector& front)
{
  const bool is_camera = std::all_of(viewpoints.begin(), viewpoints.end(),
                                     [](const Point& p) { return p == CGAL::ORIGIN; });
  return {0, is_camera && front.z() < 0 ? -1. : 1., 0};
}

} // namespace

View choose_view(const std::vector<Oriented_point>& result, const Known_sides& known)
{
  View view;
  const bool is_planar = !known.up && are_planes(result);
  if (known.up)
    view.up = normalized(Vector((*known.up)[0], (*known.up)[1], (*known.up)[2]));
  else if (is_planar && !is_y_vertical(result))
    view.up = Vector(0, 0, 1);
  const CGAL::Bbox_3 box = box_of(result);
  view.is_cut_open = !known.viewpoints.empty()
                     && std::all_of(known.viewpoints.begin(), known.viewpoints.end(),
                                    [&](const Point& p) { return is_within(box, p); });
  if (known.towards_eye) {
    const auto& [x, y, z] = *known.towards_eye;
    view.towards_eye = Vector(x, y, z);
    return view;
  }
  if (result.empty())
    return view;

  const Vector any_front = std::abs(view.up.z()) > std::abs(view.up.y()) ? Vector(0, -1, 0)
                                                                         : Vector(0, 0, 1);
  Vector front = normalized(any_front - (any_front * view.up) * view.up);
  double to_right = 0.6, upwards = 0.55;
  if (!known.viewpoints.empty() && !view.is_cut_open) {
    Vector sum = CGAL::NULL_VECTOR;
    for (const Point& viewpoint : known.viewpoints)
      sum += normalized(viewpoint - middle_of(box));
    if (sum != CGAL::NULL_VECTOR) { // slightly beside, as a front alone looks flat
      front = normalized(sum);
      to_right = upwards = 0.25;
      constexpr double along_axis = 0.8;
      if (!known.up && std::abs(front.z()) > along_axis)
        view.up = up_along_z(known.viewpoints, front);
      // The eye stays above the ground, though the scanner was lower than the middle of a facade.
      const double height = front * view.up;
      if (height < 0 && height > -along_axis && has_ground(result, known.viewpoints, view.up))
        front = normalized(front - height * view.up);
    }
  } else if (known.up || is_planar)
    front = broad_side(result, box, view.up, front);
  const Vector beside = normalized(CGAL::cross_product(view.up, front));
  view.towards_eye = front + to_right * beside + upwards * view.up;
  return view;
}

} // namespace l0_tool
