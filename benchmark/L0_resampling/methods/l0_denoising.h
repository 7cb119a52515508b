// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_L0_DENOISING_H
#define CGAL_L0_RESAMPLING_BENCHMARK_L0_DENOISING_H

#include "Gaussian_mixture.h"
#include "Point_tree.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

// LOD (Sun et al. 2015, "Denoising point sets via L0 minimization"): normals that are constant but
// for jumps, then points whose tangent planes agree with their neighbors but for jumps, then points
// at jumps onto the edge. The upsampling that follows there is left out, as in the paper that we
// compare with. Lengths are in units of the average spacing.

namespace L0_benchmark {

/// n x 3: row i belongs to point i.
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Unordered pairs of neighbors.
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

struct L0_denoising_parameters
{
  unsigned number_of_neighbors = 12;
  double normal_weight = 0.05;  ///< lambda of the normals
  double position_weight = 0.1; ///< lambda of the positions, in squared spacings
  double growth = 2;            ///< kappa: the penalty begins at 2 lambda and grows by this factor
  double last_normal_penalty = 1e3;
  double last_position_penalty = 1e2;
  double edge_angle = 30; ///< degrees between normals of neighbors on two sides of an edge
};

inline Pairs neighbor_pairs(const std::vector<Point_3>& points, unsigned number_of_neighbors)
{
  const Point_tree tree(points);
  std::set<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j : tree.nearest(points[i], number_of_neighbors + 1))
      if (j != i)
        pairs.insert(std::minmax(i, j));
  return {pairs.begin(), pairs.end()};
}

/// Solves a symmetric positive definite system, one for each column of `rhs`, from the guess `x`.
template <typename Right_hand_side>
Right_hand_side solve(const Eigen::SparseMatrix<double>& matrix, const Right_hand_side& rhs,
                      const Right_hand_side& x)
{
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(matrix);
  solver.setTolerance(1e-6);
  Right_hand_side solution = solver.solveWithGuess(rhs, x);
  if (!solution.allFinite())
    throw std::runtime_error("L0 denoising: a linear system has no finite solution");
  return solution;
}

/// Minimizes sum |n_i - m_i|^2 + lambda * sum over pairs |n_i - n_j|_0 over vectors n_i, which are
/// made unit after each turn. m_i are the `normals`, consistently oriented.
inline Rows denoised_normals(const Rows& normals, const Pairs& pairs,
                             const L0_denoising_parameters& parameters)
{
  Rows result = normals;
  for (double penalty = 2 * parameters.normal_weight; penalty <= parameters.last_normal_penalty;
       penalty *= parameters.growth) {
    const double threshold = parameters.normal_weight / penalty;
    std::vector<Eigen::Triplet<double>> entries;
    Rows rhs = normals;
    for (Eigen::Index i = 0; i < normals.rows(); ++i)
      entries.emplace_back(i, i, 1);
    for (const auto& [first, second] : pairs) {
      const auto i = Eigen::Index(first), j = Eigen::Index(second);
      for (const auto& [row, column] : {std::pair(i, j), std::pair(j, i)}) {
        entries.emplace_back(row, row, penalty);
        entries.emplace_back(row, column, -penalty);
      }
      const Eigen::RowVector3d difference = result.row(i) - result.row(j);
      if (difference.squaredNorm() > threshold) { // a jump: the auxiliary variable takes it up
        rhs.row(i) += penalty * difference;
        rhs.row(j) -= penalty * difference;
      }
    }
    Eigen::SparseMatrix<double> matrix(normals.rows(), normals.rows());
    matrix.setFromTriplets(entries.begin(), entries.end());
    result = solve(matrix, rhs, result);
    result.rowwise().normalize();
  }
  return result;
}

/// Minimizes sum a_i^2 + lambda * sum |n_i (p_i - p_j)|_0 over the steps a_i of points along their
/// normals, p_i = q_i + a_i n_i. Each pair counts twice, once for each of its normals.
/// \returns the positions p_i
inline Rows denoised_positions(const Rows& positions, const Rows& normals, const Pairs& pairs,
                               const L0_denoising_parameters& parameters)
{
  using Vector = Eigen::VectorXd;
  Vector steps = Vector::Zero(positions.rows());
  for (double penalty = 2 * parameters.position_weight; penalty <= parameters.last_position_penalty;
       penalty *= parameters.growth) {
    const double threshold = parameters.position_weight / penalty;
    std::vector<Eigen::Triplet<double>> entries;
    Vector rhs = Vector::Zero(positions.rows());
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
      entries.emplace_back(i, i, 1);
    for (const auto& [first, second] : pairs)
      for (const auto& [i, j] : {std::pair(Eigen::Index(first), Eigen::Index(second)),
                                 std::pair(Eigen::Index(second), Eigen::Index(first))}) {
        // n_i (p_i - p_j) = height + a_i - cosine * a_j
        const double height = normals.row(i).dot(positions.row(i) - positions.row(j));
        const double cosine = normals.row(i).dot(normals.row(j));
        const double jump = height + steps[i] - cosine * steps[j];
        const double target = (jump * jump > threshold ? jump : 0) - height;
        entries.emplace_back(i, i, penalty);
        entries.emplace_back(j, j, penalty * cosine * cosine);
        entries.emplace_back(i, j, -penalty * cosine);
        entries.emplace_back(j, i, -penalty * cosine);
        rhs[i] += penalty * target;
        rhs[j] -= penalty * cosine * target;
      }
    Eigen::SparseMatrix<double> matrix(positions.rows(), positions.rows());
    matrix.setFromTriplets(entries.begin(), entries.end());
    steps = solve(matrix, rhs, steps);
  }
  return positions + steps.asDiagonal() * normals;
}

/// Moves points with neighbors across an edge to where the tangent planes around them meet.
inline Rows points_on_edges(const Rows& positions, const Rows& normals, const Pairs& pairs,
                            const L0_denoising_parameters& parameters)
{
  constexpr double stiffness = 0.1; // against moving along the edge, where planes say nothing
  const double cosine_at_edge = std::cos(parameters.edge_angle * EIGEN_PI / 180);
  const auto n = std::size_t(positions.rows());
  std::vector<Eigen::Matrix3d> matrices(n, stiffness * Eigen::Matrix3d::Identity());
  std::vector<Eigen::Vector3d> sums(n, Eigen::Vector3d::Zero());
  std::vector<bool> is_at_edge(n, false);
  for (const auto& [first, second] : pairs)
    for (const auto& [i, j] : {std::pair(first, second), std::pair(second, first)}) {
      const Eigen::Vector3d normal = normals.row(Eigen::Index(j)).transpose();
      const Eigen::Vector3d difference =
        (positions.row(Eigen::Index(j)) - positions.row(Eigen::Index(i))).transpose();
      matrices[i] += normal * normal.transpose();
      sums[i] += normal * normal.dot(difference);
      if (normal.dot(normals.row(Eigen::Index(i)).transpose()) < cosine_at_edge)
        is_at_edge[i] = true;
    }
  Rows result = positions;
  for (std::size_t i = 0; i < n; ++i)
    if (is_at_edge[i]) {
      Eigen::Vector3d step = matrices[i].ldlt().solve(sums[i]);
      if (step.norm() > 1) // a spacing: nearly parallel planes may meet anywhere
        step.normalize();
      result.row(Eigen::Index(i)) += step.transpose();
    }
  return result;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_L0_DENOISING_H
