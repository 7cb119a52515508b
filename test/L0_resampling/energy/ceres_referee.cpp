// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/ceres_referee.h"

#include <ceres/ceres.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace {

using test::Vector;

/// sqrt(weight) * (p_i - q), Eq. (10), first sum
struct Fit_residual
{
  double scale;
  Vector q;

  template <typename T>
  bool operator()(const T* p, T* residual) const
  {
    for (Eigen::Index c = 0; c < 3; ++c)
      residual[c] = scale * (p[c] - q[c]);
    return true;
  }
};

/// sqrt(weight) * (p_i - p_k), second sum
struct Regularization_residual
{
  double scale;

  template <typename T>
  bool operator()(const T* p, const T* other, T* residual) const
  {
    for (int c = 0; c < 3; ++c)
      residual[c] = scale * (p[c] - other[c]);
    return true;
  }
};

/// sqrt(beta) * (n_i^T (p_i - p_k) - delta_ik), third sum
struct Normal_residual
{
  double scale;
  Vector normal;
  double offset;

  template <typename T>
  bool operator()(const T* p, const T* other, T* residual) const
  {
    residual[0] = T(-offset);
    for (Eigen::Index c = 0; c < 3; ++c)
      residual[0] += normal[c] * (p[c] - other[c]);
    residual[0] *= scale;
    return true;
  }
};

} // namespace

Eigen::VectorXd test::solve_with_ceres(const Paper_problem& paper)
{
  std::vector<Vector> p = paper.samples;
  ceres::Problem problem;
  for (const auto& t : paper.fit)
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Fit_residual, 3, 3>(
                               new Fit_residual{std::sqrt(1 / t.v), t.q}),
                             nullptr, p[t.i].data());
  for (const auto& t : paper.pairs)
  {
    if (paper.alpha > 0)
      problem.AddResidualBlock(
        new ceres::AutoDiffCostFunction<Regularization_residual, 3, 3, 3>(
          new Regularization_residual{std::sqrt(paper.alpha * t.stretch / paper.densities[t.i])}),
        nullptr, p[t.i].data(), p[t.k].data());
    problem.AddResidualBlock(
      new ceres::AutoDiffCostFunction<Normal_residual, 1, 3, 3>(
        new Normal_residual{std::sqrt(paper.beta), paper.normals[t.i], t.offset}),
      nullptr, p[t.i].data(), p[t.k].data());
  }

  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.initial_trust_region_radius = 1e16; // no damping: the problem is quadratic
  options.max_trust_region_radius = 1e32;
  options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = 1e-16;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable())
    throw std::runtime_error(summary.message);
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] -= paper.samples[i];
  return coordinates(p);
}
