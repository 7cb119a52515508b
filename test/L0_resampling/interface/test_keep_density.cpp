// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameter keep_density: a gradient of the density stays one, and is evened out without
// it; samples are even relative to the spacing of the input where they are.

#include "promise_support.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using CGAL::L0_resampling::Method;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

/// A surface whose area is spread evenly over one coordinate, along which the density grows.
struct Shape
{
  std::string name;
  Eigen::Index axis;
  std::function<Vector(test::Generator&)>
    random_point; // evenly over the surface; the coordinate lies in [-1, 1]
};

/// So many times as dense at one end as at the other.
std::vector<Vector> with_gradient(const Shape& shape, double fold, std::size_t n, double noise,
                                  test::Generator& generator)
{
  std::vector<Vector> points;
  while (points.size() < n)
  {
    const Vector p = shape.random_point(generator);
    if (test::random_number(0, 1, generator) < std::pow(fold, (p[shape.axis] - 1) / 2))
      points.push_back(p);
  }
  test::add_gaussian_noise(points, noise, generator);
  return points;
}

/// How many times denser the points are at one end than at the other, by a line through the
/// logarithms of the counts of ten bands.
template <typename Points>
double measured_fold(const Points& points, Eigen::Index axis)
{
  const int number_of_bands = 10;
  std::vector<double> counts(number_of_bands, 0.5);
  for (const auto& p : points)
    counts[std::size_t((std::min)((std::max)(int((p[axis] + 1) / 2 * number_of_bands), 0),
                                  number_of_bands - 1))] += 1;
  double slope = 0, weight = 0;
  for (int band = 1; band + 1 < number_of_bands;
       ++band) // not the ends, into which noise and borders bring points
  {
    const double x = (2. * band + 1) / number_of_bands - 1;
    slope += x * std::log(counts[std::size_t(band)]);
    weight += x * x;
  }
  return std::exp(2 * slope / weight);
}

/// How much the distance to the nearest neighbor varies, as a share of its mean, where each is read
/// relative to the spacing that its place asks for.
double unevenness(const std::vector<Vector>& points, double fold, Eigen::Index axis)
{
  double sum = 0, sum_of_squares = 0;
  for (const Vector& p : points)
  {
    double nearest = 1e9;
    for (const Vector& q : points)
      if (&q != &p)
        nearest = (std::min)(nearest, (p - q).squaredNorm());
    const double distance = std::sqrt(nearest)
                            * std::pow(fold,
                                       p[axis] / 4); // the spacing falls as the root of the density
    sum += distance;
    sum_of_squares += distance * distance;
  }
  const double mean = sum / double(points.size());
  return std::sqrt(sum_of_squares / double(points.size()) - mean * mean) / mean;
}

template <typename NamedParameters>
std::vector<Vector> resampled(const std::vector<Vector>& points, const NamedParameters& np)
{
  const auto kernel_points = test::kernel_points<Kernel>(points);
  const auto result = test::resample<Kernel, CGAL::Parallel_if_available_tag>(kernel_points, np);
  test::check_clean<Kernel>("keep_density", kernel_points, result, result.pairs.size());
  std::vector<Vector> positions;
  for (const auto& pair : result.pairs)
    positions.push_back(test::as_vector(pair.first));
  return positions;
}

void check_within(const std::string& name, double measured, double low, double high)
{
  std::cout << name << ": " << measured << std::endl;
  if (!CHECK(measured >= low && measured <= high))
    std::cerr << "  " << name << ": " << measured << " not in [" << low << ", " << high << "]"
              << std::endl;
}

const Shape strip{"strip", 0,
                  [](test::Generator& g) { return test::random_vector(Vector(1, 0.5, 0), g); }};

/// Between the ends of a scan spacings differ by twenty. The samples of the dense end have their
/// neighbors within few of theirs, and those of the sparse end have some at all.
void check_steep_gradient(double noise, test::Generator& generator)
{
  const double steep = 400;
  const std::vector<Vector> points = with_gradient(strip, steep, 12000, noise, generator),
                            kept = resampled(points, params::select_percentage(50)
                                                       | params::keep_density(true)
                                                       | params::drop_outliers(false));
  const std::string name = "steep strip, noise " + std::to_string(noise);
  const double fold = measured_fold(points, strip.axis);
  check_within(name, measured_fold(kept, strip.axis), 0.7 * fold, 1.4 * fold);
  check_within(name + ", unevenness", unevenness(kept, steep, strip.axis), 0, 0.16);
}

} // namespace

int main()
{
  const double fold = 10;
  test::Generator generator(1);
  const Shape sphere{"sphere", 2, test::random_unit_vector};
  for (const Shape& shape : {sphere, strip})
    for (double noise : {0., 0.01})
    {
      const std::vector<Vector> points = with_gradient(shape, fold, 8000, noise, generator);
      const std::string name = shape.name + ", noise " + std::to_string(noise);
      const auto check_fold = [&](const std::string& result, const auto& np, double low,
                                  double high) {
        check_within(name + ", " + result, measured_fold(resampled(points, np), shape.axis), low,
                     high);
      };
      check_within(name + ", input", measured_fold(points, shape.axis), 0.85 * fold, 1.15 * fold);
      check_fold("kept", params::select_percentage(100) | params::keep_density(true), 0.7 * fold,
                 1.3 * fold);
      check_fold("kept by LOR", params::keep_density(true).resampling_method(Method::LOR),
                 0.7 * fold, 1.3 * fold);
      check_fold("evened out", params::keep_density(false), 0.75, 1.4);

      const std::vector<Vector> fewer = resampled(points, params::select_percentage(30)
                                                            | params::keep_density(true));
      check_within(name + ", kept by fewer points", measured_fold(fewer, shape.axis), 0.7 * fold,
                   1.3 * fold);
      check_within(name + ", unevenness", unevenness(fewer, fold, shape.axis), 0,
                   0.19); // 0.52 for points by chance
    }
  for (double noise : {0., 0.002})
    check_steep_gradient(noise, generator);
  return test::result();
}
