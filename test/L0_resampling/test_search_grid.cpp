// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/ball_queries.h>

#include <algorithm>
#include <tuple>

using namespace test;

using Lists = std::vector<std::vector<std::uint32_t>>;

/// The balls around the queries as a stage finds them: by the distances of the candidates of the
/// cell.
template <typename T>
Lists balls_by_grid(const Gridded_points& queries, const Gridded_points& points, double radius)
{
  Lists balls(queries.points.size());
  std::vector<int> number_of_visits(queries.points.size(), 0);
  bool is_padding_outside = true, is_origin_near = true;
  Unwatched unwatched;
  const auto make_visitor = [&]() {
    return
      [&](Search_grid_3::Range range, const Local_points<T>& candidates, const Vector& origin) {
        for (Index i = range.first; i < range.second; ++i)
        {
          ++number_of_visits[i];
          const Eigen::Matrix<T, 3, 1> center = (queries.points[i] - origin).cast<T>();
          const T half_cell = T(0.5 * queries.grid.cell_size() * (1 + 1e-6));
          is_origin_near = is_origin_near && center.cwiseAbs().maxCoeff() <= half_cell;
          for (std::size_t k = 0; k < candidates.padded_size(); ++k)
          {
            const Eigen::Matrix<T, 3, 1> p(candidates.x[k], candidates.y[k], candidates.z[k]);
            if ((p - center).squaredNorm() >= T(radius * radius))
              continue;
            if (k < candidates.indices.size())
              balls[i].push_back(candidates.indices[k]);
            else
              is_padding_outside = false;
          }
        }
      };
  };
  for_each_cell<T, CGAL::Sequential_tag>(queries.grid, queries.points, points.grid, points.points,
                                         cells_in_reach(radius, points.grid.cell_size()),
                                         unwatched.progress, make_visitor);
  CHECK(is_padding_outside);
  CHECK(is_origin_near); // else `float` would not resolve the local coordinates
  CHECK(
    std::all_of(number_of_visits.begin(), number_of_visits.end(), [](int n) { return n == 1; }));
  return balls;
}

/// A grid gives what comparing everybody with everybody gives, by increasing index.
void check_balls(const std::vector<Vector>& query_points, const std::vector<Vector>& points,
                 double cell_size, double radius)
{
  const Gridded_points q(query_points, cell_size), p(points, cell_size);
  CHECK(balls_by_grid<double>(q, p, radius) == brute_force_neighbors(q.vector, p.vector, radius));
}

/// A crowd in one cell is thinned: its members see as many as the package allows, and not many
/// fewer.
void check_thinning(Generator& generator)
{
  const std::size_t limit = Local_points<float>::maximum_number_of_candidates;
  std::vector<Vector> crowd(20000, Vector(0.5, 0.5, 0.5));
  for (Vector& p : crowd)
    p += 0.1 * random_unit_vector(generator);
  const Gridded_points crowded(crowd, 1);
  for (const auto& ball : balls_by_grid<float>(crowded, crowded, 1))
    if (!CHECK(ball.size() > limit / 2 - 1 && ball.size() <= limit + 10))
      break;
}

/// The order of the points, within a cell that of their coordinates, depends on where they are and
/// not on the order they came in.
void check_order(std::vector<Vector> points, double cell_size, Generator& generator)
{
  const Gridded_points gridded(points, cell_size);
  const std::vector<Vector>& sorted = gridded.vector;
  for (std::size_t cell = 0; cell < gridded.grid.number_of_cells(); ++cell)
  {
    const auto [first, last] = gridded.grid.points_of_cell(cell);
    CHECK(std::is_sorted(
      sorted.begin() + first, sorted.begin() + last, [](const Vector& p, const Vector& q) {
        return std::make_tuple(p[0], p[1], p[2]) < std::make_tuple(q[0], q[1], q[2]);
      }));
  }
  for (int n = 0; n < 3; ++n)
  {
    std::shuffle(points.begin(), points.end(), generator);
    CHECK(Gridded_points(points, cell_size).vector == sorted);
    CHECK(Search_grid_3::sorted_order<CGAL::Sequential_tag>(to_buffer(points), cell_size)
          == Search_grid_3::sorted_order<CGAL::Parallel_if_available_tag>(to_buffer(points),
                                                                          cell_size));
  }
}

int main()
{
  Generator generator(1);
  std::vector<Vector> cloud = cube_points(1500, 3, generator).points;
  add_gaussian_noise(cloud, 0.1, generator);
  const std::vector<Vector> queries = sphere_points(200, 1.7, generator).points;
  for (double cell_size : {1., 0.5, 0.4, 0.3}) // balls that reach 1, 2, 3 and 4 cells
  {
    check_balls(cloud, cloud, cell_size, 1);
    check_balls(queries, cloud, cell_size, 1);
  }

  const std::vector<Vector> lattice =
    lattice_points(8, 0.25); // distances equal to the radius, exactly: outside
  for (double radius : {0.25, 0.5, 0.75})
    check_balls(lattice, lattice, 0.25, radius);
  for (double cell_size : {0.25, 0.1})
  {
    const std::vector<Vector> border = border_points(cell_size, generator);
    check_balls(border, border, cell_size,
                cell_size * (1 - 1e-12)); // local coordinates round the last bits
  }

  const std::vector<Vector> far = far_points(generator);
  for (double radius : {0.7, 1., 3.})
    check_balls(far, far, 1, radius);

  std::vector<Vector> duplicates;
  for (int n = 0; n < 20; ++n)
    duplicates.insert(duplicates.end(), 30, random_unit_vector(generator));
  check_balls(duplicates, duplicates, 0.5, 0.5);
  check_balls({Vector(1, 2, 3)}, {Vector(1, 2, 3)}, 1, 1);

  check_thinning(generator);
  check_order(cloud, 0.5, generator);
  check_order(duplicates, 0.5, generator);
  check_order(lattice, 0.6, generator);
  check_order(far, 1, generator);
  check_order({Vector(1e300, -1e300, 0), Vector(-1e20, 1e20, 1e300), Vector(0, 0, 1)}, 1e-3,
              generator); // cells beyond all integers
  return result();
}
