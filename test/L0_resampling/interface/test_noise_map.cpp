// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameter noise_map: the standard deviation of the points around each sample.

#include "promise_support.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
namespace params = CGAL::parameters;

namespace {

/// Points of the unit square, with Gaussian noise across it; of another one where x is above 0.5.
Points noisy_square(std::size_t size, double noise, double noise_on_the_right, double unit = 1)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Points points;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double x = uniform(generator), y = uniform(generator),
                 z = (x < 0.5 ? noise : noise_on_the_right) * normal(generator);
    points.emplace_back(unit * x, unit * y, unit * z);
  }
  return points;
}

template <typename Tag, typename NamedParameters>
std::vector<float> noises_of(const Points& points, const NamedParameters& np,
                             test::Pairs<Kernel>& result)
{
  std::vector<float> noises(points.size(), -1);
  result.clear();
  CGAL::l0_resample_point_set<Tag>(points, std::back_inserter(result),
                                   np | params::noise_map(CGAL::make_property_map(noises)));
  noises.resize(result.size());
  return noises;
}

/// The mean of the noises is within 15 % of the true one, and three of four of them within 30 %.
/// \param is_counted whether those of samples there are
template <typename IsCounted>
void check_noise(const std::string& name, const test::Pairs<Kernel>& result,
                 const std::vector<float>& noises, double truth, const IsCounted& is_counted)
{
  double sum = 0;
  std::size_t number = 0, number_of_good = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (is_counted(result[i].first))
    {
      sum += double(noises[i]);
      ++number;
      number_of_good += std::abs(double(noises[i]) - truth) < 0.3 * truth;
    }
  const double mean = sum / double(number), share = double(number_of_good) / double(number);
  if (!CHECK(number > 100 && std::abs(mean - truth) < 0.15 * truth && share > 0.75))
    std::cerr << "  " << name << ": " << mean << " instead of " << truth << ", " << 100 * share
              << " % of " << number << " are near" << std::endl;
}

const auto anywhere = [](const Kernel::Point_3&) { return true; };

void test_even_noise()
{
  test::Pairs<Kernel> result;
  for (const double noise : {0.002, 0.01, 0.02})
    check_noise("even", result,
                noises_of<CGAL::Parallel_if_available_tag>(noisy_square(20000, noise, noise),
                                                           params::select_percentage(20), result),
                noise, anywhere);
  // in the unit of the input
  for (const double unit : {1e-3, 1e6})
    check_noise("another unit", result,
                noises_of<CGAL::Parallel_if_available_tag>(noisy_square(20000, 0.01, 0.01, unit),
                                                           params::select_percentage(20), result),
                0.01 * unit, anywhere);
  const std::vector<float> clean = noises_of<CGAL::Parallel_if_available_tag>(
    noisy_square(5000, 0, 0), params::select_percentage(20), result);
  CHECK(*std::max_element(clean.begin(), clean.end()) < 1e-4f);
}

void test_noise_that_varies()
{
  test::Pairs<Kernel> result;
  const std::vector<float> noises = noises_of<CGAL::Parallel_if_available_tag>(
    noisy_square(20000, 0.001, 0.004), params::select_percentage(20), result);
  check_noise("left", result, noises, 0.001, [](const Kernel::Point_3& p) { return p.x() < 0.35; });
  check_noise("right", result, noises, 0.004,
              [](const Kernel::Point_3& p) { return p.x() > 0.65; });
}

void test_that_it_changes_nothing()
{
  const Points points = noisy_square(3000, 0.01, 0.02);
  test::Pairs<Kernel> without, with, sequential;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(points, std::back_inserter(without));
  const auto np = params::select_percentage(50);
  const std::vector<float> noises = noises_of<CGAL::Parallel_if_available_tag>(points, np, with);
  CHECK(noises == noises_of<CGAL::Sequential_tag>(points, np, sequential));
  CHECK(test::are_identical<Kernel>(with, without));
  CHECK(test::are_identical<Kernel>(with, sequential));
}

} // namespace

int main()
{
  test_even_noise();
  test_noise_that_varies();
  test_that_it_changes_nothing();
  return test::result();
}
