// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/density_weights.h>
#include <CGAL/L0_resampling/internal/pair_terms.h>

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
  Buffer<T> weights(sorted.points.size());
  compute_input_density_weights<CGAL::Parallel_if_available_tag>(
    sorted.grid, sorted.points, radius, bandwidth * bandwidth, unwatched.progress, weights);
  return std::vector<double>(weights.begin(), weights.end());
}

/// \param least differences are relative to at least this
double largest_relative_difference(const std::vector<double>& a, const std::vector<double>& b,
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
    CHECK(largest_relative_difference(input_density_weights<double>(sorted, radius, 0.5 * radius),
                                      naive)
          < 1e-12);
    CHECK(
      largest_relative_difference(input_density_weights<float>(sorted, radius, 0.5 * radius), naive)
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
  Buffer<double> weights(points.size());
  compute_input_density_weights<CGAL::Parallel_if_available_tag>(
    scaled.grid, scaled.points, radius, bandwidth * bandwidth, unwatched.progress, weights);
  const Gridded_points sorted(points, radius);
  CHECK(largest_relative_difference(std::vector<double>(weights.begin(), weights.end()),
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
  update_weights<CGAL::Parallel_if_available_tag>(sorted.points, normals, neighbors,
                                                  bandwidth * bandwidth, radius * radius,
                                                  jump * jump, range, regularization_weight,
                                                  weights, pair_weights);
  const std::vector<double> naive = naive_density_weights(sorted.vector, radius / 2, bandwidth,
                                                          range);
  CHECK(largest_relative_difference(std::vector<double>(weights.begin(), weights.end()), naive)
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
  CHECK(largest_relative_difference(std::vector<double>(pair_weights.begin(), pair_weights.end()),
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
  update_weights<CGAL::Sequential_tag>(apart.points, normals, none, 0.25, 1, 0.04, 0.55, 0.15,
                                       weights, no_pair_weights);
  CHECK(std::vector<double>(weights.begin(), weights.end()) == ones);
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
  return result();
}
