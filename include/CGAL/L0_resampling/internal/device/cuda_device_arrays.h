// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CUDA_DEVICE_ARRAYS_H
#define CGAL_L0_RESAMPLING_INTERNAL_CUDA_DEVICE_ARRAYS_H

#include <CGAL/L0_resampling/internal/device/cuda_interface.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

// For callers whose points are in the memory of a device already, and whose results stay there.

/// An array of shape (n, 3) in the memory of a device, wherever its rows and columns are there.
struct Device_rows
{
  const void* data;
  std::ptrdiff_t row_stride, column_stride; ///< in bytes, of either sign
  bool is_double;                           ///< or `float`
};

/// The points that `upload_from_device()` took.
struct Device_points
{
  std::size_t size;             ///< that are kept; 0 if a non-finite one is refused
  std::size_t first_non_finite; ///< index of the first non-finite point; n if there is none
  double low[3], high[3];       ///< corners of the bounding box of the session's points
};

/// As `create()`, on a device that the caller chooses.
Answer create_on(int device, Session*& session);

/// Makes the session begin after the work that a stream holds now.
/// \param stream a `cudaStream_t` as a number, which may be that of a default stream
Answer wait_for(Session& session, std::int64_t stream);

/// As `upload()`, from the session's own device.
/// \param points that may be non-finite
/// \param size from 1 to 2^32 - 2
/// \param normals, hints of any length and sign, or null
/// \param hints_are_viewpoints whether the hints are places that the points were seen from
Answer upload_from_device(Session& session, const Device_rows& points, std::size_t size,
                          const Device_rows* normals, const Device_rows* hints,
                          bool hints_are_viewpoints, bool drop_non_finite,
                          std::size_t maximum_memory, Device_points& taken);

/// As `download()`, to arrays on the session's device, in the order of C.
/// \tparam FT `float` or `double`
/// \param low, high corners, three numbers each, of a box that positions outside are moved to
/// \param may_have_equal_points out: whether two positions are equal: true whenever they are, and
/// next to never when not
template <typename FT>
Answer download_to_device(Session& session, const FT* low, const FT* high, FT* positions,
                          FT* normals, bool& may_have_equal_points);

/// The device that memory belongs to.
Answer find_device_of(const void* data, int& device);

/// Memory on the session's device that outlives the session.
Answer allocate(Session& session, std::size_t bytes, void*& data);

void give_back(int device, void* data) noexcept;

Answer copy_to_device(Session& session, const void* source, std::size_t bytes, void* target);

Answer copy_to_host(int device, const void* source, std::size_t bytes, void* target);

/// The rows of an array, xyz interleaved.
Answer copy_to_host(Session& session, const Device_rows& rows, std::size_t size, double* target);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CUDA_DEVICE_ARRAYS_H
