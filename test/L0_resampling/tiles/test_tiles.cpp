// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A cloud that is resampled tile by tile.

#include "tiles/Results_in_memory.h"
#include "tiles/points_in_memory.h"

#include <CGAL/l0_resample_tiles.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <random>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

using namespace test;
using namespace CGAL::L0_resampling;
using namespace CGAL::L0_resampling::internal;

/// A wavy ribbon along the x-axis, about one point per unit of area.
std::vector<Place> ribbon(std::size_t length, std::size_t width)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> shift(-0.5, 0.5);
  std::vector<Place> points;
  for (std::size_t i = 0; i < length; ++i)
    for (std::size_t j = 0; j < width; ++j)
    {
      const double x = double(i) + shift(generator), y = double(j) + shift(generator);
      points.push_back({x, y, 2 * std::sin(x / 40) + 0.1 * shift(generator)});
    }
  return points;
}

/// Gives copies, and counts them.
struct Copies_of_results : Results_in_memory
{
  mutable std::size_t number_of_copies = 0;

  Tile_result get(std::size_t tile) const
  {
    ++number_of_copies;
    return results.at(tile);
  }
};

/// Blocks depend neither on the order of the points nor on who has counted them.
void test_counts()
{
  std::vector<Place> points = ribbon(20000, 20);
  points.push_back({1e7, -1e7, 0});
  Tile_counts whole = counts_of(points);
  std::shuffle(points.begin(), points.end(), std::mt19937(1));
  const auto middle = points.begin() + 7;
  Tile_counts parts = counts_of({points.begin(), middle});
  parts.add(counts_of({middle, points.end()}));
  CHECK(whole.blocks().size() <= 2 * Tile_counts::most_blocks);
  whole.finish();
  parts.finish();
  CHECK(whole.blocks() == parts.blocks());
  CHECK(whole.blocks().size() <= Tile_counts::most_blocks);
  CHECK(whole.lattice().exponent() == parts.lattice().exponent());
  CHECK(whole.low() == parts.low() && whole.high() == parts.high());
  CHECK(whole.number_of_points() == points.size());
  CHECK(whole.blocks().size() * Tile_counts::fewest_points_per_block <= points.size());
  std::uint64_t sum = 0;
  for (const auto& [block, count] : whole.blocks())
    sum += count;
  CHECK(sum == points.size());
}

/// A square of blocks of side 1 with so many points in each.
Tile_counts square_of_blocks(std::int64_t side, std::uint64_t count)
{
  std::vector<std::pair<Block, std::uint64_t>> blocks;
  for (std::int64_t x = 0; x < side; ++x)
    for (std::int64_t y = 0; y < side; ++y)
      blocks.push_back({{x - 100, y - 300, 0}, count});
  const double low = -300, high = double(side);
  return Tile_counts(0, blocks, {low, low, 0}, {high, high, 0.5});
}

/// There are not more blocks than the limit, and they are no larger than that asks for.
void test_limit_of_blocks()
{
  const std::int64_t most = 512; // on a side: their square is the limit
  CHECK(std::uint64_t(most * most) == Tile_counts::most_blocks);
  Tile_counts at_limit = square_of_blocks(most, Tile_counts::fewest_points_per_block);
  at_limit.finish();
  CHECK(at_limit.lattice().exponent() == 0);
  for (const std::int64_t side : {most + 2, 2 * most - 2, 3 * most})
  {
    Tile_counts beyond = square_of_blocks(side, Tile_counts::fewest_points_per_block);
    beyond.finish();
    CHECK(beyond.lattice().exponent() == (side < 2 * most ? 1 : 2));
    CHECK(beyond.blocks().size() <= Tile_counts::most_blocks);
  }
}

/// Limits that points pass as they come do not show in the result.
void test_order_at_limit()
{
  std::vector<Place> points;
  for (double x = 0; x < 900; ++x)
    for (double y = 0; y < 900; ++y)
      points.push_back({x - 100.5, y - 300.5, 0.5});
  const Tile_counts more = square_of_blocks(30, 1000 * Tile_counts::most_blocks);
  Tile_counts in_order = counts_of(points);
  in_order.add(more);
  in_order.finish();
  CHECK(in_order.lattice().exponent() == 1);
  std::shuffle(points.begin(), points.end(), std::mt19937(2));
  Tile_counts shuffled = more;
  const auto middle = points.begin() + 300000;
  shuffled.add(counts_of({middle, points.end()}));
  shuffled.add(counts_of({points.begin(), middle}));
  shuffled.finish();
  CHECK(in_order.blocks() == shuffled.blocks());
  CHECK(in_order.lattice().exponent() == shuffled.lattice().exponent());
}

/// So many blocks around a place hold what is within a length of it, and one block less does not.
void test_halo()
{
  const Counted_cloud cloud(square_of_blocks(30, Tile_counts::fewest_points_per_block));
  const Block_lattice& lattice = cloud.lattice();
  CHECK(lattice.side() == 1);
  for (const double length : {0.1, 0.7, 1.3, 2., 7.9, 20.4})
  {
    std::int64_t farthest = 0;
    for (double x = -2; x < 2; x += 1. / 64)
    {
      const Block from = lattice.block_of(Place{x, 0, 0}),
                  to = lattice.block_of(Place{x + length, 0, 0});
      farthest = (std::max)(farthest, to[0] - from[0]);
    }
    CHECK(cloud.halo_in_blocks(length) >= farthest);
    CHECK(cloud.halo_in_blocks(0.999 * length) <= farthest);
  }
}

/// Blocks below zero are as large as those above.
void test_negative_blocks()
{
  Tile_counts counts;
  for (int i = -4096; i < 4096; ++i)
    for (int k = 0; k < 64; ++k)
      counts.add({double(i) + 0.5, 0, 0});
  counts.finish();
  for (const auto& [block, count] : counts.blocks())
    CHECK(count == counts.blocks().front().second);
}

/// Each block is in one tile, no tile is larger than the limit, and none is split without need.
void test_tiling()
{
  Tile_counts counts = counts_of(ribbon(4000, 40));
  counts.finish();
  const auto blocks = counts.blocks();
  for (const std::uint64_t limit : {200000u, 60000u, 20000u})
  {
    const Tiling tiling(blocks, 2, {1}, limit);
    std::uint64_t sum = 0;
    for (const Tile& tile : tiling.tiles())
    {
      CHECK(tile.number_of_points_with_halo <= limit);
      sum += tile.number_of_points;
    }
    CHECK(sum == counts.number_of_points());
    for (const auto& [block, count] : blocks)
    {
      std::size_t number_of_owners = 0;
      for (const Tile& tile : tiling.tiles())
        number_of_owners += tile.box.contains(block);
      CHECK(number_of_owners == 1);
    }
    CHECK((tiling.tiles().size() == 1) == (limit >= counts.number_of_points()));
  }
  CHECK(Tiling(blocks, 2, {1}, 10).maximum_bytes_of_tile() > 10);
}

/// A tile of few points has as many even samples as one of many, if its surface is as large.
void test_bytes_of_tiles()
{
  std::vector<std::pair<Block, std::uint64_t>> blocks;
  for (std::int64_t x = 0; x < 100; ++x)
    blocks.push_back({{x, 0, 0}, x < 50 ? 1000u : x < 90 ? 20u : 1u});
  const Bytes_of_tile bytes = {3, 1, 100};
  const Tiling tiling(blocks, 0, bytes, 40000);
  CHECK(tiling.maximum_bytes_of_tile() <= 40000);
  for (const Tile& tile : tiling.tiles())
  {
    const std::int64_t first = tile.box.low[0], last = tile.box.high[0];
    CHECK(3 * tile.number_of_points <= 40000);
    if (first >= 50 && last < 90)
      CHECK((last - first + 1) * 1600 <= 40000);
  }
  CHECK(bytes(1000, 16) == 3000 && bytes(20, 16) == 1620 && bytes(1, 1) == 101);
}

/// What comes before each run is what the runs of all tiles with smaller keys hold, those that
/// several have counted only once.
void test_shares()
{
  std::vector<Share_of_tile> shares(3);
  shares[0] = {{{3, {}}, {5, {10, 2, 1, 12, 3}}, {9, {20, 5, 5, 30, 4}}, {11, {}}}, 0.5};
  shares[1] = {{{3, {7, 3, 2, 7, 1}}, {5, {}}, {9, {20, 5, 5, 30, 4}}}, 0.5}; // one run in both
  const Cloud_totals sums = add_up_shares(shares);
  CHECK(sums.sums.units == 37 && sums.sums.points == 10 && sums.sums.distinct == 8);
  CHECK(sums.area == 24.5 && sums.sums.neighbors == 8);
  const auto before = [&](std::size_t tile, std::size_t run) {
    const Run_of_cells& found = shares[tile].runs[run];
    return std::array<std::uint64_t, 4>{found.key, found.sums.units, found.sums.points,
                                        found.sums.distinct};
  };
  using Numbers = std::array<std::uint64_t, 4>;
  CHECK(shares[0].runs.size() == 3 && shares[1].runs.size() == 3 && shares[2].runs.empty());
  for (const std::size_t tile : {std::size_t(0), std::size_t(1)})
  {
    CHECK(before(tile, 0) == (Numbers{3, 0, 0, 0}));
    CHECK(before(tile, 1) == (Numbers{5, 7, 3, 2}));
    CHECK(before(tile, 2) == (Numbers{9, 17, 5, 3}));
  }
}

/// Areas of all tiles that 64 bits do not hold are refused, not taken modulo 2^64.
void test_areas_beyond_64_bits()
{
  const std::uint64_t half = std::uint64_t(1) << 63;
  CHECK(add_up_disks({{half, 0, 0}, {half - 1, 0, 0}}).units == ~std::uint64_t(0));
  CHECK_THROWS(add_up_disks({{half, 0, 0}, {half, 0, 0}}), std::length_error);
  const auto shares_of = [&](std::uint64_t units) {
    return std::vector<Share_of_tile>{{{{3, {1, 1, 1, half, 1}}}, 0.5},
                                      {{{5, {1, 1, 1, units, 1}}}, 0.5}};
  };
  std::vector<Share_of_tile> shares = shares_of(half - 1), too_large = shares_of(half);
  CHECK(add_up_shares(shares).sums.units_of_all == ~std::uint64_t(0));
  CHECK_THROWS(add_up_shares(too_large), std::length_error);
}

Tile_sample sample_at(double x, double y, float sign, std::uint32_t tree)
{
  return {{x, y, 0}, {0, 0, sign}, tree};
}

/// Three tiles, the one in the middle with two trees; one tile is turned against the others, and
/// most of the evidence says that it is right.
void test_stitching()
{
  const auto row = [](double x, float sign, std::uint32_t tree) {
    std::vector<Tile_sample> samples;
    for (int i = 0; i < 10; ++i)
      samples.push_back(sample_at(x, i, sign, tree));
    return samples;
  };
  Stitching stitching(1, {{3}, {1, 2}, {100}});
  stitching.add_overlap(0, row(0, 1, 0), 1, row(0.1, 1, 0));
  stitching.add_overlap(2, row(9, -1, 0), 1, row(9.1, 1, 0));
  stitching.add_overlap(2, row(20, -1, 0), 1, row(20.6, 1, 1)); // too far off
  const auto signs = stitching.signs();
  CHECK(signs == (std::vector<std::vector<signed char>>{{-1}, {-1, 1}, {1}}));
  const Seam_report report = stitching.report(signs);
  CHECK(report.number_of_samples == 30 && report.number_of_matches == 20);
  CHECK(report.number_of_opposed == 0);
  CHECK(stitching.report({{1}, {1, 1}, {1}}).number_of_opposed == 10);
}

/// Tiles on a ring, each with one tree and ten samples that its neighbors have found too: votes are
/// those of each pair, from a sink that gives each result once.
void test_overlaps_of_all_tiles()
{
  constexpr std::size_t number_of_tiles = 6;
  struct Ring
  {
    bool are_neighbors(std::size_t a, std::size_t b) const
    {
      const std::size_t distance = a < b ? b - a : a - b;
      return distance == 1 || distance == number_of_tiles - 1;
    }
    std::vector<Tile_sample> samples_of_owner(const std::vector<Tile_sample>& samples,
                                              std::size_t owner) const
    {
      std::vector<Tile_sample> found;
      for (const Tile_sample& sample : samples)
        if (sample.position[0] == double(10 * owner))
          found.push_back(sample);
      return found;
    }
  };
  const Ring ring = {};
  Copies_of_results sink;
  Stitching of_pairs(1, {{9}, {1}, {1}, {1}, {1}, {1}}), of_all = of_pairs;
  for (std::size_t tile = 0; tile < number_of_tiles; ++tile)
  {
    const float sign = tile % 3 == 1 ? -1.f : 1.f;
    Tile_result result;
    for (std::size_t place = 0; place < number_of_tiles; ++place)
      for (int i = 0; i < 10 && (place == tile || ring.are_neighbors(tile, place)); ++i)
        (place == tile ? result.near_border : result.beyond_border)
          .push_back(sample_at(double(10 * place), i, sign, 0));
    sink.put(tile, std::move(result));
  }
  for (std::size_t a = 0; a < number_of_tiles; ++a)
    for (std::size_t b = 0; b < number_of_tiles; ++b)
      if (ring.are_neighbors(a, b))
        of_pairs.add_overlap(a, sink.results.at(a).near_border, b,
                             ring.samples_of_owner(sink.results.at(b).beyond_border, a));
  of_all.add_overlaps(ring, sink);
  CHECK(sink.number_of_copies == number_of_tiles);
  const auto signs = of_all.signs();
  CHECK(signs == (std::vector<std::vector<signed char>>{{1}, {-1}, {1}, {1}, {-1}, {1}}));
  CHECK(signs == of_pairs.signs());
  const Seam_report report = of_all.report(signs), expected = of_pairs.report(signs);
  CHECK(report.number_of_samples == 120 && report.number_of_matches == 120);
  CHECK(report.number_of_samples == expected.number_of_samples && report.number_of_opposed == 0);
}

/// Exactly as many points as asked for, of one side, each where its tile is, and as even at the
/// seams as elsewhere.
/// \param m so few that memory for half of the cloud does not do for the facts;
/// or so many that it does
void test_tiles(bool keep_density, std::size_t m, bool has_all_facts)
{
  using Tiles = CGAL::L0_resampling::Tiled_resampling<CGAL::Sequential_tag>;
  const Points_in_memory source{ribbon(2400, 10)};
  const std::size_t n = source.points.size();
  const std::uint64_t memory = (n * Tiles::bytes_per_point + m * Tiles::bytes_per_sample) / 2;
  CHECK(Tiles::can_find_all_facts(n, m, memory, 0) == has_all_facts);
  Results_in_memory sink;
  CGAL::l0_resample_tiles<CGAL::Sequential_tag>(
    source, sink, memory, CGAL::parameters::keep_density(keep_density).number_of_output_points(m));
  CHECK(sink.finished.size() >= 3);
  std::size_t number = 0, number_upwards = 0;
  std::vector<std::size_t> slabs(60, 0);
  for (const auto& [tile, samples] : sink.finished)
    for (const Tile_sample& sample : samples)
    {
      ++number;
      number_upwards += sample.normal[2] > 0;
      const double place = (std::max)(0., (std::min)(sample.position[0] / 40, 59.));
      ++slabs[std::size_t(place)];
    }
  CHECK(number == m);
  CHECK(number_upwards == 0 || number_upwards == m);
  for (std::size_t k = 1; k + 1 < slabs.size(); ++k)
    CHECK(std::abs(double(slabs[k]) - double(m) / 60) < 0.12 * double(m) / 60);
}

/// Where tiles find their sides themselves, each is asked for once beside each of its neighbors,
/// once for its own border, and once to be finished.
void test_number_of_copies()
{
  const Points_in_memory source{ribbon(4800, 10)};
  const std::size_t m = 96000;
  const std::uint64_t memory = 200 * m; // less than the sides of all take
  Copies_of_results sink;
  CGAL::l0_resample_tiles<CGAL::Sequential_tag>(source, sink, memory,
                                                CGAL::parameters::number_of_output_points(m));
  const std::size_t n = sink.finished.size();
  CHECK(n >= 3);
  CHECK(sink.number_of_copies == n + n); // for the overlaps, and to finish
}

/// The named parameter limits the memory of tiles and facts, with `CUDA_tag` that of the device.
template <typename ConcurrencyTag>
void test_limit_of_memory()
{
  const Points_in_memory source{ribbon(4800, 10)};
  const std::uint64_t most = std::uint64_t(1) << 40,
                      less = std::is_same<ConcurrencyTag, CGAL::CUDA_tag>::value ? 7000000
                                                                                 : 4000000;
  const auto tiles_of = [&](std::uint64_t limit, std::uint64_t bytes) {
    CGAL::L0_resampling::Tiled_resampling<ConcurrencyTag> tiles(
      counts_of(source.points),
      CGAL::parameters::maximum_memory(std::size_t(limit)).number_of_output_points(8000));
    const std::uint64_t of_facts = limit == most ? less : most;
    tiles.find_facts(source, of_facts, of_facts);
    CHECK(!tiles.has_all_facts()); // neither limit does
    tiles.make_tiles(bytes);
    return tiles.tiles().size();
  };
  const std::size_t number = tiles_of(most, less);
  CHECK(number >= 3);
  CHECK(tiles_of(less, most) == number);
}

void test_refusals()
{
  const Points_in_memory source{ribbon(600, 10)};
  Results_in_memory sink;
  CHECK_THROWS(CGAL::l0_resample_tiles<CGAL::Sequential_tag>(
                 source, sink, 1000, CGAL::parameters::number_of_output_points(100)),
               std::bad_alloc);
  CHECK_THROWS(CGAL::l0_resample_tiles<CGAL::Sequential_tag>(source, sink, 1 << 30,
                                                             CGAL::parameters::resampling_method(
                                                               CGAL::L0_resampling::Method::LOR)
                                                               .number_of_output_points(100)),
               std::invalid_argument);
  std::vector<double> deviations(100); // no tile has them
  CHECK_THROWS(CGAL::l0_resample_tiles<CGAL::Sequential_tag>(
                 source, sink, 1 << 30,
                 CGAL::parameters::number_of_output_points(100)
                   | CGAL::parameters::normal_deviation_map(CGAL::make_property_map(deviations))),
               std::invalid_argument);
  CHECK(sink.results.empty());
  CGAL::l0_resample_tiles<CGAL::Sequential_tag>(Points_in_memory{}, sink, 1 << 20,
                                                CGAL::parameters::number_of_output_points(100));
  CHECK(sink.finished.empty());
}

int main()
{
  test_counts();
  test_limit_of_blocks();
  test_order_at_limit();
  test_halo();
  test_negative_blocks();
  test_tiling();
  test_bytes_of_tiles();
  test_shares();
  test_areas_beyond_64_bits();
  test_stitching();
  for (const bool keep_density : {false, true})
  {
    test_tiles(keep_density, 10000, false);
    test_tiles(keep_density, 40000, true);
  }
  test_overlaps_of_all_tiles();
  test_number_of_copies();
  test_limit_of_memory<CGAL::Sequential_tag>();
  test_limit_of_memory<CGAL::CUDA_tag>();
  test_refusals();
  return test::result();
}
