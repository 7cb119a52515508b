// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_GIVEN_PARAMETERS_H
#define CGAL_L0_RESAMPLING_INTERNAL_GIVEN_PARAMETERS_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/named_parameters.h>
#include <CGAL/L0_resampling/tags.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What messages say of whom the parameters are.
constexpr const char* resampling_function = "l0_resample_point_set";
constexpr const char* orienting_function = "l0_orient_normals";

template <typename T>
struct Is_optional : std::false_type
{};
template <typename T>
struct Is_optional<std::optional<T>> : std::true_type
{};

/// Calls `use` with a copy of the named parameter if the caller gave it: as a value, or as a
/// `std::optional` that has one. The latter is for programs that learn at run time what is given,
/// where the names of a chain are known to the compiler. Never binds a reference: that would
/// outlive its value.
template <typename NamedParameters, typename Tag, typename F>
void if_given(const NamedParameters& np, Tag tag, const F& use)
{
  if constexpr (!parameters::is_default_parameter<NamedParameters, Tag>::value)
  {
    const auto value = parameters::get_parameter(np, tag);
    if constexpr (!Is_optional<std::decay_t<decltype(value)>>::value)
      use(value);
    else if (value)
      use(*value);
  }
  else
  {
    static_cast<void>(np);
    static_cast<void>(use);
  }
}

inline void reset_if_there(Report* report)
{
  if (report)
    *report = Report();
}

/// The report that the caller wants to be filled, reset; null if there is none.
template <typename NamedParameters>
Report* report_of_call(const NamedParameters& np)
{
  Report* report = nullptr;
  if_given(np, internal_np::resampling_report, [&](Report* given) { report = given; });
  reset_if_there(report);
  return report;
}

/// A count, which callers may pass as any number type.
struct Given_count
{
  bool is_given = false;
  std::size_t value = 0;
  std::string refused; ///< what the caller gave, if that is no count
};

/// The named parameters of a call as they are given, unchecked, in types that do not depend on the
/// caller's. One walk along their chain reads them, so that the compiler instantiates something for
/// those that are given only.
struct Given_parameters
{
  using Number = std::optional<double>;
  using Count = Given_count;
  using Size = std::optional<std::size_t>;
  using Flag = std::optional<bool>;
  using Place = std::optional<std::array<double, 3>>;

#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED) Kind X;
#define CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED) Kind X;
#include <CGAL/L0_resampling/value_parameters.h>

  std::optional<Method> resampling_method;
  std::function<bool(double)> callback;

  /// Whether a property map or an output iterator is given.
  struct Is_there
  {
    bool value = false;
  };
  Is_there point_noise_map, viewpoint_map, orientation_hint_map, source_index_map,
    feature_confidence_map, side_confidence_map, neighbor_radius_map, noise_map,
    position_deviation_map, normal_deviation_map, crease_output_iterator, corner_output_iterator,
    outlier_output_iterator;

  template <typename T, typename Tag, typename Base>
  Given_parameters(const Named_function_parameters<T, Tag, Base>& np)
  {
    read_chain(np);
  }

  /// Whether anything is read or written for single points, but for creases.
  bool has_values_of_points() const
  {
    for (const Is_there& given :
         {point_noise_map, viewpoint_map, orientation_hint_map, source_index_map,
          feature_confidence_map, side_confidence_map, neighbor_radius_map, noise_map,
          position_deviation_map, normal_deviation_map, outlier_output_iterator})
      if (given.value)
        return true;
    return false;
  }

private:
  struct Not_read_here
  {
  } m_others;

  // Where the value of a name goes.
#define CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED)                                          \
  Kind& place_of(internal_np::X##_t) { return X; }
#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED)                               \
  CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED)
#include <CGAL/L0_resampling/value_parameters.h>

  auto& place_of(internal_np::resampling_method_t) { return resampling_method; }
  auto& place_of(internal_np::callback_t) { return callback; }
  auto& place_of(internal_np::point_noise_map_t) { return point_noise_map; }
  auto& place_of(internal_np::viewpoint_map_t) { return viewpoint_map; }
  auto& place_of(internal_np::orientation_hint_map_t) { return orientation_hint_map; }
  auto& place_of(internal_np::source_index_map_t) { return source_index_map; }
  auto& place_of(internal_np::feature_confidence_map_t) { return feature_confidence_map; }
  auto& place_of(internal_np::side_confidence_map_t) { return side_confidence_map; }
  auto& place_of(internal_np::neighbor_radius_map_t) { return neighbor_radius_map; }
  auto& place_of(internal_np::noise_map_t) { return noise_map; }
  auto& place_of(internal_np::position_deviation_map_t) { return position_deviation_map; }
  auto& place_of(internal_np::normal_deviation_map_t) { return normal_deviation_map; }
  auto& place_of(internal_np::crease_output_iterator_t) { return crease_output_iterator; }
  auto& place_of(internal_np::corner_output_iterator_t) { return corner_output_iterator; }
  auto& place_of(internal_np::outlier_output_iterator_t) { return outlier_output_iterator; }
  auto& place_of(...) { return m_others; }

  /// Of two of a name, the last one counts.
  template <typename T, typename Tag, typename Base>
  void read_chain(const Named_function_parameters<T, Tag, Base>& np)
  {
    if constexpr (!std::is_same<Base, internal_np::No_property>::value)
      read_chain(static_cast<const Base&>(np));
    read(np.v, place_of(Tag()));
  }

  template <typename Value, typename Target>
  static void read(const Value& value, Target& place)
  {
    if constexpr (!Is_optional<Value>::value)
      convert(value, place);
    else if (value)
      convert(*value, place);
    else
      place = Target();
  }

  template <typename Value, typename T>
  static void convert(const Value& value, T& place)
  {
    place = static_cast<T>(value);
  }
  template <typename Value, typename T>
  static void convert(const Value& value, std::optional<T>& place)
  {
    place = static_cast<T>(value);
  }
  template <typename Value>
  static void convert(const Value& value, Given_count& place)
  {
    place.is_given = true;
    if (!(value < 0) && double(value) <= double((std::numeric_limits<std::size_t>::max)() / 2))
    {
      place.value = std::size_t(value);
      place.refused.clear();
      return;
    }
    std::ostringstream text;
    text.precision(17);
    text << value;
    place.refused = text.str();
  }
  template <typename Coordinates>
  static void convert(const Coordinates& p, std::optional<std::array<double, 3>>& place)
  {
    place = std::array<double, 3>{double(p[0]), double(p[1]), double(p[2])};
  }
  template <typename Map>
  static void convert(const Map&, Is_there& place)
  {
    place.value = true;
  }
  template <typename Value>
  static void convert(const Value&, Not_read_here&)
  {}
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_GIVEN_PARAMETERS_H
