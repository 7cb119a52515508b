// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/estimate_scales.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace test;

Scales scales_of(const std::vector<Vector>& points)
{
  Vector low = points.front(), high = points.front();
  for (const Vector& p : points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Unwatched unwatched;
  const double radius = (high - low).norm() / std::cbrt(double(points.size()));
  const Scales in_radii = estimate_scales<CGAL::Parallel_if_available_tag, float>(
    to_buffer(points), radius, unwatched.progress);
  return {in_radii.spacing * radius, in_radii.noise * radius};
}

/// Spacing and noise of a surface come out within 15 %, the spacing within 20 % where the noise is
/// twice as large, and noise that is as large as the spacing: the balls, of few points, are partly
/// taken for two sheets there. Where there is no noise, its bending is not taken for much.
void check_scales(std::vector<Vector> points, double area, Generator& generator)
{
  const double spacing = std::sqrt(area / double(points.size()));
  const std::vector<Vector> clean = points;
  CHECK(is_close(scales_of(clean).spacing, spacing, 0.15));
  CHECK(scales_of(clean).noise < 0.2 * spacing);
  for (double noise : {0.5 * spacing, spacing, 2 * spacing})
  {
    points = clean;
    add_gaussian_noise(points, noise, generator);
    const Scales scales = scales_of(points);
    // balls around points that are off the sheet, or at its border, hold fewer, and stand for more
    // of the area
    CHECK(is_close(scales.spacing, spacing, noise < 2 * spacing ? 0.15 : 0.2));
    CHECK(is_close(scales.noise, noise, noise == spacing ? 0.2 : 0.15));
  }
}

/// The spacing is that of half of the surface, though most points lie where they are dense.
void check_uneven_density(Generator& generator)
{
  std::vector<Vector> points =
    plane_points(9000, 1, generator).points; // the unit square around the origin
  for (const Vector& p : plane_points(3000, 1, generator).points)
    points.push_back(p + Vector(1, 0, 0));
  for (const Vector& p : plane_points(3000, 1, generator).points)
    points.push_back(p + Vector(2, 0, 0));
  CHECK(is_close(scales_of(points).spacing, std::sqrt(1. / 3000), 0.12));
}

/// The two sheets of a thin plate, closer than the first balls are wide, are not taken for one
/// noisy sheet.
void check_plate(double thickness, double noise, Generator& generator)
{
  std::vector<Vector> points = plane_points(10000, 3, generator).points;
  const double spacing = std::sqrt(9 / double(points.size()));
  for (const Vector& p : plane_points(10000, 3, generator).points)
    points.push_back(p + Vector(0, 0, thickness * spacing));
  add_gaussian_noise(points, noise * spacing, generator);
  const Scales scales = scales_of(points);
  CHECK(is_close(scales.spacing, spacing,
                 0.08)); // the balls hold less of the other sheet than of their own
  // and not half the thickness; the first balls hold a little of the other sheet where it is as far
  // as they reach: 0.41 more at 4 spacings
  CHECK(scales.noise < (noise + 0.45) * spacing);
  CHECK(scales.noise > 0.6 * noise * spacing);
}

/// Where outliers make the two peaks of their heights less clear, and balls hold few points, the
/// noise is still less than half of the thickness.
void check_plate_with_outliers(Generator& generator)
{
  const double noise = 0.006, thickness = 0.025;
  std::vector<Vector> points;
  for (double z : {0., thickness})
    for (const Vector& p : plane_points(6000, 1, generator).points)
      points.push_back(p + Vector(0, 0, z));
  add_gaussian_noise(points, noise, generator);
  for (int i = 0; i < 800; ++i)
    points.push_back(random_vector(Vector(0.5, 0.5, 0.05), generator));
  const double estimate = scales_of(points).noise;
  CHECK(estimate > 0.75 * noise && estimate < 0.95 * thickness / 2);
}

/// A thin plate of so few points that no ball of them tells of two sheets: all balls together do.
void check_plate_of_few_points(Generator& generator)
{
  const double noise = 0.005, thickness = 0.025;
  std::vector<Vector> points;
  for (double z : {0., thickness})
    for (const Vector& p : plane_points(2000, 1, generator).points)
      points.push_back(p + Vector(0, 0, z));
  add_gaussian_noise(points, noise, generator);
  CHECK(is_close(scales_of(points).noise, noise, 0.25));
}

/// Where a shape is hardly wider than its noise, the balls do not grow until they find its width,
/// not even with outliers.
void check_tube(double radius, double noise, std::size_t number_of_outliers, Generator& generator)
{
  std::vector<Vector> points;
  for (int i = 0; i < 12000; ++i)
  {
    const double angle = random_number(0, 2 * EIGEN_PI, generator);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                        random_number(-1, 1, generator));
  }
  add_gaussian_noise(points, noise, generator);
  for (std::size_t i = 0; i < number_of_outliers; ++i)
    points.push_back(random_vector(Vector(0.3, 0.3, 1), generator));
  const double estimate = scales_of(points).noise;
  CHECK(estimate > 0.8 * noise && estimate < 1.25 * noise);
}

/// Nor do the balls around far outliers count, which hold nothing else, though they are more than
/// the third tenth.
void check_crowd(double noise, Generator& generator)
{
  std::vector<Vector> points = sphere_points(20000, 1, generator).points;
  add_gaussian_noise(points, noise, generator);
  for (int i = 0; i < 12000; ++i)
    points.push_back(random_vector(2, generator));
  CHECK(is_close(scales_of(points).noise, noise, 0.15));
}

/// Noise is read in balls that hold it, and none of a ball that it fills.
void check_sheet_in_ball(Generator& generator)
{
  const double largest = std::numeric_limits<double>::infinity();
  double before = 0;
  for (const double deviation : {0., 0.05, 0.1, 0.2, 0.3, 0.35, 0.37, 0.38})
  {
    const double noise = noise_of_sheet(deviation, 1, 100);
    CHECK(noise >= deviation && noise < largest && (noise > before || deviation == 0));
    before = noise;
  }
  CHECK(is_close(noise_of_sheet(0.05, 1, 100), 0.05, 0.01));
  CHECK(noise_of_sheet(0.365, 1, 100) > 20);
  for (const double noise : {0.01, 0.2, 0.4})
  {
    std::normal_distribution<double> gaussian(0, noise);
    double in_ball = 0;
    const int n = 200000;
    for (int i = 0; i < n; ++i)
      in_ball += (std::max)(1 - square(gaussian(generator)), 0.);
    CHECK(is_close(share_of_sheet_in_ball(noise), in_ball / n, 0.01));
  }
}

/// The variance of a sheet is known among points that fill its ball, and as it is without any.
void check_variance_among_outliers(Generator& generator)
{
  const int n = 4000;
  for (const double noise : {0.1, 0.2})
    for (const double share : {0., 0.05, 0.15})
    {
      Height_moments<double> heights;
      double sum = 0, squares = 0, of_sheet = 0;
      std::normal_distribution<double> gaussian(0, noise);
      const auto add = [&](double height) {
        heights.add(height, 1);
        sum += height;
        squares += square(height);
      };
      for (int i = 0; i < n; ++i)
        if (i < share * n)
        {
          Vector p = cube_points(1, 2, generator).points[0];
          do
            p = random_vector(1, generator);
          while (p.norm() > 1);
          add(p[2]);
        }
        else
        {
          double height = gaussian(generator);
          while (random_number(0, 1, generator) > 1 - square(height)) // the ball's room there
            height = gaussian(generator);
          of_sheet += square(height) / (n - share * n);
          add(height);
        }
      const double all = squares / n - square(sum / n),
                   sheet = variance_without_outliers({double(n), all, heights.shape(n)}, 1);
      CHECK(is_close(sheet, of_sheet, share == 0 ? 0.05 : 0.3));
      CHECK(share == 0 || sheet < all);
    }
}

/// With noise that grows in steps of a tenth, the estimate grows by about as much, never falls, and
/// is never far off: by most where the noise is as large as the spacing, as above.
void check_noise_sweep(const std::vector<Vector>& clean, double spacing)
{
  double before = 0;
  for (double noise = 0.5 * spacing; noise < 6 * spacing; noise *= 1.1)
  {
    std::vector<Vector> points = clean;
    Generator generator(5); // the same errors, which grow
    add_gaussian_noise(points, noise, generator);
    const Scales scales = scales_of(points);
    CHECK(is_close(scales.noise, noise, std::abs(noise / spacing - 1) < 0.2 ? 0.3 : 0.18));
    const double radius = default_radius(scales.spacing, scales.noise);
    CHECK(radius > 0.99 * before && (before == 0 || radius < 1.22 * before));
    before = radius;
  }
}

/// Little noise on a surface that bends over the balls: what these have across their planes grows
/// with them, and is not noise.
void check_bent_surface(std::size_t n, double noise, Generator& generator)
{
  std::vector<Vector> points = sphere_points(n, 1, generator).points;
  add_gaussian_noise(points, noise, generator);
  CHECK(is_close(scales_of(points).noise, noise, 0.06));
}

/// A twentieth of outliers changes little, however large the noise is.
void check_outliers(std::vector<Vector> points, double noise, Generator& generator)
{
  add_gaussian_noise(points, noise, generator);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n / 20; ++i)
    points.push_back(random_vector(1.5, generator));
  CHECK(is_close(scales_of(points).noise, noise, 0.15));
}

/// Two sheets are known again from the moments of their heights, whatever their shares.
void check_two_sheets(double share, double noise, Generator& generator)
{
  const double distance = 3;
  const int n = 200000;
  Height_moments<double> moments;
  std::normal_distribution<double> gaussian(0, noise);
  for (int i = 0; i < n; ++i)
    moments.add(1 + (i < share * n ? distance : 0) + gaussian(generator), 1);
  const Two_sheets sheets = two_sheets_of(moments.shape(n));
  const double squared_noise = noise * noise,
               of_distance = share * (1 - share) * distance * distance;
  CHECK(std::abs(sheets.noise - squared_noise / (squared_noise + of_distance)) < 0.01);
  CHECK(std::abs(sheets.larger_sheet - (std::max)(share, 1 - share)) < 0.01);
}

/// However many points there are at one place: they count as one.
void check_equal_points(std::vector<Vector> points)
{
  const Scales scales = scales_of(points);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i)
    points.insert(points.end(), i % 5, points[i]);
  const Scales of_copies = scales_of(points); // looks at other balls
  CHECK(is_close(of_copies.spacing, scales.spacing, 0.05));
  CHECK(is_close(of_copies.noise, scales.noise, 0.1));
}

/// However many points all but coincide at one place.
void check_crowd_in_one_place(std::vector<Vector> points, Generator& generator)
{
  const Scales scales = scales_of(points);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < 3 * n; ++i)
    points.push_back(points[0] + 1e-9 * random_unit_vector(generator));
  const Scales with_crowd = scales_of(points); // looks at other balls
  CHECK(is_close(with_crowd.spacing, scales.spacing, 0.05));
  CHECK(is_close(with_crowd.noise, scales.noise, 0.1));
}

/// Scales are lengths: they double with the cloud, bit by bit.
void check_unit(std::vector<Vector> points)
{
  const Scales scales = scales_of(points);
  for (Vector& p : points)
    p *= 1024;
  const Scales scaled = scales_of(points);
  CHECK(scaled.spacing == 1024 * scales.spacing);
  CHECK(scaled.noise == 1024 * scales.noise);
}

int main()
{
  Generator generator(14);
  for (std::size_t n : {2000, 30000})
  {
    check_scales(plane_points(n, 3, generator).points, 9, generator);
    check_scales(sphere_points(n, 1, generator).points, 4 * EIGEN_PI, generator);
  }
  for (const double share : {0.5, 0.7, 0.2})
    for (const double noise : {1e-3, 0.5, 1.})
      check_two_sheets(share, noise, generator);
  check_sheet_in_ball(generator);
  check_variance_among_outliers(generator);
  check_noise_sweep(plane_points(20000, 3, generator).points, std::sqrt(9. / 20000));
  check_noise_sweep(cube_points(20000, 2, generator).points, std::sqrt(24. / 20000));
  check_bent_surface(10000, 0.003, generator);
  check_bent_surface(4000, 0.008, generator);
  for (const double noise : {0.01, 0.03, 0.06})
    check_outliers(sphere_points(20000, 1, generator).points, noise, generator);
  for (const std::size_t number_of_outliers : {0, 1000})
    check_tube(0.1, 0.03, number_of_outliers, generator);
  check_uneven_density(generator);
  for (const double noise : {0.05, 0.08})
    check_crowd(noise, generator);
  check_plate(3, 0, generator);
  check_plate(3.6, 0.6, generator);
  check_plate(4, 0.5, generator);
  check_plate(6, 1, generator);
  for (int k = 0; k < 5; ++k)
    check_plate_with_outliers(generator);
  check_plate_of_few_points(generator);
  std::vector<Vector> noisy = cube_points(3000, 2, generator).points;
  add_gaussian_noise(noisy, 0.03, generator);
  check_equal_points(noisy);
  check_crowd_in_one_place(noisy, generator);
  check_unit(noisy);

  // no surface, and still a length
  for (const auto& points :
       {std::vector<Vector>{Vector(0, 0, 0), Vector(1, 0, 0)}, lattice_points(2, 1)})
    CHECK(scales_of(points).spacing > 0 && std::isfinite(scales_of(points).spacing)
          && scales_of(points).noise >= 0);
  return result();
}
