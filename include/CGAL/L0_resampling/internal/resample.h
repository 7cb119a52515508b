// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H
#define CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/Followers.h>
#include <CGAL/L0_resampling/internal/Parameters.h>
#include <CGAL/L0_resampling/internal/alternating_minimization.h>
#include <CGAL/L0_resampling/internal/areas_of_points.h>
#include <CGAL/L0_resampling/internal/collapse_fit_term.h>
#include <CGAL/L0_resampling/internal/density_weights.h>
#include <CGAL/L0_resampling/internal/estimate_feature_confidences.h>
#include <CGAL/L0_resampling/internal/estimate_pca_normals.h>
#include <CGAL/L0_resampling/internal/estimate_scales.h>
#include <CGAL/L0_resampling/internal/filter_normals.h>
#include <CGAL/L0_resampling/internal/find_outliers.h>
#include <CGAL/L0_resampling/internal/initialize_samples.h>
#include <CGAL/L0_resampling/internal/orient_normals.h>
#include <CGAL/L0_resampling/internal/refining_minimization.h>
#include <CGAL/L0_resampling/internal/refit_normals.h>
#include <CGAL/L0_resampling/internal/settle_on_quadrics.h>
#include <CGAL/L0_resampling/internal/thin_crowds.h>
#include <CGAL/L0_resampling/internal/working_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The scalar type of what happens within one ball, where relative coordinates make `float` enough.
using Local = float;
using Local_vector = Eigen::Matrix<Local, 3, 1>;

/// The result, in the coordinates of the input.
/// \tparam FT the number type of the solver
template <typename FT>
struct Oriented_points
{
  Buffer<Vector> positions;
  Buffer<Eigen::Matrix<FT, 3, 1>> normals; ///< of unit length but for rounding in `FT`
  Buffer<float> feature_confidences;       ///< in [0, 1], if they are asked for
};

/// Coincident points are in no order but that of the input, which must not matter: puts their normals, or hints, in one.
inline void sort_normals_of_coincident_points(const Buffer<Vector>& points, Buffer<Local_vector>& normals)
{
  for_each_in_order(points.size(), [&](std::size_t begin) {
    if (begin > 0 && points[begin] == points[begin - 1])
      return;
    std::size_t end = begin + 1;
    while (end < points.size() && points[end] == points[begin])
      ++end;
    std::sort(normals.begin() + std::ptrdiff_t(begin), normals.begin() + std::ptrdiff_t(end),
              [](const Local_vector& a, const Local_vector& b) {
                return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
              });
  });
}

/// The lengths of a call, in the working frame.
struct Lengths
{
  double radius;        ///< \f$ r_p \f$, in [1, 2)
  double filter_radius; ///< \f$ r_q \f$
  double self_neighbor_radius;
  double noise;              ///< standard deviation across the surface; default method only
  double sample_spacing;     ///< of an even set of the samples
  double cell_size;          ///< of the grid of the points
  double smallest_cell_size; ///< of any grid
};

/// \f$ (1 - \cos\sigma_n)^2 \f$ of Eq. (2), for an angle in degrees; never so small that its inverse is not finite.
inline double normal_bandwidth(double angle)
{
  return (std::max)(square(double(1 - std::cos(angle * EIGEN_PI / 180))), 1e-12);
}

/// The default method's range of the terms between samples. Beyond r_p the surface may bend away, and the fit could not hold a sample that the other
/// terms carry off.
inline double self_neighbor_radius_of_spacing(const Lengths& lengths)
{
  return (std::min)(self_neighbor_radius_per_spacing * lengths.sample_spacing, lengths.radius);
}

/// Removes the outliers from the points and what belongs to them.
/// \returns their number
template <typename ConcurrencyTag>
std::size_t drop_outliers(double radius, Buffer<Vector>& points, Buffer<Local_vector>& given_normals,
                          Buffer<Local_vector>& hints, Progress& progress)
{
  const Buffer<unsigned char> is_outlier = find_outliers<Local, ConcurrencyTag>(points, radius, progress);
  const auto drop_from = [&](auto& values) {
    std::size_t size = 0;
    for_each_in_order(values.size(), [&](std::size_t i) {
      if (!is_outlier[i])
        values[size++] = values[i];
    });
    values.resize(size);
  };
  const std::size_t n = points.size();
  drop_from(points);
  drop_from(given_normals);
  drop_from(hints);
  return n - points.size();
}

/// Sorts the points, and what belongs to them, into the order of their grid, and thins them where they
/// crowd.
/// \returns the number of distinct points before
template <typename ConcurrencyTag>
std::size_t sort_points(double cell_size, Buffer<Vector>& points, Buffer<Local_vector>& given_normals,
                        Buffer<Local_vector>& hints)
{
  {
    const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(points, cell_size);
    apply_order<ConcurrencyTag>(order, points);
    for (Buffer<Local_vector>* vectors : {&given_normals, &hints})
      if (!vectors->empty())
      {
        apply_order(order, *vectors);
        sort_normals_of_coincident_points(points, *vectors);
      }
  }
  std::size_t number_of_distinct_points = 0;
  for_each_in_order(points.size(),
                    [&](std::size_t i) { number_of_distinct_points += i == 0 || points[i] != points[i - 1]; });
  const Representatives kept = thin_crowds<ConcurrencyTag>(Search_grid_3(points, cell_size), points,
                                                           most_points_of_subcell);
  kept.keep(points);
  kept.keep(given_normals);
  kept.keep(hints);
  return number_of_distinct_points;
}

/// Samples can start in crowds: where points do, or where many more samples are asked for than there
/// are points. Removes the samples of each crowd but for a few, which the others follow.
/// \param samples sorted for a grid of cells of size `lengths.cell_size`, before and after
template <typename ConcurrencyTag>
Followers take_followers(const Lengths& lengths, Initial_samples& samples)
{
  const std::size_t m = samples.positions.size();
  Followers followers(samples.positions.get_allocator());
  // a crowd in the smaller cells is one in these too
  if (!Crowded_cells(Search_grid_3(samples.positions, lengths.cell_size), samples.positions, most_samples_of_subcell)
         .are_there_any<ConcurrencyTag>())
    return followers;
  const double cell_size = (std::max)(lengths.self_neighbor_radius, lengths.smallest_cell_size);
  const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(samples.positions, cell_size);
  Buffer<Vector> positions = copy_of(samples.positions);
  apply_order<ConcurrencyTag>(order, positions);
  const Representatives kept = thin_crowds<ConcurrencyTag>(Search_grid_3(positions, cell_size), positions,
                                                           most_samples_of_subcell);
  if (kept.are_all_points())
    return followers;

  Representatives in_old_order{filled_buffer(m, Index(0), order.get_allocator())};
  for_each_in_order(m, [&](std::size_t i) { in_old_order.of_points[order[i]] = order[kept.of_points[i]]; });
  Buffer<Index> places(order.get_allocator()); // of the kept ones among themselves
  places.reserve(m);
  Index number_of_kept = 0;
  for_each_in_order(m, [&](std::size_t i) { places.push_back(in_old_order.is_kept(i) ? number_of_kept++ : 0); });
  followers.leaders.reserve(m - number_of_kept);
  followers.offsets.reserve(m - number_of_kept);
  for_each_in_order(m, [&](std::size_t i) {
    const Index leader = in_old_order.of_points[i];
    if (leader == i)
      return;
    followers.leaders.push_back(places[leader]);
    followers.offsets.push_back(samples.positions[i] - samples.positions[leader]);
  });
  followers.numbers_of_samples = in_old_order.numbers_of_points([](std::size_t) { return Index(1); });
  in_old_order.keep(samples.positions);
  in_old_order.keep(samples.sources);
  return followers;
}

/// Section 3.1: the filtered normals of the input points. `given_normals` replace PCA where they are usable.
template <typename ConcurrencyTag>
Buffer<Local_vector> compute_filtered_normals(const Search_grid_3& grid, const Buffer<Vector>& points,
                                              const Buffer<Local_vector>& given_normals, const Lengths& lengths,
                                              const Parameters& parameters, Progress& progress, Report& report)
{
  Buffer<Local_vector> normals = filled_buffer(points.size(), Local_vector(Local_vector::UnitZ()), points.get_allocator());
  const bool all_given = !given_normals.empty()
                         && std::none_of(given_normals.begin(), given_normals.end(),
                                         [](const Local_vector& n) { return n.isZero(0); });
  if (!all_given)
  {
    progress.begin_stage("PCA normals", 0.1, points.size());
    report.number_of_degenerate_neighborhoods =
      estimate_pca_normals<ConcurrencyTag>(grid, points, pca_radius_factor * lengths.radius, progress, normals);
  }
  for_each_in_order(given_normals.size(), [&](std::size_t i) {
    if (!given_normals[i].isZero(0))
      normals[i] = given_normals[i];
  });

  const Local squared_bandwidth = Local(square(spatial_bandwidth_factor * lengths.filter_radius));
  const Normal_filter<Local> filter{lengths.filter_radius, squared_bandwidth,
                                    Local(normal_bandwidth(parameters.sharpness_angle))};
  const Normal_filter<Local> plane{lengths.filter_radius, squared_bandwidth,
                                   Local(normal_bandwidth(fit_angle_factor * parameters.sharpness_angle))};
  const std::size_t number_of_iterations = parameters.number_of_normal_filter_iterations;
  const std::size_t number_of_refits = parameters.method == Method::DEFAULT
                                         ? (std::min)(number_of_normal_refits, number_of_iterations)
                                         : 0;
  progress.begin_stage("filter normals", 0.4, points.size() * (number_of_iterations + number_of_refits));
  filter_normals<ConcurrencyTag>(grid, points, filter, number_of_iterations - number_of_refits, progress, normals);
  for (std::size_t refit = 0; refit < number_of_refits; ++refit)
  {
    refit_normals<ConcurrencyTag>(grid, points, plane, Local(square(sheet_height(lengths.noise, lengths.radius))),
                                  progress, normals);
    filter_normals<ConcurrencyTag>(grid, points, filter, 1, progress, normals);
  }
  return normals;
}

/// Chooses the lengths that the caller left open: by the paper's rule, which is \f$ l_{diag} / \sqrt[3]{n} \f$, or by the spacing and the noise of the
/// points for the default method. Scales frame and points to the radius.
template <typename ConcurrencyTag>
Lengths choose_lengths(const Parameters& parameters, Buffer<Vector>& points, Working_frame& frame, Progress& progress,
                       Report& report)
{
  const double n = double(points.size()), m = double(parameters.number_of_output_points);
  double diagonal = robust_diagonal<ConcurrencyTag>(points);
  const double paper_radius = sensible_radius(diagonal / std::cbrt(n), points);
  diagonal *= frame.scale_to<ConcurrencyTag>(paper_radius, points);
  const double scaled_paper_radius = std::ldexp(paper_radius, -std::ilogb(paper_radius));

  Lengths lengths;
  lengths.noise = 0;
  lengths.radius = scaled_paper_radius;
  // a surface through the middle of a cube of that diagonal, evenly sampled
  lengths.sample_spacing = diagonal / std::sqrt(m);
  if (parameters.method == Method::DEFAULT)
  {
    const Scales scales = estimate_scales<ConcurrencyTag, Local>(points, scaled_paper_radius, progress);
    lengths.radius = default_radius(scales.spacing, scales.noise);
    lengths.noise = scales.noise;
    lengths.sample_spacing = scales.spacing * std::sqrt(n / m);
    report.estimated_spacing = frame.length_of_input(scales.spacing);
    report.estimated_noise = frame.length_of_input(scales.noise);
  }
  if (parameters.neighbor_radius > 0)
    lengths.radius = frame.length_in_frame(parameters.neighbor_radius);
  lengths.radius = sensible_radius(lengths.radius, points);

  const double scale = frame.scale_to<ConcurrencyTag>(lengths.radius, points);
  lengths.radius *= scale;
  lengths.noise *= scale;
  lengths.sample_spacing *= scale;
  if (!(lengths.sample_spacing > 0)) // all points, but for outliers, are at one place: any length will do
    lengths.sample_spacing = lengths.radius;
  const double default_factor = parameters.method == Method::DEFAULT ? default_filter_radius_factor : 1.;
  lengths.filter_radius = parameters.normal_filter_radius > 0
                            ? (std::max)(sensible_radius(frame.length_in_frame(parameters.normal_filter_radius), points),
                                         least_filter_radius_factor * lengths.radius)
                            : default_factor * lengths.radius;
  lengths.self_neighbor_radius = self_neighbor_radius_factor * lengths.radius;
  if (parameters.method == Method::DEFAULT)
    lengths.self_neighbor_radius = self_neighbor_radius_of_spacing(lengths);
  // A radius far below the spacing would spread the cloud over more cells than a grid can number.
  lengths.smallest_cell_size = std::ldexp(diagonal * scale, -18);
  // The balls of the filter reach one cell far, or two if they are the larger ones: cells as large as that share a block of
  // candidates among many queries.
  lengths.cell_size = (std::max)(lengths.filter_radius > lengths.radius ? lengths.filter_radius / 2 : lengths.radius,
                                 lengths.smallest_cell_size);

  report.neighbor_radius = frame.length_of_input(lengths.radius);
  report.normal_filter_radius = frame.length_of_input(lengths.filter_radius);
  return lengths;
}

/// Turns the normals to one side, as the hints say that the caller has given.
template <typename ConcurrencyTag, typename FT>
Orientation turn_normals(const Parameters& parameters, const Working_frame& frame, double spacing, Progress& progress,
                         Samples<FT>& samples)
{
  const auto orient = [&](const auto& hint_of) {
    return orient_normals<ConcurrencyTag>(samples.positions, parameters.number_of_orientation_neighbors, spacing,
                                          hint_of, progress, samples.normals);
  };
  if (!samples.hints.empty())
    return orient([&](Index i) -> Vector { return samples.hints[i].template cast<double>(); });
  if (!parameters.has_viewpoint)
    return orient(no_hint);
  const Vector viewpoint = frame.point_in_frame(
    Vector(parameters.viewpoint[0], parameters.viewpoint[1], parameters.viewpoint[2]));
  return orient([&](Index i) { return hint_of_viewpoint(viewpoint, samples.positions[i], square(spacing)); });
}

/*!
Resamples: the stages of the paper, one after the other.

\param points the input, finite, at least one point; used up
\param given_normals unit or zero vectors, one a point, or none at all; used up
\param hints unit or zero vectors on the side that normals shall point to, one a point, or none at all; used up
\param parameters checked; radii in the unit of the input
*/
template <typename ConcurrencyTag, typename SolverTraits>
Oriented_points<typename SolverTraits::FT> resample(Buffer<Vector>& points, Buffer<Local_vector>& given_normals,
                                                    Buffer<Local_vector>& hints, const Parameters& parameters,
                                                    SolverTraits& solver, Progress& progress, Report& report)
{
  using FT = typename SolverTraits::FT;
  const auto allocator = points.get_allocator();
  // Lengths, and the frame in which r_p lies in [1, 2)
  progress.begin_stage("sort points", 0.05, 1);
  Working_frame frame;
  frame.enter<ConcurrencyTag>(points);
  Lengths lengths = choose_lengths<ConcurrencyTag>(parameters, points, frame, progress, report);

  if (parameters.drop_outliers)
  {
    progress.begin_stage("find outliers", 0.05, points.size());
    report.number_of_outliers = drop_outliers<ConcurrencyTag>(lengths.radius, points, given_normals, hints, progress);
    progress.begin_stage("sort points", 0.05, 1);
  }
  report.number_of_distinct_points = sort_points<ConcurrencyTag>(lengths.cell_size, points, given_normals, hints);
  Search_grid_3 grid(points, lengths.cell_size);

  // Section 3.1: normals, Eq. (1) and (2)
  const double squared_bandwidth = square(spatial_bandwidth_factor * lengths.filter_radius);
  Buffer<Local_vector> normals = compute_filtered_normals<ConcurrencyTag>(grid, points, given_normals, lengths,
                                                                          parameters, progress, report);
  release(given_normals);

  // Section 3.2: density weights of Q, Eq. (5), and the first S
  progress.begin_stage("density weights", 0.08, points.size());
  Buffer<Local> input_density_weights(allocator);
  compute_input_density_weights<ConcurrencyTag>(grid, points, lengths.filter_radius, squared_bandwidth, progress,
                                                input_density_weights);

  const std::size_t number_of_area_queries = parameters.method == Method::DEFAULT ? points.size() : 0;
  progress.begin_stage("initial samples", 0.02, parameters.number_of_output_points + number_of_area_queries);
  const std::size_t m = parameters.number_of_output_points;
  Areas areas{Buffer<std::uint64_t>(allocator), 0};
  if (parameters.method == Method::DEFAULT)
  {
    const double longest_query = (std::max)(lengths.radius, lengths.filter_radius);
    areas = areas_of_points<ConcurrencyTag, Local>(grid, points, area_radius_factor * longest_query,
                                                   units_per_length_for(lengths.cell_size, longest_query), progress);
    lengths.sample_spacing = std::sqrt(areas.total() / double(m));
    lengths.self_neighbor_radius = self_neighbor_radius_of_spacing(lengths);
  }
  else if (parameters.keep_density)
    input_density_weights.assign(points.size(), Local(1)); // sparse points shall not count more than dense ones
  Samples<FT> samples(allocator);
  Followers followers(allocator);
  {
    const Buffer<std::uint64_t> no_areas(allocator);
    Initial_samples start = initialize_samples<ConcurrencyTag>(grid, points, normals,
                                                               parameters.keep_density ? no_areas : areas.units, m,
                                                               lengths.radius, parameters.random_seed, progress);
    followers = take_followers<ConcurrencyTag>(lengths, start);
    samples.positions = std::move(start.positions);
    const std::size_t size = samples.positions.size();
    samples.normals.reserve(size);
    const auto for_each_source = [&](const auto& f) {
      for_each_in_order(size, [&](std::size_t i) { f(start.sources[i]); });
    };
    for_each_source([&](Index source) { samples.normals.push_back(normals[source].cast<FT>().normalized()); });
    if (parameters.method == Method::DEFAULT && parameters.keep_density)
      for_each_source([&](Index source) {
        samples.spacings.push_back(FT(std::sqrt(areas.of_point(source) * double(points.size()) / double(m))));
      });
    if (parameters.method == Method::DEFAULT)
    {
      const auto starts_on_point = [&](std::size_t i) { return samples.positions[i] == points[start.sources[i]]; };
      std::size_t number_on_points = 0;
      for_each_in_order(size, [&](std::size_t i) { number_on_points += starts_on_point(i); });
      const Choice_of_voters choice(parameters.random_seed, lengths.radius, lengths.sample_spacing, m, number_on_points);
      samples.are_voters.reserve(size);
      for_each_in_order(size, [&](std::size_t i) {
        samples.are_voters.push_back(starts_on_point(i) && choice.takes(start.sources[i]));
      });
    }
    if (!hints.empty())
      for_each_source([&](Index source) { samples.hints.push_back(hints[source].template cast<FT>()); });
    release(hints);
    if (!followers.is_empty())
      for_each_in_order(size, [&](std::size_t i) { samples.start_indices.push_back(Index(i)); });
    fill_buffer(size, FT(0), samples.fit_weights);
    samples.fit_centroids = copy_of(samples.positions);
    release(areas.units);
  }

  // Section 3.2 and 3.3: Eq. (6) by Algorithm 1
  const Minimization_parameters minimization{
    square(lengths.radius),
    squared_bandwidth,
    sparsity_unit_factor * lengths.radius,
    jump_in_sheet_heights(parameters.method, largest_shrunk_jump_per_sheet_height, lengths.noise, lengths.radius),
    jump_in_sheet_heights(parameters.method, regularized_jump_per_sheet_height, lengths.noise, lengths.radius),
    parameters.method == Method::DEFAULT ? lengths.self_neighbor_radius : std::numeric_limits<double>::infinity(),
    half_width_of_shrinkage(parameters.method),
    parameters.normal_weight,
    parameters.regularization_weight,
    parameters.initial_penalty,
    parameters.maximum_penalty,
    parameters.penalty_growth,
    parameters.method == Method::ALOR};
  const double compatible_bandwidth = normal_bandwidth(fit_angle_factor * parameters.sharpness_angle);
  const double squared_sheet_height = square(sheet_height(lengths.noise, lengths.radius));
  if (parameters.method == Method::DEFAULT)
  {
    progress.begin_stage("L0 minimization", 0.32, (3 * minimization.number_of_turns() + 1) * m);
    const Fit_input<Local> fit_input{
      grid, points, normals, input_density_weights, lengths.radius, squared_sheet_height, compatible_bandwidth};
    const Refinement_parameters refinement{
      lengths.self_neighbor_radius, lengths.sample_spacing, number_of_repulsion_steps,
      Sample_refit_kernel(lengths.self_neighbor_radius,
                          normal_bandwidth(sample_refit_angle_factor * parameters.sharpness_angle)),
      number_of_sample_refits};
    report.number_of_self_neighbor_pairs = minimize_with_refinement<ConcurrencyTag>(
      minimization, refinement, fit_input, solver, progress, samples, report.iterations);
    release(points);
    release(normals);
    release(input_density_weights);
  }
  else
  {
    Fit_rows fit_rows{Buffer<std::size_t>(allocator), Buffer<Vector>(allocator), Buffer<double>(allocator)};
    Neighborhoods neighbors{Buffer<std::size_t>(allocator), Buffer<Index>(allocator)};
    {
      const Search_grid_3 sample_grid(samples.positions, lengths.cell_size);
      progress.begin_stage("original neighbors", 0.1, m);
      report.number_of_lonely_samples = collapse_fit_term<ConcurrencyTag>(sample_grid, samples.positions, grid, points,
                                                                          input_density_weights, lengths.radius,
                                                                          followers.numbers_of_samples, progress,
                                                                          samples.fit_weights, samples.fit_centroids);
      if (SolverTraits::needs_explicit_rows)
      {
        // Section 4.1. Merging changes the rows of Eq. (11) and not the collapsed terms, so only such solvers see Algorithm 2.
        progress.begin_stage("fit rows", 0.1, 2 * m);
        fit_rows = gather_fit_rows<ConcurrencyTag>(sample_grid, samples.positions, grid, points, input_density_weights,
                                                   lengths.radius, parameters.method == Method::ALOR ? 2 : 0, progress);
      }
      release(points);
      release(normals);
      release(input_density_weights);
      grid = Search_grid_3(points, lengths.cell_size); // of no points
    }

    progress.begin_stage("self neighbors", 0.03, 2 * m);
    {
      const double self_cell_size = (std::max)(lengths.self_neighbor_radius, lengths.smallest_cell_size);
      const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(samples.positions, self_cell_size);
      apply_order<ConcurrencyTag>(order, samples);
      if (SolverTraits::needs_explicit_rows)
        apply_order(order, fit_rows);
      const Search_grid_3 self_grid(samples.positions, self_cell_size);
      neighbors = find_self_neighbors<ConcurrencyTag>(self_grid, samples.positions, lengths.self_neighbor_radius,
                                                      progress);
    }
    report.number_of_self_neighbor_pairs = neighbors.indices.size();

    progress.begin_stage("L0 minimization", 0.2, minimization.number_of_turns());
    minimize_alternatingly<ConcurrencyTag>(minimization, neighbors, fit_rows, solver, progress, samples,
                                           report.iterations);
  }
  for (const Iteration_report& iteration : report.iterations)
    report.converged = report.converged && iteration.solver.converged;

  progress.begin_stage("orient normals", 0.1, m);
  const Orientation orientation = turn_normals<ConcurrencyTag>(parameters, frame, lengths.sample_spacing, progress,
                                                               samples);
  report.oriented_share = orientation.oriented_share;
  report.hinted_share = orientation.hinted_share;

  if (parameters.method == Method::DEFAULT)
  {
    // not before the signs, which pass from face to face through normals that lean over the edge: planes and quadrics leave none of these
    progress.begin_stage("settle on quadrics", 0.03, m);
    settle_on_quadrics<ConcurrencyTag, Local>({quadric_radius_factor * lengths.radius, compatible_bandwidth,
                                               squared_sheet_height},
                                              lengths.smallest_cell_size, progress, samples);
  }

  Buffer<float> feature_confidences(allocator);
  if (parameters.with_feature_confidences)
  {
    progress.begin_stage("feature confidences", 0.05, m);
    estimate_feature_confidences<ConcurrencyTag>(samples.positions, samples.normals, lengths.sample_spacing,
                                                 compatible_bandwidth, progress, feature_confidences);
  }
  progress.end_stage();
  followers.append_values(samples.start_indices, samples.normals);
  followers.append_values(samples.start_indices, feature_confidences);
  followers.append_positions(samples.start_indices, samples.positions);

  const std::size_t samples_per_task = 4096;
  for_each_block<ConcurrencyTag>(m, samples_per_task, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      samples.positions[i] = frame.leave(samples.positions[i]);
  });
  return {std::move(samples.positions), std::move(samples.normals), std::move(feature_confidences)};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RESAMPLE_H
