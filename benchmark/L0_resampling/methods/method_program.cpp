// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "method_program.h"

#include <CGAL/IO/read_ply_points.h>
#include <CGAL/IO/write_ply_points.h>
#include <CGAL/Real_timer.h>
#include <CGAL/version.h>

#include <malloc.h>

#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace L0_benchmark {
namespace {

/// `field` is "VmRSS", what is resident now, or "VmHWM", the most that ever was.
std::size_t resident_bytes(const std::string& field)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, field.size() + 1, field + ":") == 0)
      return std::stoull(line.substr(field.size() + 1)) * 1024;
  throw std::runtime_error("/proc/self/status has no " + field);
}

} // namespace

void Arguments::add_to(CLI::App& app)
{
  app.add_option("input", input, "PLY file; only the positions are used")
    ->required()
    ->check(CLI::ExistingFile);
  app.add_option("output", output, "binary PLY file of points with normals")->required();
  app.add_option("--points", number_of_output_points, "number of output points")
    ->required()
    ->check(CLI::PositiveNumber);
  app.add_option("--threads", number_of_threads, "1 runs the sequential code")
    ->check(CLI::PositiveNumber);
}

std::vector<Point> read_positions(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::vector<Point> points;
  if (!CGAL::IO::read_PLY(stream, std::back_inserter(points)) || points.empty())
    throw std::runtime_error(path + ": no points could be read");
  points.shrink_to_fit();
  return points;
}

void write_oriented_points(const std::string& path, const Oriented_points& points)
{
  if (!CGAL::IO::write_PLY(path, points, point_and_normal_maps()))
    throw std::runtime_error(path + ": cannot be written");
}

Measurement::Measurement()
{
  malloc_trim(0); // else what reading the file freed would serve the call unseen
  std::ofstream clear_refs("/proc/self/clear_refs");
  if (!(clear_refs << 5 << std::flush)) // sets VmHWM back to VmRSS, proc(5)
    throw std::runtime_error("/proc/self/clear_refs: the peak of memory cannot be reset");
  m_resident_before = resident_bytes("VmRSS");
}

void Measurement::phase(const std::string& name, const std::function<void()>& function)
{
  CGAL::Real_timer wall;
  const std::clock_t cpu = std::clock();
  wall.start();
  function();
  wall.stop();
  m_phases.push_back({{"name", name},
                      {"wall_seconds", wall.time()},
                      {"cpu_seconds", double(std::clock() - cpu) / CLOCKS_PER_SEC}});
}

Json Measurement::result() const
{
  double wall_seconds = 0, cpu_seconds = 0;
  for (const Json& phase : m_phases) {
    wall_seconds += phase["wall_seconds"].get<double>();
    cpu_seconds += phase["cpu_seconds"].get<double>();
  }
  const std::size_t peak = resident_bytes("VmHWM");
  return {{"wall_seconds", wall_seconds},
          {"cpu_seconds", cpu_seconds},
          {"resident_growth_bytes", peak > m_resident_before ? peak - m_resident_before : 0},
          {"phases", m_phases}};
}

void print_result(const std::string& program, const Arguments& arguments,
                  std::size_t number_of_input_points, std::size_t number_of_output_points,
                  const Json& parameters, const Json& measured)
{
  Json line = {{"program", program},
               {"cgal_version", CGAL_VERSION_STR},
               {"input", std::filesystem::path(arguments.input).filename().string()},
               {"number_of_input_points", number_of_input_points},
               {"number_of_output_points", number_of_output_points},
               {"threads", arguments.number_of_threads},
               {"parameters", parameters}};
  line.update(measured);
  std::cout << line.dump() << std::endl;
}

int run_program(CLI::App& app, int argc, char** argv, const std::function<void()>& body)
{
  if (const std::optional<int> status = read_command_line(app, argc, argv))
    return *status;
  try {
    body();
    return 0;
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << std::endl;
    return 1;
  }
}

} // namespace L0_benchmark
