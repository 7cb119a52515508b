// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_METRICS_H
#define CGAL_L0_RESAMPLING_BENCHMARK_METRICS_H

#include "../common/sample_mesh.h"
#include "Ground_truth.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace L0_benchmark {

using Search_traits = CGAL::Search_traits_3<Kernel>;
using Neighbor_search = CGAL::Orthogonal_k_neighbor_search<Search_traits>;
using Search_tree = Neighbor_search::Tree;

struct Distance_statistics
{
  double mean = 0;
  double p95 = 0;
  double p99 = 0;
  double max = 0;
};

struct Normal_statistics
{
  double mean_error = 0; ///< degrees, without regard to the sign
  double share_above_15_degrees = 0;
  double share_inwards = 0; ///< share of normals that point to the wrong side
  double share_turned =
    0; ///< of these, by more than 120 degrees, which no edge of a right angle explains
};

struct Uniformity
{
  double median_spacing = 0; ///< median distance to the nearest neighbor, a length
  double spacing_variation =
    0; ///< coefficient of variation of the mean distance to the 6 nearest neighbors
  double density_variation = 0; ///< coefficient of variation of w_i of Eq. (5)
};

struct Feature_statistics
{
  double edge_recall = 0; ///< share of the edges' length with a point within 2 median spacings
  std::size_t number_of_points = 0;        ///< points within 1.5 % of the diagonal of an edge
  double mean_distance = 0;                ///< of those points to the mesh
  std::optional<double> mean_normal_error; ///< of those points, degrees
};

/// Lengths are % of the diagonal of the mesh's bounding box, but for `uniformity.median_spacing`.
struct Evaluation
{
  Distance_statistics distance; ///< points to mesh
  Distance_statistics coverage; ///< mesh to nearest point
  double chamfer = 0;           ///< sum of the two means
  double hausdorff = 0;         ///< larger of the two maxima
  Uniformity uniformity;
  std::optional<Normal_statistics> normals;   ///< none for points without normals
  std::optional<Feature_statistics> features; ///< none for a mesh without feature edges
};

inline double mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

/// Smallest value that at least `share` of the values do not exceed.
inline double quantile(std::vector<double> values, double share)
{
  const std::size_t rank = (std::max)(std::size_t(std::ceil(share * double(values.size()))),
                                      std::size_t(1));
  std::nth_element(values.begin(), values.begin() + (rank - 1), values.end());
  return values[rank - 1];
}

/// Standard deviation over mean: 0 where all values agree, whatever their unit.
inline double coefficient_of_variation(const std::vector<double>& values)
{
  const double average = mean(values);
  double sum = 0;
  for (double value : values)
    sum += (value - average) * (value - average);
  return std::sqrt(sum / double(values.size())) / average;
}

inline Distance_statistics summarize(const std::vector<double>& lengths, double unit)
{
  return {mean(lengths) / unit, quantile(lengths, 0.95) / unit, quantile(lengths, 0.99) / unit,
          *std::max_element(lengths.begin(), lengths.end()) / unit};
}

inline std::vector<double> distances_to_mesh(const std::vector<Point_3>& points,
                                             const Ground_truth& truth)
{
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const Point_3& p : points)
    distances.push_back(truth.distance(p));
  return distances;
}

inline std::vector<double> distances_to_nearest(const std::vector<Point_3>& queries,
                                                const Search_tree& points)
{
  std::vector<double> distances;
  distances.reserve(queries.size());
  for (const Point_3& query : queries)
    distances.push_back(std::sqrt(Neighbor_search(points, query, 1).begin()->second));
  return distances;
}

/// Angle in degrees, below or equal to 90, between a normal and the best of the normals that are
/// right at the point. A vector that is no direction (zero or not finite) is 90 degrees wrong.
struct Normal_deviation
{
  double angle = 90;
  bool inwards = false;
};

inline Normal_deviation normal_deviation(const Point_3& point, const Vector_3& normal,
                                         const Ground_truth& truth)
{
  Normal_deviation best;
  if (!(normal.squared_length() > 0) || !std::isfinite(normal.squared_length()))
    return best;
  for (const Vector_3& right : truth.nearest_normals(point)) {
    const double angle = angle_in_degrees(normal, right);
    if ((std::min)(angle, 180 - angle) < best.angle)
      best = {(std::min)(angle, 180 - angle), angle > 90};
  }
  return best;
}

inline std::vector<Normal_deviation> normal_deviations(const std::vector<Point_3>& points,
                                                       const std::vector<Vector_3>& normals,
                                                       const Ground_truth& truth)
{
  std::vector<Normal_deviation> deviations;
  deviations.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    deviations.push_back(normal_deviation(points[i], normals[i], truth));
  return deviations;
}

inline Normal_statistics summarize(const std::vector<Normal_deviation>& deviations)
{
  Normal_statistics statistics;
  for (const Normal_deviation& deviation : deviations) {
    statistics.mean_error += deviation.angle;
    statistics.share_above_15_degrees += deviation.angle > 15;
    statistics.share_inwards += deviation.inwards;
    statistics.share_turned += deviation.inwards && deviation.angle < 60;
  }
  const double count = double(deviations.size());
  statistics.mean_error /= count;
  statistics.share_above_15_degrees /= count;
  statistics.share_inwards /= count;
  statistics.share_turned /= count;
  return statistics;
}

/// The share of normals that point to the wrong side, of the points whose sheet is farther than
/// `distance` from the next one; nothing if there are none.
inline std::optional<double> share_inwards_where_apart(const std::vector<Point_3>& points,
                                                       const std::vector<Vector_3>& normals,
                                                       const Ground_truth& truth, double distance)
{
  std::size_t number_apart = 0, number_inwards = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (truth.distance_to_next_sheet(points[i]) > distance) {
      ++number_apart;
      number_inwards += normal_deviation(points[i], normals[i], truth).inwards;
    }
  if (number_apart == 0)
    return std::nullopt;
  return double(number_inwards) / double(number_apart);
}

/// For each point, the mean distance to its `k` nearest neighbors.
inline std::vector<double> mean_neighbor_distances(const std::vector<Point_3>& points,
                                                   const Search_tree& tree, unsigned int k)
{
  std::vector<double> means;
  means.reserve(points.size());
  for (const Point_3& p : points) {
    double sum = 0;
    std::size_t number_of_neighbors = 0;
    const Neighbor_search search(tree, p,
                                 k + 1); // the point itself is found too, and adds 0 to the sum
    for (const auto& [neighbor, squared_distance] : search) {
      sum += std::sqrt(squared_distance);
      ++number_of_neighbors;
    }
    means.push_back(number_of_neighbors > 1 ? sum / double(number_of_neighbors - 1) : 0);
  }
  return means;
}

/// The density w_i of Eq. (5), with theta falling to e^-4 at the radius, as CGAL's point set
/// algorithms have it. A point is not its own neighbor: the "1 +" counts it.
inline std::vector<double> local_densities(const std::vector<Point_3>& points,
                                           const Search_tree& tree, double radius)
{
  std::vector<double> densities;
  densities.reserve(points.size());
  std::vector<Point_3> neighbors;
  std::size_t number_of_neighbors = 0;
  for (const Point_3& p : points) {
    neighbors.clear();
    tree.search(std::back_inserter(neighbors), CGAL::Fuzzy_sphere<Search_traits>(p, radius));
    number_of_neighbors += neighbors.size() - 1;
    double sum = -1; // what the point itself will add
    for (const Point_3& neighbor : neighbors)
      sum += std::exp(-4 * CGAL::squared_distance(p, neighbor) / (radius * radius));
    densities.push_back(sum);
  }
  const double mean_number_of_neighbors = double((std::max)(number_of_neighbors, std::size_t(1)))
                                          / points.size();
  for (double& density : densities)
    density = 1 + density / mean_number_of_neighbors;
  return densities;
}

/// The radius of Eq. (5): three times the spacing of so many points that share the area evenly, so
/// that results of equal size are measured with one radius, however clustered they are.
inline double density_radius(double area, std::size_t number_of_points)
{
  return 3 * std::sqrt(area / double(number_of_points));
}

/// \param area of the surface
inline Uniformity measure_uniformity(const std::vector<Point_3>& points, const Search_tree& tree,
                                     double area)
{
  const double radius = density_radius(area, points.size());
  return {quantile(mean_neighbor_distances(points, tree, 1), 0.5),
          coefficient_of_variation(mean_neighbor_distances(points, tree, 6)),
          coefficient_of_variation(local_densities(points, tree, radius))};
}

/// Points on the segments, evenly spaced, `count` or a little more.
inline std::vector<Point_3> sample_segments(const std::vector<Segment_3>& segments,
                                            std::size_t count)
{
  double length = 0;
  for (const Segment_3& segment : segments)
    length += std::sqrt(segment.squared_length());
  std::vector<Point_3> samples;
  for (const Segment_3& segment : segments) {
    const std::size_t steps = std::size_t(
      std::ceil(double(count) * std::sqrt(segment.squared_length()) / length));
    for (std::size_t i = 0; i < steps; ++i)
      samples.push_back(segment.source() + (double(i) + 0.5) / double(steps) * segment.to_vector());
  }
  return samples;
}

/// \param deviations of the normals of the points, empty if they have none
/// \pre the mesh has a feature edge
inline Feature_statistics measure_features(const std::vector<Point_3>& points,
                                           const Search_tree& tree,
                                           const std::vector<Normal_deviation>& deviations,
                                           const Ground_truth& truth, double median_spacing)
{
  Feature_statistics statistics;
  const std::vector<double> gaps =
    distances_to_nearest(sample_segments(truth.feature_edges(), 20000), tree);
  const auto is_met = [&](double gap) { return gap <= 2 * median_spacing; };
  statistics.edge_recall = double(std::count_if(gaps.begin(), gaps.end(), is_met))
                           / double(gaps.size());

  std::vector<double> distances, angles;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (truth.distance_to_features(points[i]) <= 0.015 * truth.diagonal()) {
      distances.push_back(truth.distance(points[i]) / truth.diagonal() * 100);
      if (!deviations.empty())
        angles.push_back(deviations[i].angle);
    }
  statistics.number_of_points = distances.size();
  if (!distances.empty())
    statistics.mean_distance = mean(distances);
  if (!angles.empty())
    statistics.mean_normal_error = mean(angles);
  return statistics;
}

/// All measures of a result.
/// \param normals as many as points, or none
/// \throws std::invalid_argument if there is no point, a coordinate is not finite, or the numbers
/// do not match
inline Evaluation evaluate(const std::vector<Point_3>& points, const std::vector<Vector_3>& normals,
                           const Ground_truth& truth)
{
  if (points.empty())
    throw std::invalid_argument("there are no points to evaluate");
  if (!normals.empty() && normals.size() != points.size())
    throw std::invalid_argument("there are " + std::to_string(normals.size()) + " normals for "
                                + std::to_string(points.size()) + " points");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(points[i].x()) || !std::isfinite(points[i].y())
        || !std::isfinite(points[i].z()))
      throw std::invalid_argument("point " + std::to_string(i) + " is not finite");

  const double percent = truth.diagonal() / 100;
  const Search_tree tree(points.begin(), points.end());
  Sampling dense;
  dense.number_of_points = 200000;

  Evaluation evaluation;
  evaluation.distance = summarize(distances_to_mesh(points, truth), percent);
  evaluation.coverage = summarize(distances_to_nearest(sample_mesh(truth.mesh(), dense), tree),
                                  percent);
  evaluation.chamfer = evaluation.distance.mean + evaluation.coverage.mean;
  evaluation.hausdorff = (std::max)(evaluation.distance.max, evaluation.coverage.max);
  evaluation.uniformity = measure_uniformity(points, tree, Area_sampler(truth.mesh()).area());
  const std::vector<Normal_deviation> deviations = normals.empty()
                                                     ? std::vector<Normal_deviation>()
                                                     : normal_deviations(points, normals, truth);
  if (!deviations.empty())
    evaluation.normals = summarize(deviations);
  if (!truth.feature_edges().empty())
    evaluation.features = measure_features(points, tree, deviations, truth,
                                           evaluation.uniformity.median_spacing);
  return evaluation;
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_METRICS_H
