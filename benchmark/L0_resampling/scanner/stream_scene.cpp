// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes blocks of a scan of an endless scene, each without the others.

#include "../common/command_line.h"
#include "block_cloud.h"
#include "scene_options.h"

#include <files/file_formats.h>
#include <basis/parse_numbers.h>
#include <formats/write_points.h>

#include <cstdint>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

namespace {

using namespace L0_benchmark;

/// Blocks from the first to the last.
struct Block_range
{
  std::uint64_t first = 0, last = 0;
};

/// \param text such as 7 or 0-63
Block_range parse_blocks(const std::string& text, std::uint64_t number_of_blocks)
{
  const std::size_t dash = text.find('-');
  const std::optional<std::uint64_t> first = l0_tool::parse_number<std::uint64_t>(
    text.substr(0, dash));
  const std::optional<std::uint64_t> last =
    dash == std::string::npos ? first : l0_tool::parse_number<std::uint64_t>(text.substr(dash + 1));
  if (!first || !last || *first > *last || *last >= number_of_blocks)
    throw std::invalid_argument("--block " + text + ": expected I or I-J below "
                                + std::to_string(number_of_blocks));
  return {*first, *last};
}

/// scan_07.las of scan.las, where there are 10 to 100 blocks.
std::string name_of_block(const std::string& output, std::uint64_t block,
                          std::uint64_t number_of_blocks)
{
  const std::string number = std::to_string(block);
  const std::size_t width = std::to_string(number_of_blocks - 1).size();
  const std::size_t dot = output.find_last_of('.');
  return output.substr(0, dot) + "_" + std::string(width - number.size(), '0') + number
         + output.substr(dot);
}

void write_stations(const std::string& path, const Endless_scene& scene)
{
  std::ofstream stream(path);
  stream << std::fixed << std::setprecision(4);
  for (std::uint32_t number = 0; number < scene.number_of_stations(); ++number)
    stream << scene.station(number).position << "\n";
  if (!stream.flush())
    throw std::runtime_error(path + ": cannot be written");
}

} // namespace

int main(int argc, char* argv[])
{
  CLI::App& app = command_line(
    "Scans a scene of 10^6 to 10^12 points, block by block.\n\n"
    "A point is a function of the seed and of its number: any blocks, made in any order and by\n"
    "any number of programs, are together the same scan, point for point. Blocks follow each\n"
    "other in Morton order and meet without a gap. Properties: classification, as in LAS, with 64\n"
    "for thin walls and 65 for poles; view, the number of the scanner. Lengths are meters.");
  Streaming streaming;
  std::uint64_t number_of_blocks = 1;
  std::string output, blocks = "0", stations;
  bool with_truth = false;
  app.add_option("output", output, "LAS or PLY; several blocks get their number before its dot")
    ->required();
  add_scene_options(app, streaming);
  app.add_option("--blocks", number_of_blocks, "how many blocks make up the scan")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  app.add_option("--block", blocks, "which one to write, from 0; or several, as 0-63")
    ->capture_default_str();
  app
    .add_option("--noise", streaming.range_noise,
                "standard deviation along the ray near the scanner; twice that at 50 m")
    ->capture_default_str();
  app.add_option("--outliers", streaming.outlier_share, "share of the points that lie on nothing")
    ->capture_default_str();
  app.add_flag("--truth", with_truth,
               "with the true normals, and true_dx, true_dy, true_dz to what the ray met");
  app.add_option("--stations", stations,
                 "write where the scanners stood, in lines x y z: --viewpoints of l0_resample");
  if (const std::optional<int> status = read_command_line(app, argc, argv))
    return *status;

  try {
    const std::optional<l0_tool::File_format> format = l0_tool::format_of(output);
    if (format != l0_tool::File_format::LAS && format != l0_tool::File_format::PLY)
      throw std::invalid_argument(output + ": expected a name that ends in .las or .ply");
    const Block_range range = parse_blocks(blocks, number_of_blocks);
    const Scene_stream stream(streaming);
    if (!stations.empty())
      write_stations(stations, stream.scene());
    for (std::uint64_t block = range.first; block <= range.last; ++block) {
      const l0_tool::Point_cloud cloud =
        cloud_of_points(stream, stream.first_of_block(block, number_of_blocks),
                        stream.first_of_block(block + 1, number_of_blocks), with_truth);
      const bool is_only_one = range.first == range.last;
      l0_tool::write_point_cloud(
        is_only_one ? output : name_of_block(output, block, number_of_blocks), *format, cloud);
    }
  } catch (const std::exception& error) {
    std::cerr << "stream_scene: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
