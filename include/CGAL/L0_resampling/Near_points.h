// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_NEAR_POINTS_H
#define CGAL_L0_RESAMPLING_NEAR_POINTS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// How many near points `l0_resample_point_set()` takes the mean of an attribute from: about those
/// of four points of a result of half as many.
constexpr std::size_t number_of_averaged_points = 8;

/// \ingroup PkgL0ResamplingRef
/// Whether integers of an attribute of this name are averaged as numbers of floating-point types
/// are: those of colors, which PLY files have channel by channel. Other integers are labels, of
/// which there is no mean; of the others `Attribute_values` says which are.
inline bool is_color_channel(const std::string& name)
{
  return name == "red" || name == "green" || name == "blue" || name == "alpha";
}

/// \ingroup PkgL0ResamplingRef
/// The input points near each point of a result, from which it takes its attributes.
/// `find_near_points()` makes one.
struct Near_points
{
  std::size_t count = 0; ///< for each point of the result
  /// \cond SKIP_IN_MANUAL
  internal::Buffer<Index> indices; // of the input points, `count` in a row, the nearest first
  internal::Buffer<float> weights; // for means, in [0, 1]; 0 where the input has fewer points
  /// \endcond

  /// The index of the input point nearest to point `i` of the result.
  Index nearest(std::size_t i) const { return indices[i * count]; }

  /// The weighted mean of a value of the input points near point `i` of the result. Values that are
  /// not finite do not count; if none is finite, it is the value of the nearest.
  /// \param i the place of the point in the result
  /// \param value_of called with the index of an input point, gives a `double`
  template <typename F>
  double mean(std::size_t i, const F& value_of) const
  {
    double first = value_of(nearest(i)), sum = 0, total = 0;
    for (std::size_t n = i * count; n < (i + 1) * count; ++n)
    {
      const double value = weights[n] > 0 ? value_of(indices[n]) : first;
      if (!std::isfinite(value))
        continue;
      if (!std::isfinite(first))
        first = value;
      sum += double(weights[n])
             * (value - first); // of differences: the mean of equal values is that value
      total += double(weights[n]);
    }
    return total > 0 ? first + sum / total : first;
  }

  /// Replaces each index `j` of an input point by `index_of(j)`, for callers who keep their points
  /// in another order than that of the range.
  template <typename F>
  void renumber(const F& index_of)
  {
    for (Index& index : indices)
      index = Index(index_of(index));
  }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_NEAR_POINTS_H
