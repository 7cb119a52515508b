// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_BENCHMARK_SCENE_OPTIONS_H
#define CGAL_L0_RESAMPLING_BENCHMARK_SCENE_OPTIONS_H

#include "Scene_stream.h"

#include <CLI/CLI.hpp>

namespace L0_benchmark {

/// The options that decide what an endless scene is.
inline void add_scene_options(CLI::App& app, Streaming& streaming)
{
  app.add_option("--points", streaming.number_of_points, "of all blocks of the scan")
    ->capture_default_str();
  app.add_option("--density", streaming.density, "points per square meter, on average")
    ->capture_default_str();
  app.add_option("--seed", streaming.seed, "same seed, same points")->capture_default_str();
}

} // namespace L0_benchmark

#endif // CGAL_L0_RESAMPLING_BENCHMARK_SCENE_OPTIONS_H
