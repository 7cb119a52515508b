// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orient_measured_normals.cuh"
#include "orientation/orientation.cuh"

#include <CGAL/L0_resampling/internal/kernels/side_confidence.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// \param first in: more than any index; out: the first sample whose viewpoint leaves no doubt
__global__ void find_first_certain(Side_hints hints, Samples samples, unsigned* first)
{
  const Wide i = thread_index();
  if (i < samples.size && i < __ldcg(first) && hints.certain_side_of(samples, i) != 0)
    atomicMin(first, unsigned(i));
}

/// As `sets_of_viewpoints()` on the CPU.
/// \param first the first sample whose viewpoint leaves no doubt, if there is any
__global__ void begin_sets(Side_hints hints, Samples samples, const unsigned* first, Link* sets)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const int side = hints.certain_side_of(samples, i);
  sets[i] = side == 0 ? Link::to(unsigned(i), false)
                      : Link::to(*first, side != hints.certain_side_of(samples, *first));
}

__global__ void count_samples_of_sets(const Link* sets, unsigned size, unsigned* sizes)
{
  const Wide i = thread_index();
  const bool is_sample = i < size;
  const unsigned with_sample = __ballot_sync(0xffffffffu, is_sample);
  if (!is_sample)
    return;
  const unsigned root = sets[i].target(), peers = __match_any_sync(with_sample, root);
  if (is_leader_of(peers))
    atomicAdd(&sizes[root], unsigned(__popc(peers)));
}

__global__ void tell_sizes(const Link* sets, unsigned size, const unsigned* sizes,
                           unsigned* sizes_of_samples)
{
  const Wide i = thread_index();
  if (i < size)
    sizes_of_samples[i] = sizes[sets[i].target()];
}

/// The edges that connect the samples.
struct Sides
{
  const Link* trees; // of each sample: the root of its tree, and whether it is turned against it
  const unsigned*
    sure_sizes; // of each sample: the size of its set once all that is sure was joined
};

constexpr double units_per_confidence = Sample_counts::units_per_confidence,
                 units_per_normal = 1 << 29; // 2^32 of them do not overflow

/// Sums over a tree, in fixed point: integers may be added in any order.
struct Tree_sums
{
  long long center_and_size[4];
  long long sides
    // flux and the largest it could be, the normals, and what `Side_votes` has: the sum of the
    // votes, that of their absolute values, and that of the certain sides
    [8];
  unsigned maximum_sure_size;
  unsigned number_of_dipoles;
  long long winding_numbers, confidences; // of the dipoles

  __device__ long long size() const { return center_and_size[3]; }
  __device__ long long flux() const { return sides[0]; }
  __device__ long long maximum_flux() const { return sides[1]; }
  __device__ long long normal(int axis) const { return sides[2 + axis]; }
  __device__ Side_votes votes() const
  {
    return {double(sides[7]), double(sides[5]), double(sides[6])};
  }
  /// Of a sum over the dipoles.
  __device__ double mean_of_dipoles(long long sum) const
  {
    return number_of_dipoles > 0 ? double(sum) / units_per_confidence / number_of_dipoles : 0;
  }
  __device__ double mean_winding_number() const { return mean_of_dipoles(winding_numbers); }

  /// As `Tree` on the CPU.
  __device__ bool is_turned_inwards() const
  {
    const double rounding = 1e-9;
    if (fabs(double(flux())) > rounding * double(maximum_flux()))
      return flux() < 0;
    int axis = 0;
    for (int other = 1; other < 3; ++other)
      if (llabs(normal(other)) > llabs(normal(axis)))
        axis = other;
    return normal(axis) < 0;
  }
  __device__ bool is_to_be_turned() const
  {
    return votes().are_clear() ? votes().say_turn()
                               : is_turned_by_windings(is_turned_inwards(), mean_winding_number());
  }
  __device__ double facing_share() const
  {
    const double x = double(normal(0)), y = double(normal(1)), z = double(normal(2));
    return sqrt(x * x + y * y + z * z) / units_per_normal / double(size());
  }
  __device__ double confidence() const
  {
    return votes().are_clear() ? confidence_of_hints(votes())
                               : confidence_of_tree(fabs(mean_winding_number()), facing_share());
  }
};

/// \param units_per_length of the fixed-point numbers, in the frame
struct Tree_scale
{
  double units_per_length;
};

/// Adds numbers of the samples to the sums of their trees. Most samples are of one tree: those of
/// the tree of a block's first sample are added up over the block, the others over warps, so that
/// no sum has to wait for many others. For all threads of a block at once.
/// \param sums called with a root, where its sums are
template <int count, typename Sums>
__device__ void add_to_trees(unsigned root, bool is_sample, const long long (&values)[count],
                             const Sums& sums)
{
  __shared__ unsigned common_root;
  __shared__ long long of_warps[threads_per_block / 32][count];
  if (threadIdx.x == 0)
    common_root = root;
  __syncthreads();
  const bool is_common = is_sample && root == common_root;
  for (int c = 0; c < count; ++c)
  {
    const long long sum = group_sum<32>(is_common ? values[c] : 0ll);
    if (threadIdx.x % 32 == 0)
      of_warps[threadIdx.x / 32][c] = sum;
  }
  __syncthreads();
  if (threadIdx.x < count)
  {
    long long sum = 0;
    for (unsigned warp = 0; warp < threads_per_block / 32; ++warp)
      sum += of_warps[warp][threadIdx.x];
    if (sum != 0)
      atomicAdd(reinterpret_cast<Wide*>(sums(common_root) + threadIdx.x), Wide(sum));
  }
  const bool is_other = is_sample && !is_common;
  const unsigned others = __ballot_sync(0xffffffffu, is_other);
  if (!is_other)
    return;
  const unsigned peers = __match_any_sync(others, root);
  for (int c = 0; c < count; ++c)
  {
    const long long sum = peer_sum(peers, values[c]);
    if (is_leader_of(peers) && sum != 0)
      atomicAdd(reinterpret_cast<Wide*>(sums(root) + c), Wide(sum));
  }
}

__global__ void find_centers(Sides sides, Samples samples, Tree_scale scale, Tree_sums* trees)
{
  const Wide i = thread_index();
  const bool is_sample = i < samples.size;
  const unsigned root = is_sample ? sides.trees[i].target() : 0;
  long long values[4] = {0, 0, 0, 1};
  for (int axis = 0; axis < 3 && is_sample; ++axis)
    values[axis] = __double2ll_rn(samples.positions[3 * i + unsigned(axis)]
                                  * scale.units_per_length);
  add_to_trees(root, is_sample, values, [&](unsigned r) { return trees[r].center_and_size; });
  const unsigned sure_size = is_sample ? sides.sure_sizes[i] : 0;
  // once for those of a warp that say the same, and not where a larger one has been seen
  const unsigned peers = __match_any_sync(0xffffffffu, Wide(root) << 32 | sure_size);
  if (is_sample && is_leader_of(peers) && __ldcg(&trees[root].maximum_sure_size) < sure_size)
    atomicMax(&trees[root].maximum_sure_size, sure_size);
}

__global__ void find_fluxes(Sides sides, Samples samples, Tree_scale scale, Side_hints hints,
                            Tree_sums* trees, unsigned* number_of_oriented)
{
  const Wide i = thread_index();
  const bool is_sample = i < samples.size;
  const Link link = is_sample ? sides.trees[i] : Link{0};
  const Tree_sums& tree = trees[link.target()];
  long long values[8] = {};
  bool is_oriented = false;
  if (is_sample)
  {
    const double sign = link.is_turned() ? -1 : 1,
                 length = 1 / scale.units_per_length / double(tree.size());
    const double3 from_center = {
      samples.positions[3 * i] - double(tree.center_and_size[0]) * length,
      samples.positions[3 * i + 1] - double(tree.center_and_size[1]) * length,
      samples.positions[3 * i + 2] - double(tree.center_and_size[2]) * length};
    const double3 normal = sign * to_double(xyz(samples.normals[i]));
    values[0] = __double2ll_rn(dot(normal, from_center) * scale.units_per_length);
    values[1] = __double2ll_rn(sqrt(dot(from_center, from_center)) * scale.units_per_length);
    values[2] = __double2ll_rn(normal.x * units_per_normal);
    values[3] = __double2ll_rn(normal.y * units_per_normal);
    values[4] = __double2ll_rn(normal.z * units_per_normal);
    values[5] = __double2ll_rn(dot(normal, hints.direction_of(samples, i)) * units_per_normal);
    values[6] = llabs(values[5]);
    values[7] = (link.is_turned() ? -1 : 1) * hints.certain_side_of(samples, i);
    is_oriented = tree.size() > 1 && sides.sure_sizes[i] == tree.maximum_sure_size;
  }
  add_to_trees(link.target(), is_sample, values, [&](unsigned r) { return trees[r].sides; });
  const int count = __syncthreads_count(is_oriented);
  if (threadIdx.x == 0 && count > 0)
    atomicAdd(number_of_oriented, unsigned(count));
}

/// What is known of the side of a dipole of a tree.
struct Side_of_dipole
{
  Side_evidence evidence; // of the others of its tree
  double confidence;      // within the tree
};

struct Dipoles
{
  Dipole* dipoles;
  Side_of_dipole* sides;
  unsigned size;
  double area; // that a dipole stands for
};

__global__ void place_dipoles(Dipoles all, Samples samples, const Link* trees_of_samples)
{
  const Wide k = thread_index();
  if (k < all.size)
    all.dipoles[k] = dipole_of(samples, trees_of_samples, k, all.size);
}

/// As `Dipoles_of_trees::evidence_of()` on the CPU, one block for each dipole.
__global__ void find_evidence(Dipoles all, Tree_sums* trees)
{
  __shared__ double of_warps[threads_per_block / 32][3];
  const Dipole& own = all.dipoles[blockIdx.x];
  const double squared_core = squared_core_of_dipole(all.area),
               minimum_squared_distance = minimum_squared_distance_of_evidence(squared_core);
  double sums[3] = {0, 0, 0}; // winding number, agreement, its absolute values
  for (unsigned k = threadIdx.x; k < all.size; k += blockDim.x)
  {
    const Dipole& other = all.dipoles[k];
    if (k == blockIdx.x || other.root != own.root)
      continue;
    const double3 d = {other.position.x - own.position.x, other.position.y - own.position.y,
                       other.position.z - own.position.z};
    const double height = dot(other.normal, d), squared_distance = dot(d, d);
    sums[0] += winding_number_of_dipole(height, squared_distance, squared_core);
    if (squared_distance <= minimum_squared_distance)
      continue;
    const double agreement = dipole_agreement(
      dot(own.normal, other.normal), height * dot(own.normal, d), squared_distance, squared_core);
    sums[1] += agreement;
    sums[2] += fabs(agreement);
  }
  for (int c = 0; c < 3; ++c)
  {
    const double sum = group_sum<32>(sums[c]);
    if (threadIdx.x % 32 == 0)
      of_warps[threadIdx.x / 32][c] = sum;
  }
  __syncthreads();
  if (threadIdx.x != 0)
    return;
  for (int c = 0; c < 3; ++c)
  {
    sums[c] = 0;
    for (unsigned warp = 0; warp < threads_per_block / 32; ++warp)
      sums[c] += of_warps[warp][c];
  }
  const Side_evidence evidence = {sums[0] * all.area, sums[2] > 0 ? sums[1] / sums[2] : 0};
  all.sides[blockIdx.x].evidence = evidence;
  Tree_sums& tree = trees[own.root];
  atomicAdd(&tree.number_of_dipoles, 1u);
  atomicAdd(reinterpret_cast<Wide*>(&tree.winding_numbers),
            Wide(__double2ll_rn(evidence.winding_number * units_per_confidence)));
}

__global__ void find_confidences(Dipoles all, Tree_sums* trees)
{
  const Wide k = thread_index();
  if (k >= all.size)
    return;
  Side_of_dipole& side = all.sides[k];
  Tree_sums& tree = trees[all.dipoles[k].root];
  const double sign = tree.is_to_be_turned() ? -1 : 1;
  side.confidence =
    confidence_within_tree({sign * side.evidence.winding_number, side.evidence.agreement},
                           sign * tree.mean_winding_number());
  atomicAdd(reinterpret_cast<Wide*>(&tree.confidences),
            Wide(__double2ll_rn(side.confidence * units_per_confidence)));
}

__global__ void turn_normals(const Link* trees_of_samples, const Tree_sums* trees, Dipoles all,
                             Side_hints hints, Samples samples, Sample_counts* counts)
{
  const Wide i = thread_index();
  bool hinted = false;
  long long confidence = 0;
  if (i < samples.size)
  {
    const Link link = trees_of_samples[i];
    const Tree_sums& tree = trees[link.target()];
    hinted = tree.votes().are_clear();
    if (tree.is_to_be_turned() != link.is_turned())
    {
      const float4 n = samples.normals[i];
      samples.normals[i] = make_float4(-n.x, -n.y, -n.z, n.w);
    }
    const std::size_t k = dipole_of_sample(i, samples.size, all.size);
    const double within_tree = all.dipoles[k].root == link.target() ? all.sides[k].confidence
                               : tree.number_of_dipoles > 0 ? tree.mean_of_dipoles(tree.confidences)
                                                            : guessed_confidence;
    const Side_hints::Viewpoint_cosine cosine = hints.viewpoint_cosine(samples, i);
    const double of_side = cosine.is_known ? confidence_of_viewpoint(cosine.value)
                                           : confidence_of_side(tree.confidence(), within_tree);
    samples.side_confidences[i] = float(of_side);
    if (samples.trees)
      samples.trees[i] = link.target();
    confidence = __double2ll_rn(of_side * units_per_confidence);
  }
  const int count = __syncthreads_count(hinted);
  if (threadIdx.x == 0 && count > 0)
    atomicAdd(&counts->hinted, unsigned(count));
  const long long sum = group_sum<32>(confidence);
  if (threadIdx.x % 32 == 0)
    atomicAdd(&counts->confidence, Wide(sum));
}

/// As `orient_normals()` on the CPU.
/// \param mean_normals out, if there is a noise of heights: on the sides of the normals or opposite
void orient_graph(const Execution_context& context, const double (&low)[3], const double (&high)[3],
                  unsigned number_of_neighbors, double spacing,
                  const std::optional<double>& noise_of_heights, const Side_hints& hints,
                  const Samples& samples, Sample_counts* counts, float3* mean_normals)
{
  const unsigned m = samples.size;
  const cudaStream_t stream = context.stream;
  const Arena_scope arena_scope(context.arena), scratch_scope(context.scratch);
  if (m > maximum_number_of_linked_samples)
    throw Failure(Status::OUT_OF_MEMORY, "more than 2^31 - 1 samples");
  // in the place of the fit, which is not needed any more
  static_assert(sizeof(*samples.fit) >= 3 * sizeof(Link) + sizeof(unsigned),
                "the fit has no room for so much");
  Link *const roots = reinterpret_cast<Link*>(samples.fit), *const faces = roots + m,
              *const parts = faces + m;
  unsigned* const sure_sizes = reinterpret_cast<unsigned*>(parts + m);
  {
    const Arena_scope first_scope(context.scratch);
    unsigned* const first = context.scratch.take<unsigned>(1);
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(first, 0xff, sizeof(unsigned), stream));
    if (hints.are_viewpoints)
    {
      find_first_certain<<<blocks_for(m), threads_per_block, 0, stream>>>(hints, samples, first);
      check_launch("find_first_certain");
    }
    begin_sets<<<blocks_for(m), threads_per_block, 0, stream>>>(hints, samples, first, faces);
    check_launch("begin_sets");
  }
  {
    const Arena_scope graph_scope(context.arena), voting_scope(context.scratch);
    unsigned* const nearest =
      find_nearest_samples(context, low, high, number_of_neighbors,
                           spacing * std::sqrt(double(number_of_neighbors) / 2), samples);
    const Graph graph = {m,       number_of_neighbors,      nearest,
                         samples, float(spacing * spacing), noise_of_heights.has_value()};
    if (noise_of_heights)
      find_height_tolerances(context, graph, spacing, *noise_of_heights);
    const unsigned number_of_edges = grow_forest(context, graph, faces);

    // As on the CPU: the votes join faces to parts and parts to trees, unless the fields of faces
    // and parts know better.
    Voting voting(context, graph, number_of_edges);
    const auto join_faces_and_parts = [&]() {
      voting.begin(faces);
      voting.join(clear_majority, parts);
      voting.join(0, roots);
    };
    // without an edge between two sets there are no two of them in a tree
    const auto is_joined_by_field = [&](Link* sets) {
      return number_of_edges > 0 && join_by_field(context, graph, roots, spacing, sets);
    };
    join_faces_and_parts();
    if (is_joined_by_field(faces))
      join_faces_and_parts();
    {
      const Arena_scope sizes_scope(context.scratch);
      unsigned* const sizes = context.scratch.take<unsigned>(m);
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
  if (noise_of_heights)
  {
    const Arena_scope voters_scope(context.arena);
    const unsigned number_of_voters = voters_per_neighbor * number_of_neighbors;
    unsigned* const nearest =
      find_nearest_samples(context, low, high, number_of_voters,
                           spacing * std::sqrt(double(number_of_voters) / 2), samples);
    turn_outvoted(context, {m, number_of_voters, nearest, samples, float(spacing * spacing), true},
                  roots, hints, mean_normals);
  }

  double extent = 0;
  for (int axis = 0; axis < 3; ++axis)
    extent = (std::max)({extent, std::abs(low[axis]), std::abs(high[axis])});
  // 2^32 values below 2^30 units each do not overflow
  const Tree_scale scale = {std::ldexp(1., 28 - std::ilogb((std::max)(extent, 1.)))};
  const Sides sides = {roots, sure_sizes};
  Tree_sums* const trees = context.scratch.take<Tree_sums>(m);
  CGAL_L0_CUDA_CHECK(cudaMemsetAsync(trees, 0, m * sizeof(Tree_sums), stream));
  find_centers<<<blocks_for(m), threads_per_block, 0, stream>>>(sides, samples, scale, trees);
  check_launch("find_centers");
  find_fluxes<<<blocks_for(m), threads_per_block, 0, stream>>>(sides, samples, scale, hints, trees,
                                                               &counts->oriented);
  check_launch("find_fluxes");
  const unsigned number_of_dipoles = (std::min)(m, maximum_number_of_dipoles);
  const Dipoles dipoles = {context.scratch.take<Dipole>(number_of_dipoles),
                           context.scratch.take<Side_of_dipole>(number_of_dipoles),
                           number_of_dipoles,
                           spacing * spacing * double(m) / double(number_of_dipoles)};
  place_dipoles<<<blocks_for(number_of_dipoles), threads_per_block, 0, stream>>>(dipoles, samples,
                                                                                 roots);
  check_launch("place_dipoles");
  find_evidence<<<number_of_dipoles, threads_per_block, 0, stream>>>(dipoles, trees);
  check_launch("find_evidence");
  find_confidences<<<blocks_for(number_of_dipoles), threads_per_block, 0, stream>>>(dipoles, trees);
  check_launch("find_confidences");
  turn_normals<<<blocks_for(m), threads_per_block, 0, stream>>>(roots, trees, dipoles, hints,
                                                                samples, counts);
  check_launch("turn_normals");
}

} // namespace

void orient_normals(const Execution_context& context, const double (&low)[3],
                    const double (&high)[3], unsigned number_of_neighbors, double spacing,
                    const Side_hints& hints, const Samples& samples, Sample_counts* counts)
{
  orient_graph(context, low, high, number_of_neighbors, spacing, std::nullopt, hints, samples,
               counts, nullptr);
}

void orient_measured_normals(const Execution_context& context, const double (&low)[3],
                             const double (&high)[3], unsigned number_of_neighbors, double spacing,
                             double noise_of_heights, const Side_hints& hints,
                             const Samples& samples, Sample_counts* counts, float3* mean_normals)
{
  orient_graph(context, low, high, number_of_neighbors, spacing, noise_of_heights, hints, samples,
               counts, mean_normals);
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
