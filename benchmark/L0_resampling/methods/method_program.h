// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_METHOD_PROGRAM_H
#define CGAL_L0_RESAMPLING_BENCHMARK_METHOD_PROGRAM_H

#include "../common/command_line.h"

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace L0_benchmark {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Oriented_point = std::pair<Point, Vector>;
using Oriented_points = std::vector<Oriented_point>;
using Json = nlohmann::ordered_json;

inline auto point_and_normal_maps()
{
  return CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented_point>())
    .normal_map(CGAL::Second_of_pair_property_map<Oriented_point>());
}

/// The command line that all programs share.
struct Arguments
{
  std::string input;
  std::string output;
  std::size_t number_of_output_points = 0;
  unsigned number_of_threads = 1;

  void add_to(CLI::App& app);
};

/// \throws std::runtime_error if `path` has no readable points
std::vector<Point> read_positions(const std::string& path);

/// \throws std::runtime_error if `path` could not be written
void write_oriented_points(const std::string& path, const Oriented_points& points);

/*!
Wall-clock time and CPU time of all threads for each phase of a program, and how far the resident
memory rises above what it was when the measurement began. So input and output must be resident
before: the peak then counts neither.
*/
class Measurement
{
public:
  Measurement();
  void phase(const std::string& name, const std::function<void()>& function);
  Json result() const;

private:
  std::size_t m_resident_before;
  Json m_phases = Json::array();
};

/// Calls `function` with the concurrency tag for `number_of_threads`, and with no more threads than
/// that.
template <typename Function>
void with_concurrency_tag(unsigned number_of_threads, const Function& function)
{
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, number_of_threads);
  if (number_of_threads == 1)
    function(CGAL::Sequential_tag());
  else
    function(CGAL::Parallel_tag());
}

/// Prints one line of JSON: what was run, on what, and its measurement.
void print_result(const std::string& program, const Arguments& arguments,
                  std::size_t number_of_input_points, std::size_t number_of_output_points,
                  const Json& parameters, const Json& measured);

/// Reads the command line, runs `body` and turns what it throws into one line on stderr.
/// \returns the exit status of the program
int run_program(CLI::App& app, int argc, char** argv, const std::function<void()>& body);

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_METHOD_PROGRAM_H
