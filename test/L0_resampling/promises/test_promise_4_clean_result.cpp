// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Promise 4: what a result is, whatever the input, in every kernel: finite, in its box, of unit
// normals, of the exact count, no point twice.

#include "promise_support.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <string>
#include <vector>

using test::Vector;
namespace params = CGAL::parameters;

namespace {

/// Clouds on which the samples come together, or have little room.
struct Cloud
{
  std::string name;
  std::vector<Vector> points;
};

std::vector<Cloud> clouds()
{
  test::Generator generator(1);
  std::vector<Cloud> result;

  std::vector<Vector> cube = test::cube_points(1500, 1, generator).points;
  test::add_gaussian_noise(cube, 0.01, generator);
  result.push_back({"cube", cube});

  // ten meters at UTM coordinates, where a float resolves a quarter
  std::vector<Vector> building, ground;
  for (const Vector& p : test::cube_points(1500, 10, generator).points)
    building.push_back(p + Vector(456075.1, 5935300.5, 120));
  for (const Vector& p : test::plane_points(1500, 200, generator).points)
    ground.push_back(p + Vector(456075.1, 5935300.5, 120));
  result.push_back({"building", building});
  result.push_back({"ground", ground});

  std::vector<Vector> needle;
  for (int i = 0; i < 800; ++i)
    needle.push_back(test::random_vector(Vector(1, 1e-7, 0), generator));
  result.push_back({"needle", needle});

  std::vector<Vector> uneven;
  for (int i = 0; i < 1000; ++i)
    uneven.push_back(std::exp(test::random_number(-20, 2, generator))
                     * test::random_unit_vector(generator));
  result.push_back({"density that varies by many orders", uneven});
  return result;
}

template <typename Kernel>
void test_clouds(const std::string& kernel_name)
{
  using CGAL::L0_resampling::Method;
  for (const Cloud& cloud : clouds())
  {
    const auto points = test::kernel_points<Kernel>(cloud.points);
    const std::size_t n = points.size();
    const auto check = [&](const std::string& setting, std::size_t m, const auto& np) {
      test::check_clean<Kernel>(kernel_name + ", " + cloud.name + ", " + setting, points,
                                test::resample<Kernel, CGAL::Parallel_if_available_tag>(points, np),
                                m);
    };
    for (std::size_t m : {std::size_t(1), n / 10, n, n + 1, 3 * n})
      check(std::to_string(m), m, params::number_of_output_points(m));
    const double diagonal = cloud.name == "ground" ? 283 : cloud.name == "building" ? 17 : 2;
    for (double share : {1e-3, 1e-2, 0.3, 1.})
      for (Method method : {Method::DEFAULT, Method::LOR})
      {
        const auto np = params::resampling_method(method).neighbor_radius(share * diagonal);
        check("radius", n / 2, np);
        check("radius, more", 2 * n, np.number_of_output_points(2 * n));
      }
    check("ALOR", n / 2, params::resampling_method(Method::ALOR));
    check("LOR, more", 3 * n,
          params::resampling_method(Method::LOR).number_of_output_points(3 * n));
    check("LOR, strong regularization", n / 2,
          params::resampling_method(Method::LOR).regularization_weight(1e6));
    check("strong regularization", n / 2, params::regularization_weight(1e6));
    check("no regularization", n / 2, params::regularization_weight(0));
    check("all jumps kept", n / 2, params::normal_weight(0));
    check("no jump kept", n / 2, params::normal_weight(1e6).maximum_penalty(100));
    check("another seed", n / 2, params::random_seed(12345));
  }
}

/// Coordinates next to the largest number: sums and radii must not leave the range.
template <typename Kernel>
void test_largest_coordinates(const std::string& kernel_name)
{
  test::Generator generator(2);
  std::vector<Vector> sphere = test::sphere_points(300, 1, generator).points;
  for (Vector& p : sphere)
    p *= double((std::numeric_limits<typename Kernel::FT>::max)());
  const auto points = test::kernel_points<Kernel>(sphere);
  for (std::size_t m : {150, 600})
    test::check_clean<Kernel>(
      kernel_name + ", largest coordinates", points,
      test::resample<Kernel, CGAL::Sequential_tag>(points, params::number_of_output_points(m)), m);
  for (Vector& p : sphere)
    p *= double(std::numeric_limits<typename Kernel::FT>::epsilon()) * 1e-38;
  const auto small_points = test::kernel_points<Kernel>(sphere);
  test::check_clean<Kernel>(
    kernel_name + ", small coordinates", small_points,
    test::resample<Kernel, CGAL::Sequential_tag>(small_points, params::default_values()), 150);
}

/// `max(1, floor(n * percentage / 100))`, also for the percentages that binary numbers have not.
void test_counts()
{
  using Kernel = CGAL::Simple_cartesian<double>;
  test::Generator generator(3);
  for (std::size_t n : {1, 2, 3, 10, 99, 100, 101, 199, 250, 1001})
  {
    const auto points = test::kernel_points<Kernel>(test::sphere_points(n, 1, generator).points);
    for (std::size_t percentage : {1, 7, 29, 50, 57, 58, 99, 100})
    {
      const std::size_t expected = (std::max)(std::size_t(1), n * percentage / 100);
      test::check_clean<Kernel>(
        std::to_string(percentage) + " % of " + std::to_string(n), points,
        test::resample<Kernel, CGAL::Sequential_tag>(points, params::select_percentage(percentage)),
        expected);
    }
    CHECK((test::resample<Kernel, CGAL::Sequential_tag>(
             points, params::select_percentage(10).number_of_output_points(5))
             .pairs.size()
           == 5));
  }
}

} // namespace

int main()
{
  test_clouds<CGAL::Simple_cartesian<double>>("double");
  test_clouds<CGAL::Simple_cartesian<float>>("float");
  test_largest_coordinates<CGAL::Simple_cartesian<double>>("double");
  test_largest_coordinates<CGAL::Simple_cartesian<float>>("float");
  test_largest_coordinates<CGAL::Exact_predicates_inexact_constructions_kernel>("EPICK");
  test_counts();
  return test::result();
}
