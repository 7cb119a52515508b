// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_BUFFER_H
#define CGAL_L0_RESAMPLING_INTERNAL_BUFFER_H

#include <CGAL/L0_resampling/internal/words/require_exceptions.h>

#include <CGAL/L0_resampling/internal/core/huge_pages.h>

#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Counts the bytes that the arrays of one call hold, and refuses to pass a limit.
class Memory_counter
{
  std::atomic<std::size_t> m_current{0};
  std::atomic<std::size_t> m_peak{0};
  std::size_t m_limit;

public:
  explicit Memory_counter(std::size_t limit = (std::numeric_limits<std::size_t>::max)())
    : m_limit(limit)
  {}

  /// \throws std::bad_alloc if the sum would pass the limit
  void acquire(std::size_t bytes)
  {
    const std::size_t now = m_current.fetch_add(bytes) + bytes;
    if (now > m_limit)
    {
      m_current.fetch_sub(bytes);
      throw std::bad_alloc();
    }
    std::size_t peak = m_peak.load();
    while (peak < now && !m_peak.compare_exchange_weak(peak, now))
    {}
  }

  void release(std::size_t bytes) noexcept { m_current.fetch_sub(bytes); }

  std::size_t peak() const { return m_peak.load(); }
  std::size_t current() const { return m_current.load(); }
  std::size_t limit() const { return m_limit; }

  /// The peak since the last call of this function; starts the next interval at what is held now.
  std::size_t take_peak() { return m_peak.exchange(m_current.load()); }
};

/// Allocator that reports to a `Memory_counter`; without one it is `std::allocator`.
template <typename T>
struct Counting_allocator
{
  using value_type = T;
  using propagate_on_container_move_assignment = std::true_type;
  using propagate_on_container_swap = std::true_type;

  Memory_counter* counter = nullptr;

  Counting_allocator() = default;
  Counting_allocator(Memory_counter* c) : counter(c) {}
  template <typename U>
  Counting_allocator(const Counting_allocator<U>& other) : counter(other.counter)
  {}

  T* allocate(std::size_t n)
  {
    if (n > (std::numeric_limits<std::size_t>::max)() / sizeof(T))
      throw std::bad_array_new_length();
    if (counter)
      counter->acquire(n * sizeof(T));
    try
    {
      T* const array = std::allocator<T>().allocate(n);
      prefer_huge_pages(array, n * sizeof(T));
      return array;
    }
    catch (...)
    {
      if (counter)
        counter->release(n * sizeof(T));
      throw;
    }
  }

  void deallocate(T* p, std::size_t n) noexcept
  {
    std::allocator<T>().deallocate(p, n);
    if (counter)
      counter->release(n * sizeof(T));
  }

  /// Numbers that are given no value are left as they are: all of such an array has to be
  /// written before it is read, which all threads can do at the same time.
  template <typename U>
  void construct(U* p)
  {
    ::new (static_cast<void*>(p)) U;
  }
  template <typename U, typename... Arguments>
  void construct(U* p, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(p)) U(std::forward<Arguments>(arguments)...);
  }

  template <typename U>
  bool operator==(const Counting_allocator<U>& other) const
  {
    return counter == other.counter;
  }
  template <typename U>
  bool operator!=(const Counting_allocator<U>& other) const
  {
    return counter != other.counter;
  }
};

/// The array type of every stage.
template <typename T>
using Buffer = std::vector<T, Counting_allocator<T>>;

/// Gives the memory back, which `clear()` does not.
template <typename T>
void release(Buffer<T>& buffer)
{
  Buffer<T>(buffer.get_allocator()).swap(buffer);
}

/// Makes it an array of `n` values that are all written before they are read. `resize()` would keep
/// those it has: take room for twice as many beside them, and copy them without a call of the
/// callback.
template <typename T>
void resize_to_overwrite(std::size_t n, Buffer<T>& buffer)
{
  if (n > buffer.capacity())
    release(buffer);
  buffer.resize(n);
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_BUFFER_H
