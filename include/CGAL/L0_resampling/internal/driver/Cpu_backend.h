// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CPU_BACKEND_H
#define CGAL_L0_RESAMPLING_INTERNAL_CPU_BACKEND_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/cloud/density_weights.h>
#include <CGAL/L0_resampling/internal/cloud/extents.h>
#include <CGAL/L0_resampling/internal/cloud/prepare_points.h>
#include <CGAL/L0_resampling/internal/driver/Cpu_points.h>
#include <CGAL/L0_resampling/internal/driver/Oriented_points.h>
#include <CGAL/L0_resampling/internal/driver/expected_memory.h>
#include <CGAL/L0_resampling/internal/energy/Any_solver.h>
#include <CGAL/L0_resampling/internal/energy/Minimization_step.h>
#include <CGAL/L0_resampling/internal/energy/collapse_fit_term.h>
#include <CGAL/L0_resampling/internal/kernels/share_of_extent.h>
#include <CGAL/L0_resampling/internal/kernels/side_of_normal.h>
#include <CGAL/L0_resampling/internal/normals/estimate_pca_normals.h>
#include <CGAL/L0_resampling/internal/normals/filter_normals.h>
#include <CGAL/L0_resampling/internal/normals/refit_normals.h>
#include <CGAL/L0_resampling/internal/orientation/order_of_places.h>
#include <CGAL/L0_resampling/internal/orientation/orient_normals.h>
#include <CGAL/L0_resampling/internal/orientation/side_hints.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/L0_resampling/internal/samples/Refinement.h>
#include <CGAL/L0_resampling/internal/samples/choose_samples.h>
#include <CGAL/L0_resampling/internal/samples/estimate_feature_confidences.h>
#include <CGAL/L0_resampling/internal/samples/fit_compatible_points.h>
#include <CGAL/L0_resampling/internal/samples/most_crowded_place.h>
#include <CGAL/L0_resampling/internal/samples/project_to_local_quadrics.h>
#include <CGAL/L0_resampling/internal/samples/tangential_repulsion.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The result, in the coordinates of the input.
/// The stages on the CPU, and the arrays of one call. What calls them, and in which order, stands
/// in `run.h`.
/// \tparam FT the number type of the solver
template <typename ConcurrencyTag, typename FT>
class Cpu_backend : public Cpu_points<ConcurrencyTag>
{
  using Base = Cpu_points<ConcurrencyTag>;

protected: // for backends that differ in a stage
  using Base::m_facts;
  using Base::m_frame;
  using Base::m_input;
  using Base::m_progress;
  using Base::m_report;

  const Parameters& m_parameters;
  Any_solver<FT>& m_solver;

  Vector m_input_extent = Vector::Zero();
  Buffer<Local_vector>&m_given_normals, &m_hints; // of the points; none if none are given
  Areas m_areas;                                  // of the points, for the first samples

  Samples<FT> m_samples;
  Duplicate_samples m_followers;
  Fit_rows m_fit_rows; // for solvers that need them
  Neighborhoods m_neighbors;
  std::optional<Search_grid_3> m_sample_grid; // that neighbors are found in
  Buffer<Vector> m_places;                    // of the samples in that grid
  std::optional<Minimization_step<ConcurrencyTag, Any_solver<FT>>> m_step;
  Buffer<Upper_triangle<FT>> m_normal_spreads;
  std::optional<Refinement<ConcurrencyTag>> m_refinement;
  Buffer<Index> m_order_before; // of the samples, before the refinement sorted them
  Buffer<float> m_feature_confidences;
  Buffer<Index> m_outliers; // if they are asked for

public:
  using Base::number_of_points;

  static constexpr bool finds_feature_confidences = true, foresees_memory = true;
  static constexpr bool may_need_explicit_rows = std::is_same<FT, double>::value; // `Any_solver`

  /// \param points the input, finite, at least one point; used up
  /// \param given_normals unit or zero vectors, one a point, or none at all; used up
  /// \param hints unit or zero vectors on the side that normals shall point to, or to the
  /// viewpoints of the points, one a point, or none at all; used up
  /// \param parameters that tell of the sides of the normals
  /// \param given what is known of the cloud that the points are a part of
  Cpu_backend(Buffer<Vector>& points, Buffer<Local_vector>& given_normals,
              Buffer<Local_vector>& hints, const Parameters& parameters, Any_solver<FT>& solver,
              Progress& progress, Report& report, const Facts_of_cloud& given)
    : Base(points, progress, report, given), m_parameters(parameters), m_solver(solver),
      m_given_normals(given_normals),
      m_hints(hints), m_areas{Buffer<std::uint64_t>(points.get_allocator()), 0},
      m_samples(points.get_allocator()), m_followers(points.get_allocator()), m_fit_rows(no_rows()),
      m_neighbors(no_neighbors()), m_places(points.get_allocator()),
      m_normal_spreads(points.get_allocator()), m_order_before(points.get_allocator()),
      m_feature_confidences(points.get_allocator()), m_outliers(points.get_allocator())
  {}
  Cpu_backend(const Cpu_backend&) = delete;
  Cpu_backend& operator=(const Cpu_backend&) = delete;

  /// Of the call, once it was run.
  Oriented_points<FT> take_result()
  {
    return {std::move(m_samples.positions),
            std::move(m_samples.normals),
            std::move(m_feature_confidences),
            std::move(m_samples.side_confidences),
            std::move(m_samples.scales),
            std::move(m_samples.noises),
            std::move(m_samples.position_deviations),
            std::move(m_samples.normal_deviations),
            std::move(m_outliers)};
  }

  /// The loops of the stages count their steps, and ask the caller, by themselves.
  void end_turn(std::size_t, std::size_t) { m_progress.look(); }

  std::size_t number_of_samples() const { return m_samples.positions.size(); }

  void begin(const Plan&) { m_input_extent = trimmed_extent<ConcurrencyTag>(m_input.points); }

  // The points

  void drop_outliers(const Plan& plan)
  {
    const Buffer<unsigned char> are_outliers = outliers_among<ConcurrencyTag>(
      m_input, plan.radius, plan.extent, Outlier_thresholds(plan.outlier_sensitivity), m_facts,
      m_progress);
    if (m_parameters.with_outliers) // the points are in their first order yet
      for_each_in_order(number_of_points(), [&](std::size_t i) {
        if (are_outliers[i])
          m_outliers.push_back(Index(i));
      });
    m_report.number_of_outliers = drop_points(are_outliers, m_input, m_given_normals, m_hints);
  }

  void sort_points(const Plan& plan)
  {
    m_report.number_of_distinct_points =
      sort_and_thin_points<ConcurrencyTag>(plan.cell_size, m_input, m_given_normals, m_hints);
    m_input.normals = filled_buffer(number_of_points(), Local_vector(Local_vector::UnitZ()),
                                    m_input.points.get_allocator());
  }

  /// \throws std::bad_alloc if the limit of memory is below what the call takes for sure
  void refuse_too_little_memory(const Plan& plan)
  {
    internal::refuse_too_little_memory<ConcurrencyTag, FT>(
      plan, m_given_normals, m_hints, m_solver.bytes_per_sample,
      [this](const Plan& with_radius) { return areas_of_points(with_radius); }, m_progress,
      m_input);
  }

  bool are_all_normals_given() const { return are_all_given<ConcurrencyTag>(m_given_normals); }

  void estimate_pca_normals(const Plan& plan)
  {
    estimate_pca_normals(plan, m_input.numbers_of_points);
  }

  /// They replace those of PCA where they are usable.
  void take_given_normals()
  {
    for_each_in_order(m_given_normals.size(), [&](std::size_t i) {
      if (!m_given_normals[i].isZero(0))
        m_input.normals[i] = m_given_normals[i];
    });
  }

  void refit_normals(const Plan& plan)
  {
    internal::refit_normals<ConcurrencyTag>(m_input.grid, m_input.points, plan.kernel_of_points(),
                                            m_progress, m_input.normals);
  }

  void filter_normals(const Plan& plan, std::size_t)
  {
    const Normal_filter<Local> filter{plan.filter_radius, Local(plan.squared_bandwidth),
                                      Local(plan.normal_bandwidth)};
    internal::filter_normals<ConcurrencyTag>(m_input.grid, m_input.points, filter, m_facts,
                                             m_progress, m_input.normals);
  }

  /// Given normals are not needed any further.
  void weigh_density(const Plan& plan)
  {
    const bool all_normals_given = are_all_normals_given();
    release(m_given_normals);
    const std::size_t number_of_sparse_balls = compute_input_density_weights<ConcurrencyTag>(
      m_input.grid, m_input.points, plan.filter_radius, plan.squared_bandwidth, m_facts, m_progress,
      m_input.density_weights);
    if (all_normals_given)
      m_report.number_of_degenerate_neighborhoods = number_of_sparse_balls;
    if (!plan.weighs_density) // sparse points shall not count more than dense ones
      m_input.density_weights.assign(number_of_points(), Local(1));
  }

  // The first samples

  double total_area(const Plan& plan)
  {
    m_areas = areas_of_points(plan);
    return known_or_found(m_facts.area, [&]() { return m_areas.total(); });
  }

  void choose_samples(const Plan& plan) { start_samples(plan, choose_sources(plan)); }

  // Algorithm 1

  void collapse_fit_term(const Plan& plan)
  {
    const Search_grid_3 sample_grid(ConcurrencyTag(), m_samples.positions, plan.cell_size);
    m_report.number_of_lonely_samples = internal::collapse_fit_term<ConcurrencyTag>(
      sample_grid, m_samples.positions, m_input.grid, m_input.points, m_input.density_weights,
      plan.radius, m_followers.numbers_of_samples, m_progress, m_samples.fit_weights,
      m_samples.fit_centroids);
  }

  bool needs_explicit_rows() const { return m_solver.needs_explicit_rows; }

  void gather_fit_rows(const Plan& plan)
  {
    const Search_grid_3 sample_grid(ConcurrencyTag(), m_samples.positions, plan.cell_size);
    m_fit_rows = internal::gather_fit_rows<ConcurrencyTag>(
      sample_grid, m_samples.positions, m_input.grid, m_input.points, m_input.density_weights,
      plan.radius, plan.number_of_half_samplings, m_progress);
  }

  void release_points() { m_input.release_all(); }

  /// For a search of neighbors; those before are forgotten.
  void sort_samples(const Plan& plan)
  {
    m_neighbors = no_neighbors();
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(m_samples.positions,
                                                                            sample_cells(plan));
    apply_order<ConcurrencyTag>(order, m_samples);
    if (needs_explicit_rows() && !plan.refines)
      apply_order(order, m_fit_rows);
  }

  void find_self_neighbors(const Plan& plan)
  {
    m_sample_grid.emplace(ConcurrencyTag(), m_samples.positions, sample_cells(plan));
    m_neighbors = internal::find_self_neighbors<ConcurrencyTag>(
      *m_sample_grid, m_samples.positions,
      {plan.self_neighbor_radius, view_of_scales(m_samples.scales), spreading_radii()}, m_progress);
    m_report.number_of_self_neighbor_pairs = m_neighbors.indices.size();
    if (!spreads_wider())
      m_sample_grid.reset();
  }

  void minimize_once(const Plan& plan, const Turn& turn)
  {
    if (!m_step)
      m_step.emplace(plan.minimization, m_solver, m_progress, m_places.get_allocator());
    if (plan.refines)
    {
      m_places = copy_of(m_samples.positions);
      if constexpr (may_need_explicit_rows)
        if (needs_explicit_rows())
          m_fit_rows = collapsed_fit_rows();
    }
    if (plan.refines || turn.number == 0) // else the normals stay
      sum_normal_spreads<ConcurrencyTag>(m_samples.normals, m_neighbors, m_normal_spreads);
    m_report.iterations.push_back(
      (*m_step)(turn, m_neighbors, m_normal_spreads, m_fit_rows, m_samples));
    m_report.converged = m_report.converged && m_report.iterations.back().solver.converged;
  }

  void release_neighbors()
  {
    m_neighbors = no_neighbors();
    m_fit_rows = no_rows();
    m_step.reset();
    release(m_normal_spreads);
  }

  // Algorithm 1 of the default method

  void fit_compatible_points(const Plan& plan, bool is_last)
  {
    fit_compatible_points(plan, is_last, [](std::size_t) { return true; });
  }

  /// Forgets what neighbors are found in, but not the neighbors.
  void repel_tangentially(const Plan& plan, std::size_t number_of_steps = number_of_repulsion_steps)
  {
    const auto repel = [&](const Neighborhoods& others, double radius) {
      internal::repel_tangentially<ConcurrencyTag>(others, m_places,
                                                   {radius, {}, spreading_radii()},
                                                   plan.sample_spacing, plan.radius,
                                                   number_of_steps, m_samples);
    };
    if (spreads_wider())
      repel(internal::find_self_neighbors<ConcurrencyTag>(
              *m_sample_grid, m_places, {plan.spreading_radius(), {}, spreading_radii()},
              m_progress),
            plan.spreading_radius());
    else
      repel(m_neighbors, plan.self_neighbor_radius);
    m_sample_grid.reset();
    release(m_places);
  }

  void take_fitted_positions() { m_samples.positions = copy_of(m_samples.fit_centroids); }

  // The end

  /// \returns the orientation, but for the confidences if these are kept for the result
  Orientation orient_normals(const Plan& plan)
  {
    if (plan.refines)
      sort_by_places(plan);
    Orientation orientation = internal::orient_normals<ConcurrencyTag>(
      m_samples.positions, plan.number_of_orientation_neighbors, plan.sample_spacing,
      side_hints(m_parameters, m_frame, m_samples.positions, m_samples.hints), m_progress,
      m_samples.normals);
    m_report.oriented_share = orientation.oriented_share;
    m_report.right_side_share = orientation.right_side_share();
    if (m_parameters.with_side_confidences)
      m_samples.side_confidences = std::move(orientation.confidences);
    m_report.hinted_share = orientation.hinted_share;
    return orientation;
  }

  void project_to_local_quadrics(const Plan& plan)
  {
    internal::project_to_local_quadrics<ConcurrencyTag>(
      plan.kernel_of_wide_balls(), plan.minimum_cell_size, m_progress, m_samples);
  }

  // The refinement

  /// As far as is known without the refinement: not more than a point tells.
  void begin_deviations(const Plan& plan)
  {
    fill_buffer(number_of_samples(), float(plan.lengths_of_refinement().noise_of_disk()),
                m_samples.position_deviations);
    fill_buffer(number_of_samples(), float(std::sqrt(squared_angle_of_any_normal)),
                m_samples.normal_deviations);
  }

  /// From here to `end_refinement()`, no stage looks at the sides of normals.
  void begin_refinement()
  {
    m_samples.sides.resize(number_of_samples());
    for_each_in_order(number_of_samples(), [&](std::size_t i) {
      auto& normal = m_samples.normals[i];
      const bool is_turned = is_negative(normal[0], normal[1], normal[2]);
      m_samples.sides[i] = is_turned ? Side_after_refinement::TURNED
                                     : Side_after_refinement::AS_IT_IS;
      if (is_turned)
        normal = -normal;
    });
  }

  /// Sorts the samples; `end_refinement()` puts them back.
  void spread_samples(const Plan& plan)
  {
    take_refined();
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(m_samples.positions,
                                                                            sample_cells(plan));
    apply_order<ConcurrencyTag>(order, m_samples);
    m_order_before = m_order_before.empty()
                       ? copy_of(order)
                       : values_in_order<ConcurrencyTag>(order, m_order_before);
    find_self_neighbors(plan);
    m_places = copy_of(m_samples.positions);
    repel_tangentially(plan, number_of_repulsion_steps_of_refinement);
    m_neighbors = no_neighbors();
  }

  void split_sheets(const Plan& plan)
  {
    begin_round(plan);
    m_refinement->share_points(m_input.grid, m_input.points, m_input.scales, widening_of_split);
    m_refinement->split_sheets(m_parameters.has_viewpoint || !m_samples.hints.empty());
  }

  void share_points(const Plan& plan)
  {
    begin_round(plan);
    m_refinement->share_points(m_input.grid, m_input.points, m_input.scales);
  }
  void fit_disks(int scale) { m_refinement->fit_disks(scale); }
  void weigh_by_risk(int scale) { m_refinement->weigh_by_risk(scale); }
  void take_mean_surfaces() { m_refinement->take_mean_surfaces(); }
  void keep_clear_of_creases() { m_refinement->keep_clear_of_creases(); }
  void find_deviations() { m_refinement->find_deviations(); }

  void end_refinement()
  {
    take_refined();
    Buffer<Index> order(number_of_samples(), m_order_before.get_allocator());
    for_each_in_order(order.size(), [&](std::size_t i) { order[m_order_before[i]] = Index(i); });
    apply_order<ConcurrencyTag>(order, m_samples);
    release(m_order_before);
    for_each_in_order(number_of_samples(), [&](std::size_t i) {
      if (m_samples.sides[i] == Side_after_refinement::TURNED)
        m_samples.normals[i] = -m_samples.normals[i];
    });
  }

  void estimate_feature_confidences(const Plan& plan)
  {
    internal::estimate_feature_confidences<ConcurrencyTag>(m_samples.positions, m_samples.normals,
                                                           plan.sample_spacing,
                                                           plan.compatible_bandwidth, m_progress,
                                                           m_feature_confidences);
  }

  void append_followers()
  {
    m_followers.append_values(m_samples.start_indices, m_samples.normals);
    m_followers.append_values(m_samples.start_indices, m_feature_confidences);
    m_followers.append_values(m_samples.start_indices, m_samples.side_confidences);
    m_followers.append_values(m_samples.start_indices, m_samples.noises);
    m_followers.append_values(m_samples.start_indices, m_samples.position_deviations);
    m_followers.append_values(m_samples.start_indices, m_samples.normal_deviations);
    if (m_parameters.with_neighbor_radii)
      m_followers.append_values(m_samples.start_indices, m_samples.scales);
    m_followers.append_positions(m_samples.start_indices, m_samples.positions);
  }

  void measure_extent(const Plan& plan)
  {
    const Vector result_extent = plain_extent(m_samples.positions);
    m_report.extent_share = share_of_extent(m_input_extent.data(), plan.noise, result_extent.data(),
                                            plan.sample_spacing);
  }

  void leave_frame()
  {
    const std::size_t samples_per_task = 4096;
    Buffer<Vector>& positions = m_samples.positions;
    for_each_block<ConcurrencyTag>(positions.size(), samples_per_task,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       positions[i] = m_frame.leave(positions[i]);
                                   });
  }

  void end(const Plan&) { m_progress.end_stage(); }

protected:
  /// \param numbers_of_points as how many each point is reported
  void estimate_pca_normals(const Plan& plan, const Buffer<Index>& numbers_of_points)
  {
    m_report.number_of_degenerate_neighborhoods = internal::estimate_pca_normals<ConcurrencyTag>(
      m_input.grid, m_input.points, numbers_of_points, plan.pca_radius, plan.looks_beyond_strips,
      m_progress, m_input.normals);
  }

  /// \param is_reported whether the last fit is to report on a sample
  template <typename IsReported>
  void fit_compatible_points(const Plan& plan, bool is_last, const IsReported& is_reported)
  {
    const Fit_input<Local> fit_input{m_input.grid, m_input.points, m_input.normals,
                                     m_input.density_weights, plan.kernel_of_fit()};
    if (!is_last)
    {
      internal::fit_compatible_points<ConcurrencyTag>(fit_input, m_progress, m_samples);
      return;
    }
    if (plan.finds_noises)
      fill_buffer(number_of_samples(), 0.f, m_samples.noises);
    Buffer<Outcome_of_fit> outcomes(number_of_samples(), Outcome_of_fit::EXPLAINED,
                                    m_places.get_allocator());
    internal::fit_compatible_points<ConcurrencyTag>(
      fit_input, m_progress, m_samples, plan.finds_noises ? &m_samples.noises : nullptr, &outcomes);
    report_fit(plan, outcomes, is_reported);
  }

  template <typename IsReported>
  void report_fit(const Plan& plan, const Buffer<Outcome_of_fit>& outcomes,
                  const IsReported& is_reported)
  {
    Buffer<Vector> unexplained(m_places.get_allocator()), others(m_places.get_allocator());
    for_each_in_order(outcomes.size(), [&](std::size_t i) {
      if (outcomes[i] == Outcome_of_fit::UNEXPLAINED)
        (is_reported(i) ? unexplained : others).push_back(m_samples.positions[i]);
      m_report.number_of_lonely_samples += outcomes[i] == Outcome_of_fit::LONELY && is_reported(i);
    });
    const std::size_t number = unexplained.size();
    m_report.number_of_unexplained_samples = number;
    if (number == 0)
      return;
    unexplained.insert(unexplained.end(), others.begin(), others.end());
    const double radius = unexplained_radius_factor * plan.radius;
    const Crowded_place place = most_crowded_place<ConcurrencyTag>(
      unexplained, number, radius, plan.minimum_cell_size, m_progress);
    const Vector center = m_frame.leave(place.center);
    m_report.unexplained_center = {center[0], center[1], center[2]};
    m_report.unexplained_radius = m_frame.length_of_input(radius);
    m_report.number_of_unexplained_samples_there = place.number_of_points;
  }

  Sources choose_sources(const Plan& plan)
  {
    return internal::choose_sources(plan, m_input, m_areas, m_facts);
  }

  void start_samples(const Plan& plan, Sources sources)
  {
    m_followers = internal::choose_samples<ConcurrencyTag>(
      plan, m_input, m_areas, m_facts, std::move(sources), m_hints, m_progress, m_samples);
    release(m_areas.units);
  }

  double units_per_length(const Plan& plan) const
  {
    return units_per_length_for(plan.cell_size, plan.longest_query(), !m_input.scales.empty());
  }

  Areas areas_of_points(const Plan& plan)
  {
    return internal::areas_of_points<ConcurrencyTag, Local>(
      m_input.grid, m_input.points, plan.area_radius(), plan.number_of_samples,
      units_per_length(plan), m_facts.units_of_disks, m_progress);
  }

  Neighborhoods no_neighbors() const
  {
    const auto allocator = m_input.points.get_allocator();
    return {Buffer<std::size_t>(allocator), Buffer<Index>(allocator)};
  }

  Fit_rows no_rows() const
  {
    const auto allocator = m_input.points.get_allocator();
    return {Buffer<std::size_t>(allocator), Buffer<Vector>(allocator), Buffer<double>(allocator)};
  }

  /// The fit term of the default method as rows: one a sample.
  Fit_rows collapsed_fit_rows() const
  {
    Fit_rows rows{Buffer<std::size_t>(number_of_samples() + 1, 0, m_places.get_allocator()),
                  m_samples.fit_centroids, m_samples.fit_weights};
    for (std::size_t i = 0; i < rows.offsets.size(); ++i)
      rows.offsets[i] = i;
    return rows;
  }

  /// Sides are not to depend on where samples were before, nor on what part of a cloud they are,
  /// where these may be parts.
  void sort_by_places(const Plan& plan)
  {
    const Buffer<Index> order = order_of_places<ConcurrencyTag>(m_samples.positions, plan);
    apply_order<ConcurrencyTag>(order, m_samples);
  }

  void begin_round(const Plan& plan)
  {
    m_refinement.emplace(plan.lengths_of_refinement(), plan.cell_size, plan.minimum_cell_size,
                         m_samples, m_progress);
  }

  void take_refined()
  {
    if (m_refinement)
      m_refinement->write_to(m_samples);
    m_refinement.reset();
  }

  /// Whether other samples repel each other than those that the energy couples.
  bool spreads_wider() const { return !m_samples.scales.empty(); }

  Scales_view spreading_radii() const { return view_of_scales(m_samples.spreading_radii); }

  Cell_sizes sample_cells(const Plan& plan) const
  {
    return {plan.sample_cell_size(spreads_wider()), m_samples.spreading_radii};
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CPU_BACKEND_H
