// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 8: memory is bounded by `maximum_memory`; what the numbers of points alone rule out is refused before any point is read, and no number wraps.

#include "promise_support.h"

#include <CGAL/L0_resampling/internal/least_memory.h>

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

template <typename NamedParameters>
void resample_unreadable(std::size_t size, const NamedParameters& np)
{
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> out;
  CGAL::l0_resample_point_set<CGAL::Sequential_tag>(Endless_range{size}, std::back_inserter(out),
                                                    np.point_map(Unreadable_map()).geom_traits(Kernel()));
}

/// Beyond 32 bits, and just before.
void test_counts()
{
  const std::size_t largest = 0xfffffffeu, two_to_31 = std::size_t(1) << 31, gibibyte = std::size_t(1) << 30;
  for (std::size_t size : {largest + 1, largest + 2, largest + 2 + 1000, std::size_t(1) << 62})
  {
    CHECK_THROWS(resample_unreadable(size, params::number_of_output_points(5)), std::invalid_argument);
    CHECK_THROWS(resample_unreadable(1000, params::number_of_output_points(size)), std::invalid_argument);
  }
  for (std::size_t size : {two_to_31 - 1, two_to_31, two_to_31 + 1, largest})
  {
    // 2^32 bytes and more, which no arithmetic in 32 bits would see
    for (std::size_t limit : {std::size_t(0), gibibyte, 8 * gibibyte})
    {
      CHECK_THROWS(resample_unreadable(size, params::maximum_memory(limit).number_of_output_points(5)), std::bad_alloc);
      CHECK_THROWS(resample_unreadable(1000, params::maximum_memory(limit).number_of_output_points(size)), std::bad_alloc);
    }
    CHECK_THROWS(resample_unreadable(size, params::number_of_output_points(5)), Read); // without a limit, it is tried
  }
}

/// \returns what of the limit is needed
template <typename NamedParameters>
void test_limit(const Points& points, Method method, const NamedParameters& np)
{
  const auto with_limit = [&](std::size_t limit) {
    return test::resample<Kernel, CGAL::Sequential_tag>(points, np.maximum_memory(limit));
  };
  const auto free = with_limit((std::numeric_limits<std::size_t>::max)());
  const std::size_t peak = free.report.peak_bytes;
  CHECK(test::are_identical<Kernel>(with_limit(peak).pairs, free.pairs));
  CHECK_THROWS(with_limit(peak - 1), std::bad_alloc);

  // the bound from the numbers alone is none that refuses what would do, and is worth something
  CGAL::L0_resampling::internal::Parameters parameters;
  parameters.number_of_output_points = free.pairs.size();
  parameters.drop_outliers = method == Method::DEFAULT;
  const std::size_t least = CGAL::L0_resampling::internal::least_memory<float>(points.size(), parameters);
  CHECK(least <= peak);
  CHECK(4 * least > peak);
  CHECK_THROWS(resample_unreadable(points.size(), np.maximum_memory(least - 1)), std::bad_alloc);
  CHECK_THROWS(resample_unreadable(points.size(), np.maximum_memory(least)), Read);
}

void test_limits()
{
  for (std::size_t n : {std::size_t(1000), std::size_t(20000)})
  {
    const Points points = test::kernel_points<Kernel>(test::noisy_cube(n));
    for (Method method : {Method::DEFAULT, Method::LOR, Method::ALOR})
    {
      test_limit(points, method, params::resampling_method(method).number_of_output_points(n / 2));
      test_limit(points, method, params::resampling_method(method).number_of_output_points(2 * n));
    }
  }
}

/// The bytes a point that the manual states
void test_bytes_a_point()
{
  const std::size_t n = 100000;
  const Points points = test::kernel_points<Kernel>(test::noisy_cube(n));
  for (Method method : {Method::DEFAULT, Method::LOR})
  {
    const auto result = test::resample<Kernel, CGAL::Parallel_if_available_tag>(
      points, params::resampling_method(method).number_of_output_points(n * 55 / 100));
    CHECK(result.report.peak_bytes < 300 * n);
  }
}

} // namespace

int main()
{
  test_counts();
  test_limits();
  test_bytes_a_point();
  return test::result();
}
