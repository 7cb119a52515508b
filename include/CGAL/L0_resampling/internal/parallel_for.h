// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_FOR_H
#define CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_FOR_H

#include <CGAL/L0_resampling/internal/Buffer.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Calls `f(begin, end)` for the blocks `[0, block_size)`, `[block_size, 2 * block_size)`, ... of `[0, n)`.
/// The blocks depend on `n` and `block_size` alone, never on the number of threads: that is what makes results
/// bitwise reproducible. `block_size` must be positive. With `Parallel_tag` the calls run at once and in any order.
/// \throws what `f` throws; with `Parallel_tag` one of the exceptions, after all running calls have ended
template <typename ConcurrencyTag, typename F>
void for_each_block(std::size_t n, std::size_t block_size, const F& f)
{
  constexpr bool is_parallel = std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel)
  {
    const std::size_t number_of_blocks = n / block_size + std::size_t(n % block_size != 0);
    tbb::parallel_for(std::size_t(0), number_of_blocks, [&](std::size_t k) {
      const std::size_t begin = k * block_size;
      f(begin, begin + (std::min)(block_size, n - begin));
    });
    return;
  }
#else
  static_assert(!is_parallel, "Parallel_tag needs TBB: link with CGAL::TBB_support.");
#endif
  for (std::size_t begin = 0; begin < n;)
  {
    const std::size_t end = begin + (std::min)(block_size, n - begin);
    f(begin, end);
    begin = end;
  }
}

/// The sum of `f(begin, end)` over the blocks of `for_each_block()`, added in the order of the blocks, so bitwise the
/// same for every number of threads. The sum may be a number or any value type with `operator+=` that is zero when
/// value-initialized.
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
    for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) { sum += f(begin, end); });
  return sum;
}

/// What `f(begin, end, values)` appends to `values` for the blocks of `for_each_block()`, in the order of the blocks.
template <typename ConcurrencyTag, typename T, typename F>
Buffer<T> append_by_blocks(std::size_t n, std::size_t block_size, const Counting_allocator<T>& allocator, const F& f)
{
  std::vector<Buffer<T>> parts(n / block_size + std::size_t(n % block_size != 0), Buffer<T>(allocator));
  for_each_block<ConcurrencyTag>(n, block_size,
                                 [&](std::size_t begin, std::size_t end) { f(begin, end, parts[begin / block_size]); });
  std::size_t size = 0;
  for (const Buffer<T>& part : parts)
    size += part.size();
  Buffer<T> all(allocator);
  all.reserve(size);
  for (Buffer<T>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
    release(part);
  }
  return all;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_FOR_H
