// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PROGRESS_H
#define CGAL_L0_RESAMPLING_INTERNAL_PROGRESS_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Thrown by `Progress::look()` once the caller's callback has said no, or has thrown; never leaves
/// the package.
struct Interrupted
{};

/// Tells the caller's callback how far the call is, and keeps the time and memory of the stages. As
/// long as it lives it watches the loops of the thread that has made it. It asks the callback at
/// the begin of each stage, so that short calls can be ended too, and every `interval()` inside.
class Progress final : public Loop_watcher
{
  using Clock = std::chrono::steady_clock;

  // Often enough for the promised 100 ms, rare enough to cost nothing.
  static constexpr std::chrono::milliseconds interval() { return std::chrono::milliseconds(20); }

  std::function<bool(double)> m_callback;
  Report& m_report;
  Memory_counter& m_memory;

  // Of the callback and of the three values below. No mutex: a callback that has loops of its own
  // may meet one of ours on its thread, which must not lock what that thread holds already.
  std::atomic_flag m_is_asking = ATOMIC_FLAG_INIT;
  Clock::time_point m_last_call = Clock::now();
  double m_last_value = 0;
  std::exception_ptr
    m_exception; // what the callback threw: threads that stop for it must not replace it

  std::atomic<bool> m_interrupted{false};
  std::atomic<std::size_t> m_done{0};
  std::size_t m_total = 1;
  double m_stage_begin = 0; // share of the whole call done before the running stage
  double m_stage_share = 0;
  Clock::time_point m_stage_start = Clock::now();
  const Cancellation_scope m_watched{m_callback ? this : nullptr};

public:
  Progress(std::function<bool(double)> callback, Report& report, Memory_counter& memory)
    : m_callback(std::move(callback)), m_report(report), m_memory(memory)
  {}

  /// Starts a stage of `total` steps that makes up `share` of the whole call. Not to be called from
  /// a loop.
  /// \throws Interrupted as `look()` does
  void begin_stage(const std::string& name, double share, std::size_t total)
  {
    end_stage();
    m_stage_begin += m_stage_share;
    m_stage_share = share;
    m_total = (std::max)(total, std::size_t(1));
    m_done = 0;
    m_stage_start = Clock::now();
    m_report.stages.push_back({name, 0, 0});
    if (!m_callback)
      return;
    m_is_asking.test_and_set(); // no loop is running
    ask();
  }

  /// Books the running stage. Starting the next one does it too.
  void end_stage()
  {
    if (m_report.stages.empty())
      return;
    m_report.stages.back().seconds =
      std::chrono::duration<double>(Clock::now() - m_stage_start).count();
    m_report.peak_bytes = (std::max)(m_report.peak_bytes, m_memory.peak());
    m_report.stages.back().peak_bytes = m_memory.take_peak();
  }

  /// To be called where `Interrupted` is caught.
  /// \throws what the callback threw, if it threw
  void rethrow_exception_of_callback() const
  {
    if (m_exception)
      std::rethrow_exception(m_exception);
  }

  /// Counts `steps` as done; any thread may call it.
  /// \throws Interrupted as `look()` does
  void advance(std::size_t steps)
  {
    m_done += steps;
    look();
  }

  /// \throws Interrupted after the callback has returned `false` or has thrown, in every thread
  void look() override
  {
    if (!m_callback)
      return;
    if (m_interrupted)
      throw Interrupted();

    if (m_is_asking.test_and_set(std::memory_order_acquire))
      return;
    if (m_interrupted || Clock::now() - m_last_call < interval())
      m_is_asking.clear(std::memory_order_release);
    else
      ask();
  }

private:
  /// Calls the callback, on a thread that may ask, and is the only one; afterwards any may.
  void ask()
  {
    const double in_stage = (std::min)(1., double(m_done) / double(m_total));
    m_last_value = (std::max)(m_last_value,
                              (std::min)(1., m_stage_begin + m_stage_share * in_stage));
    try
    {
      // What the callback waits for is not a block of a loop of ours: it may hold what that needs.
      m_interrupted = !isolated([&]() { return m_callback(m_last_value); });
    }
    catch (...)
    {
      m_interrupted = true;
      m_exception = std::current_exception();
    }
    m_last_call = Clock::now();
    m_is_asking.clear(std::memory_order_release);
    if (m_interrupted)
      throw Interrupted();
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PROGRESS_H
