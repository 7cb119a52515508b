// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that must not compile. refuses_wrong_calls.cmake looks for one error for each of them, with
// the sentence that stands above it, and for no other error.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_orient_normals.h>
#include <CGAL/l0_resample_point_set.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Pair = std::pair<Point, Vector>;
using First = CGAL::First_of_pair_property_map<Pair>;
using Second = CGAL::Second_of_pair_property_map<Pair>;
namespace parameters = CGAL::parameters;

template <typename ConcurrencyTag = CGAL::Sequential_tag, typename Range, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
void resample(const Range& range, OutputIterator out,
              const NamedParameters& np = parameters::default_values())
{
  CGAL::l0_resample_point_set<ConcurrencyTag>(range, out, np);
}

void wrong_ranges_and_kernels()
{
  std::vector<Pair> result;
  // refused: point_map needs values of type Point_3
  resample(std::vector<Pair>(), std::back_inserter(result));
  // refused: point_map needs values of type Point_3
  resample(std::vector<std::array<double, 3>>(), std::back_inserter(result));
  // refused: point_map needs values of type Point_3
  resample(std::vector<Pair>(), std::back_inserter(result), parameters::point_map(Second()));
  // refused: point_map needs values of type Point_3
  resample(std::vector<Pair>(), std::back_inserter(result),
           parameters::point_map([](const Pair& pair) { return pair.first; }));

  // refused: convert the points to a kernel such as Exact_predicates_inexact_constructions_kernel
  resample(std::vector<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>(),
           std::back_inserter(result));
  // refused: convert the points to a kernel such as Exact_predicates_inexact_constructions_kernel
  resample(std::vector<CGAL::Simple_cartesian<int>::Point_3>(), std::back_inserter(result));
  // refused: CUDA_tag needs a compiled library: link with the CMake target CGAL::L0_CUDA_support.
  resample<CGAL::CUDA_tag>(std::vector<Point>(), std::back_inserter(result));
}

void wrong_maps()
{
  const std::vector<Pair> pairs;
  std::vector<Pair> result;
  const auto np = parameters::point_map(First());
  // refused: normal_map needs values of type Vector_3.
  resample(pairs, std::back_inserter(result), np.normal_map(First()));
  // refused: viewpoint_map needs values of type Point_3.
  resample(pairs, std::back_inserter(result), np | parameters::viewpoint_map(Second()));
  // refused: orientation_hint_map needs values of type Vector_3.
  resample(pairs, std::back_inserter(result), np | parameters::orientation_hint_map(First()));
  // refused: point_noise_map needs values of a floating-point type.
  resample(pairs, std::back_inserter(result), np | parameters::point_noise_map(First()));

  std::vector<double> numbers;
  // refused: source_index_map needs values of an integral type.
  resample(pairs, std::back_inserter(result),
           np | parameters::source_index_map(CGAL::make_property_map(numbers)));
  std::vector<int> integers;
  // refused: feature_confidence_map needs values of a floating-point type.
  resample(pairs, std::back_inserter(result),
           np | parameters::feature_confidence_map(CGAL::make_property_map(integers)));
  // refused: side_confidence_map needs values of a floating-point type.
  resample(pairs, std::back_inserter(result),
           np | parameters::side_confidence_map(CGAL::make_property_map(integers)));
  // refused: neighbor_radius_map needs values of a floating-point type.
  resample(pairs, std::back_inserter(result),
           np | parameters::neighbor_radius_map(CGAL::make_property_map(integers)));
  // refused: noise_map needs values of a floating-point type.
  resample(pairs, std::back_inserter(result),
           np | parameters::noise_map(CGAL::make_property_map(integers)));
  // refused: position_deviation_map needs values of a floating-point type.
  resample(pairs, std::back_inserter(result),
           np | parameters::position_deviation_map(CGAL::make_property_map(integers)));
  // refused: normal_deviation_map needs values of a floating-point type.
  resample(pairs, std::back_inserter(result),
           np | parameters::normal_deviation_map(CGAL::make_property_map(integers)));
}

void wrong_callbacks_and_reports()
{
  const std::vector<Point> points;
  std::vector<Pair> result;
  // refused: callback has to be a function that takes the progress, a double, and returns a bool
  resample(points, std::back_inserter(result), parameters::callback([](double) {}));
  // refused: callback has to be a function that takes the progress, a double, and returns a bool
  resample(points, std::back_inserter(result), parameters::callback([] { return true; }));
  // refused: resampling_report has to be the address of a Report.
  resample(points, std::back_inserter(result),
           parameters::resampling_report(CGAL::L0_resampling::Report()));

  CGAL::Point_set_3<Point> point_set, resampled;
  // refused: callback has to be a function that takes the progress, a double, and returns a bool
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(
    point_set, resampled, parameters::callback([](const char*) { return true; }));
}

void wrong_crease_iterators()
{
  const std::vector<Point> points;
  std::vector<Pair> result;
  std::vector<Point> others;
  // refused: crease_output_iterator has to take CGAL::L0_resampling::Crease<Kernel>
  resample(points, std::back_inserter(result),
           parameters::crease_output_iterator(std::back_inserter(others)));
  // refused: outlier_output_iterator has to take std::size_t
  resample(points, std::back_inserter(result),
           parameters::outlier_output_iterator(std::back_inserter(others)));
  // refused: corner_output_iterator has to take CGAL::L0_resampling::Crease_corner<Kernel>
  resample(points, std::back_inserter(result),
           parameters::corner_output_iterator(std::back_inserter(others)));
}

void wrong_output_iterators()
{
  const std::vector<Point> points;
  std::vector<Vector> vectors;
  // refused: The output iterator of l0_resample_point_set() has to take std::pair<Point_3
  resample(points, std::back_inserter(vectors));
  std::vector<CGAL::Simple_cartesian<float>::Point_3> floats;
  // refused: The output iterator of l0_resample_point_set() has to take std::pair<Point_3
  resample(points, std::back_inserter(floats));
  std::vector<Pair> result;
  // refused: The output iterator of l0_resample_point_set() has to take std::pair<Point_3
  resample(points, result);
  // refused: The output iterator of l0_resample_point_set() has to take std::pair<Point_3
  resample(points, points.begin());
  // refused: The output iterator of l0_resample_point_set() has to take std::pair<Point_3
  resample(points, boost::make_function_output_iterator([](const Vector&) {}));
}

void wrong_orientations()
{
  std::vector<Pair> pairs;
  const auto np = parameters::point_map(First());
  // refused: l0_orient_normals() needs a normal_map, which it reads and writes.
  CGAL::l0_orient_normals<CGAL::Sequential_tag>(pairs, np);
  // refused: normal_map needs values of type Vector_3.
  CGAL::l0_orient_normals<CGAL::Sequential_tag>(pairs, np.neighbor_radius(1.).normal_map(First()));
  // refused: CUDA_tag needs a compiled library: link with the CMake target CGAL::L0_CUDA_support.
  CGAL::l0_orient_normals<CGAL::CUDA_tag>(pairs, np.normal_map(Second()));
  // refused: resampling_report has to be the address of a Report.
  CGAL::l0_orient_normals<CGAL::Sequential_tag>(
    pairs, np.normal_map(Second()) | parameters::resampling_report(CGAL::L0_resampling::Report()));
}

} // namespace

int main()
{
  wrong_orientations();
  wrong_ranges_and_kernels();
  wrong_maps();
  wrong_callbacks_and_reports();
  wrong_output_iterators();
}
