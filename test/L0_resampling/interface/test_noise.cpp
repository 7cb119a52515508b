// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameter noise, which takes the place of what is estimated.

#include "promise_support.h"

#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/l0_estimate_scales.h>

#include <cmath>
#include <iostream>
#include <random>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using CGAL::L0_resampling::Report;
namespace params = CGAL::parameters;

namespace {

/// Points of the unit square times `unit`, with Gaussian noise across it that is four times as
/// large where x is above the middle.
Points noisy_square(double noise, double unit)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < 20000; ++i)
  {
    const double x = uniform(generator), y = uniform(generator),
                 z = (x < 0.5 ? noise : 4 * noise) * normal(generator);
    points.emplace_back(unit * x, unit * y, unit * z);
  }
  return points;
}

template <typename Tag, typename NamedParameters>
test::Pairs<Kernel> result_of(const Points& points, const NamedParameters& np, Report& report)
{
  test::Pairs<Kernel> result;
  CGAL::l0_resample_point_set<Tag>(points, std::back_inserter(result),
                                   np.resampling_report(&report).select_percentage(10));
  return result;
}

/// What `l0_estimate_scales()` says before a call is what the call does.
template <typename NamedParameters>
void check_estimate(const Points& points, const NamedParameters& np, const Report& report)
{
  const Report estimate = CGAL::l0_estimate_scales<CGAL::Sequential_tag>(points,
                                                                         np.select_percentage(10));
  CHECK(estimate.number_of_input_points == points.size());
  CHECK(estimate.neighbor_radius == report.neighbor_radius);
  CHECK(estimate.least_neighbor_radius == report.least_neighbor_radius);
  CHECK(estimate.largest_neighbor_radius == report.largest_neighbor_radius);
  CHECK(estimate.estimated_noise == report.estimated_noise);
  CHECK(estimate.estimated_spacing == report.estimated_spacing);
  CHECK(estimate.iterations.empty());
}

/// The radius follows from the noise that is given and the spacing, and is the same everywhere, as
/// the spacing is. Without it, the radius follows the noise of each half.
void test_radius()
{
  for (const double unit : {1., 1e5})
  {
    const Points points = noisy_square(0.005, unit);
    for (const double noise : {0.002, 0.005, 0.02, 0.04})
    {
      Report report;
      result_of<CGAL::Parallel_if_available_tag>(points, params::noise(noise * unit), report);
      CHECK(report.estimated_noise == noise * unit);
      check_estimate(points, params::noise(noise * unit), report);
      const double radius = CGAL::L0_resampling::internal::wanted_radius(report.estimated_spacing,
                                                                         noise * unit);
      CHECK(std::abs(report.neighbor_radius - radius) < 0.005 * radius); // rounded
      CHECK(report.least_neighbor_radius == report.largest_neighbor_radius);
    }
    Report report;
    result_of<CGAL::Parallel_if_available_tag>(points, params::normal_weight(0.9), report);
    CHECK(report.largest_neighbor_radius > 1.5 * report.least_neighbor_radius);
    check_estimate(points, params::normal_weight(0.9), report);
  }
  const Report cancelled = CGAL::l0_estimate_scales<CGAL::Parallel_if_available_tag>(
    noisy_square(0.005, 1), params::callback([](double) { return false; }));
  CHECK(cancelled.outcome == CGAL::L0_resampling::Outcome::CANCELLED);
}

/// Where the noise is that of the points, the result is about as near to the surface as with the
/// estimated one; where it is far too small, it is not.
void test_distance()
{
  const double noise = 0.01;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < 20000; ++i)
    points.emplace_back(uniform(generator), uniform(generator), noise * normal(generator));
  Report report;
  const auto distance = [&](const auto& np) {
    double sum = 0;
    const test::Pairs<Kernel> result = result_of<CGAL::Parallel_if_available_tag>(points, np,
                                                                                  report);
    for (const auto& sample : result)
      sum += std::abs(sample.first.z());
    return sum / double(result.size());
  };
  const double estimated = distance(params::normal_weight(0.9)),
               known = distance(params::noise(noise)), too_small = distance(params::noise(1e-4));
  if (!CHECK(known < 1.1 * estimated && too_small > 2 * known))
    std::cerr << "  " << known << " with the noise, " << estimated << " with the estimate, "
              << too_small << " with a hundredth" << std::endl;
}

/// The refinement finds the noise around each sample, but not that which is known.
void test_refinement()
{
  using CGAL::L0_resampling::internal::Lengths_of_refinement;
  CHECK((Lengths_of_refinement{1, 0.5, 1, false}.at(2, 3).noise == 1.5));
  const Lengths_of_refinement known{1, 0.5, 1, true};
  CHECK(known.at(2, 3).noise == 0.5 && known.widened(3).at(1, 3).noise == 1.5);
  CHECK(known.at(2, 3).widened(3).at(1, 3).noise == 1.5);
}

void test_that_processors_agree()
{
  const Points points = noisy_square(0.005, 1);
  Report report;
  CHECK(test::are_identical<Kernel>(
    result_of<CGAL::Sequential_tag>(points, params::noise(0.01), report),
    result_of<CGAL::Parallel_if_available_tag>(points, params::noise(0.01), report)));
}

} // namespace

int main()
{
  test_radius();
  test_distance();
  test_refinement();
  test_that_processors_agree();
  return test::result();
}
