// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgL0ResamplingConcepts

Solves Eq. (10), the quadratic step of Algorithm 1.

\cgalConcept

A model is passed to `CGAL::l0_resample_point_set()` with the named parameter
`sparse_linear_solver`. The function works on a copy, which it keeps from the first step to the
last, so that a model may reuse what it has allocated.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::L0_resampling::Block_chebyshev_solver_traits<FT, ConcurrencyTag>}
\cgalHasModels{CGAL::L0_resampling::Block_conjugate_gradient_solver_traits<FT, ConcurrencyTag>}
\cgalHasModels{CGAL::L0_resampling::Eigen_cholesky_solver_traits<FT>}
\cgalHasModels{CGAL::L0_resampling::Eigen_least_squares_solver_traits<FT>}
\cgalHasModels{CGAL::L0_resampling::CUDA_least_squares_solver_traits<FT>}
\cgalHasModelsEnd
*/
class L0ResamplingSolverTraits
{
public:
  /// The number type of the problems it solves, `double` or `float`.
  /// `CGAL::l0_resample_point_set()` makes the problems in this type.
  typedef unspecified_type FT;

  /// Whether `solve()` reads `Quadratic_problem::rows`. Making them costs time and, with many
  /// neighbors, much memory; a model that declares `false` gets a null pointer.
  static constexpr bool needs_explicit_rows = unspecified;

  /// What `solve()` books with `Quadratic_problem::memory` for each sample at least, so that a
  /// `maximum_memory` that does not suffice is refused early. A model need not have it.
  static constexpr std::size_t bytes_per_sample = unspecified;

  /*!
  Minimizes Eq. (10).

  Models stop by the same rule, as soon as
  \f$ \|A^T(b - Ax)\| \leq \mathrm{tolerance} \cdot s \f$, in terms of `Quadratic_problem`
  \f$ \|g - Hx\| \leq \mathrm{tolerance} \cdot s \f$, or when it has spent its maximum number of
  iterations. The scale \f$ s \f$ is \f$ \|g\| \f$ or `Quadratic_problem::right_hand_side_scale`,
  whichever is larger. Both limits are set when the model is constructed; a tolerance outside of (0,
  1) is refused there with `std::invalid_argument`. A direct solver applies the rule to what it has
  found.

  Running out of iterations is no error: Algorithm 1 lives well with inexact solves. An initial
  guess that fulfills the rule costs no iteration. A model may also know the number of its
  iterations beforehand, as `CGAL::L0_resampling::Block_chebyshev_solver_traits` does; then it takes
  these, whatever the residual is, and the rule only decides whether it has converged. Where
  \f$ A^T b = 0 \f$, the solution is zero, with a relative residual of 0.

  \param problem what to minimize; the arrays belong to the caller and are not kept. A model whose
  own arrays shall
         count for the caller's `maximum_memory` books them with `problem.memory`.
  \param x the displacements of the samples, xyz interleaved; the initial guess on entry, which a
  direct solver need not
           read, and the solution on exit

  \returns the iterations spent, the relative residual \f$ \|A^T(b - Ax)\| / s \f$ on exit, and
  whether it
           reached the tolerance

  \pre `x.size() == 3 * problem.number_of_samples()`; zero samples are allowed

  \throws CGAL::L0_resampling::Solver_error with a sentence of explanation if there is no answer:
  the problem or the
          initial guess has values that are not finite, or the factorization or the recurrence
          breaks down
  \throws std::bad_alloc if there is not enough memory
  */
  CGAL::L0_resampling::Solver_report solve(
    const CGAL::L0_resampling::Quadratic_problem<FT>& problem,
    Eigen::Ref<Eigen::Matrix<FT, Eigen::Dynamic, 1>> x);
};
