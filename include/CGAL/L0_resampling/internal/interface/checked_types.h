// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

// What the compiler says of arguments whose types do not fit: one sentence for each. Of a call that
// is refused callers compile nothing else, so that the sentence is the first error, not one of
// many.

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CHECKED_TYPES_H
#define CGAL_L0_RESAMPLING_INTERNAL_CHECKED_TYPES_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/interface/output_iterators.h>
#include <CGAL/L0_resampling/named_parameters.h>

#include <CGAL/property_map.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {

template <class Kernel>
class Point_3;
template <class Kernel>
class Vector_3;

namespace L0_resampling {
namespace internal {

template <typename T>
struct Without_optional
{
  using type = T;
};
template <typename T>
struct Without_optional<std::optional<T>>
{
  using type = T;
};

/// The type of a named parameter as it is read; `Param_not_found` if it is not given.
template <typename NamedParameters, typename Tag>
using Given = typename Without_optional<std::decay_t<decltype(parameters::get_parameter(
  std::declval<const NamedParameters&>(), std::declval<Tag>()))>>::type;

/// The value type of a property map; `void` of what is none.
template <typename Map, typename = void>
struct Value_of_map
{
  using type = void;
};
template <typename Map>
struct Value_of_map<Map, std::void_t<typename boost::property_traits<Map>::value_type>>
{
  using type = std::remove_cv_t<typename boost::property_traits<Map>::value_type>;
};

template <typename T, typename = void>
struct Has_coordinates : std::false_type
{};
template <typename T>
struct Has_coordinates<
  T, std::void_t<decltype(std::declval<const T&>().x()), decltype(std::declval<const T&>().y()),
                 decltype(std::declval<const T&>().z())>> : std::true_type
{};

/// What has three coordinates is a point, but CGAL's vectors, and the other way round.
template <typename T>
struct Is_point : Has_coordinates<T>
{};
template <typename Kernel>
struct Is_point<Vector_3<Kernel>> : std::false_type
{};
template <typename T>
struct Is_vector : Has_coordinates<T>
{};
template <typename Kernel>
struct Is_vector<Point_3<Kernel>> : std::false_type
{};

/// Whether a parameter is not given, or the property map that it is has values as `Is_good` says.
template <typename Map, template <typename> class Is_good>
constexpr bool has_values = std::is_same<Map, internal_np::Param_not_found>::value
                            || Is_good<typename Value_of_map<Map>::type>::value;

/// Refuses ranges and maps without points, and kernels without floating-point numbers.
template <typename Kernel, typename PointMap>
constexpr bool points_fit()
{
  constexpr bool has_points = has_values<PointMap, Is_point>;
  static_assert(has_points, "point_map needs values of type Point_3; "
                            "without it, the elements of the range have to be points.");
  if constexpr (has_points)
  {
    constexpr bool is_floating_point = std::is_floating_point<typename Kernel::FT>::value;
    static_assert(
      is_floating_point,
      "This package computes in floating point: convert the points to a kernel such as "
      "Exact_predicates_inexact_constructions_kernel or Simple_cartesian<double> first.");
    return is_floating_point;
  }
  else
    return false;
}

/// Refuses maps of the input whose values have another type than they should.
/// \tparam NormalMap may be `bool`, for none, or an optional
template <typename Kernel, typename PointMap, typename NormalMap, typename NamedParameters>
constexpr bool input_fits()
{
  constexpr bool has_normals = std::is_same<NormalMap, bool>::value
                               || has_values<typename Without_optional<NormalMap>::type, Is_vector>;
  static_assert(has_normals, "normal_map needs values of type Vector_3.");
  constexpr bool has_viewpoints =
    has_values<Given<NamedParameters, internal_np::viewpoint_map_t>, Is_point>;
  static_assert(has_viewpoints, "viewpoint_map needs values of type Point_3.");
  constexpr bool has_hints =
    has_values<Given<NamedParameters, internal_np::orientation_hint_map_t>, Is_vector>;
  static_assert(has_hints, "orientation_hint_map needs values of type Vector_3.");
  constexpr bool has_noises =
    has_values<Given<NamedParameters, internal_np::point_noise_map_t>, std::is_floating_point>;
  static_assert(has_noises, "point_noise_map needs values of a floating-point type.");
  return points_fit<Kernel, PointMap>() && has_normals && has_viewpoints && has_hints && has_noises;
}

/// Refuses parameters for what is said of the call whose types do not fit.
template <typename NamedParameters>
constexpr bool call_fits()
{
  using internal_np::Param_not_found;
  using Callback = Given<NamedParameters, internal_np::callback_t>;
  constexpr bool has_callback =
    std::is_same<Callback, Param_not_found>::value
    || std::is_constructible<std::function<bool(double)>, Callback>::value;
  static_assert(has_callback,
                "callback has to be a function that takes the progress, a double, and "
                "returns a bool: whether to go on.");
  using Report_pointer = Given<NamedParameters, internal_np::resampling_report_t>;
  constexpr bool has_report = std::is_same<Report_pointer, Param_not_found>::value
                              || std::is_convertible<Report_pointer, Report*>::value;
  static_assert(has_report, "resampling_report has to be the address of a Report.");
  return has_callback && has_report;
}

/// Refuses parameters for the result, and for what is said of the call, whose types do not fit.
template <typename NamedParameters>
constexpr bool output_fits()
{
  constexpr bool has_indices =
    has_values<Given<NamedParameters, internal_np::source_index_map_t>, std::is_integral>;
  static_assert(has_indices, "source_index_map needs values of an integral type.");
  constexpr bool has_confidences =
    has_values<Given<NamedParameters, internal_np::feature_confidence_map_t>,
               std::is_floating_point>;
  static_assert(has_confidences, "feature_confidence_map needs values of a floating-point type.");
  constexpr bool has_sides =
    has_values<Given<NamedParameters, internal_np::side_confidence_map_t>, std::is_floating_point>;
  static_assert(has_sides, "side_confidence_map needs values of a floating-point type.");
  constexpr bool has_radii =
    has_values<Given<NamedParameters, internal_np::neighbor_radius_map_t>, std::is_floating_point>;
  static_assert(has_radii, "neighbor_radius_map needs values of a floating-point type.");
  constexpr bool has_noises =
    has_values<Given<NamedParameters, internal_np::noise_map_t>, std::is_floating_point>;
  static_assert(has_noises, "noise_map needs values of a floating-point type.");
  constexpr bool has_position_deviations =
    has_values<Given<NamedParameters, internal_np::position_deviation_map_t>,
               std::is_floating_point>;
  static_assert(has_position_deviations,
                "position_deviation_map needs values of a floating-point type.");
  constexpr bool has_normal_deviations =
    has_values<Given<NamedParameters, internal_np::normal_deviation_map_t>, std::is_floating_point>;
  static_assert(has_normal_deviations,
                "normal_deviation_map needs values of a floating-point type.");
  return has_indices && has_confidences && has_sides && has_radii && has_noises
         && has_position_deviations && has_normal_deviations && call_fits<NamedParameters>();
}

/// Refuses output iterators that take neither pairs nor points.
template <typename Kernel, typename OutputIterator>
constexpr bool iterator_fits()
{
  constexpr bool fits = takes_pairs<Kernel, OutputIterator> || takes_points<Kernel, OutputIterator>;
  static_assert(fits, "The output iterator of l0_resample_point_set() has to take "
                      "std::pair<Point_3, Vector_3> or Point_3, of the kernel of the points.");
  return fits;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CHECKED_TYPES_H
