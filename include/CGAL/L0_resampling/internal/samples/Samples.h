// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SAMPLES_H
#define CGAL_L0_RESAMPLING_INTERNAL_SAMPLES_H

#include <CGAL/L0_resampling/internal/kernels/side_of_normal.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// S, with what the fit term of Eq. (6) ties it to.
/// \tparam FT the number type of the solver, for all but places in space: `float` cannot tell
/// neighbors apart far from the origin
template <typename FT>
struct Samples
{
  using Local_vector = Eigen::Matrix<FT, 3, 1>;

  Buffer<Vector> positions;     ///< \f$ p_i \f$
  Buffer<Local_vector> normals; ///< \f$ n_i \f$, unit length
  Buffer<FT> fit_weights;       ///< \f$ W_i \f$
  Buffer<Vector> fit_centroids; ///< \f$ c_i \f$
  Buffer<FT> fit_variances;     ///< default method only: of the height of \f$ c_i \f$
  Buffer<Local_vector>
    /// default method only: where an edge or a border is near, the way towards it, whose squared
    /// length is the share of a push there that is left out; else zero
    outward_directions;

  Buffer<float>
    /// of each sample, which is that of the point it starts from; none if all are 1
    scales;
  Buffer<unsigned char>
    /// default method only: whether quadrics are fitted to the sample, which few of many are
    are_support_points;
  Buffer<float>
    /// where the density of the input is kept: how far around each sample others repel it; else
    /// none
    spreading_radii;
  Buffer<Local_vector>
    /// unit or zero vectors on the side that the normals shall point to, or to the viewpoints, if
    /// the caller has some; else none
    hints;

  Buffer<float>
    /// default method only: of the noise around the sample to that of the cloud
    noise_ratios;
  Buffer<Side_after_refinement> sides; ///< while they are refined
  Buffer<float>
    /// how sure the sides are, and what the points of the last fit scatter; none unless asked for
    side_confidences, noises;
  Buffer<float>
    /// how far each sample and its normal may be off, see `Deviations`; none unless asked for
    position_deviations, normal_deviations;

  Buffer<Index>
    start_indices; ///< where samples follow others: the place of each in the first order; else none

  explicit Samples(const Counting_allocator<Vector>& allocator)
    : positions(allocator), normals(allocator), fit_weights(allocator), fit_centroids(allocator),
      fit_variances(allocator), outward_directions(allocator), scales(allocator),
      are_support_points(allocator), spreading_radii(allocator), hints(allocator),
      noise_ratios(allocator), sides(allocator), side_confidences(allocator), noises(allocator),
      position_deviations(allocator), normal_deviations(allocator), start_indices(allocator)
  {}
};

/// Puts sample `order[i]` in place `i`.
template <typename ConcurrencyTag = Sequential_tag, typename FT>
void apply_order(const Buffer<Index>& order, Samples<FT>& samples)
{
  apply_order<ConcurrencyTag>(order, samples.positions);
  apply_order<ConcurrencyTag>(order, samples.normals);
  apply_order<ConcurrencyTag>(order, samples.fit_weights);
  apply_order<ConcurrencyTag>(order, samples.fit_centroids);
  const auto apply_to_what_there_is = [&](auto& values) {
    if (!values.empty())
      apply_order<ConcurrencyTag>(order, values);
  };
  apply_to_what_there_is(samples.fit_variances);
  apply_to_what_there_is(samples.outward_directions);
  apply_to_what_there_is(samples.scales);
  apply_to_what_there_is(samples.are_support_points);
  apply_to_what_there_is(samples.spreading_radii);
  apply_to_what_there_is(samples.hints);
  apply_to_what_there_is(samples.noise_ratios);
  apply_to_what_there_is(samples.sides);
  apply_to_what_there_is(samples.side_confidences);
  apply_to_what_there_is(samples.noises);
  apply_to_what_there_is(samples.position_deviations);
  apply_to_what_there_is(samples.normal_deviations);
  apply_to_what_there_is(samples.start_indices);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SAMPLES_H
