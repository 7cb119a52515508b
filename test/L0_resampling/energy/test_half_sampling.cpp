// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Algorithm 2 and the equations of Section 4.1 and Appendix A.

#include "test_support.h"

#include <CGAL/L0_resampling/internal/energy/half_sampling.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <tuple>
#include <vector>

namespace {

using CGAL::L0_resampling::Index;
using CGAL::L0_resampling::internal::merge_pairs;
using CGAL::L0_resampling::internal::Pair_partitioner;
using test::Generator;
using test::Vector;

template <typename FT>
std::vector<FT> flat(const std::vector<Vector>& points)
{
  std::vector<FT> result;
  for (const Vector& p : points)
    for (Eigen::Index c = 0; c < 3; ++c)
      result.push_back(FT(p[c]));
  return result;
}

template <typename FT>
FT squared_distance(const std::vector<FT>& positions, std::size_t i, std::size_t j)
{
  const FT dx = positions[3 * i] - positions[3 * j];
  const FT dy = positions[3 * i + 1] - positions[3 * j + 1];
  const FT dz = positions[3 * i + 2] - positions[3 * j + 2];
  return dx * dx + dy * dy + dz * dz;
}

/// Algorithm 2 as it is printed, with the order of equal distances decided.
template <typename FT>
std::vector<Index> algorithm_2(const std::vector<FT>& positions)
{
  const Index n = Index(positions.size() / 3);
  std::vector<std::tuple<FT, Index, Index>> distances;
  for (Index x = 0; x < n; ++x)
    for (Index y = x + 1; y < n; ++y)
      distances.emplace_back(squared_distance(positions, x, y), x, y);
  std::sort(distances.begin(), distances.end());

  std::vector<Index> partners(n);
  std::vector<bool> is_taken(n, false);
  for (Index x = 0; x < n; ++x)
    partners[x] = x;
  for (const auto& [distance, x, y] : distances)
    if (!is_taken[x] && !is_taken[y])
    {
      partners[x] = y;
      partners[y] = x;
      is_taken[x] = is_taken[y] = true;
    }
  return partners;
}

/// One partitioner for all sets, so that what a set leaves behind would be seen in the next.
template <typename FT>
void test_partition_is_that_of_algorithm_2(const std::vector<std::vector<Vector>>& sets)
{
  Pair_partitioner<FT> partitioner;
  for (const std::vector<Vector>& set : sets)
  {
    const std::vector<FT> positions = flat<FT>(set);
    const std::vector<Index> partners = partitioner(positions.data(), set.size());
    CHECK(partners == algorithm_2(positions));
    std::size_t number_left_over = 0;
    for (std::size_t i = 0; i < partners.size(); ++i)
      number_left_over += partners[i] == i;
    CHECK(number_left_over == set.size() % 2);
  }
}

std::vector<std::vector<Vector>> point_sets(Generator& generator)
{
  std::vector<std::vector<Vector>> sets;
  for (std::size_t n : {0, 1, 2, 3, 4, 7, 8, 9, 16, 17, 71, 72, 501, 1000})
  {
    sets.push_back(test::sphere_points(n, 1, generator).points);

    // duplicates: equal distances, and distances of zero
    std::vector<Vector> points = sets.back();
    for (std::size_t i = 2; i < n; i += 3)
      points[i] = points[i / 2];
    sets.push_back(points);

    // few distinct coordinates, many ties
    for (Vector& p : points)
      p = (3 * p).array().round();
    sets.push_back(points);

    sets.emplace_back(n, Vector(1, 2, 3));

    // each point nearest to the one before: the longest chain
    points.clear();
    for (std::size_t i = 0; i < (std::min)(n, std::size_t(60)); ++i)
      points.emplace_back(std::pow(1.5, double(i)), 0, 0);
    sets.push_back(points);
    std::reverse(points.begin(), points.end());
    sets.push_back(points);
  }
  sets.push_back(test::lattice_points(6, 1));
  std::vector<Vector> shuffled = test::lattice_points(7, 0.5);
  std::shuffle(shuffled.begin(), shuffled.end(), generator);
  sets.push_back(shuffled);
  return sets;
}

/// The sum of Eq. (14).
double sum_over_pairs(const std::vector<double>& positions, const std::vector<Index>& partners)
{
  double sum = 0;
  for (std::size_t i = 0; i < partners.size(); ++i)
    if (partners[i] > i)
      sum += squared_distance(positions, i, partners[i]);
  return sum;
}

/// The least sum of Eq. (14) over all perfect matchings of the points that are not taken yet.
double minimum_sum_over_matchings(const std::vector<double>& positions, std::vector<bool>& is_taken)
{
  const auto first_free = std::find(is_taken.begin(), is_taken.end(), false);
  if (first_free == is_taken.end())
    return 0;
  const std::size_t i = std::size_t(first_free - is_taken.begin());
  double least = std::numeric_limits<double>::infinity();
  is_taken[i] = true;
  for (std::size_t j = i + 1; j < is_taken.size(); ++j)
    if (!is_taken[j])
    {
      is_taken[j] = true;
      least = (std::min)(least, squared_distance(positions, i, j)
                                  + minimum_sum_over_matchings(positions, is_taken));
      is_taken[j] = false;
    }
  is_taken[i] = false;
  return least;
}

/// "Eq. (14) is hard to solve": greedy is not optimal, and never better than optimal. Prints how
/// far it is off.
void test_greedy_against_all_matchings(Generator& generator)
{
  Pair_partitioner<double> partitioner;
  double greatest_ratio = 1;
  for (std::size_t n : {2, 4, 6, 8, 10})
  {
    const std::size_t number_of_trials = 200;
    double sum_of_ratios = 0, greatest = 1;
    for (std::size_t trial = 0; trial < number_of_trials; ++trial)
    {
      std::vector<Vector> points;
      for (std::size_t i = 0; i < n; ++i)
        points.push_back(std::cbrt(test::random_number(0, 1, generator))
                         * test::random_unit_vector(generator));
      const std::vector<double> positions = flat<double>(points);
      std::vector<bool> is_taken(n, false);
      const double ratio = sum_over_pairs(positions, partitioner(positions.data(), n))
                           / minimum_sum_over_matchings(positions, is_taken);
      CHECK(ratio >= 1 - 1e-12);
      if (n == 2)
        CHECK(ratio <= 1 + 1e-12);
      sum_of_ratios += ratio;
      greatest = (std::max)(greatest, ratio);
    }
    std::cout << "greedy / optimal sum of Eq. (14), " << n << " points: mean "
              << sum_of_ratios / double(number_of_trials) << ", max " << greatest << std::endl;
    greatest_ratio = (std::max)(greatest_ratio, greatest);
  }
  CHECK(greatest_ratio > 1.01);

  // Worked by hand: at 0, 2, 3, 5 greedy takes (2, 3) first and is left with (0, 5), 1 + 25;
  // optimal is 4 + 4.
  const std::vector<double> line = {0, 0, 0, 2, 0, 0, 3, 0, 0, 5, 0, 0};
  std::vector<bool> is_taken(4, false);
  CHECK(partitioner(line.data(), 4) == std::vector<Index>({3, 2, 1, 0}));
  CHECK(sum_over_pairs(line, partitioner(line.data(), 4)) == 26);
  CHECK(minimum_sum_over_matchings(line, is_taken) == 8);
}

/// Appendix A: with equal weights the objective of Eq. (13) is half of that of Eq. (14), whatever
/// p_i is.
void test_eq_13_is_half_of_eq_14(Generator& generator)
{
  for (std::size_t n : {2, 10, 72})
  {
    const std::vector<Vector> points = test::sphere_points(n, 2, generator).points;
    std::vector<double> positions = flat<double>(points), weights(n, 1.);
    const std::vector<Index> partners = Pair_partitioner<double>()(positions.data(), n);
    const double eq_14 = sum_over_pairs(positions, partners);
    const std::size_t size = merge_pairs(partners, positions.data(), weights.data());
    CHECK(size == n / 2);
    for (int trial = 0; trial < 10; ++trial)
    {
      const Vector p = 3 * test::random_unit_vector(generator);
      double eq_13 = 0;
      for (const Vector& q : points)
        eq_13 += (p - q).squaredNorm();
      for (std::size_t j = 0; j < size; ++j)
        eq_13 -= 2 * (p - Eigen::Map<const Vector>(&positions[3 * j])).squaredNorm();
      CHECK(std::abs(eq_13 - eq_14 / 2) < 1e-12 * 25 * double(n));
    }
  }
}

/// Two passes, as the paper runs them, with weights: the sum of the weights and the weighted mean
/// stay, which is all that the minimizer of Eq. (10) sees of the fit term; and each new point is
/// the weighted mean of its pair.
void test_merging_keeps_the_fit_term(Generator& generator)
{
  for (std::size_t n : {1, 2, 3, 9, 72, 301})
  {
    std::vector<double> positions = flat<double>(test::cube_points(n, 2, generator).points),
                        weights;
    for (std::size_t j = 0; j < n; ++j)
      weights.push_back(1 / test::random_number(1, 3, generator));
    Pair_partitioner<double> partitioner;
    for (int pass = 0; pass < 2; ++pass)
    {
      const std::vector<double> old_positions = positions, old_weights = weights;
      const std::vector<Index> partners = partitioner(positions.data(), weights.size());
      const std::size_t size = merge_pairs(partners, positions.data(), weights.data());
      CHECK(size == (old_weights.size() + 1) / 2);
      positions.resize(3 * size);
      weights.resize(size);

      double weight = 0, old_weight = 0;
      Vector moment = Vector::Zero(), old_moment = Vector::Zero();
      std::size_t next = 0;
      for (std::size_t j = 0; j < old_weights.size(); ++j)
      {
        const Vector q = Eigen::Map<const Vector>(&old_positions[3 * j]);
        old_weight += old_weights[j];
        old_moment += old_weights[j] * q;
        const std::size_t k = partners[j];
        if (k < j)
          continue;
        const Vector merged = Eigen::Map<const Vector>(&positions[3 * next]);
        if (k == j)
          CHECK(merged == q && weights[next] == old_weights[j]);
        else
        {
          const Vector other = Eigen::Map<const Vector>(&old_positions[3 * k]);
          CHECK(weights[next] == old_weights[j] + old_weights[k]);
          CHECK((merged - (old_weights[j] * q + old_weights[k] * other) / weights[next]).norm()
                < 1e-14);
        }
        ++next;
      }
      for (std::size_t j = 0; j < size; ++j)
      {
        weight += weights[j];
        moment += weights[j] * Eigen::Map<const Vector>(&positions[3 * j]);
      }
      CHECK(test::is_close(weight, old_weight, 1e-14));
      CHECK((moment - old_moment).norm() < 1e-13 * old_weight);
    }
  }

  std::vector<double> positions = {0, 0, 0, 2, 4, 6}, weights = {0, 0};
  CHECK(merge_pairs<double>({1, 0}, positions.data(), weights.data()) == 1);
  CHECK(positions[0] == 1 && positions[1] == 2 && positions[2] == 3 && weights[0] == 0);
}

} // namespace

int main()
{
  Generator generator(2019);
  const std::vector<std::vector<Vector>> sets = point_sets(generator);
  test_partition_is_that_of_algorithm_2<double>(sets);
  test_partition_is_that_of_algorithm_2<float>(sets);
  test_greedy_against_all_matchings(generator);
  test_eq_13_is_half_of_eq_14(generator);
  test_merging_keeps_the_fit_term(generator);
  return test::result();
}
