// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameter feature_confidence_map: high on edges and corners, low away from them, on
// shapes whose edges are known.

#include "promise_support.h"

#include <CGAL/IO/read_points.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

using Segment = std::pair<Vector, Vector>;

double squared_distance(const Vector& p, const Segment& s)
{
  const Vector along = s.second - s.first;
  const double t = (std::min)((std::max)((p - s.first).dot(along) / along.squaredNorm(), 0.), 1.);
  return (p - s.first - t * along).squaredNorm();
}

/// The edges of a closed triangle mesh between faces whose normals differ by more than 30 degrees.
std::vector<Segment> sharp_edges(const std::string& name)
{
  std::ifstream file(L0_TEST_DATA "/" + name + ".off");
  std::string off;
  std::size_t number_of_vertices = 0, number_of_faces = 0, ignored = 0;
  file >> off >> number_of_vertices >> number_of_faces >> ignored;
  std::vector<Vector> vertices(number_of_vertices);
  for (Vector& v : vertices)
    file >> v[0] >> v[1] >> v[2];
  struct Half_edge
  {
    std::size_t low, high;
    Vector normal;
  };
  std::vector<Half_edge> half_edges;
  for (std::size_t f = 0; f < number_of_faces; ++f)
  {
    std::size_t v[3];
    file >> ignored >> v[0] >> v[1] >> v[2];
    const Vector a = vertices[v[1]] - vertices[v[0]], b = vertices[v[2]] - vertices[v[0]];
    const Vector normal = Vector(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                 a[0] * b[1] - a[1] * b[0])
                            .normalized();
    for (int k = 0; k < 3; ++k)
      half_edges.push_back(
        {(std::min)(v[k], v[(k + 1) % 3]), (std::max)(v[k], v[(k + 1) % 3]), normal});
  }
  CHECK(!file.fail() && !half_edges.empty());
  std::sort(half_edges.begin(), half_edges.end(), [](const Half_edge& a, const Half_edge& b) {
    return std::make_pair(a.low, a.high) < std::make_pair(b.low, b.high);
  });
  std::vector<Segment> edges;
  for (std::size_t k = 0; k + 1 < half_edges.size(); k += 2)
    if (half_edges[k].normal.dot(half_edges[k + 1].normal) < std::cos(EIGEN_PI / 6))
      edges.emplace_back(vertices[half_edges[k].low], vertices[half_edges[k].high]);
  return edges;
}

/// What shares of the points are found to be what they are.
struct Rates
{
  double near_and_high; ///< of those within a spacing of an edge: of at least 0.5
  double far_and_low;   ///< of those further than four spacings from all: of at most 0.2
};

Rates measure(const Points& points, const std::vector<Segment>& edges)
{
  std::vector<float> confidences(points.size() / 2);
  test::Pairs<Kernel> result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result),
    params::feature_confidence_map(CGAL::make_property_map(confidences)));
  CHECK(result.size() == confidences.size());

  std::vector<Vector> positions;
  for (const auto& pair : result)
    positions.push_back(test::as_vector(pair.first));
  double spacing = 0; // mean distance to the third of the nearest, of a sample
  const std::size_t step = 20;
  for (std::size_t i = 0; i < positions.size(); i += step)
  {
    std::vector<double> distances;
    for (const Vector& q : positions)
      distances.push_back((positions[i] - q).squaredNorm());
    std::nth_element(distances.begin(), distances.begin() + 3, distances.end());
    spacing += std::sqrt(distances[3]) / double((positions.size() + step - 1) / step);
  }

  std::size_t number_near = 0, number_high = 0, number_far = 0, number_low = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Segment& edge : edges)
      nearest = (std::min)(nearest, squared_distance(positions[i], edge));
    const double distance = std::sqrt(nearest) / spacing;
    number_near += distance < 1;
    number_high += distance < 1 && confidences[i] >= 0.5;
    number_far += distance > 4;
    number_low += distance > 4 && confidences[i] <= 0.2;
  }
  return {number_near > 0 ? double(number_high) / double(number_near) : 1,
          number_far > 0 ? double(number_low) / double(number_far) : 1};
}

void check(const std::string& name, const Points& points, const std::vector<Segment>& edges,
           const Rates& least)
{
  const Rates rates = measure(points, edges);
  std::cout << name << ": near and at least 0.5 " << rates.near_and_high << ", far and at most 0.2 "
            << rates.far_and_low << std::endl;
  if (!CHECK(rates.near_and_high >= least.near_and_high && rates.far_and_low >= least.far_and_low))
    std::cerr << "  " << name << std::endl;
}

void check_data(const std::string& name, const Rates& least)
{
  const std::vector<Segment> edges = sharp_edges(name);
  for (const char* kind : {"_clean", "_noisy"}) // the noise is 0.5 % of the diagonal
  {
    Points points;
    CHECK(
      CGAL::IO::read_points(L0_TEST_DATA "/" + name + kind + ".ply", std::back_inserter(points)));
    check(name + kind, points, edges, least);
  }
}

void check_cube(double noise, const Rates& least)
{
  std::vector<Segment> edges;
  for (int axis = 0; axis < 3; ++axis)
    for (double u : {-0.5, 0.5})
      for (double v : {-0.5, 0.5})
      {
        Vector a;
        a[axis] = -0.5;
        a[(axis + 1) % 3] = u;
        a[(axis + 2) % 3] = v;
        edges.emplace_back(a, a + Vector::Unit(axis));
      }
  test::Generator generator(1);
  std::vector<Vector> points = test::cube_points(8000, 1, generator).points;
  test::add_gaussian_noise(points, noise * std::sqrt(3.), generator);
  check("cube, noise " + std::to_string(noise), test::kernel_points<Kernel>(points), edges, least);
}

} // namespace

int main()
{
  check_cube(0, {0.9, 0.99});
  check_cube(0.005, {0.9, 0.99});
  check_data("dodecahedron", {0.85, 0.99});
  check_data("staircase", {0.9, 0.99});
  check_data("bracket", {0.9, 0.9});
  // smooth, but with few points around: it bends by 20 degrees in a neighborhood
  check_data("torus", {1, 0.7});
  return test::result();
}
