// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SCANNER_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SCANNER_H

#include "Counter_random.h"
#include "Rotation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

namespace L0_benchmark {

/// Where a scanner stands and how it is turned; the axes have unit length.
struct Pose
{
  Point_3 position;
  Vector_3 forward;
  Vector_3 right;
  Vector_3 up;

  /// Upright, turned about the vertical.
  static Pose upright(const Point_3& position, const Rotation& heading)
  {
    return {position, Vector_3(heading.cosine, heading.sine, 0),
            Vector_3(heading.sine, -heading.cosine, 0), Vector_3(0, 0, 1)};
  }

  static Pose aimed(const Point_3& position, const Point_3& target)
  {
    const Vector_3 forward = normalized(target - position);
    const Vector_3 right = normalized(CGAL::cross_product(forward, Vector_3(0, 0, 1)));
    return {position, forward, right, CGAL::cross_product(right, forward)};
  }
};

/// What a ray meets first.
struct Hit
{
  double range;  ///< from the scanner
  double cosine; ///< of the angle between ray and normal
};

/// A model of a scanner: which rays it sends, and what range it reports for what they meet.
struct Scanner
{
  enum class Kind
  {
    SPINNING_LIDAR,    ///< rings: few lasers above each other, turned about the vertical
    TERRESTRIAL_LIDAR, ///< a fine grid of angles from a tripod
    STRUCTURED_LIGHT,  ///< a camera and a projector beside it: depth from disparity
    RANGE_CAMERA       ///< a camera's grid of rays, with noise along each ray
  };

  Kind kind = Kind::SPINNING_LIDAR;
  std::size_t columns = 0; ///< rays across the field of view
  std::size_t rows = 0;
  double field_of_view = 0;   ///< of a camera, tangent of its half; lidars see all around
  double lowest = 0;          ///< elevation of the lowest row of a lidar, degrees
  double highest = 0;         ///< of its highest row
  double range_noise = 0;     ///< standard deviation along the ray; unused by structured light
  double disparity_noise = 0; ///< standard deviation, in steps of disparity; structured light only
  double inverse_step = 0;    ///< a step of disparity, as inverse depth; structured light only
  double baseline = 0;        ///< from camera to projector; structured light only
  double beam_radius = 0;     ///< tangent of half the angle of a beam, or half a matching window
  double pulse_length = 0;    ///< surfaces closer together than this merge in one return of a lidar
  double minimum_range = 0;
  double maximum_range = 0;
  double minimum_cosine = 0; ///< more grazing rays do not come back

  std::size_t number_of_rays() const { return columns * rows; }

  bool is_camera() const { return kind == Kind::STRUCTURED_LIGHT || kind == Kind::RANGE_CAMERA; }

  /// The unit direction of a ray; rays are numbered row by row.
  Vector_3 direction(const Pose& pose, std::size_t ray) const
  {
    const double column = double(ray % columns), row = double(ray / columns);
    if (is_camera()) {
      const double pixel = 2 * field_of_view / double(columns);
      return normalized(pose.forward + (column + 0.5 - 0.5 * double(columns)) * pixel * pose.right
                        + (0.5 * double(rows) - row - 0.5) * pixel * pose.up);
    }
    const double elevation = rows == 1 ? lowest
                                       : lowest + (highest - lowest) * row / double(rows - 1);
    const Rotation around = Rotation::of_turns(column / double(columns)),
                   above = Rotation::of_degrees(elevation);
    return above.cosine * (around.cosine * pose.forward - around.sine * pose.right)
           + above.sine * pose.up;
  }

  /// What is reported of one ray, or nothing. All random numbers but those of correlated noise come
  /// from `random`. \param first what the middle of the beam meets; \param second what another part
  /// of the beam meets \param forward_share cosine between the ray and the axis of the camera
  std::optional<double> reported_range(const Hit& first, const std::optional<Hit>& second,
                                       double forward_share, double correlated_noise,
                                       Counter_random& random) const
  {
    const double loss = random.uniform();
    if (first.range < minimum_range || first.range > maximum_range
        || first.cosine < minimum_cosine * (0.5 + loss))
      return std::nullopt;
    const double share = random.uniform();
    const bool is_mixed = second && random.uniform() < 0.5;
    if (kind == Kind::STRUCTURED_LIGHT) {
      double inverse_depth = 1 / (first.range * forward_share);
      if (is_mixed)
        inverse_depth += share * (1 / (second->range * forward_share) - inverse_depth);
      const double grazing = 1 / (std::max)(first.cosine, 0.25);
      const double noise = disparity_noise * (0.95 * correlated_noise + 0.3 * random.normal());
      const double disparity = inverse_depth / inverse_step + noise * std::sqrt(grazing);
      const double steps = std::floor(disparity + 0.5);
      if (steps < 1)
        return std::nullopt;
      return 1 / (steps * inverse_step * forward_share);
    }
    double range = first.range;
    if (is_mixed && std::abs(second->range - first.range) < pulse_length)
      range += share * (second->range - first.range);
    const double tangent = std::sqrt((std::max)(1 - first.cosine * first.cosine, 0.))
                           / (std::max)(first.cosine, 0.1);
    const double spread = 0.5 * beam_radius * first.range * tangent;
    return range + std::sqrt(range_noise * range_noise + spread * spread) * random.normal();
  }

  /// Noise that neighboring pixels share, with standard deviation 1: interpolates the random values
  /// of a grid as coarse as the windows that are matched.
  double correlated_noise(std::uint64_t seed, std::uint64_t view, std::size_t ray) const
  {
    constexpr double window = 9; // pixels
    const double x = double(ray % columns) / window, y = double(ray / columns) / window;
    const double u = x - std::floor(x), v = y - std::floor(y);
    const auto value = [&](int i, int j) {
      const std::uint64_t node = (std::uint64_t(y) + std::uint64_t(j)) << 32
                                 | (std::uint64_t(x) + std::uint64_t(i));
      return Counter_random(~seed, view, node).normal();
    };
    const double sum = (1 - v) * ((1 - u) * value(0, 0) + u * value(1, 0))
                       + v * ((1 - u) * value(0, 1) + u * value(1, 1));
    return sum / std::sqrt((1 - 2 * u * (1 - u)) * (1 - 2 * v * (1 - v)));
  }
};

/// A scanner of a known kind; lengths in meters.
/// \param columns rays across the field of view, 0 for as many as the device has
/// \param size of the object, for the range camera, whose noise is relative to it
/// \throws std::invalid_argument if there is no such kind
inline Scanner make_scanner(const std::string& kind, std::size_t columns, double size)
{
  Scanner scanner;
  const auto with_columns = [&](std::size_t of_device) {
    scanner.columns = columns > 0 ? columns : of_device;
  };
  if (kind == "spinning") { // 32 lasers, as the HDL-32E has them
    scanner.kind = Scanner::Kind::SPINNING_LIDAR;
    with_columns(2000);
    scanner.rows = 32;
    scanner.lowest = -30.67;
    scanner.highest = 10.67;
    scanner.range_noise = 0.02;
    scanner.beam_radius = 1.5e-3;
    scanner.pulse_length = 0.5;
    scanner.minimum_range = 1;
    scanner.maximum_range = 70;
    scanner.minimum_cosine = 0.05;
  } else if (kind == "terrestrial") {
    scanner.kind = Scanner::Kind::TERRESTRIAL_LIDAR;
    with_columns(3600);
    scanner.lowest = -40;
    scanner.highest = 50;
    scanner.rows = scanner.columns / 4; // as fine as from column to column
    scanner.range_noise = 0.004;
    scanner.beam_radius = 2e-4;
    scanner.pulse_length = 0.3;
    scanner.minimum_range = 0.6;
    scanner.maximum_range = 120;
    scanner.minimum_cosine = 0.05;
  } else if (kind == "structured-light") {
    // The first Kinect: focal length of 580 pixels, baseline of 7.5 cm, eighths of a pixel.
    scanner.kind = Scanner::Kind::STRUCTURED_LIGHT;
    with_columns(640);
    scanner.rows = scanner.columns * 3 / 4;
    scanner.field_of_view = 320. / 580;
    scanner.baseline = 0.075;
    scanner.inverse_step = 1 / (8 * 580 * 0.075);
    scanner.disparity_noise = 0.6;
    scanner.beam_radius = 2. / 580;
    scanner.minimum_range = 0.45;
    scanner.maximum_range = 6;
    scanner.minimum_cosine = 0.15;
  } else if (kind == "range-camera") {
    scanner.kind = Scanner::Kind::RANGE_CAMERA;
    with_columns(200);
    scanner.rows = scanner.columns;
    scanner.field_of_view = 0.36; // the object from 1.5 diagonals
    scanner.range_noise = 0.001 * size;
    scanner.beam_radius = 0.3 * 2 * 0.36 / double(scanner.columns);
    scanner.pulse_length = 0.1 * size;
    scanner.maximum_range = 10 * size;
    scanner.minimum_cosine = 0.2;
  } else
    throw std::invalid_argument(kind + " is no kind of scanner");
  if (scanner.rows == 0)
    throw std::invalid_argument(std::to_string(columns) + " columns leave no row");
  return scanner;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SCANNER_H
