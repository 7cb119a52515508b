// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The facts of a cloud that is not in memory are those of a call for all of it in memory, and so is
// what its tiles find of each point.

#include "tiles/tiles_as_one.h"

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace test;
namespace internal = CGAL::L0_resampling::internal;
using Tag = CGAL::Parallel_if_available_tag;

void check_same(const internal::Facts_of_cloud& found, const internal::Facts_of_cloud& expected)
{
  CHECK(found.frame->exponent == expected.frame->exponent);
  CHECK(found.frame->origin == expected.frame->origin);
  CHECK(found.extents->number_of_points == expected.extents->number_of_points);
  CHECK(found.extents->box_diagonal == expected.extents->box_diagonal);
  CHECK(found.extents->robust_diagonal == expected.extents->robust_diagonal);
  CHECK(found.extents->exponent_of_input == expected.extents->exponent_of_input);
  CHECK(found.scales->spacing == expected.scales->spacing);
  CHECK(found.scales->noise == expected.scales->noise);
  CHECK(found.range_of_scales.has_value() == expected.range_of_scales.has_value());
  const internal::Range_of_scales range = found.range_of_scales.value_or(
                                    internal::Range_of_scales()),
                                  expected_range = expected.range_of_scales.value_or(
                                    internal::Range_of_scales());
  CHECK(range.least == expected_range.least && range.largest == expected_range.largest);
  CHECK(std::abs(range.median / expected_range.median - 1) < 0.006);
  CHECK(found.median_number_of_neighbors == expected.median_number_of_neighbors);
  CHECK(found.has_plain_blocks == expected.has_plain_blocks);
  CHECK(found.units_of_disks == expected.units_of_disks);
  CHECK(found.area == expected.area);
  CHECK(found.mean_number_of_neighbors == expected.mean_number_of_neighbors);
  CHECK(found.number_of_places == expected.number_of_places);
}

/// Where each point stands in `points_in_cloud()`.
std::vector<std::uint64_t> places_block_by_block(const std::vector<Place>& points)
{
  const internal::Counted_cloud cloud(counts_of(points));
  std::map<CGAL::L0_resampling::Block, std::uint64_t> next;
  std::uint64_t sum = 0;
  for (const auto& [block, count] : cloud.blocks())
  {
    next[block] = sum;
    sum += count;
  }
  std::vector<std::uint64_t> places;
  for (const Place& p : points)
    places.push_back(next[cloud.lattice().block_of(p)]++);
  return places;
}

bool is_same(const internal::Point_in_cloud& a, const internal::Point_in_cloud& b)
{
  return a.units == b.units && a.index == b.index && a.number_of_samples == b.number_of_samples
         && a.scale == b.scale;
}

/// So that samples are neither lost nor there twice, whatever tiles find of a run.
void check_each_run_is_of_one_tile(const std::vector<internal::Share_of_tile>& shares)
{
  std::vector<std::uint64_t> keys;
  for (const internal::Share_of_tile& share : shares)
    for (const internal::Run_of_cells& run : share.runs)
      if (run.sums.points > 0)
        keys.push_back(run.key);
  std::sort(keys.begin(), keys.end());
  CHECK(!keys.empty());
  CHECK(std::adjacent_find(keys.begin(), keys.end()) == keys.end());
}

/// Where all points are outliers.
enum class Only_outliers
{
  NOWHERE,
  IN_TILES,
  EVERYWHERE
};

/// \param share of the points that memory holds at a time
/// \param halo of tiles, in radii
/// \returns the facts found in passes
template <typename NamedParameters>
internal::Facts_of_cloud check(const std::string& name, const std::vector<Place>& points,
                               double share, double halo, const NamedParameters& np,
                               Only_outliers only_outliers = Only_outliers::NOWHERE)
{
  const Points_in_memory source{points};
  const std::uint64_t much = std::uint64_t(1) << 40;
  Tiles<Tag> in_memory(counts_of(points), np), tiles(counts_of(points), np);
  in_memory.find_facts(source, much);
  CHECK(in_memory.has_all_facts());
  tiles.set_facts(facts_in_passes(points, std::size_t(share * double(points.size())), halo, np));
  const double m = double(tiles.number_of_samples());
  tiles.make_tiles(std::uint64_t(share
                                 * (double(points.size()) * double(tiles.bytes_per_point)
                                    + m * double(tiles.bytes_per_sample)))
                     + 2 * points.size(), // which the field may take
                   halo);
  const std::size_t number_of_tiles = tiles.tiles().size();
  CHECK(number_of_tiles >= 3);
  std::vector<internal::Neighbors_of_tile> neighbors_of_tiles;
  internal::Neighbor_counts neighbors;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    neighbors_of_tiles.push_back(tiles.find_neighbors_of_tile(tile, source));
    neighbors += neighbors_of_tiles.back().counts;
  }
  tiles.set_medians(neighbors.medians());
  std::vector<internal::Points_of_tile> points_of_tiles;
  std::vector<internal::Disks_of_tile> disks;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    points_of_tiles.push_back(
      tiles.find_points_of_tile(tile, source, neighbors_of_tiles[tile].scales));
    const internal::Points_of_tile found_once_more = tiles.find_points_of_tile(tile, source);
    CHECK(std::equal(points_of_tiles[tile].points.begin(), points_of_tiles[tile].points.end(),
                     found_once_more.points.begin(), found_once_more.points.end(), is_same));
    disks.push_back(points_of_tiles.back().disks);
  }
  const internal::Disks_of_tile all_disks = internal::add_up_disks(disks);
  CHECK((all_disks.keeps_outliers != 0) == (only_outliers == Only_outliers::EVERYWHERE));
  CHECK(std::any_of(disks.begin(), disks.end(),
                    [](const auto& of_tile) { return of_tile.keeps_outliers != 0; })
        == (only_outliers != Only_outliers::NOWHERE));
  tiles.set_disks(all_disks);
  std::vector<internal::Share_of_tile> shares;
  for (internal::Points_of_tile& of_tile : points_of_tiles)
    shares.push_back(tiles.share_of_tile(of_tile));
  check_each_run_is_of_one_tile(shares);
  internal::Cloud_totals sums = internal::add_up_shares(shares);
  sums.disks = all_disks;
  tiles.set_sums(sums);
  check_same(tiles.facts(), in_memory.facts());

  const internal::Buffer<internal::Point_in_cloud>& expected = in_memory.points_in_cloud();
  const internal::Parameters parameters = internal::checked_parameters(np, points.size());
  const std::vector<std::uint64_t> places = places_block_by_block(points);
  std::size_t number_of_own = 0, different = 0, different_around = 0;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    const internal::Buffer<internal::Point_in_cloud> found =
      std::move(points_of_tiles[tile])
        .placed({shares[tile].runs, sums.sums}, parameters.number_of_output_points,
                parameters.random_seed, !parameters.keep_density);
    const auto ranges = tiles.ranges_of_tile(tile);
    auto next = found.begin();
    for (const std::uint64_t place : places)
    {
      if (std::none_of(ranges.begin(), ranges.end(), [&](const auto& range) {
            return place >= range.first && place < range.first + range.second;
          }))
        continue;
      number_of_own += next->is_own;
      if (!is_same(*next, expected[place]))
        ++(next->is_own != 0 ? different : different_around);
      ++next;
    }
    CHECK(next == found.end());
  }
  std::cout << name << ": " << number_of_tiles
            << " tiles, points of which they find something else: " << different << " of "
            << points.size() << ", and " << different_around << " in their halos" << std::endl;
  CHECK(number_of_own == points.size());
  CHECK(different == 0);
  return tiles.facts();
}

/// Each a part of the cloud by itself, flat, with as many points as a ball.
std::vector<Place> clusters()
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> place(0, 2);
  std::vector<Place> points;
  for (int i = 0; i < 300; ++i)
    for (int k = 0; k < 200; ++k)
      points.push_back({30. * (i % 18) + place(generator), 30. * (i / 18) + place(generator),
                        0.02 * place(generator)});
  return points;
}

/// Beside a part that is larger.
std::vector<Place> clusters_and_sheet()
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> place(0, 2);
  std::vector<Place> points = clusters();
  for (int i = 0; i < 20000; ++i)
    points.push_back({10 * place(generator), 550 + 10 * place(generator), 0.02 * place(generator)});
  return points;
}

/// Sheets in an L, far apart, so that tiles are next to each other only beyond what they hold; and
/// a few points so far away that they do not count for the extent.
std::vector<Place> separate_sheets()
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Place> points;
  const auto add_sheet = [&](double x, double y, double density) {
    for (int i = 0; i < int(250000 * density); ++i)
      points.push_back(
        {x + 300 * place(generator), y + 300 * place(generator), 0.3 * place(generator)});
  };
  add_sheet(0, 0, 0.1);
  add_sheet(305.3, 310.7, 0.1);
  add_sheet(1300, 30, 0.2);
  add_sheet(2400, 0, 0.05);
  for (int i = 0; i < 500; ++i)
    points.push_back(
      {30000 + 20 * place(generator), (i % 3 - 1) * 9000 + 20 * place(generator), 500});
  return points;
}

/// A few places of many points each, so that balls of all sizes are looked at: the pass that looks
/// at balls is done twice, and its shares do not fall. So many that there are calls in each tile.
void check_few_places()
{
  std::mt19937 generator(13);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Place> points;
  for (int i = 0; i < 1500; ++i)
    points.insert(points.end(), 400, {place(generator), place(generator), place(generator)});
  const internal::Facts_of_cloud facts = facts_in_passes(
    points, points.size() / 10 * 8, 5,
    CGAL::parameters::number_of_output_points(std::size_t(1000)).neighbor_radius(0.02));
  CHECK(facts.scales->spacing > 0);
}

int main(int argc, char** argv)
{
  using CGAL::parameters::number_of_output_points;
  const auto& [even, uneven, crowds, sheets] = Scenes(argc > 1 ? std::atof(argv[1]) : 3000);
  const auto samples = [&](const Scene& scene, double share) {
    return number_of_output_points(number_of_samples(scene, share));
  };
  check("even", even.points(), 0.3, 20, samples(even, 0.5));
  check("uneven", uneven.points(), 0.3, 20, samples(uneven, 0.4));
  check("uneven, as dense as the input", uneven.points(), 0.3, 20,
        CGAL::parameters::keep_density(true).number_of_output_points(
          number_of_samples(uneven, 0.4)));
  check("crowds and outliers", crowds.points(), 0.3, 20, samples(crowds, 1.3));
  check("two sheets", sheets.points(), 0.3, 20, samples(sheets, 0.3));
  const auto few_samples = CGAL::parameters::outlier_sensitivity(3)
                             .number_of_output_points(std::size_t(20000))
                             .neighbor_radius(9);
  check("clusters, all too small", clusters(), 0.5, 2, few_samples, Only_outliers::EVERYWHERE);
  check("clusters and a sheet", clusters_and_sheet(), 0.5, 2, few_samples, Only_outliers::IN_TILES);
  const std::vector<Place> separate = separate_sheets();
  const internal::Facts_of_cloud facts = check("separate sheets", separate, 0.6, 30,
                                               number_of_output_points(std::size_t(30000)));
  CHECK(facts.extents->robust_diagonal < 0.2 * facts.extents->box_diagonal);
  check_few_places();
  return test::result();
}
