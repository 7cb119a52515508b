// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters position_deviation_map and normal_deviation_map: by how much points and
// normals of the result are off.

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

struct Deviations_of_result
{
  std::vector<float> positions, normals;
};

template <typename Tag>
Deviations_of_result resample(const Points& points, test::Pairs<Kernel>& result)
{
  Deviations_of_result deviations = {std::vector<float>(points.size()),
                                     std::vector<float>(points.size())};
  result.clear();
  CGAL::l0_resample_point_set<Tag>(
    points, std::back_inserter(result),
    params::position_deviation_map(CGAL::make_property_map(deviations.positions))
      .normal_deviation_map(CGAL::make_property_map(deviations.normals)));
  deviations.positions.resize(result.size());
  deviations.normals.resize(result.size());
  return deviations;
}

/// A cylinder with a lid on either end: its radius is 1, its height 2.
struct Cylinder
{
  static Points points(std::size_t size, double noise, double unit, unsigned seed = 7)
  {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform;
    std::normal_distribution<double> normal(0, noise);
    Points points;
    for (std::size_t i = 0; i < size; ++i)
    {
      const double which = 3 * uniform(generator), angle = 2 * CGAL_PI * uniform(generator);
      const bool is_lid = which < 1; // of the area
      const double radius = is_lid ? std::sqrt(uniform(generator)) : 1,
                   z = is_lid ? (which < 0.5 ? -1 : 1) : 2 * uniform(generator) - 1;
      const Kernel::Vector_3 error{normal(generator), normal(generator), normal(generator)};
      const Kernel::Point_3 place(radius * std::cos(angle), radius * std::sin(angle), z);
      points.push_back(CGAL::ORIGIN + unit * (place + error - CGAL::ORIGIN));
    }
    return points;
  }

  /// The height of a point over the nearer of side and lid, along the normal there, and whether
  /// that is the side. \pre the point is not near the edge
  static double height(const Kernel::Point_3& p, Kernel::Vector_3& normal, bool& is_side)
  {
    const double radius = std::sqrt(p.x() * p.x() + p.y() * p.y()), of_side = radius - 1,
                 of_lid = std::abs(p.z()) - 1;
    is_side = of_side > of_lid;
    normal = is_side ? Kernel::Vector_3(p.x() / radius, p.y() / radius, 0)
                     : Kernel::Vector_3(0, 0, 1);
    return is_side ? of_side : of_lid;
  }
};

struct Sums
{
  double number = 0, positions = 0, normals = 0;
  double position_ratio() const { return std::sqrt(positions / number); }
  double normal_ratio() const { return std::sqrt(normals / number); }
};

void check_ratio(const std::string& name, double ratio, double least, double most)
{
  if (!CHECK(ratio > least && ratio < most))
    std::cerr << "  " << name << ": errors are " << ratio << " of the deviations" << std::endl;
}

struct Sums_of_parts
{
  Sums side, lid, all;
};

void add_errors(Sums_of_parts& sums, double noise, double unit, unsigned seed)
{
  test::Pairs<Kernel> result;
  const Deviations_of_result deviations =
    resample<CGAL::Parallel_if_available_tag>(Cylinder::points(20000, noise, unit, seed), result);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const Kernel::Point_3 p = CGAL::ORIGIN + (result[i].first - CGAL::ORIGIN) / unit;
    Kernel::Vector_3 normal;
    bool is_side = false;
    const double height = Cylinder::height(p, normal, is_side),
                 cosine = std::abs(normal * result[i].second),
                 angle = std::acos((std::min)(cosine, 1.));
    for (Sums* to : {is_side ? &sums.side : &sums.lid, &sums.all})
    {
      to->number += 1;
      to->positions += std::pow(height * unit / double(deviations.positions[i]), 2);
      to->normals += std::pow(angle / double(deviations.normals[i]), 2);
    }
  }
}

/// Errors are what the deviations say. Those of a lid are nearly those of one plane: only several
/// lids tell how large they are.
void test_calibration(double noise, double unit, unsigned seed)
{
  Sums_of_parts sums;
  for (unsigned cloud = 0; cloud < 4; ++cloud)
    add_errors(sums, noise, unit, seed + cloud);
  CHECK(sums.lid.number > 4000 && sums.side.number > 4000);
  check_ratio("positions", sums.all.position_ratio(), 0.5, 1.4);
  check_ratio("normals", sums.all.normal_ratio(), 0.25, 1.4);
  check_ratio("normals of the lids", sums.lid.normal_ratio(), 0.5, 1.25);
  check_ratio("positions of the side", sums.side.position_ratio(), 0.5, 1.4);
  check_ratio("positions of the lids", sums.lid.position_ratio(), 0.35, 1.4);
}

void test_that_it_changes_nothing()
{
  const Points points = Cylinder::points(4000, 0.02, 1);
  test::Pairs<Kernel> without, with, sequential;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(points, std::back_inserter(without));
  const Deviations_of_result deviations = resample<CGAL::Parallel_if_available_tag>(points, with),
                             again = resample<CGAL::Sequential_tag>(points, sequential);
  CHECK(deviations.positions == again.positions && deviations.normals == again.normals);
  CHECK(test::are_identical<Kernel>(with, without));
  CHECK(test::are_identical<Kernel>(with, sequential));
}

/// Too few samples for a fit: no more is known than of a point.
void test_without_refinement()
{
  test::Pairs<Kernel> result;
  const Points points = Cylinder::points(2000, 0.02, 1);
  std::vector<double> deviations(points.size()), of_normals(points.size());
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(
    points, std::back_inserter(result),
    params::position_deviation_map(CGAL::make_property_map(deviations))
      .normal_deviation_map(CGAL::make_property_map(of_normals))
      .number_of_output_points(30));
  for (std::size_t i = 0; i < result.size(); ++i)
    CHECK(deviations[i] > 0.005 && deviations[i] < 0.06 && std::abs(of_normals[i] - 1.068) < 1e-3);
}

} // namespace

int main()
{
  test_calibration(0.015, 1, 7);
  test_calibration(0.03, 1e4, 11);
  test_that_it_changes_nothing();
  test_without_refinement();
  return test::result();
}
