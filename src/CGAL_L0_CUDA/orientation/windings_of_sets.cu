// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/add_up_by_sets.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

// of a block that adds up over dipoles: so many sets, and threads for each
constexpr unsigned sets_of_block = 32, threads_of_set = 16;

/// One block for each dipole: the winding number there of each set of its tree.
__global__ void find_windings(Field_of_sets field)
{
  __shared__ long long sums[maximum_number_of_sets];
  const Dipole_of_field a = field.dipoles[blockIdx.x];
  const unsigned size = *field.number_of_sets;
  float* const windings = field.windings_at(blockIdx.x);
  if (a.tree == no_set)
  {
    for (unsigned set = threadIdx.x; set < size; set += blockDim.x)
      windings[set] = 0;
    return;
  }
  const double squared_core = squared_core_of_dipole(field.area);
  const auto units_of_winding = [&](const Dipole_of_field& b) {
    const double3 d = b.position - a.position;
    const double winding = winding_number_of_dipole(dot(b.normal, d), dot(d, d), squared_core)
                           * b.area;
    return isfinite(winding) ? __double2ll_rn(winding * units_per_vote) : 0ll;
  };
  add_up_by_sets(field, 0, a.tree, units_of_winding, sums);
  for (unsigned set = threadIdx.x; set < size; set += blockDim.x)
    windings[set] = float(winding_number_of_set(double(sums[set]) / units_per_vote));
}

/// One block for each set and some others.
__global__ void add_windings_of_sets(Field_of_sets field, double samples_per_dipole)
{
  struct Sums
  {
    double of_a, of_b, of_products;
  };
  __shared__ Sums of_threads[threads_of_set][sets_of_block];
  const unsigned size = *field.number_of_sets, a = blockIdx.x, first = blockIdx.y * sets_of_block,
                 b = first + threadIdx.x;
  if (a >= size || first >= size) // whole blocks leave
    return;
  Sums sums = {0, 0, 0};
  const unsigned end = b < size ? field.number_of_dipoles : 0;
#pragma unroll 4 // so that the memory has several reads to do at once
  for (unsigned dipole = threadIdx.y; dipole < end; dipole += threads_of_set)
  {
    const double of_a = double(field.windings_at(dipole)[a]),
                 of_b = double(field.windings_at(dipole)[b]);
    sums.of_a += of_a;
    sums.of_b += of_b;
    sums.of_products += of_a * of_b;
  }
  of_threads[threadIdx.y][threadIdx.x] = sums;
  __syncthreads();
  if (threadIdx.y > 0 || b >= size || field.trees[a] != field.trees[b])
    return;
  for (unsigned thread = 1; thread < threads_of_set; ++thread)
  {
    const Sums& others = of_threads[thread][threadIdx.x];
    sums.of_a += others.of_a;
    sums.of_b += others.of_b;
    sums.of_products += others.of_products;
  }
  double count = 0; // of the dipoles of the tree
  for (unsigned set = 0; set < size; ++set)
    count += field.trees[set] == field.trees[a] ? field.numbers_of_dipoles[set] : 0;
  const double weight = weight_of_windings(samples_per_dipole * count, count);
  if (a == b)
    field.unary_terms[a] = __double2ll_rn(weight * minimum_gain_of_windings / 2 * field.signs[a]
                                          * field.numbers_of_dipoles[a] * units_per_vote);
  else
    field.row(a)[b] += __double2ll_rn(
      weight * winding_agreement(sums.of_products, sums.of_a, sums.of_b, count) * units_per_vote);
}

} // namespace

void add_windings(const Field_of_sets& field, unsigned number_of_samples, cudaStream_t stream)
{
  find_windings<<<field.number_of_dipoles, threads_per_block, 0, stream>>>(field);
  check_launch("find_windings");
  const dim3 blocks(maximum_number_of_sets,
                    (maximum_number_of_sets + sets_of_block - 1) / sets_of_block);
  add_windings_of_sets<<<blocks, dim3(sets_of_block, threads_of_set), 0, stream>>>(
    field, double(number_of_samples) / double(field.number_of_dipoles));
  check_launch("add_windings_of_sets");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
