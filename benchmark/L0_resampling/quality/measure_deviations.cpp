// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far the deviations of a result can be trusted: of the points of meshes with noise, the root
// mean square of the true errors over the deviations, which is 1 where these are right, and the
// share of errors that are more than twice as large. Prints a JSON object for each noise, of flat,
// curved and sharp places.

#include "../common/sample_mesh.h"
#include "../methods/method_program.h"
#include "metrics.h"

#include <CGAL/l0_resample_point_set.h>

#include <array>
#include <cmath>
#include <iostream>
#include <iterator>
#include <map>

namespace {

using namespace L0_benchmark;

/// How near an edge makes a place sharp, and within what distance normals make it flat or curved:
/// per diagonal, as `Feature_statistics` has it.
constexpr double reach_of_place = 0.015;

/// Normals of a flat place differ by no more, in degrees.
constexpr double maximum_angle_of_flat = 2;

const std::array<const char*, 3> places = {"flat", "curved", "sharp"};

/// The places of a mesh.
class Places
{
public:
  explicit Places(const Ground_truth& truth)
    : m_truth(truth), m_triangles(proper_triangles(truth.mesh()))
  {
    m_tree.insert(m_triangles.cbegin(), m_triangles.cend());
  }

  /// \returns the number of a place in `places`
  std::size_t place_of(const Point_3& p) const
  {
    const double reach = reach_of_place * m_truth.diagonal();
    if (!m_truth.feature_edges().empty() && m_truth.distance_to_features(p) < reach)
      return 2;
    const Point_3 foot = m_truth.nearest_point(p);
    const Vector_3 diagonal(reach, reach, reach), normal = m_truth.nearest_normals(p).front();
    std::vector<Triangle_iterator> around;
    m_tree.all_intersected_primitives(Kernel::Iso_cuboid_3(foot - diagonal, foot + diagonal),
                                      std::back_inserter(around));
    for (const Triangle_iterator triangle : around) {
      const double angle = angle_in_degrees(normal, area_normal(*triangle));
      if (angle > maximum_angle_of_flat && angle < 90) // not of the other side of a plate
        return 1;
    }
    return 0;
  }

private:
  const Ground_truth& m_truth;
  std::vector<Triangle_3> m_triangles;
  Triangle_tree m_tree;
};

/// Of errors over their deviations.
struct Ratios
{
  double squares = 0, number_above_two = 0;

  void add(double ratio)
  {
    squares += ratio * ratio;
    number_above_two += ratio > 2;
  }
};

struct Calibration
{
  double number = 0;
  Ratios positions, normals;

  Json ratios() const
  {
    const auto root_mean_square = [&](const Ratios& r) { return std::sqrt(r.squares / number); };
    const auto percent_above_two = [&](const Ratios& r) {
      return 100 * r.number_above_two / number;
    };
    return number > 0 ? Json{{"number", number},
                             {"position", root_mean_square(positions)},
                             {"normal", root_mean_square(normals)},
                             {"percent_of_positions_above_two", percent_above_two(positions)},
                             {"percent_of_normals_above_two", percent_above_two(normals)}}
                      : Json();
  }
};

void measure(const Ground_truth& truth, const Places& all_places, const Sampling& sampling,
             std::array<Calibration, 3>& sums)
{
  const std::vector<Point_3> points = sample_mesh(truth.mesh(), sampling);
  std::vector<double> of_positions(points.size()), of_normals(points.size());
  std::vector<std::pair<Point_3, Vector_3>> result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result),
    CGAL::parameters::position_deviation_map(CGAL::make_property_map(of_positions))
      .normal_deviation_map(CGAL::make_property_map(of_normals)));
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& [p, normal] = result[i];
    const double height = (p - truth.nearest_point(p)) * normal
                          / std::sqrt(normal.squared_length()),
                 angle = normal_deviation(p, normal, truth).angle / degrees_per_radian;
    Calibration& calibration = sums[all_places.place_of(p)];
    calibration.number += 1;
    calibration.positions.add(std::abs(height) / of_positions[i]);
    calibration.normals.add(angle / of_normals[i]);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<std::string> meshes;
  std::vector<double> noises = {0.1, 0.3, 0.5, 0.7, 1.2, 2};
  Sampling sampling;
  sampling.number_of_points = 40000;
  CLI::App& app = command_line("How far the deviations of a result can be trusted");
  app.add_option("meshes", meshes)->required()->check(CLI::ExistingFile);
  app.add_option("--noise", noises, "% of the diagonal of a mesh")->capture_default_str();
  app.add_option("--points", sampling.number_of_points, "of a cloud")->capture_default_str();

  return run_program(app, argc, argv, [&] {
    std::vector<std::array<Calibration, 3>> sums(noises.size());
    for (const std::string& mesh : meshes) {
      const Ground_truth truth(read_triangle_mesh(mesh));
      const Places all_places(truth);
      for (std::size_t k = 0; k < noises.size(); ++k) {
        sampling.noise = noises[k];
        measure(truth, all_places, sampling, sums[k]);
      }
    }
    for (std::size_t k = 0; k < noises.size(); ++k) {
      Json line = {{"noise", noises[k]}};
      for (std::size_t place = 0; place < places.size(); ++place)
        line[places[place]] = sums[k][place].ratios();
      std::cout << line.dump() << std::endl;
    }
  });
}
