// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TILE_FINDINGS_H
#define CGAL_L0_RESAMPLING_TILE_FINDINGS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/samples/most_crowded_place.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// What a tile reports of its own points and samples, as `Report` does; plain, so that it can be
/// stored. `+=` adds up those of all tiles.
struct Tile_findings
{
  std::uint64_t number_of_outliers = 0;
  std::uint64_t number_of_degenerate_neighborhoods = 0;
  std::uint64_t number_of_output_points = 0;
  std::uint64_t number_of_lonely_samples = 0;
  std::uint64_t number_of_unexplained_samples = 0;
  std::uint64_t number_of_unexplained_samples_there = 0; ///< those of other tiles count too
  std::array<double, 3> unexplained_center = {0, 0, 0};

  Tile_findings& operator+=(const Tile_findings& other)
  {
    number_of_outliers += other.number_of_outliers;
    number_of_degenerate_neighborhoods += other.number_of_degenerate_neighborhoods;
    number_of_output_points += other.number_of_output_points;
    number_of_lonely_samples += other.number_of_lonely_samples;
    number_of_unexplained_samples += other.number_of_unexplained_samples;
    if (other.unexplained_place().comes_before(unexplained_place()))
    {
      unexplained_center = other.unexplained_center;
      number_of_unexplained_samples_there = other.number_of_unexplained_samples_there;
    }
    return *this;
  }

private:
  internal::Crowded_place unexplained_place() const
  {
    return {internal::Vector(unexplained_center.data()),
            std::size_t(number_of_unexplained_samples_there)};
  }
};

namespace internal {

/// \param report of a tile
inline Tile_findings findings_of(const Report& report)
{
  return {report.number_of_outliers,
          report.number_of_degenerate_neighborhoods,
          report.number_of_output_points,
          report.number_of_lonely_samples,
          report.number_of_unexplained_samples,
          report.number_of_unexplained_samples_there,
          report.unexplained_center};
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILE_FINDINGS_H
