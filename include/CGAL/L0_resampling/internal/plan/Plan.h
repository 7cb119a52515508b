// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PLAN_H
#define CGAL_L0_RESAMPLING_INTERNAL_PLAN_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>
#include <CGAL/L0_resampling/internal/kernels/Fit_kernel.h>
#include <CGAL/L0_resampling/internal/kernels/chebyshev_steps.h>
#include <CGAL/L0_resampling/internal/kernels/lengths_of_refinement.h>
#include <CGAL/L0_resampling/internal/kernels/scale_field.h>
#include <CGAL/L0_resampling/internal/kernels/scales_of_balls.h>
#include <CGAL/L0_resampling/internal/plan/Method_rules.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What has to be known of the whole cloud before a call can be planned. Lengths are in any one
/// unit.
struct Facts
{
  std::size_t number_of_points;
  double box_diagonal;    ///< of the bounding box
  double robust_diagonal; ///< the same without far outliers
  int exponent_of_input;  ///< a length of the input times 2 to the power of this is one of these
  Scales scales = {0, 0}; ///< in units of `paper_radius()`; known if the method estimates them
};

/// The radius itself, but at most the diagonal of the bounding box, which reaches all points, and
/// not so small that a `float` cannot hold the extent of the cloud in units of it. 1 if all points
/// are one.
inline double sensible_radius(double radius, double box_diagonal)
{
  if (!(box_diagonal > 0))
    return 1;
  return (std::min)((std::max)(radius, std::ldexp(box_diagonal, -100)), box_diagonal);
}

/// \f$ l_{diag} / \sqrt[3]{n} \f$, the radius of the paper.
inline double paper_radius(const Facts& facts)
{
  return sensible_radius(facts.robust_diagonal / std::cbrt(double(facts.number_of_points)),
                         facts.box_diagonal);
}

/// \f$ (1 - \cos\sigma_n)^2 \f$ of Eq. (2), for an angle in degrees; never so small that its
/// inverse is not finite.
inline double normal_bandwidth(double angle)
{
  const double pi = 3.141592653589793;
  return (std::max)(square(1 - std::cos(angle * pi / 180)), 1e-12);
}

/// How many others of an even set, each of which has a square to itself, are in a disk; at
/// least one.
/// \param radius per spacing of the set
inline double even_number_of_neighbors(double radius)
{
  const double pi = 3.141592653589793;
  return (std::max)(pi * square(radius) - 1, 1.);
}

/// One time that lines 2 to 5 of Algorithm 1 run.
struct Turn
{
  std::size_t number; ///< from 0
  double penalty;     ///< \f$ \beta \f$
  bool regularizes;   ///< whether the second term of Eq. (7) takes part
};

/// The weights of Algorithm 1 in the working frame.
struct Minimization_parameters
{
  double squared_radius;    ///< \f$ r_p^2 \f$
  double squared_bandwidth; ///< \f$ \sigma_q^2 \f$
  double sparsity_unit;     ///< length in which \f$ \sqrt{\lambda/\beta} \f$ is read
  double maximum_jump;      ///< J of `pair_weight()`, a length; infinite in LOR and ALOR
  double range_of_pairs;    ///< of the self neighbors; infinite in LOR and ALOR
  /// \f$ \eta_S \f$ of Eq. (5): of an even set, so that no sample depends on all others; in LOR and
  /// ALOR 0, for the mean of all samples
  double mean_number_of_neighbors;
  double half_width_of_shrinkage; ///< see `Shrunk_jumps`; 0 in LOR and ALOR
  double normal_weight;           ///< \f$ \lambda \f$
  double regularization_weight;   ///< \f$ \alpha \f$
  double initial_penalty, maximum_penalty, penalty_growth; ///< \f$ \beta, \beta_{max}, \mu \f$
  bool interleave_regularization; ///< Section 4.2: regularize in every second iteration only
  double coupling = 1;            ///< as for `internal::low_end_of_spectrum()`

  std::vector<Turn> turns() const
  {
    std::vector<Turn> turns;
    for (double penalty = initial_penalty; turns.empty() || penalty <= maximum_penalty;
         penalty = next_penalty(penalty, penalty_growth))
      turns.push_back({turns.size(), penalty, !interleave_regularization || turns.size() % 2 == 0});
    return turns;
  }

  /// Of the matrix of a turn.
  double low_end_of_spectrum(const Turn& turn) const
  {
    return internal::low_end_of_spectrum(turn.regularizes ? regularization_weight : 0, turn.penalty,
                                         coupling);
  }
};

/*!
What the stages of a call do: every length, bandwidth, weight and switch. The method that the caller
asked for is not known below. Lengths are in the unit of the working frame, which is r_p.
*/
struct Plan
{
  double unit; ///< r_p, in the unit of the facts

  double radius;             ///< \f$ r_p \f$: 1
  double maximum_radius = 1; ///< of any place; the same unless scales differ
  double isolated_radius;    ///< within which samples start around a lone point; 0 if all are one
  double filter_radius;      ///< \f$ r_q \f$
  double pca_radius;
  double noise;             ///< standard deviation across the surface; 0 if it has no part
  bool is_noise_known;      ///< by the caller, so that it is not estimated
  double sheet_height;      ///< H
  double cell_size;         ///< of the grid of the points
  double extent;            ///< the diagonal of the cloud without far outliers
  double minimum_cell_size; ///< of any grid
  double point_spacing;     ///< of the points
  double sample_spacing;    ///< of an even set of the samples
  double self_neighbor_radius;

  double squared_bandwidth;    ///< \f$ \sigma_q^2 \f$
  double normal_bandwidth;     ///< of the filter of normals
  double compatible_bandwidth; ///< of what compares normals of one face

  std::size_t number_of_filter_passes; ///< over the normals of the points
  std::size_t number_of_refits;        ///< before as many of the last of these passes
  std::size_t number_of_half_samplings;
  std::size_t number_of_samples; ///< m
  std::size_t number_of_orientation_neighbors;
  std::size_t random_seed;

  bool looks_beyond_strips; ///< the first normals of points in a strip, see `normal_beyond_strip()`
  bool follows_scales;      ///< the radius and what follows from it are larger or smaller by places
  double outlier_sensitivity; ///< 0 if no points are left out as outliers
  bool uses_areas;     ///< the area that each point stands for tells the spacing of the samples
  bool starts_evenly;  ///< samples start evenly by area; else as the points do
  bool weighs_density; ///< by Eq. (5) of the input
  bool keeps_spacings; ///< the samples have the spacing of the input around each, times one factor
  bool refines; ///< Algorithm 1 as the default method runs it, and projection to local quadrics
  bool finds_feature_confidences, finds_noises, finds_deviations;

  Minimization_parameters minimization;

  /// Sets the spacing of the samples, and what follows from it. It is bounded so that the squares
  /// of distances within it are finite in single precision: a filter radius may be of any length.
  void set_sample_spacing(double spacing)
  {
    sample_spacing = (std::min)(spacing, 1e15 * radius);
    if (refines)
    {
      // Beyond r_p the surface may bend away, and the fit could not hold a sample that the other
      // terms move.
      self_neighbor_radius = keeps_spacings ? maximum_radius
                                            : (std::min)(spreading_radius(), maximum_radius);
      minimization.range_of_pairs = self_neighbor_radius;
      minimization.mean_number_of_neighbors = even_number_of_neighbors(self_neighbor_radius
                                                                       / sample_spacing);
    }
  }

  bool drops_outliers() const { return outlier_sensitivity > 0; }

  /// Whether the normals are corrected by the positions before this pass of the filter.
  bool refits_before(std::size_t pass) const
  {
    return pass + number_of_refits >= number_of_filter_passes;
  }

  /// What weighs the points around a point or sample where a surface is fitted to them: where the
  /// normals of the points are refitted, in the fit of the samples, where their normals are, and
  /// where planes and quadrics of wide balls are fitted to samples. At scale 1.
  Fit_kernel<double> kernel_of_points() const
  {
    return {filter_radius, squared_bandwidth, compatible_bandwidth, square(sheet_height)};
  }
  Fit_kernel<double> kernel_of_fit() const
  {
    return {radius, square(fit_bandwidth_factor * radius), compatible_bandwidth,
            square(sheet_height)};
  }
  Fit_kernel<double> kernel_of_wide_balls() const
  {
    return {quadric_radius_factor * radius, std::numeric_limits<double>::infinity(),
            compatible_bandwidth, square(sheet_height)};
  }

  Lengths_of_refinement lengths_of_refinement() const
  {
    return {unit_per_point_spacing * point_spacing, noise, sample_spacing, is_noise_known};
  }

  /// Whether the refinement can tell anything: if an even set of the samples has as many disks in
  /// the ball of the reference as a quadric takes.
  bool has_disks_enough() const
  {
    const double fewest = 10;
    return even_number_of_neighbors(radius_of_fit(scale_of_reference) * lengths_of_refinement().unit
                                    / sample_spacing)
           >= fewest;
  }

  double area_radius() const { return inner_radius_factor * longest_query(); }
  /// Of the samples that repel each other; the largest, where each has its own.
  double spreading_radius() const
  {
    return keeps_spacings ? double(maximum_scale) * radius
                          : self_neighbor_radius_per_spacing * sample_spacing;
  }
  /// Whether samples that have neighbors within `range` share the cells of the points: if these are
  /// no smaller, and not so much larger that a block has more samples than are looked at.
  bool are_cells_shared(double range) const
  {
    return refines && range <= cell_size && 3 * range >= cell_size;
  }

  /// Of the cells by which samples are sorted before their sides are found.
  double cell_size_of_places() const { return (std::max)(sample_spacing, minimum_cell_size); }

  /// Of the grid of the samples in which neighbors are found: those that the energy couples, and
  /// those that repel each other.
  /// \param have_scales whether the samples have scales, so that more of them repel each other
  double sample_cell_size(bool have_scales) const
  {
    if (!refines || keeps_spacings)
      return self_cell_size();
    const double range = have_scales ? spreading_radius() : self_neighbor_radius;
    return !have_scales && are_cells_shared(range) ? cell_size
                                                   : (std::max)(range, minimum_cell_size);
  }

  double longest_query() const { return (std::max)(radius, filter_radius); }
  /// Of the grid of the samples in which self neighbors are found.
  double self_cell_size() const
  {
    return (std::max)(keeps_spacings ? radius : self_neighbor_radius, minimum_cell_size);
  }
};

/// The scales by which a call is planned: the estimated ones, or the noise that the caller knows.
/// In units of `paper_radius()`.
inline Scales known_scales(const Parameters& parameters, const Facts& facts)
{
  Scales scales = facts.scales;
  if (parameters.noise > 0)
    scales.noise = (std::min)(std::ldexp(parameters.noise, facts.exponent_of_input),
                              facts.box_diagonal)
                   / paper_radius(facts);
  return scales;
}

/// The radius of the default method where the caller has not chosen it, in the unit of the facts.
inline double estimated_radius(const Scales& scales, const Facts& facts)
{
  return sensible_radius(default_radius(scales.spacing, scales.noise) * paper_radius(facts),
                         facts.box_diagonal);
}

/// Chooses what the caller left open: the radius by the paper's rule, or by the spacing and the
/// noise of the points for the default method.
/// \param parameters checked
inline Plan make_plan(const Parameters& parameters, const Facts& facts)
{
  const Method_rules rules = rules_of(parameters.method);
  const double paper = paper_radius(facts), infinity = std::numeric_limits<double>::infinity();
  const double n = double(facts.number_of_points), m = double(parameters.number_of_output_points);
  const Scales scales = known_scales(parameters, facts);
  Plan plan;
  double radius = rules.estimates_scales ? estimated_radius(scales, facts) : paper;
  if (parameters.neighbor_radius > 0)
    radius = std::ldexp(parameters.neighbor_radius, facts.exponent_of_input);
  radius = sensible_radius(radius, facts.box_diagonal);

  plan.unit = radius;
  plan.radius = 1;
  plan.isolated_radius = facts.box_diagonal > 0 ? plan.radius : 0;
  // less where the caller has chosen a ball that would not hold so much
  plan.noise = rules.estimates_scales
                 ? (std::min)(scales.noise * paper / radius, maximum_noise_per_radius)
                 : 0;
  plan.is_noise_known = parameters.noise > 0;
  plan.point_spacing = scales.spacing * paper / radius;
  plan.sheet_height = sheet_height(plan.noise, plan.radius);
  plan.filter_radius = plan.radius;
  if (parameters.normal_filter_radius > 0)
    plan.filter_radius = (std::max)(
      sensible_radius(std::ldexp(parameters.normal_filter_radius, facts.exponent_of_input),
                      facts.box_diagonal)
        / radius,
      minimum_filter_radius_factor);
  plan.pca_radius = inner_radius_factor * plan.radius;
  // A radius far below the spacing would spread the cloud over more cells than a grid can number.
  plan.extent = facts.robust_diagonal / radius;
  plan.minimum_cell_size = std::ldexp(plan.extent, -18);
  // The balls of the filter reach one cell far, or two if they are the larger ones: cells as large
  // as that share a block of candidates among many queries.
  plan.cell_size = (std::max)(plan.filter_radius > plan.radius ? plan.filter_radius / 2
                                                               : plan.radius,
                              plan.minimum_cell_size);

  plan.squared_bandwidth = square(spatial_bandwidth_factor * plan.filter_radius);
  plan.normal_bandwidth = normal_bandwidth(parameters.sharpness_angle);
  plan.compatible_bandwidth = normal_bandwidth(fit_angle_factor * parameters.sharpness_angle);

  plan.number_of_filter_passes = parameters.number_of_normal_filter_iterations;
  plan.number_of_refits = (std::min)(rules.number_of_normal_refits, plan.number_of_filter_passes);
  plan.number_of_half_samplings = rules.number_of_half_samplings;
  plan.number_of_samples = parameters.number_of_output_points;
  plan.number_of_orientation_neighbors = parameters.number_of_orientation_neighbors;
  plan.random_seed = parameters.random_seed;

  plan.looks_beyond_strips = rules.looks_beyond_strips;
  plan.follows_scales = rules.estimates_scales;
  plan.outlier_sensitivity = parameters.outlier_sensitivity;
  plan.uses_areas = rules.uses_areas;
  plan.starts_evenly = rules.uses_areas && !parameters.keep_density;
  plan.weighs_density = rules.uses_areas || !parameters.keep_density;
  plan.keeps_spacings = rules.uses_areas && parameters.keep_density;
  plan.refines = rules.refines;
  plan.finds_feature_confidences = parameters.with_feature_confidences;
  plan.finds_noises = parameters.with_noises;
  plan.finds_deviations = parameters.with_deviations;

  plan.minimization = {square(plan.radius),
                       plan.squared_bandwidth,
                       sparsity_unit_factor * plan.radius,
                       rules.limits_jumps ? minimum_height_between_sheets * plan.sheet_height
                                          : infinity,
                       infinity,
                       0,
                       rules.limits_jumps ? half_width_of_firm_shrinkage : 0,
                       parameters.normal_weight,
                       parameters.regularization_weight,
                       parameters.initial_penalty,
                       parameters.maximum_penalty,
                       parameters.penalty_growth,
                       rules.interleaves_regularization};
  plan.self_neighbor_radius = self_neighbor_radius_factor * plan.radius;
  // without scales: a surface through the middle of a cube of that diagonal, evenly sampled
  const double spacing = rules.estimates_scales ? scales.spacing * paper * std::sqrt(n / m) / radius
                                                : facts.robust_diagonal / std::sqrt(m) / radius;
  // if all points but outliers are at one place, any length will do
  plan.set_sample_spacing(spacing > 0 ? spacing : plan.radius);
  return plan;
}

/// Notes the radii of a call, in the unit of the input.
/// \param report of the CPU or of the device
/// \param frame whose unit is \f$ r_p \f$
template <typename Frame, typename Report>
void report_radii(const Plan& plan, const Range_of_scales& scales, const Frame& frame,
                  Report& report)
{
  report.neighbor_radius = frame.length_of_input(plan.radius);
  report.least_neighbor_radius = frame.length_of_input(plan.radius * scales.least);
  report.median_neighbor_radius = frame.length_of_input(plan.radius * scales.median);
  report.largest_neighbor_radius = frame.length_of_input(plan.radius * scales.largest);
  report.normal_filter_radius = frame.length_of_input(plan.filter_radius);
}

/// What the field of scales is measured by, in the unit of the facts.
inline Reference_scales reference_scales(const Parameters& parameters, const Plan& plan,
                                         const Facts& facts)
{
  const double paper = paper_radius(facts);
  const Scales scales = known_scales(parameters, facts);
  return {plan.unit, estimated_radius(scales, facts), scales.spacing * paper, scales.noise * paper,
          plan.is_noise_known};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PLAN_H
