// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SCENES_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SCENES_H

#include "Counter_random.h"
#include "solids.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace L0_benchmark {

/// A mesh that is known exactly, and where scanners stand in it.
struct Scene
{
  Triangle_mesh mesh;
  std::vector<Point_3> stations; ///< in the order in which they are used
  Point_3 target;                ///< what scanners with a narrow field of view look at
};

/// Hills of 0.3 m over 20 m and of 0.1 m over 7 m: slopes up to 8 degrees, no sharp edge.
struct Hills
{
  Rotation along_x, along_y, diagonal;

  Hills(double x, double y)
    : along_x(Rotation::of_turns(x / 21)), along_y(Rotation::of_turns(y / 19)),
      diagonal(Rotation::of_turns((x + y) / 7))
  {}

  double height() const { return 0.3 * along_x.sine * along_y.cosine + 0.1 * diagonal.sine; }

  /// Of unit length, upwards.
  Vector_3 normal() const
  {
    constexpr double two_pi = 6.28318530717958648;
    const double both = 0.1 * two_pi / 7 * diagonal.cosine;
    return normalized(Vector_3(-0.3 * two_pi / 21 * along_x.cosine * along_y.cosine - both,
                               0.3 * two_pi / 19 * along_x.sine * along_y.sine - both, 1));
  }
};

inline double height_of_ground(double x, double y) { return Hills(x, y).height(); }

inline Point_3 on_ground(double x, double y, double above = 0)
{
  return {x, y, height_of_ground(x, y) + above};
}

/// Part of a street, 60 m by 40 m: houses with flat and gabled roofs, garden walls, a board fence
/// of 2.5 cm, signs, poles from 5 cm to 15 cm, trunks from 20 cm to 50 cm, and two vehicles.
inline Scene make_street()
{
  Scene scene;
  Triangle_mesh& mesh = scene.mesh;
  add_ground(mesh, 30, 20, 1, height_of_ground);

  const double in_ground = -0.8; // solids start here, below the lowest ground next to them
  add_gabled_house(mesh, on_ground(-20, 13, in_ground), Vector_3(9, 11, 6.3), 3, 4);
  add_box(mesh, on_ground(-5, 14, in_ground), Vector_3(12, 9, 7.8), 0);
  add_gabled_house(mesh, on_ground(12, 13, in_ground), Vector_3(8, 10, 5.3), 2.5, 90);
  add_box(mesh, on_ground(24, 12, in_ground), Vector_3(7, 8, 4), -7);
  add_gabled_house(mesh, on_ground(-14, -13, in_ground), Vector_3(9, 10, 5.8), 3.2, 88);
  add_box(mesh, on_ground(3, -14, in_ground), Vector_3(10, 8, 10), 3);
  add_gabled_house(mesh, on_ground(20, -13, in_ground), Vector_3(10, 9, 5.3), 2.8, -3);

  add_box(mesh, on_ground(-12.5, 8, in_ground), Vector_3(6, 0.24, 2.4), 0);
  add_box(mesh, on_ground(18, 8, in_ground), Vector_3(5, 0.12, 2.6), 5);
  add_box(mesh, on_ground(-4.5, -8.5, in_ground), Vector_3(5, 0.1, 2.3), -4);
  add_box(mesh, on_ground(12, -8, in_ground), Vector_3(6, 0.025, 2.4), 2);

  const double poles[][3] = {
    {-9, 5, 0.05}, {6, 5.2, 0.08}, {-3, -5, 0.1}, {14, -5, 0.15}, {9, 5.1, 0.06}};
  for (const auto& [x, y, diameter] : poles)
    add_trunk(mesh, on_ground(x, y, in_ground), on_ground(x, y, diameter < 0.1 ? 3 : 6), diameter,
              diameter);
  add_box(mesh, on_ground(-9, 4.96, 2.2), Vector_3(0.6, 0.02, 0.6), 20);
  add_box(mesh, on_ground(9, 5.05, 2.1), Vector_3(0.8, 0.02, 0.5), -35);

  const double trunks[][3] = {{-14, 5.5, 0.2}, {-6, 6, 0.32}, {3, 6, 0.5},
                              {-10, -6, 0.28}, {6, -6, 0.4},  {21, 5, 0.25}};
  for (const auto& [x, y, diameter] : trunks)
    add_trunk(mesh, on_ground(x, y, in_ground), on_ground(x + 0.3, y - 0.2, 9), diameter,
              diameter / 2);

  add_box(mesh, on_ground(7, 3.2, 0.25), Vector_3(4.3, 1.75, 0.75), 2);
  add_box(mesh, on_ground(6.8, 3.2, 1), Vector_3(2.2, 1.55, 0.55), 2);
  add_box(mesh, on_ground(-8, -3.4, 0.3), Vector_3(5, 1.9, 2), -3);

  scene.stations = {on_ground(0, 0, 1.9), on_ground(14, 0.5, 1.9), on_ground(-15, -0.5, 1.9),
                    on_ground(1, -7, 1.9)};
  scene.target = on_ground(0, 14, 2);
  return scene;
}

/// 14 m by 14 m of forest: ground and 32 trunks, some of them leaning, 5 to 50 cm in diameter and
/// 4 to 12 m high.
inline Scene make_forest()
{
  Scene scene;
  add_ground(scene.mesh, 7, 7, 0.5, height_of_ground);
  Counter_random random(1, 0, 0);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) {
      const double x = 2.2 * (i - 2.5) + 1.2 * (random.uniform() - 0.5);
      const double y = 2.2 * (j - 2.5) + 1.2 * (random.uniform() - 0.5);
      const double share = random.uniform();
      const double diameter = 0.05 + 0.45 * share * share; // thin ones are more frequent
      const double height = 4 + 8 * (diameter / 0.5);
      const double lean_x = 0.04 * height * random.normal();
      const double lean_y = 0.04 * height * random.normal();
      const bool is_glade = (i == 2 || i == 3) && (j == 2 || j == 3); // the scanners stand here
      if (!is_glade)
        add_trunk(scene.mesh, on_ground(x, y, -0.5), on_ground(x + lean_x, y + lean_y, height),
                  diameter, diameter / 3);
    }
  scene.stations = {on_ground(0, 0, 1.6), on_ground(-1.1, 1, 1.6), on_ground(1.2, 1.1, 1.6),
                    on_ground(0.3, -1.3, 1.6)};
  scene.target = on_ground(0, 6, 2);
  return scene;
}

/// A table with boxes, a can, a book on its edge and a thin board, in front of a wall.
inline Scene make_room()
{
  Scene scene;
  Triangle_mesh& mesh = scene.mesh;
  add_ground(mesh, 2, 2, 0.5, [](double, double) { return 0.; });
  add_box(mesh, {0, 1.1, -0.1}, Vector_3(4, 0.1, 2.6));
  add_box(mesh, {0, 0, 0.72}, Vector_3(1.2, 0.8, 0.03));
  for (int i = 0; i < 4; ++i)
    add_box(mesh, {i % 2 ? 0.55 : -0.55, i / 2 ? 0.35 : -0.35, -0.05}, Vector_3(0.05, 0.05, 0.77));
  const double top = 0.75;
  add_box(mesh, {-0.35, 0.1, top}, Vector_3(0.22, 0.16, 0.12), 25);
  add_box(mesh, {-0.05, 0.22, top}, Vector_3(0.3, 0.12, 0.2), -10);
  add_box(mesh, {0.3, -0.12, top}, Vector_3(0.12, 0.2, 0.06), 40);
  add_box(mesh, {0.35, 0.22, top}, Vector_3(0.18, 0.025, 0.24), 30); // the book
  add_box(mesh, {-0.2, -0.2, top}, Vector_3(0.16, 0.006, 0.1), -20); // the board
  add_box(mesh, {-0.35, 0.1, top + 0.12}, Vector_3(0.1, 0.1, 0.05), 60);
  add_trunk(mesh, {0.1, -0.05, top}, {0.1, -0.05, top + 0.11}, 0.07, 0.07);
  add_trunk(mesh, {0.48, -0.28, top}, {0.48, -0.28, top + 0.3}, 0.02, 0.02);
  scene.stations = {{0, -1, 1.35}, {-0.8, -0.7, 1.4}, {0.8, -0.7, 1.4}, {0, -0.8, 1.8}};
  scene.target = {0, 0.1, 0.78};
  return scene;
}

/// A mesh and stations around it, at three heights, 1.5 diagonals from its center.
inline Scene make_object(const std::string& path)
{
  Scene scene;
  scene.mesh = read_triangle_mesh(path);
  const CGAL::Bbox_3 box = bounding_box(scene.mesh);
  scene.target = CGAL::midpoint(Point_3(box.xmin(), box.ymin(), box.zmin()),
                                Point_3(box.xmax(), box.ymax(), box.zmax()));
  constexpr int number_of_stations = 12;
  for (int i = 0; i < number_of_stations; ++i) {
    const Rotation around = Rotation::of_turns(0.07 + double(i) * 5 / number_of_stations);
    const Rotation above = Rotation::of_degrees((i % 3 - 1) * 40 + 7);
    const Vector_3 direction(above.cosine * around.cosine, above.cosine * around.sine, above.sine);
    scene.stations.push_back(scene.target + 1.5 * diagonal(box) * direction);
  }
  return scene;
}

/// \param name "street", "forest", "room", or an OFF file
/// \throws std::runtime_error as `read_triangle_mesh()` does
inline Scene make_scene(const std::string& name)
{
  if (name == "street")
    return make_street();
  if (name == "forest")
    return make_forest();
  return name == "room" ? make_room() : make_object(name);
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SCENES_H
