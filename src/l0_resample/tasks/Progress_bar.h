// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_PROGRESS_BAR_H
#define L0_RESAMPLE_PROGRESS_BAR_H

#include <chrono>
#include <string>

namespace l0_tool {

/// One line on the terminal that says which stage runs, how far the work is and how long it may
/// still take.
class Progress_bar
{
  using Clock = std::chrono::steady_clock;

  bool m_is_visible;
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_last_drawn = {};

public:
  /// Draws nothing if `is_quiet` or standard error is no terminal.
  explicit Progress_bar(bool is_quiet);
  ~Progress_bar() { clear(); }
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  /// The time left is counted anew.
  void restart() { m_start = Clock::now(); }

  /// \param share of the work since `restart()` that is done, in [0, 1]
  void update(const std::string& stage, double share);

  /// Leaves the line empty for whatever is written next.
  void clear();
};

} // namespace l0_tool

#endif // L0_RESAMPLE_PROGRESS_BAR_H
