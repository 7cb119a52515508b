// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_THINNED_POINTS_CUH
#define CGAL_L0_CUDA_THINNED_POINTS_CUH

#include "driver/Cuda_points.cuh"
#include "search/representatives.cuh"

#include <optional>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Points of which one after the other comes to stand for those near it, as `Thinned_points` on the
/// CPU. The arrays are taken from the arena.
class Thinned_points
{
  const Execution_context& m_context;
  const unsigned m_size_of_input;
  unsigned* const m_of_input;  // for each point of the input, the place of what stands for it
  Positions m_positions;       // that are left
  unsigned* const m_list;      // room for that of the positions
  float3 *m_normals, *m_hints; // of the positions; null for none
  float4* m_all_normals =
    nullptr; // of the positions, once there are any in place of the given ones
  std::optional<Arena_scope> m_grid_scope; // of the arena
  Cell_grid m_grid;

public:
  /// \param of_input room for a number a point
  Thinned_points(const Execution_context& context, const Input& input, unsigned* of_input);
  Thinned_points(const Thinned_points&) = delete;
  Thinned_points& operator=(const Thinned_points&) = delete;

  const Positions& positions() const { return m_positions; }
  const float3* hints() const { return m_hints; }
  const float* given_normals() const { return reinterpret_cast<const float*>(m_normals); }

  const Cell_grid& grid() const { return m_grid; } // of the last `sort()`

  /// Builds a grid of the points, which stay in their order.
  const Cell_grid& sort(const Cell_frame& frame);

  /// For points at one place keeps one, with the largest normal and hint that are given: by x, then
  /// y, then z. Waits for the device.
  /// \returns whether any was left out; the grid is not theirs then
  bool keep_one_of_each_place();

  /// Keeps at most `limit` points in each subcell of the grid, as `thin_crowds()`.
  /// \returns whether any was left out; the grid is not theirs then
  bool thin(unsigned limit);

  /// Puts the points in the order of the grid.
  void take_order();

  /// \param normals of all positions, in place of the given ones; kept in their order from now on
  void take_normals(float4* normals)
  {
    m_all_normals = normals;
    m_normals = nullptr;
  }

private:
  void keep(const Representatives& representatives);
  void move_to(const Representatives& representatives);
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_THINNED_POINTS_CUH
