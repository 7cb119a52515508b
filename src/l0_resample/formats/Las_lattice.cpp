// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Las_lattice.h"

#include "basis/parse_numbers.h"
#include "basis/Sample_of_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace l0_tool {
namespace {

// Scales are 1e-300 to 1e300, of which products with integers are no denormal numbers.
constexpr double largest_exponent = 300;

constexpr double maximum_integer = (std::numeric_limits<std::int32_t>::max)();

// Offsets are multiples of so many scales, unless all points are at one place.
constexpr double scales_per_step = 1000;

/// The nearest double, which std::pow() does not promise.
double power_of_ten(double exponent)
{
  const double within = (std::max)(-largest_exponent, (std::min)(exponent, largest_exponent));
  return *parse_number<double>("1e" + std::to_string(int(within)));
}

bool is_on(const Las_lattice& lattice, const Point_rows& rows)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double coordinate = rows.point(i)[int(axis)];
      if (lattice.coordinate(lattice.integer(coordinate, axis), axis) != coordinate)
        return false;
    }
  return true;
}

/// Of one coordinate.
struct Range
{
  double low, high;

  double half() const { return high / 2 - low / 2; }
  double middle() const { return low / 2 + high / 2; }
};

Range range_of(const Point_rows& rows, std::size_t axis)
{
  const auto coordinate = [&](std::size_t i) { return rows.point(i)[int(axis)]; };
  Range range = {coordinate(0), coordinate(0)};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    range.low = (std::min)(range.low, coordinate(i));
    range.high = (std::max)(range.high, coordinate(i));
  }
  return range;
}

/// \param largest of the scales whose rounding is small; 0 if nothing says what is small
/// \param of_file the scale of the file that the points come from, or 0
double choose_scale(const Range& range, double largest, double of_file)
{
  constexpr double usual = 1e-3;
  if (range.half() == 0 && largest == 0)
    return usual;
  // Such that all coordinates are held, wherever the offset lies in its step
  const double least = power_of_ten(
    std::ceil(std::log10(range.half() / (maximum_integer - scales_per_step))));
  if (largest == 0)
    return least;
  const double small = of_file > 0 && of_file <= largest
                         ? of_file
                         : power_of_ten(std::floor(std::log10(largest)));
  return (std::max)(small, least);
}

} // namespace

std::int32_t Las_lattice::integer(double coordinate, std::size_t axis) const
{
  const double integer = (coordinate - offset[axis]) / scale[axis];
  return std::int32_t(
    std::lround((std::max)(-maximum_integer, (std::min)(integer, maximum_integer))));
}

Las_lattice choose_las_lattice(const Point_rows& rows, const std::optional<Las_origin>& origin)
{
  if (origin && is_on({origin->scale, origin->offset}, rows))
    return {origin->scale, origin->offset};
  Las_lattice lattice = {{1e-3, 1e-3, 1e-3}, {0, 0, 0}};
  if (rows.size() == 0)
    return lattice;
  constexpr double maximum_share = 1e-3; // of the spacing, that a point is moved by
  const auto point = [&](std::size_t i) -> const Point& { return rows.point(i); };
  const double spacing = point_spacing(rows.size(), point);
  // Squares of distances may be beyond the range of numbers
  const double largest = std::isfinite(spacing) ? 2 * maximum_share * spacing : 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Range range = range_of(rows, axis);
    const double scale = choose_scale(range, largest, origin ? std::abs(origin->scale[axis]) : 0);
    const double step = scales_per_step * scale;
    const double stepped = std::round(range.middle() / step) * step;
    lattice.scale[axis] = scale;
    lattice.offset[axis] = range.half() > 0 && std::isfinite(stepped) ? stepped : range.middle();
  }
  return lattice;
}

} // namespace l0_tool
