// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SAMPLE_MESH_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SAMPLE_MESH_H

#include "Portable_random.h"
#include "Triangle_mesh.h"

#include <CGAL/IO/write_ply_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace L0_benchmark {

/// How to imitate a scan of a mesh.
struct Sampling
{
  std::size_t number_of_points = 10000; ///< exact, outliers included
  double noise = 0;    ///< standard deviation of each coordinate, % of the bounding box's diagonal
  double outliers = 0; ///< share of the points, %
  double density_gradient =
    1; ///< >= 1: density at the upper end of the longest axis over that at the lower end
  std::uint64_t seed = 1;
};

/// Draws points uniformly by area from a mesh, which must outlive the sampler.
class Area_sampler
{
public:
  /// \throws std::invalid_argument if the mesh has no area
  explicit Area_sampler(const Triangle_mesh& mesh) : m_mesh(mesh)
  {
    m_cumulated_areas.reserve(mesh.triangles.size());
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      area += std::sqrt(mesh.triangle(t).squared_area());
      m_cumulated_areas.push_back(area);
    }
    if (!(area > 0) || !std::isfinite(area))
      throw std::invalid_argument("a mesh without area cannot be sampled");
  }

  double area() const { return m_cumulated_areas.back(); }

  Point_3 operator()(Portable_random& random) const
  {
    const double position = random.uniform() * area();
    const auto found = std::upper_bound(m_cumulated_areas.begin(), m_cumulated_areas.end(),
                                        position);
    // Rounding may put the position on the total area, which belongs to no triangle.
    const std::size_t t = (std::min)(std::size_t(found - m_cumulated_areas.begin()),
                                     m_cumulated_areas.size() - 1);
    const Triangle_3 triangle = m_mesh.triangle(t);
    double u = random.uniform();
    double v = random.uniform();
    if (u + v > 1) { // the other half of the parallelogram, turned onto the triangle
      u = 1 - u;
      v = 1 - v;
    }
    return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
  }

private:
  const Triangle_mesh& m_mesh;
  std::vector<double> m_cumulated_areas;
};

inline void check(const Sampling& sampling)
{
  const auto demand = [](bool condition, const char* name, double value, const char* range) {
    if (!condition)
      throw std::invalid_argument(std::string(name) + " is " + std::to_string(value) + ", must be "
                                  + range);
  };
  demand(sampling.noise >= 0 && std::isfinite(sampling.noise), "noise", sampling.noise,
         "finite and not negative");
  demand(sampling.outliers >= 0 && sampling.outliers <= 100, "outliers", sampling.outliers,
         "in [0, 100]");
  demand(sampling.density_gradient >= 1 && std::isfinite(sampling.density_gradient),
         "density gradient", sampling.density_gradient, "finite and at least 1");
}

/// Points on the surface first, moved by isotropic Gaussian noise, then the outliers: uniform in
/// the bounding box with each side grown by 10 % of the diagonal, since 10 % of a flat side would
/// be nothing. The density grows exponentially along the longest axis of the box.
/// \throws std::invalid_argument if a value of `sampling` is out of its range, or the mesh has no
/// area
inline std::vector<Point_3> sample_mesh(const Triangle_mesh& mesh, const Sampling& sampling)
{
  check(sampling);
  const Area_sampler draw(mesh);
  const CGAL::Bbox_3 box = bounding_box(mesh);
  const double extents[] = {box.x_span(), box.y_span(), box.z_span()};
  const int axis = int(std::max_element(extents, extents + 3) - extents);
  const double standard_deviation = sampling.noise / 100 * diagonal(box);
  const std::size_t number_of_outliers = std::size_t(
    std::llround(double(sampling.number_of_points) * sampling.outliers / 100));

  Portable_random random(sampling.seed);
  std::vector<Point_3> points;
  points.reserve(sampling.number_of_points);
  while (points.size() < sampling.number_of_points - number_of_outliers) {
    const Point_3 p = draw(random);
    const double height = (p[axis] - (box.min)(axis)) / extents[axis];
    if (sampling.density_gradient > 1
        && random.uniform() >= std::pow(sampling.density_gradient, height - 1))
      continue;
    double offset[3] = {0, 0, 0};
    if (standard_deviation > 0)
      for (double& coordinate : offset)
        coordinate = standard_deviation * random.normal();
    points.push_back(p + Vector_3(offset[0], offset[1], offset[2]));
  }
  const double growth = 0.1 * diagonal(box);
  while (points.size() < sampling.number_of_points) {
    double coordinates[3];
    for (int i = 0; i < 3; ++i)
      coordinates[i] = (box.min)(i)-growth / 2 + random.uniform() * (extents[i] + growth);
    points.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
  }
  return points;
}

/// Binary PLY of `float` x, y, z: half the size, and rounding is far below any noise.
/// \throws std::runtime_error if the file cannot be written
inline void write_points(const std::string& path, const std::vector<Point_3>& points)
{
  using Float_point = CGAL::Simple_cartesian<float>::Point_3;
  std::vector<Float_point> rounded;
  rounded.reserve(points.size());
  for (const Point_3& p : points)
    rounded.emplace_back(float(p.x()), float(p.y()), float(p.z()));
  if (!CGAL::IO::write_PLY(path, rounded))
    throw std::runtime_error(path + ": cannot be written");
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SAMPLE_MESH_H
