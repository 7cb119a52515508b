// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation.cuh"

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

__global__ void count_samples_of_sets(const Link* sets, unsigned size, unsigned* sizes)
{
  const Wide i = thread_index();
  if (i >= size)
    return;
  const unsigned root = sets[i].target(), peers = __match_any_sync(__activemask(), root);
  if (is_leader_of(peers))
    atomicAdd(&sizes[root], unsigned(__popc(peers)));
}

__global__ void tell_sizes(const Link* sets, unsigned size, const unsigned* sizes, unsigned* sizes_of_samples)
{
  const Wide i = thread_index();
  if (i < size)
    sizes_of_samples[i] = sizes[sets[i].target()];
}

/// What the samples hang together by.
struct Sides
{
  const Link* trees;          // of each sample: the root of its tree, and whether it is turned against it
  const unsigned* sure_sizes; // of each sample: the size of its set once all that is sure was joined
};

/// Sums over a tree, in fixed point: integers may be added in any order.
struct Tree_sums
{
  long long center[3];
  long long normal[3];
  long long flux, largest_flux;
  unsigned size;
  unsigned largest_sure_size;
};

/// \param scale units of the fixed-point numbers per length of the frame
struct Tree_scale
{
  double units_per_length;
  double units_per_normal;
};

/// Adds up over the threads of a warp that have the same root, so that a tree's sums are not the bottleneck.
__device__ void add(long long* sum, long long value, unsigned peers, bool is_leader)
{
  const long long total = peer_sum(peers, value);
  if (is_leader && total != 0)
    atomicAdd(reinterpret_cast<Wide*>(sum), Wide(total));
}

__global__ void find_centers(Sides sides, Samples samples, Tree_scale scale, Tree_sums* trees)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const unsigned root = sides.trees[i].target();
  const unsigned peers = __match_any_sync(__activemask(), root);
  const bool is_leader = is_leader_of(peers);
  Tree_sums& tree = trees[root];
  for (int axis = 0; axis < 3; ++axis)
    add(&tree.center[axis], __double2ll_rn(samples.positions[3 * i + axis] * scale.units_per_length), peers, is_leader);
  // once for those that say the same
  const unsigned sure_size = sides.sure_sizes[i];
  if (is_leader_of(__match_any_sync(__activemask(), Wide(root) << 32 | sure_size)))
    atomicMax(&tree.largest_sure_size, sure_size);
  if (is_leader)
    atomicAdd(&tree.size, unsigned(__popc(peers)));
}

__global__ void find_fluxes(Sides sides, Samples samples, Tree_scale scale, Tree_sums* trees, unsigned* number_of_oriented)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const Link link = sides.trees[i];
  const unsigned root = link.target();
  const unsigned peers = __match_any_sync(__activemask(), root);
  const bool is_leader = is_leader_of(peers);
  Tree_sums& tree = trees[root];
  const double sign = link.is_turned() ? -1 : 1, length = 1 / scale.units_per_length / tree.size;
  const double3 from_center = {samples.positions[3 * i] - double(tree.center[0]) * length,
                               samples.positions[3 * i + 1] - double(tree.center[1]) * length,
                               samples.positions[3 * i + 2] - double(tree.center[2]) * length};
  const double3 normal = sign * to_double(xyz(samples.normals[i]));
  add(&tree.flux, __double2ll_rn(dot(normal, from_center) * scale.units_per_length), peers, is_leader);
  add(&tree.largest_flux, __double2ll_rn(sqrt(dot(from_center, from_center)) * scale.units_per_length), peers, is_leader);
  add(&tree.normal[0], __double2ll_rn(normal.x * scale.units_per_normal), peers, is_leader);
  add(&tree.normal[1], __double2ll_rn(normal.y * scale.units_per_normal), peers, is_leader);
  add(&tree.normal[2], __double2ll_rn(normal.z * scale.units_per_normal), peers, is_leader);
  const bool is_oriented = tree.size > 1 && sides.sure_sizes[i] == tree.largest_sure_size;
  const unsigned oriented = __ballot_sync(peers, is_oriented) & peers;
  if (is_leader && oriented)
    atomicAdd(number_of_oriented, unsigned(__popc(oriented)));
}

/// As `is_turned_inwards()` on the CPU.
__device__ bool is_turned_inwards(const Tree_sums& tree)
{
  const double rounding = 1e-9;
  if (fabs(double(tree.flux)) > rounding * double(tree.largest_flux))
    return tree.flux < 0;
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (llabs(tree.normal[other]) > llabs(tree.normal[axis]))
      axis = other;
  return tree.normal[axis] < 0;
}

__global__ void turn_normals(const Link* trees_of_samples, const Tree_sums* trees, Samples samples)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const Link link = trees_of_samples[i];
  if (is_turned_inwards(trees[link.target()]) == link.is_turned())
    return;
  const float4 n = samples.normals[i];
  samples.normals[i] = make_float4(-n.x, -n.y, -n.z, n.w);
}

} // namespace

double orient_normals(const Workplace& workplace, const double (&low)[3], const double (&high)[3],
                      unsigned number_of_neighbors, double spacing, const Samples& samples)
{
  const unsigned m = samples.size;
  const cudaStream_t stream = workplace.stream;
  const Arena_scope arena_scope(workplace.arena), scratch_scope(workplace.scratch);
  Link* const roots = workplace.arena.take<Link>(m);
  unsigned* const sure_sizes = workplace.arena.take<unsigned>(m);
  {
    const Arena_scope graph_scope(workplace.arena), voting_scope(workplace.scratch);
    const unsigned* const nearest = find_nearest_samples(workplace, low, high, number_of_neighbors,
                                                         spacing * std::sqrt(double(number_of_neighbors) / 2), samples);
    const Graph graph = {m,       number_of_neighbors,
                         nearest, workplace.arena.take<unsigned short>(Wide(m) * number_of_neighbors),
                         samples, float(spacing * spacing)};
    Link *const faces = workplace.arena.take<Link>(m), *const parts = workplace.arena.take<Link>(m);
    const unsigned number_of_edges = grow_forest(workplace, graph, faces);

    // As on the CPU: the votes join faces to parts and parts to trees, unless the fields of faces and parts know better.
    Voting voting(workplace, graph, number_of_edges);
    const auto join_faces_and_parts = [&]() {
      voting.begin(faces);
      voting.join(clear_majority, parts);
      voting.join(0, roots);
    };
    // without an edge between two sets there are no two of them in a tree
    const auto is_joined_by_field = [&](Link* sets) {
      return number_of_edges > 0 && join_by_field(workplace, graph, roots, spacing, sets);
    };
    join_faces_and_parts();
    if (is_joined_by_field(faces))
      join_faces_and_parts();
    {
      const Arena_scope sizes_scope(workplace.scratch);
      unsigned* const sizes = workplace.scratch.take<unsigned>(m);
      CGAL_L0_CUDA_CHECK(cudaMemsetAsync(sizes, 0, m * sizeof(unsigned), stream));
      count_samples_of_sets<<<blocks_for(m), threads_per_block, 0, stream>>>(parts, m, sizes);
      check_launch("count_samples_of_sets");
      tell_sizes<<<blocks_for(m), threads_per_block, 0, stream>>>(parts, m, sizes, sure_sizes);
      check_launch("tell_sizes");
    }
    if (is_joined_by_field(parts))
    {
      voting.begin(parts);
      voting.join(0, roots);
    }
  }

  double extent = 0;
  for (int axis = 0; axis < 3; ++axis)
    extent = (std::max)({extent, std::abs(low[axis]), std::abs(high[axis])});
  // 2^32 values below 2^30 units each do not overflow
  const Tree_scale scale = {std::ldexp(1., 28 - std::ilogb((std::max)(extent, 1.))), std::ldexp(1., 29)};
  const Sides sides = {roots, sure_sizes};
  Tree_sums* const trees = workplace.scratch.take<Tree_sums>(m);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(trees, 0, m * sizeof(Tree_sums), stream));
  const Device_counter<unsigned> number_of_oriented(workplace);
  find_centers<<<blocks_for(m), threads_per_block, 0, stream>>>(sides, samples, scale, trees);
  check_launch("find_centers");
  find_fluxes<<<blocks_for(m), threads_per_block, 0, stream>>>(sides, samples, scale, trees, number_of_oriented.address());
  check_launch("find_fluxes");
  turn_normals<<<blocks_for(m), threads_per_block, 0, stream>>>(roots, trees, samples);
  check_launch("turn_normals");
  return double(number_of_oriented.read()) / m;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
