// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Session.cuh"
#include "orientation.cuh"
#include "plan_and_scale.cuh"

#include <CGAL/L0_resampling/internal/share_of_extent.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

Iteration iteration_report(const Parameters& parameters,
                           const Minimization_parameters& minimization, double penalty,
                           bool regularized, std::size_t number_of_pairs, const Turn_result& result)
{
  const double unit = 1 / minimization.squared_radius;
  return {penalty,
          result.fit_energy * unit,
          result.regularization_energy * unit,
          penalty * result.squared_normal_misfit * unit,
          parameters.normal_weight * square(minimization.sparsity_unit)
            * double(result.number_of_active_pairs) * unit,
          number_of_pairs ? double(result.number_of_active_pairs) / double(number_of_pairs) : 0,
          result.relative_residual,
          result.solver_iterations,
          regularized,
          bool(result.converged)};
}

/// Bytes for n points and m samples with as many neighbors as is usual; what is missing is added on
/// the way, once.
std::size_t estimate_memory(std::size_t n, std::size_t m, const Parameters& parameters,
                            bool has_hints)
{
  const bool is_default = parameters.method == Method::DEFAULT;
  const std::size_t slack = (std::size_t(1) << 20) + (is_default ? 4 * n : 0), // and the scales
    of_outliers = parameters.drop_outliers ? 4 * n : 0;
  // positions, normals and fit; what the default method adds; and what parameters ask for
  const std::size_t of_samples = (56 + (is_default ? 11 : 0)
                                  + (is_default && parameters.keep_density ? 4 : 0)
                                  + (has_hints ? 16 : 0))
                                 * m;
  // points with their cells, and normals; and their order before
  const std::size_t of_points = of_outliers + 18 * n + 16 * n + (is_default ? 4 * n : 0),
                    of_order = 5 * n;
  const std::size_t of_sorting = of_outliers + 24 * n + 76 * n;
  const std::size_t of_filtering = of_points + of_order + 16 * n + (is_default ? 20 : 10) * n;
  const std::size_t of_start = of_points + of_order + 24 * n + 16 * m + (has_hints ? 12 * n : 0);
  const std::size_t of_sample_grid = 19 * m;
  const std::size_t of_neighbors = is_default ? 80 * m : 64 * m;
  const std::size_t of_sorting_samples = (is_default ? of_points : 0) + of_sample_grid + 5 * m
                                         + 76 * m;
  const std::size_t of_fit = of_points + of_sample_grid + 15 * m;
  const std::size_t of_minimization = (is_default ? of_points + 16 * m : 0) + 16 * m + of_neighbors
                                      + 76 * m;
  const std::size_t of_quadrics = 2 * of_sample_grid + 20 * m + 76 * m;
  const std::size_t k = parameters.number_of_orientation_neighbors;
  const std::size_t of_orientation = // votes and the field, or grades of the edges
    4 * k * m + (std::max)(118 * m + bytes_of_field, 2 * k * m + 16 * m);
  return slack + of_samples
         + (std::max)({of_sorting, of_filtering, of_start, of_sorting_samples, of_fit,
                       of_minimization, of_quadrics, of_orientation});
}

/// What a call carries from stage to stage.
struct Call
{
  const Parameters& parameters;
  Workplace workplace;
  Stages& stages;
  Call_report& report;
  Framed_box box;
  Plan plan;
  std::vector<double> penalties;
  Turn_result* turn_results;                 // on the device, one for each penalty
  Sample_counts* counts;                     // on the device
  std::vector<std::size_t> numbers_of_pairs; // of self neighbors, one for each penalty
  Samples samples;
  Followers followers;

  const Turn_result* last_turn_result(std::size_t turn) const
  {
    return turn > 0 ? turn_results + turn - 1 : nullptr;
  }

  /// \param scales of the samples, for cells that follow them; null for cells of one size
  Positions sample_positions(const float* scales = nullptr) const
  {
    return {samples.positions, samples.size, Frame(), true, nullptr, scales};
  }

  /// Sorts the samples into cells, and puts them in that order; that before is forgotten.
  /// \param arena takes the arrays of the grid
  Cell_grid sort_samples(const Cell_frame& frame, Device_arena& arena, Device_arena& scratch)
  {
    const Arena_scope order_scope(scratch);
    Cell_grid grid = build_grid(sample_positions(), nullptr, frame, arena, scratch, scratch,
                                workplace.stream);
    reorder(workplace, grid.order, samples);
    grid.forget_order();
    return grid;
  }

  Cell_frame self_frame(double cell_size) const
  {
    return Cell_frame::around(box.low, box.high, cell_size, largest_range());
  }

  /// Whether other samples repel each other than those that the energy couples.
  bool spreads_wider() const { return plan.refines && samples.scales; }

  /// Of the self neighbors, and of the samples that repel each other.
  double largest_range() const
  {
    return spreads_wider() ? plan.spreading_radius() : plan.self_neighbor_radius;
  }
};

/// The points of the session that a call works with.
struct Input
{
  Positions positions;  // with their scales
  const float* normals; // of them; null if none were given
  bool all_normals_given;
  const float* hints; // of them; null if none were given
};

/// Takes the normals and hints of the points of the session that the positions list.
void take_vectors_of_list(Call& call, const Session& session, Input& input)
{
  const Workplace& workplace = call.workplace;
  const auto taken = [&](const float* vectors) {
    float* const listed = workplace.arena.take<float>(3 * std::size_t(input.positions.size));
    take_listed(workplace, vectors, input.positions.list, input.positions.size, listed);
    return listed;
  };
  if (session.normals)
  {
    input.normals = taken(session.normals);
    input.all_normals_given = session.all_normals_given
                              || !has_zero(workplace, input.normals, input.positions.size);
  }
  if (session.hints)
    input.hints = taken(session.hints);
}

/// Leaves outliers out, if that is asked for.
/// \param scales of the points; null if all are 1
Input filter_input(Session& session, Call& call, const float* scales)
{
  const Workplace& workplace = call.workplace;
  const Plan& plan = call.plan;
  Input input = {{session.points, session.size, call.box.frame, false, nullptr, scales},
                 session.normals,
                 session.all_normals_given,
                 session.hints};
  if (!plan.drops_outliers)
    return input;
  call.stages.begin("find outliers", 0.05);
  unsigned* const kept = workplace.arena.take<unsigned>(session.size);
  const unsigned number_of_outliers = find_outliers(workplace, input.positions, call.box.low,
                                                    call.box.high, plan.radius, kept);
  call.report.number_of_outliers = number_of_outliers;
  if (number_of_outliers > 0)
  {
    input.positions.size -= number_of_outliers;
    input.positions.list = kept;
    take_vectors_of_list(call, session, input);
  }
  call.stages.begin("sort points", 0.05);
  return input;
}

/// The input points with all that the stages find out about them.
struct Prepared_points
{
  Cell_grid grid;
  float4* normals; // filtered, and 1/v_j
};

/// Section 3.1 and Eq. (5): normals and density weights of the input. What their grid tells of
/// their order before is in the scratch arena.
/// \param input loses the points that are not kept of crowds
Prepared_points prepare_points(Session& session, Call& call, Input& input)
{
  const Workplace& workplace = call.workplace;
  const Plan& plan = call.plan;
  Prepared_points points;
  const auto sort_points = [&]() {
    points.grid = build_grid(input.positions, input.normals,
                             Cell_frame::around(call.box.low, call.box.high, plan.cell_size,
                                                plan.longest_query(), input.positions.scales),
                             workplace.arena, workplace.scratch, workplace.scratch,
                             workplace.stream);
  };
  sort_points();
  call.report.number_of_distinct_points = points.grid.number_of_distinct;
  unsigned number_of_kept;
  const unsigned* numbers_of_points;
  if (const unsigned* const kept = thin_crowds(workplace, input.positions, points.grid,
                                               number_of_kept, numbers_of_points))
  {
    input.positions.size = number_of_kept;
    input.positions.list = kept;
    take_vectors_of_list(call, session, input);
    sort_points();
  }
  points.normals = workplace.arena.take<float4>(points.grid.size);

  const Arena_scope scope(workplace.scratch);
  float4 *normals = points.normals, *filtered = workplace.scratch.take<float4>(points.grid.size);
  const auto blocks_for_radius = [&](double radius) {
    return find_blocks(points.grid, points.grid, cells_in_reach(radius, plan.cell_size),
                       maximum_number_of_candidates, workplace.scratch, workplace.stream);
  };
  const Device_counter<Ball_counts> ball_counts(workplace);
  const Cell_blocks filter_blocks = blocks_for_radius(plan.filter_radius);
  const std::size_t number_of_passes = plan.number_of_filter_passes,
                    number_of_refits = plan.number_of_refits;
  if ((number_of_passes + number_of_refits) % 2
      != 0) // so that the last pass writes where they are to be
    std::swap(normals, filtered);
  if (!input.all_normals_given)
  {
    call.stages.begin("PCA normals", 0.1);
    const bool shares_blocks = cells_in_reach(plan.pca_radius, plan.cell_size)
                               == cells_in_reach(plan.filter_radius, plan.cell_size);
    call.report.number_of_degenerate_neighborhoods =
      estimate_pca_normals(workplace, input.positions, points.grid,
                           shares_blocks ? filter_blocks : blocks_for_radius(plan.pca_radius),
                           plan.pca_radius, numbers_of_points, normals);
  }
  if (input.normals)
    take_given_normals(workplace, points.grid, input.normals, normals);

  call.stages.begin("filter normals", 0.4);
  const float squared_bandwidth = float(plan.squared_bandwidth);
  for (std::size_t i = 0; i < number_of_passes; ++i)
  {
    if (i + number_of_refits >= number_of_passes)
    {
      refit_normals(workplace, points.grid, filter_blocks, plan.filter_radius, squared_bandwidth,
                    float(plan.compatible_bandwidth), float(square(plan.sheet_height)), normals,
                    filtered);
      std::swap(normals, filtered);
    }
    const bool is_last = i + 1 == number_of_passes;
    filter_normals(workplace, points.grid, filter_blocks, plan.filter_radius, squared_bandwidth,
                   float(plan.normal_bandwidth), normals, filtered,
                   is_last ? ball_counts.address() : nullptr);
    std::swap(normals, filtered);
    call.stages.ask(double(i + 1) / double(number_of_passes));
  }

  call.stages.begin("density weights", 0.08);
  if (number_of_passes == 0)
    sum_up_input_density(workplace, points.grid, filter_blocks, plan.filter_radius,
                         squared_bandwidth, points.normals, ball_counts.address());
  invert_input_density(workplace, points.grid.size,
                       plan.weighs_density ? ball_counts.address() : nullptr, points.normals);
  if (input.all_normals_given)
    call.report.number_of_degenerate_neighborhoods = ball_counts.read().sparse;
  return points;
}

/// Section 3.2: the first S. The default method spreads it by area, which tells its spacing.
void choose_samples(Call& call, const Input& input, const Prepared_points& points)
{
  const Workplace& workplace = call.workplace;
  Plan& plan = call.plan;
  call.stages.begin("initial samples", 0.02);
  const Arena_scope scope(workplace.arena);
  Areas areas;
  if (plan.uses_areas)
  {
    areas = areas_of_points(workplace, points.grid, plan.area_radius(), call.samples.size);
    plan.set_sample_spacing(std::sqrt(areas.total / double(call.samples.size)));
  }
  const Sources_of_samples sources = {points.normals, plan.uses_areas ? &areas : nullptr,
                                      plan.starts_evenly, input.hints};
  initialize_samples(workplace, input.positions, points.grid, sources, plan.radius,
                     plan.sample_spacing, call.parameters.random_seed, call.samples);
}

/// Section 3.2: the fit term of LOR and ALOR, collapsed.
void fit_to_all_points(Call& call, const Prepared_points& points)
{
  const Workplace& workplace = call.workplace;
  call.stages.begin("original neighbors", 0.1);
  const Arena_scope scope(workplace.arena);
  const Cell_grid sample_grid = build_grid(call.sample_positions(), nullptr, points.grid.frame,
                                           workplace.arena, workplace.scratch, workplace.stream);
  const Cell_blocks blocks =
    find_blocks(sample_grid, points.grid, cells_in_reach(call.plan.radius, call.plan.cell_size),
                maximum_number_of_candidates, workplace.arena, workplace.stream);
  collapse_fit_term(workplace, sample_grid, blocks, points.grid, points.normals, call.plan.radius,
                    call.samples, call.followers.numbers_of_samples, call.counts);
}

/// The samples in the order of their grid, of which only the points are needed any further, and
/// their self neighbors.
struct Neighborhood
{
  Cell_grid points;
  Neighbor_lists neighbors;
  int4* places = nullptr; // as the points, for the neighbors that repel each other; if any do
  Neighbor_lists spreading;
};

/// Takes the arrays from the arena.
/// \param use_grid called with the grid of the samples as long as it is there
template <typename F>
Neighborhood find_neighborhood(Call& call, const Cell_frame& frame, const F& use_grid)
{
  const Workplace& workplace = call.workplace;
  Neighborhood result;
  result.points.size = call.samples.size;
  result.points.frame = frame;
  result.points.points = workplace.arena.take<int4>(result.points.size);
  const Arena_scope grid_scope(workplace.scratch);
  const Cell_grid grid = call.sort_samples(frame, workplace.scratch, workplace.arena);
  use_grid(grid);
  const std::size_t bytes = grid.size * sizeof(int4);
  const auto copy = [&](int4* to, const int4* from) {
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, workplace.stream));
  };
  const auto find_neighbors = [&](double radius, const float* scales) {
    return find_self_neighbors(workplace, grid, radius, scales);
  };
  const float* const scales = call.samples.scales;
  if (call.plan.refines)
    result.places = workplace.arena.take<int4>(grid.size);
  if (call.spreads_wider())
  {
    copy(result.points.points, grid.points);
    result.spreading = find_neighbors(call.plan.spreading_radius(), nullptr);
    copy(result.places, grid.points);
    copy(grid.points, result.points.points); // with their cells again
  }
  result.neighbors = find_neighbors(call.plan.self_neighbor_radius, scales);
  copy(result.points.points, grid.points);
  if (call.plan.refines && !call.spreads_wider())
  {
    copy(result.places, grid.points);
    result.spreading = result.neighbors;
  }
  call.report.number_of_self_neighbor_pairs = result.neighbors.number_of_pairs;
  return result;
}

/// Section 3.3: Algorithm 1, with the self neighbors of the start.
void minimize_alternatingly(Call& call)
{
  const Workplace& workplace = call.workplace;
  call.stages.begin("self neighbors", 0.03);
  const Arena_scope arena_scope(workplace.arena);
  const Cell_frame frame = call.self_frame(call.plan.self_cell_size());
  const auto [points, neighbors, places, spreading] = find_neighborhood(call, frame,
                                                                        [](const Cell_grid&) {});
  call.numbers_of_pairs.assign(call.penalties.size(), neighbors.number_of_pairs);

  call.stages.begin("L0 minimization", 0.12);
  const Arena_scope scope(workplace.scratch);
  const Turn_arrays arrays = take_turn_arrays(workplace, call.samples.size);
  for (std::size_t i = 0; i < call.penalties.size(); ++i)
  {
    minimize_once(workplace, call.plan.minimization, call.penalties[i],
                  call.plan.minimization.regularizes(i), neighbors, points, call.samples, arrays,
                  call.last_turn_result(i), call.turn_results + i);
    call.stages.ask(double(i + 1) / double(call.penalties.size()));
  }
}

/// Algorithm 1 as the default method runs it, see `minimize_with_refinement()` on the CPU.
void minimize_with_refinement(Call& call, const Prepared_points& points)
{
  const Workplace& workplace = call.workplace;
  const Plan& plan = call.plan;
  const int reach = cells_in_reach(plan.radius, plan.cell_size);
  const double largest_range = call.largest_range();
  const bool one_grid_is_enough = !call.samples.scales && largest_range <= plan.cell_size;
  const Cell_frame self_frame =
    one_grid_is_enough ? points.grid.frame
                       : call.self_frame((std::max)(largest_range, plan.smallest_cell_size));
  bool is_last = false;
  const auto fit = [&](const Cell_grid& sample_grid, bool is_in_order) {
    const Cell_blocks blocks = find_blocks(sample_grid, points.grid, reach,
                                           maximum_number_of_candidates, workplace.arena,
                                           workplace.stream);
    fit_compatible_points(workplace, sample_grid, is_in_order, blocks, points.grid, points.normals,
                          plan.radius, square(plan.sheet_height), plan.compatible_bandwidth,
                          call.samples, is_last ? &call.counts->lonely : nullptr);
  };
  const auto fit_in_cells_of_points = [&]() {
    const Arena_scope scope(workplace.arena);
    fit(build_grid(call.sample_positions(call.samples.scales), nullptr, points.grid.frame,
                   workplace.arena, workplace.scratch, workplace.stream),
        false);
  };

  const Sample_refit_kernel kernel(plan.self_neighbor_radius, plan.refit_bandwidth);

  call.stages.begin("L0 minimization", 0.32);
  for (std::size_t i = 0; i < call.penalties.size(); ++i)
  {
    const Arena_scope scope(workplace.arena);
    const auto [samples, neighbors, places,
                spreading] = find_neighborhood(call, self_frame, [&](const Cell_grid& grid) {
      if (!one_grid_is_enough)
        return fit_in_cells_of_points();
      const Arena_scope fit_scope(workplace.arena);
      fit(grid, true);
    });
    call.numbers_of_pairs.push_back(neighbors.number_of_pairs);
    refit_sample_normals(workplace, kernel, samples, neighbors, number_of_sample_refits,
                         call.samples);
    {
      const Arena_scope turn_scope(workplace.scratch);
      const Turn_arrays arrays = take_turn_arrays(workplace, call.samples.size);
      minimize_once(workplace, call.plan.minimization, call.penalties[i], true, neighbors, samples,
                    call.samples, arrays, call.last_turn_result(i), call.turn_results + i);
    }
    repel_tangentially(workplace, samples, spreading, places, largest_range, plan.sample_spacing,
                       plan.radius, number_of_repulsion_steps, call.samples);
    if (i + 1 == call.penalties.size()) // while the neighbors are there
    {
      is_last = true;
      fit_in_cells_of_points();
      take_fitted_positions(workplace, call.samples);
      refit_sample_normals(workplace, kernel, samples, neighbors, number_of_sample_refits,
                           call.samples);
    }
    call.stages.ask(double(i + 1) / double(call.penalties.size()));
  }
}

/// What the caller says of the sides of the samples.
Side_hints side_hints(const Call& call)
{
  const Parameters& parameters = call.parameters;
  Side_hints hints = {parameters.has_viewpoint, parameters.viewpoint,
                      parameters.has_viewpoint || parameters.hints_are_viewpoints};
  if (hints.viewpoint.weight > 0)
    for (int axis = 0; axis < 3; ++axis)
      hints.viewpoint.coordinates[axis] =
        call.box.frame.enter_clamped(hints.viewpoint.coordinates[axis], axis);
  return hints;
}

/// Where the default method ends, see `project_to_local_quadrics()` on the CPU. The points are not
/// needed any more.
void project_to_local_quadrics(Call& call)
{
  const Plan& plan = call.plan;
  call.stages.begin("project to local quadrics", 0.03);
  const double radius = quadric_radius_factor * plan.radius;
  const Cell_frame frame = Cell_frame::around(call.box.low, call.box.high,
                                              (std::max)(radius / 2, plan.smallest_cell_size),
                                              radius, call.samples.scales);
  project_to_local_quadrics(call.workplace, frame, radius, square(plan.sheet_height),
                            plan.compatible_bandwidth, call.samples);
}

} // namespace

void run(Session& session, const Parameters& parameters, Stages& stages, Call_report& report)
{
  const unsigned n = session.size, m = unsigned(parameters.number_of_output_points);
  session.reserve(estimate_memory(n, m, parameters, session.hints != nullptr));
  const Workplace workplace = session.workplace();

  stages.begin("sort points", 0.05);
  const auto scales_in = [&](const Framed_box& box) {
    if (!session.has_scales)
      session.scales = estimate_scales(workplace, {session.points, n, box.frame, false}, box.low,
                                       box.high, 1);
    session.has_scales = true;
    return session.scales;
  };
  const float* scales = nullptr;
  const auto range_of_scales_in = [&](const Framed_box& box, const Usual_scales& usual) {
    const Scales_of_points found = estimate_scale_field(
      workplace, {session.points, n, box.frame, false}, session.extent.robust_diagonal, usual);
    scales = found.scales;
    return found.range;
  };
  Framed_box box;
  const Plan plan = plan_and_scale(session.extent, n, parameters, scales_in, range_of_scales_in,
                                   box, report);
  Call call = {
    parameters, workplace, stages, report,    box,        plan, plan.minimization.penalties(),
    nullptr,    nullptr,   {},     Samples(), Followers()};
  std::vector<Turn_result> results(call.penalties.size());
  call.turn_results = session.arena.take<Turn_result>(results.size());
  call.counts = session.arena.take<Sample_counts>(1);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(call.counts, 0, sizeof(Sample_counts), session.stream));
  call.samples =
    take_samples(session.arena, m,
                 {plan.refines, scales != nullptr, plan.keeps_spacings, session.hints != nullptr});
  {
    const Arena_scope points_scope(session.arena);
    Input input = filter_input(session, call, scales);
    const Prepared_points points = [&]() {
      const Arena_scope order_scope(session.scratch);
      Prepared_points prepared = prepare_points(session, call, input);
      choose_samples(call, input, prepared);
      prepared.grid.forget_order();
      return prepared;
    }();
    call.followers = take_followers(workplace, call.self_frame(call.plan.self_cell_size()),
                                    call.samples);
    if (plan.refines)
      minimize_with_refinement(call, points);
    else
      fit_to_all_points(call, points);
  }
  if (!plan.refines)
    minimize_alternatingly(call);
  stages.begin("orient normals", 0.1);
  orient_normals(workplace, call.box.low, call.box.high,
                 unsigned(parameters.number_of_orientation_neighbors), call.plan.sample_spacing,
                 side_hints(call), call.samples, call.counts);
  if (plan.refines)
    project_to_local_quadrics(call);
  const unsigned number_of_leaders = call.samples.size;
  append_followers(workplace, call.followers, call.samples);
  double result_extent[3], input_extent[3];
  find_plain_extent(workplace, call.samples.positions, call.samples.size, result_extent);
  for (int axis = 0; axis < 3; ++axis)
    input_extent[axis] = session.extent.trimmed[axis] / plan.unit;
  report.extent_share = share_of_extent(input_extent, plan.noise, result_extent,
                                        call.plan.sample_spacing);
  leave_frame(workplace, call.box.frame, call.samples);
  // not before: the device would have nothing to do while the host takes them
  const Sample_counts* const counts = session.scratch.fetch(call.counts, session.stream);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(results.data(), call.turn_results,
                                     results.size() * sizeof(Turn_result), cudaMemcpyDeviceToHost,
                                     session.stream));
  stages.end();
  report.number_of_lonely_samples = counts->lonely;
  report.oriented_share = double(counts->oriented) / number_of_leaders;
  report.hinted_share = double(counts->hinted) / number_of_leaders;

  session.iterations.clear();
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    if (!results[i].is_finite)
      throw Failure(Status::NOT_FINITE,
                    "The quadratic problem or its initial guess has values that are not finite.");
    session.iterations.push_back(
      iteration_report(parameters, call.plan.minimization, call.penalties[i],
                       plan.minimization.regularizes(i), call.numbers_of_pairs[i], results[i]));
  }
  report.iterations = session.iterations.data();
  report.number_of_iterations = session.iterations.size();
  session.positions = call.samples.positions;
  session.sample_normals = reinterpret_cast<float*>(call.samples.fit);
  session.number_of_samples = m;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
