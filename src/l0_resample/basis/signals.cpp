// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/signals.h"

#include "basis/Failure.h"

#include <atomic>
#include <cmath>
#include <csignal>
#include <sys/time.h>

namespace l0_tool {
namespace {

// Written by the handler in whatever thread the signal arrives, read by all.
std::atomic<int> noted_signal{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

void note_signal(int signal) { noted_signal = signal; }

void handle(int signal, int flags)
{
  struct sigaction action = {};
  if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN)
    return; // started by nohup or in the background of a script: whoever did that wants it ignored
  action = {};
  action.sa_handler = note_signal;
  action.sa_flags = flags; // without SA_RESTART, so that a blocked read() or write() returns
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

} // namespace

void catch_signals(double timeout)
{
  handle(SIGINT, SA_RESETHAND);
  handle(SIGTERM, SA_RESETHAND);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);

  if (timeout > 0) {
    std::signal(SIGALRM, SIG_DFL);
    handle(SIGALRM, 0);
    const double seconds = std::floor(timeout);
    itimerval timer = {};
    timer.it_value.tv_sec = time_t(seconds);
    timer.it_value.tv_usec = suseconds_t((timeout - seconds) * 999999)
                             + 1; // 0 would switch the timer off
    timer.it_interval.tv_usec =
      100000; // again and again, for a read() that began just after the first
    setitimer(ITIMER_REAL, &timer, nullptr);
  }
}

bool is_interrupted() { return noted_signal != 0; }

void throw_if_interrupted()
{
  switch (noted_signal) {
  case 0: return;
  case SIGINT: throw Failure(INTERRUPTED, "interrupted");
  case SIGTERM: throw Failure(TERMINATED, "terminated");
  default: throw Failure(RUN_TIME_FAILURE, "the time given by --timeout is over");
  }
}

} // namespace l0_tool
