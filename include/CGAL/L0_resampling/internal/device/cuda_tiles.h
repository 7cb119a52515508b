// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CUDA_TILES_H
#define CGAL_L0_RESAMPLING_INTERNAL_CUDA_TILES_H

#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>
#include <CGAL/L0_resampling/internal/device/cuda_interface.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The part of `cuda_interface.h` for tiles of a cloud that is larger than a device.
namespace cuda {

/// The memory of the current device that nobody has taken, in bytes.
Answer free_memory(std::size_t& bytes);

/// `Facts_of_cloud`, as far as a tile needs them.
struct Facts_of_tiles
{
  int exponent_of_frame;
  double origin_of_frame[3];
  Facts extents; ///< with the scales
  Range_of_scales range_of_scales;
  double area;
  std::size_t number_of_points;    ///< of the cloud, without outliers, and thinned
  std::size_t number_of_places;    ///< where these are
  double mean_number_of_neighbors; ///< in the balls of the normal filter; 0 if it is not known
};

/// Finds the facts of a whole cloud, as a call that resamples it does, and as `Fact_finder` on the
/// CPU.
/// \param points xyz interleaved, finite
/// \param size from 1 to 2^32 - 2
/// \param parameters checked; `maximum_memory` is of the device
/// \param points_in_cloud out: what is found of each point, but for what a tile decides
Answer find_facts(Session& session, const double* points, std::size_t size,
                  const Parameters& parameters, Progress_callback progress, Call_report& report,
                  Facts_of_tiles& facts, Point_in_cloud* points_in_cloud);

/// What a tile is, beside its points.
struct Tile_of_cloud
{
  const Point_in_cloud* points;  ///< one for each point, in their order
  std::size_t number_of_samples; ///< that start in the tile or its halo, at least 1
  bool finds_sides;              ///< if not, what they follow from is kept
  Facts_of_tiles facts;
};

/// Brings points to the device and resamples them, as `resample()` and `Tile_backend` on the CPU.
/// The result stays on the device until the next call.
/// \param points xyz interleaved, finite
/// \param size from 1 to 2^32 - 2
/// \param parameters checked, of the cloud; `maximum_memory` is of the device
/// \param number_of_unoriented out: of the samples that `download_unoriented()` brings
Answer resample_tile(Session& session, const double* points, std::size_t size,
                     const Tile_of_cloud& tile, const Parameters& parameters,
                     Progress_callback progress, Call_report& report,
                     std::size_t& number_of_unoriented);

/// Brings to the host what a tile has beside the result that `download()` brings.
/// \param trees out: samples of one have sides relative to each other
/// \param are_own out: whether the tile keeps each of the samples
Answer download_tile(Session& session, float* side_confidences, std::uint32_t* trees,
                     unsigned char* are_own);

/// Brings the samples to the host that are to be oriented, if the tile has found no sides: each is
/// the tree of its place.
/// \param positions, normals out: xyz interleaved, in the frame of the cloud
/// \param are_own out: whether the tile keeps each
Answer download_unoriented(Session& session, double* positions, float* normals,
                           unsigned char* are_own);

/// Where a cloud is.
struct Place_of_cloud
{
  int exponent_of_frame;
  double origin_of_frame[3];
  double low[3], high[3]; ///< corners of the box of its points, in the unit of the input
};

/// Turns the normals of the samples of all tiles, as `orient_tiles()` on the CPU.
/// \param positions xyz interleaved, in the frame of the plan
/// \param size from 1 to 2^31 - 1
/// \param plan of the cloud, with the spacing of its samples
/// \param parameters checked, of the cloud; `maximum_memory` is of the device
/// \param normals in and out: unit vectors, xyz interleaved
Answer orient_tiles(Session& session, const double* positions, std::size_t size,
                    const Place_of_cloud& place, const Plan& plan, const Parameters& parameters,
                    Progress_callback progress, Call_report& report, float* normals);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CUDA_TILES_H
