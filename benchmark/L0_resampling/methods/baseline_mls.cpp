// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// PCL's moving least squares: every point is projected to a polynomial through those around it,
// which has the normal too. The normals are oriented over a spanning tree, and a random subset is
// kept.

#include "baseline_steps.h"
#include "subsampling.h"

#include <CGAL/compute_average_spacing.h>

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>

#include <cmath>
#include <memory>

namespace {

using namespace L0_benchmark;

Oriented_points moving_least_squares(const std::vector<Point>& points, double radius,
                                     unsigned number_of_threads)
{
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Point& p : points)
    cloud->push_back({float(p.x()), float(p.y()), float(p.z())});
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointNormal> mls;
  mls.setInputCloud(cloud);
  mls.setSearchMethod(std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  mls.setSearchRadius(radius);
  mls.setPolynomialOrder(2);
  mls.setComputeNormals(true);
  mls.setNumberOfThreads(number_of_threads);
  pcl::PointCloud<pcl::PointNormal> projected;
  mls.process(projected);

  Oriented_points result;
  for (const pcl::PointNormal& p : projected)
    result.emplace_back(Point(p.x, p.y, p.z), Vector(p.normal_x, p.normal_y, p.normal_z));
  return result;
}

void make_normals_unit(Oriented_points& points)
{
  for (Oriented_point& point : points)
    point.second /= std::sqrt(point.second.squared_length());
}

} // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  double radius_in_spacings = 8;
  CLI::App& app = command_line("PCL's MovingLeastSquares, polynomials of order 2");
  arguments.add_to(app);
  app.add_option("--radius-in-spacings", radius_in_spacings)->check(CLI::PositiveNumber);

  return run_program(app, argc, argv, [&] {
    const std::vector<Point> points = read_positions(arguments.input);
    Oriented_points result;
    Measurement measurement;
    measurement.phase("mls", [&] {
      const double spacing =
        CGAL::compute_average_spacing<CGAL::Sequential_tag>(points, number_of_spacing_neighbors);
      result = moving_least_squares(points, radius_in_spacings * spacing,
                                    arguments.number_of_threads);
    });
    keep_random_subset(result, arguments.number_of_output_points, 1);
    make_normals_unit(result);
    measurement.phase("orient normals", [&] { orient_normals(result); });
    const Json measured = measurement.result();

    write_oriented_points(arguments.output, result);
    print_result("baseline_mls", arguments, points.size(), result.size(),
                 {{"radius_in_spacings", radius_in_spacings}}, measured);
  });
}
