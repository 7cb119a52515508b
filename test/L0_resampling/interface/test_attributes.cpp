// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What points of the result take from the input: the index of the nearest point, and the properties
// of a Point_set_3.

#include "promise_support.h"

#include <CGAL/IO/Color.h>
#include <CGAL/L0_resampling/find_near_points.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point_set = CGAL::Point_set_3<Kernel::Point_3>;
using CGAL::L0_resampling::Method;
using test::Vector;
using test::noisy_cube;
namespace params = CGAL::parameters;

namespace {

/// The index of the nearest point, the smallest of those at one distance; those that are not finite
/// are none.
std::size_t nearest_index(const std::vector<Vector>& points, const Vector& query)
{
  std::size_t nearest = points.size();
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < points.size(); ++j)
    if ((points[j] - query).squaredNorm() < smallest)
    {
      smallest = (points[j] - query).squaredNorm();
      nearest = j;
    }
  return nearest;
}

/// Both maps, from both kinds of runs.
struct Maps
{
  std::vector<std::size_t> sources;
  std::vector<float> confidences;
};

template <typename Tag, typename K, typename NamedParameters>
test::Pairs<K> resample_with_maps(const std::vector<typename K::Point_3>& points, std::size_t size,
                                  const NamedParameters& np, Maps& maps)
{
  test::Pairs<K> result;
  maps.sources.assign(size, (std::numeric_limits<std::size_t>::max)());
  maps.confidences.assign(size, -1);
  CGAL::l0_resample_point_set<Tag>(
    points, std::back_inserter(result),
    np | params::source_index_map(CGAL::make_property_map(maps.sources))
      | params::feature_confidence_map(CGAL::make_property_map(maps.confidences)));
  return result;
}

/// `find_near_points()` says the same of a result as the call that gave it, and adds a stage to its
/// report; once it is told to stop, it says nothing.
template <typename K>
void check_near_points(const std::string& name, const std::vector<typename K::Point_3>& points,
                       const test::Pairs<K>& result, const std::vector<std::size_t>& sources)
{
  using CGAL::L0_resampling::Near_points;
  const auto np = params::query_point_map(
    CGAL::First_of_pair_property_map<typename test::Pairs<K>::value_type>());
  CGAL::L0_resampling::Report report;
  report.stages.push_back({"before", 1, 2});
  const Near_points near = CGAL::L0_resampling::find_near_points<CGAL::Parallel_if_available_tag>(
    points, result, 8, np | params::resampling_report(&report));
  CHECK(near.count == 8 && report.stages.size() == 2);
  CHECK(report.stages[0].seconds == 1 && report.stages[0].peak_bytes == 2);
  CHECK(report.stages[1].name == "near points");
  bool are_nearest = true, are_means = true;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    are_nearest = are_nearest && near.nearest(i) == sources[i];
    are_means = are_means && near.mean(i, [](std::size_t) { return 0.7; }) == 0.7;
  }
  if (!CHECK(are_nearest && are_means))
    std::cerr << "  " << name << std::endl;
  const Near_points none = CGAL::L0_resampling::find_near_points<CGAL::Sequential_tag>(
    points, result, 8, np.callback([](double) { return false; }));
  CHECK(none.count == 0);
}

template <typename K, typename NamedParameters>
void check_maps(const std::string& name, const std::vector<Vector>& input, std::size_t size,
                const NamedParameters& np)
{
  const auto points = test::kernel_points<K>(input);
  std::vector<Vector> rounded;
  for (const auto& p : points)
    rounded.push_back(test::as_vector(p));
  Maps maps, parallel_maps;
  const auto result = resample_with_maps<CGAL::Sequential_tag, K>(points, size, np, maps);
  const auto parallel = resample_with_maps<CGAL::Parallel_if_available_tag, K>(points, size, np,
                                                                               parallel_maps);
  CHECK(test::are_identical<K>(result, parallel));
  CHECK(maps.sources == parallel_maps.sources && maps.confidences == parallel_maps.confidences);
  test::Pairs<K> without;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(points, std::back_inserter(without),
                                                               np);
  CHECK(test::are_identical<K>(result, without)); // to be asked changes nothing

  bool are_nearest = result.size() == size, are_confidences = true;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    are_nearest = are_nearest
                  && maps.sources[i] == nearest_index(rounded, test::as_vector(result[i].first));
    are_confidences = are_confidences && maps.confidences[i] >= 0 && maps.confidences[i] <= 1;
  }
  if (!CHECK(are_nearest && are_confidences))
    std::cerr << "  " << name << std::endl;
  if (size > 0)
    check_near_points<K>(name, points, result, maps.sources);
}

void test_source_indices()
{
  std::vector<Vector> points = noisy_cube(1500);
  check_maps<Kernel>("default", points, 750, params::select_percentage(50));
  check_maps<Kernel>("LOR", points, 750,
                     params::select_percentage(50) | params::resampling_method(Method::LOR));
  check_maps<Kernel>("more than the input", points, 3000, params::number_of_output_points(3000));
  check_maps<CGAL::Simple_cartesian<float>>("float", points, 750, params::select_percentage(50));

  for (std::size_t i = 0; i < 300; ++i) // the same points again: the first of each pair is meant
    points.push_back(points[2 * i]);
  points.emplace_back(1e9, 0, 0);
  check_maps<Kernel>("duplicates and an outlier", points, 900,
                     params::number_of_output_points(900));
  for (std::size_t i :
       {0, 7, 500}) // the places in the range are meant, not those among the finite points
    points[i][1] = std::numeric_limits<double>::quiet_NaN();
  check_maps<Kernel>("dropped points", points, 900,
                     params::number_of_output_points(900) | params::drop_non_finite(true));
  check_maps<Kernel>("one place", std::vector<Vector>(40, Vector(1, 2, 3)), 20,
                     params::select_percentage(50));
  check_maps<Kernel>("one point", {Vector(1, 2, 3)}, 1, params::select_percentage(50));
  check_maps<Kernel>("no point", {}, 0, params::select_percentage(50));

  std::vector<Vector> lattice; // where the result is as far from two points or more
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 20; ++y)
      lattice.emplace_back(x, y, 0);
  check_maps<Kernel>("lattice", lattice, 1000, params::number_of_output_points(1000));
}

/// Throws for one of the points.
struct Throwing_map
{
  using key_type = std::size_t;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::writable_property_map_tag;
};
void put(const Throwing_map&, std::size_t key, std::size_t)
{
  if (key == 100)
    throw std::domain_error("of the map");
}

void test_throwing_map()
{
  const auto points = test::kernel_points<Kernel>(noisy_cube(500));
  test::Pairs<Kernel> result;
  CHECK_THROWS(CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
                 points, std::back_inserter(result), params::source_index_map(Throwing_map())),
               std::domain_error);
  CHECK(result.empty());
}

// CGAL 5 answers with a pair, CGAL 6 with an optional.
template <typename Map>
Map map_of(const std::pair<Map, bool>& found)
{
  CHECK(found.second);
  return found.first;
}
template <typename Optional, typename = typename Optional::value_type>
typename Optional::value_type map_of(const Optional& found)
{
  CHECK(found.has_value());
  return *found;
}

template <typename T>
Point_set::Property_map<T> add_map(Point_set& points, const std::string& name, T value)
{
  return points.add_property_map<T>(name, value).first;
}

void test_properties()
{
  Point_set points;
  for (const Vector& p : noisy_cube(3000))
    points.insert(Kernel::Point_3(p[0], p[1], p[2]));
  const auto height = add_map(points, "height", 0.);
  const auto weight = add_map(points, "weight", 0.f);
  const auto label = add_map(points, "label", 0);
  const auto float_label = add_map(points, "float_label", 0.f);
  const auto red = add_map<std::uint8_t>(points, "red", 0);
  const auto green = add_map<std::uint8_t>(points, "green", 0);
  const auto byte = add_map<std::uint8_t>(points, "class", 0);
  const auto color = add_map(points, "color", CGAL::IO::Color(1, 2, 3));
  const auto word = add_map(points, "word", std::string());
  const auto flag = add_map(points, "flag", false);
  for (const Point_set::Index& i : points)
  {
    const Kernel::Point_3& p = points.point(i);
    height[i] = p.z();
    weight[i] = 0.1f;
    label[i] = p.x() > 0 ? -7 : 1000000;
    float_label[i] = float(label[i]);
    red[i] = std::uint8_t(p.x() > 0 ? 200 : 100);
    green[i] = 77;
    byte[i] = std::uint8_t(p.x() > 0 ? 200 : 100);
    color[i] = CGAL::IO::Color(p.x() > 0 ? 200 : 100, 20, 30, 40);
    word[i] = p.x() > 0 ? "right" : "left";
    flag[i] = p.x() > 0;
  }
  points.remove(points.begin()
                + 5); // the last one takes its place in the range, and not among the indices

  Point_set result, plain;
  result.insert(Kernel::Point_3(9, 9, 9));
  const auto own = add_map(result, "own", 5);
  auto source = add_map<std::size_t>(result, "source", 12345);
  const auto confidence = add_map(result, "confidence", -1.f);
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, result, params::source_index_map(source).feature_confidence_map(confidence));
  Point_set bare;
  for (const Point_set::Index& i : points)
    bare.insert(points.point(i));
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(bare, plain);
  CHECK(result.size() == 1 + plain.size() && result.has_normal_map() && !points.has_normal_map());
  CHECK(result.point(0) == Kernel::Point_3(9, 9, 9) && source[0] == 12345 && own[0] == 5
        && confidence[0] == -1);

  const auto result_height = map_of(result.property_map<double>("height"));
  const auto result_weight = map_of(result.property_map<float>("weight"));
  const auto result_label = map_of(result.property_map<int>("label"));
  const auto result_float_label = map_of(result.property_map<float>("float_label"));
  const auto result_red = map_of(result.property_map<std::uint8_t>("red"));
  const auto result_green = map_of(result.property_map<std::uint8_t>("green"));
  const auto result_byte = map_of(result.property_map<std::uint8_t>("class"));
  const auto result_color = map_of(result.property_map<CGAL::IO::Color>("color"));
  const auto result_word = map_of(result.property_map<std::string>("word"));
  const auto result_flag = map_of(result.property_map<bool>("flag"));
  double maximum_error = 0;
  std::size_t number_of_mixed = 0;
  bool are_nearest = true, are_constant = true, are_alike = true, are_same = true;
  for (std::size_t k = 1; k < result.size(); ++k)
  {
    const Point_set::Index i = *(result.begin() + std::ptrdiff_t(k)),
                           j = *(points.begin() + std::ptrdiff_t(source[i]));
    are_same = are_same && result.point(i) == plain.point(k - 1)
               && result.normal(i) == plain.normal(k - 1) && confidence[i] >= 0;
    are_nearest = are_nearest && result_label[i] == label[j]
                  && result_float_label[i] == float_label[j] && result_byte[i] == byte[j]
                  && result_word[i] == word[j] && result_flag[i] == flag[j];
    const CGAL::IO::Color& c = result_color[i];
    are_constant = are_constant && result_weight[i] == 0.1f && result_green[i] == 77 && c.g() == 20
                   && c.b() == 30 && c.a() == 40;
    are_alike = are_alike && c.r() == result_red[i] && result_red[i] >= 100 && result_red[i] <= 200;
    number_of_mixed += result_red[i] > 100 && result_red[i] < 200;
    maximum_error = (std::max)(maximum_error, std::abs(result_height[i] - result.point(i).z()));
  }
  CHECK(are_same && are_nearest && are_constant && are_alike);
  CHECK(number_of_mixed > 10
        && number_of_mixed < result.size() / 5); // where left meets right, and nowhere else
  CHECK(maximum_error < 0.05);                   // a few spacings
  CHECK(!map_of(result.property_map<bool>("flag"))[0] && result_height[0] == 0);
}

/// The properties of a result.
template <typename T>
std::vector<T> values_of(const Point_set& result, const std::string& name)
{
  const auto map = map_of(result.property_map<T>(name));
  std::vector<T> values;
  for (const Point_set::Index& i : result)
    values.push_back(map[i]);
  return values;
}

// There are no means of labels with fractions, nor with what stands for no data; of the channels of
// a color there are, whatever its type.
void test_meanings_of_values()
{
  constexpr float no_depth = -9999;
  Point_set points;
  for (const Vector& p : noisy_cube(3000))
    points.insert(Kernel::Point_3(p[0], p[1], p[2]));
  const auto phase = add_map(points, "phase", 0.);
  const auto depth = add_map(points, "depth", 0.f);
  const auto red = add_map<std::uint16_t>(points, "red", 0);
  const auto alpha = add_map(points, "alpha", 0.f);
  for (const Point_set::Index& i : points)
  {
    const Kernel::Point_3& p = points.point(i);
    const bool is_right = p.x() > 0;
    phase[i] = is_right ? 0.5 : 1.5;
    depth[i] = is_right || i % 3 == 0 ? no_depth : float(p.z());
    red[i] = is_right ? 65000 : 100;
    alpha[i] = is_right ? 1.f : 0.f;
  }
  Point_set result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(points, result);

  const auto number_of = [](const auto& values, const auto& is_wanted) {
    return std::size_t(std::count_if(values.begin(), values.end(), is_wanted));
  };
  const auto phases = values_of<double>(result, "phase");
  CHECK(number_of(phases, [](double v) { return v == 0.5 || v == 1.5; }) == result.size());
  const auto depths = values_of<float>(result, "depth");
  const std::size_t number_of_depths = number_of(depths, [](float v) { return std::abs(v) < 2; });
  CHECK(number_of(depths, [&](float v) { return v == no_depth; }) + number_of_depths
        == result.size());
  CHECK(number_of_depths > result.size() / 3 && number_of_depths < result.size() * 2 / 3);
  CHECK(number_of(values_of<std::uint16_t>(result, "red"),
                  [](std::uint16_t v) { return v > 100 && v < 65000; })
        > 10);
  CHECK(number_of(values_of<float>(result, "alpha"), [](float v) { return v > 0 && v < 1; }) > 10);
}

} // namespace

int main()
{
  test_source_indices();
  test_throwing_map();
  test_properties();
  test_meanings_of_values();
  return test::result();
}
