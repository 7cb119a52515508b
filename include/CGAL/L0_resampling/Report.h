// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_REPORT_H
#define CGAL_L0_RESAMPLING_REPORT_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Solver_report.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// How a call ended that did not throw.
enum class Outcome
{
  COMPLETED, ///< the result was written
  CANCELLED  ///< the callback returned `false`; nothing was written
};

/// \ingroup PkgL0ResamplingRef
/// One stage of a call, in the order of execution.
struct Stage_report
{
  std::string name;           ///< such as `"filter normals"`
  double seconds = 0;         ///< wall-clock time
  std::size_t peak_bytes = 0; ///< most memory held by the call's own arrays during the stage
};

/*!
\ingroup PkgL0ResamplingRef

One outer iteration of Algorithm 1. The energies are the terms of Eq. (7) after line 2, the choice
of the offsets, in units of the squared radius \f$ r_p^2 \f$; the fit term leaves out the constant
that does not depend on the samples.
*/
struct Iteration_report
{
  double penalty = 0;      ///< \f$ \beta \f$
  bool regularized = true; ///< `false` in the iterations that interleaved regularization skips
  double fit_energy = 0;   ///< \f$ \sum W_i \|p_i - c_i\|^2 \f$
  double regularization_energy = 0; ///< the second term of Eq. (7); 0 where not `regularized`
  double normal_energy = 0;         ///< \f$ \beta \sum (n_i^T(p_i - p_{i'}) - \delta_{ii'})^2 \f$
  double sparsity_energy = 0;       ///< \f$ \lambda \|\delta\|_0 \f$, \f$ \lambda \f$ as in Eq. (8)
  double active_pair_share = 0;     ///< share of pairs with \f$ \delta_{ii'} \neq 0 \f$
  Solver_report solver;             ///< the solve of Eq. (10)
};

/*!
\ingroup PkgL0ResamplingRef

What a call of `CGAL::l0_resample_point_set()` did. Pass the address of one with the named parameter
`resampling_report`; it is reset on entry and filled as far as the call came, also when the call
throws.
*/
struct Report
{
  Outcome outcome = Outcome::COMPLETED; ///< how the call ended, unless it threw

  std::size_t number_of_input_points = 0;   ///< points used, without the dropped ones
  std::size_t number_of_dropped_points = 0; ///< non-finite points, with `drop_non_finite(true)`
  std::size_t number_of_outliers =
    0; ///< points off the cloud that were left out, with `drop_outliers(true)`
  std::size_t number_of_distinct_points = 0; ///< of the points used, without outliers
  std::size_t number_of_output_points = 0;   ///< points that were written
  /// Points whose ball of \f$ 0.7 r_p \f$ spans no plane, or holds fewer than six points, and, of
  /// the default method, those on a line: in that ball and in one twice as large the points are a
  /// third as wide as long, or less. If all points have normals, no planes are fitted, and those
  /// with fewer than six points in their ball of \f$ r_q \f$ count.
  std::size_t number_of_degenerate_neighborhoods = 0;
  /// Samples without an original neighbor, which stay where they start. In the default method
  /// samples without a compatible one in the last fit: they end where they were last fitted.
  std::size_t number_of_lonely_samples = 0;
  /// Samples whose points scatter more than those of one surface with the estimated noise do:
  /// around them two sheets may have become one, or the noise is larger; default method only.
  std::size_t number_of_unexplained_samples = 0;
  /// The unexplained sample that has most of the others within `unexplained_radius`: where to look
  /// for what the result does not explain. In the coordinates of the input.
  std::array<double, 3> unexplained_center = {0, 0, 0};
  double unexplained_radius = 0; ///< in the unit of the input; 0 if all is explained
  std::size_t number_of_unexplained_samples_there = 0; ///< within that radius
  std::size_t number_of_self_neighbor_pairs =
    0; ///< ordered pairs \f$ (i, i') \f$ of the normal term

  double neighbor_radius = 0; ///< \f$ r_p \f$, in the unit of the input
  /// The least radius around a point, in the unit of the input. It, the median and the largest are
  /// \f$ r_p \f$, unless the default method follows a spacing or a noise that varies.
  double least_neighbor_radius = 0;
  double median_neighbor_radius = 0;  ///< of the radii around the points
  double largest_neighbor_radius = 0; ///< of the radii around the points
  double normal_filter_radius = 0;    ///< \f$ r_q \f$, in the unit of the input
  double estimated_spacing =
    /// square root of the area a point mid-surface, in the unit of the input; default method only
    0;
  double estimated_noise =
    /// standard deviation across the surface, in the unit of the input: estimated, or the `noise`
    /// of the call; default method only
    0;
  double sample_spacing =
    0; ///< square root of the area a point of the result, in the unit of the input; where points
       ///< keep their density, or with `LOR` and `ALOR`, 0
  /// Share of the samples to which one sign was propagated, over edges beyond doubt, in [0, 1].
  /// Samples that face their viewpoints for certain count as joined to each other. It does not say
  /// how many normals are on the right side: `right_side_share` does.
  double oriented_share = 0;
  /// Expected share of the samples whose normals are on the right side, in [0, 1]: the mean of what
  /// `side_confidence_map` gets. About 0.5 says that the side of the whole is a guess.
  double right_side_share = 0;
  /// Share of the samples in [0, 1] whose side `viewpoint`, `viewpoint_map`, `up_direction` or
  /// `orientation_hint_map` decided: their own, or that of what they are joined to.
  double hinted_share = 0;
  /// Diagonal of the bounding box of the result per that of the input, in [0, 1]. At either end of
  /// each axis 0.5 % of the input points and 2.6 standard deviations of the noise (if it is
  /// estimated) do not count, and half a spacing of the samples counts as reached.
  double extent_share = 1;

  std::vector<Iteration_report> iterations; ///< one for each value of the penalty
  bool converged = true;                    ///< whether every solve converged

  std::vector<Stage_report> stages; ///< in the order of execution
  std::size_t peak_bytes =
    0; ///< most memory held by the call's own arrays, input and output not counted

  std::string device = "cpu"; ///< `"cpu"` or `"cuda"`
  std::string device_reason;  ///< why that device was taken
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_REPORT_H
