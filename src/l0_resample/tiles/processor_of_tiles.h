// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PROCESSOR_OF_TILES_H
#define L0_RESAMPLE_PROCESSOR_OF_TILES_H

#include "command_line/options.h"
#include "tiles/Property_interpolator.h"

#include <CGAL/l0_resample_tiles.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

// What resamples the tiles of `--as-one`: a CUDA device if one is asked for, else the CPU. All
// tasks of a run have to agree on it, so that `--device auto` is the CPU.

namespace l0_tool {

inline bool are_tiles_on_device(const Machine_options& options)
{
  return options.device == Device::CUDA;
}

/// What a tile takes: to resample it there, or to carry properties to its samples, whichever is
/// more.
/// \param row_size of the properties of a point, in bytes
inline Bytes_of_call bytes_of_tile(const Machine_options& options, std::size_t row_size)
{
  using CGAL::L0_resampling::Tiled_resampling;
  Bytes_of_call bytes = are_tiles_on_device(options)
                          ? Tiled_resampling<CGAL::CUDA_tag>::bytes_of_call
                          : Tiled_resampling<CGAL::Parallel_if_available_tag>::bytes_of_call;
  if (row_size > 0) {
    const Bytes_of_call to_carry = Property_interpolator::bytes_of_call(row_size);
    bytes.per_point = (std::max)(bytes.per_point, to_carry.per_point);
    bytes.per_sample = (std::max)(bytes.per_sample, to_carry.per_sample);
  }
  return bytes;
}

/// What it takes to find the sides of all samples at once, in bytes for each.
inline std::uint64_t bytes_per_sample_of_sides(const Machine_options& options)
{
  using CGAL::L0_resampling::Tiled_resampling;
  return are_tiles_on_device(options)
           ? Tiled_resampling<CGAL::CUDA_tag>::bytes_per_sample_of_sides
           : Tiled_resampling<CGAL::Parallel_if_available_tag>::bytes_per_sample_of_sides;
}

/// What tiles may take of the device of this machine, in bytes; without one all that there is.
/// \throws Device_error if it cannot be used
inline std::uint64_t memory_of_device(const Machine_options& options)
{
  using CGAL::L0_resampling::Tiled_resampling;
  return are_tiles_on_device(options)
           ? Tiled_resampling<CGAL::CUDA_tag>::device_memory()
           : Tiled_resampling<CGAL::Parallel_if_available_tag>::device_memory();
}

/// Calls `f` with the concurrency tag of the processor.
template <typename F>
void run_on(const Machine_options& options, const F& f)
{
#ifdef CGAL_L0_LINKED_WITH_CUDA
  if (are_tiles_on_device(options))
    return f(CGAL::CUDA_tag());
#endif
  (void)options;
  f(CGAL::Parallel_if_available_tag());
}

} // namespace l0_tool

#endif // L0_RESAMPLE_PROCESSOR_OF_TILES_H
