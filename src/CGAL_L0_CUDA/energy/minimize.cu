// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/Grid_sum.cuh"
#include "driver/stages.cuh"
#include "samples/loops_over_samples.cuh"

#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/internal/kernels/Density_in_ball.h>
#include <CGAL/L0_resampling/internal/kernels/Weight_of_pair.h>
#include <CGAL/L0_resampling/internal/kernels/block_factorization.h>
#include <CGAL/L0_resampling/internal/kernels/chebyshev_steps.h>
#include <CGAL/L0_resampling/internal/kernels/negligible_displacement.h>
#include <CGAL/L0_resampling/internal/kernels/shrinkage.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

// Large blocks: few to wait for, and few partial sums.
constexpr unsigned threads_per_large_block = 512;

// At once: the square of the right-hand side, and the energies.
constexpr int number_of_sums = 5;

struct Turn_in_kernel
{
  Minimization_parameters parameters;
  float penalty;
  Shrunk_jumps<float> jumps;
  bool regularize;
  double low_end_of_spectrum;
  unsigned number_of_steps; // at least one
  float unit;
  double units_per_length;
  Neighbor_lists neighbors;
  Samples samples;
  int4* points;
  Turn_arrays arrays;
  const Turn_result* last_result; // null in the first turn
  Turn_result* result;

  __device__ Range_of_pairs range() const
  {
    return {float(parameters.range_of_pairs), samples.scales, samples.spreading_radii};
  }
};

/// What the lengths of a pair are measured by, and where its weights end.
struct Scales_of_pair
{
  float own, other, squared_range;

  __device__ float squared() const { return own * other; }
};

/// w_i of Eq. (5): its inverse becomes the fourth number of the normal.
__device__ void update_density_weights(const Turn_in_kernel& turn)
{
  const float squared_bandwidth = float(turn.parameters.squared_bandwidth);
  const Range_of_pairs range = turn.range();
  const float mean_number_of_neighbors = float(turn.parameters.mean_number_of_neighbors > 0
                                                 ? turn.parameters.mean_number_of_neighbors
                                                 : double(turn.neighbors.number_of_pairs)
                                                     / turn.samples.size);
  for_each_sample_of_group(turn.samples.size, [&](unsigned i, unsigned lane, bool is_sample) {
    const uint2 row = turn.neighbors.row(turn.points, turn.samples.size, i);
    const int4 center = turn.points[i];
    const float own_scale = range.scale(i), own_limit = range.limit(i);
    float sum = 0;
    struct Other
    {
      int4 point;
      float scale, limit;
    };
    for_each_pair<4>(
      turn.neighbors, row, lane,
      [&](unsigned k, Wide) {
        return Other{turn.points[k], range.scale(k), range.limit(k)};
      },
      [&](const Other& other, Wide) {
        const float3 d = difference(center, other.point, turn.unit);
        const float squared_scale = own_scale * other.scale;
        sum += share_in_ball(dot(d, d), range.squared(own_limit, other.limit))
               * gaussian_weight(dot(d, d) / squared_scale, squared_bandwidth);
      });
    sum = group_sum<lanes_per_sample>(sum);
    if (lane == 0 && is_sample)
      turn.samples.normals[i].w = 1 / density_weight(sum, mean_number_of_neighbors);
  });
}

__device__ Block_factorization<float> load_block(const float* blocks, Wide size, Wide i)
{
  Block_factorization<float> block;
  block.pivots[0] = blocks[i];
  block.pivots[1] = blocks[size + i];
  block.pivots[2] = blocks[2 * size + i];
  block.l10 = blocks[3 * size + i];
  block.l20 = blocks[4 * size + i];
  block.l21 = blocks[5 * size + i];
  return block;
}

__device__ void store_block(const Block_factorization<float>& block, Wide size, Wide i,
                            float* blocks)
{
  blocks[i] = block.pivots[0];
  blocks[size + i] = block.pivots[1];
  blocks[2 * size + i] = block.pivots[2];
  blocks[3 * size + i] = block.l10;
  blocks[4 * size + i] = block.l20;
  blocks[5 * size + i] = block.l21;
}

__device__ float3 solve(const Block_factorization<float>& block, float3 r)
{
  const float x[3] = {r.x, r.y, r.z};
  float y[3];
  solve_block(block, x, y);
  return {y[0], y[1], y[2]};
}

__device__ float3 multiply(const Block_factorization<float>& block, float3 p)
{
  const float x[3] = {p.x, p.y, p.z};
  float y[3];
  multiply_block(block, x, y);
  return {y[0], y[1], y[2]};
}

__device__ double wide_dot(float3 a, float3 b)
{
  return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z;
}

/// \f$ a_{ik} \f$ of Eq. (7), 0 in turns without regularization.
struct Pair_weights
{
  bool regularize;
  float regularization_weight;
  Weight_of_pair<float> weight_of_pair;
  Range_of_pairs range;

  __device__ explicit Pair_weights(const Turn_in_kernel& turn)
    : regularize(turn.regularize),
      regularization_weight(float(turn.parameters.regularization_weight)),
      weight_of_pair{float(turn.parameters.squared_radius),
                     float(square(turn.parameters.maximum_jump))},
      range(turn.range())
  {}

  /// \param squared_distance, height_i, height_k of \f$ d = p_i - p_k \f$: its square,
  /// \f$ n_i^T d \f$ and \f$ n_k^T d \f$
  /// \param inverse_i, inverse_k \f$ 1/w_i \f$ and \f$ 1/w_k \f$
  __device__ float operator()(float squared_distance, float height_i, float height_k,
                              float inverse_i, float inverse_k, const Scales_of_pair& scales) const
  {
    if (!regularize)
      return 0;
    const float squared_height = squared_height_of_pair(height_i, height_k);
    const float stretch = 1 / scales.squared();
    const float by_place = weight_of_pair.by_place(
      regularization_weight * share_in_ball(squared_distance, scales.squared_range),
      squared_distance * stretch, squared_height * stretch);
    return weight_of_pair.by_density(by_place, inverse_i, inverse_k);
  }
};

struct Energy_sums
{
  double fit = 0, regularization = 0, squared_normal_misfit = 0;
  Wide number_of_active_pairs = 0;
};

/// Lines 4 and 2 of Algorithm 1 and the start of line 3: offsets by Eq. (9), g of Eq. (10),
/// diagonal blocks D, r = g, and the first step p = D^-1 r. The fourth number of p is beta n^T p,
/// all that neighbors need of p beside itself. From here to the end of the turn, the place of the
/// position holds c_i, and the fit tells where the sample is: the step need not be kept beside
/// them.
/// \returns g^T g of the thread
__device__ double linearize(const Turn_in_kernel& turn, Energy_sums& energy)
{
  double squared_rhs = 0;
  const float penalty = turn.penalty;
  const Range_of_pairs range = turn.range();
  const Pair_weights weight_of_pair(turn);
  const Wide size = turn.samples.size;
  for_each_sample_of_group(turn.samples.size, [&](unsigned i, unsigned lane, bool is_sample) {
    const uint2 row = turn.neighbors.row(turn.points, turn.samples.size, i);
    const int4 center = turn.points[i];
    const float4 own = turn.samples.normals[i], fit = turn.samples.fit[i];
    const float3 n = xyz(own), to_centroid = xyz(fit);
    float3 g = {0, 0, 0};
    float weight = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    float regularization = 0, squared_misfit = 0;
    unsigned number_of_active_pairs = 0;
    const float own_scale = range.scale(i), own_limit = range.limit(i);
    struct Other
    {
      int4 point;
      float4 normal;
      float scale, limit;
    };
    const auto load_other = [&](unsigned k, Wide) {
      return Other{turn.points[k], turn.samples.normals[k], range.scale(k), range.limit(k)};
    };
    for_each_pair<2>(turn.neighbors, row, lane, load_other, [&](const Other& loaded, Wide) {
      const float3 d = difference(center, loaded.point, turn.unit);
      const float4 other = loaded.normal;
      const float3 nk = xyz(other);
      const float squared_distance = dot(d, d);
      const float distance_i = dot(n, d), distance_k = dot(nk, d);
      const Scales_of_pair scales = {own_scale, loaded.scale,
                                     range.squared(own_limit, loaded.limit)};
      const float a = weight_of_pair(squared_distance, distance_i, distance_k, own.w, other.w,
                                     scales);
      const float scale = range.scales ? sqrtf(scales.squared()) : 1.f;
      const float share = share_in_ball(squared_distance, scales.squared_range);
      const Jump_of_pair<float> jump_i(distance_i, scale, share, turn.jumps),
        jump_k(distance_k, scale, share, turn.jumps);
      g -= a * d + (penalty * jump_i.misfit) * n + (penalty * jump_k.misfit) * nk;
      weight += a;
      xx += nk.x * nk.x;
      xy += nk.x * nk.y;
      xz += nk.x * nk.z;
      yy += nk.y * nk.y;
      yz += nk.y * nk.z;
      zz += nk.z * nk.z;
      regularization += 0.5f * a * squared_distance; // each unordered pair comes twice
      squared_misfit += jump_i.misfit * jump_i.misfit;
      number_of_active_pairs += jump_i.offset != 0;
    });
    g = group_sum<lanes_per_sample>(g);
    weight = group_sum<lanes_per_sample>(weight);
    xx = group_sum<lanes_per_sample>(xx);
    xy = group_sum<lanes_per_sample>(xy);
    xz = group_sum<lanes_per_sample>(xz);
    yy = group_sum<lanes_per_sample>(yy);
    yz = group_sum<lanes_per_sample>(yz);
    zz = group_sum<lanes_per_sample>(zz);
    if (!is_sample)
      return;
    energy.regularization += regularization;
    energy.squared_normal_misfit += squared_misfit;
    energy.number_of_active_pairs += number_of_active_pairs;
    if (lane != 0)
      return;
    energy.fit += double(fit.w) * wide_dot(to_centroid, to_centroid);

    g += fit.w * to_centroid;
    weight += fit.w;
    const float count = float(row.y - row.x);
    const float upper[6] = {
      weight + penalty * (xx + count * n.x * n.x), penalty * (xy + count * n.x * n.y),
      penalty * (xz + count * n.x * n.z),          weight + penalty * (yy + count * n.y * n.y),
      penalty * (yz + count * n.y * n.z),          weight + penalty * (zz + count * n.z * n.z)};
    const Block_factorization<float> block = factorize_block(upper);
    store_block(block, size, i, turn.arrays.blocks);
    const float3 p = solve(block, g);
    turn.arrays.r.set(i, g);
    turn.arrays.directions[0][i] = with_w(p, penalty * dot(n, p));
    turn.samples.fit[i] = with_w(to_centroid - p, fit.w);
    double* const position = turn.samples.positions + 3 * Wide(i);
    position[0] += to_centroid.x;
    position[1] += to_centroid.y;
    position[2] += to_centroid.z;
    squared_rhs += wide_dot(g, g);
  });
  return squared_rhs;
}

/// r -= H p, as (Hp)_i = D_i p_i - sum of [a_ik I + beta (n_i n_i^T + n_k n_k^T)] p_k. The weights
/// a_ik are computed anew each time: that takes no longer than reading them, and they would be as
/// many numbers as the lists of neighbors have.
/// \param use gets the sample, its block, its p and what becomes r
template <typename Use>
__device__ void subtract_product(const Turn_in_kernel& turn, const float4* directions,
                                 const Use& use)
{
  const Pair_weights weight_of_pair(turn);
  for_each_sample_of_group(turn.samples.size, [&](unsigned i, unsigned lane, bool is_sample) {
    float3 sum = {0, 0, 0}, product = {0, 0, 0};
    struct Other
    {
      float4 p;
      float4 normal;
      int4 point;
      float scale, limit;
    };
    const uint2 row = turn.neighbors.row(turn.points, turn.samples.size, i);
    const int4 center = turn.points[i];
    const float4 own = turn.samples.normals[i];
    const float3 n = xyz(own);
    const Range_of_pairs& range = weight_of_pair.range;
    const float own_scale = range.scale(i), own_limit = range.limit(i);
    const auto load_other = [&](unsigned k, Wide) {
      return Other{directions[k], turn.samples.normals[k], turn.points[k], range.scale(k),
                   range.limit(k)};
    };
    for_each_pair<2>(turn.neighbors, row, lane, load_other, [&](const Other& other, Wide) {
      const float3 d = difference(center, other.point, turn.unit);
      const float a =
        weight_of_pair(dot(d, d), dot(n, d), dot(xyz(other.normal), d), own.w, other.normal.w,
                       {own_scale, other.scale, range.squared(own_limit, other.limit)});
      sum += xyz(other.p);
      product += a * xyz(other.p) + other.p.w * xyz(other.normal);
    });
    sum = group_sum<lanes_per_sample>(sum);
    product = group_sum<lanes_per_sample>(product);
    if (lane != 0 || !is_sample)
      return;
    const Block_factorization<float> block = load_block(turn.arrays.blocks, turn.samples.size, i);
    const float3 p = xyz(directions[i]);
    product += (turn.penalty * dot(n, sum)) * n;
    use(i, block, p, turn.arrays.r.get(i) - (multiply(block, p) - product));
  });
}

/// r -= H p, p' = keep p + gain D^-1 r, x += p', where x is what the fit has lost
__device__ void take_step(const Turn_in_kernel& turn, float keep, float gain,
                          const float4* directions, float4* next_directions)
{
  subtract_product(turn, directions,
                   [&](unsigned i, const Block_factorization<float>& block, float3 last, float3 r) {
                     turn.arrays.r.set(i, r);
                     const float3 p = keep * last + gain * solve(block, r);
                     next_directions[i] = with_w(p, turn.penalty
                                                      * dot(xyz(turn.samples.normals[i]), p));
                     const float4 fit = turn.samples.fit[i];
                     turn.samples.fit[i] = with_w(xyz(fit) - p, fit.w);
                   });
}

/// Moves the samples to where the fit tells that they are.
__device__ void move_samples(const Turn_in_kernel& turn)
{
  for_each_sample(turn.samples.size, [&](unsigned i) {
    double* const position = turn.samples.positions + 3 * Wide(i);
    const double3 p = double3{position[0], position[1], position[2]}
                      - to_double(xyz(turn.samples.fit[i]));
    position[0] = p.x;
    position[1] = p.y;
    position[2] = p.z;
    const auto fixed = [&](double c) {
      return int(unsigned(Wide(__double2ll_rn(c * turn.units_per_length))));
    };
    turn.points[i] = make_int4(fixed(p.x), fixed(p.y), fixed(p.z), turn.points[i].w);
  });
}

/*!
One turn of Algorithm 1 in one cooperative launch, so that nobody waits for the host: weights,
shrinkage, and the steps of `Block_chebyshev_solver_traits`. These need one barrier each. Every
second one is written over the last but one, since neighbors may still read the last.
*/
__global__ void __launch_bounds__(threads_per_large_block, 2) run_turn(Turn_in_kernel turn)
{
  __shared__ double shared[Grid_sum<number_of_sums>::size_of_shared(threads_per_large_block)];
  Grid_sum<number_of_sums> grid_sum(turn.arrays.partial_sums, shared);
  const cooperative_groups::grid_group grid = cooperative_groups::this_grid();

  if (turn.regularize)
  {
    update_density_weights(turn);
    grid.sync();
  }
  Energy_sums energy;
  const double squared_rhs_of_thread = linearize(turn, energy);
  double sums[number_of_sums] = {squared_rhs_of_thread, energy.fit, energy.regularization,
                                 energy.squared_normal_misfit,
                                 double(energy.number_of_active_pairs)};
  grid_sum(sums);
  const double squared_rhs = sums[0];

  Chebyshev_steps steps(turn.low_end_of_spectrum);
  unsigned last = 0; // direction
  for (unsigned step = 1; step < turn.number_of_steps; ++step, last = 1 - last)
  {
    steps.advance();
    take_step(turn, float(steps.keep), float(steps.gain), turn.arrays.directions[last],
              turn.arrays.directions[1 - last]);
    grid.sync();
  }
  double squared_residual[1] = {0};
  subtract_product(turn, turn.arrays.directions[last],
                   [&](unsigned, const Block_factorization<float>&, float3, float3 r) {
                     squared_residual[0] += wide_dot(r, r);
                   });
  grid_sum(squared_residual);
  const bool is_finite = isfinite(squared_rhs) && isfinite(squared_residual[0]);
  if (is_finite)
    move_samples(turn);

  if (thread_index() == 0)
  {
    // As on the CPU: where the samples have come a long way, what is left of it need not be known
    // better than the way itself.
    const double last_scale = turn.last_result ? turn.last_result->right_hand_side_scale
                                               : negligible_displacement,
                 scale = max(last_scale, sqrt(squared_rhs)),
                 relative_residual = sqrt(squared_residual[0]) / scale;
    Turn_result& result = *turn.result;
    result.fit_energy = sums[1];
    result.regularization_energy = sums[2];
    result.squared_normal_misfit = sums[3];
    result.number_of_active_pairs = Wide(sums[4]);
    result.right_hand_side_scale = scale;
    result.relative_residual = relative_residual;
    result.solver_iterations = squared_rhs > 0 ? turn.number_of_steps : 0;
    result.converged = relative_residual <= default_chebyshev_tolerance;
    result.is_finite = is_finite;
  }
}

unsigned number_of_cooperative_blocks(const Execution_context& context)
{
  int blocks_per_multiprocessor = 0;
  CGAL_L0_CUDA_CHECK(cudaOccupancyMaxActiveBlocksPerMultiprocessor(
    &blocks_per_multiprocessor, run_turn, int(threads_per_large_block), 0));
  return unsigned(blocks_per_multiprocessor * context.number_of_multiprocessors);
}

} // namespace

Turn_arrays take_turn_arrays(const Execution_context& context, unsigned number_of_samples)
{
  Device_arena& arena = context.scratch;
  Turn_arrays arrays;
  for (float4*& directions : arrays.directions)
    directions = arena.take<float4>(number_of_samples);
  arrays.r = {arena.take<float>(3 * std::size_t(number_of_samples)), number_of_samples};
  arrays.blocks = arena.take<float>(6 * std::size_t(number_of_samples));
  arrays.partial_sums = arena.take<double>(2 * number_of_sums
                                           * std::size_t(number_of_cooperative_blocks(context)));
  return arrays;
}

void minimize_once(const Execution_context& context, const Minimization_parameters& parameters,
                   const Turn& of_plan, const Neighbor_lists& neighbors, const Cell_grid& grid,
                   const Samples& samples, const Turn_arrays& arrays,
                   const Turn_result* last_result, Turn_result* result)
{
  const double threshold = shrinkage_threshold(parameters.normal_weight, of_plan.penalty,
                                               parameters.sparsity_unit, parameters.maximum_jump);
  const double low_end_of_spectrum = parameters.low_end_of_spectrum(of_plan);
  Turn_in_kernel turn = {parameters,
                         float(of_plan.penalty),
                         {threshold, parameters.half_width_of_shrinkage},
                         of_plan.regularizes,
                         low_end_of_spectrum,
                         unsigned(number_of_chebyshev_steps(low_end_of_spectrum,
                                                            default_chebyshev_tolerance,
                                                            maximum_number_of_chebyshev_steps)),
                         grid.frame.unit(),
                         grid.frame.units_per_length,
                         neighbors,
                         samples,
                         grid.points,
                         arrays,
                         last_result,
                         result};
  void* arguments[] = {&turn};
  const unsigned useful_blocks = unsigned(
    (Wide(samples.size) * lanes_per_sample + threads_per_large_block - 1)
    / threads_per_large_block);
  const unsigned blocks = (std::min)(number_of_cooperative_blocks(context), useful_blocks);
  CGAL_L0_CUDA_CHECK(cudaLaunchCooperativeKernel(reinterpret_cast<void*>(run_turn), dim3(blocks),
                                                 dim3(threads_per_large_block), arguments, 0,
                                                 context.stream));
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
