// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times l0_orient_normals() on a sphere with noise, whose normals have signs by chance. What its
// stages do not take goes by with reading and writing the range and, on a CUDA device, with copies
// to and from it. Prints one line of JSON.

#include "../common/Portable_random.h"
#include "../methods/method_program.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/l0_orient_normals.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>

namespace {

using namespace L0_benchmark;
using CGAL::L0_resampling::Report;
using Point_set = CGAL::Point_set_3<Point>;

/// A noisy unit sphere, in no order
Oriented_points sphere(std::size_t n)
{
  const double noise = 0.5 * std::sqrt(4 * CGAL_PI / double(n)); // half a spacing
  Portable_random random(1);
  Oriented_points points;
  points.reserve(n);
  while (points.size() < n) {
    const Vector v(random.normal(), random.normal(), random.normal());
    const double length = std::sqrt(v.squared_length());
    const double sign = random.uniform() < 0.5 ? -1 : 1;
    if (length > 1e-3)
      points.emplace_back(CGAL::ORIGIN + (1 + noise * random.normal()) / length * v,
                          sign / length * v);
  }
  return points;
}

Point_set point_set(const Oriented_points& points, bool with_normals)
{
  Point_set result(with_normals);
  result.reserve(points.size());
  for (const auto& [point, normal] : points)
    if (with_normals)
      result.insert(point, normal);
    else
      result.insert(point);
  return result;
}

double share_outwards(const Oriented_points& points)
{
  const auto is_outwards = [](const Oriented_point& pair) {
    return pair.second * (pair.first - CGAL::ORIGIN) > 0;
  };
  return double(std::count_if(points.begin(), points.end(), is_outwards)) / double(points.size());
}

double share_outwards(const Point_set& points)
{
  const auto is_outwards = [&](const Point_set::Index& i) {
    return points.normal(i) * (points.point(i) - CGAL::ORIGIN) > 0;
  };
  return double(std::count_if(points.begin(), points.end(), is_outwards)) / double(points.size());
}

template <typename ConcurrencyTag, typename Range, typename NamedParameters>
Json measured_call(Range points, const NamedParameters& np)
{
  Report report;
  Measurement measurement;
  measurement.phase("l0_orient_normals", [&] {
    CGAL::l0_orient_normals<ConcurrencyTag>(points,
                                            np | CGAL::parameters::resampling_report(&report));
  });
  Json result = measurement.result();
  Json stages = Json::array();
  double outside = result["wall_seconds"];
  for (const auto& stage : report.stages) {
    stages.push_back({{"name", stage.name}, {"seconds", stage.seconds}});
    outside -= stage.seconds;
  }
  result.erase("phases");
  result["seconds_outside_stages"] = outside;
  result["stages"] = stages;
  result["own_arrays_bytes"] = report.peak_bytes;
  result["share_outwards"] = share_outwards(points);
  return result;
}

} // namespace

int main(int argc, char** argv)
{
  std::size_t n = 10000000, repetitions = 3;
  unsigned threads = 1;
  bool is_on_device = false, is_point_set = false, estimates_normals = false;
  CLI::App& app = command_line("Times of CGAL::l0_orient_normals(), with reading and writing");
  app.add_option("--points", n)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--threads", threads, "1 runs the sequential code")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--repetitions", repetitions)->check(CLI::PositiveNumber)->capture_default_str();
#ifdef CGAL_L0_LINKED_WITH_CUDA
  app.add_flag("--cuda", is_on_device, "on a CUDA device, with --threads on the host");
#endif
  app.add_flag("--point-set", is_point_set, "a Point_set_3; else a vector of pairs");
  app.add_flag("--estimate", estimates_normals, "no normals are given");

  return run_program(app, argc, argv, [&] {
    Oriented_points pairs = sphere(n);
    if (estimates_normals)
      for (Oriented_point& pair : pairs)
        pair.second = CGAL::NULL_VECTOR;
    const auto measure = [&](auto tag) {
      using Tag = decltype(tag);
      return is_point_set ? measured_call<Tag>(point_set(pairs, !estimates_normals),
                                               CGAL::parameters::default_values())
                          : measured_call<Tag>(pairs, point_and_normal_maps());
    };
    Json calls = Json::array();
    for (std::size_t i = 0; i < repetitions; ++i)
      with_concurrency_tag(threads, [&](auto tag) {
#ifdef CGAL_L0_LINKED_WITH_CUDA
        if (is_on_device)
          return calls.push_back(measure(CGAL::CUDA_tag()));
#endif
        calls.push_back(measure(tag));
      });
    const Json line = {{"points", n},
                       {"range", is_point_set ? "Point_set_3" : "vector"},
                       {"normals", estimates_normals ? "estimated" : "given"},
                       {"device", is_on_device ? "cuda" : "cpu"},
                       {"threads", threads},
                       {"calls", calls}};
    std::cout << line.dump() << std::endl;
  });
}
