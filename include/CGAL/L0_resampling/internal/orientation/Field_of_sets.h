// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_FIELD_OF_SETS_H
#define CGAL_L0_RESAMPLING_INTERNAL_FIELD_OF_SETS_H

#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The larger sets of samples, and how far they agree two by two.
struct Field_of_sets
{
  using Set = std::size_t;

  std::vector<Index> roots; // of the sets, ascending
  std::vector<Index> trees; // that they belong to
  std::vector<int> signs;   // relative to the tree
  std::vector<double>
    agreements; // a row for each set, of 0 with itself and with those of other trees
  std::vector<double> unary_terms; // of each set with the sign 1

  bool has(Index root) const { return std::binary_search(roots.begin(), roots.end(), root); }
  Set place_of(Index root) const
  {
    return Set(std::lower_bound(roots.begin(), roots.end(), root) - roots.begin());
  }

  /// Whether no other set is of its tree, so that there is none to agree with.
  bool is_alone(Set a) const { return std::count(trees.begin(), trees.end(), trees[a]) == 1; }

  /// Turns the set that disagrees most with all others, one after the other, until none does; and
  /// where none does, the group that does so together, each of which the others of it keep from
  /// turning.
  /// \returns whether there was one
  bool flip_disagreeing_sets()
  {
    const Set n = roots.size(), maximum_number_of_turns = 10 * n;
    std::vector<double> with_others(n);
    for (Set a = 0; a < n; ++a)
    {
      with_others[a] = signs[a] * unary_terms[a];
      for (Set b = 0; b < n; ++b)
        with_others[a] += agreement(a, b);
    }
    for (Set turn = 0; turn < maximum_number_of_turns; ++turn)
    {
      poll_for_cancellation();
      std::vector<Set> turned = disagreeing_set(with_others);
      if (turned.empty())
        turned = disagreeing_group(with_others);
      if (turned.empty())
        return turn > 0;
      for (Set a : turned)
      {
        signs[a] = -signs[a];
        with_others[a] = -with_others[a];
        for (Set b = 0; b < n; ++b)
          if (b != a)
            with_others[b] += 2 * agreement(a, b);
      }
    }
    return true;
  }

private:
  static constexpr Set none = Set(-1);

  /// Sets that turn together.
  struct Group
  {
    std::vector<Set> members;
    double with_rest = 0; // how far they agree with all others
    Set closest = none;   // the group that it agrees most with
  };

  /// Of two sets, as they are turned now.
  double agreement(Set a, Set b) const
  {
    return signs[a] * signs[b] * agreements[a * roots.size() + b];
  }

  /// The set that disagrees most with all others, or none.
  std::vector<Set> disagreeing_set(const std::vector<double>& with_others) const
  {
    const auto least = std::min_element(with_others.begin(), with_others.end());
    if (!(*least < -minimum_disagreement))
      return {};
    return {Set(least - with_others.begin())};
  }

  /// The group that disagrees most with all others, of those that come to be where the two that
  /// agree most become one, again and again; or none.
  std::vector<Set> disagreeing_group(const std::vector<double>& with_others) const
  {
    const Set n = roots.size();
    std::vector<Group> groups(n);
    std::vector<double> links(
      n
      * n); // how far two groups agree; no more than 0 where one of them has become part of another
    for (Set a = 0; a < n; ++a)
      for (Set b = 0; b < n; ++b)
        links[a * n + b] = a == b ? 0 : agreement(a, b);
    const auto link = [&](Set a, Set b) { return b == none ? 0 : links[a * n + b]; };
    const auto find_closest = [&](Set a) {
      groups[a].closest = none;
      for (Set b = 0; b < n; ++b)
        if (link(a, b) > link(a, groups[a].closest))
          groups[a].closest = b;
    };
    for (Set a = 0; a < n; ++a)
    {
      groups[a].members = {a};
      groups[a].with_rest = with_others[a];
      find_closest(a);
    }
    Group most_disagreeing;
    most_disagreeing.with_rest = -minimum_disagreement_of_groups;
    while (true)
    {
      poll_for_cancellation();
      Set first = none;
      for (Set a = 0; a < n; ++a)
        if (link(a, groups[a].closest) > (first == none ? 0 : link(first, groups[first].closest)))
          first = a;
      if (first == none)
        return most_disagreeing.members;
      const Set second = groups[first].closest;
      Group &whole = groups[first], &part = groups[second];
      whole.members.insert(whole.members.end(), part.members.begin(), part.members.end());
      whole.with_rest += part.with_rest - 2 * link(first, second);
      if (whole.with_rest < most_disagreeing.with_rest)
        most_disagreeing = whole;
      for (Set b = 0; b < n; ++b)
      {
        if (b != first)
          links[first * n + b] = links[b * n + first] += links[second * n + b];
        links[second * n + b] = links[b * n + second] = 0;
      }
      for (Set b = 0; b < n; ++b)
        if (b == first || b == second || groups[b].closest == first || groups[b].closest == second)
          find_closest(b);
        else if (link(b, first) > link(b, groups[b].closest))
          groups[b].closest = first;
    }
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_FIELD_OF_SETS_H
