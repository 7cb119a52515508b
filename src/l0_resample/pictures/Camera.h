// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_CAMERA_H
#define L0_RESAMPLE_CAMERA_H

#include "basis/Point_cloud.h"

#include <vector>

namespace l0_tool {

/// Where a point is in a picture: in pixels from its top left corner. So is `depth`, larger nearer
/// to the eye.
struct Projected_point
{
  float x, y, depth;
};

/// With length 1, if it is not zero; of any finite length.
Vector normalized(const Vector& v);

/// The direction, of length 1, that points upwards in a picture, though maybe towards the eye or
/// away from it too: `up`, or another axis where the eye looks along that.
/// \param towards_eye not zero, nor is `up`
Vector upwards_in_picture(const Vector& towards_eye, const Vector& up);

/// Parallel projection that fits points into a picture.
class Camera
{
  Vector m_right, m_up, m_towards_eye;
  Point m_center = CGAL::ORIGIN;
  double m_scale = 1;
  double m_middle_x, m_middle_y;

public:
  /// \param up see `upwards_in_picture()`
  Camera(const Vector& towards_eye, int width, int height, const Vector& up = Vector(0, 1, 0));

  /// Takes the position and scale from which all points are seen, but for a few that lie far away
  /// from the others.
  void fit(const std::vector<const std::vector<Point>*>& clouds);

  Projected_point project(const Point& point) const;

  /// In the directions of `Projected_point`, without the scale.
  Vector rotate(const Vector& v) const;

  double pixels_per_length() const { return m_scale; }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_CAMERA_H
