// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/search/Neighborhoods.h>

#include <algorithm>
#include <functional>

using namespace test;

using Lists = std::vector<std::vector<std::uint32_t>>;

/// The lists, which are the same for any number of threads.
Lists self_neighbors(const Gridded_points& samples, double radius)
{
  Unwatched unwatched;
  const Neighborhoods n = find_self_neighbors<CGAL::Sequential_tag>(samples.grid, samples.points,
                                                                    radius, unwatched.progress);
  const Neighborhoods parallel = find_self_neighbors<CGAL::Parallel_if_available_tag>(
    samples.grid, samples.points, radius, unwatched.progress);
  CHECK(n.offsets == parallel.offsets && n.indices == parallel.indices);
  CHECK(n.offsets.size() == samples.points.size() + 1 && n.offsets.front() == 0
        && n.offsets.back() == n.indices.size());
  CHECK(n.view().size == samples.points.size());
  Lists lists;
  for (std::size_t i = 0; i < samples.points.size(); ++i)
    lists.emplace_back(n.indices.begin() + std::ptrdiff_t(n.offsets[i]),
                       n.indices.begin() + std::ptrdiff_t(n.offsets[i + 1]));
  return lists;
}

/// The lists hold the samples in the ball but for the one itself, ascending.
void check_self_neighbors(const std::vector<Vector>& points, double cell_size, double radius)
{
  const Gridded_points samples(points, cell_size);
  Lists expected = brute_force_neighbors(samples.vector, samples.vector, radius);
  for (std::size_t i = 0; i < expected.size(); ++i)
    expected[i].erase(std::remove(expected[i].begin(), expected[i].end(), i), expected[i].end());
  CHECK(self_neighbors(samples, radius) == expected);
}

/// Lists that are too long for the package are thinned: bounded, still symmetric and ascending, and
/// of true neighbors only. A sample whose surroundings are not crowded keeps all.
void check_thinning(Generator& generator)
{
  std::vector<Vector> points;
  const auto fill_cell = [&](double x, int n) {
    for (; n > 0; --n)
    {
      const Vector in_cell = 0.5 * (Vector::Ones() + Vector(random_unit_vector(generator)));
      points.push_back(in_cell + x * Vector::UnitX());
    }
  };
  fill_cell(0, 5000); // crowded
  fill_cell(1, 300);  // beside the crowd
  fill_cell(2, 300);  // beside that, and undisturbed
  const Gridded_points samples(points, 1);
  const Lists lists = self_neighbors(samples, 0.9);
  const Lists all = brute_force_neighbors(samples.vector, samples.vector, 0.9);
  bool are_true = true, are_ascending = true, are_symmetric = true, are_complete = true;
  std::size_t longest = 0;
  for (std::uint32_t i = 0; i < lists.size(); ++i)
  {
    are_true = are_true
               && std::includes(all[i].begin(), all[i].end(), lists[i].begin(), lists[i].end());
    are_ascending = are_ascending
                    && std::adjacent_find(lists[i].begin(), lists[i].end(), std::greater_equal<>())
                         == lists[i].end();
    for (std::uint32_t k : lists[i])
      are_symmetric = are_symmetric && k != i
                      && std::binary_search(lists[k].begin(), lists[k].end(), i);
    if (samples.vector[i][0] >= 2)
      for (std::uint32_t k : all[i])
        if (samples.vector[k][0] >= 2)
          are_complete = are_complete
                         && (k == i || std::binary_search(lists[i].begin(), lists[i].end(), k));
    longest = (std::max)(longest, lists[i].size());
  }
  CHECK(are_true);
  CHECK(are_ascending);
  CHECK(are_symmetric);
  CHECK(are_complete);
  CHECK(longest > 300
        && longest <= 1024 + 4); // one more at most for each of the cells, and one for rounding

  // nor do samples far away change what is left out
  for (std::uint32_t number = 1; number <= 3; ++number)
  {
    points.push_back(Vector(number, 0, -100)); // the first ones in the order of the grid
    Lists of_more = self_neighbors(Gridded_points(points, 1), 0.9);
    of_more.erase(of_more.begin(), of_more.begin() + number);
    for (auto& list : of_more)
      for (std::uint32_t& index : list)
        index -= number;
    CHECK(of_more == lists);
  }
}

int main()
{
  Generator generator(13);
  std::vector<Vector> cloud = cube_points(1500, 3, generator).points;
  add_gaussian_noise(cloud, 0.1, generator);
  check_self_neighbors(cloud, 0.5, 0.5);
  check_self_neighbors(cloud, 0.7, 0.5);

  const std::vector<Vector> lattice =
    lattice_points(8, 0.25); // distances equal to the radius, exactly: outside
  for (double radius : {0.25, 0.5, 0.75})
    check_self_neighbors(lattice, radius, radius);
  for (double cell_size : {0.25, 0.1})
    check_self_neighbors(border_points(cell_size, generator), cell_size * (1 + 1e-12), cell_size);
  check_self_neighbors(far_points(generator), 1, 1);

  std::vector<Vector> duplicates;
  for (int n = 0; n < 20; ++n)
    duplicates.insert(duplicates.end(), 30, random_unit_vector(generator));
  check_self_neighbors(duplicates, 0.5, 0.5);
  check_self_neighbors({Vector(1, 2, 3)}, 1, 1);
  check_thinning(generator);
  return result();
}
