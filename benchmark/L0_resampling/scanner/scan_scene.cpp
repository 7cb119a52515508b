// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Imitates a scanner in a scene that is known exactly: rays from where it stands, and its errors.

#include "../common/command_line.h"
#include "Scan.h"

#include <CGAL/IO/OFF.h>

#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
#include <string>

namespace {

using namespace L0_benchmark;

void write_truth(const std::string& path, const Triangle_mesh& mesh)
{
  if (!CGAL::IO::write_OFF(path, mesh.vertices, mesh.triangles,
                           CGAL::parameters::stream_precision(17)))
    throw std::runtime_error(path + ": cannot be written");
}

void write_viewpoints(const std::string& path, const std::vector<Point_3>& viewpoints)
{
  std::ofstream stream(path);
  for (const Point_3& viewpoint : viewpoints)
    stream << std::fixed << std::setprecision(6) << viewpoint << "\n";
  if (!stream.flush())
    throw std::runtime_error(path + ": cannot be written");
}

} // namespace

int main(int argc, char* argv[])
{
  CLI::App& app = command_line(
    "Scans a scene with known errors.\n\n"
    "Writes OUTPUT.ply, the points as they are reported, each with the number of its view;\n"
    "OUTPUT_exact.ply, in the same order where the middle of each beam met the scene;\n"
    "OUTPUT_truth.off, the scene; OUTPUT_views.txt, a line with the position of each view as "
    "registered, which --viewpoints of l0_resample reads.\n"
    "Lengths of the scenes are meters. The same options give the same bytes.");
  std::string scene_name, output, kind;
  std::size_t columns = 0;
  Scanning scanning;
  app.add_option("scene", scene_name, "street, forest, room, or an OFF file")->required();
  app.add_option("output", output, "start of the names of the files to write")->required();
  app.add_option("--scanner", kind, "spinning, terrestrial, structured-light, range-camera")
    ->required();
  app
    .add_option("--columns", columns, "rays across the field of view; 0: as many as the device has")
    ->capture_default_str();
  app.add_option("--views", scanning.number_of_views, "how many of the scene's stations are used")
    ->capture_default_str();
  app
    .add_option("--registration-error", scanning.registration_error,
                "how far views are from their places, % of the diagonal of the scene")
    ->capture_default_str();
  app
    .add_option("--noise-factor", scanning.noise_factor,
                "of the scanner's noise; 0 leaves steps of disparity alone")
    ->capture_default_str();
  app.add_option("--seed", scanning.seed, "same seed, same points")->capture_default_str();
  if (const std::optional<int> status = read_command_line(app, argc, argv))
    return *status;

  try {
    const Scene scene = make_scene(scene_name);
    const Scanner scanner = make_scanner(kind, columns, diagonal(bounding_box(scene.mesh)));
    const Scan scan = make_scan(scene, scanner, scanning);
    if (scan.points.empty())
      throw std::runtime_error("no ray meets the scene");
    write_scan(output + ".ply", scan, &Scan_point::reported);
    write_scan(output + "_exact.ply", scan, &Scan_point::exact);
    write_truth(output + "_truth.off", scene.mesh);
    write_viewpoints(output + "_views.txt", scan.viewpoints);
  } catch (const std::exception& error) {
    std::cerr << "scan_scene: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
