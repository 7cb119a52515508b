// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 6: the unit of length, the place, the order of the points and the signs of given normals
// do not matter.

#include "promise_support.h"

#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Pair = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using CGAL::L0_resampling::Method;
using test::Vector;
namespace params = CGAL::parameters;

namespace {

/// Points with normals.
struct Cloud
{
  std::string name;
  test::Oriented_points points;
  double length; ///< a side of it
};

/// The points rounded to multiples of 2^-20: adding numbers of millions does not round them.
Cloud on_grid(Cloud cloud)
{
  for (Vector& p : cloud.points.points)
    for (double& x : p)
      x = std::ldexp(std::nearbyint(std::ldexp(x, 20)), -20);
  return cloud;
}

/// A cube as a mesh with a normal a face corner gives it: points of an edge come twice and corners
/// three times, each with another normal.
test::Oriented_points cube_of_face_corners(test::Generator& generator)
{
  test::Oriented_points cube = test::cube_points(1200, 1, generator);
  const auto add = [&](const Vector& point, int axis) {
    cube.points.push_back(point);
    cube.normals.push_back((point[axis] > 0 ? 1. : -1.) * Vector::Unit(axis));
  };
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector start(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    for (int axis = 0; axis < 3; ++axis)
    {
      add(start, axis);
      for (int n = 0; n < 10; ++n)
      {
        Vector point = start;
        point[axis] = test::random_number(-0.5, 0.5, generator);
        add(point, (axis + 1) % 3);
        add(point, (axis + 2) % 3);
      }
    }
  }
  return cube;
}

std::vector<Cloud> clouds()
{
  test::Generator generator(3);
  test::Oriented_points noisy_cube = test::cube_points(1500, 1, generator);
  test::add_gaussian_noise(noisy_cube.points, 0.01, generator);
  test::Oriented_points duplicates = noisy_cube;
  duplicates.points.insert(duplicates.points.end(), noisy_cube.points.begin(),
                           noisy_cube.points.begin() + 300);
  duplicates.normals.insert(duplicates.normals.end(), noisy_cube.normals.begin(),
                            noisy_cube.normals.begin() + 300);
  test::Oriented_points lattice{test::lattice_points(9, 0.125), {}};
  for (std::size_t i = 0; i < lattice.points.size(); ++i)
    lattice.normals.push_back(test::random_unit_vector(generator));
  return {{"noisy cube", noisy_cube, 1},
          {"duplicates", duplicates, 1},
          {"cube without noise", test::cube_points(1500, 1, generator), 1},
          {"plane", test::plane_points(800, 1, generator), 1},
          {"sphere", test::sphere_points(800, 10, generator), 20},
          {"lattice", lattice, 1},
          {"cube of face corners", cube_of_face_corners(generator), 1}};
}

/// The point `scale * p + translation` for each point p; normals are used if `with_normals`.
template <typename NamedParameters>
test::Pairs<Kernel> resample(const test::Oriented_points& points, double scale,
                             const Vector& translation, bool with_normals,
                             const NamedParameters& np)
{
  std::vector<Pair> input;
  for (std::size_t i = 0; i < points.points.size(); ++i)
  {
    const Vector p = scale * points.points[i] + translation, n = points.normals[i];
    input.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), Kernel::Vector_3(n[0], n[1], n[2]));
  }
  using Tag = CGAL::Parallel_if_available_tag;
  test::Pairs<Kernel> result;
  const auto with_points = np.point_map(CGAL::First_of_pair_property_map<Pair>());
  if (with_normals)
    CGAL::l0_resample_point_set<Tag>(input, std::back_inserter(result),
                                     with_points.normal_map(
                                       CGAL::Second_of_pair_property_map<Pair>()));
  else
    CGAL::l0_resample_point_set<Tag>(input, std::back_inserter(result), with_points);
  return result;
}

/// The settings that each law is checked with; `f` gets named parameters whose lengths are
/// multiples of `scale`.
template <typename F>
void for_each_setting(const Cloud& cloud, double scale, const F& f)
{
  const double length = scale * cloud.length;
  f(params::select_percentage(50));
  f(params::select_percentage(50) | params::resampling_method(Method::LOR));
  f(params::select_percentage(30) | params::resampling_method(Method::ALOR));
  f(params::neighbor_radius(0.1 * length) | params::normal_filter_radius(0.15 * length));
  f(params::number_of_output_points(2 * cloud.points.points.size()).random_seed(5)
    | params::normal_weight(2));
}

/// The results of `resample()` with `scale` and `translation`, one for each setting.
void add_results(const Cloud& cloud, double scale, const Vector& translation, bool with_normals,
                 std::vector<test::Pairs<Kernel>>& all)
{
  for_each_setting(cloud, scale, [&](const auto& np) {
    all.push_back(resample(cloud.points, scale, translation, with_normals, np));
  });
}

/// Those without normals, and then those with them.
std::vector<test::Pairs<Kernel>> results(const Cloud& cloud, double scale,
                                         const Vector& translation)
{
  std::vector<test::Pairs<Kernel>> all;
  for (bool with_normals : {false, true})
    add_results(cloud, scale, translation, with_normals, all);
  return all;
}

template <typename Law>
void compare(const std::string& name, const Cloud& cloud, const std::vector<test::Pairs<Kernel>>& a,
             const std::vector<test::Pairs<Kernel>>& b, const Law& law)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!CHECK(a[i].size() == b[i].size() && !a[i].empty() && law(a[i], b[i])))
      std::cerr << "  " << name << ", " << cloud.name << ", setting " << i << std::endl;
}

void test_scale(const Cloud& cloud, const std::vector<test::Pairs<Kernel>>& expected)
{
  for (int exponent : {-40, 40, 900})
  {
    const double scale = std::ldexp(1., exponent);
    compare("scale", cloud, expected, results(cloud, scale, Vector::Zero()),
            [&](test::Pairs<Kernel> a, const test::Pairs<Kernel>& b) {
              for (Pair& pair : a)
                pair.first = Kernel::Point_3(scale * pair.first.x(), scale * pair.first.y(),
                                             scale * pair.first.z());
              return test::are_identical<Kernel>(a, b);
            });
  }
}

/// Clouds as they come, with noise and with an uneven density.
std::vector<Cloud> measured_clouds()
{
  test::Generator generator(4);
  std::vector<Cloud> clouds;
  for (double noise : {0.003, 0.02})
  {
    test::Oriented_points cube = test::cube_points(6000, 1, generator);
    test::add_gaussian_noise(cube.points, noise, generator);
    clouds.push_back({"cube with noise " + std::to_string(noise), cube, 1});

    test::Oriented_points sphere = test::sphere_points(9000, 10, generator), uneven;
    test::add_gaussian_noise(sphere.points, 20 * noise, generator);
    for (std::size_t i = 0; i < sphere.points.size(); ++i)
    {
      const double share_kept = 0.05 + 0.95 * std::pow((sphere.points[i].x() + 10) / 20, 2);
      if (test::random_number(0, 1, generator) < share_kept)
      {
        uneven.points.push_back(sphere.points[i]);
        uneven.normals.push_back(sphere.normals[i]);
      }
    }
    clouds.push_back({"uneven sphere with noise " + std::to_string(noise), uneven, 20});
  }
  return clouds;
}

/// Within 1e-6 of the diagonal for factors that are no powers of two, which round the coordinates.
void test_any_scale(const Cloud& cloud)
{
  const auto results_at = [&](double scale) {
    const double length = scale * cloud.length;
    std::vector<test::Pairs<Kernel>> all;
    const auto add = [&](const auto& np) {
      all.push_back(resample(cloud.points, scale, Vector::Zero(), false, np));
    };
    add(params::select_percentage(50));
    add(params::select_percentage(50) | params::keep_density(true));
    add(params::select_percentage(50).neighbor_radius(0.1 * length));
    add(params::select_percentage(50) | params::resampling_method(Method::LOR));
    return all;
  };
  const std::vector<test::Pairs<Kernel>> expected = results_at(1);
  for (double scale : {3., 1. / 3, 1000., 0.001, 0.3048, 7.})
    compare("times " + std::to_string(scale), cloud, expected, results_at(scale),
            [&](const auto& a, const auto& b) {
              const double minimum_diagonal = std::sqrt(3.) * cloud.length;
              for (std::size_t i = 0; i < a.size(); ++i)
                if (!((test::as_vector(b[i].first) / scale - test::as_vector(a[i].first)).norm()
                        <= 1e-6 * minimum_diagonal
                      && (test::as_vector(b[i].second) - test::as_vector(a[i].second)).norm()
                           <= 1e-4))
                  return false;
              return true;
            });
}

/// At UTM offsets and at the largest coordinates of maps.
std::vector<Vector> translations()
{
  const Vector utm(456075, 5935300.5, 120.25);
  return {utm, Vector(-1e7, 0.5, 1e7)};
}

/// Where the translation rounds no input, the result is the same bitwise but for the last step,
/// which puts it where the input was: it rounds, and keeps apart what rounding has joined.
void test_exact_translation(const Cloud& cloud)
{
  const std::vector<test::Pairs<Kernel>> expected = results(cloud, 1, Vector::Zero());
  for (const Vector& translation : translations())
  {
    const double largest = translation.cwiseAbs().maxCoeff() + 2 * cloud.length;
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * largest;
    const auto is_moved = [&](const Pair& a, const Pair& b) {
      const Vector p = test::as_vector(a.first) + translation, q = test::as_vector(b.first);
      return a.second == b.second && (p - q).cwiseAbs().maxCoeff() <= rounding;
    };
    using Pairs = test::Pairs<Kernel>;
    const auto law = [&](const Pairs& a, const Pairs& b) {
      const auto begin = a.begin(), end = a.end();
      return std::equal(begin, end, b.begin(), is_moved);
    };
    compare("exact translation", cloud, expected, results(cloud, 1, translation), law);
  }
}

/// Points in the order of their first coordinates.
class Sorted_pairs
{
  test::Pairs<Kernel> m_pairs;

public:
  explicit Sorted_pairs(const test::Pairs<Kernel>& pairs) : m_pairs(pairs)
  {
    std::stable_sort(m_pairs.begin(), m_pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.first.x() < b.first.x(); });
  }

  /// Calls `f` with each pair whose first coordinate is at most `distance` from `x`, and may be
  /// that of others; `f` may make `distance` smaller.
  template <typename F>
  void for_each_near(double x, const double& distance, const F& f) const
  {
    const auto middle = std::partition_point(m_pairs.begin(), m_pairs.end(),
                                             [&](const Pair& y) { return y.first.x() < x; });
    for (auto y = middle; y != m_pairs.end() && y->first.x() - x <= distance; ++y)
      f(*y);
    for (auto y = middle; y != m_pairs.begin() && x - std::prev(y)->first.x() <= distance; --y)
      f(*std::prev(y));
  }
};

/// The greatest distance of a point of `a` to the nearest of `b`.
double one_sided_distance(const test::Pairs<Kernel>& a, const test::Pairs<Kernel>& b)
{
  const Sorted_pairs sorted(b);
  double greatest = 0;
  for (const Pair& x : a)
  {
    double nearest = std::numeric_limits<double>::infinity();
    sorted.for_each_near(x.first.x(), nearest, [&](const Pair& y) {
      nearest = (std::min)(nearest, (test::as_vector(x.first) - test::as_vector(y.first)).norm());
    });
    greatest = (std::max)(greatest, nearest);
  }
  return greatest;
}

double diagonal(const std::vector<Vector>& points)
{
  Vector low = points.front(), high = points.front();
  for (const Vector& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// Settings that leave the lengths and weights to the method come first, see `for_each_setting()`.
bool has_default_lengths(std::size_t setting) { return setting % 5 < 3; }

/// Where the translation rounds the input, the result moves with it within 1e-6 of the diagonal;
/// with lengths, weights or more points given, within 1e-4. The cloud is as large as a building.
/// The deviation is that of single precision within the balls, however little the input is rounded.
void test_translation(const Cloud& cloud, const std::vector<test::Pairs<Kernel>>& expected)
{
  const double scale = 128; // a power of two, so that it does not round
  for (const Vector& translation : translations())
  {
    std::vector<test::Pairs<Kernel>> moved_back = results(cloud, scale, translation);
    for (std::size_t i = 0; i < moved_back.size(); ++i)
    {
      for (Pair& pair : moved_back[i])
      {
        const Vector p = (test::as_vector(pair.first) - translation) / scale;
        pair.first = Kernel::Point_3(p[0], p[1], p[2]);
      }
      const double distance = (std::max)(one_sided_distance(expected[i], moved_back[i]),
                                         one_sided_distance(moved_back[i], expected[i]));
      const double tolerance = has_default_lengths(i) ? 1e-6 : 1e-4;
      const double share = distance / diagonal(cloud.points.points);
      if (!CHECK(expected[i].size() == moved_back[i].size() && share <= tolerance))
        std::cerr << "  " << cloud.name << ", setting " << i << ": " << share << std::endl;
    }
  }
}

/// Points for each of which there is a point of the other set, and its normal, closer than 1e-9 of
/// the size.
bool are_same_set(const test::Pairs<Kernel>& a, const test::Pairs<Kernel>& b, double length)
{
  const Sorted_pairs sorted(b);
  const double tolerance = 1e-9 * length;
  return std::all_of(a.begin(), a.end(), [&](const Pair& x) {
    bool is_there = false;
    sorted.for_each_near(x.first.x(), tolerance, [&](const Pair& y) {
      is_there |= (test::as_vector(x.first) - test::as_vector(y.first)).norm() <= tolerance
                  && (test::as_vector(x.second) - test::as_vector(y.second)).norm() <= 1e-6;
    });
    return is_there;
  });
}

void test_permutation(const Cloud& cloud, const std::vector<test::Pairs<Kernel>>& expected)
{
  test::Generator generator(2);
  for (int run = 0; run < 2; ++run)
  {
    std::vector<std::size_t> order(cloud.points.points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::shuffle(order.begin(), order.end(), generator);
    Cloud shuffled = cloud;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      shuffled.points.points[i] = cloud.points.points[order[i]];
      shuffled.points.normals[i] = cloud.points.normals[order[i]];
    }
    compare("permutation", cloud, expected, results(shuffled, 1, Vector::Zero()),
            [&](const auto& a, const auto& b) {
              return are_same_set(a, b, cloud.length) && are_same_set(b, a, cloud.length);
            });
  }
}

/// \param all without normals, and then with them
void test_signs_of_normals(const Cloud& cloud, const std::vector<test::Pairs<Kernel>>& all)
{
  const std::vector<test::Pairs<Kernel>> expected(all.begin() + std::ptrdiff_t(all.size() / 2),
                                                  all.end());
  test::Generator generator(3);
  for (int run = 0; run < 2; ++run)
  {
    Cloud turned = cloud;
    for (Vector& n : turned.points.normals)
      if (test::random_number(0, 1, generator) < 0.5)
        n = -n;
    std::vector<test::Pairs<Kernel>> found;
    add_results(turned, 1, Vector::Zero(), true, found);
    compare("signs", cloud, expected, found, [&](const auto& a, const auto& b) {
      return are_same_set(a, b, cloud.length) && are_same_set(b, a, cloud.length);
    });
  }
}

} // namespace

int main()
{
  for (const Cloud& cloud : clouds())
  {
    const std::vector<test::Pairs<Kernel>> expected = results(cloud, 1, Vector::Zero());
    test_scale(cloud, expected);
    test_translation(cloud, expected);
    test_exact_translation(on_grid(cloud));
    test_permutation(cloud, expected);
    test_signs_of_normals(cloud, expected);
  }
  for (const Cloud& cloud : measured_clouds())
    test_any_scale(cloud);
  return test::result();
}
