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

constexpr unsigned threads_for_sets = 704; // one for each set
static_assert(threads_for_sets >= maximum_number_of_sets, "too few threads for the sets");

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

__global__ void add_up_windings(Field_of_sets field)
{
  const unsigned set = unsigned(thread_index());
  if (set >= *field.number_of_sets)
    return;
  double sum = 0;
  for (unsigned dipole = 0; dipole < field.number_of_dipoles; ++dipole)
    sum += double(field.windings_at(dipole)[set]);
  field.sums_of_windings[set] = sum;
}

/// One block for each set, with a thread for each other one.
__global__ void add_windings_of_sets(Field_of_sets field, double samples_per_dipole)
{
  const unsigned size = *field.number_of_sets, a = blockIdx.x, b = threadIdx.x;
  if (a >= size || b >= size || field.trees[a] != field.trees[b])
    return;
  double count = 0; // of the dipoles of the tree
  for (unsigned set = 0; set < size; ++set)
    count += field.trees[set] == field.trees[a] ? field.numbers_of_dipoles[set] : 0;
  const double weight = weight_of_windings(samples_per_dipole * count, count);
  if (a == b)
  {
    field.with_signs[a] = __double2ll_rn(weight * least_gain_of_windings / 2 * field.signs[a]
                                         * field.numbers_of_dipoles[a] * units_per_vote);
    return;
  }
  double sum_of_products = 0;
#pragma unroll 8 // so that the memory has several reads to do at once
  for (unsigned dipole = 0; dipole < field.number_of_dipoles; ++dipole)
    sum_of_products += double(field.windings_at(dipole)[a]) * double(field.windings_at(dipole)[b]);
  field.row(a)[b] += __double2ll_rn(weight
                                    * winding_agreement(sum_of_products, field.sums_of_windings[a],
                                                        field.sums_of_windings[b], count)
                                    * units_per_vote);
}

} // namespace

void add_windings(const Field_of_sets& field, unsigned number_of_samples, cudaStream_t stream)
{
  find_windings<<<field.number_of_dipoles, threads_per_block, 0, stream>>>(field);
  check_launch("find_windings");
  add_up_windings<<<blocks_for(maximum_number_of_sets), threads_per_block, 0, stream>>>(field);
  check_launch("add_up_windings");
  add_windings_of_sets<<<maximum_number_of_sets, threads_for_sets, 0, stream>>>(
    field, double(number_of_samples) / double(field.number_of_dipoles));
  check_launch("add_windings_of_sets");
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
