// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_LOCALLY_OPTIMAL_PROJECTION_H
#define CGAL_L0_RESAMPLING_BENCHMARK_LOCALLY_OPTIMAL_PROJECTION_H

#include "Point_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace L0_benchmark {

/// What the projection operators of this folder have in common.
struct Projection_parameters
{
  double radius;           ///< h, a length
  double repulsion = 0.45; ///< mu, in [0, 1/2)
  int repulsion_power =
    4; ///< |eta'(r)| = r^-power: 4 for LOP's eta = 1/(3 r^3), 0 for CLOP's eta = -r
  unsigned number_of_iterations = 35;
};

/// Points further away than this share of h count for nothing: the kernel is below e^-9 there.
constexpr double kernel_reach = 0.75;

/// theta(r) = exp(-r^2 / (h/4)^2), the kernel of LOP. CGAL's WLOP has exp(-4 r^2 / h^2), so that
/// its radius is half of this one for the same kernel.
inline double projection_kernel(double squared_distance, double radius)
{
  return std::exp(-16 * squared_distance / (radius * radius));
}

/// r^-power for a whole power, which std::pow() takes long for.
inline double inverse_power(double r, int power)
{
  double result = 1;
  for (int i = 0; i < power; ++i)
    result /= r;
  return result;
}

/// The push on sample `i` from the others, a mean of the differences weighted by theta(r) / r
/// |eta'(r)|.
inline Vector_3 repulsion(const std::vector<Point_3>& samples, const Point_tree& tree,
                          std::size_t i, const Projection_parameters& parameters)
{
  Vector_3 sum = CGAL::NULL_VECTOR;
  double sum_of_weights = 0;
  for (std::size_t k : tree.in_ball(samples[i], kernel_reach * parameters.radius)) {
    const Vector_3 difference = samples[i] - samples[k];
    const double squared_distance = difference.squared_length();
    if (squared_distance
        == 0) // the sample itself; one that coincides with it pushes in no direction
      continue;
    // In units of h, so that the powers do not overflow. The sum of weights takes the unit away
    // again.
    const double distance = std::sqrt(squared_distance) / parameters.radius;
    const double weight = projection_kernel(squared_distance, parameters.radius)
                          * inverse_power(distance, 1 + parameters.repulsion_power);
    sum = sum + weight * difference;
    sum_of_weights += weight;
  }
  return sum_of_weights > 0 ? sum / sum_of_weights : sum;
}

/// Moves all samples at once, again and again, to where they are attracted, and away from each
/// other.
/// \param attract from a sample to the point it is drawn to
template <typename Attraction>
void project(const Projection_parameters& parameters, const Attraction& attract,
             std::vector<Point_3>& samples)
{
  std::vector<Point_3> next(samples.size());
  for (unsigned iteration = 0; iteration < parameters.number_of_iterations; ++iteration) {
    const Point_tree tree(samples);
    for (std::size_t i = 0; i < samples.size(); ++i)
      next[i] = attract(samples[i])
                + parameters.repulsion * repulsion(samples, tree, i, parameters);
    samples.swap(next);
  }
}

/// The mean of the points around a sample, weighted by theta(r) / r^power. Power 1 makes one step
/// towards their L1 median; power 0 is the mean that LOP begins with. Without points in reach the
/// sample stays.
inline Point_3 local_mean(const Point_3& sample, const std::vector<Point_3>& points,
                          const Point_tree& tree, double radius, int power)
{
  const double minimum_distance = 1e-6
                                  * radius; // a sample on a point would have an infinite weight
  Vector_3 sum = CGAL::NULL_VECTOR;
  double sum_of_weights = 0;
  for (std::size_t j : tree.in_ball(sample, kernel_reach * radius)) {
    const Vector_3 difference = points[j] - sample;
    const double squared_distance = difference.squared_length();
    const double distance = (std::max)(std::sqrt(squared_distance), minimum_distance);
    const double weight = projection_kernel(squared_distance, radius)
                          * inverse_power(distance / radius, power);
    sum = sum + weight * difference;
    sum_of_weights += weight;
  }
  return sum_of_weights > 0 ? sample + sum / sum_of_weights : sample;
}

/*!
LOP (Lipman et al. 2007, "Parameterization-free projection for geometry reconstruction"): draws each
sample to the L1 median of the points around it, while samples repel each other.

\param samples where they start, and where they end
*/
inline void locally_optimal_projection(const std::vector<Point_3>& points,
                                       const Projection_parameters& parameters,
                                       std::vector<Point_3>& samples)
{
  const Point_tree tree(points);
  for (Point_3& sample : samples)
    sample = local_mean(sample, points, tree, parameters.radius, 0);
  project(
    parameters,
    [&](const Point_3& sample) { return local_mean(sample, points, tree, parameters.radius, 1); },
    samples);
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_LOCALLY_OPTIMAL_PROJECTION_H
