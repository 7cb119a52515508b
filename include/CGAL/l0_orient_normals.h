// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_ORIENT_NORMALS_H
#define CGAL_L0_ORIENT_NORMALS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/driver/orient_point_set.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/checked_types.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/named_parameters.h>
#include <CGAL/L0_resampling/tags.h>
#ifndef CGAL_L0_LINKED_WITH_COMPILED
#include <CGAL/L0_resampling/internal/driver/orient_point_set_impl.h>
#endif

#include <CGAL/Kernel_traits.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/internal/driver/orient_on_device.h>
#endif

namespace CGAL {

namespace L0_resampling {
namespace internal {

/// Chooses where the stages run; uses up the input.
template <typename ConcurrencyTag>
Oriented_representatives orient_input(Input& input, const Parameters& parameters,
                                      const std::function<bool(double)>& callback,
                                      Progress& progress, Report& report)
{
  if constexpr (!std::is_same<ConcurrencyTag, CUDA_tag>::value)
  {
    static_cast<void>(callback); // `progress` asks it
    return orient_point_set<ConcurrencyTag>(input.points, input.normals, input.hints, parameters,
                                            progress, report);
  }
  else
  {
    static_cast<void>(progress);
#ifdef CGAL_L0_LINKED_WITH_CUDA
    return orient_on_device(input.points, input.normals, input.hints, parameters, callback, report);
#else
    static_assert(
      !std::is_same<ConcurrencyTag, CUDA_tag>::value,
      "CUDA_tag needs a compiled library: link with the CMake target CGAL::L0_CUDA_support.");
#endif
  }
}

/// Whether a normal is on the other side than `oriented`. Of one at right angles to it, one of the
/// two signs is, so that the sign it came with does not matter.
/// \param normal finite and not zero
inline bool has_to_turn(const Vector& normal, const Vector& oriented)
{
  const double product = (normal / normal.cwiseAbs().maxCoeff()).dot(oriented);
  const Vector zero = Vector::Zero();
  return product != 0 ? product < 0
                      : std::lexicographical_compare(normal.data(), normal.data() + 3, zero.data(),
                                                     zero.data() + 3);
}

/// Turns the normals that are not on the side of those around what stands for their points, and
/// writes those that were estimated.
template <typename ConcurrencyTag, typename PointRange, typename NormalMap>
void write_oriented_normals(PointRange& range, NormalMap normal_map,
                            const Oriented_representatives& representatives, const Input& input)
{
  using Normal = typename Value_of_map<NormalMap>::type;
  using FT = std::decay_t<decltype(std::declval<const Normal&>().x())>;
  const Cancellation_scope not_watched(
    nullptr); // cancelled no more: that would leave some unwritten
  for_each_kept_point<ConcurrencyTag>(range, input, [&](auto&& key, std::size_t place) {
    const Index representative = representatives.of_points[place];
    const auto vector_of = [&](const Buffer<Local_vector>& vectors) -> Vector {
      return vectors[representative].template cast<double>();
    };
    const Normal normal = get(normal_map, key);
    const Vector n = as_vector(normal);
    const bool is_given = n.allFinite() && !n.isZero(0);
    if (!is_given && !representatives.normals.empty())
    {
      const Vector estimated = vector_of(representatives.normals).normalized();
      put(normal_map, key, Normal(FT(estimated[0]), FT(estimated[1]), FT(estimated[2])));
    }
    else if (has_to_turn(n, vector_of(representatives.mean_normals)))
      put(normal_map, key, Normal(-normal.x(), -normal.y(), -normal.z()));
  });
}

/// Where the range is read and written.
template <typename ConcurrencyTag>
using Host_tag = std::conditional_t<std::is_same<ConcurrencyTag, CUDA_tag>::value,
                                    Parallel_if_available_tag, ConcurrencyTag>;

/// What of a call does not depend on the types of its range and maps.
/// \param size of the range
/// \param wanted_report may be null
/// \param read_positions as `read_points()`
/// \param read_normals_and_hints as far as they are given
/// \param write called once there is a result
template <typename ConcurrencyTag>
void orient_points(std::size_t size, const Given_parameters& given, Report* wanted_report,
                   const Function_view<Report&, Input&>& read_positions,
                   const Function_view<Input&>& read_normals_and_hints,
                   const Function_view<const Oriented_representatives&, const Input&>& write)
{
  Report unwanted_report;
  Report& report = wanted_report ? *wanted_report : unwanted_report;
  constexpr bool is_on_device = std::is_same<ConcurrencyTag, CUDA_tag>::value;
  report.device = is_on_device ? "cuda" : "cpu";
  report.device_reason = is_on_device ? "asked for" : "compiled for the CPU";

  // Checked before any point is looked at
  Parameters parameters = checked_orientation_parameters(given, size);
  if (!given.drop_non_finite.value_or(false)
      && minimum_memory_to_orient(size) > parameters.maximum_memory)
    throw std::bad_alloc();
  Memory_counter unlimited, limited(parameters.maximum_memory);
  Memory_counter& memory = is_on_device ? unlimited : limited; // the limit is of the device there
  Input input(&memory);
  Progress progress(is_on_device ? nullptr : given.callback, report, memory);
  Oriented_representatives representatives{Buffer<Index>(&memory), Buffer<Local_vector>(&memory),
                                           Buffer<Local_vector>(&memory)};
  try
  {
    read_positions(report, input);
    parameters.number_of_output_points = input.points.size();
    if (input.points.empty())
      return;
    if (minimum_memory_to_orient(input.points.size()) > parameters.maximum_memory)
      throw std::bad_alloc();
    read_normals_and_hints(input);
    representatives = orient_input<ConcurrencyTag>(input, parameters, given.callback, progress,
                                                   report);
  }
  catch (const Interrupted&)
  {
    progress.rethrow_exception_of_callback();
    report.outcome = Outcome::CANCELLED;
  }
  if (report.outcome == Outcome::CANCELLED)
    return;
  write(representatives, input);
  report.number_of_output_points = representatives.of_points.size();
}

/// The whole function, once the property maps are known.
/// \param normal_map an optional: without a value, all normals are estimated
/// \param map_to_write called once there is a result; gives the normal map that takes it
template <typename ConcurrencyTag, typename PointRange, typename PointMap, typename NormalMap,
          typename MapToWrite, typename NamedParameters>
void orient_range(PointRange& range, PointMap point_map, const std::optional<NormalMap>& normal_map,
                  const MapToWrite& map_to_write, const NamedParameters& np)
{
  using Tag = Host_tag<ConcurrencyTag>;
  Report* const report = report_of_call(np);
  const Given_parameters given(np);
  const auto read_positions = [&](Report& r, Input& input) {
    read_points<Tag>(range, point_map, given.drop_non_finite.value_or(false), r, input,
                     orienting_function);
  };
  const auto read_normals_and_hints = [&](Input& input) {
    read_normals_if_given<Tag>(range, normal_map, input);
    read_hints_if_given<Tag>(range, point_map, np, input);
  };
  const auto write = [&](const Oriented_representatives& representatives, const Input& input) {
    write_oriented_normals<Tag>(range, map_to_write(), representatives, input);
  };
  orient_points<ConcurrencyTag>(
    std::size_t(std::distance(range.begin(), range.end())), given, report,
    Function_view<Report&, Input&>(read_positions), Function_view<Input&>(read_normals_and_hints),
    Function_view<const Oriented_representatives&, const Input&>(write));
}

/// Refuses at compile time what does not fit, and else runs.
template <typename ConcurrencyTag, typename PointRange, typename NormalMap, typename MapToWrite,
          typename NamedParameters>
void l0_orient_normals(PointRange& range, const std::optional<NormalMap>& normal_map,
                       const MapToWrite& map_to_write, const NamedParameters& np)
{
  const auto point_map = point_map_of(range, np);
  using Point_map = std::decay_t<decltype(point_map)>;
  using Default_kernel = typename Kernel_traits<typename Value_of_map<Point_map>::type>::Kernel;
  using Kernel =
    typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                 Default_kernel>::type;
  if constexpr (input_fits<Kernel, Point_map, NormalMap, NamedParameters>())
    if constexpr (call_fits<NamedParameters>())
      orient_range<ConcurrencyTag>(range, point_map, normal_map, map_to_write, np);
}

/// As above, with the normal map among the parameters.
template <typename ConcurrencyTag, typename PointRange, typename NamedParameters>
void orient_with_given_map(PointRange& range, const NamedParameters& np)
{
  const auto normal_map = normal_map_of(np);
  constexpr bool has_map = !std::is_same<std::decay_t<decltype(normal_map)>, bool>::value;
  static_assert(has_map, "l0_orient_normals() needs a normal_map, which it reads and writes.");
  if constexpr (has_map)
    l0_orient_normals<ConcurrencyTag>(
      range, std::make_optional(normal_map), [&] { return normal_map; }, np);
}

} // namespace internal
} // namespace L0_resampling

/*!
\ingroup PkgL0ResamplingRef

orients the normals of a point set: turns those that point to the wrong side, and nothing else.
Points are neither moved nor reordered, and their number stays. It may be called where
`CGAL::mst_orient_normals()` is, which reorders the points.

Sides are found as `l0_resample_point_set()` finds those of its samples: normals point outwards, in
the sense of the divergence theorem, or to where the parameters say. The result does not depend on
the order of the points, on the signs of the normals, on the number of threads or on the run.
Outliers get a side too, and do not pass it on to the surface.

Heights of neighbors over a point's tangent plane are evidence of a fold beyond what the spacing and
the noise around the point explain. Points that their neighbors outvote are turned at last.

Points at one place, and points much closer together than the others, are represented by some of
them; the others turn to the side of what represents them. Where the standard deviation of the noise
is larger than the spacing, a point in every such deviation represents those around it.

\tparam ConcurrencyTag says where and how the stages run: `Sequential_tag`, `Parallel_tag` or
`Parallel_if_available_tag`; or `CUDA_tag`, in programs that link with `CGAL::L0_CUDA_support`. On
the device `maximum_memory` is of the device, and `Device_error` is thrown where none can be used.
\tparam PointRange is a model of `Range` with forward iterators. Unless the tag is
`Sequential_tag`, all threads read the points and write the normals if the iterators have random
access: property maps have to allow `get()` on several threads at the same time, and `put()` for
different elements, as with `CGAL::pca_estimate_normals()`.

\param points any number of points, from none; only their normals are written
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
below, in chains as of `l0_resample_point_set()`. All but `point_map`, `normal_map` and
`geom_traits` may also be given as a `std::optional` of their type.

\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map associating points to the elements of the range `points`}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and
      `Point_3` as value type}
    \cgalParamDefault{`CGAL::Identity_property_map<Point_3>`; of a `Point_set_3` its own}
  \cgalParamNEnd
  \cgalParamNBegin{normal_map}
    \cgalParamDescription{a property map associating normals to the elements of the range `points`,
      of any length and sign. A zero or non-finite normal is replaced by one of unit length, the
      normal of the plane through the points around (PCA); of all others at most the sign changes.}
    \cgalParamType{a model of `ReadWritePropertyMap` with the iterator's value type as key type and
      `Vector_3` as value type}
    \cgalParamDefault{none: it is required, but for a `Point_set_3`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{a kernel whose `FT` is `float` or `double`; one with an exact number type
      is refused at compile time}
    \cgalParamType{a model of `Kernel`}
    \cgalParamDefault{the kernel of the point type}
  \cgalParamNEnd
  \cgalParamNBegin{neighbor_radius}
    \cgalParamDescription{planes for missing normals are fitted to the points within seven tenths of
      it; closer points than an eightieth of it, more than a handful, are represented by some of
      them}
    \cgalParamType{`double`, a length in the unit of the points}
    \cgalParamDefault{as of `l0_resample_point_set()` with `Method::DEFAULT`}
    \cgalParamExtra{`std::invalid_argument` if not finite or not positive; values beyond the
      diagonal are taken as the diagonal}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_orientation_neighbors}
    \cgalParamDescription{the number of nearest points over which the signs of the normals are
      propagated}
    \cgalParamType{any integral type}
    \cgalParamDefault{12}
    \cgalParamExtra{`std::invalid_argument` if not in [3, 1000]}
  \cgalParamNEnd
  \cgalParamNBegin{viewpoint}
    \cgalParamDescription{the place that all points were seen from. A point whose surface is seen at
      more than 10 degrees faces it; where the angle is smaller, the side follows from those around
      it.}
    \cgalParamType{`Point_3`}
    \cgalParamDefault{none: normals point outwards, in the sense of the divergence theorem}
    \cgalParamExtra{`std::invalid_argument` if not finite, or if `viewpoint_map`, `up_direction` or
      `orientation_hint_map` is there too}
  \cgalParamNEnd
  \cgalParamNBegin{viewpoint_map}
    \cgalParamDescription{a property map associating to the elements of the range `points` the place
      that each was seen from. A viewpoint that is not finite, or is the point itself, says
      nothing.}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and
      `Point_3` as value type}
    \cgalParamDefault{none}
    \cgalParamExtra{`std::invalid_argument` if `viewpoint`, `up_direction` or
      `orientation_hint_map` is there too}
  \cgalParamNEnd
  \cgalParamNBegin{up_direction}
    \cgalParamDescription{the way up, for points that were seen from above: as a viewpoint
      infinitely far in this direction. Its length does not matter.}
    \cgalParamType{`Vector_3`}
    \cgalParamDefault{none}
    \cgalParamExtra{`std::invalid_argument` if zero or not finite, or if `viewpoint`,
      `viewpoint_map` or `orientation_hint_map` is there too}
  \cgalParamNEnd
  \cgalParamNBegin{orientation_hint_map}
    \cgalParamDescription{a property map associating vectors to the elements of the range `points`,
      on whose side the normals shall be. Each connected component is turned as a whole to the side
      of the majority. Lengths do not matter; a zero or non-finite vector says nothing.}
    \cgalParamType{a model of `ReadablePropertyMap` with the iterator's value type as key type and
      `Vector_3` as value type}
    \cgalParamDefault{none}
    \cgalParamExtra{`std::invalid_argument` if `viewpoint`, `viewpoint_map` or `up_direction` is
      there too}
  \cgalParamNEnd
  \cgalParamNBegin{drop_non_finite}
    \cgalParamDescription{whether points with a coordinate that is not finite are passed over, their
      normals left as they are, and counted in the report, or refused}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`: `std::invalid_argument` with the index of the first such point}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_memory}
    \cgalParamDescription{the most memory that the function's own arrays may take}
    \cgalParamType{any integral type, in bytes}
    \cgalParamDefault{unlimited}
    \cgalParamExtra{`std::bad_alloc` if it does not suffice; where the number of points alone says
      so, before any point is read}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{called every now and then, and at the begin of each stage, from one thread
      at a time, with the progress, in [0, 1] and never falling. Once it returns `false` the
      function returns and no normal is written.}
    \cgalParamType{`std::function<bool(double)>`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{resampling_report}
    \cgalParamDescription{filled with what was done: numbers of points, radius, shares of oriented
      points and of those whose side was told, stages and memory}
    \cgalParamType{`CGAL::L0_resampling::Report*`}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\throws std::invalid_argument for a parameter out of its range, or a point that is not finite,
before any work
\throws std::bad_alloc if memory does not suffice
\throws CGAL::L0_resampling::Device_error with `CUDA_tag`, if there is no usable device, or it fails

Arguments whose types do not fit are refused at compile time, with a sentence that says what is
wrong. What the property maps and the callback throw passes through, from whichever thread. No
normal is written unless everything else succeeded; if `put()` throws, some are.
*/
template <typename ConcurrencyTag, typename PointRange,
          typename NamedParameters = parameters::Default_named_parameters>
void l0_orient_normals(PointRange& points, const NamedParameters& np = parameters::default_values())
{
  L0_resampling::internal::orient_with_given_map<ConcurrencyTag>(points, np);
}

/*!
\ingroup PkgL0ResamplingRef

orients the normals of a `Point_set_3`, as above. One that has no normal map gets one, with
estimated normals, once everything else has succeeded.

\param points its point map and its normal map are the defaults of `point_map` and `normal_map`
\param np as above
*/
template <typename ConcurrencyTag, typename Point, typename Vector,
          typename NamedParameters = parameters::Default_named_parameters>
void l0_orient_normals(Point_set_3<Point, Vector>& points,
                       const NamedParameters& np = parameters::default_values())
{
  namespace internal = L0_resampling::internal;
  if constexpr (!parameters::is_default_parameter<NamedParameters, internal_np::normal_t>::value)
    internal::orient_with_given_map<ConcurrencyTag>(points, np);
  else
    internal::l0_orient_normals<ConcurrencyTag>(
      points, points.has_normal_map() ? std::make_optional(points.normal_map()) : std::nullopt,
      [&] {
        points.add_normal_map();
        return points.normal_map();
      },
      np);
}

} // namespace CGAL

#endif // CGAL_L0_ORIENT_NORMALS_H
