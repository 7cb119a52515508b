// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device/test_cuda_support.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

// P7: what is told of each point of the result is the same on the device and on the CPU.

namespace {

using namespace test_cuda;
namespace parameters = CGAL::parameters;

struct Results
{
  Result host, device;
  Report report;                  // of the device
  std::vector<std::size_t> other; // of each point of the host that of the device
};

template <typename OfHost, typename OfDevice>
Results resample(const Points& points, const OfHost& of_host, const OfDevice& of_device)
{
  Results results;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(results.host), of_host);
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(results.device),
                                              of_device.resampling_report(&results.report));
  results.other = counterparts(results.host, results.device, results.report.neighbor_radius);
  CHECK(results.host.size() == results.device.size() && !results.host.empty());
  return results;
}

/// Those that differ by more than 2 %: places at which a test is as good as undecided.
std::size_t number_of_others(const std::string& name, const Results& results,
                             const std::vector<double>& of_host,
                             const std::vector<double>& of_device)
{
  std::size_t number = 0;
  for (std::size_t i = 0; i < results.host.size(); ++i)
    number += !(std::abs(of_device[results.other[i]] - of_host[i]) < 0.02 * of_host[i]);
  std::cout << name << " that differ by more than 2 %: " << number << " of " << results.host.size()
            << std::endl;
  return number;
}

/// Where it differs from place to place.
void check_noises()
{
  const double noise = 0.005;
  const Points points = steeply_graded_sphere(20000, noise, 27); // with scales
  std::vector<double> of_host(12000, -1), of_device(12000, -1);
  const auto np_for = [](std::vector<double>& noises) {
    return parameters::noise_map(CGAL::make_property_map(noises)).select_percentage(60);
  };
  const Results results = resample(points, np_for(of_host), np_for(of_device));
  CHECK(number_of_others("noises", results, of_host, of_device) <= 12000 / 500);
  CHECK(results.report.least_neighbor_radius < 0.8 * results.report.median_neighbor_radius);
  double sum = 0;
  for (const double of_point : of_device)
    sum += of_point;
  CHECK(std::abs(sum / 12000 - noise) < 0.15 * noise);
}

struct Deviations
{
  std::vector<double> positions, normals;

  explicit Deviations(std::size_t size) : positions(size, -1), normals(size, -1) {}

  auto asked_for()
  {
    return parameters::position_deviation_map(CGAL::make_property_map(positions))
      .normal_deviation_map(CGAL::make_property_map(normals));
  }
};

void check_deviations(const std::string& name, const Points& points, std::size_t size,
                      double maximum_share_of_others)
{
  Deviations of_host(size), of_device(size);
  const Results results = resample(points, of_host.asked_for().number_of_output_points(size),
                                   of_device.asked_for().number_of_output_points(size));
  const double most = maximum_share_of_others * double(size);
  CHECK(double(number_of_others(name + "deviations of positions", results, of_host.positions,
                                of_device.positions))
        <= most);
  CHECK(double(number_of_others(name + "deviations of normals", results, of_host.normals,
                                of_device.normals))
        <= most);

  Result without; // of them nothing changes
  CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(without),
                                              parameters::number_of_output_points(size));
  CHECK(without == results.device);
}

/// Of a crowd in one place, which is thinned: its samples stand in another order, and have the
/// deviations of those that they follow.
void check_deviations_of_followers()
{
  const std::size_t size = 6000;
  Deviations of_host(size), of_device(size);
  resample(with_crowd_in_one_place(noisy_cube(4000, 0.01, 4), 4000, 5),
           of_host.asked_for().number_of_output_points(size),
           of_device.asked_for().number_of_output_points(size));
  const auto check_alike = [](std::vector<double> on_host, std::vector<double> on_device) {
    std::sort(on_host.begin(), on_host.end());
    std::sort(on_device.begin(), on_device.end());
    std::size_t number_of_others = 0;
    for (std::size_t i = 0; i < on_host.size(); ++i)
      number_of_others += !(std::abs(on_device[i] - on_host[i]) < 0.1 * on_host[i]);
    std::cout << "followers: deviations that differ by more than a tenth: " << number_of_others
              << std::endl;
    CHECK(number_of_others <= on_host.size() / 100);
  };
  check_alike(of_host.positions, of_device.positions);
  check_alike(of_host.normals, of_device.normals);
}

void check_refusals()
{
  Deviations deviations(100);
  Result result;
  for (const auto method : {CGAL::L0_resampling::Method::LOR, CGAL::L0_resampling::Method::ALOR})
  {
    const Points points = noisy_cube(2000, 0.01, 2);
    CHECK_THROWS(
      CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result),
                                                  parameters::resampling_method(method).noise_map(
                                                    CGAL::make_property_map(deviations.positions))),
      std::invalid_argument);
    CHECK_THROWS(
      CGAL::l0_resample_point_set<CGAL::CUDA_tag>(points, std::back_inserter(result),
                                                  deviations.asked_for().resampling_method(method)),
      std::invalid_argument);
  }
  CHECK(result.empty());
}

} // namespace

int main()
{
  if (!has_device())
    return number_of_skip;
  check_noises();
  check_deviations("cube: ", noisy_cube(20000, 0.02, 3), 12000, 0.002);
  check_deviations("graded sphere: ", steeply_graded_sphere(20000, 0.005, 27), 12000, 0.002);
  check_deviations_of_followers();
  check_deviations("too few for fits: ", noisy_cube(2000, 0.02, 5), 30, 0);
  check_refusals();
  return test::result();
}
