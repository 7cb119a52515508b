// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

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

/// A crowd is thinned: its members see as many as the package allows, and not many fewer.
/// \param center of the crowd, whose cells are of size 1
void check_thinning(const Vector& center, Generator& generator)
{
  const std::size_t limit = maximum_number_of_candidates;
  std::vector<Vector> crowd(4 * limit + 3, center);
  for (Vector& p : crowd)
    p += 0.1 * random_unit_vector(generator);
  const Gridded_points crowded(crowd, 1);
  for (const auto& ball : balls_by_grid<float>(crowded, crowded, 1))
    if (!CHECK(ball.size() > limit / 2 - 1 && ball.size() <= limit + 1))
      break;
}

/// Which points of a crowd are left out does not depend on points far away, whether the crowd is in
/// one row of cells or in many.
void check_thinning_is_local(Generator& generator)
{
  std::vector<Vector> points;
  for (int n = 0; n < 6000; ++n)
    points.push_back(random_vector(Vector(1, 1, 0.2), generator));
  const Gridded_points crowd(points, 1);
  const Lists expected = balls_by_grid<float>(crowd, crowd, 0.2);
  for (std::uint32_t number = 1; number <= 3; ++number)
  {
    points.push_back(Vector(number, 0, -100)); // the first ones in the order of the grid
    const Gridded_points more(points, 1);
    Lists balls = balls_by_grid<float>(more, more, 0.2);
    balls.erase(balls.begin(), balls.begin() + number);
    for (auto& ball : balls)
      for (std::uint32_t& index : ball)
        index -= number;
    CHECK(balls == expected);
  }
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

/// Balls whose radii follow the scales of their centers, in cells of several levels, hold what
/// comparing everybody with everybody finds.
/// \param scale_at of a place
template <typename Scale_at>
void check_levels(const std::vector<Vector>& points, double radius, const Scale_at& scale_at)
{
  Buffer<float> scales;
  for (const Vector& p : points)
    scales.push_back(scale_at(p));
  const Sorted_queries sorted(CGAL::Sequential_tag(), to_buffer(points), Cell_sizes(1, scales));
  const std::size_t n = points.size();
  Lists balls(n), naive(n);
  std::size_t number_at_other_levels = 0;
  Unwatched unwatched;
  const auto squared_radius = [&](std::size_t i) { return square(radius * sorted.scales[i]); };
  for_each_cell<double, CGAL::Parallel_if_available_tag>(
    sorted.grid, sorted.points, sorted.grid, sorted.points, cells_in_reach(radius, 1),
    unwatched.progress, [&]() {
      return [&](Search_grid_3::Range range, const Local_points<double>& candidates,
                 const Vector& origin) {
        for (Index i = range.first; i < range.second; ++i)
          for (std::size_t k = 0; k < candidates.indices.size(); ++k)
            if ((Vector(candidates.x[k], candidates.y[k], candidates.z[k]) + origin
                 - sorted.points[i])
                  .squaredNorm()
                < squared_radius(i))
              balls[i].push_back(candidates.indices[k]);
      };
    });
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t k = 0; k < n; ++k)
      if ((sorted.points[k] - sorted.points[i]).squaredNorm() < squared_radius(i))
      {
        naive[i].push_back(std::uint32_t(k));
        number_at_other_levels += level_of_scale(sorted.scales[i])
                                  != level_of_scale(sorted.scales[k]);
      }
    std::sort(balls[i].begin(), balls[i].end());
  }
  CHECK(!sorted.grid.has_one_scale());
  CHECK(number_at_other_levels > n / 20);
  CHECK(balls == naive);
}

/// A level is the smallest whose cells are as large as the scale.
void check_sizes()
{
  CHECK(level_of_scale(1) == level_of_one && size_of_cells(level_of_one) == 1);
  for (double scale = minimum_scale; scale <= double(maximum_scale); scale *= 1.01)
  {
    const int level = level_of_scale(scale);
    CHECK(level < number_of_levels && size_of_cells(level) >= scale);
    CHECK(level == 0 || size_of_cells(level - 1) < scale);
  }
}

/// Cells begin where blocks of points do that threads look at, and elsewhere.
template <typename ConcurrencyTag>
void check_cells_of_many_points(std::size_t points_per_cell)
{
  const std::size_t number_of_cells = 40000, cells_per_row = 100;
  Buffer<Vector> points;
  for (std::size_t cell = 0; cell < number_of_cells; ++cell)
    for (std::size_t k = 0; k < points_per_cell; ++k)
      points.push_back(
        {double(cell % cells_per_row) + 0.5, double(cell / cells_per_row) + 0.5, 0.5});
  const Search_grid_3 grid(ConcurrencyTag(), points, 1.);
  CHECK(grid.number_of_points() == points.size());
  CHECK(grid.number_of_cells() == number_of_cells);
  CHECK(grid.number_of_rows() == number_of_cells / cells_per_row);
  bool are_ranges_right = grid.number_of_cells() == number_of_cells;
  for (std::size_t cell = 0; are_ranges_right && cell < number_of_cells; ++cell)
    are_ranges_right = grid.points_of_cell(cell)
                       == Search_grid_3::Range(Index(cell * points_per_cell),
                                               Index((cell + 1) * points_per_cell));
  CHECK(are_ranges_right);
}

int main()
{
  Generator generator(1);
  check_sizes();
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

  const auto rising = [](const Vector& p) { return float(0.3 + 0.1 * std::abs(p[0])); };
  const std::vector<Vector> wide = cube_points(1500, 12, generator).points;
  for (double radius : {0.9, 1.7, 3.})
    check_levels(wide, radius, rising);

  const std::vector<Vector> far = far_points(generator);
  for (double radius : {0.7, 1., 3.})
    check_balls(far, far, 1, radius);

  std::vector<Vector> duplicates;
  for (int n = 0; n < 20; ++n)
    duplicates.insert(duplicates.end(), 30, random_unit_vector(generator));
  check_balls(duplicates, duplicates, 0.5, 0.5);
  check_balls({Vector(1, 2, 3)}, {Vector(1, 2, 3)}, 1, 1);

  check_thinning({0.5, 0.5, 0.5}, generator);
  check_thinning({0, 0, 0}, generator); // in four rows of cells
  check_thinning_is_local(generator);
  check_order(cloud, 0.5, generator);
  check_order(duplicates, 0.5, generator);
  check_order(lattice, 0.6, generator);
  check_order(far, 1, generator);
  check_order({Vector(1e300, -1e300, 0), Vector(-1e20, 1e20, 1e300), Vector(0, 0, 1)}, 1e-3,
              generator); // cells beyond all integers
  for (const std::size_t points_per_cell : {1u, 3u, 4u})
  {
    check_cells_of_many_points<CGAL::Sequential_tag>(points_per_cell);
    check_cells_of_many_points<CGAL::Parallel_if_available_tag>(points_per_cell);
  }
  return result();
}
