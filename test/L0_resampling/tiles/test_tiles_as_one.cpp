// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A cloud that is resampled tile by tile gives the bits of a call for all of it.

#include "tiles/tiles_as_one.h"

#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace test;
namespace internal = CGAL::L0_resampling::internal;

/// Samples that may differ, by the halo.
struct Largest_shares
{
  double with_wide_halo, with_practical_halo;
};

/// What decides whether all points are looked at for the facts is an upper bound.
void check_memory_of_facts(const std::vector<Place>& points, std::size_t number_of_samples)
{
  using Tag = CGAL::Parallel_if_available_tag;
  internal::Memory_counter memory;
  internal::Buffer<Vector> buffer(&memory);
  buffer.reserve(points.size());
  for (const Place& p : points)
    buffer.push_back(Vector(p.data()));
  CGAL::L0_resampling::Report report;
  internal::Progress progress(nullptr, report, memory);
  CGAL::L0_resampling::Block_chebyshev_solver_traits<float, Tag> solver;
  internal::Any_solver<float> any_solver(solver);
  const internal::Parameters parameters = internal::checked_parameters(
    CGAL::parameters::number_of_output_points(number_of_samples), points.size());
  internal::Buffer<internal::Point_in_cloud> points_in_cloud;
  CHECK(internal::facts_of_points<Tag>(buffer, parameters, any_solver, progress, report,
                                       points_in_cloud)
          .area
        > 0.);
  const std::size_t bytes = memory.peak() + points_in_cloud.size() * sizeof points_in_cloud[0];
  const std::size_t bound = Tiles<Tag>::bytes_per_point_of_facts * points.size()
                            + Tiles<Tag>::bytes_per_sample_of_facts * number_of_samples;
  if (!CHECK(bytes <= bound))
    std::cerr << "  " << bytes << " bytes for " << points.size() << " points and "
              << number_of_samples << " samples" << std::endl;
}

/// \param shares of the points that a tile and its halo have at most, one for each way to cut the
/// cloud into several
/// \param largest which share of the samples may differ
template <typename ConcurrencyTag, typename NamedParameters>
void check(const std::string& name, const std::vector<Place>& points,
           const std::vector<double>& shares, const Largest_shares& largest,
           std::size_t number_of_samples, const NamedParameters& np)
{
  const std::size_t n = points.size();
  const std::vector<Sample> expected = in_memory<CGAL::Parallel_if_available_tag>(points, np);
  CHECK(expected.size() == number_of_samples);
  const double wide_halo = 80, practical_halo = Tiles<ConcurrencyTag>::halo_in_radii;
  std::size_t number_of_tiles = 0;
  const auto differences = [&](double share, double halo) {
    const std::vector<Sample> found =
      by_tiles<ConcurrencyTag>(points, std::size_t(share * double(n)), halo, number_of_tiles, np);
    CHECK(found.size() == number_of_samples);
    const std::size_t number = number_of_different(found, expected);
    // what a number of single precision does not hold, as samples are about one apart
    CHECK(maximum_difference(expected, found) < 1e-6);
    std::cout << name << ": " << number_of_tiles << " tiles with halos of " << halo
              << " radii, samples that differ: " << number << " of " << number_of_samples
              << std::endl;
    return double(number) / double(number_of_samples);
  };
  CHECK(differences(2, practical_halo) == 0 && number_of_tiles == 1);
  for (const double share : shares)
  {
    CHECK(differences(share, wide_halo) <= largest.with_wide_halo);
    CHECK(number_of_tiles >= 2);
    CHECK(differences(share, practical_halo) <= largest.with_practical_halo);
    CHECK(number_of_tiles >= 2);
  }
}

/// The same where memory holds neither all points nor what is known of them.
void check_little_memory(const Scene& scene)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const std::vector<Place>& points = scene.points();
  const auto np = CGAL::parameters::number_of_output_points(number_of_samples(scene, 0.4));
  std::size_t number_of_tiles = 0;
  const std::vector<Sample> found = by_tiles<Tag>(points, points.size() / 2, 50, number_of_tiles,
                                                  np, false);
  CHECK(number_of_tiles >= 3);
  const std::size_t different = number_of_different(found, in_memory<Tag>(points, np));
  std::cout << "little memory: " << number_of_tiles
            << " tiles with halos of 50 radii, samples that differ: " << different << std::endl;
  CHECK(different == 0);
}

/// All points of a line have one radius, but not that of the cloud: tiles go by it too.
void check_line()
{
  using Tag = CGAL::Parallel_if_available_tag;
  const std::size_t n = 60000, m = 20000;
  std::vector<Place> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({0.25 * double(i), 0, 0});
  const auto np = CGAL::parameters::number_of_output_points(m);
  std::size_t number_of_tiles = 0;
  CHECK(number_of_different(by_tiles<Tag>(points, 2 * n, 20, number_of_tiles, np),
                            in_memory<Tag>(points, np))
        == 0);
  CHECK(number_of_tiles == 1);
  CHECK(by_tiles<Tag>(points, n / 2, 5, number_of_tiles, np).size() == m);
  CHECK(number_of_tiles >= 2);
}

/// Blocks of cells with too many points are thinned: where, depends on no tile.
void check_thinned_blocks()
{
  using Tag = CGAL::Parallel_if_available_tag;
  const Scene strips = scene_of_strips(600);
  const std::size_t m = number_of_samples(strips, 0.5), n = strips.points().size();
  const auto np = CGAL::parameters::neighbor_radius(4).number_of_output_points(m);
  const std::vector<Sample> expected = in_memory<Tag>(strips.points(), np);
  std::size_t before = 0;
  for (const double share : {2., 0.9, 0.6})
  {
    std::size_t number_of_tiles = 0;
    const std::vector<Sample> found = by_tiles<Tag>(strips.points(), std::size_t(share * double(n)),
                                                    Tiles<Tag>::halo_in_radii, number_of_tiles, np);
    std::cout << "thinned blocks: " << number_of_tiles << " tiles" << std::endl;
    CHECK(number_of_tiles > before);
    CHECK(number_of_different(found, expected) == 0);
    before = number_of_tiles;
  }
}

/// Followers of a sample that another tile keeps get its side, though their tile found it with the
/// other one, and hardly elsewhere.
void check_leaders_elsewhere()
{
  using Tag = CGAL::Parallel_if_available_tag;
  const Scene scene(300);
  const Points_in_memory source{scene.points()};
  CGAL::L0_resampling::Tile_counts counts;
  for (const Place& p : scene.points())
    counts.add(p);
  Tiles<Tag> tiles(std::move(counts), CGAL::parameters::number_of_output_points(3000));
  tiles.find_facts(source, std::uint64_t(1) << 40);
  tiles.make_tiles(std::uint64_t(1) << 40);
  tiles.choose_how_to_orient(std::uint64_t(1) << 40);
  CHECK(tiles.orients_at_once());
  std::vector<CGAL::L0_resampling::Unoriented_samples> unoriented = {
    tiles.resample_tile(0, source).unoriented, {}};
  const std::vector<CGAL::L0_resampling::Tile_sample>& own = unoriented[0].own;
  CHECK(own.size() == 3000 && unoriented[0].leaders_elsewhere.empty());
  for (std::size_t i = 0; i < own.size(); i += 100)
  {
    CGAL::L0_resampling::Tile_sample leader = own[i];
    leader.position[2] += 1e-6;
    for (float& coordinate : leader.normal)
      coordinate = i % 200 == 0 ? coordinate : -coordinate;
    unoriented[1].leaders_elsewhere.push_back(leader);
  }
  CGAL::L0_resampling::Report report;
  const std::vector<std::vector<signed char>> signs = tiles.sides(unoriented, report);
  // each begins with that of samples whose sides are known
  CHECK(signs[0].size() == 1 + own.size() && signs[1].size() == 1 + own.size() / 100);
  CHECK(signs[0][0] == 1 && signs[1][0] == 1);
  for (std::size_t k = 0; k < own.size() / 100; ++k)
    CHECK(signs[1][1 + k] == (k % 2 == 0 ? 1 : -1) * signs[0][1 + 100 * k]);
}

/// \param argv the length of the scenes: with 50000 they have a million points and more, and are
/// cut into up to 64 tiles and more, which takes minutes
int main(int argc, char** argv)
{
  using CGAL::parameters::keep_density;
  const bool are_large = argc > 1;
  const auto& [even, uneven, crowds, sheets] = Scenes(are_large ? std::atof(argv[1]) : 1500);
  const auto shares = [&](double of_small_scenes) {
    return are_large ? std::vector<double>{0.3, 0.07} : std::vector<double>{of_small_scenes};
  };
  std::size_t m = number_of_samples(even, 0.5);
  const auto check_even = [&, &scene = even](auto tag) {
    check<decltype(tag)>("even", scene.points(), shares(0.5), {0, 0.001}, m,
                         CGAL::parameters::number_of_output_points(m));
  };
  if (are_large)
    check_even(CGAL::Parallel_if_available_tag());
  else
    check_even(CGAL::Sequential_tag());
  // where radii are larger, the halo is narrower for them
  m = number_of_samples(uneven, 0.4);
  check<CGAL::Parallel_if_available_tag>("uneven", uneven.points(), shares(0.7), {0, 0.08}, m,
                                         CGAL::parameters::number_of_output_points(m));
  check<CGAL::Parallel_if_available_tag>("uneven, as dense as the input", uneven.points(),
                                         shares(0.7), {0, 0.08}, m,
                                         keep_density(true).number_of_output_points(m));
  check<CGAL::Parallel_if_available_tag>("a known noise", uneven.points(), shares(0.7), {0, 0.08},
                                         m,
                                         CGAL::parameters::noise(0.01).number_of_output_points(m));
  m = number_of_samples(crowds, 1.3); // a lone point is the start of several samples
  check<CGAL::Parallel_if_available_tag>("crowds and outliers", crowds.points(), shares(0.5),
                                         {0, 0.001}, m,
                                         CGAL::parameters::number_of_output_points(m));
  check<CGAL::Parallel_if_available_tag>(
    "more outliers", crowds.points(), shares(0.5), {0, 0.001}, m,
    CGAL::parameters::outlier_sensitivity(2).number_of_output_points(m));
  m = number_of_samples(sheets, 0.3);
  check<CGAL::Parallel_if_available_tag>("two sheets", sheets.points(), shares(0.5), {0, 0.001}, m,
                                         CGAL::parameters::number_of_output_points(m));
  check_little_memory(uneven);
  check_line();
  check_thinned_blocks();
  check_leaders_elsewhere();
  for (const Scene* scene : {&even, &uneven, &crowds})
    for (const double share : {0.01, 2.})
      check_memory_of_facts(scene->points(), number_of_samples(*scene, share));
  return test::result();
}
