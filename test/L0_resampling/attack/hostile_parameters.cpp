// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "hostile.h"

#include <algorithm>
#include <cmath>

namespace attack {
namespace {

/// Defaults with some changes.
template <typename F>
Parameters with(const F& change)
{
  Parameters p;
  change(p);
  return p;
}

} // namespace

std::vector<Named_parameters> hostile_parameter_sets(std::size_t size, double diagonal)
{
  using P = Parameters;
  const double n = double(size);
  return {
    {"defaults", P()},
    {"LOR", with([](P& p) { p.method = 1; })},
    {"ALOR", with([](P& p) { p.method = 2; })},
    {"no such method", with([](P& p) { p.method = 7; })},
    {"a negative method", with([](P& p) { p.method = -1; })},
    {"single precision", with([](P& p) { p.in_single_precision = true; })},
    {"single precision, LOR", with([](P& p) {
       p.in_single_precision = true;
       p.method = 1;
     })},
    {"Cholesky", with([](P& p) { p.solver = Solver::CHOLESKY; })},
    {"least squares", with([](P& p) { p.solver = Solver::LEAST_SQUARES; })},
    {"least squares, ALOR", with([](P& p) {
       p.solver = Solver::LEAST_SQUARES;
       p.method = 2;
     })},
    {"given normals", with([](P& p) { p.with_normals = true; })},
    {"given normals, LOR", with([](P& p) {
       p.with_normals = true;
       p.method = 1;
     })},
    // How many
    {"none", with([](P& p) { p.number_of_output_points = 0; })},
    {"one", with([](P& p) { p.number_of_output_points = 1; })},
    {"as many", with([=](P& p) { p.number_of_output_points = n; })},
    {"one more", with([=](P& p) { p.number_of_output_points = n + 1; })},
    {"seven times as many", with([=](P& p) { p.number_of_output_points = 7 * n; })},
    {"LOR, twice as many", with([=](P& p) {
       p.method = 1;
       p.number_of_output_points = 2 * n;
     })},
    {"minus one", with([](P& p) { p.number_of_output_points = -1; })},
    {"NaN points", with([](P& p) { p.number_of_output_points = nan; })},
    {"infinitely many", with([](P& p) { p.number_of_output_points = infinity; })},
    {"2^31, little memory", with([](P& p) {
       p.number_of_output_points = 2147483648.;
       p.maximum_memory = 1 << 24;
     })},
    {"2^32 - 2, little memory", with([](P& p) {
       p.number_of_output_points = 4294967294.;
       p.maximum_memory = 1 << 24;
     })},
    {"2^32 - 1", with([](P& p) { p.number_of_output_points = 4294967295.; })},
    {"2^63", with([](P& p) { p.number_of_output_points = 9223372036854775808.; })},
    {"a hundred percent", with([](P& p) { p.select_percentage = 100; })},
    {"hardly any percent", with([](P& p) { p.select_percentage = 1e-300; })},
    {"no percent", with([](P& p) { p.select_percentage = 0; })},
    {"too many percent", with([](P& p) { p.select_percentage = 100.0000001; })},
    {"NaN percent", with([](P& p) { p.select_percentage = nan; })},
    // Radii
    {"a radius of nobody", with([=](P& p) { p.neighbor_radius = 1e-9 * diagonal; })},
    {"a radius of few", with([=](P& p) { p.neighbor_radius = 0.03 * diagonal; })},
    {"a radius of many", with([=](P& p) { p.neighbor_radius = 0.4 * diagonal; })},
    {"a radius of everybody", with([=](P& p) { p.neighbor_radius = 1e6 * diagonal; })},
    {"LOR, a radius of everybody, more points", with([=](P& p) {
       p.method = 1;
       p.neighbor_radius = diagonal;
       p.number_of_output_points = 2 * n;
     })},
    {"the least radius", with([](P& p) { p.neighbor_radius = Numbers::denorm_min(); })},
    {"the largest radius", with([](P& p) { p.neighbor_radius = largest; })},
    {"radius 0", with([](P& p) { p.neighbor_radius = 0; })},
    {"radius -1", with([](P& p) { p.neighbor_radius = -1; })},
    {"radius NaN", with([](P& p) { p.neighbor_radius = nan; })},
    {"radius infinity", with([](P& p) { p.neighbor_radius = infinity; })},
    {"the least noise", with([](P& p) { p.noise = Numbers::denorm_min(); })},
    {"the largest noise", with([](P& p) { p.noise = largest; })},
    {"a noise of a tenth", with([=](P& p) { p.noise = 0.1 * diagonal; })},
    {"noise 0", with([](P& p) { p.noise = 0; })},
    {"noise NaN", with([](P& p) { p.noise = nan; })},
    {"a noise of LOR", with([=](P& p) {
       p.method = 1;
       p.noise = 0.01 * diagonal;
     })},
    {"the least filter radius", with([](P& p) { p.normal_filter_radius = Numbers::denorm_min(); })},
    {"the largest filter radius", with([](P& p) { p.normal_filter_radius = largest; })},
    {"filter radius of all, radius of nobody", with([=](P& p) {
       p.neighbor_radius = 1e-6 * diagonal;
       p.normal_filter_radius = diagonal;
     })},
    {"filter radius NaN", with([](P& p) { p.normal_filter_radius = nan; })},
    // Weights
    {"a blunt angle", with([](P& p) { p.sharpness_angle = 90; })},
    {"hardly an angle", with([](P& p) { p.sharpness_angle = 1e-300; })},
    {"angle 90.1", with([](P& p) { p.sharpness_angle = 90.1; })},
    {"angle NaN", with([](P& p) { p.sharpness_angle = nan; })},
    {"no filter", with([](P& p) { p.number_of_normal_filter_iterations = 0; })},
    {"one pass of the filter", with([](P& p) { p.number_of_normal_filter_iterations = 1; })},
    {"forty passes", with([](P& p) { p.number_of_normal_filter_iterations = 40; })},
    {"10001 passes", with([](P& p) { p.number_of_normal_filter_iterations = 10001; })},
    {"minus one pass", with([](P& p) { p.number_of_normal_filter_iterations = -1; })},
    {"no price of jumps", with([](P& p) { p.normal_weight = 0; })},
    {"jumps beyond price", with([](P& p) { p.normal_weight = largest; })},
    {"price infinity", with([](P& p) { p.normal_weight = infinity; })},
    {"price -0.1", with([](P& p) { p.normal_weight = -0.1; })},
    {"no regularization", with([](P& p) { p.regularization_weight = 0; })},
    {"strong regularization", with([](P& p) { p.regularization_weight = 1e6; })},
    {"overwhelming regularization", with([](P& p) { p.regularization_weight = largest; })},
    {"regularization NaN", with([](P& p) { p.regularization_weight = nan; })},
    {"the least penalty", with([](P& p) {
       p.initial_penalty = Numbers::denorm_min();
       p.maximum_penalty = 1e-320;
     })},
    {"the largest penalties", with([](P& p) { p.initial_penalty = p.maximum_penalty = largest; })},
    {"all penalties in one leap", with([](P& p) {
       p.initial_penalty = 1e-300;
       p.maximum_penalty = 1e300;
       p.penalty_growth = 1e200;
     })},
    {"first penalty above the last", with([](P& p) { p.initial_penalty = 5; })},
    {"penalty 0", with([](P& p) { p.initial_penalty = 0; })},
    {"last penalty infinity", with([](P& p) { p.maximum_penalty = infinity; })},
    {"growth 1", with([](P& p) { p.penalty_growth = 1; })},
    {"growth next to 1", with([](P& p) { p.penalty_growth = 1.0000000000000002; })},
    {"growth 1.05", with([](P& p) { p.penalty_growth = 1.05; })},
    {"the largest growth", with([](P& p) { p.penalty_growth = largest; })},
    {"3 orientation neighbors", with([](P& p) { p.number_of_orientation_neighbors = 3; })},
    {"1000 orientation neighbors", with([](P& p) { p.number_of_orientation_neighbors = 1000; })},
    {"2 orientation neighbors", with([](P& p) { p.number_of_orientation_neighbors = 2; })},
    {"2^32 - 1 orientation neighbors",
     with([](P& p) { p.number_of_orientation_neighbors = 4294967295.; })},
    // The rest
    {"the last seed",
     with([](P& p) { p.random_seed = (std::numeric_limits<std::size_t>::max)(); })},
    {"dropping what is not finite", with([](P& p) { p.drop_non_finite = true; })},
    {"dropping all that can be", with([](P& p) {
       p.drop_non_finite = true;
       p.drop_outliers = true;
       p.method = 1;
     })},
    {"dropping no outliers", with([](P& p) { p.drop_outliers = false; })},
    {"the most sensitive", with([](P& p) { p.outlier_sensitivity = 3; })},
    {"the least sensitive", with([](P& p) { p.outlier_sensitivity = Numbers::denorm_min(); })},
    {"LOR, half as sensitive", with([](P& p) {
       p.outlier_sensitivity = 0.5;
       p.method = 1;
     })},
    {"sensitivity NaN", with([](P& p) { p.outlier_sensitivity = nan; })},
    {"sensitivity -1", with([](P& p) { p.outlier_sensitivity = -1; })},
    {"keeping the density", with([](P& p) { p.keep_density = true; })},
    {"keeping the density, LOR, more points", with([=](P& p) {
       p.keep_density = true;
       p.method = 1;
       p.number_of_output_points = 2 * n;
     })},
    {"a viewpoint among the points", with([](P& p) { p.viewpoint = 0; })},
    {"a viewpoint next to the points", with([=](P& p) { p.viewpoint = diagonal; })},
    {"a viewpoint at the largest number", with([](P& p) { p.viewpoint = largest; })},
    {"a viewpoint at the least number", with([](P& p) { p.viewpoint = Numbers::denorm_min(); })},
    {"viewpoint NaN", with([](P& p) { p.viewpoint = nan; })},
    {"viewpoint infinity", with([](P& p) { p.viewpoint = infinity; })},
    {"a viewpoint for each point", with([=](P& p) {
       p.viewpoint = diagonal;
       p.viewpoint_by_map = true;
     })},
    {"viewpoints among the points, LOR, more points", with([=](P& p) {
       p.viewpoint = 0;
       p.viewpoint_by_map = true;
       p.method = 1;
       p.number_of_output_points = 2 * n;
     })},
    {"viewpoints at the largest number", with([](P& p) {
       p.viewpoint = largest;
       p.viewpoint_by_map = true;
     })},
    {"viewpoints at infinity, which say nothing", with([](P& p) {
       p.viewpoint = infinity;
       p.viewpoint_by_map = true;
     })},
    {"the way up", with([](P& p) { p.up_direction = 1; })},
    {"a short way up", with([](P& p) { p.up_direction = Numbers::denorm_min(); })},
    {"a long way up", with([](P& p) { p.up_direction = -largest; })},
    {"no way up", with([](P& p) { p.up_direction = 0; })},
    {"way up NaN", with([](P& p) { p.up_direction = nan; })},
    {"way up infinity", with([](P& p) { p.up_direction = infinity; })},
    {"a viewpoint and the way up", with([](P& p) { p.viewpoint = p.up_direction = 1; })},
    {"hints", with([](P& p) { p.with_hints = true; })},
    {"hints, given normals, ALOR", with([](P& p) {
       p.with_hints = p.with_normals = true;
       p.method = 2;
     })},
    {"hints and a viewpoint", with([](P& p) {
       p.with_hints = true;
       p.viewpoint = 1;
     })},
    {"nearest points and confidences", with([](P& p) { p.with_point_data = true; })},
    {"nearest points and confidences, LOR", with([](P& p) {
       p.with_point_data = true;
       p.method = 1;
     })},
    {"nearest points and confidences, single precision, more points", with([=](P& p) {
       p.with_point_data = p.in_single_precision = true;
       p.number_of_output_points = 2 * n;
     })},
    {"no memory", with([](P& p) { p.maximum_memory = 0; })},
    {"4 KiB", with([](P& p) { p.maximum_memory = 4096; })},
    {"64 KiB", with([](P& p) { p.maximum_memory = 65536; })},
    {"a map that throws at once", with([](P& p) { p.throwing_access = 0; })},
    {"a map that throws late", with([=](P& p) { p.throwing_access = size / 2; })},
    {"an output that throws at once", with([](P& p) { p.throwing_write = 0; })},
    {"an output that throws late", with([=](P& p) { p.throwing_write = size / 4; })},
  };
}

Parameters random_parameters(std::size_t n, double diagonal, Generator& generator)
{
  const auto random = [&](double low, double high) {
    return test::random_number(low, high, generator);
  };
  const auto one_in = [&](double k) { return random(0, k) < 1; };
  // mostly sensible, so that more is reached than the checks of parameters
  const auto number = [&](double low, double high) {
    static const std::vector<double> bad{
      0, -1, nan, infinity, -infinity, largest, Numbers::denorm_min(), -0., 1, 1e-30, 1e30};
    return one_in(60) ? bad[std::size_t(random(0, double(bad.size())))]
                      : low * std::pow(high / low, random(0, 1));
  };

  const std::vector<Named_parameters> named = hostile_parameter_sets(n, diagonal);
  Parameters p;
  if (one_in(4))
    p = named[std::size_t(random(0, double(named.size())))].parameters;
  else
    p.method = int(random(0, 3));
  if (one_in(4))
    p.in_single_precision = true;
  if (one_in(40)) // these take most of the time
    p.solver = one_in(2) ? Solver::CHOLESKY : Solver::LEAST_SQUARES;
  if (one_in(4))
    p.with_normals = true;
  if (one_in(3))
    p.number_of_output_points = std::floor(random(0, one_in(4) ? 900 : 300));
  if (one_in(4))
    p.select_percentage = number(1, 100);
  if (one_in(3))
    p.neighbor_radius = number(1e-4, 3) * diagonal;
  if (one_in(5))
    p.normal_filter_radius = number(1e-4, 3) * diagonal;
  if (one_in(6))
    p.sharpness_angle = number(0.1, 90);
  if (one_in(6))
    p.number_of_normal_filter_iterations = std::floor(random(0, 12));
  if (one_in(6))
    p.normal_weight = number(1e-6, 1e6);
  if (one_in(6))
    p.regularization_weight = number(1e-6, 1e6);
  if (one_in(6))
    p.initial_penalty = number(1e-6, 1e3);
  if (one_in(6))
    p.maximum_penalty = number(1e-3, 1e6);
  if (one_in(6))
    p.penalty_growth = number(1.2, 100);
  if (one_in(6))
    p.number_of_orientation_neighbors = std::floor(random(3, 40));
  if (one_in(3))
    p.random_seed = std::size_t(random(0, 1e6));
  if (one_in(2))
    p.drop_non_finite = true;
  if (one_in(4))
    p.drop_outliers = one_in(2);
  if (one_in(4))
    p.outlier_sensitivity = random(0, 3);
  if (one_in(20))
    p.maximum_memory = std::size_t(1e3 * std::pow(1e3, random(0, 1)));
  if (one_in(40))
    p.throwing_access = std::size_t(random(0, 2 * double(n) + 1));
  if (one_in(40))
    p.throwing_write = std::size_t(random(0, double(n) + 1));
  if (one_in(6))
    p.keep_density = true;
  if (one_in(8))
    p.viewpoint = (one_in(2) ? 1 : -1) * number(1e-3, 1e3) * diagonal;
  if (p.viewpoint)
    p.viewpoint_by_map = one_in(3);
  if (one_in(p.viewpoint ? 60 : 12))
    p.up_direction = (one_in(2) ? 1 : -1) * number(1e-3, 1e3);
  if (one_in(p.viewpoint || p.up_direction ? 60 : 8))
    p.with_hints = true;
  if (one_in(6))
    p.with_point_data = true;
  // where everybody is everybody's neighbor, a factorization takes the cube of the number of
  // samples, in each of hundreds of iterations
  if (p.solver != Solver::BLOCK_CHEBYSHEV)
    p.number_of_output_points = (std::min)(p.number_of_output_points.value_or(100), 100.);
  return p;
}

double number_of_growths(const Parameters& p)
{
  const double growth = p.penalty_growth.value_or(p.method == 0 ? 2.3 : 1.5);
  return (std::log(p.maximum_penalty) - std::log(p.initial_penalty)) / std::log(growth);
}

double diagonal_of(const std::vector<Vector>& points)
{
  Vector low = Vector::Zero(), high = Vector::Zero();
  bool is_first = true;
  for (const Vector& p : points)
    if (p.allFinite())
    {
      low = is_first ? p : Vector(low.cwiseMin(p));
      high = is_first ? p : Vector(high.cwiseMax(p));
      is_first = false;
    }
  const Vector extent = high / 2 - low / 2; // halves, as the largest numbers have no difference
  const double longest = extent.maxCoeff();
  return longest > 0 ? (std::min)(2 * longest * (extent / longest).norm(), largest) : 0;
}

} // namespace attack
