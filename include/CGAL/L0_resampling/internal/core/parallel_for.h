// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_FOR_H
#define CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_FOR_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Learns from the loops of the thread that it is set in that they are still running, and may end
/// them by an exception.
class Loop_watcher
{
public:
  /// Called between two blocks of a loop, by any thread.
  virtual void look() = 0;

protected:
  ~Loop_watcher() = default;
};

/// The watcher of this thread, or null. Not handed through all stages, as every loop has to be
/// seen, those of a solver included. A template so that a compiled library and the programs that
/// load it have one between them.
template <typename = void>
Loop_watcher*& loop_watcher()
{
  thread_local Loop_watcher* watcher = nullptr;
  return watcher;
}

#ifdef CGAL_L0_LINKED_WITH_COMPILED
extern template Loop_watcher*& loop_watcher<void>();
#endif

/// Has the thread watched by `watcher`, which may be null, as long as this lives.
class Cancellation_scope
{
  Loop_watcher* const m_outer =
    loop_watcher(); // of a call from whose callback or property map this one is made

public:
  explicit Cancellation_scope(Loop_watcher* watcher) { loop_watcher() = watcher; }
  ~Cancellation_scope() { loop_watcher() = m_outer; }
  Cancellation_scope(const Cancellation_scope&) = delete;
  Cancellation_scope& operator=(const Cancellation_scope&) = delete;
};

/// For loops that are not `for_each_block()`.
inline void poll_for_cancellation()
{
  if (loop_watcher())
    loop_watcher()->look();
}

/// What `f()` returns. Where that waits for parallel loops of its own, its thread takes no block of
/// a loop around them.
template <typename F>
auto isolated(const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  return tbb::this_task_arena::isolate(f);
#else
  return f();
#endif
}

/// A view of a function of these arguments, for one body of a loop for all functions: a call
/// through a pointer is nothing beside what the functions do, and each copy of a loop costs the
/// compiler time, a quarter of a second where it is TBB's.
template <typename... Arguments>
class Function_view
{
  const void* m_function;
  void (*m_call)(const void*, Arguments...);

public:
  /// \param f outlives this object
  template <typename F>
  explicit Function_view(const F& f)
    : m_function(&f), m_call([](const void* function, Arguments... arguments) {
        (*static_cast<const F*>(function))(arguments...);
      })
  {}

  void operator()(Arguments... arguments) const { m_call(m_function, arguments...); }
};

/// Of `f(begin, end)`.
using Block_function = Function_view<std::size_t, std::size_t>;

#ifdef CGAL_LINKED_WITH_TBB
/// `for_each_block()` with `Parallel_tag`.
inline void for_each_block_in_parallel(std::size_t n, std::size_t block_size,
                                       const Block_function& f)
{
  Loop_watcher* const watcher = loop_watcher();
  const std::size_t number_of_blocks = n / block_size + std::size_t(n % block_size != 0);
  tbb::parallel_for(std::size_t(0), number_of_blocks, [&](std::size_t k) {
    const Cancellation_scope watched(watcher); // on whatever thread this is
    const std::size_t begin = k * block_size;
    f(begin, begin + (std::min)(block_size, n - begin));
    poll_for_cancellation();
  });
}
#endif

/// `for_each_block()` with `Sequential_tag`.
inline void for_each_block_in_order(std::size_t n, std::size_t block_size, const Block_function& f)
{
  for (std::size_t begin = 0; begin < n;)
  {
    const std::size_t end = begin + (std::min)(block_size, n - begin);
    f(begin, end);
    poll_for_cancellation();
    begin = end;
  }
}

/// Calls `f(begin, end)` for the blocks `[0, block_size)`, `[block_size, 2 * block_size)`, ... of
/// `[0, n)`. The blocks depend on `n` and `block_size` alone, never on the number of threads: that
/// is what makes results bitwise reproducible. `block_size` must be positive. With `Parallel_tag`
/// the calls run at once and in any order.
/// \throws what `f` or the watcher of the calling thread throws; with `Parallel_tag` one of the
/// exceptions, after all running calls have ended
template <typename ConcurrencyTag, typename F>
void for_each_block(std::size_t n, std::size_t block_size, const F& f)
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel)
    return for_each_block_in_parallel(n, block_size, Block_function(f));
#else
  static_assert(!is_parallel, "Parallel_tag needs TBB: link with CGAL::TBB_support.");
#endif
  for_each_block_in_order(n, block_size, Block_function(f));
}

/// Calls `f(i)` for each i of `[0, n)`, one after the other.
template <typename F>
void for_each_in_order(std::size_t n, const F& f)
{
  const std::size_t block_size = 65536; // a few milliseconds
  for (std::size_t i = 0; i < n;)
  {
    for (const std::size_t end = i + (std::min)(block_size, n - i); i < end; ++i)
      f(i);
    poll_for_cancellation();
  }
}

/// Makes `values` `n` times `value`, as `assign()` does, but in blocks: the first touch of memory
/// takes half a second a gigabyte.
template <typename T>
void fill_buffer(std::size_t n, const T& value, Buffer<T>& values)
{
  const std::size_t block_size = 65536;
  values.clear();
  values.reserve(n);
  for_each_block<Sequential_tag>(n, block_size,
                                 [&](std::size_t, std::size_t end) { values.resize(end, value); });
}

/// `n` times `value`, likewise.
template <typename T, typename U>
Buffer<T> filled_buffer(std::size_t n, const T& value, const Counting_allocator<U>& allocator)
{
  Buffer<T> values(allocator);
  fill_buffer(n, value, values);
  return values;
}

/// A copy, likewise.
template <typename T>
Buffer<T> copy_of(const Buffer<T>& values)
{
  const std::size_t block_size = 65536;
  Buffer<T> copy(values.get_allocator());
  copy.reserve(values.size());
  for_each_block<Sequential_tag>(values.size(), block_size,
                                 [&](std::size_t begin, std::size_t end) {
                                   copy.insert(copy.end(), values.begin() + std::ptrdiff_t(begin),
                                               values.begin() + std::ptrdiff_t(end));
                                 });
  return copy;
}

/// `less` for algorithms of the standard library that take long: polls for cancellation once in
/// many comparisons.
/// \param number_of_comparisons outlives what is returned, as does `less`
template <typename Less>
auto watched_order(const Less& less, std::size_t& number_of_comparisons)
{
  return [&](const auto& a, const auto& b) {
    const std::size_t comparisons_per_look = 65536;
    if (++number_of_comparisons % comparisons_per_look == 0)
      poll_for_cancellation();
    return less(a, b);
  };
}

/// The sum of `f(begin, end)` over the blocks of `for_each_block()`, added in the order of the
/// blocks, so bitwise the same for every number of threads. The sum may be a number or any value
/// type with `operator+=` that is zero when value-initialized.
template <typename ConcurrencyTag, typename F>
auto block_sum(std::size_t n, std::size_t block_size, const F& f)
{
  using Sum = std::decay_t<decltype(f(n, n))>;
  Sum sum = Sum();
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
  {
    std::vector<Sum> parts(n / block_size + std::size_t(n % block_size != 0));
    for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
      parts[begin / block_size] = f(begin, end);
    });
    for (const Sum& part : parts)
      sum += part;
  }
  else
    for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
      sum += f(begin, end);
    });
  return sum;
}

/// What `f(begin, end, values)` appends to `values` for the blocks of `for_each_block()`, in the
/// order of the blocks.
template <typename ConcurrencyTag, typename T, typename F>
Buffer<T> append_by_blocks(std::size_t n, std::size_t block_size,
                           const Counting_allocator<T>& allocator, const F& f)
{
  std::vector<Buffer<T>> parts(n / block_size + std::size_t(n % block_size != 0),
                               Buffer<T>(allocator));
  for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
    Buffer<T>& part = parts[begin / block_size];
    f(begin, end, part);
    part.shrink_to_fit(); // else there may be room for twice as many
  });
  std::size_t size = 0;
  std::vector<std::ptrdiff_t> begins;
  for (const Buffer<T>& part : parts)
  {
    begins.push_back(std::ptrdiff_t(size));
    size += part.size();
  }
  Buffer<T> all(size, allocator);
  for_each_block<ConcurrencyTag>(parts.size(), 1, [&](std::size_t k, std::size_t) {
    std::copy(parts[k].begin(), parts[k].end(), all.begin() + begins[k]);
    release(parts[k]);
  });
  return all;
}

/// Keeps what `f` makes of the values, in their order and in their place: nothing, of some.
/// \param f called with a value, at the same time for several; returns an optional one
template <typename ConcurrencyTag, typename T, typename F>
void keep_by_blocks(std::size_t block_size, const F& f, Buffer<T>& values)
{
  const std::size_t n = values.size();
  std::vector<std::size_t> sizes(n / block_size + std::size_t(n % block_size != 0));
  for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
    std::size_t kept = begin;
    for (std::size_t i = begin; i < end; ++i)
      if (const std::optional<T> value = f(values[i]))
        values[kept++] = *value;
    sizes[begin / block_size] = kept - begin;
  });
  auto end = values.begin();
  for (std::size_t k = 0; k < sizes.size(); ++k)
  {
    const auto first = values.begin() + std::ptrdiff_t(k * block_size);
    end = std::copy(first, first + std::ptrdiff_t(sizes[k]), end);
    poll_for_cancellation();
  }
  values.resize(std::size_t(end - values.begin()));
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_FOR_H
