// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALE_FIELD_H
#define CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALE_FIELD_H

#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/core/select_nth.h>
#include <CGAL/L0_resampling/internal/kernels/scale_field.h>
#include <CGAL/L0_resampling/internal/search/Morton_places.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The seeds of the field, and the scale at each.
struct Scale_field
{
  Morton_places seeds;
  double radius;                ///< of scale 1
  Buffer<Scale_of_seed> scales; ///< none if all are 1

  bool is_even() const { return scales.empty(); }
  std::size_t number_of_bytes() const
  {
    return seeds.number_of_bytes() + scales.size() * sizeof(Scale_of_seed);
  }

  /// The scale of each point; none if all are 1.
  template <typename ConcurrencyTag>
  Buffer<float> of_points(const Buffer<Vector>& points) const
  {
    Buffer<float> values(points.get_allocator());
    if (scales.empty())
      return values;
    values.resize(points.size());
    const Morton_points view = seeds.view();
    for_each_block<ConcurrencyTag>(points.size(), 1024, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        values[i] = scale_at(One_thread(), view, scales.data(), radius, points[i].data());
    });
    return values;
  }
};

/// \param scales none if all are 1
inline Range_of_scales range_of(const Buffer<float>& scales)
{
  Range_of_scales range;
  if (scales.empty())
    return range;
  const auto [least, largest] = std::minmax_element(scales.begin(), scales.end());
  range = {*least, median_of(copy_of(scales)), *largest};
  return range;
}

/// Calls `f(i)` for each of the seeds, for several at a time.
template <typename ConcurrencyTag, typename F>
void for_each_seed(std::size_t number_of_seeds, Progress& progress, const F& f)
{
  const std::size_t seeds_per_block = 64;
  for_each_block<ConcurrencyTag>(number_of_seeds, seeds_per_block,
                                 [&](std::size_t begin, std::size_t end) {
                                   for (std::size_t i = begin; i < end; ++i)
                                     f(i);
                                   progress.advance(0);
                                 });
}

/*!
The field of scales of a cloud.

\param places_of_seeds every `points_of_seed`-th place of the cloud
\param known what is known at each of them
\param usual of the cloud
\param noise_ratios of that at each seed to that of the cloud, where the caller knows them; none if
all are 1
*/
template <typename ConcurrencyTag>
Scale_field field_of_seeds(Morton_places places_of_seeds, const Buffer<Seed>& known,
                           const Reference_scales& usual, Progress& progress,
                           const Buffer<float>& noise_ratios = Buffer<float>())
{
  const double radius = usual.radius;
  const auto allocator = known.get_allocator();
  Scale_field field{std::move(places_of_seeds), radius, Buffer<Scale_of_seed>(allocator)};
  const Morton_points seeds = field.seeds.view();
  const std::size_t size = seeds.size;
  const auto for_each_seed = [&](const auto& f) {
    internal::for_each_seed<ConcurrencyTag>(size, progress, f);
  };
  std::vector<Growth_of_deviations> growths;
  for (std::size_t i = 0; i < size; i += stride_of_growth(size))
    growths.push_back(growth_at(known[i]));
  const double widening = widening_by_correlation(growths);
  Buffer<double> wanted(size, allocator), scales(size, allocator);
  for_each_seed([&](std::size_t i) {
    wanted[i] = wanted_scale(One_thread(), seeds, known.data(), usual, widening, i,
                             view_of_scales(noise_ratios)[i]);
  });
  for_each_seed([&](std::size_t i) {
    scales[i] = scale_of_group(One_thread(), seeds, known.data(), wanted.data(), i);
  });
  const auto are_all_one = [&] {
    return std::all_of(scales.begin(), scales.end(), [](double scale) { return scale == 1; });
  };
  Buffer<double>& next = wanted;
  for (int sweep = 0; sweep < sweeps_over_seeds && !are_all_one(); ++sweep)
  {
    for_each_seed([&](std::size_t i) {
      next[i] = limited_scale(One_thread(), seeds, known.data(), scales.data(), radius, i);
    });
    scales.swap(next);
  }
  for_each_seed([&](std::size_t i) {
    next[i] = spanning_scale(One_thread(), seeds, known.data(), scales.data(),
                             usual.estimated_radius, i);
  });
  scales.swap(next);
  if (are_all_one())
    return field;
  field.scales.resize(size);
  for_each_seed([&](std::size_t i) {
    field.scales[i] = scale_of_seed(One_thread(), seeds, known.data(), scales.data(), i);
  });
  return field;
}

/// The noise ratios of points, at seeds: of points that share a place, the largest.
inline Buffer<float> noise_ratios_of_seeds(const Morton_places& seeds, const Buffer<Vector>& points,
                                           const Buffer<float>& noise_ratios)
{
  Buffer<float> found(noise_ratios.get_allocator());
  if (noise_ratios.empty())
    return found;
  const Buffer<std::uint64_t>& codes = seeds.codes();
  found.resize(codes.size(), 0.f);
  for_each_in_order(points.size(), [&](std::size_t i) {
    const std::uint64_t code = seeds.cells().code(points[i].data());
    const auto it = std::lower_bound(codes.begin(), codes.end(), code);
    if (it == codes.end() || *it != code)
      return;
    float& ratio = found[std::size_t(it - codes.begin())];
    ratio = (std::max)(ratio, noise_ratios[i]);
  });
  return found;
}

/// Estimates the field of scales of points, which are a whole cloud. Parameters are those of
/// `cells_of_places()` and `field_of_seeds()`.
/// \param noise_ratios of the points
template <typename ConcurrencyTag>
Scale_field estimate_scale_field(const Buffer<Vector>& points, const Buffer<float>& noise_ratios,
                                 double extent, const Reference_scales& usual, Progress& progress)
{
  const Morton_places places = places_of<ConcurrencyTag>(points, cells_of_places(extent));
  Morton_places seeds = places.one_of(points_of_seed);
  const Morton_points view = places.view();
  Buffer<Seed> known(seeds.view().size, points.get_allocator());
  for_each_seed<ConcurrencyTag>(known.size(), progress, [&](std::size_t i) {
    known[i] = seed_at(One_thread(), view, i * points_of_seed);
  });
  const Buffer<float> of_seeds = noise_ratios_of_seeds(seeds, points, noise_ratios);
  return field_of_seeds<ConcurrencyTag>(std::move(seeds), known, usual, progress, of_seeds);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ESTIMATE_SCALE_FIELD_H
