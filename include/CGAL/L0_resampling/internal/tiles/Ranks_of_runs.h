// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_RANKS_OF_RUNS_H
#define CGAL_L0_RESAMPLING_INTERNAL_RANKS_OF_RUNS_H

#include <CGAL/L0_resampling/internal/core/keep_one_of_each.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A run of places that follow each other in an order of all places of a cloud. All places of a run
/// have its key, which ascends with the order.
struct Run_of_places
{
  std::uint64_t key, count;
};

/// The ranks of places in the order of the whole cloud, the runs of which are spread over tiles. A
/// run that is cut by the border of tiles has the same places in each of them.
class Ranks_of_runs
{
  std::vector<Run_of_places> m_runs; // with what comes before each, once all are there
  std::uint64_t m_total = 0;

  static bool precedes(const Run_of_places& run, std::uint64_t key) { return run.key < key; }

public:
  void add(const std::vector<Run_of_places>& runs)
  {
    m_runs.insert(m_runs.end(), runs.begin(), runs.end());
  }

  /// Once all are there.
  void add_up()
  {
    keep_one_of_each([](const Run_of_places& run) { return run.key; }, m_runs);
    for (Run_of_places& run : m_runs)
    {
      const std::uint64_t count = run.count;
      run.count = m_total;
      m_total += count;
    }
  }

  /// Of all places.
  std::uint64_t total() const { return m_total; }

  /// The rank of the first place of a run; none if no tile has it.
  std::optional<std::uint64_t> first_of(std::uint64_t key) const
  {
    const auto run = std::lower_bound(m_runs.begin(), m_runs.end(), key, precedes);
    if (run == m_runs.end() || run->key != key)
      return std::nullopt;
    return run->count;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_RANKS_OF_RUNS_H
