// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PARAMETERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_PARAMETERS_H

#include <CGAL/L0_resampling/internal/core/Orientation_hints.h>
#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/random_bits.h>
#include <CGAL/L0_resampling/internal/core/weights.h>
#include <CGAL/L0_resampling/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The named parameters of a call, with their defaults.
struct Parameters
{
  Method method = Method::DEFAULT;

  std::size_t number_of_output_points = 0; ///< \f$ |P| \f$

  using Number = double;
  using Count = std::size_t;
  using Size = std::size_t;
  using Flag = bool;

#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED) Kind X = DEFAULT;
#include <CGAL/L0_resampling/value_parameters.h>

  bool is_noise_given_by_point = false; ///< and not one `noise` for all
  double outlier_sensitivity = 0;       ///< how readily points off the cloud are left out; 0: never
  bool has_viewpoint = false;
  Viewpoint viewpoint;               ///< that all normals shall face, if there is one
  bool hints_are_viewpoints = false; ///< whether the hints of the points lead to their viewpoints
  // whether they are asked for, of each point of the result
  bool with_feature_confidences = false, with_side_confidences = false, with_neighbor_radii = false,
       with_noises = false, with_deviations = false, with_creases = false, with_outliers = false;
};

// What the paper leaves open, as multiples of a radius. All are lengths.

/// The self neighbors of a sample lie within r_p/2 (Section 3.2).
constexpr double self_neighbor_radius_factor = 0.5;

/// First normals and areas are those of a ball of half the area: of r_p for PCA, as near an edge
/// fewer points of the other side spoil the first normal, and noise is the filter's job; and of r_q
/// for areas, as about as many points count there as count in Eq. (5), whose weights fall off.
constexpr double inner_radius_factor = 0.7;

/// A ball of fewer points determines no normal: through three noisy points a plane goes anywhere.
constexpr unsigned minimum_number_of_points_of_plane = 6;

/// How many of n points are left out at either end of an axis where the extent of the cloud is
/// measured: 0.5 %.
inline std::size_t margin_of_extent(std::size_t n) { return n / 200; }

/// \f$ \sigma_q \f$ is "a scaling of r_q" (Section 3.1).
constexpr double spatial_bandwidth_factor = 0.5;

/// The unit of length in which Eq. (9) reads its threshold \f$ \sqrt{\lambda/\beta} \f$, per r_p.
/// Printed without one, the threshold would mean another thing for every unit of the input. With
/// r_p/4 and the default weights no jump within r_p/2 survives the first iterations, and jumps
/// above 0.18 r_p survive the last.
constexpr double sparsity_unit_factor = 0.25;

// The default method

/// r_p covers this many spacings of clean points, and this many standard deviations of the noise of
/// dense ones; in between their powers of 3/2 add up: with a little noise already, more points than
/// three and a half spacings hold gain more than detail loses. Smaller radii follow finer detail,
/// larger ones average more noise away.
constexpr double radius_per_spacing = 3.5;
constexpr double radius_per_noise = 3.8;

/// The radius of the default method where points have this spacing and this noise.
CGAL_L0_HOST_DEVICE inline double wanted_radius(double spacing, double noise)
{
  const double of_spacing = radius_per_spacing * spacing, of_noise = radius_per_noise * noise;
  return std::cbrt(square(std::sqrt(of_spacing) * of_spacing + std::sqrt(of_noise) * of_noise));
}

/// The radius of the default method, in units of the paper's. It is rounded in steps of 0.2 to 0.4
/// % of itself, which is less than the error of spacing and noise: processors that round
/// differently, and clouds that are scaled by any factor, have the same radius, and with it the
/// same cells and the same first samples.
/// \param spacing, noise divided by the paper's radius, so that the steps scale with the cloud
inline double default_radius(double spacing, double noise)
{
  int exponent = 0;
  const double mantissa = std::frexp(wanted_radius(spacing, noise), &exponent);
  return std::ldexp(std::floor(512 * mantissa + 0.5), exponent - 9);
}

/// No default radius holds more noise.
constexpr double maximum_noise_per_radius = 1 / radius_per_noise;

/// No filter radius is smaller than this part of r_p: its square, in units of r_p, is a `float`.
constexpr double minimum_filter_radius_factor = 0x1p-40;

/// The fit is blind to points whose normal differs by much more than this many times
/// \f$ \sigma_n \f$. More than once, since the normals of a curved surface differ more over the
/// ball of the fit than filtered normals of one face do.
constexpr double fit_angle_factor = 2;

/// \f$ \sigma \f$ of the fit per r_p. A wider one averages more noise away and rounds corners more.
constexpr double fit_bandwidth_factor = 0.6;

/// Points of the other sheet of a thin plate agree with a normal too. The default method weighs
/// points by their height over the sheet, \f$ e^{-h^2/H^2} \f$, where H is this many standard
/// deviations of the noise and this share of r_p; the two add up as squares. A larger share would
/// make one of two clean sheets, a smaller one takes points of a curved sheet for another.
constexpr double sheet_height_per_noise = 1.9;
constexpr double sheet_height_per_radius = 0.2;

inline double sheet_height(double noise, double radius)
{
  return std::hypot(sheet_height_per_noise * noise, sheet_height_per_radius * radius);
}

/// Within so many r_p the place is looked for that has most of the samples that their points do not
/// agree with: a few balls of the fit, so that a sample by chance is none.
constexpr double unexplained_radius_factor = 4;

/// Two sheets are told apart from this share of H on. A jump of more between two samples is one to
/// another sheet, or across an edge, and no noise: the default method shrinks no such jump, however
/// small the penalty still is, and its regularization lets go of such pairs, which would draw two
/// sheets together. A larger share joins sheets. With a smaller one the samples of a face, which
/// have no hold beyond its edges, draw each other away from them.
constexpr double minimum_height_between_sheets = 0.7;

/// The default method begins to shrink jumps less at two thirds of the threshold, and ends at twice
/// as much. A step, as in Eq. (9), would put a sample here or there by a rounding.
constexpr double half_width_of_firm_shrinkage = 1. / 3;

/// A point is an outlier if its ball holds fewer points than this share of the mean ball around it,
/// or of the median ball. At a border and its corners a ball is a half or a quarter full; between
/// the ends of a scan densities may differ by ten.
constexpr double outlier_share_of_surroundings = 0.3;
constexpr double outlier_share_of_median = 0.05;

/// Points whose ball holds less than this share of the median ball are of the sparse end of a scan,
/// or of a crowd of outliers that has enough of its own around each. Such a ball tells no noise.
constexpr double share_of_sparse_points = 0.15;

/// A ball with less than this share of the mean ball around it is on a sparse surface where a dense
/// one is near. Half of the balls at a seam would be, so it is more than makes an outlier.
constexpr double sheet_share_of_surroundings = 0.5;

/// Sparse points that are in a sheet are no outliers. Its points are within so many times the
/// geometric mean of r_p and the radius of a point, which a tile of a cloud sees around its own: a
/// surface sixty times as sparse as most of the cloud, and at its border.
constexpr double radii_of_sparse_sheet = 10;

/// Sparse points fill space, and are outliers, if balls of 2 r_p hold more than this many times as
/// many of the others as those of r_p/2 do. It is 16 in a sheet, up to 40 if the sheet is noisy or
/// becomes denser, and 64 where points fill space.
constexpr double volume_filling_ratio = 50;
/// Additive smoothing of the number of points in the small balls, which may be few.
constexpr double count_prior = 3;

/// Up to this sensitivity a ball need not hold as many points as those around it do.
constexpr double maximum_outlier_sensitivity = 3;

/// Thresholds of the outlier test. The set of outliers grows with the sensitivity: an outlier at
/// one value is one at all larger values.
struct Outlier_thresholds
{
  double share_of_surroundings, share_of_median; ///< of the points that balls hold, at least
  double volume_filling_ratio;                   ///< of sparse points, at most
  double share_of_part; ///< of the points of a median ball that a part has, at least

  /// \param sensitivity above 0
  CGAL_L0_HOST_DEVICE explicit Outlier_thresholds(double sensitivity)
    : share_of_surroundings(sensitivity * outlier_share_of_surroundings),
      share_of_median(sensitivity * outlier_share_of_median),
      volume_filling_ratio(internal::volume_filling_ratio / sensitivity),
      share_of_part(sensitivity / 2)
  {}
};

/// Points of one sheet that scatter about it by H/2, with the weights \f$ e^{-h^2/H^2} \f$, have
/// the first of these variances, in units of \f$ H^2 \f$. Those of two sheets have more, and from
/// the second on their sheets are as low as the height from which on two are told apart.
constexpr double variance_of_one_sheet = 1. / 6, variance_of_two_sheets = 1. / 5;

/// \f$ H^2 \f$ of a sample whose points scatter.
/// \param squared_sheet_height \f$ H^2 \f$ of all
/// \param variance of the heights of its points, weighted with that
CGAL_L0_HOST_DEVICE inline double squared_sheet_height_among(double squared_sheet_height,
                                                             double variance)
{
  const double t = as_share((variance / squared_sheet_height - variance_of_one_sheet)
                            / (variance_of_two_sheets - variance_of_one_sheet));
  return squared_sheet_height
         * (1 - t * (1 - minimum_height_between_sheets * minimum_height_between_sheets));
}

/// Fewer points do not count as compatible: a sample with less weight of them is lonely.
constexpr double minimum_weight_of_compatible_points = 1e-3;

/// A weighted mean of unit normals that is shorter has no direction.
constexpr double minimum_length_of_mean_normal = 1e-3;

/// Cosine of the angle between similar normals: 30 degrees, what survives bilateral filtering on
/// one side of an edge.
constexpr double cosine_of_similar_normals = 0.87;

/// A ball whose points have no plane becomes twice as large for PCA, up to so many times.
constexpr int number_of_radius_doublings = 10;

/// Up to so many cells away they are looked at in the grid of the points: to sort all points anew
/// costs more for a few of them.
constexpr int farthest_reach_of_refits = 3;

/// Where more points share a block of cells, balls are made of some of them. Well above what any
/// sensible radius gathers: the paper's, at ten million points, gathers about 600.
constexpr unsigned maximum_number_of_candidates = 4096;

/// Where more samples share a block of cells, each looks for its self neighbors in a smaller ball.
constexpr unsigned maximum_number_of_self_candidates = 1024;

/// A sample is unsupported if the points that agree with it weigh less than this share of those in
/// its ball, and begins to be at twice as much. On a face it is a quarter, at an edge an eighth.
constexpr double share_of_unsupported = 0.04;

/// Whether a sample is unsupported, and how it finds its points: by the normal of most of them and
/// its own, in a sheet that is higher than that of others.
struct Unsupported_sample
{
  bool is_unsupported;
  double weight_of_own_normal = 0; ///< beside those of the points
  double squared_sheet_height;

  /// \param weight of the points that agree with it
  /// \param all the weight of all points of its ball
  /// \param sheet_height H, squared, as of samples that are supported
  CGAL_L0_HOST_DEVICE Unsupported_sample(double weight, double all, double sheet_height,
                                         double squared_radius)
    : squared_sheet_height(sheet_height)
  {
    const double t = 2 - weight / (share_of_unsupported * all);
    is_unsupported = t > 0;
    if (t >= 1)
      squared_sheet_height = squared_radius;
    else if (is_unsupported)
    {
      weight_of_own_normal = all * (1 - t) / t;
      squared_sheet_height *= std::pow(squared_radius / sheet_height, t);
    }
  }
};

/// A first normal counts in full if the two smaller variances of its points differ by this share of
/// the largest, and the less the nearer they are: a strip has no plane.
constexpr double minimum_gap_of_plane = 0.1;

/// At the end the default method looks for planes and quadrics in balls of this many r_p. In wider
/// ones more surfaces are neither; smaller ones average less noise away.
constexpr double quadric_radius_factor = 4;

/// How far from a plane or a quadric samples may be that lie in it, per what noise leaves of the
/// fit.
constexpr double maximum_roughness = 3;

/// From where on a plane or a quadric counts less, and at twice this not at all: what variance its
/// height has at the sample, per that of the mean height of the support points. Inside of a surface
/// it is 1 and 4 to 5, at an edge 4 and 9 to 16; where the support points are all on one side and
/// further off it grows fast.
constexpr double maximum_leverage = 10;

/// The support subset is of at least this many places in a ball, if the ball has as many, and of
/// less than twice as many. On a tenth or two of them no sample starts.
constexpr double minimum_support_points_in_ball = 160;

/// Chooses the support subset among the samples that start on a point each: by that point, so
/// that no rounding of where they are now has a part in it.
struct Support_subset
{
  std::uint64_t seed;
  std::uint64_t stride = 1; ///< every `stride`-th sample is used

  /// \param spacing of an even set of samples
  /// \param number_of_places where points are: no more samples start on a point
  Support_subset(std::uint64_t random_seed, double radius, double spacing,
                 std::size_t number_of_samples, std::size_t number_of_places)
    : seed(random_seed)
  {
    const double pi = 3.141592653589793, reach = quadric_radius_factor * radius / spacing;
    const double in_ball = pi * reach * reach
                           * (std::min)(double(number_of_places) / double(number_of_samples), 1.);
    // a power of two, since few numbers are so near to one that a rounding decides
    while (double(2 * stride) * minimum_support_points_in_ball <= in_ball
           && stride < (std::uint64_t(1) << 20))
      stride *= 2;
  }

  CGAL_L0_HOST_DEVICE bool takes(std::uint64_t source) const
  {
    return random_bits(seed, ~source) % stride == 0;
  }
};

/// The default method corrects normals by positions: those of the points before each of the last
/// filter passes, as many times, and those of the samples in as many passes after each fit.
constexpr std::size_t number_of_normal_refits = 2;

/// \f$ \mu \f$ of the default method: fewer turns than the paper's 1.5 makes, each of which fits
/// anew.
constexpr double default_penalty_growth = 2.7;

/// Line 5 of Algorithm 1. The product of a subnormal number and a growth near 1 can be that number
/// again: then it is the next one.
inline double next_penalty(double penalty, double growth)
{
  return (std::max)(penalty * growth,
                    std::nextafter(penalty, std::numeric_limits<double>::infinity()));
}

/// Radius of the self neighbors, per spacing of the samples, at least.
constexpr double self_neighbor_radius_per_spacing = 2;

/// Of a sample that repels others within a radius of its own.
/// \param area of the surface that it stands for, which rounds to 0 where points are very dense
CGAL_L0_HOST_DEVICE inline float spreading_radius_of(double area, double largest)
{
  const double radius = self_neighbor_radius_per_spacing * std::sqrt(area), least = largest / 1024;
  return float(radius > largest ? largest : radius < least ? least : radius);
}

/// Of the default method in each turn, and each time before the refinement, whose fits do not draw
/// samples back that were pushed over a border.
constexpr std::size_t number_of_repulsion_steps = 3, number_of_repulsion_steps_of_refinement = 1;

/// How the samples repel each other: the push of one from a neighbor at distance d is
/// \f$ \mathrm{strength} \cdot d \, e^{-d^2 / \mathrm{squared\_bandwidth}} \f$, and the sum of all
/// is cut at `maximum_step`. Chosen by the evenness they reach, and so that no sample is pushed out
/// of the reach of the fit.
struct Repulsion
{
  double squared_bandwidth, strength, maximum_step;

  /// \param spacing of an even set of that many samples
  /// \param radius of the fit
  CGAL_L0_HOST_DEVICE Repulsion(double spacing, double radius) : strength(0.7)
  {
    // Samples that a huge radius has made one point for it have no spacing to speak of; its square
    // must not be zero.
    spacing = (std::max)(spacing, 1e-9 * radius);
    squared_bandwidth = 0.8 * spacing * spacing;
    maximum_step = (std::min)(0.3 * spacing, 0.15 * radius);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PARAMETERS_H
