// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 3: what is refused, with the type and the words that say why; and what only looks like
// it.

#include "promise_support.h"

#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/property_map.h>

#include <exception>
#include <iterator>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Points sphere(std::size_t n)
{
  test::Generator generator(1);
  return test::kernel_points<Kernel>(test::sphere_points(n, 1, generator).points);
}

/// The words of the refusal, empty if there is none; also if anything was written all the same.
template <typename NamedParameters>
std::string refusal(const Points& points, const NamedParameters& np)
{
  test::Pairs<Kernel> result;
  try
  {
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(points, std::back_inserter(result),
                                                                 np);
  }
  catch (const std::invalid_argument& error)
  {
    return result.empty() ? error.what() : "";
  }
  return "";
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// Refused on a healthy cloud and on none, and the message has the name and the value.
template <typename NamedParameters>
void check_refused(const std::string& name, const std::string& value, const NamedParameters& np)
{
  for (const Points& points : {sphere(50), Points()})
  {
    const std::string message = refusal(points, np);
    if (!CHECK(contains(message, name) && contains(message, value)))
      std::cerr << "  " << name << " = " << value << ", " << points.size() << " points: \""
                << message << '"' << std::endl;
  }
}

enum class Kind
{
  Number,
  Count,
  Size,
  Flag,
  Place
};

/// Of sizes and flags any value is good.
template <Kind kind, typename With>
void check_row([[maybe_unused]] const char* name, [[maybe_unused]] const With& with)
{
  if constexpr (kind == Kind::Number)
    check_refused(name, "nan", with(nan));
  else if constexpr (kind == Kind::Count)
    check_refused(name, "-1", with(-1));
  else if constexpr (kind == Kind::Place)
    check_refused(name, "nan", with(Kernel::Point_3(0, nan, 0)));
}

/// So each row of the table of values is read.
void test_what_is_no_value()
{
#define CGAL_L0_value_of_call(KIND, X, IS_GOOD, EXPECTED)                                          \
  check_row<Kind::KIND>(#X, [](const auto& value) { return params::X(value); });
#define CGAL_L0_value_parameter(KIND, X, DEFAULT, IS_GOOD, EXPECTED)                               \
  CGAL_L0_value_of_call(KIND, X, IS_GOOD, EXPECTED)
#include <CGAL/L0_resampling/value_parameters.h>
}

void test_lengths_and_angles()
{
  for (double bad : {0., -0., -1., nan, infinity, -infinity})
  {
    const std::string value = std::isnan(bad)   ? "nan"
                              : std::isinf(bad) ? "inf"
                              : bad == 0        ? "0"
                                                : "-1";
    check_refused("neighbor_radius", value, params::neighbor_radius(bad));
    check_refused("noise", value, params::noise(bad));
    check_refused("normal_filter_radius", value, params::normal_filter_radius(bad));
    check_refused("sharpness_angle", value, params::sharpness_angle(bad));
    check_refused("initial_penalty", value, params::initial_penalty(bad));
    check_refused("maximum_penalty", value, params::maximum_penalty(bad));
    check_refused("penalty_growth", value, params::penalty_growth(bad));
    check_refused("select_percentage", value, params::select_percentage(bad));
  }
  for (double bad : {-1., nan, infinity, -infinity})
  {
    const std::string value = std::isnan(bad) ? "nan" : std::isinf(bad) ? "inf" : "-1";
    check_refused("normal_weight", value, params::normal_weight(bad));
    check_refused("regularization_weight", value, params::regularization_weight(bad));
  }
  for (double bad : {nan, infinity, -infinity})
    for (int axis = 0; axis < 3; ++axis)
    {
      Vector v(1, 2, 3);
      v[axis] = bad;
      check_refused("viewpoint", std::isnan(bad) ? "nan" : "inf",
                    params::viewpoint(Kernel::Point_3(v[0], v[1], v[2])));
      check_refused("up_direction", std::isnan(bad) ? "nan" : "inf",
                    params::up_direction(Kernel::Vector_3(v[0], v[1], v[2])));
    }
  check_refused("up_direction", "0, 0, 0", params::up_direction(Kernel::Vector_3(0, 0, 0)));
  const Kernel::Vector_3 up(0, 0, 1);
  const CGAL::Constant_property_map<Kernel::Point_3, Kernel::Vector_3> hints(up);
  const CGAL::Constant_property_map<Kernel::Point_3, Kernel::Point_3> viewpoints(
    Kernel::Point_3(0, 0, 9));
  const auto viewpoint = params::viewpoint(Kernel::Point_3(0, 0, 9));
  check_refused("viewpoint", "given", viewpoint.orientation_hint_map(hints));
  check_refused("viewpoint", "given", viewpoint.viewpoint_map(viewpoints));
  check_refused("viewpoint", "given", viewpoint.up_direction(up));
  check_refused("up_direction", "given", params::up_direction(up).viewpoint_map(viewpoints));
  check_refused("up_direction", "given", params::up_direction(up).orientation_hint_map(hints));
  check_refused("viewpoint_map", "given",
                params::viewpoint_map(viewpoints).orientation_hint_map(hints));
  std::vector<double> noises;
  const CGAL::Constant_property_map<Kernel::Point_3, double> tenth(0.1);
  check_refused("point_noise_map", "given", params::point_noise_map(tenth).noise(0.1));
  for (const auto method : {CGAL::L0_resampling::Method::LOR, CGAL::L0_resampling::Method::ALOR})
    check_refused("point_noise_map", "given",
                  params::point_noise_map(tenth).resampling_method(method));
  const auto noise_map = params::noise_map(CGAL::make_property_map(noises));
  check_refused("noise_map", "given",
                noise_map.resampling_method(CGAL::L0_resampling::Method::LOR));
  check_refused("noise_map", "given",
                noise_map.resampling_method(CGAL::L0_resampling::Method::ALOR));
  const auto deviations = CGAL::make_property_map(noises);
  check_refused(
    "position_deviation_map", "given",
    params::position_deviation_map(deviations).resampling_method(CGAL::L0_resampling::Method::LOR));
  check_refused(
    "normal_deviation_map", "given",
    params::normal_deviation_map(deviations).resampling_method(CGAL::L0_resampling::Method::ALOR));
  std::vector<CGAL::L0_resampling::Crease<Kernel>> creases;
  std::vector<CGAL::L0_resampling::Crease_corner<Kernel>> corners;
  const auto to_creases = params::crease_output_iterator(std::back_inserter(creases));
  const auto to_corners = params::corner_output_iterator(std::back_inserter(corners));
  check_refused("crease_output_iterator", "given",
                to_creases.resampling_method(CGAL::L0_resampling::Method::LOR));
  check_refused("crease_output_iterator", "given", to_creases.keep_density(true));
  check_refused("corner_output_iterator", "given",
                to_corners.resampling_method(CGAL::L0_resampling::Method::ALOR));
  for (const auto method : {CGAL::L0_resampling::Method::LOR, CGAL::L0_resampling::Method::ALOR})
    check_refused("noise", "0.25", params::noise(0.25).resampling_method(method));
  check_refused("sharpness_angle", "90.5", params::sharpness_angle(90.5));
  check_refused("outlier_sensitivity", "-0.25", params::outlier_sensitivity(-0.25));
  check_refused("outlier_sensitivity", "3.25", params::outlier_sensitivity(3.25));
  check_refused("outlier_sensitivity", "nan",
                params::outlier_sensitivity(std::numeric_limits<double>::quiet_NaN()));
  check_refused("select_percentage", "100.5", params::select_percentage(100.5));
  check_refused("penalty_growth", "1", params::penalty_growth(1));
  check_refused("penalty_growth", "1.0001", params::penalty_growth(1.0001)); // 30 thousand solves
}

void test_counts()
{
  check_refused("number_of_output_points", "-1", params::number_of_output_points(-1));
  check_refused("number_of_output_points", "4294967295",
                params::number_of_output_points((std::size_t(1) << 32) - 1));
  check_refused("number_of_output_points", "18446744073709551615",
                params::number_of_output_points((std::numeric_limits<std::size_t>::max)()));
  check_refused("number_of_output_points", "nan", params::number_of_output_points(nan));
  check_refused("number_of_normal_filter_iterations", "-1",
                params::number_of_normal_filter_iterations(-1));
  check_refused("number_of_normal_filter_iterations", "10001",
                params::number_of_normal_filter_iterations(10001));
  for (int bad : {-1, 0, 2, 1001})
    check_refused("number_of_orientation_neighbors", std::to_string(bad),
                  params::number_of_orientation_neighbors(bad));
  check_refused("resampling_method", "7",
                params::resampling_method(static_cast<CGAL::L0_resampling::Method>(7)));
}

/// The ends of the permitted ranges, and values so large or small that a product of two overflows.
void test_extreme_values_are_not_refused()
{
  const Points points = sphere(200);
  const auto check = [&](const std::string& name, const auto& np) {
    try
    {
      test::check_clean<Kernel>(
        name, points, test::resample<Kernel, CGAL::Parallel_if_available_tag>(points, np), 100);
    }
    catch (const std::exception& error)
    {
      CHECK(!"no exception");
      std::cerr << "  " << name << ": " << error.what() << std::endl;
    }
  };
  const double largest = (std::numeric_limits<double>::max)(),
               least = std::numeric_limits<double>::denorm_min();
  check("sharpness_angle 90", params::sharpness_angle(90));
  check("sharpness_angle least", params::sharpness_angle(least));
  for (const double sensitivity : {0., least, 3.})
    check("outlier_sensitivity " + std::to_string(sensitivity),
          params::outlier_sensitivity(sensitivity));
  check("noise least", params::noise(least));
  check("noise largest", params::noise(largest));
  check("normal_weight 0", params::normal_weight(0));
  check("normal_weight least", params::normal_weight(least));
  check("normal_weight largest", params::normal_weight(largest));
  check("regularization_weight 0", params::regularization_weight(0));
  check("regularization_weight 1e12", params::regularization_weight(1e12));
  check("normal_weight 0, regularization_weight 0",
        params::normal_weight(0).regularization_weight(0));
  check("maximum_penalty below initial_penalty", params::maximum_penalty(0.01));
  check("initial_penalty least", params::initial_penalty(least).maximum_penalty(least));
  check("initial_penalty least, that growth leaves as it is",
        params::initial_penalty(least).maximum_penalty(100 * least).penalty_growth(1.4));
  check("initial_penalty 1e-300 to 1e300",
        params::initial_penalty(1e-300).maximum_penalty(1e300).penalty_growth(1e10));
  check("initial_penalty 1e12", params::initial_penalty(1e12));
  check("penalty_growth largest", params::penalty_growth(largest));
  check("no filtering", params::number_of_normal_filter_iterations(0));
  check("number_of_orientation_neighbors 3", params::number_of_orientation_neighbors(3));
  check("number_of_orientation_neighbors 1000", params::number_of_orientation_neighbors(1000));
  check("random_seed -1", params::random_seed(-1));
}

/// Where the fit term drowns in the rounding of the others there may be no answer; that ends in the
/// exception for it.
void test_overflowing_weights()
{
  const Points points = sphere(200);
  const double largest = (std::numeric_limits<double>::max)();
  const auto check = [&](const std::string& name, const auto& np) {
    try
    {
      test::check_clean<Kernel>(
        name, points, test::resample<Kernel, CGAL::Parallel_if_available_tag>(points, np), 100);
    }
    catch (const CGAL::L0_resampling::Solver_error&)
    {
      CHECK(true);
    }
  };
  for (double weight : {1e20, 1e100, largest})
  {
    check("regularization_weight", params::regularization_weight(weight));
    check("initial_penalty", params::initial_penalty(weight));
    check("both and normal_weight",
          params::regularization_weight(weight).normal_weight(weight).initial_penalty(weight));
  }
}

void test_points_that_are_not_finite()
{
  for (double bad : {nan, infinity, -infinity})
    for (int axis = 0; axis < 3; ++axis)
    {
      Points points = sphere(100);
      for (std::size_t i : {17, 60})
      {
        Vector v = test::as_vector(points[i]);
        v[axis] = bad;
        points[i] = Kernel::Point_3(v[0], v[1], v[2]);
      }
      const std::string message = refusal(points, params::default_values());
      CHECK(contains(message, "point 17") && contains(message, std::isnan(bad) ? "nan" : "inf"));
      CHECK(contains(refusal(points, params::drop_non_finite(false)), "point 17"));

      const test::Resampled<Kernel> dropped =
        test::resample<Kernel, CGAL::Parallel_if_available_tag>(points,
                                                                params::drop_non_finite(true));
      test::check_clean<Kernel>("dropped", points, dropped, 49);
      CHECK(dropped.report.number_of_dropped_points == 2);
      CHECK(dropped.report.number_of_input_points == 98);
      points.erase(points.begin() + 60);
      points.erase(points.begin() + 17);
      const auto without =
        test::resample<Kernel, CGAL::Parallel_if_available_tag>(points, params::default_values());
      CHECK(test::are_identical<Kernel>(dropped.pairs, without.pairs));
    }
  const Points all_bad(5, Kernel::Point_3(nan, 0, 0));
  for (std::size_t m : {0, 1, 7})
    test::check_clean<Kernel>("nothing left", all_bad,
                              test::resample<Kernel, CGAL::Sequential_tag>(
                                all_bad, params::drop_non_finite(true).number_of_output_points(m)),
                              0);
}

void test_empty_range()
{
  test::check_clean<Kernel>(
    "empty", {}, test::resample<Kernel, CGAL::Sequential_tag>({}, params::default_values()), 0);
  test::check_clean<Kernel>(
    "empty", {},
    test::resample<Kernel, CGAL::Parallel_if_available_tag>({}, params::number_of_output_points(9)),
    0);
}

/// An empty optional is as good as a parameter that is not there, and one with a value as good as
/// the value.
void test_optional_values()
{
  const Points points = sphere(200);
  const auto resampled = [&](const auto& np) {
    return test::resample<Kernel, CGAL::Sequential_tag>(points, np);
  };
  const auto expected = resampled(params::default_values());
  const auto empty = resampled(
    params::normal_weight(std::optional<double>())
      .number_of_output_points(std::optional<int>())
      .neighbor_radius(std::optional<double>())
      .viewpoint(std::optional<Kernel::Point_3>())
      .viewpoint_map(std::optional<CGAL::Constant_property_map<Kernel::Point_3, Kernel::Point_3>>())
      .up_direction(std::optional<Kernel::Vector_3>())
      .normal_map(std::optional<CGAL::Constant_property_map<Kernel::Point_3, Kernel::Vector_3>>()));
  CHECK(test::are_identical<Kernel>(empty.pairs, expected.pairs));
  const auto some = resampled(params::normal_weight(std::optional<double>(0.2))
                                .number_of_output_points(std::optional<int>(30)));
  CHECK(test::are_identical<Kernel>(
    some.pairs, resampled(params::normal_weight(0.2).number_of_output_points(30)).pairs));
  CHECK(some.pairs.size() == 30);
  check_refused("neighbor_radius", "-1", params::neighbor_radius(std::optional<double>(-1)));
}

/// What the report calls the peak is what the call needs: with less it ends in std::bad_alloc.
void test_maximum_memory()
{
  const Points points = sphere(2000);
  for (int n_fold : {0, 1, 3})
  {
    const std::size_t m = n_fold == 0 ? 500 : points.size() * std::size_t(n_fold);
    const auto free = test::resample<Kernel, CGAL::Parallel_if_available_tag>(
      points, params::number_of_output_points(m));
    const std::size_t peak = free.report.peak_bytes;
    CHECK(peak > points.size() * sizeof(Kernel::Point_3));
    const auto limited = test::resample<Kernel, CGAL::Parallel_if_available_tag>(
      points, params::number_of_output_points(m) | params::maximum_memory(peak));
    CHECK(test::are_identical<Kernel>(limited.pairs, free.pairs));
    test::Pairs<Kernel> result;
    for (std::size_t limit = peak - 1; limit > 0; limit /= 2)
      CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
                     points, std::back_inserter(result),
                     params::number_of_output_points(m) | params::maximum_memory(limit)),
                   std::bad_alloc);
    CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::Sequential_tag>(
                   points, std::back_inserter(result), params::maximum_memory(0)),
                 std::bad_alloc);
    CHECK(result.empty());
  }
  // as many as may be asked for: 100 GB
  CHECK_THROWS((test::resample<Kernel, CGAL::Sequential_tag>(
                 points, params::number_of_output_points((std::size_t(1) << 32) - 2)
                           | params::maximum_memory(std::size_t(1) << 30))),
               std::bad_alloc);
}

} // namespace

int main()
{
  test_what_is_no_value();
  test_lengths_and_angles();
  test_counts();
  test_extreme_values_are_not_refused();
  test_overflowing_weights();
  test_points_that_are_not_finite();
  test_empty_range();
  test_optional_values();
  test_maximum_memory();
  return test::result();
}
