// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how far points are from the surfaces of an endless scene, and their normals from those.

#include "../common/command_line.h"
#include "scene_options.h"

#include <basis/Failure.h>
#include <formats/read_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace L0_benchmark;

/// What is counted of the points of all files.
class Errors
{
public:
  explicit Errors(const Endless_scene& scene) : m_nearest(scene) {}

  /// \param normal of any length but 0, if there is one
  void add(const Point_3& point, const std::optional<Vector_3>& normal)
  {
    ++m_points;
    const std::optional<Surface_point> truth = m_nearest(point);
    if (!truth)
      return;
    ++m_near;
    const double distance = std::sqrt(CGAL::squared_distance(point, truth->point));
    m_sum += distance;
    m_largest = (std::max)(m_largest, distance);
    ++m_histogram[std::size_t(distance / step)];
    if (!normal || normal->squared_length() == 0)
      return;
    ++m_normals;
    const double cosine = normalized(*normal) * truth->normal;
    m_wrong_sides += cosine < 0;
    m_sum_of_angles += std::acos((std::min)(std::abs(cosine), 1.)) * degrees_per_radian;
  }

  void print(std::ostream& stream) const
  {
    const auto per = [](double sum, std::uint64_t number) {
      return number > 0 ? sum / double(number) : 0;
    };
    stream << std::fixed << std::setprecision(5) << "points           " << m_points
           << "\nfarther than " << std::setprecision(0) << Nearest_in_scene::reach << " m  "
           << std::setprecision(5) << 100 * per(double(m_points - m_near), m_points)
           << " %\nmean distance    " << per(m_sum, m_near) << " m\n95 % are within  "
           << quantile(0.95) << " m\n99 % are within  " << quantile(0.99) << " m\nlargest distance "
           << m_largest << " m\n";
    if (m_normals > 0)
      stream << "mean angle       " << per(m_sum_of_angles, m_normals)
             << " degrees, whatever the side\non wrong sides   "
             << 100 * per(double(m_wrong_sides), m_normals) << " %\n";
  }

private:
  static constexpr double step = 1e-5; ///< of the histogram, in meters
  static constexpr double degrees_per_radian = 57.295779513082321;

  /// Of the distances, rounded up to a step.
  double quantile(double share) const
  {
    std::uint64_t below = 0;
    std::size_t bin = 0;
    while (bin + 1 < m_histogram.size()
           && double(below += m_histogram[bin]) < share * double(m_near))
      ++bin;
    return double(bin + 1) * step;
  }

  Nearest_in_scene m_nearest;
  std::uint64_t m_points = 0, m_near = 0, m_normals = 0, m_wrong_sides = 0;
  double m_sum = 0, m_largest = 0, m_sum_of_angles = 0;
  std::vector<std::uint64_t> m_histogram = std::vector<std::uint64_t>(
    std::size_t(Nearest_in_scene::reach / step) + 2);
};

void add_file(const std::string& path, Errors& errors)
{
  const std::optional<l0_tool::File_format> format = l0_tool::format_of(path);
  if (!format)
    throw l0_tool::Failure(l0_tool::INPUT_REFUSED, path + ": unknown extension");
  l0_tool::Read_options options;
  options.with_normals = true;
  const l0_tool::Point_cloud cloud = l0_tool::read_points(path, *format, options);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    errors.add(cloud.points[i], cloud.normals.empty() ? std::optional<Vector_3>()
                                                      : std::optional<Vector_3>(cloud.normals[i]));
}

} // namespace

int main(int argc, char* argv[])
{
  CLI::App& app = command_line(
    "Measures points on the scene that stream_scene made a scan of with the same options: how far\n"
    "they are from the true surface, and normals from those there.");
  Streaming streaming;
  std::vector<std::string> files;
  app.add_option("files", files, "points, of any format that l0_resample reads; one at a time")
    ->required();
  add_scene_options(app, streaming);
  if (const std::optional<int> status = read_command_line(app, argc, argv))
    return *status;

  try {
    Errors errors(Scene_stream::scene_of(streaming));
    for (const std::string& file : files)
      add_file(file, errors);
    errors.print(std::cout);
  } catch (const std::exception& error) {
    std::cerr << "measure_in_scene: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
