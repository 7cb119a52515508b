// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "samples/gathered.cuh"
#include "samples/stages_of_refinement.cuh"
#include "kernels/Plane_fit.cuh"
#include "search/Query.cuh"

#include <CGAL/L0_resampling/internal/kernels/split_of_sheet.h>

#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// The sums of the inner ball come after those of the whole one: registers are scarce.
/// \param order where each sample of the grid stands; null if each in its own place
__global__ void __launch_bounds__(threads_per_block, 2)
  find_splits(Cell_grid grid, const unsigned* order, Cell_blocks blocks, Scattered_disks disks,
              Lengths_of_refinement lengths, Samples samples, Split_of_sheet* splits)
{
  using Moments = Moments_of_sheets<float>;
  __shared__ Sums_of_block<Moments> sums_of_ball, sums_of_inner;
  {
    const Query query(grid.size);
    const int4 center = grid.points[query.index];
    const unsigned i = order ? order[query.index] : query.index;
    const double scale = samples.scale(i), radius = radius_of_split * lengths.unit * scale;
    const float highest = float(maximum_height_of_sheets * lengths.at(scale, 1).noise_of_disk()),
                per_radius = float(1 / radius), unit = grid.frame.unit();
    const float4 normal = samples.normals[i];
    const Tangent_frame frame({normal.x, normal.y, normal.z});
    const float3 along_u = to_float(frame.u), along_v = to_float(frame.v),
                 across = to_float(frame.normal);
    const auto sum_up = [&](double share_of_radius, Sums_of_block<Moments>& sums_of_block) {
      const float reach = float(std::sqrt(square(share_of_radius * radius) + square(highest))),
                  per_squared_radius = float(1 / square(share_of_radius * radius));
      Moments sums;
      for_each_candidate(
        grid, blocks, center, query.lane, reach, [&](unsigned k, const int4& place) {
          const float3 d = difference(place, center, unit);
          const float4 other = disks.normals[k], scatter = disks.scatters[k];
          const float3 n = xyz(other), foot = d + other.w * n;
          const float cosine = dot(n, across), off = dot(d, across),
                      within = (dot(d, d) - off * off) * per_squared_radius,
                      near = fmaxf(1 - within, 0),
                      weight = where_less(fabsf(off), highest,
                                          where_less(-fabsf(cosine), -minimum_cosine_of_sheets,
                                                     scatter.x));
          sums.add(dot(foot, along_u) * per_radius, dot(foot, along_v) * per_radius,
                   off + cosine * other.w, scatter.y, scatter.z, scatter.w, near * near * weight);
        });
      sums_of_block.set(query,
                        sums.transformed<float>([](float sum) { return group_sum<lanes>(sum); }));
    };
    sum_up(1, sums_of_ball);
    sum_up(inner_share_of_split, sums_of_inner);
  }
  __syncthreads();
  const Single_query query(grid.size);
  if (!query.exists)
    return;
  const unsigned i = order ? order[query.index] : query.index;
  const double scale = samples.scale(i), noise = lengths.at(scale, 1).noise_of_disk(),
               squared_noise = square(noise);
  const auto scatter_of = [&](const Moments& sums) {
    return Scatter_in_ball(sums.transformed<double>([](float sum) { return double(sum); }),
                           squared_noise);
  };
  const Scatter_in_ball of_ball = scatter_of(sums_of_ball.of_query()),
                        of_inner = scatter_of(sums_of_inner.of_query());
  const Split_of_sheet split(of_ball, of_inner, squared_noise, lengths.unit * scale);
  splits[i] = split;
  if (!lengths.is_noise_known)
    samples.noise_ratios[i] = noise_ratio(of_ball, of_inner, split, noise);
}

/// The samples of one sheet around a sample that have to agree with it.
struct Majority
{
  double units; // within which they are
  float share, share_of_sure_ones;
};

/// \param order where each sample of the grid stands; null if each in its own place
/// \param normals, splits in the order of the grid
/// \param kept out: of each sample
__global__ void keep_agreed(Cell_grid grid, const unsigned* order, Cell_blocks blocks,
                            Majority majority, Lengths_of_refinement lengths, Samples samples,
                            const float4* normals, const Split_of_sheet* splits,
                            Split_of_sheet* kept)
{
  const Query query(samples.size);
  const unsigned i = order ? order[query.index] : query.index;
  const int4 center = grid.points[query.index];
  const Split_of_sheet own = splits[query.index];
  const bool is_split = own.half_distance > 0;
  const double radius = majority.units * lengths.unit * samples.scale(i);
  const float squared_radius = float(square(radius)), unit = grid.frame.unit();
  const float3 normal = xyz(normals[query.index]);
  float all = 0, flagged = 0, sure = 0;
  if (is_split)
    for_each_candidate(
      grid, blocks, center, query.lane, float(radius), [&](unsigned k, const int4& place) {
        const float3 d = difference(place, center, unit);
        const Split_of_sheet other = splits[k];
        const float counts = where_less(dot(d, d), squared_radius,
                                        where_less(-fabsf(dot(normal, xyz(normals[k]))),
                                                   -minimum_cosine_of_majority, 1.f));
        all += counts;
        flagged += other.half_distance > 0 ? counts : 0;
        sure += other.is_sure ? counts : 0;
      });
  all = group_sum<lanes>(all);
  flagged = group_sum<lanes>(flagged);
  sure = group_sum<lanes>(sure);
  if (query.writes)
    kept[i] = is_split && flagged > majority.share * all
                  && sure > majority.share_of_sure_ones * flagged
                ? own
                : Split_of_sheet();
}

__global__ void choose_first_sides(Samples samples, const Split_of_sheet* splits,
                                   signed char* sides)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  sides[i] = first_side(splits[i], samples.positions + 3 * i);
}

/// Each goes to the side that fewer of those around it are on.
__global__ void balance_sides(Cell_grid grid, Cell_blocks blocks, int turn,
                              Lengths_of_refinement lengths, Samples samples,
                              const signed char* sides, signed char* balanced)
{
  const Query query(samples.size);
  const unsigned i = query.index;
  const int4 center = grid.points[i];
  const signed char side = sides[i];
  const bool is_moving = side != 0 && is_balanced_in(turn, samples.positions + 3 * Wide(i));
  const double length = lengths.unit * samples.scale(i), radius = radius_of_balance * length;
  const float squared_radius = float(square(radius)), per_squared = float(1 / square(length)),
              unit = grid.frame.unit();
  const float3 normal = xyz(samples.normals[i]);
  float sum = 0;
  if (is_moving)
    for_each_candidate(
      grid, blocks, center, query.lane, float(radius), [&](unsigned k, const int4& place) {
        const float3 d = difference(place, center, unit);
        const float squared = dot(d, d),
                    cosine = float(sides[k]) * dot(normal, xyz(samples.normals[k]));
        sum += where_less(squared, squared_radius, cosine * decay(squared * per_squared));
      });
  const float others = group_sum<lanes>(sum) - float(side);
  if (query.writes)
    balanced[i] = !is_moving || others == 0 ? side : static_cast<signed char>(others > 0 ? -1 : 1);
}

__global__ void move_to_sides(Samples samples, const Split_of_sheet* splits,
                              const signed char* sides)
{
  const Wide i = thread_index();
  if (i >= samples.size)
    return;
  const int side = sides[i];
  if (side == 0)
    return;
  const float3 normal = xyz(samples.normals[i]);
  const double height = double(splits[i].middle) + side * double(splits[i].half_distance);
  double* const position = samples.positions + 3 * i;
  position[0] += height * double(normal.x);
  position[1] += height * double(normal.y);
  position[2] += height * double(normal.z);
  samples.normals[i] = with_w(float(side) * normal, 0);
  samples.sides[i] = Side_after_refinement::OUTWARDS;
}

} // namespace

Scattered_disks in_order_of(const Execution_context& context, const Cell_grid& grid,
                            const Scattered_disks& disks)
{
  const auto sorted = [&](const float4* values) {
    return gathered(context.arena, context.stream, grid.order, grid.size, values);
  };
  return {sorted(disks.normals), sorted(disks.scatters)};
}

void split_sheets(const Execution_context& context, const Lengths_of_refinement& lengths,
                  const Cell_grid& wide_grid, const unsigned* order, const Scattered_disks& disks,
                  const Cell_grid& region_grid, const unsigned* order_of_region,
                  const Cell_grid& sample_grid, bool splits, const Samples& samples)
{
  const cudaStream_t stream = context.stream;
  const unsigned m = samples.size;
  Device_arena& scratch = context.scratch;
  const Arena_scope scope(scratch);
  Split_of_sheet *found = scratch.take<Split_of_sheet>(m), *kept = scratch.take<Split_of_sheet>(m);
  const auto blocks_around = [&](const Cell_grid& grid, double units) {
    return find_blocks(grid, grid, cells_in_reach(units * lengths.unit, grid.frame.cell_size),
                       maximum_number_of_candidates, scratch, stream);
  };
  {
    const Arena_scope blocks_scope(scratch);
    const Cell_blocks blocks = blocks_around(wide_grid, radius_of_split);
    find_splits<<<blocks_for_queries(m), threads_per_block, 0, stream>>>(
      wide_grid, order, blocks, disks, lengths, samples, found);
    check_launch("find_splits");
  }
  if (!splits)
    return;
  {
    const Arena_scope blocks_scope(scratch);
    keep_agreed<<<blocks_for_queries(m), threads_per_block, 0, stream>>>(
      sample_grid, nullptr, blocks_around(sample_grid, radius_of_majority),
      {radius_of_majority, float(share_of_majority), 0}, lengths, samples, samples.normals, found,
      kept);
    check_launch("keep_agreed");
    std::swap(found, kept);
  }
  {
    const Arena_scope blocks_scope(scratch);
    const float4* normals = samples.normals;
    const Split_of_sheet* splits_in_order = found;
    if (order_of_region)
    {
      normals = gathered(scratch, stream, order_of_region, m, normals);
      splits_in_order = gathered(scratch, stream, order_of_region, m, splits_in_order);
    }
    keep_agreed<<<blocks_for_queries(m), threads_per_block, 0, stream>>>(
      region_grid, order_of_region, blocks_around(region_grid, radius_of_region),
      {radius_of_region, float(share_of_region), float(share_of_sure_ones)}, lengths, samples,
      normals, splits_in_order, kept);
    check_launch("keep_agreed");
    std::swap(found, kept);
  }

  // No side is set where nothing is split: the host need not wait to know that.
  signed char *sides = scratch.take<signed char>(m), *balanced = scratch.take<signed char>(m);
  choose_first_sides<<<blocks_for(m), threads_per_block, 0, stream>>>(samples, found, sides);
  check_launch("choose_first_sides");
  const Cell_blocks blocks = blocks_around(sample_grid, radius_of_balance);
  for (int turn = 0; turn < number_of_balances; ++turn)
  {
    balance_sides<<<blocks_for_queries(m), threads_per_block, 0, stream>>>(
      sample_grid, blocks, turn, lengths, samples, sides, balanced);
    check_launch("balance_sides");
    std::swap(sides, balanced);
  }
  move_to_sides<<<blocks_for(m), threads_per_block, 0, stream>>>(samples, found, sides);
  check_launch("move_to_sides");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
