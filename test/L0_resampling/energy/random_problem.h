// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_RANDOM_PROBLEM_H
#define CGAL_L0_RESAMPLING_TEST_RANDOM_PROBLEM_H

#include "test_support.h"

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/kernels/chebyshev_steps.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace test {

/// The symbols of Eq. (10) as the paper has them, nothing collapsed and nothing multiplied out.
struct Paper_problem
{
  struct Fit_term
  {
    std::size_t i;
    Vector q;
    double v;
  }; // |p_i - q_j|^2 / v_j
  struct Pair_term
  {
    std::size_t i, k;
    double stretch;
    double offset;
  }; // ordered: theta_ik, delta_ik

  std::vector<Vector> samples;   // current positions o_i
  std::vector<Vector> normals;   // n_i
  std::vector<double> densities; // w_i
  std::vector<Fit_term> fit;     // grouped by i
  std::vector<Pair_term> pairs;  // grouped by i, k ascending
  double alpha, beta;

  /// Eq. (10) term by term.
  double energy(const std::vector<Vector>& p) const
  {
    double sum = 0;
    for (const Fit_term& t : fit)
      sum += (p[t.i] - t.q).squaredNorm() / t.v;
    for (const Pair_term& t : pairs)
      sum += alpha * (p[t.i] - p[t.k]).squaredNorm() * t.stretch / densities[t.i];
    for (const Pair_term& t : pairs)
      sum += beta * std::pow(normals[t.i].dot(p[t.i] - p[t.k]) - t.offset, 2);
    return sum;
  }
};

/// A noisy cube of side 3; self neighbors are closer than half of the radius 1.5. The last three
/// samples are isolated: one input point and no self neighbor. The offsets are random: Eq. (10)
/// does not ask that delta_ik be -delta_ki.
inline Paper_problem random_paper_problem(std::size_t number_of_samples, double alpha, double beta,
                                          Generator& generator)
{
  const double radius = 1.5;
  Oriented_points input = cube_points(5 * number_of_samples, 3, generator);
  add_gaussian_noise(input.points, 0.05, generator);

  Paper_problem problem;
  problem.alpha = alpha;
  problem.beta = beta;
  for (std::size_t i = 0; i < number_of_samples; ++i)
  {
    const bool is_isolated = i + 3 >= number_of_samples;
    problem.samples.push_back(is_isolated ? Vector(20 + 5 * double(i), 0, 0) : input.points[5 * i]);
    problem.normals.push_back(
      (input.normals[5 * i] + 0.2 * random_unit_vector(generator)).normalized());
    problem.densities.push_back(random_number(1, 3, generator));
    if (is_isolated)
      input.points.push_back(problem.samples.back() + 0.3 * random_unit_vector(generator));
  }

  std::vector<double> input_densities;
  for (std::size_t j = 0; j < input.points.size(); ++j)
    input_densities.push_back(random_number(1, 3, generator));
  const auto original_neighbors = brute_force_neighbors(problem.samples, input.points, radius);
  const auto self_neighbors = brute_force_neighbors(problem.samples, problem.samples, radius / 2);
  for (std::size_t i = 0; i < number_of_samples; ++i)
  {
    for (std::size_t j : original_neighbors[i])
      problem.fit.push_back({i, input.points[j], input_densities[j]});
    for (std::size_t k : self_neighbors[i])
      if (k != i)
      {
        const double squared_distance = (problem.samples[i] - problem.samples[k]).squaredNorm();
        const double offset = random_number(0, 1, generator) < 0.5
                                ? 0
                                : random_number(-0.5, 0.5, generator);
        problem.pairs.push_back({i, k, std::exp(squared_distance / (radius * radius)), offset});
      }
  }
  return problem;
}

/// The arrays behind a `Quadratic_problem`, made of a `Paper_problem` by what its documentation
/// says.
template <typename FT>
class Collapsed_problem
{
  std::vector<FT> m_normals, m_normal_spreads;
  std::vector<std::size_t> m_offsets;
  std::vector<CGAL::L0_resampling::Index> m_indices;
  CGAL::L0_resampling::Explicit_rows<FT> m_rows;
  FT m_beta;
  double m_alpha;

  static std::vector<FT> flat(const std::vector<Vector>& vectors)
  {
    std::vector<FT> numbers;
    for (const Vector& v : vectors)
      for (Eigen::Index c = 0; c < 3; ++c)
        numbers.push_back(FT(v[c]));
    return numbers;
  }

  template <typename Term>
  static std::vector<std::size_t> offsets(const std::vector<Term>& terms, std::size_t m)
  {
    std::vector<std::size_t> result{0};
    for (std::size_t i = 0; i < m; ++i)
    {
      std::size_t end = result.back();
      while (end < terms.size() && terms[end].i == i)
        ++end;
      result.push_back(end);
    }
    return result;
  }

public:
  std::vector<FT> fit_weights, pair_weights, right_hand_side;
  std::vector<std::size_t> fit_offsets;
  std::vector<FT> origins, fit_positions, row_weights, normal_offsets;

  explicit Collapsed_problem(const Paper_problem& paper)
    : m_normals(flat(paper.normals)), m_offsets(offsets(paper.pairs, paper.samples.size())),
      m_beta(FT(paper.beta)), m_alpha(paper.alpha), fit_weights(paper.samples.size(), FT(0)),
      fit_offsets(offsets(paper.fit, paper.samples.size())), origins(flat(paper.samples))
  {
    const std::vector<Vector>& o = paper.samples;
    std::vector<Vector> pulls(o.size(),
                              Vector::Zero()); // minus half of the gradient of Eq. (10) at o
    std::vector<Vector> fit_points;
    for (const auto& t : paper.fit)
    {
      fit_weights[t.i] += FT(1 / t.v);
      fit_points.push_back(t.q);
      row_weights.push_back(FT(1 / t.v));
      pulls[t.i] += (t.q - o[t.i]) / t.v;
    }
    for (const auto& t : paper.pairs)
    {
      const double weight = paper.alpha * t.stretch;
      const Vector pull = weight / paper.densities[t.i] * (o[t.i] - o[t.k])
                          + paper.beta * (paper.normals[t.i].dot(o[t.i] - o[t.k]) - t.offset)
                              * paper.normals[t.i];
      pulls[t.i] -= pull;
      pulls[t.k] += pull;
      m_indices.push_back(CGAL::L0_resampling::Index(t.k));
      pair_weights.push_back(FT(weight / paper.densities[t.i] + weight / paper.densities[t.k]));
      normal_offsets.push_back(FT(t.offset));
    }
    right_hand_side = flat(pulls);
    for (std::size_t i = 0; i < o.size(); ++i)
    {
      Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
      for (std::size_t e = m_offsets[i]; e < m_offsets[i + 1]; ++e)
        for (std::size_t k : {i, std::size_t(m_indices[e])})
          spread += paper.normals[k] * paper.normals[k].transpose();
      for (Eigen::Index row = 0; row < 3; ++row)
        for (Eigen::Index column = row; column < 3; ++column)
          m_normal_spreads.push_back(FT(spread(row, column)));
    }
    fit_positions = flat(fit_points);
  }

  Collapsed_problem(const Collapsed_problem&) = delete;
  Collapsed_problem& operator=(const Collapsed_problem&) = delete;

  /// Valid while this object lives and its arrays keep their sizes.
  CGAL::L0_resampling::Quadratic_problem<FT> view()
  {
    const std::size_t m = fit_weights.size();
    const Eigen::Index columns = Eigen::Index(m);
    m_rows = {fit_offsets.data(), fit_positions.data(), row_weights.data(), normal_offsets.data(),
              origins.data()};
    return {{fit_weights.data(), columns},
            {m, m_offsets.data(), m_indices.data()},
            {m_normals.data(), 3, columns},
            {pair_weights.data(), Eigen::Index(pair_weights.size())},
            {right_hand_side.data(), 3, columns},
            m_beta,
            {m_normal_spreads.data(), 6, columns},
            &m_rows,
            0,
            nullptr,
            CGAL::L0_resampling::internal::low_end_of_spectrum(m_alpha, m_beta, 1)};
  }
};

/// xyz interleaved, as one vector of 3m numbers.
inline Eigen::VectorXd coordinates(const std::vector<Vector>& points)
{
  Eigen::VectorXd x(3 * Eigen::Index(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    x.segment<3>(3 * Eigen::Index(i)) = points[i];
  return x;
}

} // namespace test

#endif // CGAL_L0_RESAMPLING_TEST_RANDOM_PROBLEM_H
