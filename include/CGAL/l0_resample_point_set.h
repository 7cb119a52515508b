// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLE_POINT_SET_H
#define CGAL_L0_RESAMPLE_POINT_SET_H

#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/Point_data.h>
#include <CGAL/L0_resampling/internal/carry_properties.h>
#include <CGAL/L0_resampling/internal/checked_parameters.h>
#include <CGAL/L0_resampling/internal/checked_types.h>
#include <CGAL/L0_resampling/internal/compiled_templates.h>
#include <CGAL/L0_resampling/internal/least_memory.h>
#include <CGAL/L0_resampling/internal/output_iterators.h>
#include <CGAL/L0_resampling/internal/points_of_range.h>
#include <CGAL/L0_resampling/internal/resample.h>
#include <CGAL/L0_resampling/named_parameters.h>
#include <CGAL/L0_resampling/tags.h>
#include <CGAL/L0_resampling/warnings.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Origin.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/CUDA_resampler.h>
#endif

namespace CGAL {

namespace L0_resampling {
namespace internal {

/// The caller's solver, which may come wrapped in a `std::reference_wrapper`, or else
/// `default_solver`.
template <typename NamedParameters, typename DefaultSolver>
decltype(auto) choose_solver(const NamedParameters& np, DefaultSolver& default_solver)
{
  if constexpr (parameters::is_default_parameter<NamedParameters,
                                                 internal_np::sparse_linear_solver_t>::value)
    return (default_solver);
  else
    return parameters::get_parameter(np, internal_np::sparse_linear_solver); // a copy
}

template <typename Solver>
Solver& unwrapped(Solver& solver)
{
  return solver;
}
template <typename Solver>
Solver& unwrapped(std::reference_wrapper<Solver>& solver)
{
  return solver.get();
}

/// The whole function on the CPU, once the property maps are known. `NormalMap` may be `bool`, for
/// none, or an optional.
/// \param near_count how many near points of the input `write` wants to know of each point, if the
/// maps among the parameters want fewer
/// \param write called once if there is a result: with its size, a function that gives its i-th
/// pair, and the `Point_data` asked for
template <typename ConcurrencyTag, typename Kernel, typename PointRange, typename PointMap,
          typename NormalMap, typename Write, typename NamedParameters>
void resample_on_cpu(const PointRange& range, PointMap point_map, NormalMap normal_map,
                     std::size_t near_count, const Write& write, const NamedParameters& np)
{
  using FT = typename Kernel::FT;
  Report unwanted_report;
  Report* wanted_report = &unwanted_report;
  read_parameter(np, internal_np::resampling_report, wanted_report);
  Report& report = *wanted_report;
  report = Report();
  report.device_reason = "compiled for the CPU";

  std::function<bool(double)> callback;
  read_parameter(np, internal_np::callback, callback);
  bool drop_non_finite = false;
  read_parameter(np, internal_np::drop_non_finite, drop_non_finite);

  Block_conjugate_gradient_solver_traits<Local, ConcurrencyTag> default_solver;
  decltype(auto) chosen_solver = choose_solver(np, default_solver);
  using Solver = std::decay_t<decltype(unwrapped(chosen_solver))>;

  // Checked before any point is looked at, and read again below: a percentage is one of the points
  // that are used.
  const std::size_t size = std::size_t(std::distance(range.begin(), range.end()));
  const Parameters checked_for_all = checked_parameters(np, size);
  const std::size_t maximum_memory = checked_for_all.maximum_memory;
  if (!drop_non_finite && least_memory<typename Solver::FT>(size, checked_for_all) > maximum_memory)
    throw std::bad_alloc();
  Memory_counter memory(maximum_memory);
  Input input(&memory);
  Progress progress(callback, report, memory);
  Buffer<std::array<FT, 3>> positions(&memory);
  Buffer<Eigen::Matrix<typename Solver::FT, 3, 1>> normals(&memory);
  Point_data data{{number_of_near_points(np, near_count), Buffer<Index>(&memory),
                   Buffer<float>(&memory)},
                  Buffer<float>(&memory)};
  try
  {
    read_points(range, point_map, drop_non_finite, report, input);
    const Parameters checked = checked_parameters(np, input.points.size());
    if (checked.number_of_output_points == 0)
      return;
    if (least_memory<typename Solver::FT>(input.points.size(), checked) > maximum_memory)
      throw std::bad_alloc();
    read_normals_if_given(range, normal_map, input);
    read_hints_if_given(range, point_map, np, input);
    release(input.is_kept);

    std::size_t n = input.points.size();
    const std::size_t m = checked.number_of_output_points;
    Any_solver<typename Solver::FT> solver(unwrapped(chosen_solver));
    Oriented_points<typename Solver::FT> result = resample<ConcurrencyTag>(
      input.points, input.normals, input.hints, checked, solver, progress, report);
    n -= report.number_of_outliers;
    if (report.number_of_distinct_points < (std::min)(n, m))
      report.number_of_distinct_points = number_of_distinct_points(range, point_map, memory);
    positions =
      rounded_positions<ConcurrencyTag, FT>(result.positions, input, report.neighbor_radius,
                                            report.number_of_distinct_points >= (std::min)(n, m));
    normals = std::move(result.normals);
    data.feature_confidences = std::move(result.feature_confidences);
    release(result.positions);
    if (data.near_points.count > 0)
    {
      progress.begin_stage("near points", 0.05, positions.size());
      nearest_input_points<ConcurrencyTag>(tree_of_range(range, point_map, memory), positions,
                                           progress, data.near_points);
      progress.end_stage();
    }
  }
  catch (const Interrupted&)
  {
    progress.rethrow_exception_of_callback();
    report.outcome = Outcome::CANCELLED;
    return;
  }

  report.number_of_output_points = positions.size();
  const auto pair_of = [&](std::size_t i) {
    const Vector normal = normals[i].template cast<double>().normalized();
    return std::make_pair(typename Kernel::Point_3(positions[i][0], positions[i][1],
                                                   positions[i][2]),
                          typename Kernel::Vector_3(FT(normal[0]), FT(normal[1]), FT(normal[2])));
  };
  write(positions.size(), pair_of, data);
}

/// Chooses where the stages run.
template <typename ConcurrencyTag, typename Kernel, typename PointRange, typename PointMap,
          typename NormalMap, typename Write, typename NamedParameters>
void l0_resample_point_set(const PointRange& range, PointMap point_map, NormalMap normal_map,
                           std::size_t near_count, const Write& write, const NamedParameters& np)
{
  if constexpr (!std::is_same<ConcurrencyTag, CUDA_tag>::value)
    resample_on_cpu<ConcurrencyTag, Kernel>(range, point_map, normal_map, near_count, write, np);
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
\tparam PointRange is a model of `ConstRange` with forward iterators.
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
      sheet only, looks for neighbors anew in every iteration, spreads the samples by repulsion and
      takes the radius from the spacing and the noise of the points. ALOR's local half-sampling
      leaves Eq. (10) as it is once the fit term is collapsed, so it is carried out only for solvers
      that need the rows of Eq. (11).}
    \cgalParamType{`CGAL::L0_resampling::Method`}
    \cgalParamDefault{`Method::DEFAULT`}
  \cgalParamNEnd
  \cgalParamNBegin{neighbor_radius}
    \cgalParamDescription{\f$ r_p \f$: the fit looks at the input points within \f$ r_p \f$ of a
      sample. The other terms look at the samples within \f$ r_p / 2 \f$ (`LOR`, `ALOR`) or within 2
      spacings of the samples, at most \f$ r_p \f$ (`DEFAULT`).}
    \cgalParamType{`double`, a length in the unit of the points}
    \cgalParamDefault{`LOR` and `ALOR`: \f$ l_{diag} / \sqrt[3]{n} \f$, where far outliers do not
      count for the diagonal of the bounding box. `DEFAULT`:
      \f$ ((3.5s)^{3/2} + (3.8\sigma)^{3/2})^{2/3} \f$ with the spacing s and the noise
      \f$ \sigma \f$ estimated from the points; around each point with those of its surroundings,
      where they differ from those of the cloud}
    \cgalParamExtra{`std::invalid_argument` if not finite or not positive; values beyond the
      diagonal are taken as the diagonal}
  \cgalParamNEnd
  \cgalParamNBegin{normal_filter_radius}
    \cgalParamDescription{\f$ r_q \f$, the radius of the bilateral filter of normals and of the
      density weights of Eq. (5)}
    \cgalParamType{`double`, a length in the unit of the points}
    \cgalParamDefault{\f$ r_p \f$; `DEFAULT`: \f$ 1.2 r_p \f$}
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
    \cgalParamDefault{5}
    \cgalParamExtra{`std::invalid_argument` if negative or above 10000}
  \cgalParamNEnd
  \cgalParamNBegin{normal_weight}
    \cgalParamDescription{\f$ \lambda \f$ of Eq. (6), the price of a jump across the tangent plane
      of a neighbor. Larger values give sharper edges and flatter faces, smaller ones stay closer to
      the input. Read in the unit \f$ r_p / 4 \f$, so that it does not depend on the unit of the
      points.}
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
    \cgalParamDefault{1.5; 2 for `Method::DEFAULT`}
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
    \cgalParamDefault{`CGAL::L0_resampling::Block_conjugate_gradient_solver_traits`}
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
    \cgalParamDefault{`false` for `LOR` and `ALOR`, `true` for `DEFAULT`}
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

Each point gets the properties of the input point nearest to it, whatever their type; where that is
`float`, `double` or `CGAL::IO::Color`, or where a `std::uint8_t` is named red, green, blue or
alpha, the weighted mean of the eight nearest ones. The keys of `source_index_map` and
`feature_confidence_map` are indices of `result`, whose property maps fit.

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
  const std::size_t near_count = has_properties ? internal::number_of_averaged_points : 0;
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
