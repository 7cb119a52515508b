// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How sure the sides of normals are: the winding numbers that dipoles have at each other, what
// follows from them, and the named parameters side_confidence_map and neighbor_radius_map.

#include "promise_support.h"

#include <CGAL/L0_resampling/internal/orientation/winding_numbers.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using test::Vector;
namespace params = CGAL::parameters;
namespace internal = CGAL::L0_resampling::internal;

namespace {

/// Even points on a sphere around the origin, with normals outwards.
void sphere(std::size_t size, double radius, internal::Buffer<Vector>& positions,
            internal::Buffer<Vector>& normals)
{
  const double golden_angle = 2.399963229728653;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double z = 1 - (2 * double(i) + 1) / double(size), r = std::sqrt(1 - z * z);
    const Vector n(r * std::cos(golden_angle * double(i)), r * std::sin(golden_angle * double(i)),
                   z);
    positions.push_back(radius * n);
    normals.push_back(n);
  }
}

/// As `Dipoles_of_trees::evidence_of()`, by its definition.
internal::Side_evidence naive_evidence(const std::vector<CGAL::L0_resampling::Index>& samples,
                                       const internal::Signed_union_find& trees,
                                       const internal::Buffer<Vector>& positions,
                                       const internal::Buffer<Vector>& normals, std::size_t k,
                                       double area)
{
  const double pi = 3.141592653589793, squared_core = area / pi;
  const auto [root, sign] = trees.find(samples[k]);
  double winding = 0, sum = 0, total = 0;
  for (const CGAL::L0_resampling::Index other : samples)
    if (const auto [other_root, other_sign] = trees.find(other);
        other != samples[k] && other_root == root)
    {
      const Vector d = positions[other] - positions[samples[k]], n = sign * normals[samples[k]],
                   m = other_sign * normals[other];
      const double r = std::sqrt(d.squaredNorm() + squared_core);
      winding += area * m.dot(d) / (4 * pi * r * r * r);
      if (d.squaredNorm() <= 2 * squared_core)
        continue;
      const double agreement =
        (n.dot(m) - 3 * (squared_core * n.dot(m) + n.dot(d) * m.dot(d)) / (r * r)) / (r * r * r);
      sum += agreement;
      total += std::abs(agreement);
    }
  return {winding, total > 0 ? sum / total : 0};
}

void check_evidence_by_definition()
{
  std::mt19937 generator(7);
  std::normal_distribution<double> normal;
  const std::size_t size = 203; // no multiple of the lanes
  internal::Buffer<Vector> positions, normals;
  internal::Signed_union_find trees(size,
                                    internal::Counting_allocator<CGAL::L0_resampling::Index>());
  std::vector<CGAL::L0_resampling::Index> samples;
  for (std::size_t i = 0; i < size; ++i)
  {
    const auto coordinate = [&] { return normal(generator); };
    positions.push_back(Vector(coordinate(), coordinate(), coordinate()));
    normals.push_back(Vector(coordinate(), coordinate(), coordinate()).normalized());
    samples.push_back(CGAL::L0_resampling::Index(i));
    if (i >= 2 && i < size - 1) // two trees, mixed up, and one of a single sample
      trees.join(CGAL::L0_resampling::Index(i % 2), CGAL::L0_resampling::Index(i),
                 i % 3 == 0 ? -1 : 1);
  }
  const double area = 0.05;
  const internal::Dipoles_of_trees dipoles(samples, trees, positions, normals);
  double maximum_error = 0;
  for (std::size_t k = 0; k < size; ++k)
  {
    const internal::Side_evidence fast = dipoles.evidence_of(k, area),
                                  naive = naive_evidence(samples, trees, positions, normals, k,
                                                         area);
    maximum_error = (std::max)({maximum_error, std::abs(fast.winding_number - naive.winding_number),
                                std::abs(fast.agreement - naive.agreement)});
  }
  if (!CHECK(maximum_error < 1e-5))
    std::cerr << "evidence is off by " << maximum_error << std::endl;
}

/// Of a flat sheet all agree, however near to each other some are.
void check_evidence_of_flat_sheet()
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform;
  const std::size_t size = 400;
  internal::Buffer<Vector> positions, normals(size, Vector::UnitZ());
  internal::Signed_union_find trees(size,
                                    internal::Counting_allocator<CGAL::L0_resampling::Index>());
  std::vector<CGAL::L0_resampling::Index> samples;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double x = uniform(generator), y = uniform(generator);
    positions.push_back(Vector(x, y, 0));
    samples.push_back(CGAL::L0_resampling::Index(i));
    trees.join(0, CGAL::L0_resampling::Index(i), 1);
  }
  const internal::Dipoles_of_trees dipoles(samples, trees, positions, normals);
  double least = 1;
  for (std::size_t k = 0; k < size; ++k)
    least = (std::min)(least, dipoles.evidence_of(k, 1 / double(size)).agreement);
  CHECK(least > 0.999);
}

void check_winding_number_of_sphere()
{
  const std::size_t size = 2000;
  internal::Buffer<Vector> positions, normals;
  sphere(size, 3, positions, normals);
  internal::Signed_union_find trees(size,
                                    internal::Counting_allocator<CGAL::L0_resampling::Index>());
  std::vector<CGAL::L0_resampling::Index> samples;
  for (std::size_t i = 0; i < size; ++i)
  {
    samples.push_back(CGAL::L0_resampling::Index(i));
    trees.join(0, CGAL::L0_resampling::Index(i), 1);
  }
  const double area = 4 * 3.141592653589793 * 9 / double(size);
  const internal::Dipoles_of_trees dipoles(samples, trees, positions, normals);
  for (std::size_t k = 0; k < size; k += 97)
  {
    const internal::Side_evidence evidence = dipoles.evidence_of(k, area);
    CHECK(std::abs(evidence.winding_number - 0.5) < 0.03 && evidence.agreement > 0.9);
    CHECK(internal::confidence_within_tree(evidence, 0.5) > 0.97);
    // the same sample turned against the others: they agree about its place, not about it
    CHECK(internal::confidence_within_tree({evidence.winding_number, -evidence.agreement}, 0.5)
          < 0.8);
  }
}

void check_formulas()
{
  CHECK(internal::confidence_of_tree(0.5, 0) > 0.999 && internal::confidence_of_tree(0, 1) == 0.5);
  // half of a sphere, a view of a body, and a street
  CHECK(internal::confidence_of_tree(0.2, 0.5) > 0.95
        && internal::confidence_of_tree(0.12, 0.8) > 0.95
        && internal::confidence_of_tree(0.12, 0.5) == 0.5);
  // as the flux says, unless the winding number contradicts it
  CHECK(!internal::is_turned_by_windings(false, 0.3)
        && internal::is_turned_by_windings(true, -0.3));
  CHECK(internal::is_turned_by_windings(false, -0.3)
        && !internal::is_turned_by_windings(true, 0.3));
  CHECK(!internal::is_turned_by_windings(false, -1e-6)
        && internal::is_turned_by_windings(true, 1e-6));
  CHECK(std::abs(internal::confidence_of_side(0.5, 0.99) - 0.5) < 1e-12);
  CHECK(std::abs(internal::confidence_of_side(1, 0.9) - 0.9) < 1e-12);
  // certain where the viewpoint is, a guess edge-on
  CHECK(internal::confidence_of_viewpoint(0.2) == 1 && internal::confidence_of_viewpoint(-0.2) == 0
        && internal::confidence_of_viewpoint(0) == 0.5);
  CHECK(std::abs(internal::confidence_of_viewpoint(0.0425) - 0.75) < 1e-12
        && std::abs(internal::confidence_of_viewpoint(-0.0425) - 0.25) < 1e-12);
  internal::Side_votes votes;
  votes.sum = -3;
  votes.total = 4;
  CHECK(std::abs(internal::confidence_of_hints(votes) - 0.875) < 1e-12);
  votes.certain_sum = 1;
  CHECK(internal::confidence_of_hints(votes) == 1);
}

struct Result
{
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> pairs;
  std::vector<double> confidences;
  std::vector<float> radii;
  CGAL::L0_resampling::Report report;

  double mean_confidence() const
  {
    double sum = 0;
    for (const double confidence : confidences)
      sum += confidence;
    return sum / double(confidences.size());
  }
};

template <typename NamedParameters>
Result resampled(const Points& points, std::size_t size, const NamedParameters& np)
{
  Result result;
  result.confidences.resize(size, -1);
  result.radii.resize(size, -1);
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result.pairs),
    np.number_of_output_points(size)
      | params::side_confidence_map(CGAL::make_property_map(result.confidences))
      | params::neighbor_radius_map(CGAL::make_property_map(result.radii))
      | params::resampling_report(&result.report));
  return result;
}

Points noisy_sphere(std::size_t size, bool only_upper_half)
{
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  Points points;
  while (points.size() < size)
  {
    Vector n(normal(generator), normal(generator), normal(generator));
    n.normalize();
    if (only_upper_half && n[2] < 0.5)
      continue;
    n *= 1 + 0.005 * normal(generator);
    points.push_back(Kernel::Point_3(n[0], n[1], n[2]));
  }
  return points;
}

void check_call()
{
  {
    const Result closed = resampled(noisy_sphere(3000, false), 2000, params::random_seed(1));
    CHECK(closed.report.right_side_share > 0.97 && closed.report.right_side_share <= 1);
    CHECK(std::abs(closed.mean_confidence() - closed.report.right_side_share) < 1e-6);
    CHECK(*std::min_element(closed.confidences.begin(), closed.confidences.end()) > 0.9);
    // one radius for all
    for (const float radius : closed.radii)
      CHECK(radius == float(closed.report.neighbor_radius));
  }
  // a plane has no outside
  Points plane;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 3000; ++i)
    plane.push_back(Kernel::Point_3{uniform(generator), uniform(generator), 0});
  {
    const Result guess = resampled(plane, 1500, params::random_seed(1));
    CHECK(guess.report.right_side_share < 0.6);
    const Result seen =
      resampled(plane, 1500, params::random_seed(1) | params::viewpoint(Kernel::Point_3(0, 0, 9)));
    CHECK(seen.report.right_side_share == 1);
    const Result seen_edge_on = resampled(
      plane, 1500, params::random_seed(1) | params::viewpoint(Kernel::Point_3(5, 0.5, 0.02)));
    CHECK(std::abs(seen_edge_on.report.right_side_share - 0.5) < 0.05);
  }
  {
    const Result cap = resampled(noisy_sphere(3000, true), 1500,
                                 params::random_seed(1)
                                   | params::up_direction(Kernel::Vector_3(0, 0, 1)));
    CHECK(cap.report.right_side_share > 0.99);
  }
}

void check_radii_where_spacing_varies()
{
  // dense on one half of a plane, sparse on the other
  Points points;
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 8000; ++i)
    points.push_back(Kernel::Point_3{uniform(generator), uniform(generator), 0});
  for (int i = 0; i < 800; ++i)
    points.push_back(Kernel::Point_3{1 + 3 * uniform(generator), uniform(generator), 0});
  const Result result = resampled(points, 3000, params::random_seed(1));
  CHECK(result.report.largest_neighbor_radius > 1.5 * result.report.least_neighbor_radius);
  const auto [least, largest] = std::minmax_element(result.radii.begin(), result.radii.end());
  CHECK(*largest > 1.4f * *least);
  CHECK(double(*least) >= 0.999 * result.report.least_neighbor_radius
        && double(*largest) <= 1.001 * result.report.largest_neighbor_radius);
  double dense = 0, sparse = 0;
  std::size_t number_of_dense = 0, number_of_sparse = 0;
  for (std::size_t i = 0; i < result.pairs.size(); ++i)
    if (const double x = result.pairs[i].first.x(); x < 0.7)
    {
      dense += double(result.radii[i]);
      ++number_of_dense;
    }
    else if (x > 2)
    {
      sparse += double(result.radii[i]);
      ++number_of_sparse;
    }
  CHECK(sparse / double(number_of_sparse) > 1.3 * dense / double(number_of_dense));
}

} // namespace

int main()
{
  check_evidence_by_definition();
  check_evidence_of_flat_sheet();
  check_winding_number_of_sphere();
  check_formulas();
  check_call();
  check_radii_where_spacing_varies();
  return test::result();
}
