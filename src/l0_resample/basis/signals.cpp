// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/signals.h"

#include "basis/Failure.h"
#include "system/interrupts_of_system.h"

#include <atomic>

namespace l0_tool {
namespace {

// Written by the handler in whatever thread the signal arrives, read by all.
std::atomic<Interrupt> noted{Interrupt::NONE};
static_assert(std::atomic<Interrupt>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

void note(Interrupt interrupt) { noted = interrupt; }

} // namespace

void catch_signals(double timeout) { watch_interrupts(note, timeout); }

bool is_interrupted() { return noted != Interrupt::NONE; }

void throw_if_interrupted()
{
  switch (noted) {
  case Interrupt::NONE: return;
  case Interrupt::BY_USER: throw Failure(INTERRUPTED, "interrupted");
  case Interrupt::BY_SYSTEM: throw Failure(TERMINATED, "terminated");
  case Interrupt::BY_TIMEOUT: break;
  }
  throw Failure(RUN_TIME_FAILURE, "the time given by --timeout is over");
}

} // namespace l0_tool
