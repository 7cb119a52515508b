// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "samples/sorted_samples.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/find_deviations.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace test;

const Lengths_of_refinement lengths = {0.06, 0.03, 0.05};
const double cell_size = 0.2;

/// As the manual has it.
Deviations naive_deviations(const Sorted_samples& samples, const Buffer<Variances_of_fit>& of_fits,
                            std::size_t i)
{
  double sum = 0, weight = 0;
  const double extent = 1.44 * (square(lengths.noise) + square(lengths.unit * samples.scale(i)));
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    const double squared_distance = (samples.position(k) - samples.position(i)).squaredNorm();
    if (squared_distance >= 9 * extent)
      continue;
    const double g = std::exp(-squared_distance / (2 * extent));
    const Vector n = samples.normal(i), other = samples.normal(k);
    weight += g;
    sum += g * (std::min)((other - n).squaredNorm(), (other + n).squaredNorm());
  }
  return {float(std::sqrt(double(of_fits[i].position))),
          float(std::sqrt(
            (std::min)(double(of_fits[i].normal) + sum / (2 * weight), double(EIGEN_PI) - 2)))};
}

void check_formula(bool have_even_scales, Generator& generator)
{
  Oriented_points cloud = sphere_points(500, 0.4, generator);
  const Oriented_points wedge = wedge_points(1000, generator);
  cloud.points.insert(cloud.points.end(), wedge.points.begin(), wedge.points.end());
  cloud.normals.insert(cloud.normals.end(), wedge.normals.begin(), wedge.normals.end());
  cloud.normals = noisy_normals(cloud.normals, 0.1, generator);
  turn_some(generator, cloud.normals);
  const Sorted_samples samples(cloud, cell_size, have_even_scales);
  Buffer<Local_vector> normals(samples.size()); // in the order before
  Buffer<Variances_of_fit> of_fits(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    normals[samples.sorted.order[i]] = samples.normals[i];
    of_fits[i].position = float(random_number(0, 0.01, generator));
    of_fits[i].normal = float(random_number(0, 1.2, generator));
  }
  const auto run = [&](auto tag) {
    Buffer<Deviations> deviations(samples.size());
    Buffer<Index> place(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      place[samples.sorted.order[i]] = Index(i);
    Unwatched unwatched;
    find_deviations<decltype(tag)>(
      samples.sorted, normals, [&](std::size_t k) { return of_fits[place[k]]; },
      [&](std::size_t k) { return Ball_of_normals(lengths.at(samples.scale(place[k]), 1)); },
      cells_in_reach(Ball_of_normals::maximum_radius(lengths), cell_size), unwatched.progress,
      deviations);
    return deviations;
  };
  const Buffer<Deviations> deviations = run(CGAL::Parallel_if_available_tag()),
                           sequential = run(CGAL::Sequential_tag());
  double off = 0;
  bool are_same = true;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const std::size_t k = samples.sorted.order[i];
    const Deviations naive = naive_deviations(samples, of_fits, i);
    off = (std::max)({off, std::abs(double(deviations[k].position / naive.position) - 1),
                      std::abs(double(deviations[k].normal / naive.normal) - 1)});
    are_same = are_same && deviations[k].position == sequential[k].position
               && deviations[k].normal == sequential[k].normal;
  }
  CHECK(are_same);
  if (!CHECK(off < 1e-4))
    std::cerr << "  off by " << off << std::endl;
}

/// The covariance of the fits, and what is known where there is none.
void check_variances()
{
  Mean_surface mean;
  Surface_of_disks surface;
  surface.height_variance = 4e-6f;
  surface.slope_variance = 0.01f;
  mean.add(surface, 1);
  surface.height_variance = 1e-6f;
  surface.slope_variance = 0.04f;
  mean.add(surface, 2); // weighs an eighth
  const Variances_of_fit of_mean(mean, lengths);
  CHECK(is_close(double(of_mean.position), 6.25 * (4e-6 + 1e-6 / 8) / 1.125, 1e-6));
  CHECK(is_close(double(of_mean.normal), 2 * (0.01 + 0.04 / 8) / 1.125, 1e-6));
  const auto check_unknown = [](const Mean_surface& m) {
    const Variances_of_fit unknown(m, lengths);
    CHECK(is_close(double(unknown.position), 0.03 * 0.03, 1e-7));
    CHECK(is_close(double(unknown.normal), EIGEN_PI - 2, 1e-6));
  };
  check_unknown(Mean_surface());
  mean.height = mean.weight; // a length of 1, far off
  check_unknown(mean);
}

int main()
{
  Generator generator(20261130);
  check_formula(true, generator);
  check_formula(false, generator);
  check_variances();
  return result();
}
