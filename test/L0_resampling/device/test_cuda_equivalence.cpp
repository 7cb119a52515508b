// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/test_cuda_support.h"

#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// P7: the device and the CPU give one result, but for rounding. Both order it alike, but for
// roundings, and it is compared point by point.

namespace {

using namespace test_cuda;

struct Comparison
{
  double median, largest_but_a_thousandth, hausdorff; // distance, in radii
  double
    largest_angle_share; // share of the normals that differ by more than 5 degrees, sign included
};

/// Both ways, so that no sample of either is without a counterpart.
Comparison compare(const Result& a, const Result& b, double radius)
{
  std::vector<double> distances;
  std::size_t number_of_other_normals = 0;
  const auto add = [&](const Result& from, const Result& to) {
    const std::vector<std::size_t> others = counterparts(from, to, radius);
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      const auto &one = from[i], &other = to[others[i]];
      distances.push_back(std::sqrt(CGAL::squared_distance(one.first, other.first)) / radius);
      number_of_other_normals += one.second * other.second < std::cos(5 * CGAL_PI / 180);
    }
  };
  add(a, b);
  add(b, a);
  std::sort(distances.begin(), distances.end());
  const std::size_t n = distances.size(),
                    left_out = 2 * ((n / 2 + 999) / 1000); // whole samples, each in both results
  return {distances[n / 2], distances[n - 1 - left_out], distances.back(),
          double(number_of_other_normals) / double(n)};
}

/// The largest distances of counterparts, in radii.
struct Bounds
{
  double median = 1e-4, largest_but_a_thousandth = 1e-2, hausdorff = 0.05;
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Bounds of_all_samples = {}, of_most_samples = {1e-4, infinity, infinity};

/// \returns the number of outliers
template <typename PointRange, typename NamedParameters>
std::size_t check_agreement(const std::string& name, const PointRange& points,
                            const NamedParameters& np, const Bounds& bounds = of_all_samples)
{
  Result on_cpu, on_device;
  Report cpu_report, device_report;
  std::vector<std::size_t> cpu_outliers, device_outliers;
  const auto with_outputs = [&](Report& report, std::vector<std::size_t>& outliers) {
    return np | CGAL::parameters::resampling_report(&report)
           | CGAL::parameters::outlier_output_iterator(std::back_inserter(outliers));
  };
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(on_cpu), with_outputs(cpu_report, cpu_outliers));
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(on_device),
                                              with_outputs(device_report, device_outliers));
  if (!CHECK(on_cpu.size() == on_device.size()))
    return 0;
  CHECK(device_report.device == "cuda");
  CHECK(std::abs(cpu_report.neighbor_radius - device_report.neighbor_radius)
        <= 1e-6 * cpu_report.neighbor_radius);
  CHECK(cpu_report.number_of_outliers == device_report.number_of_outliers);
  CHECK(cpu_outliers.size() == cpu_report.number_of_outliers && cpu_outliers == device_outliers);
  const auto are_close = [&](std::size_t a, std::size_t b) {
    return std::abs(double(a) - double(b)) <= 2e-3 * double(on_cpu.size());
  };
  CHECK(are_close(cpu_report.number_of_unexplained_samples,
                  device_report.number_of_unexplained_samples));
  CHECK(are_close(cpu_report.number_of_unexplained_samples_there,
                  device_report.number_of_unexplained_samples_there));
  CHECK((device_report.number_of_unexplained_samples > 0)
        == (device_report.unexplained_radius > 0));
  CHECK(cpu_report.number_of_distinct_points == device_report.number_of_distinct_points);
  CHECK(cpu_report.iterations.size() == device_report.iterations.size());
  const double pairs = double(cpu_report.number_of_self_neighbor_pairs);
  CHECK(std::abs(double(device_report.number_of_self_neighbor_pairs) - pairs) <= 1e-3 * pairs);
  double flipped_share = 0, solver_iterations = 0, more_solver_iterations = 0;
  for (std::size_t i = 0; i < cpu_report.iterations.size(); ++i)
  {
    const auto &on_cpu_then = cpu_report.iterations[i],
               &on_device_then = device_report.iterations[i];
    flipped_share = (std::max)(flipped_share, std::abs(on_cpu_then.active_pair_share
                                                       - on_device_then.active_pair_share));
    solver_iterations += double(on_cpu_then.solver.iterations);
    more_solver_iterations += std::abs(double(on_device_then.solver.iterations)
                                       - double(on_cpu_then.solver.iterations));
  }
  CHECK(flipped_share <= 1e-3);
  CHECK(more_solver_iterations
        <= 2 + 0.1 * solver_iterations); // one stopping rule, but other roundings
  CHECK(std::abs(cpu_report.oriented_share - device_report.oriented_share) <= 1e-2);
  CHECK(std::abs(cpu_report.hinted_share - device_report.hinted_share) <= 1e-2);
  // The dipoles that tell are every so-maniest sample. Where cells of the CPU have many samples, it
  // spreads them less evenly than the device, which has smaller cells.
  CHECK(std::abs(cpu_report.right_side_share - device_report.right_side_share) <= 3e-2);
  CHECK(std::abs(cpu_report.extent_share - device_report.extent_share) <= 1e-3);
  CHECK(warnings(cpu_report) == warnings(device_report));

  const Comparison comparison = compare(on_cpu, on_device, cpu_report.neighbor_radius);
  std::cout << name << ": " << points.size() << " -> " << on_cpu.size() << ", radii median "
            << comparison.median << ", 99.9 % " << comparison.largest_but_a_thousandth
            << ", Hausdorff " << comparison.hausdorff << ", other normals "
            << comparison.largest_angle_share << ", flipped " << flipped_share << ", pairs "
            << pairs << " / " << device_report.number_of_self_neighbor_pairs << ", oriented "
            << cpu_report.oriented_share << " / " << device_report.oriented_share << ", hinted "
            << cpu_report.hinted_share << " / " << device_report.hinted_share << ", right sides "
            << cpu_report.right_side_share << " / " << device_report.right_side_share
            << ", outliers " << cpu_report.number_of_outliers << " / "
            << device_report.number_of_outliers << ", degenerate "
            << cpu_report.number_of_degenerate_neighborhoods << " / "
            << device_report.number_of_degenerate_neighborhoods << ", iterations "
            << solver_iterations << " +- " << more_solver_iterations << std::endl;
  CHECK(comparison.median <= bounds.median);
  CHECK(comparison.largest_but_a_thousandth <= bounds.largest_but_a_thousandth);
  CHECK(comparison.hausdorff <= bounds.hausdorff);
  CHECK(comparison.largest_angle_share <= 1e-2);
  return cpu_report.number_of_outliers;
}

/// Given normals, of which only those of outliers are zero: once these are dropped, PCA has nothing
/// to do.
void check_given_normals()
{
  namespace parameters = CGAL::parameters;
  const Points sphere = noisy_sphere(20000, 0.005, 15), points = with_outliers(sphere, 16);
  Result with_normals;
  for (std::size_t i = 0; i < points.size(); ++i)
    with_normals.emplace_back(points[i],
                              i < sphere.size() ? points[i] - CGAL::ORIGIN : CGAL::NULL_VECTOR);
  CHECK(
    check_agreement("default given normals", with_normals,
                    parameters::point_map(CGAL::First_of_pair_property_map<Result::value_type>())
                      .normal_map(CGAL::Second_of_pair_property_map<Result::value_type>())
                      .select_percentage(50))
    > 0);
}

/// Of a sphere, the half below.
Points noisy_bowl(std::size_t n, double noise, unsigned seed)
{
  Points points;
  for (const Point& p : noisy_sphere(3 * n, noise, seed))
    if (points.size() < n && p.z() < 0)
      points.push_back(p);
  return points;
}

/// A table with a plate that floats over its middle, as a scan from above has them.
Points noisy_table(std::size_t n, double noise, unsigned seed)
{
  Points points;
  for (const Point& p : noisy_cube(6 * n, noise, seed))
    if (points.size() < n && p.z() > 0.9 && std::abs(p.x()) < 0.95 && std::abs(p.y()) < 0.95)
    {
      const bool is_on_plate = std::abs(p.x()) < 0.4 && std::abs(p.y()) < 0.4;
      points.emplace_back(p.x(), p.y(), p.z() + (is_on_plate ? 0.1 : 0));
    }
  return points;
}

/// Viewpoints near and as far as numbers reach.
template <typename NamedParameters>
void check_viewpoints(const std::string& name, const NamedParameters& np)
{
  const Points bowl = noisy_bowl(6000, 0.005, 21), cube = noisy_cube(6000, 0.005, 22),
               table = noisy_table(6000, 0.005, 28);
  for (const double height : {0.5, -1e6, 1e6, 1e300})
    check_agreement(name + "bowl seen from " + std::to_string(height), bowl,
                    np.viewpoint(Point(0.1 * height, 0, height)).select_percentage(50));
  // from inside; and from outside, where the far faces are turned inwards
  for (const Point& viewpoint : {Point(0.3, -0.4, 0.2), Point(3, 0, 0)})
    check_agreement(name + "cube seen from " + std::to_string(viewpoint.x()), cube,
                    np.viewpoint(viewpoint).select_percentage(50));
  check_agreement(name + "table", table, np.viewpoint(Point(0.2, 0.1, 4)).select_percentage(50));
  check_agreement(name + "table and the way up", table,
                  np.up_direction(Normal(0.1, 0, 1)).select_percentage(50));
  check_agreement(name + "bowl on a map", moved(bowl, {500000, 5000000, 100}),
                  np.viewpoint(Point(500000, 5000000, 102)).select_percentage(50));
}

/// A viewpoint for each point: of two scanners, one above and one below a plate; some of no use.
template <typename NamedParameters>
void check_viewpoint_map(const std::string& name, const NamedParameters& np)
{
  std::vector<std::pair<Point, Point>> seen;
  for (const Point& p : noisy_table(8000, 0.005, 29))
  {
    const bool is_from_above = seen.size() % 2 == 0;
    const double height = seen.size() % 11 == 0 ? std::numeric_limits<double>::infinity()
                          : is_from_above       ? 4
                                                : -3;
    seen.emplace_back(p + Normal(0, 0, is_from_above ? 0.4 : 0), Point(0.2, 0, height));
  }
  Report report;
  const auto viewpoints = np.viewpoint_map(
                              CGAL::Second_of_pair_property_map<std::pair<Point, Point>>())
                            .point_map(CGAL::First_of_pair_property_map<std::pair<Point, Point>>());
  check_agreement(name + "two scanners", seen, viewpoints.select_percentage(50));
  check_agreement(name + "two scanners, upsampled", seen,
                  viewpoints.number_of_output_points(10000));
  Result result;
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(seen, std::back_inserter(result),
                                              viewpoints.resampling_report(&report));
  const auto faces_scanner = [](const Result::value_type& point_and_normal) {
    return (point_and_normal.second.z() > 0) == (point_and_normal.first.z() > 1.25);
  };
  CHECK(std::count_if(result.begin(), result.end(), faces_scanner)
        >= std::ptrdiff_t(0.995 * double(result.size())));
  CHECK(report.hinted_share == 1);
}

/// Hints, a third of them wrong, of points that come twice with two of them; of outliers, which are
/// dropped; and of a part without any.
template <typename NamedParameters>
void check_hints(const std::string& name, const NamedParameters& np)
{
  const Points bowl = noisy_bowl(5000, 0.005, 23);
  const Points points = with_outliers(duplicated(bowl), 24);
  Result with_hints;
  for (std::size_t i = 0; i < points.size(); ++i)
    with_hints.emplace_back(points[i], (i % 3 ? -1e-150 : 1e-150) * (points[i] - CGAL::ORIGIN));
  for (const Point& p : noisy_cube(5000, 0.005, 25))
    with_hints.emplace_back(p + Normal(7, 0, 0), CGAL::NULL_VECTOR);
  const auto hints = np.orientation_hint_map(
                         CGAL::Second_of_pair_property_map<Result::value_type>())
                       .point_map(CGAL::First_of_pair_property_map<Result::value_type>());
  CHECK(check_agreement(name + "hints", with_hints, hints.drop_outliers(true).select_percentage(50))
        > 0);
  const Result of_bowl(with_hints.begin(), with_hints.begin() + 10000);
  check_agreement(name + "hints, upsampled", of_bowl,
                  hints.drop_outliers(false).number_of_output_points(15000));

  Report report;
  Result result;
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(
    with_hints, std::back_inserter(result),
    hints.drop_outliers(true).resampling_report(&report).select_percentage(50));
  std::size_t number_inwards = 0, number_on_bowl = 0;
  for (const auto& [p, n] : result)
    if (p.x() < 2 && p.z() < 0.1)
    {
      ++number_on_bowl;
      number_inwards += n * (p - CGAL::ORIGIN) < 0;
    }
  CHECK(number_on_bowl > 0 && double(number_inwards) >= 0.98 * double(number_on_bowl));
  CHECK(report.hinted_share > 0.05 && report.hinted_share < 0.95); // that of the cube has none
}

/// What the CPU refuses the device refuses, and an object that holds hints refuses a viewpoint or
/// a direction beside them.
void check_refusals()
{
  namespace parameters = CGAL::parameters;
  const Points points = noisy_bowl(500, 0.005, 26);
  Result with_hints;
  for (const Point& p : points)
    with_hints.emplace_back(p, CGAL::ORIGIN - p);
  const auto hints = parameters::orientation_hint_map(
                       CGAL::Second_of_pair_property_map<Result::value_type>())
                       .point_map(CGAL::First_of_pair_property_map<Result::value_type>());
  Result result;
  CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::CUDA_tag>(with_hints, std::back_inserter(result),
                                                           hints.viewpoint(Point(0, 0, 3))),
               std::invalid_argument);
  CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::CUDA_tag>(
                 points, std::back_inserter(result),
                 parameters::viewpoint(Point(0, std::numeric_limits<double>::infinity(), 3))),
               std::invalid_argument);
  CGAL::L0_resampling::CUDA_resampler<Kernel> resampler;
  resampler.upload(with_hints, hints);
  CHECK_THROWS(resampler.resample(std::back_inserter(result),
                                  parameters::viewpoint(Point(0, 0, 3))),
               std::invalid_argument);
  CHECK_THROWS(resampler.resample(std::back_inserter(result),
                                  parameters::up_direction(Normal(0, 0, 1))),
               std::invalid_argument);
  CHECK(result.empty());
  Report report;
  resampler.resample(std::back_inserter(result), parameters::resampling_report(&report));
  CHECK(result.size() == 250 && report.hinted_share == 1);
  result.clear();
  resampler.upload(points);
  resampler.resample(std::back_inserter(result), parameters::resampling_report(&report));
  CHECK(result.size() == 250
        && report.hinted_share == 0); // those of the points before are forgotten
  result.clear();
  resampler.resample(std::back_inserter(result),
                     parameters::viewpoint(Point(0, 0, 3)).resampling_report(&report));
  CHECK(result.size() == 250 && report.hinted_share == 1);
}

/// The creases of a result, and its points by their place.
struct Result_with_creases
{
  Result points;
  std::vector<CGAL::L0_resampling::Crease<Kernel>> creases;
  std::vector<CGAL::L0_resampling::Crease_corner<Kernel>> corners;
  Report report;

  const Point& position(std::size_t place) const { return points[place].first; }
  bool is_at_corner(const Point& p, double distance) const
  {
    return std::any_of(corners.begin(), corners.end(), [&](const auto& corner) {
      return CGAL::squared_distance(position(corner.point), p) < distance * distance;
    });
  }
  bool is_on_crease(const Point& p, double distance) const
  {
    for (const auto& crease : creases)
      for (std::size_t k = 0; k + 1 < crease.points.size(); ++k)
        if (CGAL::squared_distance(
              Kernel::Segment_3(position(crease.points[k]), position(crease.points[k + 1])), p)
            < distance * distance)
          return true;
    return false;
  }
};

template <typename Tag>
Result_with_creases resample_with_creases(const Points& points)
{
  namespace parameters = CGAL::parameters;
  Result_with_creases result;
  CGAL::l0_resample_point_set<Tag>(
    points, std::back_inserter(result.points),
    parameters::crease_output_iterator(std::back_inserter(result.creases))
      | parameters::corner_output_iterator(std::back_inserter(result.corners))
      | parameters::resampling_report(&result.report));
  return result;
}

/// The same lines and corners, whichever processor the samples are from.
void check_creases()
{
  const Points points = noisy_cube(20000, 0.01, 29);
  const Result_with_creases host = resample_with_creases<CGAL::Parallel_if_available_tag>(points),
                            device = resample_with_creases<CGAL::CUDA_tag>(points);
  const double maximum_distance = 0.1 * host.report.sample_spacing;
  const auto check_that_other_has = [&](const Result_with_creases& result,
                                        const Result_with_creases& other) {
    CHECK(result.creases.size() == 12 && result.corners.size() == 8); // those of a cube
    for (const auto& corner : result.corners)
      CHECK(other.is_at_corner(result.position(corner.point), maximum_distance));
    for (const auto& crease : result.creases)
    {
      CHECK(crease.is_convex);
      for (const std::size_t place : crease.points)
        CHECK(other.is_on_crease(result.position(place), maximum_distance));
    }
  };
  check_that_other_has(host, device);
  check_that_other_has(device, host);
}

} // namespace

int main()
{
  if (!has_device())
    return number_of_skip;
  using CGAL::L0_resampling::Method;
  namespace parameters = CGAL::parameters;
  for (const Method method : {Method::LOR, Method::ALOR, Method::DEFAULT})
  {
    const std::string name = method == Method::LOR    ? "LOR "
                             : method == Method::ALOR ? "ALOR "
                                                      : "default ";
    const auto np = parameters::resampling_method(method);
    check_agreement(name + "cube", noisy_cube(20000, 0.01, 1), np.select_percentage(60));
    check_agreement(name + "sphere", noisy_sphere(30000, 0.02, 2),
                    np.number_of_output_points(10000));
    check_agreement(name + "upsampled cube", noisy_cube(5000, 0.005, 3),
                    np.number_of_output_points(9000));
    check_agreement(name + "far from the origin",
                    moved(noisy_cube(20000, 0.01, 4), {256075.1, 3935300.5, 120.}),
                    np.select_percentage(60));
    check_agreement(name + "large radius", noisy_cube(4000, 0.01, 5),
                    np.neighbor_radius(0.3).select_percentage(60));
    check_agreement(name + "large filter radius", noisy_cube(20000, 0.01, 6),
                    np.normal_filter_radius(0.2).select_percentage(60));
    check_agreement(name + "few samples", noisy_cube(20000, 0.01, 9),
                    np.number_of_output_points(700));
    for (const std::size_t m :
         {300, 350, 400, 800}) // of single samples, few and many, that are no faces
      check_agreement(name + "few samples of a torus", noisy_torus(8000, 0.002, 21),
                      np.number_of_output_points(m));
    check_agreement(name + "strong noise", noisy_sphere(20000, 0.05, 10), np.select_percentage(60));
    check_agreement(name + "many orientation neighbors", noisy_sphere(3000, 0.01, 11),
                    np.number_of_orientation_neighbors(300).number_of_output_points(2000));
    check_agreement(name + "duplicates", duplicated(noisy_cube(3000, 0.01, 7)),
                    np.select_percentage(60));
    Points with_far_points = noisy_cube(20000, 0.01, 8);
    with_far_points.push_back(Point(1e6, 3, 4));
    with_far_points.push_back(Point(-50, 1e3, 40));
    check_agreement(name + "far points", with_far_points, np.select_percentage(60));
    for (const double noise : {0., 0.01})
    {
      const std::string kind = name + (noise > 0 ? "noisy " : "clean ");
      CHECK(check_agreement(kind + "cube with outliers",
                            with_outliers(noisy_cube(20000, noise, 12), 13),
                            np.drop_outliers(true).select_percentage(60))
            > 500);
      check_agreement(kind + "density gradient", graded_sphere(20000, noise, 14),
                      np.select_percentage(60));
      check_agreement(kind + "kept density", graded_sphere(20000, noise, 19),
                      np.keep_density(true).select_percentage(60));
      check_agreement(kind + "kept steep density", steeply_graded_sphere(20000, noise, 25),
                      np.keep_density(true).drop_outliers(false).select_percentage(60));
    }
    if (method == Method::DEFAULT)
      check_agreement(name + "known noise", graded_sphere(20000, 0.01, 14),
                      np.noise(0.02).select_percentage(60));
    for (const double sensitivity : {0.3, 0.7, 2.})
      CHECK(check_agreement(name + "sensitivity " + std::to_string(sensitivity),
                            with_outliers(noisy_cube(20000, 0.01, 12), 13),
                            np.outlier_sensitivity(sensitivity).select_percentage(60))
            > 300);
    // so many that each has others around it
    CHECK(check_agreement(name + "crowd of outliers",
                          with_crowd(noisy_sphere(20000, 0.08, 22), 4000, 1.3, 23),
                          np.drop_outliers(true).select_percentage(60))
          > 1500);
    CHECK(check_agreement(name + "far crowd of outliers",
                          with_crowd(noisy_sphere(20000, 0.08, 22), 12000, 2, 23),
                          np.drop_outliers(true).select_percentage(60))
          > 8000);
    // where samples beside such a crowd settle, roundings decide, on the CPU as well
    const std::size_t number_of_outliers = check_agreement(
      name + "crowd in one place",
      with_crowd_in_one_place(with_outliers(noisy_sphere(10000, 0.01, 22), 25), 20000, 26),
      np.drop_outliers(true).select_percentage(20), of_most_samples);
    CHECK(number_of_outliers > 200 && number_of_outliers < 600);
    check_agreement(name + "density gradient, strong noise", graded_sphere(20000, 0.04, 24),
                    np.select_percentage(60));
    check_agreement(name + "kept density, upsampled", graded_sphere(4000, 0.005, 20),
                    np.keep_density(true).number_of_output_points(7000));
    check_viewpoints(name, np);
    check_viewpoint_map(name, np);
    check_hints(name, np);
  }
  for (const double noise : {0., 0.005})
    check_agreement(noise > 0 ? "default noisy thin plate" : "default clean thin plate",
                    noisy_plate(20000, 0.05, noise, 17), parameters::select_percentage(60));
  // more points in a block of cells than are looked at
  check_agreement("default huge radius", noisy_cube(20000, 0.01, 18),
                  parameters::neighbor_radius(0.5).select_percentage(20));
  check_given_normals();
  check_creases();
  check_refusals();
  return test::result();
}
