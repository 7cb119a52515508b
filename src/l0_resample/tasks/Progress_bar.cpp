// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tasks/Progress_bar.h"

#include "system/files_of_system.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace l0_tool {
namespace {

std::string time_left(double seconds)
{
  const long rounded = std::lround(std::ceil(seconds));
  if (rounded < 60)
    return std::to_string(rounded) + " s left";
  if (rounded < 3600)
    return std::to_string(rounded / 60) + " min " + std::to_string(rounded % 60) + " s left";
  return std::to_string(rounded / 3600) + " h " + std::to_string(rounded % 3600 / 60) + " min left";
}

} // namespace

Progress_bar::Progress_bar(bool is_quiet) : m_is_visible(!is_quiet && is_terminal(standard_error))
{}

void Progress_bar::update(const std::string& stage, double share)
{
  const Clock::time_point now = Clock::now();
  if (!m_is_visible || now - m_last_drawn < std::chrono::milliseconds(100))
    return;
  m_last_drawn = now;

  constexpr int width = 30;
  const int filled = int(std::lround(width * (std::clamp)(share, 0., 1.)));
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '-');

  // Before that, the estimate is a guess.
  const double elapsed = std::chrono::duration<double>(now - m_start).count();
  const bool has_estimate = elapsed > 0.5 && share > 0.02;
  std::fprintf(stderr, "\r\033[K[%s] %3.0f %%  %s%s", bar.c_str(), 100 * share, stage.c_str(),
               has_estimate ? (", " + time_left(elapsed * (1 - share) / share)).c_str() : "");
  std::fflush(stderr);
}

void Progress_bar::clear()
{
  if (!m_is_visible || m_last_drawn == Clock::time_point())
    return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  m_last_drawn = {};
}

} // namespace l0_tool
