// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SCAN_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SCAN_H

#include "../common/Aabb_trees.h"
#include "Scanner.h"
#include "scenes.h"

#include <CGAL/IO/io.h>
#include <CGAL/IO/write_ply_points.h>

#include <cstdint>
#include <fstream>
#include <ios>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace L0_benchmark {

/// How a scene is seen.
struct Scanning
{
  std::size_t number_of_views = 1;
  double registration_error = 0; ///< mean displacement of a view, % of the diagonal of the scene
  double noise_factor = 1;       ///< of the scanner's noise; 0: none, but for steps of disparity
  std::uint64_t seed = 1;
};

struct Scan_point
{
  Point_3 reported; ///< with all errors
  Point_3 exact;    ///< what the middle of the beam met
  int view;
};

struct Scan
{
  std::vector<Scan_point> points;
  std::vector<Point_3> viewpoints; ///< of each view, where its registration puts it
};

/// Finds what rays meet of a mesh.
class Ray_caster
{
public:
  explicit Ray_caster(const Triangle_mesh& mesh) : m_triangles(proper_triangles(mesh))
  {
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
    m_tree.build();
  }

  Ray_caster(const Ray_caster&) = delete; // the tree holds iterators into the vector
  Ray_caster& operator=(const Ray_caster&) = delete;

  /// \param direction of unit length
  std::optional<Hit> operator()(const Point_3& origin, const Vector_3& direction) const
  {
    const auto found = m_tree.first_intersected_primitive(Kernel::Ray_3(origin, direction));
    if (!found)
      return std::nullopt;
    // Not the tree's own point of intersection, whose last digits depend on the version of CGAL.
    const Triangle_3& triangle = **found;
    const Vector_3 side = triangle[1] - triangle[0];
    const Vector_3 normal = CGAL::cross_product(side, triangle[2] - triangle[0]);
    const double slope = direction * normal;
    return Hit{((triangle[0] - origin) * normal) / slope,
               std::abs(slope) / std::sqrt(normal.squared_length())};
  }

  /// Whether nothing is between two points, but within 0.1 % of the way at its end.
  bool sees(const Point_3& from, const Point_3& to) const
  {
    return !m_tree.do_intersect(Kernel::Segment_3(from, from + 0.999 * (to - from)));
  }

private:
  std::vector<Triangle_3> m_triangles;
  Triangle_tree m_tree;
};

/// A small rigid motion: turned about `center`, then shifted.
struct Registration
{
  Point_3 center;
  Vector_3 axis = Vector_3(0, 0, 1);
  Rotation turn = {1, 0};
  Vector_3 shift = CGAL::NULL_VECTOR;

  Point_3 operator()(const Point_3& p) const { return center + turn(p - center, axis) + shift; }
};

/// \param displacement by which points half a diagonal from the center move, approximately
inline Registration make_registration(const CGAL::Bbox_3& box, double displacement,
                                      Counter_random& random)
{
  const auto direction = [&] {
    Vector_3 v(random.normal(), random.normal(), random.normal());
    return normalized(v);
  };
  Registration registration;
  registration.center = CGAL::midpoint(Point_3(box.xmin(), box.ymin(), box.zmin()),
                                       Point_3(box.xmax(), box.ymax(), box.zmax()));
  registration.axis = direction();
  registration.shift = 0.7 * displacement * direction();
  constexpr double two_pi = 6.28318530717958648;
  registration.turn = Rotation::of_turns(0.7 * displacement / (0.5 * diagonal(box)) / two_pi);
  return registration;
}

/// The view of one station. Rays are independent of each other.
inline void add_view(const Ray_caster& cast, const Scanner& scanner, const Pose& pose,
                     const Scanning& scanning, std::uint64_t view, const Registration& registration,
                     Scan& scan)
{
  for (std::size_t ray = 0; ray < scanner.number_of_rays(); ++ray) {
    const Vector_3 direction = scanner.direction(pose, ray);
    const std::optional<Hit> first = cast(pose.position, direction);
    if (!first)
      continue;
    Counter_random random(scanning.seed, view + 1, ray);
    const Point_3 exact = pose.position + first->range * direction;
    if (scanner.baseline > 0 && !cast.sees(pose.position + scanner.baseline * pose.right, exact))
      continue; // in the shadow of the projector

    const Vector_3 aside(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
    const Vector_3 part_of_beam = normalized(direction + 2 * scanner.beam_radius * aside);
    const std::optional<Hit> second = cast(pose.position, part_of_beam);
    const double correlated = scanner.disparity_noise > 0
                                ? scanner.correlated_noise(scanning.seed, view, ray)
                                : 0;
    const std::optional<double> range =
      scanner.reported_range(*first, second, direction * pose.forward, correlated, random);
    if (range)
      scan.points.push_back({registration(pose.position + *range * direction), exact, int(view)});
  }
}

/// \throws std::invalid_argument if the scene has fewer stations than views, or a number is out of
/// its range
inline Scan make_scan(const Scene& scene, Scanner scanner, const Scanning& scanning)
{
  if (scanning.number_of_views < 1 || scanning.number_of_views > scene.stations.size())
    throw std::invalid_argument("the scene has stations for 1 to "
                                + std::to_string(scene.stations.size()) + " views");
  if (!(scanning.registration_error >= 0 && scanning.registration_error < 10))
    throw std::invalid_argument("the error of registration must be in [0, 10) %");
  if (!(scanning.noise_factor >= 0 && scanning.noise_factor < 1000))
    throw std::invalid_argument("the factor of noise must be in [0, 1000)");
  scanner.range_noise *= scanning.noise_factor;
  scanner.disparity_noise *= scanning.noise_factor;
  scanner.beam_radius *= scanning.noise_factor > 0;

  const Ray_caster cast(scene.mesh);
  const CGAL::Bbox_3 box = bounding_box(scene.mesh);
  Scan scan;
  for (std::size_t view = 0; view < scanning.number_of_views; ++view) {
    Counter_random random(scanning.seed, 0, view);
    const Point_3& station = scene.stations[view];
    const Rotation heading = Rotation::of_turns(random.uniform());
    const Pose pose = scanner.is_camera() ? Pose::aimed(station, scene.target)
                                          : Pose::upright(station, heading);
    const Registration registration =
      make_registration(box, scanning.registration_error / 100 * diagonal(box), random);
    scan.viewpoints.push_back(registration(station));
    add_view(cast, scanner, pose, scanning, view, registration, scan);
  }
  return scan;
}

/// Binary PLY of `float` x, y, z and `int` view.
/// \param position reported or exact
/// \throws std::runtime_error if the file cannot be written
inline void write_scan(const std::string& path, const Scan& scan, Point_3 Scan_point::*position)
{
  using Float_point = CGAL::Simple_cartesian<float>::Point_3;
  using Row = std::pair<Float_point, int>;
  std::vector<Row> rows;
  rows.reserve(scan.points.size());
  for (const Scan_point& point : scan.points) {
    const Point_3& p = point.*position;
    rows.emplace_back(Float_point(float(p.x()), float(p.y()), float(p.z())), point.view);
  }
  std::ofstream stream(path, std::ios::binary);
  CGAL::IO::set_binary_mode(stream);
  const bool is_written = CGAL::IO::write_PLY_with_properties(
    stream, rows, CGAL::IO::make_ply_point_writer(CGAL::First_of_pair_property_map<Row>()),
    std::make_pair(CGAL::Second_of_pair_property_map<Row>(), CGAL::IO::PLY_property<int>("view")));
  if (!is_written || !stream.flush())
    throw std::runtime_error(path + ": cannot be written");
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SCAN_H
