// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tiles on a device give what a call on the device gives for the whole cloud.

#include "device/test_cuda_support.h"
#include "tiles/report_of_tiles.h"
#include "tiles/tiles_as_one.h"

#include <CGAL/L0_resampling/internal/tiles/tiles_on_device.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace test;
namespace internal = CGAL::L0_resampling::internal;
using CGAL::CUDA_tag;

constexpr std::uint64_t most = std::uint64_t(1) << 40; // bytes: no limit

/// \param maximum_share of the samples that may differ with the practical halo
template <typename NamedParameters>
void check(const std::string& name, const std::vector<Place>& points, double maximum_share,
           std::size_t number_of_samples, const NamedParameters& np)
{
  const std::size_t n = points.size();
  std::size_t number_of_tiles = 0;
  const std::vector<Sample> whole = in_memory<CUDA_tag>(points, np);
  CHECK(whole.size() == number_of_samples);
  CHECK(by_tiles<CUDA_tag>(points, 2 * n, 40, number_of_tiles, np) == whole);
  CHECK(number_of_tiles == 1);
  for (const double halo : {80., 40.})
  {
    const std::vector<Sample> several = by_tiles<CUDA_tag>(points, 7 * n / 10, halo,
                                                           number_of_tiles, np);
    CHECK(number_of_tiles >= 2 && several.size() == number_of_samples);
    const std::size_t different = number_of_different(several, whole);
    std::cout << name << ": " << number_of_tiles << " tiles with halos of " << halo
              << " radii, samples that differ: " << different << std::endl;
    CHECK(double(different) <= (halo > 40 ? 0 : maximum_share) * double(number_of_samples));
  }
  const std::vector<Sample> with_own_sides = by_tiles<CUDA_tag>(points, 7 * n / 10, 80,
                                                                number_of_tiles, np, true, false);
  CHECK(without_sides(with_own_sides) == without_sides(whole));
}

internal::Buffer<Vector> vectors_of(const std::vector<Place>& points)
{
  internal::Buffer<Vector> vectors;
  for (const Place& p : points)
    vectors.push_back(Vector(p.data()));
  return vectors;
}

/// What is found of each point is the same on both processors, but for a few on the border of
/// something that roundings decide.
template <typename NamedParameters>
void check_facts(const std::string& name, const std::vector<Place>& points,
                 const NamedParameters& np)
{
  using Tag = CGAL::Parallel_if_available_tag;
  const internal::Parameters parameters = internal::checked_parameters(np, points.size());
  CGAL::L0_resampling::Report report, report_of_device;
  internal::Memory_counter memory;
  internal::Progress progress(nullptr, report, memory);
  CGAL::L0_resampling::Block_chebyshev_solver_traits<float, Tag> solver;
  internal::Any_solver<float> any_solver(solver);
  internal::Buffer<Vector> used_up = vectors_of(points);
  internal::Buffer<internal::Point_in_cloud> on_cpu, on_device;
  const internal::Facts_of_cloud expected =
    internal::facts_of_points<Tag>(used_up, parameters, any_solver, progress, report, on_cpu);
  const internal::Facts_of_cloud found =
    internal::facts_on_device(vectors_of(points), parameters, nullptr, report_of_device, on_device);
  CHECK(found.frame->exponent == expected.frame->exponent);
  CHECK(found.frame->origin == expected.frame->origin);
  CHECK(std::abs(*found.area / *expected.area - 1) < 1e-6);
  CHECK(std::abs(found.scales->noise / expected.scales->noise - 1) < 1e-5);
  CHECK(std::abs(*found.mean_number_of_neighbors / *expected.mean_number_of_neighbors - 1) < 1e-4);
  if (expected.number_of_points) // if it was needed
    CHECK(*found.number_of_points == *expected.number_of_points);
  CHECK(*found.number_of_places == *expected.number_of_places);
  std::size_t different = 0, with_other_scale = 0, number_of_samples = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const internal::Point_in_cloud &a = on_cpu[i], &b = on_device[i];
    different += a.units != b.units || a.index != b.index
                 || a.number_of_samples != b.number_of_samples;
    with_other_scale += std::abs(a.scale / b.scale - 1) > 1e-5;
    number_of_samples += b.number_of_samples;
  }
  std::cout << name << ": points of which the CPU finds something else: " << different
            << ", and another scale: " << with_other_scale << " of " << points.size() << std::endl;
  CHECK(number_of_samples == parameters.number_of_output_points);
  CHECK(double(different + with_other_scale) <= 0.001 * double(points.size()));
}

/// What a tile takes of the device is what tiles are cut by, and likewise for the facts.
void check_memory(const std::string& name, const std::vector<Place>& scene)
{
  using On_device = Tiles<CUDA_tag>;
  const Points_in_memory source{scene};
  const std::size_t n = scene.size();
  for (const double share : {0.02, 0.5, 2.})
  {
    const std::size_t m = std::size_t(share * double(n));
    const auto np = CGAL::parameters::number_of_output_points(m);
    CGAL::L0_resampling::Tile_counts counts;
    for (const Place& p : scene)
      counts.add(p);
    On_device tiles(std::move(counts), np);
    tiles.find_facts(source, most);
    tiles.make_tiles(most);
    CHECK(tiles.tiles().size() == 1 && tiles.has_all_facts());
    const CGAL::L0_resampling::Tile_result result = tiles.resample_tile(0, source);
    CHECK(result.report.device == "cuda");
    CGAL::L0_resampling::Report report;
    internal::Buffer<internal::Point_in_cloud> points;
    internal::facts_on_device(vectors_of(scene), internal::checked_parameters(np, n), nullptr,
                              report, points);
    const auto check_peak = [&](const char* what, std::size_t peak, std::uint64_t per_point,
                                std::uint64_t per_sample) {
      const std::uint64_t bound = n * per_point + m * per_sample;
      std::cout << name << ", " << what << " of " << n << " points and " << m
                << " samples: " << peak << " bytes of " << bound << std::endl;
      CHECK(peak <= bound);
    };
    check_peak("tile", result.report.peak_bytes, On_device::bytes_per_point,
               On_device::bytes_per_sample);
    check_peak("facts", report.peak_bytes, On_device::bytes_per_point_of_facts_on_device,
               On_device::bytes_per_sample_of_facts_on_device);
    tiles.choose_how_to_orient(most);
    tiles.sides({tiles.resample_tile(0, source).unoriented}, report);
    if (m >= 2 * n) // fewer take less than the field of their sets
      check_peak("sides", report.peak_bytes, 0, On_device::bytes_per_sample_of_sides);
  }
}

void check_failures()
{
  const Scene scene(500);
  const Points_in_memory source{scene.points()};
  const auto tiles_of = [&](const auto& np) {
    CGAL::L0_resampling::Tile_counts counts;
    for (const Place& p : scene.points())
      counts.add(p);
    return Tiles<CUDA_tag>(std::move(counts), np.number_of_output_points(2000));
  };
  int number_of_calls = 0;
  const std::function<bool(double)> say_no = [&](double) { return ++number_of_calls < 3; };
  auto cancelled = tiles_of(CGAL::parameters::callback(say_no));
  CHECK_THROWS(cancelled.find_facts(source, most), Tiles<CUDA_tag>::Cancelled);
  CHECK(number_of_calls == 3);
  auto tiles = tiles_of(CGAL::parameters::random_seed(0));
  tiles.find_facts(source, most);
  cancelled.set_facts(tiles.facts());
  cancelled.make_tiles(most);
  cancelled.set_points(0, tiles.points_in_cloud());
  number_of_calls = 0;
  CHECK_THROWS(cancelled.resample_tile(0, source), Tiles<CUDA_tag>::Cancelled);
  CHECK(number_of_calls == 3);

  auto without_memory = tiles_of(CGAL::parameters::maximum_memory(std::size_t(100000)));
  without_memory.find_facts(source, most); // of regions
  CHECK(!without_memory.has_all_facts());
  CHECK_THROWS(without_memory.make_tiles(most), std::bad_alloc);
  CHECK(internal::device_memory_for_tiles() > (std::uint64_t(1) << 28));
}

} // namespace

int main()
{
  using CGAL::parameters::keep_density;
  if (!test_cuda::has_device())
    return test_cuda::number_of_skip;
  const auto& [even, uneven, crowds, sheets] = Scenes(1500);
  std::size_t m = number_of_samples(even, 0.5);
  check("even", even.points(), 0.001, m, CGAL::parameters::number_of_output_points(m));
  m = number_of_samples(uneven, 0.4);
  check("uneven", uneven.points(), 0.08, m, CGAL::parameters::number_of_output_points(m));
  check("uneven, as dense as the input", uneven.points(), 0.08, m,
        keep_density(true).number_of_output_points(m));
  m = number_of_samples(crowds, 1.3);
  check("crowds and outliers", crowds.points(), 0.001, m,
        CGAL::parameters::number_of_output_points(m));
  m = number_of_samples(sheets, 0.3);
  check("two sheets", sheets.points(), 0.001, m, CGAL::parameters::number_of_output_points(m));
  const Scene strips = scene_of_strips(1500);
  m = number_of_samples(strips, 0.5);
  check("thinned blocks", strips.points(), 0.001, m,
        CGAL::parameters::neighbor_radius(4).number_of_output_points(m));
  check_facts("even", even.points(), CGAL::parameters::number_of_output_points(9000));
  check_facts("uneven", uneven.points(), CGAL::parameters::number_of_output_points(9000));
  check_facts("uneven, as dense as the input", uneven.points(),
              keep_density(true).number_of_output_points(9000));
  check_facts("crowds and outliers", crowds.points(),
              CGAL::parameters::number_of_output_points(90000));
  const Scenes large(10000);
  check_memory("even", large.even.points());
  check_memory("uneven", large.uneven.points());
  check_memory("crowds and outliers", large.crowds.points());
  check_report_of_tiles<CUDA_tag>(280, false); // memory holds all facts
  check_report_of_tiles<CUDA_tag>(170, false);
  check_failures();
  return test::result();
}
