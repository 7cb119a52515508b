// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stage_support.h"

#include <CGAL/L0_resampling/internal/cloud/estimate_scale_field.h>

#include <algorithm>
#include <cmath>
#include <set>

using namespace test;

/// Codes keep the places, and balls hold what comparing everybody finds.
void check_Morton_points(Generator& generator)
{
  const Morton_cells cells = Morton_cells::of_extent(8);
  std::vector<Vector> points = cube_points(2000, 2, generator).points;
  points.push_back(Vector(100, -100, 3)); // shares an outermost cell
  const Morton_places places = places_of<CGAL::Parallel_if_available_tag>(to_buffer(points), cells);
  const Morton_points view = places.view();
  CHECK(view.size == points.size());
  CHECK(std::is_sorted(view.codes, view.codes + view.size));
  bool are_kept = true;
  for (std::uint64_t i = 0; i < view.size; ++i)
    are_kept = are_kept && cells.code(view.xyz + 3 * i) == view.codes[i];
  CHECK(are_kept);

  for (const double radius : {1e-7, 0.03, 0.4, 3.})
  {
    bool are_all_found = true;
    for (std::uint64_t i = 0; i < view.size; i += 37)
    {
      const double* const p = view.xyz + 3 * i;
      std::set<std::uint64_t> found, naive;
      view.visit_ball(One_thread(), p, radius, view.size,
                      [&](std::uint64_t k, double, bool is_inside) {
                        if (is_inside)
                          found.insert(k);
                      });
      for (std::uint64_t k = 0; k < view.size; ++k)
        if (view.squared_distance(p, k) < radius * radius)
          naive.insert(k);
      are_all_found = are_all_found && found == naive;
    }
    CHECK(are_all_found);
  }
  std::vector<double> distances;
  for (std::uint64_t k = 0; k < view.size; ++k)
    distances.push_back(std::sqrt(view.squared_distance(view.xyz + 3 * 500, k)));
  std::sort(distances.begin(), distances.end());
  CHECK(is_close(reach_of_nearest(One_thread(), view, 500), distances[points_of_seed], 1e-12));
}

struct Field
{
  Buffer<float> scales; ///< of the points; none if all are 1

  /// \param spacing, noise of scale 1
  Field(const std::vector<Vector>& points, double spacing, double noise)
  {
    Unwatched unwatched;
    const Buffer<Vector> buffer = to_buffer(points);
    const double radius = default_radius(spacing, noise);
    const Reference_scales usual(radius, radius, spacing, noise);
    scales = estimate_scale_field<CGAL::Parallel_if_available_tag>(buffer, {}, 10, usual,
                                                                   unwatched.progress)
               .of_points<CGAL::Parallel_if_available_tag>(buffer);
  }
};

/// An even cloud has one radius, with noise and without, and if its points share places.
void check_even_clouds(Generator& generator)
{
  const double spacing = std::sqrt(6 * 4. / 8000);
  for (const double noise : {0., 0.3 * spacing, 1.5 * spacing, 4 * spacing})
  {
    std::vector<Vector> points = cube_points(8000, 2, generator).points;
    add_gaussian_noise(points, noise, generator);
    CHECK(Field(points, spacing, noise).scales.empty());
    points.insert(points.end(), points.begin(), points.end());
    CHECK(Field(points, spacing, noise).scales.empty());
  }
}

/// A small part that is denser has radii of its own, and the rest keeps the one it has.
void check_small_part(Generator& generator)
{
  const double spacing = std::sqrt(16. / 64000);
  std::vector<Vector> points = plane_points(64000, 4, generator).points;
  const std::size_t number_of_dense_points = 1600;
  const double side = spacing / 8 * std::sqrt(double(number_of_dense_points));
  for (const Vector& p : plane_points(number_of_dense_points, side, generator).points)
    points.push_back(p);
  const Field field(points, spacing, 0);
  if (!CHECK(!field.scales.empty()))
    return;
  bool is_one_elsewhere = true;
  for (std::size_t i = 0; i < points.size(); ++i)
    is_one_elsewhere = is_one_elsewhere && (points[i].norm() < 1 || field.scales[i] > 0.9);
  CHECK(is_one_elsewhere);
  CHECK(field.scales.back() < 0.6);
}

/// Around a sparse plane beside a dense one the sparse one decides, though most seeds around are
/// dense.
void check_sparse_beside_dense(Generator& generator)
{
  std::vector<Vector> points = plane_points(32000, 4, generator).points;
  for (const Vector& p : plane_points(2000, 4, generator).points)
    points.push_back(p + Vector(4, 0, 0));
  const Field field(points, std::sqrt(16. / 32000), 0);
  if (!CHECK(!field.scales.empty()))
    return;
  double sum = 0;
  int number = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i][0] > 4 && points[i][0] < 5.5 && std::abs(points[i][1]) < 1.5)
    {
      sum += field.scales[i];
      ++number;
    }
  CHECK(sum / number > 2.2); // as far from the border as scales may rise: 4 if they rose at once
}

/// Points of scan lines look as far as other lines, and those of a wire no farther than along it.
void check_lines(Generator& generator)
{
  std::vector<Vector> points;
  const double way = 0.1;
  for (int line = 0; line < 40; ++line)
    for (int i = 0; i < 1000; ++i)
      points.emplace_back(random_number(-2, 2, generator), line * way, 0);
  const Morton_places places = places_of<CGAL::Parallel_if_available_tag>(to_buffer(points),
                                                                          cells_of_places(5));
  const Morton_points view = places.view();
  int number_across = 0, number = 0;
  for (std::uint64_t i = 0; i < view.size; i += 197, ++number)
    number_across += seed_at(One_thread(), view, i).reach > 0.9 * way;
  CHECK(number_across > 0.9 * number);

  std::vector<Vector> wire;
  for (int i = 0; i < 4000; ++i)
  {
    const double angle = random_number(0, 2 * EIGEN_PI, generator);
    wire.emplace_back(0.002 * std::cos(angle), 0.002 * std::sin(angle),
                      random_number(-2, 2, generator));
  }
  const Morton_places of_wire = places_of<CGAL::Parallel_if_available_tag>(to_buffer(wire),
                                                                           cells_of_places(4));
  const Morton_points wire_view = of_wire.view();
  for (std::uint64_t i = 0; i < wire_view.size; i += 197)
    CHECK(seed_at(One_thread(), wire_view, i).reach
          < 1.5 * reach_of_nearest(One_thread(), wire_view, i));
}

/// Where noise is four times as large as elsewhere the radius is larger, also in balls that noise
/// fills.
void check_two_noises(Generator& generator)
{
  const double spacing = std::sqrt(16. / 16000);
  for (const double noise : {0.4 * spacing, 1.2 * spacing})
  {
    std::vector<Vector> points = plane_points(16000, 4, generator).points;
    std::vector<Vector> noisy = plane_points(16000, 4, generator).points;
    add_gaussian_noise(points, noise, generator);
    add_gaussian_noise(noisy, 4 * noise, generator);
    for (const Vector& p : noisy)
      points.push_back(p + Vector(4, 0, 0));
    const Field field(points, spacing, noise);
    if (!CHECK(!field.scales.empty()))
      continue;
    const double ratio = default_radius(spacing, 4 * noise) / default_radius(spacing, noise);
    double of_clean = 0, of_noisy = 0;
    int number_of_clean = 0, number_of_noisy = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (std::abs(points[i][1]) < 1.5 && std::abs(points[i][0]) < 1)
      {
        of_clean += field.scales[i];
        ++number_of_clean;
      }
      else if (std::abs(points[i][1]) < 1.5 && std::abs(points[i][0] - 4.5) < 1)
      {
        of_noisy += field.scales[i];
        ++number_of_noisy;
      }
    CHECK(is_close(of_clean / number_of_clean, 1, 0.1));
    // where noise fills the balls, they tell less of it
    CHECK(of_noisy / number_of_noisy > (noise < spacing ? 0.9 : 0.6) * ratio);
    CHECK(of_noisy / number_of_noisy < 1.1 * ratio);
  }
}

/// Where a cloud is four times as dense as elsewhere, its radius is half as large, and between the
/// two it changes no faster than it may, whatever order the points come in.
void check_two_densities(Generator& generator)
{
  std::vector<Vector> points = plane_points(4000, 4, generator).points;
  for (const Vector& p : plane_points(64000, 4, generator).points)
    points.push_back(p + Vector(4, 0, 0));
  const double spacing = std::sqrt(16. / 4000), radius = default_radius(spacing, 0);
  const Field field(points, spacing, 0);
  if (!CHECK(!field.scales.empty()))
    return;
  bool is_dense_right = true, is_sparse_right = true, is_slow = true;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector& p = points[i];
    const bool is_inside = std::abs(p[1]) < 1.5;
    if (is_inside && p[0] > 2.5 && p[0] < 5.5)
      is_dense_right = is_dense_right && is_close(field.scales[i], 0.25, 0.3);
    if (is_inside && p[0] > -1.5 && p[0] < -1)
      is_sparse_right = is_sparse_right && is_close(field.scales[i], 1, 0.2);
    const std::size_t k = (i * 7919) % points.size();
    is_slow = is_slow
              && std::abs(field.scales[i] - field.scales[k])
                   < 2 * slope_of_scales * (p - points[k]).norm() / radius + 0.1;
  }
  CHECK(is_dense_right);
  CHECK(is_sparse_right);
  CHECK(is_slow);

  std::vector<Vector> shuffled(points.rbegin(), points.rend());
  Buffer<float> reversed = Field(shuffled, spacing, 0).scales;
  std::reverse(reversed.begin(), reversed.end());
  CHECK(reversed == field.scales);
}

/// Places near a seed that decides alone get what looking at all seeds around gives.
void check_deciding_seeds(Generator& generator)
{
  std::vector<Vector> points = plane_points(16000, 4, generator).points;
  for (const Vector& p : plane_points(4000, 1, generator).points)
    points.push_back(p + Vector(1, 0, 0));
  const double spacing = std::sqrt(16. / 16000), radius = default_radius(spacing, 0);
  Unwatched unwatched;
  const Buffer<Vector> buffer = to_buffer(points);
  Scale_field field = estimate_scale_field<CGAL::Parallel_if_available_tag>(
    buffer, {}, 10, Reference_scales(radius, radius, spacing, 0), unwatched.progress);
  const auto decides = [](const Scale_of_seed& seed) { return seed.within > 0; };
  const auto number = std::count_if(field.scales.begin(), field.scales.end(), decides);
  CHECK(number > std::ptrdiff_t(field.scales.size() / 4));
  CHECK(number < std::ptrdiff_t(field.scales.size()));
  const Buffer<float> known = field.of_points<CGAL::Parallel_if_available_tag>(buffer);
  for (Scale_of_seed& seed : field.scales)
    seed.within = -1;
  CHECK(known == field.of_points<CGAL::Parallel_if_available_tag>(buffer));
}

/// Where noise grows with the ball as that of structured light does, over all balls that are looked
/// at, all radii are larger; noise of each point alone, however large, and a surface that bends are
/// none of that.
void check_correlated_noise(Generator& generator)
{
  const auto growths = [](float flatness, float first, float second, float third) {
    return std::vector<Growth_of_deviations>(9, {flatness, {first, second, third}});
  };
  CHECK(is_close(widening_by_correlation(growths(0.11f, 0.5f, 0.4f, 0.6f)), std::sqrt(8.), 1e-12));
  CHECK(is_close(widening_by_correlation(growths(0.11f, 0.5f, 0.6f, 1.3f)), 2, 1e-12));
  CHECK(widening_by_correlation(growths(0.11f, 0.6f, 1.3f, 0.5f)) == 1);
  CHECK(widening_by_correlation(growths(0.11f, 0.1f, 0.1f, 0.5f)) == 1);
  CHECK(widening_by_correlation(growths(0.03f, 0.5f, 0.4f, 0.6f)) == 1); // nothing to be seen
  CHECK(widening_by_correlation(growths(0.3f, 0.5f, 0.4f, 0.6f)) == 1);  // in a filled ball
  CHECK(widening_by_correlation({}) == 1);

  const double spacing = std::sqrt(16. / 16000);
  std::vector<Vector> points = plane_points(16000, 4, generator).points;
  struct Wave
  {
    Vector way; // across it
    double phase, height;
  };
  std::vector<Wave> waves;
  for (int k = 0; k < 60; ++k)
  {
    const double length = 2 * spacing * std::pow(30., random_number(0, 1, generator)),
                 angle = random_number(0, 6.2832, generator);
    waves.push_back({6.2832 / length * Vector(std::cos(angle), std::sin(angle), 0),
                     random_number(0, 6.2832, generator), std::pow(length / spacing, 0.3)});
  }
  for (Vector& p : points)
    for (const Wave& wave : waves)
      p[2] += 0.07 * spacing * wave.height * std::cos(wave.way.dot(p) + wave.phase);
  const Range_of_scales range = range_of(Field(points, spacing, 0.4 * spacing).scales);
  CHECK(range.median > 1.5f);
}

/// A point that is far from all others does not see them: its radius is no larger than what lies in
/// between allows.
void check_outliers(Generator& generator)
{
  std::vector<Vector> points = plane_points(16000, 4, generator).points;
  const double spacing = std::sqrt(16. / 16000), radius = default_radius(spacing, 0);
  points.push_back(Vector(0, 0, 10 * radius));
  const Field field(points, spacing, 0);
  CHECK(field.scales.empty() || field.scales.back() <= 1 + 10 * slope_of_scales * 1.1);
}

/// Few points, or all at one place, have a radius too.
void check_few_points(Generator& generator)
{
  for (const std::size_t n : {1u, 2u, 3u, 17u, 30u})
  {
    const Field field(cube_points(n, 2, generator).points, 0.3, 0);
    CHECK(std::all_of(field.scales.begin(), field.scales.end(),
                      [](float s) { return s >= minimum_scale && s <= maximum_scale; }));
  }
  const Field field(std::vector<Vector>(5000, Vector(1, 2, 3)), 0.3, 0);
  CHECK(std::all_of(field.scales.begin(), field.scales.end(),
                    [](float s) { return s >= minimum_scale && s <= maximum_scale; }));
}

int main()
{
  Generator generator(3);
  check_Morton_points(generator);
  check_even_clouds(generator);
  check_small_part(generator);
  check_sparse_beside_dense(generator);
  check_lines(generator);
  check_two_noises(generator);
  check_two_densities(generator);
  check_deciding_seeds(generator);
  check_correlated_noise(generator);
  check_outliers(generator);
  check_few_points(generator);
  return result();
}
