// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_STEPS_OF_TILES_H
#define CGAL_L0_RESAMPLING_INTERNAL_STEPS_OF_TILES_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/Tile_result.h>
#include <CGAL/L0_resampling/Tiled_cloud.h>
#include <CGAL/L0_resampling/internal/interface/rounded_positions.h>
#include <CGAL/L0_resampling/internal/tiles/Facts_in_passes.h>
#include <CGAL/L0_resampling/internal/tiles/Samples_to_orient.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>
#include <CGAL/L0_resampling/tags.h>
#ifndef CGAL_L0_LINKED_WITH_COMPILED
#include <CGAL/L0_resampling/internal/tiles/facts_of_tile_impl.h>
#include <CGAL/L0_resampling/internal/tiles/find_creases_of_tiles_impl.h>
#include <CGAL/L0_resampling/internal/tiles/orient_tiles_impl.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile_impl.h>
#endif
#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/internal/tiles/tiles_on_device.h>
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// `Tiled_resampling::Cancelled`
struct Tiles_cancelled
{};

/// What is known of points, once it is known where samples start.
struct Known_points
{
  Buffer<Point_in_cloud> of_cloud; ///< of all blocks, if all facts were found from them
  std::map<std::size_t, Buffer<Point_in_cloud>> of_tiles; ///< that were set
  std::map<std::size_t, Run_prefix_sums> starts;          ///< of tiles, if not all facts were found
};

/*!
The stages of the steps of `Tiled_resampling`, which documents those that have names of its own.

\tparam Solver_traits of a number type and a concurrency tag
*/
template <typename ConcurrencyTag, template <typename, typename> class Solver_traits>
class Steps_of_tiles
{
public:
  static constexpr bool is_on_device = std::is_same<ConcurrencyTag, CUDA_tag>::value;

private:
  using Host_tag = std::conditional_t<is_on_device, Parallel_if_available_tag, ConcurrencyTag>;
  using Solver = Solver_traits<float, Host_tag>;
  using FT = typename Solver::FT;

  const Tiled_cloud& m_cloud;
  const Parameters& m_parameters;
  const std::function<bool(double)>& m_callback;

  /// Calls `f(progress, memory)`.
  /// \throws Tiles_cancelled if the callback says no
  template <typename F>
  void watched(Report& report, const F& f) const
  {
    Memory_counter memory(is_on_device // whose limit it is then
                            ? (std::numeric_limits<std::size_t>::max)()
                            : m_parameters.maximum_memory);
    Progress progress(m_callback, report, memory);
    try
    {
      f(progress, memory);
    }
    catch (const Interrupted&)
    {
      progress.rethrow_exception_of_callback();
      throw Tiles_cancelled();
    }
  }

  /// Calls `f(points, progress, report)` with the points of a tile and around it, to be used up.
  template <typename Source, typename F>
  void with_points(std::size_t tile, const Source& source, const F& f) const
  {
    Report unwanted_report;
    watched(unwanted_report, [&](Progress& progress, Memory_counter& memory) {
      Buffer<Vector> points(&memory);
      m_cloud.blocks_of_tile(tile).read_at_once(source, points);
      f(points, progress, unwanted_report);
    });
  }

  Input input_without_points(Memory_counter& memory) const
  {
    Input input(&memory);
    input.low = Vector(m_cloud.counted().low().data());
    input.high = Vector(m_cloud.counted().high().data());
    return input;
  }

  Buffer<std::array<double, 3>> rounded(const Buffer<Vector>& positions, const Input& input) const
  {
    return rounded_positions<Host_tag, double>(positions, input, m_cloud.neighbor_radius(), true);
  }

  /// Calls `f(solver)`.
  template <typename F>
  static auto with_solver(const F& f)
  {
    Solver solver;
    Any_solver<FT> any_solver(solver);
    return f(any_solver);
  }

  /// \param points used up
  /// \param found out: what is known of each
  Facts_of_cloud facts_of_points(Buffer<Vector>& points, Progress& progress, Report& report,
                                 Buffer<Point_in_cloud>& found) const
  {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    if constexpr (is_on_device)
      return facts_on_device(points, m_parameters, m_callback, report, found);
#endif
    return with_solver([&](Any_solver<FT>& solver) {
      return internal::facts_of_points<Host_tag>(points, m_parameters, solver, progress, report,
                                                 found);
    });
  }

  /// \param points used up
  /// \param scales of them; none if they are to be found
  Points_of_tile find_points(std::size_t tile, Buffer<Vector>& points, Buffer<float> scales,
                             Progress& progress, Report& report) const
  {
    return with_solver([&](Any_solver<FT>& solver) {
      return internal::find_points_of_tile<Host_tag>(points, std::move(scales), m_cloud.facts(),
                                                     m_parameters, m_cloud.own_blocks_of_tile(tile),
                                                     solver, progress, report);
    });
  }

  /// What is to be known of the points of a tile and its halo.
  Buffer<Point_in_cloud> points_of_tile(std::size_t tile, const Known_points& known,
                                        const Buffer<Vector>& points, Progress& progress) const
  {
    if (!m_cloud.has_all_facts())
    {
      Report unwanted_report;
      Buffer<Vector> used_up = copy_of(points);
      return placed(find_points(tile, used_up, {}, progress, unwanted_report),
                    known.starts.at(tile));
    }
    const Blocks_of_tile blocks = m_cloud.blocks_of_tile(tile);
    Buffer<Point_in_cloud> of_tile;
    of_tile.reserve(blocks.number_of_points());
    for (const auto& [first, count] : blocks.ranges())
      of_tile.insert(of_tile.end(), known.of_cloud.begin() + std::ptrdiff_t(first),
                     known.of_cloud.begin() + std::ptrdiff_t(first + count));
    blocks.mark_own(of_tile);
    return of_tile;
  }

  /// \param points used up
  Samples_of_tile<FT> resample_points(Buffer<Vector>& points, const Buffer<Point_in_cloud>& known,
                                      bool finds_sides, Progress& progress, Report& report) const
  {
    if constexpr (!is_on_device)
      return with_solver([&](Any_solver<FT>& solver) {
        return internal::resample_tile<Host_tag>(points, known, m_cloud.facts(), finds_sides,
                                                 m_parameters, solver, progress, report);
      });
    else
    {
#ifdef CGAL_L0_LINKED_WITH_CUDA
      return resample_tile_on_device(points, known, m_cloud.facts(), finds_sides, m_parameters,
                                     m_callback, report);
#else
      static_assert(
        !is_on_device,
        "CUDA_tag needs a compiled library: link with the CMake target CGAL::L0_CUDA_support.");
#endif
    }
  }

  void orient(const Plan& plan, Progress& progress, Report& report,
              Samples_to_orient& samples) const
  {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    if constexpr (is_on_device)
      return orient_tiles_on_device(m_cloud.facts(), plan,
                                    {m_cloud.counted().low(), m_cloud.counted().high()},
                                    m_parameters, m_callback, report, samples);
#endif
    (void)report;
    orient_tiles<Host_tag>(m_cloud.facts(), plan, m_parameters, progress, samples);
  }

public:
  /// \param cloud, callback outlive this object
  Steps_of_tiles(const Tiled_cloud& cloud, const std::function<bool(double)>& callback)
    : m_cloud(cloud), m_parameters(cloud.parameters()), m_callback(callback)
  {}

  static std::uint64_t device_memory()
  {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    if constexpr (is_on_device)
      return device_memory_for_tiles();
#endif
    return (std::numeric_limits<std::uint64_t>::max)();
  }

  /// \param at_once whether memory holds all of the points
  /// \param found out: if so, what is known of each
  template <typename Source>
  Facts_of_cloud find_facts(const Source& source, bool at_once, std::uint64_t bytes, double halo,
                            Buffer<Point_in_cloud>& found) const
  {
    Facts_of_cloud facts;
    Report unwanted_report;
    watched(unwanted_report, [&](Progress& progress, Memory_counter& memory) {
      if (!at_once)
      {
        facts = Facts_in_passes<Host_tag, Source>(m_cloud.counted(), source, m_parameters, bytes,
                                                  m_callback, memory)
                  .find(halo);
        return;
      }
      Buffer<Vector> points(&memory);
      points.reserve(std::size_t(m_cloud.number_of_points()));
      for (const auto& [block, count] : m_cloud.blocks())
        m_cloud.counted().read(source, {block, block}, points);
      facts = facts_of_points(points, progress, unwanted_report, found);
    });
    return facts;
  }

  template <typename Source>
  Neighbors_of_tile find_neighbors_of_tile(std::size_t tile, const Source& source) const
  {
    Neighbors_of_tile found;
    with_points(tile, source, [&](Buffer<Vector>& points, Progress& progress, Report& report) {
      Neighbors_of_tile counted = internal::find_neighbors_of_tile<Host_tag>(
        points, m_cloud.facts(), m_parameters, m_cloud.own_blocks_of_tile(tile), progress, report);
      found.counts = std::move(counted.counts);
      found.scales.assign(counted.scales.begin(), counted.scales.end()); // outlives the counter
    });
    return found;
  }

  template <typename Source>
  Points_of_tile find_points_of_tile(std::size_t tile, const Source& source,
                                     Buffer<float> scales) const
  {
    Points_of_tile found;
    with_points(tile, source, [&](Buffer<Vector>& points, Progress& progress, Report& report) {
      found = find_points(tile, points, std::move(scales), progress, report);
    });
    return found;
  }

  /// What is to be known of points, once it is known where samples start.
  Buffer<Point_in_cloud> placed(Points_of_tile points, const Run_prefix_sums& starts) const
  {
    m_cloud.share_of_tile(points);
    const Plan plan = m_cloud.plan();
    return std::move(points).placed(starts, plan.number_of_samples, plan.random_seed,
                                    plan.starts_evenly);
  }

  template <typename Source>
  Tile_result resample_tile(std::size_t tile, const Source& source, const Known_points& points,
                            bool finds_sides) const
  {
    Tile_result result;
    watched(result.report, [&](Progress& progress, Memory_counter& memory) {
      Input input = input_without_points(memory);
      const Blocks_of_tile blocks = m_cloud.blocks_of_tile(tile);
      if (m_cloud.has_all_facts())
        blocks.read_by_blocks(source, input.points);
      else
        blocks.read_at_once(source, input.points);
      const auto set = points.of_tiles.find(tile);
      const bool are_set = set != points.of_tiles.end();
      const Buffer<Point_in_cloud> found_here =
        are_set ? Buffer<Point_in_cloud>() : points_of_tile(tile, points, input.points, progress);
      const Buffer<Point_in_cloud>& known = are_set ? set->second : found_here;
      result.report.number_of_input_points = input.points.size();
      if (m_cloud.plan().drops_outliers())
        result.outliers = own_outliers(input.points, known);
      if (!are_there_starts(known))
        return;
      const Samples_of_tile<FT> samples = resample_points(input.points, known, finds_sides,
                                                          progress, result.report);
      const Buffer<std::array<double, 3>> positions = rounded(samples.points.positions, input);
      const Found_samples<FT> found = {samples, positions, m_cloud.box_of_tile(tile),
                                       m_cloud.overlap_width()};
      if (finds_sides)
        take_oriented_samples(found, result);
      else
        take_unoriented_samples(found, result);
    });
    result.report.number_of_output_points = result.samples.size();
    result.findings = findings_of(result.report);
    result.findings.number_of_outliers = result.outliers.size(); // those of its halo are others'
    return result;
  }

  std::vector<std::vector<signed char>> sides(std::vector<Unoriented_samples> unoriented,
                                              Report& report) const
  {
    std::vector<std::vector<signed char>> signs;
    watched(report, [&](Progress& progress, Memory_counter& memory) {
      Plan plan = m_cloud.plan();
      plan.set_sample_spacing(m_cloud.spacing_in_radii());
      Samples_to_orient samples(Host_tag(), std::move(unoriented), plan.sample_spacing, memory);
      if (!samples.places.empty())
        orient(plan, progress, report, samples);
      signs = samples.template signs<Host_tag>();
    });
    return signs;
  }

  template <typename SamplesOf>
  Creases_of_tiles find_creases(const SamplesOf& samples_of) const
  {
    Creases_of_tiles found;
    Report unwanted_report;
    watched(unwanted_report, [&](Progress& progress, Memory_counter& memory) {
      const auto take_samples_of = [&](std::size_t tile, std::vector<Tile_sample>& samples) {
        samples = samples_of(tile);
      };
      found = find_creases_of_tiles<Host_tag>(m_cloud.tiles().size(),
                                              spacing_of_creases(m_cloud.sample_spacing(),
                                                                 m_cloud.estimated_spacing()),
                                              Samples_of_tiles(take_samples_of), progress, memory);
      Buffer<Vector> positions(&memory);
      for (const Sample_beside_crease& sample : found.placed.moved)
        positions.push_back(sample.position);
      const Buffer<std::array<double, 3>> places = rounded(positions, input_without_points(memory));
      for (std::size_t k = 0; k < places.size(); ++k)
        found.placed.moved[k].position = Vector(places[k].data());
    });
    return found;
  }

  Report report(const Tile_findings& findings) const
  {
    Report report;
    report.number_of_input_points = std::size_t(m_cloud.number_of_points());
    report.number_of_outliers = std::size_t(findings.number_of_outliers);
    report.number_of_degenerate_neighborhoods = std::size_t(
      findings.number_of_degenerate_neighborhoods);
    report.number_of_output_points = std::size_t(findings.number_of_output_points);
    report.number_of_lonely_samples = std::size_t(findings.number_of_lonely_samples);
    report.number_of_unexplained_samples = std::size_t(findings.number_of_unexplained_samples);
    report.number_of_unexplained_samples_there = std::size_t(
      findings.number_of_unexplained_samples_there);
    report.unexplained_center = findings.unexplained_center;
    if (findings.number_of_unexplained_samples > 0)
      report.unexplained_radius = unexplained_radius_factor * m_cloud.neighbor_radius();
    report.neighbor_radius = m_cloud.neighbor_radius();
    report.estimated_spacing = m_cloud.estimated_spacing();
    report.estimated_noise = m_cloud.estimated_noise();
    report.sample_spacing = m_parameters.keep_density ? 0 : m_cloud.sample_spacing();
    if (is_on_device)
      report.device = "cuda";
    return report;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_STEPS_OF_TILES_H
