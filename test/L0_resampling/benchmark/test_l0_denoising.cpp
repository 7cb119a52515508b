// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// L0 denoising as the benchmarks have it: normals and positions become clean and keep their jumps.

#include "../../../benchmark/L0_resampling/methods/l0_denoising.h"
#include "test_support.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace L0_benchmark;

constexpr std::size_t n = 3000;
const double side = std::sqrt(double(n) / 6); // so that the spacing is about 1

struct Scene
{
  test::Oriented_points cube;
  Rows positions{Eigen::Index(n), 3}, normals{Eigen::Index(n), 3};
  Pairs pairs;
};

/// A cube with noise of the normals and of the positions.
Scene cube_scene(double normal_noise, double position_noise)
{
  test::Generator generator(5);
  Scene scene;
  scene.cube = test::cube_points(n, side, generator);
  std::vector<test::Vector> points = scene.cube.points, normals = scene.cube.normals;
  test::add_gaussian_noise(points, position_noise, generator);
  test::add_gaussian_noise(normals, normal_noise, generator);
  std::vector<Point_3> for_pairs;
  for (std::size_t i = 0; i < n; ++i)
  {
    scene.positions.row(Eigen::Index(i)) = points[i].transpose();
    scene.normals.row(Eigen::Index(i)) = normals[i].normalized().transpose();
    for_pairs.push_back(to_cgal(points[i]));
  }
  scene.pairs = neighbor_pairs(for_pairs, L0_denoising_parameters().number_of_neighbors);
  return scene;
}

double share_of_good_normals(const Scene& scene, const Rows& normals)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < n; ++i)
    count += normals.row(Eigen::Index(i)).dot(scene.cube.normals[i].transpose())
             > std::cos(5 * EIGEN_PI / 180);
  return double(count) / double(n);
}

double mean_distance_to_cube(const Rows& positions)
{
  double sum = 0;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
    sum += std::abs(positions.row(i).cwiseAbs().maxCoeff() - side / 2);
  return sum / double(positions.rows());
}

Rows true_normals(const Scene& scene)
{
  Rows normals = scene.normals;
  for (std::size_t i = 0; i < n; ++i)
    normals.row(Eigen::Index(i)) = scene.cube.normals[i].transpose();
  return normals;
}

void every_point_has_enough_neighbors()
{
  const Scene scene = cube_scene(0, 0);
  std::vector<std::size_t> degrees(n, 0);
  for (const auto& [i, j] : scene.pairs)
  {
    CHECK(i < j);
    ++degrees[i];
    ++degrees[j];
  }
  CHECK(*std::min_element(degrees.begin(), degrees.end())
        >= L0_denoising_parameters().number_of_neighbors);
}

// Piecewise constant, and the faces of the cube stay three directions apart.
void normals_become_those_of_faces()
{
  const Scene scene = cube_scene(0.2, 0);
  const Rows denoised = denoised_normals(scene.normals, scene.pairs, L0_denoising_parameters());
  CHECK(share_of_good_normals(scene, scene.normals) < 0.3);
  CHECK(share_of_good_normals(scene, denoised) > 0.95);
}

void positions_lose_their_noise_along_the_normals_only()
{
  const Scene scene = cube_scene(0, 0.2);
  const Rows normals = true_normals(scene);
  const Rows denoised = denoised_positions(scene.positions, normals, scene.pairs,
                                           L0_denoising_parameters());
  CHECK(mean_distance_to_cube(denoised) < mean_distance_to_cube(scene.positions) / 2);
  const Rows steps = denoised - scene.positions;
  for (Eigen::Index i = 0; i < steps.rows(); ++i)
    CHECK((steps.row(i) - steps.row(i).dot(normals.row(i)) * normals.row(i)).norm() < 1e-9);
}

// A clean cube: what is far from the edges stays, and points at an edge move onto it without
// leaving the cube's surface.
void points_at_edges_move_onto_them()
{
  const Scene scene = cube_scene(0, 0);
  const Rows moved = points_on_edges(scene.positions, true_normals(scene), scene.pairs,
                                     L0_denoising_parameters());
  CHECK(mean_distance_to_cube(moved) < 1e-2);
  const auto distance_to_edge = [](const Eigen::RowVector3d& p) {
    Eigen::RowVector3d sizes = p.cwiseAbs();
    std::sort(sizes.data(), sizes.data() + 3);
    return side / 2 - sizes[1];
  };
  std::size_t number_moved = 0;
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
  {
    const double before = distance_to_edge(scene.positions.row(i)),
                 after = distance_to_edge(moved.row(i));
    if (before > 5) // spacings, beyond all neighbors
      CHECK(moved.row(i) == scene.positions.row(i));
    number_moved += before > 0.2 && before < 0.8 && after < before / 2;
  }
  CHECK(number_moved > 100);
}

} // namespace

int main()
{
  every_point_has_enough_neighbors();
  normals_become_those_of_faces();
  positions_lose_their_noise_along_the_normals_only();
  points_at_edges_move_onto_them();
  return test::result();
}
