// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Crowds of points are thinned, and nothing else is; samples that are left out follow their
// leaders.

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/Duplicate_samples.h>
#include <CGAL/L0_resampling/internal/search/thin_crowds.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

using namespace test;

namespace {

constexpr Index limit = 32;

std::array<long long, 3> subcell_of_point(const Vector& p, double cell_size)
{
  const auto place = [&](int axis) { return std::llround(std::floor(8 * (p[axis] / cell_size))); };
  return {place(0), place(1), place(2)};
}

/// Two crowds of 5000 points, one of them at one place, and 3000 points of a plane around them.
std::vector<Vector> crowded_plane(Generator& generator)
{
  std::vector<Vector> points;
  for (int i = 0; i < 3000; ++i)
    points.push_back(Vector(0, 0, 0.01) + random_vector(Vector(3, 3, 0), generator));
  for (int i = 0; i < 5000; ++i)
  {
    points.push_back(Vector(0.5, 0.5, 0.01));
    points.push_back(Vector(-1.2, -0.7, 0.01) + 1e-9 * random_unit_vector(generator));
  }
  return points;
}

void check_thinning(const std::vector<Vector>& unsorted, double cell_size)
{
  const Gridded_points points(unsorted, cell_size);
  const Representatives r = thin_crowds<CGAL::Sequential_tag>(points.grid, points.points, limit);
  CHECK(thin_crowds<CGAL::Parallel_if_available_tag>(points.grid, points.points, limit).of_points
        == r.of_points);

  std::map<std::array<long long, 3>, std::vector<std::size_t>> subcells;
  for (std::size_t i = 0; i < points.vector.size(); ++i)
    subcells[subcell_of_point(points.vector[i], cell_size)].push_back(i);
  bool is_any_crowded = false;
  for (const auto& subcell : subcells)
    is_any_crowded = is_any_crowded || subcell.second.size() > limit;
  CHECK(r.are_all_points() == !is_any_crowded);
  if (r.are_all_points())
    return;
  for (const auto& subcell : subcells)
  {
    const std::vector<std::size_t>& members = subcell.second;
    const std::size_t maximum_gap = (members.size() + limit - 1) / limit;
    std::size_t number_of_kept = 0, last_kept = 0;
    bool is_right = r.is_kept(members.front());
    for (std::size_t rank = 0; rank < members.size(); ++rank)
    {
      if (r.is_kept(members[rank]))
      {
        ++number_of_kept;
        last_kept = rank;
      }
      is_right = is_right && r.of_points[members[rank]] == members[last_kept]
                 && rank - last_kept < maximum_gap;
    }
    CHECK(is_right);
    CHECK(number_of_kept == (std::min)(members.size(), std::size_t(limit)));
  }

  Buffer<Vector> kept = points.points;
  r.keep(kept);
  std::size_t place = 0;
  for (std::size_t i = 0; i < points.vector.size(); ++i)
    if (r.is_kept(i))
      CHECK(kept[place++] == points.vector[i]);
  CHECK(place == kept.size());
  std::size_t total = 0;
  for (Index number : r.numbers_of_points())
    total += number;
  CHECK(total == points.vector.size());
}

void test_thinning()
{
  Generator generator(1);
  const std::vector<Vector> plane = crowded_plane(generator);
  for (double cell_size : {0.25, 1., 7.})
    check_thinning(plane, cell_size);
  check_thinning(cube_points(5000, 3, generator).points, 0.5);
  check_thinning({Vector(1, 2, 3)}, 1);
}

/// The outermost cells of a grid have no size: points in them may be anywhere.
void test_outermost_cells()
{
  const std::vector<Vector> far_away(1000, Vector(1e9, 0, 0));
  const Gridded_points points(far_away, 1);
  CHECK(thin_crowds<CGAL::Sequential_tag>(points.grid, points.points, limit).are_all_points());
}

void test_followers()
{
  Duplicate_samples followers{Counting_allocator<Vector>()};
  followers.leaders = to_buffer<Index>({1, 1, 0});
  followers.offsets = to_buffer<Vector>({Vector(0, 0, 1), Vector(0, 0, 2), Vector(5, 0, 0)});
  // the samples changed places since the start, and moved
  const Buffer<Index> start_indices = to_buffer<Index>({1, 0});
  Buffer<Vector> positions = to_buffer<Vector>({Vector(10, 0, 0), Vector(0, 20, 0)});
  Buffer<double> values = to_buffer<double>({7, 8}), none;
  followers.append_values(start_indices, values);
  followers.append_values(start_indices, none);
  followers.append_positions(start_indices, positions);
  CHECK(values == to_buffer<double>({7, 8, 7, 7, 8}));
  CHECK(none.empty());
  CHECK(positions
        == to_buffer<Vector>({Vector(10, 0, 0), Vector(0, 20, 0), Vector(10, 0, 1),
                              Vector(10, 0, 2), Vector(5, 20, 0)}));
}

} // namespace

int main()
{
  test_thinning();
  test_outermost_cells();
  test_followers();
  return test::result();
}
