// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_SANDBOX_H
#define CGAL_L0_RESAMPLING_TEST_SANDBOX_H

#include <cstddef>
#include <functional>
#include <string>

namespace attack {

struct Limits
{
  std::size_t cpu_seconds = 30;
  std::size_t wall_seconds = 600;           // for one that waits for ever; far above the other, as machines are busy
  std::size_t bytes = std::size_t(4) << 30; // of address space; 0 for no limit, which the shadow of a sanitizer needs
};

/// What `f` returns, called in a child process with these limits, or how the child died.
std::string in_sandbox(const std::function<std::string()>& f, const Limits& limits);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_SANDBOX_H
