// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How often the callback is called, and how soon a call ends once it has said no. Prints one line
// of JSON.

#include "../common/Portable_random.h"
#include "../methods/method_program.h"

#include <CGAL/l0_resample_point_set.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>

namespace {

using namespace L0_benchmark;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;

const std::map<std::string, Method> methods = {
  {"default", Method::DEFAULT}, {"lor", Method::LOR}, {"alor", Method::ALOR}};

/// A noisy unit sphere
std::vector<Point> sphere(std::size_t n, double noise)
{
  Portable_random random(1);
  std::vector<Point> points;
  points.reserve(n);
  while (points.size() < n) {
    const Vector v(random.normal(), random.normal(), random.normal());
    const double length = std::sqrt(v.squared_length());
    if (length > 1e-3)
      points.push_back(CGAL::ORIGIN + (1 + noise * random.normal()) / length * v);
  }
  return points;
}

/// Evenly random in the cube [-1, 1]^3: surfaces are nowhere, and balls have the most neighbors.
std::vector<Point> volume(std::size_t n)
{
  Portable_random random(2);
  std::vector<Point> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    points.emplace_back(2 * x - 1, 2 * y - 1, 2 * z - 1);
  }
  return points;
}

/// Half of the points within 1e-9 of one point of the sphere: all in one cell of any grid.
std::vector<Point> crowd(std::size_t n, double noise)
{
  Portable_random random(3);
  std::vector<Point> points = sphere(n, noise);
  for (std::size_t i = 1; i < n; i += 2) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    points[i] = points[0] + 1e-9 * Vector(x, y, z);
  }
  return points;
}

std::vector<Point> input_points(const std::string& input, std::size_t n, double noise)
{
  return input == "volume" ? volume(n) : input == "crowd" ? crowd(n, noise) : sphere(n, noise);
}

/// Wall-clock time, and the time that all threads of the process have had: of the two, a busy
/// machine lengthens the first.
struct Instant
{
  std::chrono::steady_clock::time_point wall = std::chrono::steady_clock::now();
  std::clock_t cpu = std::clock();
};

struct Duration
{
  double wall_seconds, cpu_seconds;
  Duration(const Instant& begin, const Instant& end)
    : wall_seconds(std::chrono::duration<double>(end.wall - begin.wall).count()),
      cpu_seconds(double(end.cpu - begin.cpu) / CLOCKS_PER_SEC)
  {}
};

Json to_json(const Duration& duration)
{
  return {{"wall_seconds", duration.wall_seconds}, {"cpu_seconds", duration.cpu_seconds}};
}

struct Gap
{
  Duration duration;
  std::string from, to; // stages
};

struct Observation
{
  Instant last;
  std::string stage = "begin";
  double progress = 0;
  bool is_monotonic = true;
  std::vector<Gap> gaps;

  void note(const std::string& next_stage)
  {
    const Instant now;
    gaps.push_back({Duration(last, now), stage, next_stage});
    last = now;
    stage = next_stage;
  }
};

/// \param refusal the progress from which on the callback says no; above 1 for never
Observation observe(const std::vector<Point>& points, Method method, double radius,
                    unsigned threads, double refusal, Report& report)
{
  const std::size_t m = points.size() * 6 / 10;
  Oriented_points result(m); // resident, so that the first write to each page does not count
  result.clear();
  Observation observation;
  const std::function<bool(double)> callback = [&](double progress) {
    observation.is_monotonic = observation.is_monotonic && progress >= observation.progress
                               && progress <= 1;
    observation.progress = progress;
    observation.note(report.stages.empty() ? "read points" : report.stages.back().name);
    return progress < refusal;
  };
  const auto parameters = CGAL::parameters::resampling_method(method)
                            .number_of_output_points(m)
                            .callback(callback)
                            .resampling_report(&report);
  with_concurrency_tag(threads, [&](auto tag) {
    const auto resample = [&](const auto& np) {
      observation.last = Instant();
      CGAL::l0_resample_point_set<decltype(tag)>(points, std::back_inserter(result), np);
      observation.note("end");
    };
    if (radius > 0)
      resample(parameters.neighbor_radius(radius));
    else
      resample(parameters);
  });
  return observation;
}

} // namespace

int main(int argc, char** argv)
{
  std::size_t n = 20000, number_of_cancellations = 3;
  std::string method = "default", input = "sphere";
  unsigned threads = 1;
  double noise_in_spacings = 0.5, radius_in_spacings = 0;
  CLI::App& app = command_line(
    "How often CGAL::l0_resample_point_set() calls back, and how fast it is cancelled");
  app.add_option("--input", input, "sphere, with noise; volume; or crowd, half of it in one place")
    ->check(CLI::IsMember({"sphere", "volume", "crowd"}));
  app.add_option("--points", n)->check(CLI::PositiveNumber);
  app.add_option("--method", method)->check(CLI::IsMember(methods));
  app.add_option("--threads", threads, "1 runs the sequential code")->check(CLI::PositiveNumber);
  app.add_option("--noise-in-spacings", noise_in_spacings)->check(CLI::NonNegativeNumber);
  app.add_option("--radius-in-spacings", radius_in_spacings, "0 for the method's own")
    ->check(CLI::NonNegativeNumber);
  app.add_option("--cancellations", number_of_cancellations,
                 "calls that are cancelled at evenly spread values of progress");

  return run_program(app, argc, argv, [&] {
    const double spacing = std::sqrt(4 * CGAL_PI / double(n));
    const std::vector<Point> points = input_points(input, n, noise_in_spacings * spacing);
    const double radius = radius_in_spacings * spacing;

    Report report;
    const Observation complete = observe(points, methods.at(method), radius, threads, 2, report);
    const auto longest_by = [&](double Duration::*seconds) {
      const Gap& gap = *std::max_element(complete.gaps.begin(), complete.gaps.end(),
                                         [&](const Gap& a, const Gap& b) {
                                           return a.duration.*seconds < b.duration.*seconds;
                                         });
      Json json = to_json(gap.duration);
      json["from"] = gap.from;
      json["to"] = gap.to;
      return json;
    };

    bool is_monotonic = complete.is_monotonic;
    Json cancellations = Json::array();
    for (std::size_t k = 1; k <= number_of_cancellations; ++k) {
      Report report_of_cancelled;
      const double refusal = double(k) / double(number_of_cancellations + 1);
      const Observation cancelled = observe(points, methods.at(method), radius, threads, refusal,
                                            report_of_cancelled);
      is_monotonic = is_monotonic && cancelled.is_monotonic;
      Json cancellation = to_json(cancelled.gaps.back().duration);
      cancellation["progress"] = cancelled.progress;
      cancellation["stage"] = cancelled.gaps.back().from;
      cancellations.push_back(cancellation);
    }
    const Json line = {{"input", input},
                       {"method", method},
                       {"points_in", n},
                       {"threads", threads},
                       {"is_monotonic", is_monotonic},
                       {"longest_gaps",
                        {longest_by(&Duration::wall_seconds), longest_by(&Duration::cpu_seconds)}},
                       {"cancellations", cancellations}};
    std::cout << line.dump() << std::endl;
  });
}
