// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_AGREEMENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_AGREEMENT_H

#include <CGAL/L0_resampling/internal/core/weights.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Samples that agree as much as this are of one sheet, whatever others say.
constexpr double beyond_doubt = 0.98;

/// The votes between two sets of samples are clear if one side is ahead by this share of all.
constexpr double clear_majority = 0.5;

/// How sure an edge is, 0 for the surest, in steps of 1/1024, which is all that a spanning forest
/// of noisy normals needs.
CGAL_L0_HOST_DEVICE inline unsigned step_of_agreement(float agreement)
{
  const unsigned number_of_steps = 1024;
  return unsigned((1 - at_most(std::abs(agreement), 1.f)) * (number_of_steps - 1));
}

/// How many times as many neighbors as in the graph have a vote on the side of a point at last. The
/// more there are, the less counts the noise of their normals; but trees that grow over as many
/// pass from one sheet of a plate to the other.
constexpr unsigned voters_per_neighbor = 2;

/// How often points are turned whose neighbors outvote them. Those that turn change the votes on
/// others; the third time hardly any does.
constexpr int sweeps_over_outvoted = 3;

/// The most samples, evenly spread, and the most sets that the field of sets is summed over.
constexpr unsigned maximum_number_of_dipoles = 4096, maximum_number_of_sets = 682;

/// The k-th of the samples that are dipoles. Samples are sorted by place: steps of equal length
/// through them spread the dipoles evenly.
CGAL_L0_HOST_DEVICE inline std::size_t sample_of_dipole(std::size_t k,
                                                        std::size_t number_of_samples,
                                                        std::size_t number_of_dipoles)
{
  return std::size_t((2 * std::uint64_t(k) + 1) * number_of_samples / (2 * number_of_dipoles));
}

/// The dipole that stands for a sample: the nearest one in their order.
CGAL_L0_HOST_DEVICE inline std::size_t dipole_of_sample(std::size_t i,
                                                        std::size_t number_of_samples,
                                                        std::size_t number_of_dipoles)
{
  return std::size_t(std::uint64_t(i) * number_of_dipoles / number_of_samples);
}

/// Sets of this many dipoles are large: there are no more of them than `maximum_number_of_sets`.
constexpr unsigned dipoles_of_large_set = 6;

/// How many dipoles a set has to have to be one of the field: all sets are, if they are few and
/// each sample is a dipole; else the large ones.
CGAL_L0_HOST_DEVICE inline unsigned minimum_number_of_dipoles_of_a_set(
  std::size_t number_of_samples, std::size_t number_of_sets)
{
  return number_of_samples <= maximum_number_of_dipoles && number_of_sets <= maximum_number_of_sets
           ? 1
           : dipoles_of_large_set;
}

/// Whether sets are large enough for the field to tell most samples what side they are on, by the
/// dipoles of large sets. They grow no further by single edges: a wrong one between two large sets
/// would turn a whole face, and the field could not part the two any more.
CGAL_L0_HOST_DEVICE inline bool are_sets_large(std::size_t dipoles_of_large_sets,
                                               std::size_t number_of_dipoles)
{
  return 10 * dipoles_of_large_sets >= 9 * number_of_dipoles;
}

/// Whether the field of the larger sets is that of their tree, by its dipoles. That of the
/// minority, single flat spots of a surface that bends within few spacings, tells nothing of the
/// side of what lies between them.
CGAL_L0_HOST_DEVICE inline bool stand_for_tree(std::size_t dipoles_of_sets,
                                               std::size_t dipoles_of_tree)
{
  return 2 * dipoles_of_sets >= dipoles_of_tree;
}

/// Sets of the field that disagree with the others by less than this, in edges, are left as they
/// are: that is rounding.
constexpr double minimum_disagreement = 1e-6;

/// Groups of sets that disagree with the others by less than this, in edges, are left as they are:
/// the field of few samples is not known to less.
constexpr double minimum_disagreement_of_groups = 5;

/// Of a set at a place, from the sum over its dipoles: these may crowd, but no part of a surface
/// winds more than once around a place.
CGAL_L0_HOST_DEVICE inline double winding_number_of_set(double sum)
{
  return at_least(at_most(sum, 1.), -1.);
}

/// The square of the mean winding number, per that of the mean square: more than the variance has.
constexpr double weight_of_mean_winding = 1.4;

/*!
How far two sets agree by the winding numbers that they have at the dipoles of their tree. Those of
the right sides are the same everywhere, and large: all sets have the least of

\f[ \sum_i w_i^2 - \frac{c}{n} \left( \sum_i w_i \right)^2 , \f]

which for \f$ c = 1 \f$ is their variance. That is least, too, where all are 0.

\param sum_of_products of the winding numbers of both
\param sum, other_sum of those of each
\param number_of_dipoles of the tree
*/
CGAL_L0_HOST_DEVICE inline double winding_agreement(double sum_of_products, double sum,
                                                    double other_sum, double number_of_dipoles)
{
  return 2 * (weight_of_mean_winding * sum * other_sum / number_of_dipoles - sum_of_products);
}

/// What turning a set has to bring at least, for each of its dipoles: winding numbers of sheets
/// that are nearly one are known to less.
constexpr double minimum_gain_of_windings = 0.15;

/// What the winding numbers of a dipole weigh beside edges. As many edges cross a line over a tree
/// as the square root of its number of samples says, so all its dipoles together weigh that much.
CGAL_L0_HOST_DEVICE inline double weight_of_windings(double number_of_samples,
                                                     double number_of_dipoles)
{
  using std::sqrt;
  return 500 * sqrt(number_of_samples) / number_of_dipoles;
}

/// How far two samples are of one sheet, in [0, 1], where each lies near the tangent plane of the
/// other.
/// \param squared_heights the sum of the squares of the heights over these planes
/// \param squared_spacing as for `orientation_agreement()`
template <typename T>
CGAL_L0_HOST_DEVICE inline T share_of_one_sheet(T squared_heights, T squared_spacing)
{
  return decay(squared_heights / squared_spacing * 2);
}

/*!
How far two samples agree about the side their normals point to: positive if the signs fit, negative
if one has to turn; the absolute value, in [0, 1], is how sure that is.

Where each lies near the tangent plane of the other they are of one sheet, whose normals are
parallel: \f$ n_i^T n_k \f$ decides (Hoppe et al. 1992). Where each lies well above or below, at the
heights \f$ h_i = n_i^T(p_k - p_i) \f$ and \f$ h_k = n_k^T(p_i - p_k) \f$, they are on two sides of
a fold or on the two sheets of a plate or a gap. Seen from the outside of a solid, both heights are
negative across a convex edge or a plate, and both positive across a concave edge or a gap. So there
\f$ 2 h_i h_k / (h_i^2 + h_k^2) \f$ decides, at any angle of the fold. In between, the two rules are
mixed. The second counts a tenth of the first: it decides where the first is silent, and on a rough
surface, where heights mean little, it is outvoted.

\param cosine \f$ n_i^T n_k \f$
\param height, other_height \f$ h_i, h_k \f$, lengths
\param squared_spacing of the samples: heights of a fraction of the spacing are noise
*/
template <typename T>
CGAL_L0_HOST_DEVICE inline T orientation_agreement(T cosine, T height, T other_height,
                                                   T squared_spacing)
{
  using std::isfinite;
  const T squared_heights = height * height + other_height * other_height,
          squared_noise = squared_spacing / 2;
  if (!(squared_noise > 0 && isfinite(squared_heights / squared_noise)))
    return cosine;
  const T one_sheet = share_of_one_sheet(squared_heights, squared_spacing),
          weight_of_folds = T(0.1);
  return one_sheet * cosine
         + weight_of_folds * (1 - one_sheet) * 2 * height * other_height
             / (squared_heights + squared_noise);
}

/// Of a number; lanes have their own.
template <typename T>
CGAL_L0_HOST_DEVICE inline T inverse_sqrt(T x)
{
  using std::sqrt;
  return 1 / sqrt(x);
}

/*!
How far two dipoles agree, as those do whose field has the least energy. On a flat or bent sheet,
across an edge and from one side of a solid to the other, that is when both point outwards. Their
energy is that of \f$ -n_i^T B_k \f$, where the flux density B of a dipole is spread out near it, as
that of a disk is,

\f[ B = \nabla \times \frac{n \times d}{r^3} = \frac{1}{r^3} \left( \frac{3 a^2}{r^2} n - n
+ 3 \frac{n^T d}{r^2} d \right), \qquad r^2 = d^T d + a^2 . \f]

It is that of a current and has no sources: through a plane of any height over the dipole flows as
much one way as the other. So the dipoles of a wide sheet have no field beyond it, however close,
and one of two sheets leaves it to the rims to say on which side the other one is.

\tparam T of numbers, or of lanes of them
\param cosine \f$ n_i^T n_k \f$
\param product_of_heights \f$ (n_i^T d)(n_k^T d) \f$
\param squared_distance \f$ d^T d \f$
\param squared_core \f$ a^2 \f$
*/
template <typename T, typename Scalar>
CGAL_L0_HOST_DEVICE inline T dipole_agreement(T cosine, T product_of_heights, T squared_distance,
                                              Scalar squared_core)
{
  const T inverse = inverse_sqrt(squared_distance + T(squared_core));
  const T squared_inverse = inverse * inverse;
  return (cosine - (cosine * squared_core + product_of_heights) * squared_inverse * Scalar(3))
         * (squared_inverse * inverse);
}

/// The winding number that a dipole, which stands for an area of 1, has at another place.
/// \param height \f$ n^T d \f$
template <typename T, typename Scalar>
CGAL_L0_HOST_DEVICE inline T winding_number_of_dipole(T height, T squared_distance,
                                                      Scalar squared_core)
{
  const T inverse = inverse_sqrt(squared_distance + T(squared_core));
  return height * (inverse * inverse * inverse) * Scalar(1 / (4 * 3.141592653589793));
}

/// How much another dipole of its set crowds a dipole. On a sheet that is evenly covered these sum
/// up to `crowding_of_even_sheet`, with that of the dipole itself.
template <typename T, typename Scalar>
CGAL_L0_HOST_DEVICE inline T crowding_of_dipole(T cosine, T squared_distance, Scalar squared_core)
{
  using std::sqrt;
  const T inverse = inverse_sqrt(squared_distance + T(squared_core));
  return cosine * (inverse * inverse * inverse) * Scalar(squared_core * sqrt(squared_core));
}
constexpr double crowding_of_even_sheet = 2;

/// The share of its area that a dipole stands for where they crowd, and the area is that of the
/// usual one.
CGAL_L0_HOST_DEVICE inline double share_of_dipole(double crowding)
{
  return crowding > crowding_of_even_sheet ? crowding_of_even_sheet / crowding : 1;
}

/// \f$ a^2 \f$ of a dipole that stands for a disk of that area: with the radius of the disk for
/// \f$ a \f$, the two have the same flux density at their centers.
CGAL_L0_HOST_DEVICE inline double squared_core_of_dipole(double area)
{
  return area / 3.141592653589793;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_AGREEMENT_H
