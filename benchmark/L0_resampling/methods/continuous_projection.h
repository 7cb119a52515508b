// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_CONTINUOUS_PROJECTION_H
#define CGAL_L0_RESAMPLING_BENCHMARK_CONTINUOUS_PROJECTION_H

#include "Gaussian_mixture.h"
#include "locally_optimal_projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace L0_benchmark {

/*!
The kernel of LOP's attraction, theta(r) / r, as a sum of Gaussians, so that it can be integrated
over others.

From 1/r = 2 / sqrt(pi) * integral of exp(-r^2 t^2) over t from 0, with t = e^u, a sum over the
integers u. It is within 2 % of 1/r between 0.02 and 1, and stays finite below. All u below 0 are
one term with their mean exponent, 0.09, since they hardly differ beside the 16 of theta(r) =
exp(-16 r^2). Lengths are in units of h.
*/
class Attraction_kernel
{
public:
  struct Term
  {
    double height, exponent;
  }; ///< height * exp(-exponent * r^2)
  static constexpr int number_of_terms = 6;

  Attraction_kernel()
  {
    const double scale = 2 / std::sqrt(3.14159265358979323846);
    m_terms[0] = {scale / (std::exp(1.) - 1), 16 + 0.09}; // a geometric series
    for (int u = 0; u < number_of_terms - 1; ++u)
      m_terms[std::size_t(u) + 1] = {scale * std::exp(double(u)), 16 + std::exp(2. * u)};
  }

  const std::array<Term, number_of_terms>& terms() const { return m_terms; }

  double operator()(double distance) const
  {
    double sum = 0;
    for (const Term& term : m_terms)
      sum += term.height * std::exp(-term.exponent * distance * distance);
    return sum;
  }

private:
  std::array<Term, number_of_terms> m_terms;
};

/// LOP's attraction, with integrals over a mixture in place of sums over points.
class Continuous_attraction
{
  struct Component
  {
    double weight;
    Eigen::Vector3d mean;
    Eigen::Matrix3d axes;
    Eigen::Vector3d variances;
  };

  double m_radius, m_longest_axis = 0;
  Attraction_kernel m_kernel;
  std::vector<Component> m_components;
  std::vector<Point_3> m_means;
  Point_tree m_tree;

  static std::vector<Point_3> means_of(const Gaussian_mixture& mixture)
  {
    std::vector<Point_3> means;
    for (const Gaussian& gaussian : mixture)
      means.push_back(to_cgal(gaussian.mean));
    return means;
  }

public:
  Continuous_attraction(const Gaussian_mixture& mixture, double radius)
    : m_radius(radius), m_means(means_of(mixture)), m_tree(m_means)
  {
    for (const Gaussian& gaussian : mixture) {
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(gaussian.covariance);
      m_components.push_back(
        {gaussian.weight, gaussian.mean, solver.eigenvectors(), solver.eigenvalues().cwiseMax(0)});
      m_longest_axis = (std::max)(m_longest_axis,
                                  std::sqrt(m_components.back().variances.maxCoeff()));
    }
  }

  // The tree looks at the means.
  Continuous_attraction(const Continuous_attraction&) = delete;
  Continuous_attraction& operator=(const Continuous_attraction&) = delete;

  Point_3 operator()(const Point_3& sample) const
  {
    constexpr double support =
      2.5; // standard deviations of a component, which hold nearly all of it
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double sum_of_weights = 0;
    for (std::size_t s :
         m_tree.in_ball(sample, kernel_reach * m_radius + support * m_longest_axis)) {
      const Component& component = m_components[s];
      const Eigen::Vector3d difference = component.axes.transpose()
                                         * (component.mean - to_eigen(sample));
      if (difference.norm()
          > kernel_reach * m_radius + support * std::sqrt(component.variances.maxCoeff()))
        continue;
      for (const Attraction_kernel::Term& term : m_kernel.terms()) {
        // The term is a Gaussian around the sample; its product with the component is one again.
        const double variance = m_radius * m_radius / (2 * term.exponent);
        const Eigen::Array3d sums = component.variances.array() + variance;
        const double weight = component.weight * term.height
                              * std::sqrt(variance * variance * variance / sums.prod())
                              * std::exp(-0.5 * (difference.array().square() / sums).sum());
        sum += weight * (component.axes * (variance * difference.array() / sums).matrix());
        sum_of_weights += weight;
      }
    }
    return sum_of_weights > 0 ? to_cgal(to_eigen(sample) + sum / sum_of_weights) : sample;
  }
};

/*!
CLOP (Preiner et al. 2014, "Continuous projection for fast L1 reconstruction"): LOP on a Gaussian
mixture that stands for the points.

\param samples where they start, and where they end
*/
inline void continuous_projection(const Gaussian_mixture& mixture,
                                  const Projection_parameters& parameters,
                                  std::vector<Point_3>& samples)
{
  const Continuous_attraction attract(mixture, parameters.radius);
  project(
    parameters, [&](const Point_3& sample) { return attract(sample); }, samples);
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_CONTINUOUS_PROJECTION_H
