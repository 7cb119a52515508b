// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the shapes of data/: a mesh (the ground truth), a clean and a noisy sampling of each.

#include "sample_mesh.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using L0_benchmark::Point_3;
using L0_benchmark::Triangle_mesh;
using L0_benchmark::Vector_3;

using Plane_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point_2 = Plane_kernel::Point_2;
using Polygon = std::vector<Point_2>;

using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Plane_kernel>;
using Face_base = CGAL::Constrained_triangulation_face_base_2<Plane_kernel>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
  Plane_kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;

constexpr double pi = 3.14159265358979323846;

/// The solid over a polygon with holes, from z = 0 to z = `height`.
/// \param boundaries the outer one counterclockwise, the holes clockwise: the solid is to their
/// left
Triangle_mesh extrude(const std::vector<Polygon>& boundaries, double height)
{
  Triangle_mesh solid;
  Triangulation triangulation;
  // Vertex 2i is on the bottom, 2i + 1 above it.
  for (const Polygon& boundary : boundaries) {
    const std::size_t first = solid.vertices.size();
    std::vector<Triangulation::Vertex_handle> handles;
    for (const Point_2& p : boundary) {
      handles.push_back(triangulation.insert(p));
      handles.back()->info() = solid.vertices.size();
      solid.vertices.emplace_back(p.x(), p.y(), 0);
      solid.vertices.emplace_back(p.x(), p.y(), height);
    }
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const std::size_t next = (i + 1) % boundary.size();
      triangulation.insert_constraint(handles[i], handles[next]);
      const std::size_t a = first + 2 * i, b = first + 2 * next;
      solid.triangles.push_back({a, b, b + 1});
      solid.triangles.push_back({a, b + 1, a + 1});
    }
  }
  for (const auto face : triangulation.finite_face_handles()) {
    const Point_2 center = CGAL::centroid(triangulation.triangle(face));
    const auto surrounds_center = [&](const Polygon& boundary) {
      return CGAL::bounded_side_2(boundary.begin(), boundary.end(), center)
             == CGAL::ON_BOUNDED_SIDE;
    };
    // Within the outer boundary and no hole: an odd number.
    if (std::count_if(boundaries.begin(), boundaries.end(), surrounds_center) % 2 == 1) {
      const std::size_t a = face->vertex(0)->info(), b = face->vertex(1)->info(),
                        c = face->vertex(2)->info();
      solid.triangles.push_back({a, c, b});
      solid.triangles.push_back({a + 1, b + 1, c + 1});
    }
  }
  return solid;
}

Polygon rectangle(double width, double depth)
{
  return {Point_2(0, 0), Point_2(width, 0), Point_2(width, depth), Point_2(0, depth)};
}

/// Convex and concave right angles, corners of both kinds.
Triangle_mesh make_staircase()
{
  const int number_of_steps = 4;
  const double step = 0.25;
  Polygon profile = {Point_2(0, 0), Point_2(number_of_steps * step, 0)};
  for (int i = 1; i <= number_of_steps; ++i) {
    profile.emplace_back((number_of_steps - i + 1) * step, i * step);
    profile.emplace_back((number_of_steps - i) * step, i * step);
  }
  profile.pop_back();
  profile.emplace_back(0, number_of_steps * step);
  return extrude({profile}, 0.8);
}

/// Sharp edges that are straight and curved, one of them concave and acute.
Triangle_mesh make_bracket()
{
  const Polygon outline = {Point_2(0, 0),   Point_2(1.2, 0),    Point_2(1.2, 0.8),
                           Point_2(1, 0.8), Point_2(0.85, 0.5), Point_2(0.7, 0.8),
                           Point_2(0, 0.8)};
  const int number_of_sides = 64; // 5.6 degrees from one to the next: smooth
  Polygon hole;
  for (int i = 0; i < number_of_sides; ++i)
    hole.emplace_back(0.35 + 0.2 * std::cos(2 * pi * i / number_of_sides),
                      0.4 - 0.2 * std::sin(2 * pi * i / number_of_sides));
  return extrude({outline, hole}, 0.5);
}

/// Two sides with opposite normals, 2 % of the diagonal apart.
Triangle_mesh make_thin_plate() { return extrude({rectangle(1, 0.7)}, 0.025); }

/// Regular, with circumscribed radius sqrt(3).
Triangle_mesh make_dodecahedron()
{
  const double phi = (1 + std::sqrt(5.)) / 2;
  const double signs[] = {-1, 1};
  Triangle_mesh solid;
  std::vector<Vector_3> face_normals;
  for (double s : signs)
    for (double t : signs) {
      for (double u : signs)
        solid.vertices.emplace_back(s, t, u);
      for (int axis = 0; axis < 3; ++axis) {
        const auto turned = [axis](double a, double b, double c) {
          const double xyz[] = {a, b, c};
          return Vector_3(xyz[axis], xyz[(axis + 1) % 3], xyz[(axis + 2) % 3]);
        };
        solid.vertices.push_back(CGAL::ORIGIN + turned(0, s / phi, t * phi));
        face_normals.push_back(turned(0, s * phi, t));
      }
    }
  for (const Vector_3& normal : face_normals) {
    std::vector<std::pair<double, std::size_t>> corners; // angle around the normal, vertex
    const Vector_3 x_axis = CGAL::cross_product(normal, Vector_3(1, 2, 3));
    const Vector_3 y_axis = CGAL::cross_product(normal, x_axis)
                            / std::sqrt(normal.squared_length());
    for (std::size_t v = 0; v < solid.vertices.size(); ++v) {
      const Vector_3 position = solid.vertices[v] - CGAL::ORIGIN;
      if (position * normal > phi) // phi^2 on the face, 1 / phi or less elsewhere
        corners.emplace_back(std::atan2(position * y_axis, position * x_axis), v);
    }
    std::sort(corners.begin(), corners.end());
    for (std::size_t i = 2; i < corners.size(); ++i)
      solid.triangles.push_back({corners[0].second, corners[i - 1].second, corners[i].second});
  }
  return solid;
}

/// Smooth, curved to both sides: radii 1 and 0.4.
Triangle_mesh make_torus()
{
  const std::size_t around = 80, across = 40;
  Triangle_mesh torus;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      const double u = 2 * pi * double(i) / around, v = 2 * pi * double(j) / across;
      const double radius = 1 + 0.4 * std::cos(v);
      torus.vertices.emplace_back(radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v));
      const auto vertex = [&](std::size_t di, std::size_t dj) {
        return (i + di) % around * across + (j + dj) % across;
      };
      torus.triangles.push_back({vertex(0, 0), vertex(1, 0), vertex(1, 1)});
      torus.triangles.push_back({vertex(0, 0), vertex(1, 1), vertex(0, 1)});
    }
  return torus;
}

struct Shape
{
  std::string name;
  Triangle_mesh mesh;
  std::size_t number_of_points;
};

/// The mesh as its file holds it. 9 decimals are more than the points keep, and hide that sines
/// differ a little between platforms.
Triangle_mesh rounded(Triangle_mesh mesh)
{
  const auto round = [](double x) {
    return std::round(x * 1e9) / 1e9 + 0.;
  }; // + 0 makes -0 positive
  for (Point_3& p : mesh.vertices)
    p = Point_3(round(p.x()), round(p.y()), round(p.z()));
  return mesh;
}

void write(const Shape& shape, const std::string& folder)
{
  const std::string path = folder + "/" + shape.name;
  if (!CGAL::IO::write_OFF(path + ".off", shape.mesh.vertices, shape.mesh.triangles,
                           CGAL::parameters::stream_precision(10)))
    throw std::runtime_error(path + ".off: cannot be written");
  L0_benchmark::Sampling sampling;
  sampling.number_of_points = shape.number_of_points;
  L0_benchmark::write_points(path + "_clean.ply", L0_benchmark::sample_mesh(shape.mesh, sampling));
  sampling.noise = 0.5;
  sampling.seed = 2;
  L0_benchmark::write_points(path + "_noisy.ply", L0_benchmark::sample_mesh(shape.mesh, sampling));
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc != 2) {
    std::cerr << "usage: make_shapes FOLDER\n";
    return 2;
  }
  try {
    for (const Shape& shape : {Shape{"dodecahedron", rounded(make_dodecahedron()), 8000},
                               Shape{"staircase", rounded(make_staircase()), 10000},
                               Shape{"bracket", rounded(make_bracket()), 10000},
                               Shape{"thin_plate", rounded(make_thin_plate()), 8000},
                               Shape{"torus", rounded(make_torus()), 8000}})
      write(shape, argv[1]);
  } catch (const std::exception& error) {
    std::cerr << "make_shapes: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
