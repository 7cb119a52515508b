// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "samples/sorted_samples.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/weigh_by_risk.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace test;

/// That bias is averaged over, at scale 1.
const double radius = 0.3, cell_size = 0.2;

bool are_same_means(const Mean_surface& a, const Mean_surface& b)
{
  return a.weight == b.weight && a.height == b.height && a.slope_u == b.slope_u
         && a.slope_v == b.slope_v && a.uu == b.uu && a.uv == b.uv && a.vv == b.vv;
}

using Surfaces = Buffer<Surfaces_of_scale>;
using References = Buffer<Surface_of_disks>;

Buffer<Mean_surface> weighed(const Sorted_samples& samples, const References& references,
                             const Surfaces& surfaces)
{
  const auto run = [&](auto tag) {
    using Tag = decltype(tag);
    Buffer<Mean_surface> means(samples.size());
    Unwatched unwatched;
    weigh_by_risk<Tag>(
      samples.sorted.grid, samples.sorted.points, samples.normals, references, surfaces,
      [&](std::size_t i) { return radius * samples.scale(i); }, cells_in_reach(radius, cell_size),
      unwatched.progress, means);
    return means;
  };
  Buffer<Mean_surface> means = run(CGAL::Parallel_if_available_tag());
  const Buffer<Mean_surface> sequential = run(CGAL::Sequential_tag());
  CHECK(
    std::equal(means.begin(), means.end(), sequential.begin(), sequential.end(),
               [](const Mean_surface& a, const Mean_surface& b) { return are_same_means(a, b); }));
  return means;
}

/// With deviations of its height and of its slopes, and a bias of its height.
Surface_of_disks any_surface(double deviation, double deviation_of_slope, double bias,
                             Generator& generator)
{
  const auto normal = [&](double s) { return float(std::normal_distribution<>(0, s)(generator)); };
  Surface_of_disks s;
  s.height = normal(deviation) + float(bias);
  s.slope_u = normal(deviation_of_slope);
  s.slope_v = normal(deviation_of_slope);
  s.uu = normal(1);
  s.uv = normal(1);
  s.vv = normal(1);
  s.height_variance = float(square(deviation));
  s.slope_variance = float(square(deviation_of_slope));
  return s;
}

/// The risk of a surface of a sample, as the docstring has it; below 0 if there is none.
template <typename Surface_at>
double naive_risk(const Sorted_samples& samples, const References& references, std::size_t i,
                  const Surface_at& surface_at)
{
  double weight = 0, heights = 0, slopes = 0;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    const Surface_of_disks &s = surface_at(k), &r = references[k];
    if (!s.is_determined() || !r.is_determined())
      continue;
    const double squared_distance = (samples.position(k) - samples.position(i)).squaredNorm(),
                 squared_radius = square(radius * samples.scale(i)),
                 opening = 1 - std::cos(35 * EIGEN_PI / 180),
                 w = (std::max)(1 - squared_distance / squared_radius, 0.)
                     * (std::max)(
                       1 - (1 - std::abs(samples.normal(k).dot(samples.normal(i)))) / opening, 0.);
    const auto by_chance = [](float of_reference, float of_surface) {
      return (std::max)(double(of_reference) - double(of_surface), 0.);
    };
    weight += w;
    heights += w
               * (square(double(s.height) - double(r.height))
                  - by_chance(r.height_variance, s.height_variance));
    slopes += w
              * ((square(double(s.slope_u) - double(r.slope_u))
                  + square(double(s.slope_v) - double(r.slope_v)))
                   / 2
                 - by_chance(r.slope_variance, s.slope_variance));
  }
  const Surface_of_disks &s = surface_at(i), &r = references[i];
  if (!s.is_determined() || !r.is_determined() || !(weight > 0))
    return -1;
  return (double(s.height_variance) + (std::max)(heights / weight, 0.)) / double(r.height_variance)
         + (double(s.slope_variance) + (std::max)(slopes / weight, 0.)) / double(r.slope_variance);
}

/// With surfaces of chance on a wedge and a sphere, some of them biased, some not determined.
void check_formula(bool have_even_scales, Generator& generator)
{
  Oriented_points cloud = sphere_points(400, 0.7, generator);
  const Oriented_points wedge = wedge_points(400, generator);
  cloud.points.insert(cloud.points.end(), wedge.points.begin(), wedge.points.end());
  cloud.normals.insert(cloud.normals.end(), wedge.normals.begin(), wedge.normals.end());
  cloud.normals = noisy_normals(cloud.normals, 0.1, generator);
  Generator of_sides(1);
  turn_some(of_sides, cloud.normals);
  const Sorted_samples samples(cloud, cell_size, have_even_scales);
  Surfaces surfaces(samples.size());
  References references(samples.size());
  const auto is_there = [&]() { return std::bernoulli_distribution(0.9)(generator); };
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double bias = samples.position(i).x() > 0 ? 0.03 : 0;
    references[i] = any_surface(0.02, 0.1, 0, generator);
    surfaces[i].plane = any_surface(0.01, 0.12, bias, generator);
    surfaces[i].quadric = any_surface(0.005, 0.03, 0, generator);
    if (!is_there())
      references[i] = Surface_of_disks();
    if (!is_there())
      surfaces[i].plane = Surface_of_disks();
    if (!is_there())
      surfaces[i].quadric = Surface_of_disks();
  }
  const Buffer<Mean_surface> means = weighed(samples, references, surfaces);
  double off = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const double of_plane = naive_risk(
                   samples, references,
                   i, [&](std::size_t k) -> const auto& { return surfaces[k].plane; }),
                 of_quadric = naive_risk(
                   samples, references,
                   i, [&](std::size_t k) -> const auto& { return surfaces[k].quadric; });
    const double p = of_plane > 0 ? std::pow(of_plane, -3) : 0,
                 q = of_quadric > 0 ? std::pow(of_quadric, -3) : 0;
    const Surface_of_disks &plane = surfaces[i].plane, &quadric = surfaces[i].quadric;
    const Mean_surface& mean = means[i];
    const auto compare = [&](float sum, float a, float b) {
      const double scale = p * std::abs(double(a)) + q * std::abs(double(b));
      off = (std::max)(off, std::abs(double(sum) - p * double(a) - q * double(b))
                              / (scale > 0 ? scale : 1));
    };
    compare(mean.weight, 1, 1);
    compare(mean.height, plane.height, quadric.height);
    compare(mean.slope_u, plane.slope_u, quadric.slope_u);
    compare(mean.slope_v, plane.slope_v, quadric.slope_v);
    compare(mean.uu, plane.uu, quadric.uu);
    compare(mean.uv, plane.uv, quadric.uv);
    compare(mean.vv, plane.vv, quadric.vv);
  }
  CHECK(off < 1e-4);
}

/// Where surfaces are what their variances say, the one with less of it counts, and the mean is
/// nearer to the truth, which is 0, than the reference.
void check_without_bias(Generator& generator)
{
  const Sorted_samples samples(even_samples(0.05, generator), cell_size, true);
  Surfaces surfaces(samples.size());
  References references(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    references[i] = any_surface(0.02, 0.1, 0, generator);
    surfaces[i].plane = any_surface(0.005, 0.03, 0, generator);
    surfaces[i].quadric = references[i];
  }
  double of_means = 0, of_references = 0, share_of_planes = 0;
  const Buffer<Mean_surface> means = weighed(samples, references, surfaces);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    of_means += square(double(means[i].height / means[i].weight));
    of_references += square(double(references[i].height));
    const double of_quadric = std::pow(2, -3); // the reference has the risk 2
    share_of_planes += (1 - of_quadric / double(means[i].weight)) / double(samples.size());
  }
  CHECK(of_means < 0.1 * of_references);
  CHECK(share_of_planes > 0.95);
}

/// A surface that is off in one direction everywhere hardly counts, though it has little variance.
void check_bias(Generator& generator)
{
  const Sorted_samples samples(even_samples(0.05, generator), cell_size, true);
  Surfaces surfaces(samples.size());
  References references(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    references[i] = any_surface(0.02, 0.1, 0, generator);
    surfaces[i].plane = any_surface(0.005, 0.03, 0.1, generator);
    surfaces[i].quadric = references[i];
  }
  double mean = 0;
  for (const Mean_surface& m : weighed(samples, references, surfaces))
    mean += double(m.height / m.weight) / double(samples.size());
  CHECK(std::abs(mean) < 0.003);
}

/// The bias of one face does not matter to the other one of an edge.
void check_edge(Generator& generator)
{
  const Oriented_points wedge = wedge_points(1000, generator);
  const Sorted_samples samples(wedge, cell_size, true);
  Surfaces surfaces(samples.size());
  References references(samples.size());
  const auto is_biased = [&](std::size_t i) { return samples.normal(i).z() > 0.5; };
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    references[i] = any_surface(0.02, 0.1, 0, generator);
    surfaces[i].plane = any_surface(0.005, 0.03, is_biased(i) ? 0.1 : 0, generator);
  }
  const Buffer<Mean_surface> means = weighed(samples, references, surfaces);
  float least = 1e9f, largest = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (is_biased(i))
      largest = (std::max)(largest, means[i].weight);
    else
      least = (std::min)(least, means[i].weight);
  CHECK(largest < 0.01f);
  CHECK(least > 1.f);
}

/// Means of several scales add up; a sample alone has the surface it has; and without a reference
/// there is none.
void check_few(Generator& generator)
{
  CHECK(weighed(Sorted_samples({}, cell_size, true), {}, {}).empty());
  const Sorted_samples one({{Vector::Zero()}, {Vector::UnitZ()}}, cell_size, true);
  Surfaces surfaces(1);
  References references(1);
  surfaces[0].plane = any_surface(0.01, 0.1, 0, generator);
  CHECK(are_same_means(weighed(one, references, surfaces)[0], Mean_surface()));
  references[0] = surfaces[0].plane;
  const Mean_surface mean = weighed(one, references, surfaces)[0];
  CHECK(is_close(mean.weight, 0.125, 1e-6)); // the risk is 2
  CHECK(is_close(mean.height / mean.weight, surfaces[0].plane.height, 1e-6));
  CHECK(is_close(mean.uv / mean.weight, surfaces[0].plane.uv, 1e-6));

  Buffer<Mean_surface> means(1);
  Unwatched unwatched;
  for (int scale = 0; scale < 3; ++scale)
    weigh_by_risk<CGAL::Sequential_tag>(
      one.sorted.grid, one.sorted.points, one.normals, references, surfaces,
      [&](std::size_t) { return radius; }, 2, unwatched.progress, means);
  CHECK(is_close(means[0].weight, 3 * mean.weight, 1e-6));
}

/// The quadric of the smallest balls is the reference by its share, where there are both.
void check_reference(Generator& generator)
{
  const Surface_of_disks quadric = any_surface(0.02, 0.1, 0, generator);
  Surface_of_disks smallest = any_surface(0.03, 0.2, 0, generator);
  CHECK(are_the_same(reference_of(quadric, smallest, 0), quadric));
  const Surface_of_disks half = reference_of(quadric, smallest, 0.5f),
                         whole = reference_of(quadric, smallest, 1);
  CHECK(is_close(half.height, 0.5 * (double(quadric.height) + double(smallest.height)), 1e-5));
  CHECK(is_close(half.slope_variance, 0.5 * (0.01 + 0.04), 1e-5));
  CHECK(is_close(whole.slope_v, smallest.slope_v, 1e-5)
        && is_close(whole.height_variance, smallest.height_variance, 1e-5));
  smallest = Surface_of_disks();
  CHECK(are_the_same(reference_of(quadric, smallest, 0.5f), quadric));
  CHECK(!reference_of(smallest, quadric, 1).is_determined());
  CHECK(radius_of_bias(0) == 2 && is_close(radius_of_bias(1), 3.3, 1e-12)
        && radius_of_bias(4) == 6);
}

int main()
{
  Generator generator(20261128);
  for (const bool have_even_scales : {true, false})
    check_formula(have_even_scales, generator);
  check_without_bias(generator);
  check_bias(generator);
  check_edge(generator);
  check_few(generator);
  check_reference(generator);
  return result();
}
