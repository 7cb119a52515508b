// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_RESAMPLE_H
#define CGAL_L0_PYTHON_RESAMPLE_H

#include "../common/device_choice.h"
#include "Array_view.h"

#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/tags.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace l0_python {

using l0_common::Device;

/// The named parameters of `CGAL::l0_resample_point_set()`, by their names. What is not there keeps
/// the function's default. Counts have a sign, so that it is the function that refuses the negative
/// ones.
struct Parameters
{
  using Number = std::optional<double>;
  using Count = std::optional<std::int64_t>;
  using Size = std::optional<std::uint64_t>;
  using Flag = std::optional<bool>;
  using Place = std::optional<std::array<double, 3>>;

  CGAL::L0_resampling::Method resampling_method = CGAL::L0_resampling::Method::DEFAULT;
#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED) Kind X;
#define CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED) Kind X;
#include <CGAL/L0_resampling/value_parameters.h>

  // whether the named parameters source_index_map, feature_confidence_map, side_confidence_map,
  // neighbor_radius_map, noise_map, position_deviation_map and normal_deviation_map are wanted, and
  // the output iterators of creases, corners and outliers
  bool source_indices = false;
  bool feature_confidences = false;
  bool side_confidences = false;
  bool neighbor_radii = false;
  bool noises = false;
  bool position_deviations = false;
  bool normal_deviations = false;
  bool creases = false;
  bool outliers = false;

  // of this call, not of the function
  Count threads; ///< all, if not given
  Device device = Device::CPU;
};

/// What the caller has of each point beside its coordinates: arrays of the same size, or null.
/// \tparam View of an array
template <typename View>
struct Vectors_of_points
{
  const View* normals;
  const View* orientation_hints;
  const View* viewpoints;
  const View* noises = nullptr; ///< of one column
};

/// Does the work with as many threads as the parameters allow.
/// \throws std::invalid_argument for a number of threads that is out of its range
void in_arena(const Parameters& parameters, const std::function<void()>& work);

/// Positions and normals, xyz interleaved, and what is wanted beside them, one number a point.
template <typename FT>
struct Result
{
  std::vector<FT> positions, normals;
  std::vector<std::int64_t> source_indices, outliers;
  std::vector<FT> feature_confidences, side_confidences, neighbor_radii, noises,
    position_deviations, normal_deviations;
  std::vector<CGAL::L0_resampling::Crease<CGAL::Simple_cartesian<FT>>> creases;
  std::vector<CGAL::L0_resampling::Crease_corner<CGAL::Simple_cartesian<FT>>> corners;
  CGAL::L0_resampling::Report report;
};

/*!
Calls `CGAL::l0_resample_point_set()`.

\tparam FT `float` or `double`, the number type of the result
\throws what the function throws
*/
template <typename FT>
Result<FT> resample(const Array_view& points, const Vectors_of_points<Array_view>& vectors,
                    const Parameters& parameters, const std::function<bool(double)>& callback);

} // namespace l0_python

#endif // CGAL_L0_PYTHON_RESAMPLE_H
