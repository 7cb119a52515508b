// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Camera.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace l0_tool {
namespace {

constexpr double margin = 0.05; // share of the picture left free on each side

// The range of all values, unless a few of them stretch it far beyond that of the others.
std::pair<double, double> sensible_range(std::vector<double>& values)
{
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double low = *lowest, high = *highest;
  const auto quantile = [&](double share) {
    const auto position = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), position, values.end());
    return *position;
  };
  const double inner_low = quantile(0.002), inner_high = quantile(0.998);
  const double allowance = 0.15 * (inner_high - inner_low);
  return {(std::max)(low, inner_low - allowance), (std::min)(high, inner_high + allowance)};
}

} // namespace

Vector normalized(const Vector& v)
{
  const double largest = (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
  if (!(largest > 0))
    return CGAL::NULL_VECTOR;
  const Vector scaled = v / largest;
  return scaled / std::sqrt(scaled.squared_length());
}

Vector upwards_in_picture(const Vector& towards_eye, const Vector& up)
{
  const Vector upwards = normalized(up);
  if (std::abs(normalized(towards_eye) * upwards) <= 0.99)
    return upwards;
  return std::abs(upwards.z()) > 0.5 ? Vector(0, 1, 0) : Vector(0, 0, -1);
}

Camera::Camera(const Vector& towards_eye, int width, int height, const Vector& up)
  : m_towards_eye(normalized(towards_eye)), m_middle_x(width / 2.), m_middle_y(height / 2.)
{
  m_right = normalized(CGAL::cross_product(upwards_in_picture(towards_eye, up), m_towards_eye));
  m_up = CGAL::cross_product(m_towards_eye, m_right);
}

void Camera::fit(const std::vector<const std::vector<Point>*>& clouds)
{
  std::size_t n = 0;
  for (const std::vector<Point>* points : clouds)
    n += points->size();
  if (n == 0)
    return;

  const auto range_along = [&](const Vector& direction) {
    std::vector<double> values;
    values.reserve(n);
    for (const std::vector<Point>* points : clouds)
      for (const Point& point : *points)
        values.push_back((point - CGAL::ORIGIN) * direction);
    return sensible_range(values);
  };
  const auto [left, right] = range_along(m_right);
  const auto [low, high] = range_along(m_up);
  const auto [far, near] = range_along(m_towards_eye);
  m_center = CGAL::ORIGIN + (left + right) / 2 * m_right + (low + high) / 2 * m_up
             + (far + near) / 2 * m_towards_eye;

  const double room = 2 * (1 - 2 * margin);
  const double largest = (std::max)((right - left) / (room * m_middle_x),
                                    (high - low) / (room * m_middle_y));
  m_scale = largest > 0 ? 1 / largest : 1;
}

Projected_point Camera::project(const Point& point) const
{
  const Vector v = rotate(point - m_center);
  return {float(m_middle_x + m_scale * v.x()), float(m_middle_y + m_scale * v.y()),
          float(m_scale * v.z())};
}

Vector Camera::rotate(const Vector& v) const
{
  return {v * m_right, -(v * m_up), v * m_towards_eye};
}

} // namespace l0_tool
