// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_FRAME_CUH
#define CGAL_L0_CUDA_FRAME_CUH

#include "core/vectors.cuh"

#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// The working frame of the CPU, `Working_frame`: what of it the device needs. Points enter it to
/// the bit as there.
struct Frame
{
  int exponent = 0;
  double origin[3] = {0, 0, 0}; // after the scaling by the exponent
  double unit = 1;              // a length after that scaling

  __host__ __device__ double enter(double coordinate, int axis) const
  {
    return (scalbn(coordinate, exponent) - origin[axis]) / unit;
  }

  __host__ __device__ double3 enter(const double* xyz) const
  {
    return {enter(xyz[0], 0), enter(xyz[1], 1), enter(xyz[2], 2)};
  }

  __host__ __device__ double leave(double coordinate, int axis) const
  {
    return scalbn(coordinate * unit + origin[axis], -exponent);
  }

  double length_in_frame(double length) const { return std::ldexp(length, exponent) / unit; }
  double length_of_input(double length) const
  {
    return (std::min)(std::ldexp(length * unit, -exponent), (std::numeric_limits<double>::max)());
  }
};

/// A frame, and the bounding box of the points in it.
struct Framed_box
{
  Frame frame;
  double low[3], high[3];

  double diagonal() const
  {
    const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return std::sqrt(x * x + y * y + z * z);
  }

  /// Makes `unit`, a length in the frame, the unit of frame and box.
  void set_unit(double unit)
  {
    frame.unit *= unit;
    for (double* corner : {low, high})
      for (int axis = 0; axis < 3; ++axis)
        corner[axis] /= unit;
  }
};

/// Points of the input, all or some, in a frame; or of that frame itself.
struct Positions
{
  const double* xyz;
  unsigned size;
  Frame frame;
  bool in_frame;                  // whether they are there already
  const unsigned* list = nullptr; // which of the points they are; null for the first `size`
  const float* scales = nullptr;  // of all points; null if all are 1

  __device__ float scale(unsigned i) const { return Scales_view{scales}[list ? list[i] : i]; }

  __device__ double3 operator()(unsigned i) const
  {
    const double* const p = xyz + 3 * (unsigned long long)(list ? list[i] : i);
    return in_frame ? double3{p[0], p[1], p[2]} : frame.enter(p);
  }
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_FRAME_CUH
