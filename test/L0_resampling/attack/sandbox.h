// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_SANDBOX_H
#define CGAL_L0_RESAMPLING_TEST_SANDBOX_H

#include <cstddef>
#include <functional>
#include <string>

#include <sys/types.h>

namespace attack {

struct Limits
{
  std::size_t cpu_seconds = 30;
  std::size_t wall_seconds =
    600; // for one that waits for ever; far above the other, as machines are busy
  std::size_t bytes =
    std::size_t(4) << 30; // of address space; 0 for no limit, which the shadow of a sanitizer needs
};

/// Calls a function of an index in a child process. The child takes one call after the other, as
/// starting it, and its threads, would be most of the time; one that died, or was ended for a
/// limit, is replaced at the next call.
class Sandbox
{
  std::function<std::string(std::size_t)> m_function;
  Limits m_limits;
  pid_t m_child = -1;
  int m_questions = -1, m_answers = -1; // ends of pipes

public:
  Sandbox(std::function<std::string(std::size_t)> f, const Limits& limits);
  ~Sandbox();
  Sandbox(const Sandbox&) = delete;
  Sandbox& operator=(const Sandbox&) = delete;

  /// \param patience how often each call has the limits of time
  /// \returns `f(i)`, or how the child died. Memory that an earlier call has lost is missing in the
  /// later ones.
  std::string operator()(std::size_t i, std::size_t patience = 1);

  /// Has the next call come to a new child.
  void end_child();

private:
  void start_child();
  int wait_for_end();
};

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_SANDBOX_H
