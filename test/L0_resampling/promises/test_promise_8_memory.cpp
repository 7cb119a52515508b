// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 8: memory is bounded by `maximum_memory`; what the numbers of points alone rule out is
// refused before any point is read, and no number wraps.

#include "promise_support.h"

#include <CGAL/L0_resampling/internal/driver/minimum_memory.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <new>
#include <stdexcept>

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<Kernel::Point_3>;
using CGAL::L0_resampling::Method;
namespace params = CGAL::parameters;

namespace {

constexpr std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();

/// As many points as are wished, none of which is stored.
class Endless_iterator
{
  std::size_t m_place = 0;

public:
  using iterator_category = std::random_access_iterator_tag;
  using value_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using pointer = const std::size_t*;
  using reference = std::size_t;

  explicit Endless_iterator(std::size_t place = 0) : m_place(place) {}
  std::size_t operator*() const { return m_place; }
  Endless_iterator& operator++()
  {
    ++m_place;
    return *this;
  }
  friend std::ptrdiff_t operator-(Endless_iterator a, Endless_iterator b)
  {
    return std::ptrdiff_t(a.m_place) - std::ptrdiff_t(b.m_place);
  }
  friend bool operator==(Endless_iterator a, Endless_iterator b) { return a.m_place == b.m_place; }
  friend bool operator!=(Endless_iterator a, Endless_iterator b) { return a.m_place != b.m_place; }
};

struct Endless_range
{
  std::size_t size;
  Endless_iterator begin() const { return Endless_iterator(0); }
  Endless_iterator end() const { return Endless_iterator(size); }
};

struct Read
{};

/// Throws where a point is read.
struct Unreadable_map
{
  using key_type = std::size_t;
  using value_type = Kernel::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  friend Kernel::Point_3 get(const Unreadable_map&, std::size_t) { throw Read(); }
};

// Each further type of parameters would be one more instance of the whole function to compile.
auto parameters(Method method, std::size_t number_of_output_points, std::size_t limit)
{
  return params::resampling_method(method)
    .number_of_output_points(number_of_output_points)
    .maximum_memory(limit);
}

void resample_unreadable(std::size_t size, std::size_t number_of_output_points,
                         std::size_t limit = unlimited, Method method = Method::DEFAULT)
{
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> out;
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(Endless_range{size}, std::back_inserter(out),
                                                    parameters(method, number_of_output_points,
                                                               limit)
                                                      .point_map(Unreadable_map())
                                                      .geom_traits(Kernel()));
}

/// Beyond 32 bits, and just before.
void test_counts()
{
  const std::size_t largest = 0xfffffffeu, two_to_31 = std::size_t(1) << 31,
                    gibibyte = std::size_t(1) << 30;
  for (std::size_t size : {largest + 1, largest + 2, largest + 2 + 1000, std::size_t(1) << 62})
  {
    CHECK_THROWS(resample_unreadable(size, 5), std::invalid_argument);
    CHECK_THROWS(resample_unreadable(1000, size), std::invalid_argument);
  }
  for (std::size_t size : {two_to_31 - 1, two_to_31, two_to_31 + 1, largest})
  {
    // 2^32 bytes and more, which no arithmetic in 32 bits would see
    for (std::size_t limit : {std::size_t(0), gibibyte, 8 * gibibyte})
    {
      CHECK_THROWS(resample_unreadable(size, 5, limit), std::bad_alloc);
      CHECK_THROWS(resample_unreadable(1000, size, limit), std::bad_alloc);
    }
    CHECK_THROWS(resample_unreadable(size, 5), Read); // without a limit, it is tried
  }
}

test::Resampled<Kernel> resample(const Points& points, Method method, std::size_t m,
                                 std::size_t limit = unlimited)
{
  return test::resample<Kernel, CGAL::Sequential_tag>(points, parameters(method, m, limit));
}

/// The peak that a report states is the least limit that will do, and no limit is passed.
void test_limit(const Points& points, Method method, std::size_t m)
{
  const auto free = resample(points, method, m);
  const std::size_t peak = free.report.peak_bytes;
  CHECK(test::are_identical<Kernel>(resample(points, method, m, peak).pairs, free.pairs));
  CHECK_THROWS(resample(points, method, m, peak - 1), std::bad_alloc);

  // the bound from the numbers alone refuses nothing that would do, and is worth something
  CGAL::L0_resampling::internal::Parameters p;
  p.number_of_output_points = m;
  p.outlier_sensitivity = method == Method::DEFAULT ? 1 : 0;
  const std::size_t least = CGAL::L0_resampling::internal::minimum_memory<float>(points.size(), p);
  CHECK(least <= peak);
  CHECK(10 * least > peak); // many samples of few points have most of it in the lists of neighbors
  CHECK_THROWS(resample_unreadable(points.size(), m, least - 1, method), std::bad_alloc);
  CHECK_THROWS(resample_unreadable(points.size(), m, least, method), Read);
}

void test_limits()
{
  for (std::size_t n : {std::size_t(1000), std::size_t(20000)})
  {
    const Points points = test::kernel_points<Kernel>(test::noisy_cube(n));
    for (Method method : {Method::DEFAULT, Method::LOR, Method::ALOR})
    {
      test_limit(points, method, n / 2);
      test_limit(points, method, 2 * n);
    }
  }
}

/// Also where a radius leaves samples alone: then the neighbors of the orientation are most of it.
void test_small_radius()
{
  test::Generator generator(3);
  const std::size_t n = 6000;
  const Points points = test::kernel_points<Kernel>(test::sphere_points(n, 1, generator).points);
  for (Method method : {Method::DEFAULT, Method::LOR, Method::ALOR})
    for (std::size_t m : {n, 2 * n})
    {
      const auto with_limit = [&](std::size_t limit) {
        return test::resample<Kernel, CGAL::Sequential_tag>(
          points, parameters(method, m, limit).neighbor_radius(1e-3));
      };
      const auto free = with_limit(unlimited);
      CHECK(test::are_identical<Kernel>(with_limit(free.report.peak_bytes).pairs, free.pairs));
    }
}

/// Neighbors apart, the need grows as the number of points does.
void test_growth()
{
  for (Method method : {Method::DEFAULT, Method::LOR})
  {
    const auto bytes_a_point = [&](std::size_t n) {
      const Points points = test::kernel_points<Kernel>(test::noisy_cube(n));
      const auto result = resample(points, method, n * 55 / 100);
      const std::size_t lists =
        12 * result.report.number_of_self_neighbor_pairs; // an index, and two numbers of the solver
      return (double(result.report.peak_bytes) - double(lists)) / double(n);
    };
    const double few = bytes_a_point(10000), many = bytes_a_point(100000);
    std::cout << few << " and " << many << " bytes a point beside the lists of neighbors"
              << std::endl;
    CHECK(test::is_close(few, many, 0.2));
  }
}

} // namespace

int main()
{
  test_counts();
  test_limits();
  test_small_radius();
  test_growth();
  return test::result();
}
