// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_ATTRIBUTE_VALUES_H
#define CGAL_L0_RESAMPLING_ATTRIBUTE_VALUES_H

#include <CGAL/license/L0_resampling.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// Looks at the values of an attribute of a floating-point type, to tell what only all of them do:
/// whether they have means. Those that are not finite do not count.
class Attribute_values
{
  /// The value that is farthest on one side.
  struct Extreme
  {
    int side;          // 1 for the highest value, -1 for the lowest
    double value;      // infinite if there is none
    double next_value; // the next one that differs from it
    std::size_t count = 0;

    explicit Extreme(int s)
      : side(s), value(-s * std::numeric_limits<double>::infinity()), next_value(value)
    {}

    void add(double other)
    {
      if (side * other > side * value)
      {
        next_value = value;
        value = other;
        count = 0;
      }
      if (other == value)
        ++count;
      else if (side * other > side * next_value)
        next_value = other;
    }
  };

  static constexpr std::size_t maximum_number_of_labels = 256,
                               minimum_number_of_points_of_label = 10;

  bool m_are_finite = true, m_are_whole = true;
  std::size_t m_count = 0;
  std::vector<double> m_different; // in ascending order, or too many
  Extreme m_lowest = Extreme(-1), m_highest = Extreme(1);

public:
  /// Takes the value of one more point.
  void add(double value)
  {
    if (!std::isfinite(value))
    {
      m_are_finite = false;
      return;
    }
    ++m_count;
    m_are_whole = m_are_whole && std::floor(value) == value;
    m_lowest.add(value);
    m_highest.add(value);
    if (m_different.size() > maximum_number_of_labels)
      return;
    const auto place = std::lower_bound(m_different.begin(), m_different.end(), value);
    if (place == m_different.end() || *place != value)
      m_different.insert(place, value);
  }

  /// Whether all values are finite.
  bool are_finite() const { return m_are_finite; }

  /// Whether no value has a fraction.
  bool are_whole() const { return m_are_whole; }

  /// Infinite if there is none.
  double lowest() const { return m_lowest.value; }

  /// Minus infinity if there is none.
  double highest() const { return m_highest.value; }

  /// Whether the values may be labels, of which there is no mean: if they are whole, or few, which
  /// are 256 different ones at most, with ten points for each.
  bool are_labels() const
  {
    return m_are_whole
           || (m_different.size() <= maximum_number_of_labels
               && m_count >= minimum_number_of_points_of_label * m_different.size());
  }

  /// The value, such as -9999, that stands for none, if there is one: the lowest or the highest, if
  /// several points have it and it is farther from all others than they are from each other, so
  /// that nothing else lies where a mean with it would. Only of values that are no labels.
  std::optional<double> no_data() const
  {
    for (const auto& [extreme, other] :
         {std::pair(m_lowest, m_highest), std::pair(m_highest, m_lowest)})
      if (extreme.count > 1
          && std::abs(extreme.value - extreme.next_value)
               > std::abs(other.value - extreme.next_value))
        return extreme.value;
    return std::nullopt;
  }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_ATTRIBUTE_VALUES_H
