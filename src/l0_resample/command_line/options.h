// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_OPTIONS_H
#define L0_RESAMPLE_OPTIONS_H

#include "../../common/device_choice.h"
#include "files/Output_file.h"
#include "files/file_formats.h"
#include "pictures/Image.h"

#include <CGAL/L0_resampling/tags.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

using l0_common::Device;

enum class Solver
{
  BLOCK_CHEBYSHEV,
  BLOCK_CG,
  CHOLESKY,
  ROWS_CG
};

/// As the function has it.
constexpr std::uint64_t max_number_of_output_points = 4294967294;

/// What is read.
struct Input_options
{
  std::string input;
  File_format input_format = File_format::PLY;
  std::vector<std::string> columns; ///< names of those of a table, empty if nobody names them
  bool has_decimal_commas = false;  ///< of a text
  bool allows_degrees = false;      ///< as coordinates, beside heights that are none
  bool drop_non_finite = false;
  std::vector<unsigned> classes; ///< to keep; empty for all
  bool only_first_returns = false;
  std::string decompression;

  /// What to call the input in messages.
  std::string input_name() const { return input == standard_stream ? "standard input" : input; }
};

/// What is written of the result.
struct Result_options
{
  std::string output;
  File_format output_format = File_format::PLY;
  bool force = false; ///< replace files
  bool with_source_indices = false;
  bool with_feature_confidences = false;
  bool with_side_confidences = false;
  bool with_neighbor_radii = false;
  bool with_noises = false;
  bool with_deviations = false;
  std::string creases;  ///< a file for them; empty for none
  std::string outliers; ///< likewise

  Existing_file existing_file() const
  {
    using File = Existing_file;
    return force ? File::REPLACE : File::KEEP;
  }
};

/// How the points of the result are found.
struct Method_options
{
  std::optional<std::uint64_t> number_of_points; ///< goes before `percentage`
  double percentage = 50;
  CGAL::L0_resampling::Method method = CGAL::L0_resampling::Method::DEFAULT;
  std::optional<double> neighbor_radius;
  std::optional<double> noise;
  std::string noise_property; ///< of the points; empty if one noise is given for all, or none
  std::optional<double> normal_weight; ///< the function's default, if not given
  double sharpness_angle = 15;
  std::uint64_t seed = 0;
  bool keep_density = false;
  bool keep_outliers = false;
  std::optional<double> outlier_sensitivity;
  Solver solver = Solver::BLOCK_CHEBYSHEV;
  std::optional<std::uint64_t> solver_iterations; ///< the most of one solve
};

/// Which normals are started from, and on which side the result has them.
struct Normal_options
{
  bool use_normals = false;
  bool orient_by_normals = false;
  std::optional<std::array<double, 3>> viewpoint;
  bool ignore_viewpoint_of_file = false;
  std::string viewpoints;    ///< a file; empty for none
  std::string view_property; ///< which of these each point was seen from; else the nearest
  std::optional<std::array<double, 3>> up_direction;

  /// Whether they say on which side the normals are.
  bool have_side() const
  {
    return orient_by_normals || viewpoint || ignore_viewpoint_of_file || !viewpoints.empty()
           || up_direction;
  }
};

/// What is told and shown of a run.
struct Report_options
{
  std::string json;                          ///< empty for none
  std::string page;                          ///< empty for none
  std::string snapshot;                      ///< empty for none
  std::optional<std::array<double, 3>> view; ///< from the points towards the eye
  int snapshot_views = 1;
  Snapshot_colors snapshot_colors = Snapshot_colors::SHADED;
  bool quiet = false;
  bool strict = false;
};

/// What a run may take.
struct Machine_options
{
  Device device = Device::AUTO;
  std::optional<int> threads;
  std::uint64_t max_points = (std::numeric_limits<std::uint64_t>::max)();
  std::uint64_t max_memory = (std::numeric_limits<std::uint64_t>::max)(); ///< in bytes
  double timeout = 0; ///< in seconds, 0 for none
};

/// What is done instead of resampling.
struct Task_options
{
  bool convert_only = false;
  bool orient_only = false; ///< keep points and properties, and give normals their side
  bool info = false;        ///< say what the input is, and write nothing
  bool dry_run = false;     ///< read and check, and write nothing
};

struct Setting;

/// What is asked for one input.
struct Options : Input_options,
                 Result_options,
                 Method_options,
                 Normal_options,
                 Report_options,
                 Machine_options,
                 Task_options
{
  std::string refusal;      ///< of a batch: why the input is not opened; empty if it is
  bool is_in_batch = false; ///< whose folders are made, if they are missing
  /// All options as the command line leaves them, for reports and keys: the same of all inputs, of
  /// which there may be thousands.
  std::shared_ptr<const std::vector<Setting>> settings;
};

/// What is asked for if the inputs are parts of one cloud, which is cut into tiles.
struct Tile_options
{
  static constexpr double practical_halo = 40;

  bool is_as_one = false;       ///< whether they are
  std::uint64_t memory = 0;     ///< that the program may take, in bytes
  double halo = practical_halo; ///< of a tile, in radii
  bool resumes = false;         ///< go on where an earlier run has ended
  std::string task;             ///< to do instead of all; empty for all
};

/// The command line, checked.
struct Command
{
  std::vector<Options> runs;    ///< one for each input; all options but the files are the same
  std::string output_directory; ///< empty unless it is a batch, or all are parts of one cloud
  Tile_options tiles;
  std::string merged_output; ///< of tiles: one file of all of them; empty for none

  bool is_batch() const { return !output_directory.empty(); }
};

/// \returns the exit status if the program ends here, as after --help, having said why
std::optional<int> parse_command_line(int argc, char** argv, Command& command);

double normal_weight_of(const Method_options& options);

/// As on the command line.
std::string name_of(CGAL::L0_resampling::Method method);

} // namespace l0_tool

#endif // L0_RESAMPLE_OPTIONS_H
