// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The recipes of the manual; run it in a folder with the scans.

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Oriented_points = std::vector<std::pair<Point_3, Kernel::Vector_3>>;
using Concurrency_tag = CGAL::Parallel_if_available_tag;
using Report = CGAL::L0_resampling::Report;
namespace parameters = CGAL::parameters;

std::vector<Point_3> read(const std::string& file)
{
  std::vector<Point_3> points;
  if (!CGAL::IO::read_points(file, std::back_inserter(points)))
    throw std::runtime_error(file + " cannot be read");
  return points;
}

// Says what happened, with the warnings of a result that cannot be good
void print(const Report& report)
{
  std::cout << report.number_of_output_points << " points, " << report.number_of_outliers
            << " outliers, turned to a viewpoint: " << 100 * report.hinted_share << " %\n";
  for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(report))
    std::cout << "warning: " << CGAL::L0_resampling::message_of(warning, report) << '\n';
}

Report range_scan()
{
  //! [range]
  const std::vector<Point_3> scan = read("range.ply");
  Oriented_points clean;
  Report report;
  CGAL::l0_resample_point_set<Concurrency_tag>(
    scan, std::back_inserter(clean),
    parameters::viewpoint(Point_3(4.6, 2.2, -3.3)).resampling_report(&report));
  //! [range]
  return report;
}

Report photogrammetry()
{
  //! [photos]
  const std::vector<Point_3> photos = read("photos.ply");
  Oriented_points clean;
  Report report;
  CGAL::l0_resample_point_set<Concurrency_tag>(
    photos, std::back_inserter(clean),
    parameters::resampling_report(&report).number_of_output_points(8000));
  //! [photos]
  return report;
}

Report lidar()
{
  //! [lidar]
  using Point_and_station = std::pair<Point_3, int>;
  std::vector<Point_and_station> survey;
  std::ifstream file("survey.ply", std::ios::binary);
  CGAL::IO::read_PLY_with_properties(
    file, std::back_inserter(survey),
    CGAL::make_ply_point_reader(CGAL::First_of_pair_property_map<Point_and_station>()),
    std::make_pair(CGAL::Second_of_pair_property_map<Point_and_station>(),
                   CGAL::PLY_property<int>("view")));

  std::vector<Point_3> stations;
  std::ifstream list("stations.txt");
  for (Point_3 station; list >> station;)
    stations.push_back(station);

  std::vector<Point_3> points, seen_from;
  std::vector<std::size_t> indices;
  for (const auto& [point, station] : survey)
  {
    indices.push_back(points.size());
    points.push_back(point);
    seen_from.push_back(stations.at(std::size_t(station)));
  }
  Oriented_points clean;
  Report report;
  CGAL::l0_resample_point_set<Concurrency_tag>(indices, std::back_inserter(clean),
                                               parameters::viewpoint_map(
                                                 CGAL::make_property_map(seen_from))
                                                 .resampling_report(&report)
                                                 .point_map(CGAL::make_property_map(points)));
  //! [lidar]
  return report;
}

Report machined_part()
{
  //! [part]
  const std::vector<Point_3> part = read("part.ply");
  Oriented_points clean;
  std::vector<double> confidences(10000);
  Report report;
  CGAL::l0_resample_point_set<Concurrency_tag>(part, std::back_inserter(clean),
                                               parameters::feature_confidence_map(
                                                 CGAL::make_property_map(confidences))
                                                 .resampling_report(&report)
                                                 .number_of_output_points(confidences.size()));
  const auto on_edges = std::count_if(confidences.begin(), confidences.end(),
                                      [](double confidence) { return confidence > 0.8; });
  std::cout << on_edges << " points lie on edges\n";
  //! [part]
  return report;
}

Report before_poisson()
{
  //! [poisson]
  const std::vector<Point_3> body = read("body.ply");
  Oriented_points clean;
  Report report;
  CGAL::l0_resample_point_set<Concurrency_tag>(
    body, std::back_inserter(clean), parameters::resampling_report(&report).select_percentage(100));
  std::cout << "one orientation: " << 100 * report.oriented_share << " %\n";
  //! [poisson]
  return report;
}

//! [registration]
// A call for one point estimates the spacing of all
double spacing_of(const std::vector<Point_3>& points)
{
  Oriented_points one;
  Report report;
  CGAL::l0_resample_point_set<Concurrency_tag>(
    points, std::back_inserter(one),
    parameters::resampling_report(&report).number_of_output_points(1));
  return report.estimated_spacing;
}

std::array<Oriented_points, 2> with_equal_spacing(const std::vector<Point_3>& first,
                                                  const std::vector<Point_3>& second)
{
  const std::array<const std::vector<Point_3>*, 2> scans = {&first, &second};
  const double spacing = (std::max)(spacing_of(first), spacing_of(second));
  std::array<Oriented_points, 2> even;
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double ratio = spacing_of(*scans[i]) / spacing;
    CGAL::l0_resample_point_set<Concurrency_tag>(
      *scans[i], std::back_inserter(even[i]), parameters::select_percentage(100 * ratio * ratio));
  }
  return even;
}
//! [registration]

int main()
try
{
  for (const auto& recipe : {range_scan, photogrammetry, lidar, machined_part, before_poisson})
  {
    const Report report = recipe();
    print(report);
    for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(report))
      if (warning != CGAL::L0_resampling::Warning::MANY_OUTLIERS) // which photographs have
        return EXIT_FAILURE;
  }
  const auto [first, second] = with_equal_spacing(read("first.ply"), read("second.ply"));
  std::cout << first.size() << " and " << second.size() << " points of one spacing\n";
  return first.size() < 1.15 * second.size() ? EXIT_SUCCESS : EXIT_FAILURE;
}
catch (const std::exception& error)
{
  std::cerr << error.what() << '\n';
  return EXIT_FAILURE;
}
