// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_RUN_BESIDE_PYTHON_H
#define CGAL_L0_PYTHON_RUN_BESIDE_PYTHON_H

#include <pybind11/pybind11.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace l0_python {

/// Where the thread that computes leaves its progress for the thread that Python knows.
class Progress_relay
{
  std::mutex m_mutex;
  std::condition_variable m_condition;
  std::optional<double> m_news;
  bool m_is_done = false;
  bool m_is_cancelled = false;

public:
  /// By the thread that computes.
  /// \returns whether to go on
  bool post(double share)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_news = share;
    m_condition.notify_one();
    return !m_is_cancelled;
  }

  void finish()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_done = true;
    m_condition.notify_one();
  }

  void cancel()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_cancelled = true;
  }

  /// Waits for news, but not for long.
  /// \param news out: the latest share that was posted since the last call, if any was
  /// \returns whether the work goes on
  bool wait(std::optional<double>& news)
  {
    std::unique_lock<std::mutex> lock(m_mutex);
    m_condition.wait_for(lock, std::chrono::milliseconds(50),
                         [this]() { return m_news || m_is_done; });
    news = m_news;
    m_news.reset();
    return !m_is_done;
  }
};

/*!
Computes in a thread of its own, without the interpreter's lock. The calling thread asks Python:
only there can a signal such as Ctrl-C become an exception, and only there may a callback expect to
be called. The threads that compute never wait for Python.

\param callback called with the progress now and then, or None. It cancels by what is false, but for
None.
\param work called with a function to ask whether to go on

\returns whether the callback let the work come to its end
\throws what the work, the callback or a signal threw; the work has ended then
*/
inline bool run_beside_python(const pybind11::object& callback,
                              const std::function<void(const std::function<bool(double)>&)>& work)
{
  Progress_relay relay;
  std::exception_ptr exception_of_work, exception_of_python;
  bool is_cancelled = false;
  {
    const pybind11::gil_scoped_release without_lock;
    std::thread thread([&]() {
      try
      {
        work([&](double share) { return relay.post(share); });
      }
      catch (...)
      {
        exception_of_work = std::current_exception();
      }
      relay.finish();
    });

    std::optional<double> news;
    while (relay.wait(news))
    {
      if (is_cancelled)
        continue;
      const pybind11::gil_scoped_acquire with_lock;
      try
      {
        if (PyErr_CheckSignals() != 0)
          throw pybind11::error_already_set();
        if (news && !callback.is_none())
        {
          const pybind11::object answer = callback(*news);
          is_cancelled = !answer.is_none() && !pybind11::bool_(answer);
        }
      }
      catch (...)
      {
        exception_of_python = std::current_exception();
        is_cancelled = true;
      }
      if (is_cancelled)
        relay.cancel();
    }
    thread.join();
  }
  if (exception_of_python)
    std::rethrow_exception(exception_of_python);
  if (is_cancelled)
    return false;
  if (exception_of_work)
    std::rethrow_exception(exception_of_work);
  return true;
}

} // namespace l0_python

#endif // CGAL_L0_PYTHON_RUN_BESIDE_PYTHON_H
