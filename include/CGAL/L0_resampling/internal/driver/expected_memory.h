// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_EXPECTED_MEMORY_H
#define CGAL_L0_RESAMPLING_INTERNAL_EXPECTED_MEMORY_H

#include <CGAL/L0_resampling/internal/orientation/orientation_votes.h>
#include <CGAL/L0_resampling/internal/samples/Refinement.h>
#include <CGAL/L0_resampling/internal/samples/choose_samples.h>
#include <CGAL/L0_resampling/internal/search/Neighborhoods.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What decides how much memory the samples take.
struct Expected_samples
{
  std::size_t size;         ///< of those that are worked on
  std::size_t other_bytes;  ///< of their grid, and of the samples that follow them
  Counted_neighbors self;   ///< the self neighbors, in the turn with the most
  Counted_neighbors others; ///< those that repel a sample, if they are not its self neighbors
};

/// The neighbors of samples once the repulsion has spread them: even samples have as many as their
/// density says, uneven ones keep more. The repulsion goes part of the way from one to the other.
inline Counted_neighbors once_spread(const Counted_neighbors& at_start, double number_of_even_ones)
{
  const double factor = 0.5 + 0.5 * number_of_even_ones / (std::max)(1., double(at_start.listed));
  if (!(factor > 1))
    return at_start;
  return {std::size_t(factor * double(at_start.listed)),
          std::size_t(factor * double(at_start.maximum_number_held))};
}

/// Counts the neighbors of samples where they start.
/// \param positions in the order of the grid of the points
/// \param scales of the samples; none if all are 1
/// \param spreading_radii of the samples, where they have their own
template <typename ConcurrencyTag>
Expected_samples count_neighbors(const Plan& plan, double cell_size_of_points,
                                 Buffer<Vector>& positions, Buffer<float>& scales,
                                 Buffer<float>& spreading_radii, Progress& progress)
{
  const Memory_counter& memory = *positions.get_allocator().counter;
  const bool spreads_wider = plan.refines && !scales.empty();
  const double longest_range = spreads_wider ? plan.spreading_radius() : plan.self_neighbor_radius,
               cell_size = plan.refines && !plan.keeps_spacings
                             ? (std::max)(cell_size_of_points, longest_range)
                             : plan.self_cell_size();
  {
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(
      positions, Cell_sizes(cell_size, spreading_radii));
    apply_order<ConcurrencyTag>(order, positions);
    for (Buffer<float>* values : {&scales, &spreading_radii})
      apply_order<ConcurrencyTag>(order, *values);
  }
  const std::size_t bytes_before = memory.current(), m = positions.size();
  const Search_grid_3 grid(positions, Cell_sizes(cell_size, spreading_radii));
  Expected_samples expected{m, memory.current() - bytes_before, {}, {}};
  const auto count_within = [&](const Range_of_pairs& range) {
    return count_self_neighbors<ConcurrencyTag>(grid, positions, range, progress);
  };
  const Range_of_pairs range_of(plan.self_neighbor_radius,
                                plan.refines ? view_of_scales(scales) : Scales_view(),
                                view_of_scales(spreading_radii));
  expected.self = count_within(range_of);
  if (!plan.refines)
    return expected;
  if (spreads_wider)
    expected.others = count_within({plan.spreading_radius(), {}, range_of.spreading_radii});
  double number_of_even_ones = 0; // in the ball around each, of the area of one sample each
  for_each_in_order(m, [&](std::size_t i) {
    const double spacing = spreading_radii.empty()
                             ? plan.sample_spacing
                             : spreading_radii[i] / self_neighbor_radius_per_spacing;
    number_of_even_ones += double(EIGEN_PI) * range_of.squared(i, i) / square(spacing) - 1;
  });
  expected.self = once_spread(expected.self, number_of_even_ones);
  return expected;
}

/// What the arrays of the minimization and of the orientation take at their peak.
/// \tparam FT the number type of the solver
/// \param bytes_of_input what the points take, which are released before the minimization of LOR
/// and ALOR
/// \param has_hints whether there is a hint for each sample
template <typename FT>
double bytes_at_peak(const Plan& plan, double bytes_of_input, const Expected_samples& samples,
                     bool has_hints, std::size_t bytes_of_solver)
{
  const double m = double(samples.size), index = sizeof(Index), place = sizeof(Vector),
               number = sizeof(FT), offset = sizeof(std::size_t);
  const double hint = has_hints ? 3 * number : 0,
               refined = plan.refines ? 4 * number + 1 + (plan.follows_scales ? sizeof(float) : 0)
                                          + (plan.keeps_spacings ? sizeof(float) : 0)
                                          + (plan.finds_deviations ? 2 * sizeof(float) : 0)
                                      : 0;
  const double of_samples = (2 * place + 4 * number + hint + refined) * m
                            + double(samples.other_bytes);

  const auto of_finding = [&](const Counted_neighbors& neighbors) {
    return (offset + index) * m + index * double(neighbors.maximum_number_held);
  };
  const double pairs = double(samples.self.listed), of_lists = offset * m + index * pairs,
               of_step = 12 * number * m + number * pairs, // see `Minimization_step`
    of_solving = of_lists + of_step + double(bytes_of_solver) * m;
  double of_minimization;
  if (plan.refines)
  {
    // From the second turn on, the arrays of a step are there while its neighbors are found.
    of_minimization = bytes_of_input
                      + (std::max)(of_step + of_finding(samples.self), of_solving + place * m);
    if (samples.others.listed > 0)
      of_minimization = (std::max)(of_minimization, bytes_of_input + of_lists + of_step + place * m
                                                      + of_finding(samples.others));
  }
  else
    of_minimization = (std::max)(index * m + of_finding(samples.self), of_solving);

  // Of the k neighbors of a sample, at least every second is an edge that the other one does not
  // list too: where each of two lists the other it is no more.
  const double k = (std::min)(double(plan.number_of_orientation_neighbors), m - 1),
               of_orientation = ((k + 1) * index + 0.5 * k * sizeof(Edge)) * m;
  const double of_refinement = plan.refines && plan.has_disks_enough()
                                 ? bytes_of_input
                                     + double(Refinement<Sequential_tag>::bytes_of_sample) * m
                                 : 0;
  return of_samples + (std::max)({of_minimization, of_orientation, of_refinement});
}

/// The share of the expected peak that a call needs for sure: the expectation is up to a tenth too
/// high, as the neighbors of the start and the edges of the graph are not those of the end.
constexpr double share_of_expected_memory = 0.91;

/*!
Refuses a limit of memory that will not do, before most of the work is done. How much a call takes
depends on how many neighbors its samples have. This places the samples as the call will, but for
the normals, which are not known yet, and counts. It does nothing where there is no limit.

\tparam FT the number type of the solver
\param plan without the spacing that the areas tell
\param given_normals, hints of the points, as far as there are any; released before the minimization
\param bytes_of_solver for each sample
\param areas_of called with the plan; finds the areas of the points
\param input points without weights, all with the same normal

\throws std::bad_alloc if the limit is below what the call takes for sure
*/
template <typename ConcurrencyTag, typename FT, typename AreasOf>
void refuse_too_little_memory(Plan plan, const Buffer<Local_vector>& given_normals,
                              const Buffer<Local_vector>& hints, std::size_t bytes_of_solver,
                              const AreasOf& areas_of, Progress& progress,
                              const Prepared_points& input)
{
  const Memory_counter* const memory = input.points.get_allocator().counter;
  if (!memory || memory->limit() == (std::numeric_limits<std::size_t>::max)())
    return;
  progress.begin_stage("estimate memory", 0, 1);
  const std::size_t n = input.points.size(), m = plan.number_of_samples;
  const double bytes_of_input =
    double(memory->current()) - double((given_normals.size() + hints.size()) * sizeof(Local_vector))
    + double(n * sizeof(Local));
  Expected_samples expected;
  {
    Areas areas{Buffer<std::uint64_t>(input.points.get_allocator()), 0};
    if (plan.uses_areas)
    {
      areas = areas_of(plan);
      plan.set_sample_spacing(std::sqrt(areas.total() / double(m)));
    }
    Facts_of_cloud facts; // it is enough to know about how many they are
    Placed_samples placed = place_samples<ConcurrencyTag>(
      plan, input, areas, facts, choose_sources(plan, input, areas, facts), progress);
    Buffer<float> scales = listed_scales(input.grid.scales(), placed.start.sources);
    expected = count_neighbors<ConcurrencyTag>(plan, input.grid.cell_size(), placed.start.positions,
                                               scales, placed.spreading_radii, progress);
  }
  if (expected.size < m) // those that follow, and where each of the others has stood
    expected.other_bytes += (m - expected.size) * (sizeof(Index) + sizeof(Vector))
                            + 2 * expected.size * sizeof(Index);
  if (share_of_expected_memory
        * bytes_at_peak<FT>(plan, bytes_of_input, expected, !hints.empty(), bytes_of_solver)
      > double(memory->limit()))
    throw std::bad_alloc();
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_EXPECTED_MEMORY_H
