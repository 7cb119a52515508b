// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// In place of TBB's header, for ThreadSanitizer: it does not see how the threads of a library that
// was not built with it wait for each other, and takes all of TBB's own work for races. These
// threads it sees, so that nothing needs to be suppressed.

#ifndef CGAL_L0_RESAMPLING_TEST_TBB_PARALLEL_FOR_H
#define CGAL_L0_RESAMPLING_TEST_TBB_PARALLEL_FOR_H

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb {

/// Calls `f(i)` for all i of [begin, end) and throws the first exception once all threads have
/// ended. Each of three threads takes every third i: what they fetched from a common counter would
/// be in some order, in which no race is seen.
template <typename Index, typename F>
void parallel_for(Index begin, Index end, const F& f)
{
  const Index number_of_threads = 3;
  std::mutex mutex;
  std::exception_ptr exception;
  const auto work = [&](Index first) {
    try
    {
      for (Index i = first; i < end; i += number_of_threads)
        f(i);
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!exception)
        exception = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (Index k = 1; k < number_of_threads; ++k)
    threads.emplace_back(work, begin + k);
  work(begin);
  for (std::thread& thread : threads)
    thread.join();
  if (exception)
    std::rethrow_exception(exception);
}

/// The same: no partitioner would share the work otherwise.
template <typename Index, typename F, typename Partitioner>
void parallel_for(Index begin, Index end, const F& f, const Partitioner&)
{
  parallel_for(begin, end, f);
}

} // namespace tbb

#endif // CGAL_L0_RESAMPLING_TEST_TBB_PARALLEL_FOR_H
