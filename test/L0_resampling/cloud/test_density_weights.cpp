// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/density_weights.h>
#include <CGAL/L0_resampling/internal/energy/pair_terms.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Falls from 1 to 0 over the last tenth of the squared range.
double share_in_range(double squared_distance, double range)
{
  return (std::min)(10 * (std::max)(1 - squared_distance / (range * range), 0.), 1.);
}

/// Eq. (5), its sum without the point itself.
/// \param range where the weights end
std::vector<double> naive_density_weights(const std::vector<Vector>& points, double radius,
                                          double bandwidth, double range = infinity)
{
  const auto neighbors = brute_force_neighbors(points, points, radius);
  double mean_number_of_neighbors = 0;
  for (const auto& list : neighbors)
    mean_number_of_neighbors += double(list.size() - 1) / double(points.size());
  std::vector<double> weights(points.size(), 1);
  for (std::size_t j = 0; j < points.size(); ++j)
    for (std::size_t k : neighbors[j])
      if (k != j)
      {
        const double squared_distance = (points[j] - points[k]).squaredNorm();
        weights[j] += share_in_range(squared_distance, range)
                      * std::exp(-squared_distance / (bandwidth * bandwidth))
                      / mean_number_of_neighbors;
      }
  return weights;
}

template <typename T>
std::vector<double> input_density_weights(const Gridded_points& sorted, double radius,
                                          double bandwidth)
{
  Unwatched unwatched;
  Facts_of_cloud facts;
  Buffer<T> weights(sorted.points.size());
  compute_input_density_weights<CGAL::Parallel_if_available_tag>(
    sorted.grid, sorted.points, radius, bandwidth * bandwidth, facts, unwatched.progress, weights);
  return std::vector<double>(weights.begin(), weights.end());
}

/// \param least differences are relative to at least this
double maximum_relative_difference(const std::vector<double>& a, const std::vector<double>& b,
                                   double least = 0)
{
  double largest = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
    largest = (std::max)(largest, std::abs(a[i] - b[i]) / (std::max)(b[i], least));
  return largest;
}

/// v_j of Eq. (5) for the input points.
void check_input(const std::vector<Vector>& points, double radius)
{
  for (double cell_size : {0.5 * radius, 0.8 * radius})
  {
    const Gridded_points sorted(points, cell_size);
    const std::vector<double> naive = naive_density_weights(sorted.vector, radius, 0.5 * radius);
    CHECK(maximum_relative_difference(input_density_weights<double>(sorted, radius, 0.5 * radius),
                                      naive)
          < 1e-12);
    CHECK(
      maximum_relative_difference(input_density_weights<float>(sorted, radius, 0.5 * radius), naive)
      < 1e-5);
  }
}

/// Where all points are of one scale, balls are those of another radius, though cells are not.
void check_one_scale(const std::vector<Vector>& points, double radius)
{
  const double scale = 0.75, bandwidth = 0.5 * radius;
  const Buffer<float> scales(points.size(), float(scale));
  const Sorted_queries scaled(CGAL::Sequential_tag(), to_buffer(points),
                              Cell_sizes(radius, scales));
  Unwatched unwatched;
  Facts_of_cloud facts;
  Buffer<double> weights(points.size());
  compute_input_density_weights<CGAL::Parallel_if_available_tag>(
    scaled.grid, scaled.points, radius, bandwidth * bandwidth, facts, unwatched.progress, weights);
  const Gridded_points sorted(points, radius);
  CHECK(maximum_relative_difference(std::vector<double>(weights.begin(), weights.end()),
                                    input_density_weights<double>(sorted, scale * radius,
                                                                  scale * bandwidth))
        < 1e-12);
}

/// w_i of Eq. (5) for the samples, and with it the weights of the pairs of Eq. (4), once for each
/// of the two; less where there is a jump between them, and where the range ends.
void check_samples(const std::vector<Vector>& points, double radius, double bandwidth, double jump,
                   double range, Generator& generator)
{
  const double regularization_weight = 0.15;
  const Gridded_points sorted(points, radius);
  Unwatched unwatched;
  const Neighborhoods neighbors = find_self_neighbors<CGAL::Sequential_tag>(
    sorted.grid, sorted.points, radius / 2, unwatched.progress);
  Buffer<double> weights(points.size()), pair_weights(neighbors.indices.size());
  Buffer<Vector> normals;
  for (std::size_t i = 0; i < points.size(); ++i)
    normals.push_back(random_unit_vector(generator));
  update_weights<CGAL::Parallel_if_available_tag>(
    sorted.points, normals, neighbors, double(neighbors.indices.size()) / double(points.size()),
    bandwidth * bandwidth, radius * radius, jump * jump, range, regularization_weight, weights,
    pair_weights);
  const std::vector<double> naive = naive_density_weights(sorted.vector, radius / 2, bandwidth,
                                                          range);
  CHECK(maximum_relative_difference(std::vector<double>(weights.begin(), weights.end()), naive)
        < 1e-12);

  std::vector<double> naive_pair_weights;
  std::size_t number_of_low_weights = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
    {
      const std::size_t k = neighbors.indices[e];
      const Vector d = sorted.vector[i] - sorted.vector[k];
      const double height = (std::max)(std::abs(normals[i].dot(d)), std::abs(normals[k].dot(d)));
      const double decay_across_jump = std::exp(-height * height / (jump * jump));
      const double weight = std::exp(d.squaredNorm() / (radius * radius)) * decay_across_jump
                            * share_in_range(d.squaredNorm(), range);
      naive_pair_weights.push_back(regularization_weight * weight / naive[i]
                                   + regularization_weight * weight / naive[k]);
      number_of_low_weights += decay_across_jump < 0.5;
    }
  CHECK(std::isinf(jump) == (number_of_low_weights == 0));
  // what is left of a weight where it ends has few digits
  const double least = std::isinf(range) ? 0 : 0.01;
  CHECK(maximum_relative_difference(std::vector<double>(pair_weights.begin(), pair_weights.end()),
                                    naive_pair_weights, least)
        < 1e-12);
}

/// Points that see nobody have no density to correct.
void check_loners()
{
  const Gridded_points apart(lattice_points(3, 2), 1);
  const std::vector<double> ones(27, 1);
  CHECK(input_density_weights<float>(apart, 1, 0.5) == ones);
  Unwatched unwatched;
  const Neighborhoods none = find_self_neighbors<CGAL::Sequential_tag>(apart.grid, apart.points, 1,
                                                                       unwatched.progress);
  Buffer<double> weights(27, 0.), no_pair_weights;
  const Buffer<Vector> normals(27, Vector::UnitZ());
  update_weights<CGAL::Sequential_tag>(apart.points, normals, none, 0, 0.25, 1, 0.04, 0.55, 0.15,
                                       weights, no_pair_weights);
  CHECK(std::vector<double>(weights.begin(), weights.end()) == ones);
}

/// What lies far away, before them or behind them, changes no bit of the weights of samples:
/// neither by the lanes that a pair is computed in nor by the order of sums.
void check_far_samples(Generator& generator)
{
  struct Weights
  {
    std::vector<float> of_samples, of_pairs;
  };
  const auto weights_of = [](const std::vector<Vector>& points, std::size_t first,
                             std::size_t size) {
    const Gridded_points sorted(points, 1);
    Unwatched unwatched;
    const Neighborhoods neighbors =
      find_self_neighbors<CGAL::Sequential_tag>(sorted.grid, sorted.points, 1, unwatched.progress);
    Buffer<float> weights(points.size()), pair_weights(neighbors.indices.size());
    const Buffer<Eigen::Vector3f> normals(points.size(), Eigen::Vector3f::UnitZ());
    update_weights<CGAL::Sequential_tag>(sorted.points, normals, neighbors, 5, 0.25, 1, 0.04, 0.9,
                                         0.15, weights, pair_weights);
    const auto part = [](const Buffer<float>& values, std::size_t begin, std::size_t end) {
      return std::vector<float>(values.begin() + std::ptrdiff_t(begin),
                                values.begin() + std::ptrdiff_t(end));
    };
    return Weights{part(weights, first, first + size),
                   part(pair_weights, neighbors.offsets[first], neighbors.offsets[first + size])};
  };
  const auto random_points = [&](std::size_t n, double z) {
    std::vector<Vector> points;
    for (std::size_t i = 0; i < n; ++i)
      points.push_back(
        {random_number(0, 1, generator), random_number(0, 1, generator), z + 0.001 * double(i)});
    return points;
  };
  for (std::size_t trial = 0; trial < 50; ++trial)
  {
    const std::vector<Vector> points = random_points(15, 0);
    const Weights alone = weights_of(points, 0, 15);
    for (const double z : {-10., 10.})
    {
      std::vector<Vector> all = random_points(2 + trial % 7, z);
      const std::size_t first = z < 0 ? all.size() : 0;
      all.insert(all.end(), points.begin(), points.end());
      const Weights beside = weights_of(all, first, 15);
      CHECK(beside.of_samples == alone.of_samples && beside.of_pairs == alone.of_pairs);
    }
  }
}

int main()
{
  Generator generator(6);
  std::vector<Vector> points = cube_points(1200, 2, generator).points;
  add_gaussian_noise(points, 0.02, generator);
  for (int n = 0; n < 300; ++n) // a denser spot
    points.push_back(Vector(1, 0, 0) + 0.2 * random_unit_vector(generator));
  points.insert(points.end(), 20, Vector(0.5, 0.5, 1)); // duplicates
  points.emplace_back(9, 9, 9);                         // a point alone
  check_input(points, 0.3);
  check_one_scale(points, 0.3);
  points.emplace_back(1e9, 0, 0); // in an outermost cell, so that balls are looked at one by one
  check_input(points, 0.3);
  points.pop_back();
  for (double jump : {0.1, infinity})
    for (double range : {0.3, infinity})
      check_samples(points, 0.6, 0.3, jump, range, generator);
  check_loners();
  check_far_samples(generator);
  return result();
}
