// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_RESAMPLE_OPTIONS_H
#define L0_CLOUDCOMPARE_RESAMPLE_OPTIONS_H

#include <CGAL/L0_resampling/tags.h>

#include <array>
#include <cstdint>
#include <optional>

namespace l0_cloudcompare {

/// What decides on which side of the surface the normals of the result are.
enum class Sides
{
  OUTWARDS,  ///< nothing that is given: outwards, in the sense of the divergence theorem
  SENSOR,    ///< the position of the cloud's sensor, or of the scanner of each of its grids
  VIEWPOINT, ///< `Resample_options::viewpoint`
  UP,        ///< `Resample_options::up`
  NORMALS    ///< the normals of the cloud
};

/// What is asked for. Defaults are those of the library.
struct Resample_options
{
  std::optional<std::uint64_t> number_of_points; ///< none: what `percentage` gives
  double percentage = 50;                        ///< of the points of the cloud
  std::optional<double> neighbor_radius; ///< in the unit of the cloud; none: the method's default
  CGAL::L0_resampling::Method method = CGAL::L0_resampling::Method::DEFAULT;
  Sides sides = Sides::OUTWARDS;
  std::array<double, 3> viewpoint = {0, 0, 0}; ///< in coordinates of the file, before any shift
  std::array<double, 3> up = {0, 0, 1};
  bool keep_outliers = false;
  bool keep_density = false;
};

} // namespace l0_cloudcompare

#endif // L0_CLOUDCOMPARE_RESAMPLE_OPTIONS_H
