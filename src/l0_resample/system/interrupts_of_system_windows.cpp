// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/interrupts_of_system.h"

#include <atomic>
#include <chrono>
#include <thread>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace l0_tool {
namespace {

void (*note_interrupt)(Interrupt) = nullptr;
std::atomic<HANDLE> main_thread{nullptr};
std::atomic<bool> was_interrupted{false};

void interrupt(Interrupt what)
{
  note_interrupt(what);
  CancelSynchronousIo(main_thread); // fails where nothing blocks
}

BOOL WINAPI handle_event(DWORD event)
{
  if (was_interrupted.exchange(true))
    return FALSE; // The system ends the program.
  interrupt(event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT ? Interrupt::BY_USER
                                                               : Interrupt::BY_SYSTEM);
  return TRUE;
}

/// Again and again, for a read that began just after the first call.
[[noreturn]] void interrupt_after(double timeout)
{
  std::this_thread::sleep_for(std::chrono::duration<double>(timeout));
  for (;;) {
    interrupt(Interrupt::BY_TIMEOUT);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

} // namespace

void watch_interrupts(void (*note)(Interrupt), double timeout)
{
  note_interrupt = note;
  HANDLE thread;
  if (DuplicateHandle(GetCurrentProcess(), GetCurrentThread(), GetCurrentProcess(), &thread, 0,
                      FALSE, DUPLICATE_SAME_ACCESS))
    main_thread = thread;
  SetConsoleCtrlHandler(handle_event, TRUE);
  if (timeout > 0)
    std::thread(interrupt_after, timeout).detach();
}

} // namespace l0_tool
