// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLE_POINT_SET_H
#define CGAL_L0_RESAMPLE_POINT_SET_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Near_points.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/interface/Point_data.h>
#include <CGAL/L0_resampling/internal/interface/carry_properties.h>
#include <CGAL/L0_resampling/internal/interface/checked_types.h>
#include <CGAL/L0_resampling/internal/interface/output_iterators.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/interface/resample_on_cpu.h>
#include <CGAL/L0_resampling/named_parameters.h>
#include <CGAL/L0_resampling/tags.h>
#include <CGAL/L0_resampling/warnings.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <type_traits>

#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/CUDA_resampler.h>
#endif

namespace CGAL {

namespace L0_resampling {
namespace internal {

/// Chooses where the stages run.
template <typename ConcurrencyTag, typename Kernel, typename PointRange, typename PointMap,
          typename NormalMap, typename Write, typename NamedParameters>
void l0_resample_point_set(const PointRange& range, PointMap point_map, NormalMap normal_map,
                           std::size_t near_count, const Write& write, const NamedParameters& np)
{
  if constexpr (!std::is_same<ConcurrencyTag, CUDA_tag>::value)
    resample_range_on_cpu<ConcurrencyTag, Kernel,
                          Block_chebyshev_solver_traits<Local, ConcurrencyTag>>(
      range, point_map, normal_map, near_count, write, np);
  else
  {
#ifdef CGAL_L0_LINKED_WITH_CUDA
    CUDA_resampler<Kernel> resampler;
    resampler.upload(range, point_map, normal_map, np);
    resampler.resample(range, point_map, near_count, write, np);
#else
    static_assert(
      !std::is_same<ConcurrencyTag, CUDA_tag>::value,
      "CUDA_tag needs a compiled library: link with the CMake target CGAL::L0_CUDA_support.");
#endif
  }
}

/// As above, to an output iterator.
template <typename ConcurrencyTag, typename Kernel, typename PointRange, typename PointMap,
          typename NormalMap, typename OutputIterator, typename NamedParameters>
OutputIterator resample_to_iterator(const PointRange& range, PointMap point_map,
                                    NormalMap normal_map, OutputIterator out,
                                    const NamedParameters& np)
{
  const auto write = [&](std::size_t size, const auto& pair_of, const Point_data& data) {
    write_point_data(np, data, size, [](std::size_t i) { return i; });
    write_creases<Kernel>(np, data.creases);
    write_outliers(np, data.outliers);
    write_result<Kernel>(size, pair_of, out);
  };
  l0_resample_point_set<ConcurrencyTag, Kernel>(range, point_map, normal_map, 0, write, np);
  return out;
}

} // namespace internal
} // namespace L0_resampling

/*!
\ingroup PkgL0ResamplingRef

resamples a point set: from raw, noisy, unoriented points to a given number of clean, evenly spread
points with oriented normals that keep sharp features. It implements *Efficient L0 resampling of
point sets* \cgalCite{cgal:czlwl-elrps-19}.

The input is neither changed nor reordered. The result does not depend on its order, on the signs of
given normals, on the number of threads or on the run; it scales and moves with the input. What
`warnings()` says of the `resampling_report` are reasons why the result cannot be good.

\tparam ConcurrencyTag says where the stages run: `Sequential_tag`, `Parallel_tag` or
`Parallel_if_available_tag`; or `CUDA_tag`, in programs that link with `CGAL::L0_CUDA_support`. On
the device the solver is fixed, `maximum_memory` is of the device, and `Device_error` is thrown
where none can be used.
\tparam PointRange is a model of `ConstRange` with forward iterators. Unless the tag is
`Sequential_tag`, all threads read it if the iterators have random access: property maps have to
allow `get()` on several threads at the same time.
\tparam OutputIterator accepts `std::pair<Point_3, Vector_3>`, or else `Point_3`. A
`boost::function_output_iterator` accepts what its function does.

\param points the input. Any number of points, from none.
\param out takes one pair for each point of the result: its position and its normal of unit length;
or the position alone, if it does not accept pairs.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below. Those that CGAL lacks start a chain, or are joined to one by `|`, one at a time:
`parameters::neighbor_radius(0.1) | parameters::normal_weight(0.5)`. All but `point_map`,
`geom_traits` and `sparse_linear_solver` may also be given as a `std::optional` of their type; one
without a value leaves the default.

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of the range `points`}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and
      `Point_3` as value type}
    \cgalParamDefault{`CGAL::Identity_property_map<Point_3>`; of a `Point_set_3` its own}
  \cgalParamNEnd
  \cgalParamNBegin{normal_map}
    \cgalParamDescription{a property map associating normals to the elements of the range `points`;
      they replace the PCA normals. Length and sign do not matter. A zero or non-finite normal is
      replaced by PCA.}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and
      `Vector_3` as value type}
    \cgalParamDefault{none: normals are estimated by PCA}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{a kernel whose `FT` is `float` or `double`; one with an exact number type
      is refused at compile time}
    \cgalParamType{a model of `Kernel`}
    \cgalParamDefault{the kernel of the point type}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_output_points}
    \cgalParamDescription{the number of points of the result, exactly. More than the input has may
      be asked for: the further ones start between existing points.}
    \cgalParamType{any integral type}
    \cgalParamDefault{what `select_percentage` gives}
    \cgalParamExtra{`std::invalid_argument` if negative or above \f$ 2^{32} - 2 \f$; 0 gives an
      empty result}
  \cgalParamNEnd
  \cgalParamNBegin{select_percentage}
    \cgalParamDescription{the number of points of the result,
      \f$ \max(1, \lfloor n \cdot \mathrm{percentage} / 100 \rfloor) \f$ of n}
    \cgalParamType{`double`}
    \cgalParamDefault{50}
    \cgalParamExtra{`std::invalid_argument` if not in (0, 100]}
  \cgalParamNEnd
  \cgalParamNBegin{resampling_method}
    \cgalParamDescription{`LOR`, Section 3 of the paper; `ALOR`, Section 4; or `DEFAULT`, what this
      package recommends, which runs Algorithm 1 on the same energy but leaves outliers out,
      corrects the normals by the positions, starts evenly, fits to points of the same side and
      sheet only, looks for neighbors anew in every iteration, spreads the samples by repulsion,
      takes the radius from the spacing and the noise of the points, and at last refines the samples
      by surfaces that are fitted around each of them in balls of several sizes. ALOR's local
      half-sampling leaves Eq. (10) as it is once the fit term is collapsed, so it is carried out
      only for solvers that need the rows of Eq. (11).}
    \cgalParamType{`CGAL::L0_resampling::Method`}
    \cgalParamDefault{`Method::DEFAULT`}
  \cgalParamNEnd
  \cgalParamNBegin{neighbor_radius}
    \cgalParamDescription{\f$ r_p \f$: the fit looks at the input points within \f$ r_p \f$ of a
      sample. The other terms look at the samples within \f$ r_p / 2 \f$ (`LOR`, `ALOR`) or within 2
      spacings of the samples, at most \f$ r_p \f$ (`DEFAULT`). Around points whose spacing or noise
      differ from those of the cloud, `DEFAULT` takes a larger or a smaller radius, as many times as
      the formula below gives there.}
    \cgalParamType{`double`, a length in the unit of the points}
    \cgalParamDefault{`LOR` and `ALOR`: \f$ l_{diag} / \sqrt[3]{n} \f$, where far outliers do not
      count for the diagonal of the bounding box. `DEFAULT`:
      \f$ ((3.5s)^{3/2} + (3.8\sigma)^{3/2})^{2/3} \f$ with the spacing s and the noise
      \f$ \sigma \f$ estimated from the points}
    \cgalParamExtra{`std::invalid_argument` if not finite or not positive; values beyond the
      diagonal are taken as the diagonal}
  \cgalParamNEnd
  \cgalParamNBegin{noise}
    \cgalParamDescription{the standard deviation of the points across the surface, where it is
      known, as from the scanner's maker. It takes the place of what is estimated from the points,
      for the whole cloud and in each part of it: in the radius, in the heights of sheets, and in
      the refinement.}
    \cgalParamType{`double`, a length in the unit of the points}
    \cgalParamDefault{estimated from the points}
    \cgalParamExtra{`std::invalid_argument` if not finite or not positive, or beside `LOR` and
      `ALOR`, which do not use it; values beyond the diagonal are taken as the diagonal}
  \cgalParamNEnd
  \cgalParamNBegin{point_noise_map}
    \cgalParamDescription{a property map associating to the elements of the range `points` the
      standard deviation of each across the surface, where it is known, as from the error model of a
      scanner. As `noise`, which is their median then, but other radii, and another noise in the
      refinement, where the points have another one. A number that is not positive or not finite
      says nothing.}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and a
      floating-point value type, a length in the unit of the points}
    \cgalParamDefault{estimated from the points}
    \cgalParamExtra{`std::invalid_argument` if `noise` is there too, beside `LOR` and `ALOR`, and
      with `CUDA_tag`}
  \cgalParamNEnd
  \cgalParamNBegin{normal_filter_radius}
    \cgalParamDescription{\f$ r_q \f$, the radius of the bilateral filter of normals and of the
      density weights of Eq. (5)}
    \cgalParamType{`double`, a length in the unit of the points}
    \cgalParamDefault{\f$ r_p \f$}
    \cgalParamExtra{`std::invalid_argument` if not finite or not positive}
  \cgalParamNEnd
  \cgalParamNBegin{sharpness_angle}
    \cgalParamDescription{\f$ \sigma_n \f$ of Eq. (2): normals that differ by much more are not
      averaged. Smaller values keep blunter edges.}
    \cgalParamType{`double`, in degrees}
    \cgalParamDefault{15}
    \cgalParamExtra{`std::invalid_argument` if not in (0, 90]}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_normal_filter_iterations}
    \cgalParamDescription{how often Eq. (1) is applied to all normals; 0 leaves them as they are.
      Before each of the last two times, the default method corrects the normals by planes through
      the points that agree with them.}
    \cgalParamType{any integral type}
    \cgalParamDefault{3}
    \cgalParamExtra{`std::invalid_argument` if negative or above 10000}
  \cgalParamNEnd
  \cgalParamNBegin{normal_weight}
    \cgalParamDescription{\f$ \lambda \f$ of Eq. (6), the price of a jump across the tangent plane
      of a neighbor. Larger values give sharper edges and flatter faces, in the default method up to
      a limit that grows with the noise; smaller ones stay closer to the input. Read in the unit
      \f$ r_p / 4 \f$, so that it does not depend on the unit of the points.}
    \cgalParamType{`double`}
    \cgalParamDefault{0.9}
    \cgalParamExtra{`std::invalid_argument` if negative or not finite}
  \cgalParamNEnd
  \cgalParamNBegin{regularization_weight}
    \cgalParamDescription{\f$ \alpha \f$ of Eq. (6): larger values draw neighbors together more}
    \cgalParamType{`double`}
    \cgalParamDefault{0.15}
    \cgalParamExtra{`std::invalid_argument` if negative or not finite}
  \cgalParamNEnd
  \cgalParamNBegin{initial_penalty}
    \cgalParamDescription{the first \f$ \beta \f$ of Algorithm 1}
    \cgalParamType{`double`}
    \cgalParamDefault{0.1}
    \cgalParamExtra{`std::invalid_argument` if not finite or not positive}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_penalty}
    \cgalParamDescription{Algorithm 1 ends once \f$ \beta \f$ is above; it runs one iteration at
      least}
    \cgalParamType{`double`}
    \cgalParamDefault{2}
    \cgalParamExtra{`std::invalid_argument` if not finite or not positive}
  \cgalParamNEnd
  \cgalParamNBegin{penalty_growth}
    \cgalParamDescription{\f$ \mu \f$, the factor between one \f$ \beta \f$ and the next}
    \cgalParamType{`double`}
    \cgalParamDefault{1.5; 2.7 for `Method::DEFAULT`}
    \cgalParamExtra{`std::invalid_argument` if not finite, not above 1, or if it asks for more than
      10000 iterations}
  \cgalParamNEnd
  \cgalParamNBegin{keep_density}
    \cgalParamDescription{whether the result is as dense here and there as the input is, instead of
      even. `DEFAULT` starts where the points are and spreads the samples relative to the spacing
      around them; `LOR` and `ALOR` do without the weights of Eq. (5) of the input.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{viewpoint}
    \cgalParamDescription{the place that all points were seen from, such as that of the scanner. A
      sample whose surface is seen at more than 10 degrees faces it; where the angle is smaller, the
      side follows from those around it. Points that were seen from elsewhere, such as the far side
      of a closed surface, are turned to the wrong side: they need `viewpoint_map`.}
    \cgalParamType{`Point_3`}
    \cgalParamDefault{none: normals point outwards, in the sense of the divergence theorem}
    \cgalParamExtra{`std::invalid_argument` if not finite, or if `viewpoint_map`, `up_direction` or
      `orientation_hint_map` is there too}
  \cgalParamNEnd
  \cgalParamNBegin{viewpoint_map}
    \cgalParamDescription{a property map associating to the elements of the range `points` the place
      that each was seen from, for several scans or a scanner that moves. Sides are as with
      `viewpoint`. A sample looks in the direction in which the input point that it starts on has
      its viewpoint. A viewpoint that is not finite, or is the point itself, says nothing.}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and
      `Point_3` as value type}
    \cgalParamDefault{none}
    \cgalParamExtra{`std::invalid_argument` if `viewpoint`, `up_direction` or
      `orientation_hint_map` is there too}
  \cgalParamNEnd
  \cgalParamNBegin{up_direction}
    \cgalParamDescription{the way up, for points that were seen from above, such as those of an
      airborne scanner: as a viewpoint infinitely far in this direction. Its length does not
      matter.}
    \cgalParamType{`Vector_3`}
    \cgalParamDefault{none}
    \cgalParamExtra{`std::invalid_argument` if zero or not finite, or if `viewpoint`,
      `viewpoint_map` or `orientation_hint_map` is there too}
  \cgalParamNEnd
  \cgalParamNBegin{orientation_hint_map}
    \cgalParamDescription{a property map associating vectors to the elements of the range `points`,
      on whose side the normals shall be, such as the input's own normals. Each connected component
      of the result is turned as a whole to the side of the majority. Lengths do not matter; a zero
      or non-finite vector says nothing.}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and
      `Vector_3` as value type}
    \cgalParamDefault{none}
    \cgalParamExtra{`std::invalid_argument` if `viewpoint`, `viewpoint_map` or `up_direction` is
      there too}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_orientation_neighbors}
    \cgalParamDescription{the number of nearest samples over which the signs of the normals are
      propagated}
    \cgalParamType{any integral type}
    \cgalParamDefault{12}
    \cgalParamExtra{`std::invalid_argument` if not in [3, 1000]}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{solves Eq. (10)}
    \cgalParamType{a model of `L0ResamplingSolverTraits`, or a `std::reference_wrapper` of one}
    \cgalParamDefault{`CGAL::L0_resampling::Block_chebyshev_solver_traits`}
    \cgalParamExtra{throws `CGAL::L0_resampling::Solver_error` where it has no answer}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{chooses where the samples start}
    \cgalParamType{any integral type}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{drop_non_finite}
    \cgalParamDescription{whether points with a coordinate that is not finite are left out, and
      counted in the report, or refused}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`: `std::invalid_argument` with the index of the first such point}
  \cgalParamNEnd
  \cgalParamNBegin{drop_outliers}
    \cgalParamDescription{whether points off the cloud are left out, and counted in the report:
      points around which there are far fewer others than around the points in their surroundings,
      and small clusters apart from the rest}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false` for `LOR` and `ALOR`, `true` for `DEFAULT`, and for all if
      `outlier_sensitivity` is given}
  \cgalParamNEnd
  \cgalParamNBegin{outlier_sensitivity}
    \cgalParamDescription{how readily points are left out as outliers: none at 0, more the larger it
      is. It multiplies the number of points that there have to be around a point, so that a large
      one takes corners and borders of open surfaces away too.}
    \cgalParamType{`double`}
    \cgalParamDefault{1}
    \cgalParamExtra{without effect if `drop_outliers` is `false`; `std::invalid_argument` if not in
      [0, 3]}
  \cgalParamNEnd
  \cgalParamNBegin{source_index_map}
    \cgalParamDescription{out: for each point of the result, the place in the range `points` of the
      input point nearest to it; of those at the same distance, the first}
    \cgalParamType{a model of `WritablePropertyMap` with `std::size_t`, the place in the result, as
      key type and an integral value type}
    \cgalParamDefault{none}
    \cgalParamExtra{written before the first pair. `CUDA_resampler`, which holds no points on the
      host, does not have it.}
  \cgalParamNEnd
  \cgalParamNBegin{feature_confidence_map}
    \cgalParamDescription{out: for each point of the result, how sure it is that it lies on an edge
      or a corner, in [0, 1]: twice the share of its neighbors that are on the other side of a jump
      of the normals, as far as these differ by more than twice `sharpness_angle`}
    \cgalParamType{a model of `WritablePropertyMap` with `std::size_t`, the place in the result, as
      key type and a floating-point value type}
    \cgalParamDefault{none}
    \cgalParamExtra{written before the first pair}
  \cgalParamNEnd
  \cgalParamNBegin{side_confidence_map}
    \cgalParamDescription{out: for each point of the result, how sure it is that its normal is on
      the right side, in [0, 1]. Where many have 0.9, about nine of ten are. Without a hint the side
      of terrain, or of a room that was scanned from within, is a guess, and has about 0.5. The mean
      is `Report::right_side_share`.}
    \cgalParamType{a model of `WritablePropertyMap` with `std::size_t`, the place in the result, as
      key type and a floating-point value type}
    \cgalParamDefault{none}
    \cgalParamExtra{written before the first pair}
  \cgalParamNEnd
  \cgalParamNBegin{neighbor_radius_map}
    \cgalParamDescription{out: for each point of the result, the radius \f$ r_p \f$ that it was
      fitted with, in the unit of the points}
    \cgalParamType{a model of `WritablePropertyMap` with `std::size_t`, the place in the result, as
      key type and a floating-point value type}
    \cgalParamDefault{none}
    \cgalParamExtra{written before the first pair}
  \cgalParamNEnd
  \cgalParamNBegin{noise_map}
    \cgalParamDescription{out: for each point of the result, the standard deviation of the points
      in its ball across the surface, as the last fit measures it, in the unit of the points. It is
      too small where the noise is more than a fifth of the radius there, and 0 if no points are
      compatible with the sample.}
    \cgalParamType{a model of `WritablePropertyMap` with `std::size_t`, the place in the result, as
      key type and a floating-point value type}
    \cgalParamDefault{none}
    \cgalParamExtra{written before the first pair; `std::invalid_argument` for `LOR` and `ALOR`,
      whose fit does not tell noise from what the surface does in the ball}
  \cgalParamNEnd
  \cgalParamNBegin{position_deviation_map}
    \cgalParamDescription{out: for each point of the result, the standard deviation of its position
      along its normal, in the unit of the points. Where nothing could be fitted it is that of an
      input point. Two sheets nearer to each other than the noise are not told apart, and not
      counted in.}
    \cgalParamType{a model of `WritablePropertyMap` with `std::size_t`, the place in the result, as
      key type and a floating-point value type}
    \cgalParamDefault{none}
    \cgalParamExtra{written before the first pair; `std::invalid_argument` for `LOR` and `ALOR`,
      which have no covariance of a fit}
  \cgalParamNEnd
  \cgalParamNBegin{normal_deviation_map}
    \cgalParamDescription{out: for each point of the result, the standard deviation of the angle
      between its normal and that of the surface, in radians. It counts in that the surface may
      have facets, and is larger than the angles, by a factor of two and more, where the surface is
      smooth and bends. Details that the noise hides are not counted in.}
    \cgalParamType{a model of `WritablePropertyMap` with `std::size_t`, the place in the result, as
      key type and a floating-point value type}
    \cgalParamDefault{none}
    \cgalParamExtra{as of `position_deviation_map`}
  \cgalParamNEnd
  \cgalParamNBegin{crease_output_iterator}
    \cgalParamDescription{out: the creases of the surface, along which two faces meet, as lines of
      points of the result: of those beside a crease, as many as it has spacings are moved onto it,
      and the others on their faces away from it.
      What bends by less than 27 degrees, or within less than 6 spacings of the result without a
      corner, is none.}
    \cgalParamType{a model of `OutputIterator` that takes `CGAL::L0_resampling::Crease<Kernel>`}
    \cgalParamDefault{none: no point is moved}
    \cgalParamExtra{written before the first pair; `std::invalid_argument` for `LOR` and `ALOR`,
      and with `keep_density`}
  \cgalParamNEnd
  \cgalParamNBegin{corner_output_iterator}
    \cgalParamDescription{out: the points of the result, moved there, that three creases or more
      meet at, or that one turns at by more than 35 degrees}
    \cgalParamType{a model of `OutputIterator` that takes
      `CGAL::L0_resampling::Crease_corner<Kernel>`}
    \cgalParamDefault{none: no point is moved unless `crease_output_iterator` is given}
    \cgalParamExtra{as for `crease_output_iterator`}
  \cgalParamNEnd
  \cgalParamNBegin{outlier_output_iterator}
    \cgalParamDescription{out: which points were left out as outliers, as places in the range from
      0 on, ascending. They are those that `number_of_outliers` of the report counts.}
    \cgalParamType{a model of `OutputIterator` that takes `std::size_t`}
    \cgalParamDefault{none}
    \cgalParamExtra{written before the first pair; points that `drop_non_finite` leaves out have
      places, and are none}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_memory}
    \cgalParamDescription{the most memory that the function's own arrays may take}
    \cgalParamType{any integral type, in bytes}
    \cgalParamDefault{unlimited}
    \cgalParamExtra{`std::bad_alloc` if it does not suffice: before any point is read where the
      numbers of points alone say so, and before the normals where the neighbors of the first
      samples do; the time to count these is spent only if there is a limit}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{called every now and then, on the CPU also at the begin of each stage,
      from one thread at a time, with the progress, in [0, 1] and never falling; it may read the
      name of the last stage in the report. Once it returns `false` the function returns and nothing
      is written to `out`.}
    \cgalParamType{`std::function<bool(double)>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{resampling_report}
    \cgalParamDescription{filled with what was done}
    \cgalParamType{`CGAL::L0_resampling::Report*`}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the output iterator behind the last element written.

\throws std::invalid_argument for a parameter out of its range, or a point that is not finite,
before any work
\throws CGAL::L0_resampling::Solver_error if the solver has no answer
\throws std::bad_alloc if memory does not suffice
\throws CGAL::L0_resampling::Device_error with `CUDA_tag`, if there is no usable device, or it
failed

Arguments whose types do not fit are refused at compile time, with a sentence that says what is
wrong. What the property maps, the callback and the output iterator throw passes through. Nothing is
written unless everything else succeeded.

\cgalHeading{Complexity} With k neighbors in the ball of radius \f$ r_p \f$, time \cgalBigO{n k};
the radius of LOR and ALOR makes k grow like \f$ n^{1/3} \f$ on surfaces.
*/
template <typename ConcurrencyTag, typename PointRange, typename OutputIterator,
          typename NamedParameters = parameters::Default_named_parameters>
OutputIterator l0_resample_point_set(const PointRange& points, OutputIterator out,
                                     const NamedParameters& np = parameters::default_values())
{
  using namespace L0_resampling::internal;
  const auto point_map = point_map_of(points, np);
  const auto normal_map = normal_map_of(np);
  using Point_map = std::decay_t<decltype(point_map)>;
  using Normal_map = std::decay_t<decltype(normal_map)>;
  using Default_kernel = typename Kernel_traits<typename Value_of_map<Point_map>::type>::Kernel;
  using Kernel =
    typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                 Default_kernel>::type;
  if constexpr (input_fits<Kernel, Point_map, Normal_map, NamedParameters>())
    if constexpr (output_fits<NamedParameters>() && iterator_fits<Kernel, OutputIterator>())
      return resample_to_iterator<ConcurrencyTag, Kernel>(points, point_map, normal_map, out, np);
  return out;
}

/*!
\ingroup PkgL0ResamplingRef

resamples a point set, as above, from `points` to the end of `result`, which gets a normal map if it
has none.

The input's own normals are used only if they are passed:
`parameters::normal_map(points.normal_map())`.

Each point gets the properties of the input point nearest to it, whatever their type. Colors and
measurements are the weighted mean of the eight nearest ones instead: `CGAL::IO::Color`; integers of
at most 32 bits that are channels of a color, see `L0_resampling::is_color_channel()`; and `float`
and `double`, unless they are labels, and without values that stand for no data, see
`L0_resampling::Attribute_values`.

The keys of `source_index_map`, `feature_confidence_map`, `side_confidence_map`,
`neighbor_radius_map`, `noise_map`, `position_deviation_map` and `normal_deviation_map` are indices
of `result`, whose property maps fit.

\param points the input; its point map is the default of `point_map`
\param result another point set than `points`
\param np as above
*/
template <typename ConcurrencyTag, typename Point, typename Vector,
          typename NamedParameters = parameters::Default_named_parameters>
void l0_resample_point_set(const Point_set_3<Point, Vector>& points,
                           Point_set_3<Point, Vector>& result,
                           const NamedParameters& np = parameters::default_values())
{
  namespace internal = L0_resampling::internal;
  using Kernel = typename Kernel_traits<Point>::Kernel;
  const bool has_properties = internal::has_other_properties(points);
  const std::size_t near_count = has_properties ? L0_resampling::number_of_averaged_points : 0;
  const auto write = [&](std::size_t size, const auto& pair_of, const internal::Point_data& data) {
    const std::size_t size_before = result.size();
    if (has_properties)
      internal::append_with_properties(points, data.near_points, size, pair_of, result);
    else
    {
      result.reserve(size_before + size);
      result.add_normal_map();
      for (std::size_t i = 0; i < size; ++i)
      {
        const auto pair = pair_of(i);
        result.insert(pair.first, pair.second);
      }
    }
    internal::write_point_data(np, data, size, [&](std::size_t i) {
      return *(result.begin() + std::ptrdiff_t(size_before + i));
    });
    internal::write_creases<Kernel>(np, data.creases);
    internal::write_outliers(np, data.outliers);
  };
  const auto point_map = internal::point_map_of(points, np);
  const auto normal_map = internal::normal_map_of(np);
  if constexpr (internal::input_fits<Kernel, std::decay_t<decltype(point_map)>,
                                     std::decay_t<decltype(normal_map)>, NamedParameters>())
    if constexpr (internal::output_fits<NamedParameters>())
      internal::l0_resample_point_set<ConcurrencyTag, Kernel>(points, point_map, normal_map,
                                                              near_count, write, np);
}

} // namespace CGAL

#endif // CGAL_L0_RESAMPLE_POINT_SET_H
