// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "driver/Cuda_backend.cuh"

#include <CGAL/L0_resampling/internal/kernels/share_of_extent.h>

#include <algorithm>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

Iteration iteration_report(const Minimization_parameters& p, const Turn& turn,
                           std::size_t number_of_pairs, const Turn_result& result)
{
  const double unit = 1 / p.squared_radius;
  return {turn.penalty,
          result.fit_energy * unit,
          result.regularization_energy * unit,
          turn.penalty * result.squared_normal_misfit * unit,
          p.normal_weight * square(p.sparsity_unit) * double(result.number_of_active_pairs) * unit,
          number_of_pairs ? double(result.number_of_active_pairs) / double(number_of_pairs) : 0,
          result.relative_residual,
          result.solver_iterations,
          turn.regularizes,
          bool(result.converged)};
}

} // namespace

void Cuda_backend::begin(const Plan& plan)
{
  m_input.positions.frame = m_box.frame;
  m_turns = plan.minimization.turns();
  m_results.resize(m_turns.size());
  m_turn_results = m_session.arena.take<Turn_result>(m_results.size());
  m_counts = m_session.arena.take<Sample_counts>(1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(m_counts, 0, sizeof(Sample_counts), m_session.stream));
  m_samples = take_samples(m_session.arena, m_number_of_samples,
                           {plan.refines, m_input.positions.scales != nullptr, plan.keeps_spacings,
                            m_session.hints != nullptr, m_session.points_in_cloud != nullptr,
                            plan.finds_noises, plan.finds_deviations});
  m_points_scope.emplace(m_session.arena);
}

// The points

/// Takes the normals and hints of the points of the session that the positions list.
void Cuda_backend::take_vectors_of_list()
{
  const Positions& positions = m_input.positions;
  const auto taken = [&](const float* vectors) {
    float* const listed = m_context.arena.take<float>(3 * std::size_t(positions.size));
    take_listed(m_context, vectors, positions.list, positions.size, listed);
    return listed;
  };
  if (m_session.normals)
  {
    m_input.normals = taken(m_session.normals);
    m_input.all_normals_given = m_session.all_normals_given
                                || !has_zero(m_context, m_input.normals, positions.size);
  }
  if (m_session.hints)
    m_input.hints = taken(m_session.hints);
}

void Cuda_backend::drop_outliers(const Plan& plan)
{
  unsigned* const kept = m_context.arena.take<unsigned>(m_session.size);
  const unsigned number_of_outliers =
    find_outliers(m_context, m_input.positions, m_box.low, m_box.high, plan.radius, plan.extent,
                  Outlier_thresholds(plan.outlier_sensitivity), kept);
  m_report.number_of_outliers = number_of_outliers;
  if (number_of_outliers == 0)
    return;
  if (m_parameters.with_outliers)
    list_outliers(kept, number_of_outliers);
  m_input.positions.size -= number_of_outliers;
  m_input.positions.list = kept;
  take_vectors_of_list();
}

/// Lists them in the session.
/// \param kept the other points, ascending, on the device
void Cuda_backend::list_outliers(const unsigned* kept, unsigned number_of_outliers)
{
  std::vector<unsigned> others(m_session.size - number_of_outliers);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(others.data(), kept, others.size() * sizeof(unsigned),
                                     cudaMemcpyDeviceToHost, m_context.stream));
  CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(m_context.stream));
  m_session.outliers.reserve(number_of_outliers);
  auto other = others.begin();
  for (unsigned i = 0; i < m_session.size; ++i)
    if (other != others.end() && *other == i)
      ++other;
    else
      m_session.outliers.push_back(i);
}

void Cuda_backend::build_grid_of_points(const Plan& plan)
{
  m_grid = build_grid(m_input.positions, m_input.normals,
                      Cell_frame::around(m_box.low, m_box.high, plan.cell_size,
                                         plan.longest_query(), m_input.positions.scales),
                      m_context.arena, m_context.scratch, m_context.scratch, m_context.stream);
}

Cell_blocks Cuda_backend::blocks_of_points(const Plan& plan, double radius) const
{
  return find_blocks(m_grid, m_grid, cells_in_reach(radius, plan.cell_size),
                     maximum_number_of_candidates, m_context.scratch, m_context.stream);
}

void Cuda_backend::sort_points(const Plan& plan)
{
  m_order_scope.emplace(m_context.scratch);
  build_grid_of_points(plan);
  m_report.number_of_distinct_points = m_grid.number_of_distinct;
  unsigned number_of_kept;
  if (const unsigned* const kept = thin_crowds(m_context, m_input.positions, m_grid, number_of_kept,
                                               m_numbers_of_points))
  {
    m_input.positions.size = number_of_kept;
    m_input.positions.list = kept;
    take_vectors_of_list();
    build_grid_of_points(plan);
  }
  m_normals = m_context.arena.take<float4>(m_grid.size);

  m_filter.emplace(m_context, m_normals, m_grid.size);
  m_filter->blocks = blocks_of_points(plan, plan.filter_radius);
  // so that the last pass writes where they are to be
  if ((plan.number_of_filter_passes + plan.number_of_refits) % 2 != 0)
    std::swap(m_filter->normals, m_filter->filtered);
}

void Cuda_backend::estimate_pca_normals(const Plan& plan, const unsigned* numbers_of_points)
{
  const bool shares_blocks = cells_in_reach(plan.pca_radius, plan.cell_size)
                             == cells_in_reach(plan.filter_radius, plan.cell_size);
  m_report.number_of_degenerate_neighborhoods = cuda::estimate_pca_normals(
    m_context, m_input.positions, m_grid,
    shares_blocks ? m_filter->blocks : blocks_of_points(plan, plan.pca_radius), plan.pca_radius,
    plan.looks_beyond_strips, numbers_of_points, m_filter->normals);
}

void Cuda_backend::take_given_normals()
{
  if (m_input.normals)
    cuda::take_given_normals(m_context, m_grid, m_input.normals, m_filter->normals);
}

void Cuda_backend::refit_normals(const Plan& plan)
{
  cuda::refit_normals(m_context, m_grid, m_filter->blocks, plan.kernel_of_points(),
                      m_filter->normals, m_filter->filtered);
  std::swap(m_filter->normals, m_filter->filtered);
}

void Cuda_backend::filter_normals(const Plan& plan, std::size_t pass)
{
  const bool is_last = pass + 1 == plan.number_of_filter_passes;
  cuda::filter_normals(m_context, m_grid, m_filter->blocks, plan.filter_radius,
                       float(plan.squared_bandwidth), float(plan.normal_bandwidth),
                       m_filter->normals, m_filter->filtered,
                       is_last ? m_filter->ball_counts.address() : nullptr);
  std::swap(m_filter->normals, m_filter->filtered);
}

void Cuda_backend::weigh_density(const Plan& plan, double known_mean)
{
  const Device_counter<Ball_counts>& counts = m_filter->ball_counts;
  if (plan.number_of_filter_passes == 0)
    sum_up_input_density(m_context, m_grid, m_filter->blocks, plan.filter_radius,
                         float(plan.squared_bandwidth), m_normals, counts.address());
  invert_input_density(m_context, m_grid.size, plan.weighs_density ? counts.address() : nullptr,
                       known_mean, m_normals);
  if (m_input.all_normals_given)
    m_report.number_of_degenerate_neighborhoods = counts.read().sparse;
  m_filter.reset();
}

// The first samples

double Cuda_backend::total_area(const Plan& plan)
{
  m_areas_scope.emplace(m_context.arena);
  m_areas = areas_of_points(m_context, m_grid, plan.area_radius(), m_samples.size);
  return m_areas.total;
}

void Cuda_backend::choose_samples(const Plan& plan, const Known_starts* known)
{
  const Sources_of_samples sources = {m_normals,
                                      plan.uses_areas ? &m_areas : nullptr,
                                      plan.starts_evenly,
                                      m_input.hints,
                                      plan.spreading_radius(),
                                      known};
  initialize_samples(m_context, m_input.positions, m_grid, sources, plan.radius,
                     plan.isolated_radius, plan.sample_spacing, plan.random_seed, m_samples);
  m_areas_scope.reset();
  m_grid.forget_order();
  m_order_scope.reset();
  m_followers = take_followers(m_context, self_frame(plan, plan.self_cell_size()), m_samples);
}

/// \param scales of the samples, for cells that follow them; null for cells of one size
Positions Cuda_backend::sample_positions(const float* scales) const
{
  return {m_samples.positions, m_samples.size, Frame(), true, nullptr, scales};
}

// Algorithm 1

void Cuda_backend::collapse_fit_term(const Plan& plan)
{
  const Arena_scope scope(m_context.arena);
  const Cell_grid sample_grid = build_grid(sample_positions(nullptr), nullptr, m_grid.frame,
                                           m_context.arena, m_context.scratch, m_context.stream);
  const Cell_blocks blocks =
    find_blocks(sample_grid, m_grid, cells_in_reach(plan.radius, plan.cell_size),
                maximum_number_of_candidates, m_context.arena, m_context.stream);
  cuda::collapse_fit_term(m_context, sample_grid, blocks, m_grid, m_normals, plan.radius, m_samples,
                          m_followers.numbers_of_samples, m_counts);
}

/// Of the self neighbors, and of the samples that repel each other.
double Cuda_backend::maximum_range(const Plan& plan) const
{
  return spreads_wider(plan) ? plan.spreading_radius() : plan.self_neighbor_radius;
}

/// Whether the cells of the points serve the search of neighbors too.
bool Cuda_backend::is_one_grid_enough(const Plan& plan) const
{
  return !m_samples.scales && !m_samples.spreading_radii
         && plan.are_cells_shared(maximum_range(plan));
}

Cell_frame Cuda_backend::self_frame(const Plan& plan, double cell_size) const
{
  return Cell_frame::around(m_box.low, m_box.high, cell_size, maximum_range(plan),
                            m_samples.spreading_radii);
}

void Cuda_backend::sort_samples(const Plan& plan)
{
  m_neighborhood.reset();
  m_neighborhood.emplace(m_context.arena);
  Cell_grid& points = m_neighborhood->points;
  points.size = m_samples.size;
  points.frame = is_one_grid_enough(plan)
                   ? m_grid.frame
                   : self_frame(plan, plan.sample_cell_size(spreads_wider(plan)));
  points.points = m_context.arena.take<int4>(points.size);

  m_sample_grid_scope.emplace(m_context.scratch);
  const Arena_scope order_scope(m_context.arena);
  m_sample_grid = build_grid(sample_positions(m_samples.spreading_radii), nullptr, points.frame,
                             m_context.scratch, m_context.arena, m_context.arena, m_context.stream);
  reorder(m_context, m_sample_grid.order, m_samples);
  m_sample_grid.forget_order();
}

void Cuda_backend::find_self_neighbors(const Plan& plan)
{
  Neighborhood& result = *m_neighborhood;
  const Cell_grid& grid = m_sample_grid;
  const auto copy = [&](int4* to, const int4* from) {
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(to, from, grid.size * sizeof(int4), cudaMemcpyDeviceToDevice,
                                       m_context.stream));
  };
  const auto find_neighbors = [&](double radius, const float* scales) {
    return cuda::find_self_neighbors(m_context, grid,
                                     {float(radius), scales, m_samples.spreading_radii});
  };
  if (plan.refines)
    result.places = m_context.arena.take<int4>(grid.size);
  if (spreads_wider(plan))
  {
    copy(result.points.points, grid.points);
    result.spreading = find_neighbors(plan.spreading_radius(), nullptr);
    copy(result.places, grid.points);
    copy(grid.points, result.points.points); // with their cells again
  }
  result.neighbors = find_neighbors(plan.self_neighbor_radius, m_samples.scales);
  copy(result.points.points, grid.points);
  if (plan.refines && !spreads_wider(plan))
  {
    copy(result.places, grid.points);
    result.spreading = result.neighbors;
  }
  m_report.number_of_self_neighbor_pairs = result.neighbors.number_of_pairs;
  m_sample_grid_scope.reset();
}

void Cuda_backend::minimize_once(const Plan& plan, const Turn& turn)
{
  m_numbers_of_pairs.push_back(m_neighborhood->neighbors.number_of_pairs);
  const Arena_scope scope(m_context.scratch);
  const Turn_arrays arrays = take_turn_arrays(m_context, m_samples.size);
  Turn_result* const result = m_turn_results + turn.number;
  cuda::minimize_once(m_context, plan.minimization, turn, m_neighborhood->neighbors,
                      m_neighborhood->points, m_samples, arrays,
                      turn.number > 0 ? result - 1 : nullptr, result);
}

// Algorithm 1 of the default method

void Cuda_backend::fit_compatible_points(const Plan& plan, bool is_last)
{
  const Arena_scope scope(m_context.arena), scratch_scope(m_context.scratch);
  Outcomes_of_fit outcomes;
  if (is_last)
    outcomes = {m_counts, m_context.scratch.take<unsigned char>(m_samples.size)};
  const auto fit = [&](const Cell_grid& sample_grid, bool is_in_order) {
    const Cell_blocks blocks =
      find_blocks(sample_grid, m_grid, cells_in_reach(plan.radius, plan.cell_size),
                  maximum_number_of_candidates, m_context.arena, m_context.stream);
    cuda::fit_compatible_points(m_context, sample_grid, is_in_order, blocks, m_grid, m_normals,
                                plan.kernel_of_fit(), m_samples, outcomes);
  };
  if (m_sample_grid_scope && is_one_grid_enough(plan))
    fit(m_sample_grid, true);
  else
    fit(build_grid(m_samples.in_frame(), nullptr, m_grid.frame, m_context.arena, m_context.scratch,
                   m_context.stream),
        false);
  if (is_last)
    report_unexplained_place(plan, outcomes.are_unexplained);
}

/// \param are_unexplained of the samples
void Cuda_backend::report_unexplained_place(const Plan& plan, const unsigned char* are_unexplained)
{
  const double radius = unexplained_radius_factor * plan.radius;
  const Crowded_sample found = most_crowded_sample(m_context, m_samples, are_unexplained, m_box.low,
                                                   m_box.high, radius);
  m_report.number_of_unexplained_samples_there = found.number_of_samples;
  if (found.number_of_samples == 0)
    return;
  for (int axis = 0; axis < 3; ++axis)
    m_report.unexplained_center[axis] = m_box.frame.leave(found.position[axis], axis);
  m_report.unexplained_radius = m_box.frame.length_of_input(radius);
}

void Cuda_backend::repel_tangentially(const Plan& plan, std::size_t number_of_steps)
{
  cuda::repel_tangentially(m_context, m_neighborhood->points, m_neighborhood->spreading,
                           m_neighborhood->places, maximum_range(plan), plan.sample_spacing,
                           plan.radius, number_of_steps, m_samples);
}

// The end

void Cuda_backend::orient_normals(const Plan& plan)
{
  if (plan.refines)
    sort_by_places(m_context, m_box.low, m_box.high, plan.cell_size_of_places(), m_samples,
                   nullptr);
  cuda::orient_normals(m_context, m_box.low, m_box.high,
                       unsigned(plan.number_of_orientation_neighbors), plan.sample_spacing,
                       side_hints(), m_samples, m_counts);
}

void Cuda_backend::project_to_local_quadrics(const Plan& plan)
{
  const Fit_kernel<double> kernel = plan.kernel_of_wide_balls();
  const double cell_size = (std::max)(kernel.radius / 2, plan.minimum_cell_size);
  cuda::project_to_local_quadrics(m_context,
                                  Cell_frame::around(m_box.low, m_box.high, cell_size,
                                                     kernel.radius, m_samples.scales),
                                  kernel, m_samples);
}

// The refinement

void Cuda_backend::begin_deviations(const Plan& plan)
{
  cuda::begin_deviations(m_context, plan.lengths_of_refinement(), m_samples);
}

/// From here on, copies of the samples are worked on, which are sorted.
void Cuda_backend::begin_refinement()
{
  m_refined_scope.emplace(m_context.arena);
  m_samples_before = m_samples;
  m_samples = samples_to_refine(m_context, m_samples_before);
}

void Cuda_backend::spread_samples(const Plan& plan)
{
  m_refinement.reset();
  sort_samples(plan);
  find_self_neighbors(plan);
  repel_tangentially(plan, number_of_repulsion_steps_of_refinement);
  release_neighbors();
}

void Cuda_backend::begin_round(const Plan& plan)
{
  m_refinement.emplace(m_context, plan.lengths_of_refinement(), m_box, plan.minimum_cell_size,
                       m_grid.frame, m_samples);
}

void Cuda_backend::split_sheets(const Plan& plan)
{
  begin_round(plan);
  m_refinement->split_sheets(m_input.positions, m_grid,
                             m_parameters.has_viewpoint || m_samples_before.hints);
}

void Cuda_backend::share_points(const Plan& plan)
{
  begin_round(plan);
  m_refinement->share_points(m_input.positions, m_grid);
}

void Cuda_backend::end_refinement()
{
  m_refinement.reset();
  put_back(m_context, m_samples, m_samples_before);
  m_samples = m_samples_before;
  m_refined_scope.reset();
}

// The result

void Cuda_backend::append_followers()
{
  m_number_of_leaders = m_samples.size;
  cuda::append_followers(m_context, m_followers, m_samples);
}

void Cuda_backend::measure_extent(const Plan& plan)
{
  double result_extent[3], input_extent[3];
  find_plain_extent(m_context, m_samples.positions, m_samples.size, result_extent);
  for (int axis = 0; axis < 3; ++axis)
    input_extent[axis] = m_session.extent.trimmed[axis] / plan.unit;
  m_report.extent_share = share_of_extent(input_extent, plan.noise, result_extent,
                                          plan.sample_spacing);
}

void Cuda_backend::end(const Plan& plan)
{
  // not before: the device would have nothing to do while the host takes them
  const Sample_counts* const counts = m_session.scratch.fetch(m_counts, m_session.stream);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(m_results.data(), m_turn_results,
                                     m_results.size() * sizeof(Turn_result), cudaMemcpyDeviceToHost,
                                     m_session.stream));
  m_stages.end();
  m_report.number_of_lonely_samples = counts->lonely;
  m_report.number_of_unexplained_samples = counts->unexplained;
  note_sides(*counts, m_number_of_leaders);

  m_session.iterations.clear();
  for (const Turn& turn : m_turns)
  {
    const Turn_result& result = m_results[turn.number];
    if (!result.is_finite)
      throw Failure(Status::NOT_FINITE,
                    "The quadratic problem or its initial guess has values that are not finite.");
    m_session.iterations.push_back(
      iteration_report(plan.minimization, turn, m_numbers_of_pairs[turn.number], result));
  }
  m_report.iterations = m_session.iterations.data();
  m_report.number_of_iterations = m_session.iterations.size();
  m_session.positions = m_samples.positions;
  m_session.sample_normals = reinterpret_cast<float*>(m_samples.fit);
  m_session.side_confidences = m_samples.side_confidences;
  m_session.sample_scales = m_samples.scales;
  m_session.sample_noises = m_samples.noises;
  m_session.position_deviations = m_samples.position_deviations;
  m_session.normal_deviations = m_samples.normal_deviations;
  m_session.number_of_samples = m_number_of_samples;
  m_session.trees = m_samples.trees;
  m_session.are_own = m_samples.are_own;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
