// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_GAUSSIAN_MIXTURE_H
#define CGAL_L0_RESAMPLING_BENCHMARK_GAUSSIAN_MIXTURE_H

#include "../common/Portable_random.h"
#include "Point_tree.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace L0_benchmark {

inline Eigen::Vector3d to_eigen(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

inline Point_3 to_cgal(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

/// A component of a mixture. The weight is the number of points it stands for.
struct Gaussian
{
  double weight;
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;
};

using Gaussian_mixture = std::vector<Gaussian>;

/// The Kullback-Leibler divergence of `child` from `parent`.
inline double divergence(const Gaussian& child, const Gaussian& parent,
                         const Eigen::Matrix3d& inverse_of_parent)
{
  const Eigen::Vector3d difference = child.mean - parent.mean;
  return 0.5
         * ((inverse_of_parent * child.covariance).trace()
            + difference.dot(inverse_of_parent * difference) - 3
            - std::log(child.covariance.determinant() / parent.covariance.determinant()));
}

/// Each point as the Gaussian of its nearest points.
/// \param floor the least standard deviation in any direction, so that no covariance is singular
inline Gaussian_mixture gaussians_of_points(const std::vector<Point_3>& points, double floor)
{
  constexpr unsigned number_of_neighbors = 16; // the point itself is one of them
  const Point_tree tree(points);
  Gaussian_mixture mixture;
  mixture.reserve(points.size());
  for (const Point_3& point : points) {
    Gaussian gaussian{1, to_eigen(point), Eigen::Matrix3d::Identity() * (floor * floor)};
    for (std::size_t j : tree.nearest(point, number_of_neighbors)) {
      const Eigen::Vector3d difference = to_eigen(points[j]) - gaussian.mean;
      gaussian.covariance += difference * difference.transpose() / number_of_neighbors;
    }
    mixture.push_back(gaussian);
  }
  return mixture;
}

/// What a parent takes over of its children, weighted by its responsibility for them: number, mean
/// and covariance.
class Merged_gaussian
{
  double m_weight = 0;
  Eigen::Vector3d m_sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d m_squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d m_origin; // near the children, so that squares do not cancel

public:
  explicit Merged_gaussian(const Eigen::Vector3d& origin) : m_origin(origin) {}

  void add(const Gaussian& child, double responsibility)
  {
    const double weight = responsibility * child.weight;
    const Eigen::Vector3d position = child.mean - m_origin;
    m_weight += weight;
    m_sum += weight * position;
    m_squares += weight * (child.covariance + position * position.transpose());
  }

  bool is_empty() const { return m_weight == 0; }

  Gaussian result() const
  {
    const Eigen::Vector3d mean = m_sum / m_weight;
    return {m_weight, m_origin + mean, m_squares / m_weight - mean * mean.transpose()};
  }
};

/*!
One level of hierarchical expectation maximization (Preiner et al. 2014): a third of the components,
chosen at random, become parents. The others are shared out among the parents close by, closeness
being the divergence, and what is close to none stays. Number, mean and covariance of the whole
mixture do not change.

\param reach alpha: children diverge from their parent by alpha^2 / 2 at most
*/
inline Gaussian_mixture reduced_mixture(const Gaussian_mixture& mixture, double reach,
                                        Portable_random& random)
{
  std::vector<std::size_t> parents;
  for (std::size_t s = 0; s < mixture.size(); ++s)
    if (random.uniform() < 1. / 3)
      parents.push_back(s);

  // For each component the parents close by, and the logarithm of its likelihood times their weight
  struct Candidate
  {
    std::size_t parent;
    double log_likelihood;
  };
  std::vector<std::vector<Candidate>> candidates(mixture.size());
  std::vector<Point_3> means;
  for (const Gaussian& gaussian : mixture)
    means.push_back(to_cgal(gaussian.mean));
  const Point_tree tree(means);
  for (std::size_t p = 0; p < parents.size(); ++p) {
    const Gaussian& parent = mixture[parents[p]];
    const Eigen::Matrix3d inverse = parent.covariance.inverse();
    const double longest_axis = std::sqrt(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(parent.covariance).eigenvalues().maxCoeff());
    // The divergence is at least half the squared Mahalanobis distance, so no other child can be
    // close.
    for (std::size_t c : tree.in_ball(means[parents[p]], reach * longest_axis)) {
      if (divergence(mixture[c], parent, inverse) > reach * reach / 2)
        continue;
      const Eigen::Vector3d difference = mixture[c].mean - parent.mean;
      const double of_one_point = -0.5
                                  * (difference.dot(inverse * difference)
                                     + (inverse * mixture[c].covariance).trace()
                                     + std::log(parent.covariance.determinant()));
      candidates[c].push_back({p, mixture[c].weight * of_one_point + std::log(parent.weight)});
    }
  }

  std::vector<Merged_gaussian> merged;
  merged.reserve(parents.size());
  for (std::size_t s : parents)
    merged.emplace_back(mixture[s].mean);
  Gaussian_mixture result;
  for (std::size_t c = 0; c < mixture.size(); ++c) {
    double best = -std::numeric_limits<double>::infinity(), sum = 0;
    for (const Candidate& candidate : candidates[c])
      best = (std::max)(best, candidate.log_likelihood);
    for (const Candidate& candidate : candidates[c])
      sum += std::exp(candidate.log_likelihood - best);
    for (const Candidate& candidate : candidates[c])
      merged[candidate.parent].add(mixture[c], std::exp(candidate.log_likelihood - best) / sum);
    if (candidates[c].empty())
      result.push_back(mixture[c]);
  }
  for (const Merged_gaussian& parent : merged)
    if (!parent.is_empty())
      result.push_back(parent.result());
  return result;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_GAUSSIAN_MIXTURE_H
