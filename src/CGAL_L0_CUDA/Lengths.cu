// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Lengths.cuh"

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// As `sensible_radius()` on the CPU, for a bounding box.
double sensible_radius(double radius, const double (&low)[3], const double (&high)[3])
{
  const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2],
               diagonal = std::sqrt(x * x + y * y + z * z);
  if (!(diagonal > 0))
    return 1;
  return (std::min)((std::max)(radius, std::ldexp(diagonal, -100)), diagonal);
}

} // namespace

Lengths choose_lengths(const Extent& extent, unsigned n, const Parameters& parameters,
                       const std::function<Scales(const Lengths&)>& scales_in, Call_report& report)
{
  const bool is_default = parameters.method == Method::DEFAULT;
  const double m = double(parameters.number_of_output_points);
  Lengths lengths;
  lengths.frame = extent.frame;
  std::copy(extent.low, extent.low + 3, lengths.low);
  std::copy(extent.high, extent.high + 3, lengths.high);
  const double paper_radius = sensible_radius(extent.robust_diagonal / std::cbrt(double(n)), lengths.low, lengths.high);
  double diagonal = extent.robust_diagonal * lengths.scale_to(paper_radius);
  lengths.radius = std::ldexp(paper_radius, -std::ilogb(paper_radius));
  lengths.noise = 0;
  lengths.sample_spacing = diagonal / std::sqrt(m);
  if (is_default)
  {
    const Scales scales = scales_in(lengths);
    lengths.radius = default_radius(scales.spacing, scales.noise);
    lengths.noise = scales.noise;
    lengths.sample_spacing = scales.spacing * std::sqrt(n / m);
    report.estimated_spacing = lengths.frame.length_of_input(scales.spacing);
    report.estimated_noise = lengths.frame.length_of_input(scales.noise);
  }
  if (parameters.neighbor_radius > 0)
    lengths.radius = lengths.frame.length_in_frame(parameters.neighbor_radius);
  lengths.radius = sensible_radius(lengths.radius, lengths.low, lengths.high);

  const double scale = lengths.scale_to(lengths.radius);
  lengths.radius *= scale;
  lengths.noise *= scale;
  lengths.sample_spacing *= scale;
  if (!(lengths.sample_spacing > 0)) // all points, but for outliers, are at one place: any length will do
    lengths.sample_spacing = lengths.radius;
  lengths.filter_radius = parameters.normal_filter_radius > 0
                            ? (std::max)(sensible_radius(lengths.frame.length_in_frame(parameters.normal_filter_radius),
                                                         lengths.low, lengths.high),
                                         least_filter_radius_factor * lengths.radius)
                            : (is_default ? default_filter_radius_factor : 1.) * lengths.radius;
  lengths.self_neighbor_radius = self_neighbor_radius_factor * lengths.radius;
  if (is_default)
    lengths.set_sample_spacing(lengths.sample_spacing);
  lengths.smallest_cell_size = std::ldexp(diagonal * scale, -18);
  lengths.cell_size = (std::max)(lengths.filter_radius > lengths.radius ? lengths.filter_radius / 2 : lengths.radius,
                                 lengths.smallest_cell_size);
  report.neighbor_radius = lengths.frame.length_of_input(lengths.radius);
  report.normal_filter_radius = lengths.frame.length_of_input(lengths.filter_radius);
  return lengths;
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
