// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orientation_support.h"

#include <CGAL/L0_resampling/internal/orientation/orient_normals.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <set>
#include <vector>

using namespace test;

/// Turns true outward normals by chance and asks for them back.
void check_orientation(const Oriented_points& truth, double spacing, Generator& generator)
{
  Buffer<Vector> normals = to_buffer(truth.normals);
  for (Vector& n : normals)
    if (std::bernoulli_distribution()(generator))
      n = -n;
  const Buffer<Vector> positions = to_buffer(truth.points), unoriented = normals;
  Unwatched unwatched;
  CHECK(orient_normals<CGAL::Parallel_if_available_tag>(positions, 12, spacing, Side_hints(),
                                                        unwatched.progress, normals)
          .oriented_share
        == 1);

  CHECK(positions == to_buffer(truth.points)); // by index: nobody changed places
  bool are_only_turned = true;
  std::size_t number_outward = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    are_only_turned = are_only_turned
                      && (normals[i] == unoriented[i] || normals[i] == -unoriented[i]);
    number_outward += normals[i].dot(truth.normals[i]) > 0;
  }
  CHECK(are_only_turned);
  CHECK(number_outward == normals.size());
}

/// The graph is that of the nearest neighbors, the very nearest first, of whatever spacing one
/// guesses.
void check_nearest(const Oriented_points& cloud, double spacing_guess)
{
  Unwatched unwatched;
  const Nearest_samples nearest = find_nearest_samples<CGAL::Parallel_if_available_tag>(
    to_buffer(cloud.points), 5, 12, spacing_guess, unwatched.progress);
  bool are_nearest = true;
  for (Index i = 0; i < cloud.points.size(); ++i)
  {
    std::vector<Index> others;
    for (Index k = 0; k < cloud.points.size(); ++k)
      if (k != i)
        others.push_back(k);
    const auto distance = [&](Index k) {
      return (cloud.points[i] - cloud.points[k]).squaredNorm();
    };
    std::partial_sort(others.begin(), others.begin() + 12, others.end(),
                      [&](Index a, Index b) { return distance(a) < distance(b); });
    std::vector<double> found, expected; // of equally far ones, any will do
    for (const Index* k = nearest.begin(i); k != nearest.end(i); ++k)
      found.push_back(distance(*k));
    are_nearest = are_nearest && nearest.end_of_first(i) - nearest.begin(i) == 5;
    std::sort(found.begin(), found.begin() + 5);
    std::sort(found.begin() + 5, found.end());
    std::transform(others.begin(), others.begin() + 12, std::back_inserter(expected), distance);
    are_nearest = are_nearest && found == expected
                  && std::set<Index>(nearest.begin(i), nearest.end(i)).size() == 12
                  && !nearest.is_one_of_first(i, i);
  }
  CHECK(are_nearest);
}

/// Samples are sorted by place, as the stage before leaves them.
Oriented_points in_order_of_cells(const Oriented_points& cloud, double cell_size)
{
  Oriented_points result;
  for (const Index i :
       Search_grid_3::sorted_order<CGAL::Sequential_tag>(to_buffer(cloud.points), cell_size))
  {
    result.points.push_back(cloud.points[i]);
    result.normals.push_back(cloud.normals[i]);
  }
  return result;
}

/// On the box [0, size] without its part above and behind the middle if `is_step`: that leaves an
/// edge of 90 degrees that is concave.
Oriented_points box_points(std::size_t n, const Vector& size, bool is_step, Generator& generator)
{
  // faces: axis, coordinate on it, outward sign, low and high corner
  struct Face
  {
    int axis;
    double sign;
    Vector low, high;
  };
  std::vector<Face> faces;
  const auto add = [&](int axis, double sign, const Vector& low, const Vector& high) {
    faces.push_back({axis, sign, low, high});
  };
  const double x = size[0], y = size[1], z = size[2], hx = is_step ? x / 2 : x, hz = z / 2;
  add(2, -1, {0, 0, 0}, {x, y, 0});
  add(2, 1, {0, 0, z}, {hx, y, z});
  add(0, -1, {0, 0, 0}, {0, y, z});
  add(0, 1, {x, 0, 0}, {x, y, is_step ? hz : z});
  for (int side : {0, 1})
  {
    add(1, side ? 1 : -1, {0, side * y, 0}, {x, side * y, hz});
    add(1, side ? 1 : -1, {0, side * y, hz}, {hx, side * y, z});
  }
  if (is_step)
  {
    add(2, 1, {hx, 0, hz}, {x, y, hz});
    add(0, 1, {hx, 0, hz}, {hx, y, z});
  }
  std::vector<double> areas;
  for (const Face& f : faces)
  {
    const Vector extent = f.high - f.low;
    areas.push_back(extent[(f.axis + 1) % 3] * extent[(f.axis + 2) % 3]);
  }
  std::discrete_distribution<std::size_t> face(areas.begin(), areas.end());
  Oriented_points result;
  for (std::size_t i = 0; i < n; ++i)
  {
    const Face& f = faces[face(generator)];
    Vector p;
    for (int c = 0; c < 3; ++c)
      p[c] = f.low[c] < f.high[c] ? random_number(f.low[c], f.high[c], generator) : f.low[c];
    result.points.push_back(p);
    result.normals.push_back(f.sign * Vector::Unit(f.axis));
  }
  return result;
}

Oriented_points together(const Oriented_points& a, const Oriented_points& b, const Vector& shift)
{
  Oriented_points result = a;
  for (const Vector& p : b.points)
    result.points.push_back(p + shift);
  result.normals.insert(result.normals.end(), b.normals.begin(), b.normals.end());
  return result;
}

/// A flat patch has no outside, but one side: the same for all its normals, whatever signs they
/// came with.
void check_plane(Generator& generator)
{
  Oriented_points plane = plane_points(500, 1, generator);
  for (Vector& p : plane.points)
    p = Vector(p[2], p[0], p[1]);
  std::vector<Buffer<Vector>> results;
  for (int n = 0; n < 8; ++n)
  {
    results.push_back(Buffer<Vector>(500, Vector::UnitX()));
    for (Vector& normal : results.back())
      if (std::bernoulli_distribution()(generator))
        normal = -normal;
    Unwatched unwatched;
    orient_normals<CGAL::Sequential_tag>(to_buffer(plane.points), 12, 0.05, Side_hints(),
                                         unwatched.progress, results.back());
    CHECK(std::count(results.back().begin(), results.back().end(), results.back().front()) == 500);
    CHECK(results.back() == results.front());
  }
}

/// Samples whose viewpoints leave no doubt face them, each for itself; the others follow these, and
/// not their own viewpoints.
void check_viewpoints(Generator& generator)
{
  const Oriented_points plane = plane_points(500, 1, generator);
  Buffer<Vector> normals(500, Vector::UnitZ());
  for (Vector& normal : normals)
    if (std::bernoulli_distribution()(generator))
      normal = -normal;
  const Buffer<Vector> unoriented = normals;
  Side_hints hints;
  hints.direction_of = [](Index i) -> Vector {
    return i % 100 == 0 ? Vector(0.8, 0, 0.6) : Vector(std::sqrt(0.99), 0, -0.1);
  };
  const auto turned = [&]() {
    normals = unoriented;
    Unwatched unwatched;
    const Orientation orientation = orient_normals<CGAL::Parallel_if_available_tag>(
      to_buffer(plane.points), 12, 0.05, hints, unwatched.progress, normals);
    CHECK(orientation.hinted_share == 1);
    return std::size_t(std::count(normals.begin(), normals.end(), Vector(Vector::UnitZ())));
  };
  CHECK(turned() == 0); // the majority of hints
  hints.are_viewpoints = true;
  CHECK(turned() == 500);

  const auto is_certain = [&](Index i) { return i % 3 == 0; };
  hints.direction_of = [&](Index i) -> Vector {
    const double height = is_certain(i) ? 0.18 : 0.16;
    return Vector(std::sqrt(1 - height * height), 0, i % 2 == 0 ? height : -height);
  };
  turned();
  bool do_face = true;
  for (Index i = 0; i < 500; ++i)
    do_face = do_face && (!is_certain(i) || normals[i].dot(hints.direction_of(i)) > 0);
  CHECK(do_face);
}

/// Sets grow by the surest edges until they are large, and no further; but as far as they can, if
/// they stay small.
void check_forest(Generator& generator)
{
  const Index columns = 90, n = columns * columns;
  std::vector<int> signs;
  for (Index i = 0; i < n; ++i)
    signs.push_back(std::bernoulli_distribution()(generator) ? -1 : 1);
  const auto forest_of = [&](double doubtful_share) {
    Buffer<Edge> edges;
    Signed_union_find whole(n, {});
    const auto add = [&](Index i, Index k) {
      const bool is_doubtful = random_number(0, 1, generator) < doubtful_share;
      const double agreement = is_doubtful ? random_number(0, 0.97, generator)
                                           : random_number(0.985, 1, generator);
      edges.push_back({float(signs[i] * signs[k] * agreement), i, k});
      if (!is_doubtful)
        whole.join(i, k, 1);
    };
    for (Index i = 0; i < n; ++i)
    {
      if (i % columns > 0)
        add(i, i - 1);
      if (i >= columns)
        add(i, i - columns);
      if (doubtful_share == 0 && i > columns) // less sure than all others, and wrong
        edges.push_back({float(-0.981 * signs[i] * signs[i - columns - 1]), i, i - columns - 1});
    }
    Buffer<Edge> left = copy_of(edges), left_again = copy_of(edges);
    const Signed_union_find sets =
      grow_forest<CGAL::Parallel_if_available_tag>(Signed_union_find(n, {}), left);
    const Signed_union_find again = grow_forest<CGAL::Sequential_tag>(Signed_union_find(n, {}),
                                                                      left_again);
    bool are_signs_right = true, are_within_whole = true, are_whole = true, are_same = true;
    for (Index i = 0; i < n; ++i)
    {
      const auto [root, sign] = sets.find(i);
      are_signs_right = are_signs_right && sign == signs[i] * signs[root];
      are_within_whole = are_within_whole && whole.find(i).first == whole.find(root).first;
      are_whole = are_whole && sets.size_of_set(root) == whole.size_of_set(whole.find(i).first);
      are_same = are_same && again.find(i) == sets.find(i);
    }
    // between the sets: those that led from one to another, with their signs
    std::size_t e = 0;
    bool are_left = true;
    for (const Edge& edge : edges)
    {
      const auto [root_i, sign_i] = sets.find(edge.i);
      const auto [root_k, sign_k] = sets.find(edge.k);
      if (root_i == root_k)
        continue;
      are_left = are_left && e < left.size() && left[e].i == root_i && left[e].k == root_k
                 && left[e].agreement == float(sign_i * sign_k) * edge.agreement;
      ++e;
    }
    CHECK(are_left && e == left.size() && e == left_again.size());
    CHECK(are_signs_right);
    CHECK(are_within_whole);
    CHECK(are_same);
    CHECK(are_sets_large(samples_of_dipoles(n), sets) != are_whole);
  };
  forest_of(0);
  forest_of(0.3); // most are one set
  forest_of(0.8); // few are more than two or three
}

/// A chain of samples on an edge of a cube, whose normals lead over edges beyond doubt from the
/// outside of one face to the inside of the other. It must not turn one of them.
void check_misleading_chain(const Oriented_points& even_cube, Generator& generator)
{
  const double spacing = std::sqrt(24. / double(even_cube.points.size()));
  const std::size_t length = 10;
  Oriented_points cloud = even_cube;
  for (std::size_t j = 0; j < length; ++j)
  {
    const double angle = (double(j) + 0.5) / double(length) * EIGEN_PI / 2;
    cloud.points.push_back(Vector(1, 0.02 * spacing * double(j), 1));
    cloud.normals.push_back(Vector(-std::sin(angle), 0, std::cos(angle)));
  }
  cloud = in_order_of_cells(cloud, 4 * spacing);
  Buffer<Vector> normals = to_buffer(cloud.normals);
  for (Vector& n : normals)
    if (std::bernoulli_distribution()(generator))
      n = -n;
  Unwatched unwatched;
  orient_normals<CGAL::Parallel_if_available_tag>(to_buffer(cloud.points), 12, spacing,
                                                  Side_hints(), unwatched.progress, normals);
  std::size_t number_outward = 0;
  for (std::size_t i = 0; i < normals.size(); ++i)
    number_outward += normals[i].dot(cloud.normals[i]) > 0;
  CHECK(number_outward >= even_cube.points.size());
}

/// The sheets of a plate, of so many samples that each dipole stands for an area wider than the
/// plate is thick.
void check_wide_plate(double thickness_in_spacings, Generator& generator)
{
  const double width = 2, spacing = width / 128, thickness = thickness_in_spacings * spacing;
  const Vector size(width, width, thickness);
  Oriented_points plate;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1., 1.})
    {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (double x = spacing / 2; x < size[u]; x += spacing)
        for (double y = spacing / 2; y < size[v]; y += spacing)
        {
          Vector p;
          p[axis] = sign > 0 ? size[axis] : 0;
          p[u] = x + random_number(-0.2, 0.2, generator) * spacing;
          p[v] = y + random_number(-0.2, 0.2, generator) * spacing;
          plate.points.push_back(p);
          plate.normals.push_back(sign * Vector::Unit(axis));
        }
    }
  check_orientation(in_order_of_cells(plate, 4 * spacing), spacing, generator);
}

/// Where the surface bends away within few spacings, edges are beyond doubt at single flat spots
/// only.
void check_coarse_sets(Generator& generator)
{
  for (const std::size_t n : {250, 300, 350, 400, 500})
    for (int repetition = 0; repetition < 4; ++repetition)
    {
      const Oriented_points torus =
        evenly(n, [&](std::size_t size) { return torus_points(size, generator); });
      check_orientation(torus, std::sqrt(1.6 * EIGEN_PI * EIGEN_PI / double(n)), generator);
    }
}

int main()
{
  Generator generator(10);
  const auto sphere = [&](std::size_t n) { return sphere_points(n, 1, generator); };
  const auto cube = [&](std::size_t n) { return cube_points(n, 2, generator); };
  const auto torus = [&](std::size_t n) { return torus_points(n, generator); };
  const auto step = [&](std::size_t n) { return box_points(n, {2, 1, 1}, true, generator); };
  const auto plate = [&](std::size_t n) { return box_points(n, {2, 2, 0.15}, false, generator); };

  const Oriented_points even_sphere = evenly(800, sphere), even_cube = evenly(1200, cube);
  check_orientation(even_sphere, 0.12, generator);
  check_orientation(evenly(1000, torus), 0.12, generator);
  check_orientation(evenly(1500, step), 0.08, generator);
  check_orientation(evenly(1500, plate), 0.08,
                    generator); // twice as thick as the samples are apart
  check_orientation(together(even_sphere, even_cube, Vector(5, 1, 0)), 0.13, generator);
  for (double factor : {0.5, 2.}) // the spacing need not be known well
    check_orientation(even_cube, factor * 0.14, generator);
  check_forest(generator);
  check_misleading_chain(even_cube, generator);
  check_coarse_sets(generator);
  check_plane(generator);
  check_viewpoints(generator);
  for (const double thickness_in_spacings : {2., 3., 4., 8.})
    check_wide_plate(thickness_in_spacings, generator);
  for (double spacing_guess : {1e-3, 0.1, 10.})
  {
    check_nearest(even_cube, spacing_guess);
    check_nearest({lattice_points(8, 0.25), {}}, spacing_guess);
  }
  return result();
}
