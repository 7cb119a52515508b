// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Once the facts of the whole cloud are given, what one part of it looks like changes no bit of the
// samples of a far part, but for the signs of their normals.

#include "stage_support.h"

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/internal/driver/resample.h>
#ifndef CGAL_L0_LINKED_WITH_COMPILED
#include <CGAL/L0_resampling/internal/driver/resample_impl.h>
#endif

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace internal = CGAL::L0_resampling::internal;
using CGAL::L0_resampling::Block_chebyshev_solver_traits;
using CGAL::L0_resampling::Report;
using namespace test;

constexpr double middle = 15; // in z, between the two parts

struct Sample
{
  Vector position;
  Eigen::Vector3f normal;
};

/// Resamples by the default method.
/// \param facts as far as they are known; out: all
/// \returns the samples of the near part, in the order of the result
template <typename ConcurrencyTag>
std::vector<Sample> near_samples(const std::vector<Vector>& points, Facts_of_cloud& facts)
{
  Parameters parameters;
  parameters.outlier_sensitivity = 1;
  parameters.penalty_growth = default_penalty_growth;
  parameters.number_of_output_points = 3000;
  Block_chebyshev_solver_traits<Local, ConcurrencyTag> solver;
  Any_solver<Local> any_solver(solver);
  Buffer<Vector> buffer = to_buffer(points);
  Buffer<Local_vector> no_normals, no_hints;
  Report report;
  Memory_counter memory;
  Progress progress{nullptr, report, memory};
  const auto result = internal::resample<ConcurrencyTag>(buffer, no_normals, no_hints, parameters,
                                                         any_solver, progress, report, facts);
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < result.positions.size(); ++i)
    if (result.positions[i][2] < middle)
      samples.push_back({result.positions[i], result.normals[i]});
  return samples;
}

/// How many samples differ in a bit of the position, or of the normal but for its sign.
std::size_t number_of_different(const std::vector<Sample>& a, const std::vector<Sample>& b)
{
  if (a.size() != b.size())
    return (std::max)(a.size(), b.size());
  std::size_t number = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    number += a[i].position != b[i].position
              || (a[i].normal != b[i].normal && a[i].normal != -b[i].normal);
  return number;
}

std::vector<Vector> noisy_part(std::vector<Vector> points, double noise, const Vector& place,
                               Generator& generator)
{
  add_gaussian_noise(points, noise, generator);
  for (Vector& p : points)
    p += place;
  return points;
}

std::vector<Vector> joined(std::vector<Vector> a, const std::vector<Vector>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

} // namespace

int main()
{
  Generator generator(21);
  const std::vector<Vector> near = noisy_part(cube_points(4000, 2, generator).points, 0.01,
                                              Vector::Zero(), generator),
                            far = noisy_part(cube_points(4000, 2, generator).points, 0.01,
                                             Vector(1, 2, 30), generator);
  // a crowd, outliers, and points so close together that no block of cells is plain
  std::vector<Vector> others = noisy_part(cube_points(500, 1, generator).points, 0.2,
                                          Vector(3, -2, 33), generator);
  others = joined(others, noisy_part(std::vector<Vector>(9000, Vector::Zero()), 0.05,
                                     Vector(0, 0, 35), generator));

  Facts_of_cloud facts;
  const std::vector<Sample> expected = near_samples<CGAL::Sequential_tag>(joined(near, far), facts);
  CHECK(expected.size() > 1000);
  const auto check = [&](const std::string& name, const std::vector<Vector>& others_of_near) {
    Facts_of_cloud known = facts, unknown;
    const std::vector<Vector> points = joined(near, others_of_near);
    const std::size_t number =
      number_of_different(near_samples<CGAL::Sequential_tag>(points, known), expected);
    if (!CHECK(number == 0))
      std::cerr << "  " << name << ": " << number << " of " << expected.size() << std::endl;
    CHECK(
      number_of_different(near_samples<CGAL::Parallel_if_available_tag>(points, known), expected)
      == 0);
    // the test can tell
    CHECK(number_of_different(near_samples<CGAL::Sequential_tag>(points, unknown), expected)
          > expected.size() / 2);
  };
  check("a sphere in place of a cube",
        noisy_part(sphere_points(7000, 1.5, generator).points, 0.02, Vector(0, 1, 25), generator));
  check("noise and a crowd", others);
  check("nothing", {});
  return test::result();
}
