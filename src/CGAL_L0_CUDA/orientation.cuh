// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_ORIENTATION_CUH
#define CGAL_L0_CUDA_ORIENTATION_CUH

#include "stages.cuh"

#include <CGAL/L0_resampling/internal/orientation_agreement.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

using Wide = unsigned long long;

/// What has to turn for `i` to fit `target`: the target's index, and whether the signs differ. One word, so that it is read and written at once.
struct Link
{
  Wide word;

  __device__ static Link to(unsigned target, bool is_turned) { return {Wide(target) << 1 | Wide(is_turned)}; }
  __device__ unsigned target() const { return unsigned(word >> 1); }
  __device__ bool is_turned() const { return word & 1; }
};

/// The graph of nearest neighbors: edge `i k + e` leads from sample i to its e-th neighbor.
struct Graph
{
  unsigned size;
  unsigned k;
  const unsigned* nearest;
  unsigned short* grades; // step, 0 for the surest edges; lowest bit: whether the normals disagree; or `doubtful`
  Samples samples;
  float squared_spacing;
};

/// Votes are added up in fixed point: integers may be added in any order.
constexpr double units_per_vote = 4294967296.;

/// `orientation_agreement()` of two samples.
__device__ inline float agreement_of(const Graph& graph, Wide i, unsigned other)
{
  const double* const p = graph.samples.positions + 3 * i;
  const double* const q = graph.samples.positions + 3 * Wide(other);
  const float3 e = {float(q[0] - p[0]), float(q[1] - p[1]), float(q[2] - p[2])};
  const float3 n = xyz(graph.samples.normals[i]), other_n = xyz(graph.samples.normals[other]);
  return orientation_agreement(dot(n, other_n), dot(n, e), -dot(other_n, e), graph.squared_spacing);
}

/// Joins the larger ones of the sets that hang together if their field asks to turn some of them against the others, as `join_by_field()` on the CPU.
/// \param edges between samples of different sets; others do not matter
/// \param trees what the votes make of the sets
/// \param sets in and out: the root of each sample
/// \returns whether any was turned; if not, nothing was joined. Waits for the device
bool join_by_field(const Workplace& workplace, const Graph& graph, const Wide* edges, unsigned number_of_edges,
                   const Link* trees, double spacing, Link* sets);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_ORIENTATION_CUH
