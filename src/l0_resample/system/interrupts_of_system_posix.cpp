// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/interrupts_of_system.h"

#include <cmath>
#include <csignal>
#include <sys/time.h>

namespace l0_tool {
namespace {

void (*note_interrupt)(Interrupt) = nullptr;

void note_signal(int signal)
{
  note_interrupt(signal == SIGINT    ? Interrupt::BY_USER
                 : signal == SIGTERM ? Interrupt::BY_SYSTEM
                                     : Interrupt::BY_TIMEOUT);
}

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

void watch_interrupts(void (*note)(Interrupt), double timeout)
{
  note_interrupt = note;
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

} // namespace l0_tool
