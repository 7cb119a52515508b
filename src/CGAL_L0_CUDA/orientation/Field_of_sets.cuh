// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_FIELD_OF_SETS_CUH
#define CGAL_L0_CUDA_FIELD_OF_SETS_CUH

#include "orientation/orientation.cuh"

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

constexpr unsigned no_set = ~0u;
/// A dipole of the field.
struct Dipole_of_field
{
  double3 position, normal; // that in the sense of its set
  double area;              // that it stands for
  unsigned tree;            // of its set, if that has another set of the field in it; or `no_set`
  unsigned set;
};

/// The larger sets of samples, and how far they agree two by two, in fixed point.
struct Field_of_sets
{
  Dipole_of_field* dipoles;
  unsigned* roots_of_dipoles;
  unsigned* trees_of_dipoles;
  unsigned number_of_dipoles;
  unsigned*
    // of each dipole that is the first one of its set: how many dipoles that has; of others 0
    sizes_of_sets;
  unsigned* number_of_all_sets;  // that have a dipole
  unsigned char* stands_for_set; // of each dipole: the first one of a set of the field
  double area;                   // that a dipole usually stands for
  double spacing;                // of the samples
  unsigned*
    set_of_root; // of each sample that is a root: its number among the larger sets, or `no_set`
  unsigned* number_of_sets;
  unsigned* roots;              // of the sets
  unsigned* trees;              // that they belong to
  unsigned* numbers_of_dipoles; // that they have
  int* signs;                   // relative to the tree
  long long*
    // a row of `maximum_number_of_sets` for each set; those of a and b, and of b and a, stand for
    // each other
    agreements;
  long long* links;       // of groups of sets, as many
  long long* unary_terms; // of each set with the sign 1
  // of each dipole: the winding number of each set there; a row of `maximum_number_of_sets`
  float* windings;

  __device__ float* windings_at(Wide dipole) const
  {
    return windings + dipole * maximum_number_of_sets;
  }
  __device__ long long* row(unsigned set) const
  {
    return agreements + Wide(set) * maximum_number_of_sets;
  }
  __device__ bool are_of_one_tree(unsigned a, unsigned b) const
  {
    return a != no_set && b != no_set && a != b && trees[a] == trees[b];
  }
};

/// Adds to the agreements what the winding numbers of the sets say, as `Windings_of_sets` on the
/// CPU.
void add_windings(const Field_of_sets& field, unsigned number_of_samples, cudaStream_t stream);

/// Turns the set that disagrees most, or the group of them, one after the other, until none does.
/// \param number_of_turns on the device, in and out
void flip_disagreeing_sets(const Field_of_sets& field, unsigned* number_of_turns,
                           cudaStream_t stream);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_FIELD_OF_SETS_CUH
