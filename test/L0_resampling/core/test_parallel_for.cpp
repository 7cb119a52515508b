// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Blocks that do not depend on the number of threads, and sums that no thread can reorder.

#include "test_support.h"

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/core/Progress.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/select_nth.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

using CGAL::L0_resampling::internal::block_sum;
using CGAL::L0_resampling::internal::for_each_block;

template <typename ConcurrencyTag>
void test_every_index_once_in_fixed_blocks()
{
  for (const std::size_t n : {0, 1, 7, 8, 9, 1000})
    for (const std::size_t block_size : {1, 8, 2000})
    {
      std::vector<int> visits(n, 0);
      std::atomic<bool> blocks_are_right(true);
      for_each_block<ConcurrencyTag>(n, block_size, [&](std::size_t begin, std::size_t end) {
        const std::size_t size = end - begin;
        if (begin % block_size != 0 || size == 0 || size > block_size
            || (size != block_size && end != n))
          blocks_are_right = false;
        for (std::size_t i = begin; i < end; ++i)
          ++visits[i];
      });
      CHECK(blocks_are_right);
      CHECK(visits == std::vector<int>(n, 1));
    }
}

/// Addition of doubles does depend on the order, by this much: the sum by blocks is not the plain
/// sum.
template <typename ConcurrencyTag>
void test_sum_is_in_the_order_of_the_blocks()
{
  const std::size_t n = 100000, block_size = 64;
  const auto term = [](std::size_t i) { return std::sin(double(i)) * std::exp2(double(i % 50)); };
  const auto sum_of = [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i)
      sum += term(i);
    return sum;
  };
  double expected = 0;
  for (std::size_t begin = 0; begin < n; begin += block_size)
    expected += sum_of(begin, (std::min)(begin + block_size, n));
  CHECK(expected != sum_of(0, n));
  for (int run = 0; run < 20; ++run)
    CHECK(block_sum<ConcurrencyTag>(n, block_size, sum_of) == expected);
}

/// Letters do not commute at all.
struct Text
{
  std::string letters;
  Text& operator+=(const Text& other)
  {
    letters += other.letters;
    return *this;
  }
};

template <typename ConcurrencyTag>
void test_sum_of_a_type_of_ones_own()
{
  const std::string alphabet = "abcdefghijklmnopqrstuvwxyz";
  const auto letters = [&](std::size_t begin, std::size_t end) {
    return Text{alphabet.substr(begin, end - begin)};
  };
  CHECK(block_sum<ConcurrencyTag>(26, 3, letters).letters == alphabet);
  CHECK(block_sum<ConcurrencyTag>(0, 3, letters).letters.empty());
}

template <typename ConcurrencyTag>
void test_exceptions_pass()
{
  const auto fails = [](std::size_t begin, std::size_t) {
    if (begin == 50)
      throw std::runtime_error("planted");
    return 1;
  };
  CHECK_THROWS(for_each_block<ConcurrencyTag>(100, 10, fails), std::runtime_error);
  CHECK_THROWS(block_sum<ConcurrencyTag>(100, 10, fails), std::runtime_error);
}

/// Counts the looks, and ends the loop at one of them.
struct Counting_watcher final : CGAL::L0_resampling::internal::Loop_watcher
{
  std::atomic<std::size_t> looks{0};
  std::size_t last_look = (std::numeric_limits<std::size_t>::max)();

  void look() override
  {
    if (++looks >= last_look)
      throw std::runtime_error("enough");
  }
};

/// A look a block, on whatever thread, also from a loop within a loop; none once the scope has
/// ended.
template <typename ConcurrencyTag>
void test_loops_are_watched()
{
  using namespace CGAL::L0_resampling::internal;
  const auto nothing = [](std::size_t, std::size_t) {};
  Counting_watcher watcher, inner_watcher, impatient;
  {
    const Cancellation_scope watched(&watcher);
    for_each_block<ConcurrencyTag>(95, 10, nothing);
    CHECK(watcher.looks == 10);
    for_each_block<ConcurrencyTag>(7, 1, [&](std::size_t, std::size_t) {
      for_each_block<CGAL::Sequential_tag>(30, 10, nothing);
    });
    CHECK(watcher.looks == 10 + 7 * 4);
    {
      const Cancellation_scope other(&inner_watcher);
      for_each_block<ConcurrencyTag>(50, 10, nothing);
    }
    CHECK(inner_watcher.looks == 5 && watcher.looks == 10 + 7 * 4);
    for_each_in_order(200000, [](std::size_t) {});
    CHECK(watcher.looks == 10 + 7 * 4 + 4);
  }
  for_each_block<ConcurrencyTag>(50, 10, nothing);
  CHECK(watcher.looks == 10 + 7 * 4 + 4);

  impatient.last_look = 3;
  const Cancellation_scope watched(&impatient);
  std::atomic<std::size_t> blocks{0};
  CHECK_THROWS(for_each_block<ConcurrencyTag>(1000000, 1,
                                              [&](std::size_t, std::size_t) { ++blocks; }),
               std::runtime_error);
  CHECK(blocks < 1000000);
}

/// What touches much memory, or compares often, is seen to run as loops are.
void test_buffers_and_sorts_are_watched()
{
  using namespace CGAL::L0_resampling::internal;
  const std::size_t size = 200000, blocks = 4;
  Memory_counter memory;
  const Counting_allocator<int> allocator(&memory);
  Counting_watcher filling, filling_again, copying, sorting, impatient;
  Buffer<int> numbers(allocator);
  {
    const Cancellation_scope watched(&filling);
    numbers = filled_buffer(size, 3, allocator);
  }
  CHECK(filling.looks == blocks && memory.peak() == size * sizeof(int));
  {
    const Cancellation_scope watched(&filling_again);
    CHECK(numbers == Buffer<int>(size, 3, allocator));
    memory.take_peak();
    fill_buffer(size / 2, 4, numbers);
  }
  CHECK(filling_again.looks == blocks / 2
        && memory.peak() == size * sizeof(int)); // the room of before
  CHECK(numbers == Buffer<int>(size / 2, 4, allocator));

  test::Generator generator(2);
  numbers.resize(size);
  for (int& number : numbers)
    number = int(generator() % 1000000);
  {
    const Cancellation_scope watched(&copying);
    const Buffer<int> copy = copy_of(numbers);
    CHECK(copy == numbers && copy.get_allocator() == allocator);
  }
  CHECK(copying.looks == blocks);

  const auto less = [](int a, int b) { return a < b; };
  std::size_t number_of_comparisons = 0;
  {
    const Cancellation_scope watched(&sorting);
    std::sort(numbers.begin(), numbers.end(), watched_order(less, number_of_comparisons));
  }
  CHECK(std::is_sorted(numbers.begin(), numbers.end()));
  CHECK(number_of_comparisons > size && sorting.looks == number_of_comparisons / 65536);

  impatient.last_look = 2;
  const Cancellation_scope watched(&impatient);
  CHECK_THROWS(filled_buffer(size, 3, allocator), std::runtime_error);
  CHECK_THROWS(copy_of(numbers), std::runtime_error);
  CHECK_THROWS(std::sort(numbers.begin(), numbers.end(),
                         watched_order(less, number_of_comparisons)),
               std::runtime_error);
  memory.take_peak();
  resize_to_overwrite(size + 1, numbers);
  CHECK(numbers.size() == size + 1
        && memory.take_peak() == (size + 1) * sizeof(int)); // not beside what was there
  resize_to_overwrite(size, numbers);
  CHECK(numbers.size() == size && memory.peak() == (size + 1) * sizeof(int)); // the room of before
  release(numbers);
  CHECK(memory.take_peak() > 0 && memory.peak() == 0); // what was begun is given back
}

template <typename Number>
void test_selection(std::vector<Number> numbers, std::size_t n)
{
  std::vector<Number> expected = numbers;
  std::nth_element(expected.begin(), expected.begin() + std::ptrdiff_t(n), expected.end());
  const auto nth = numbers.begin() + std::ptrdiff_t(n);
  CGAL::L0_resampling::internal::select_nth(numbers.begin(), nth, numbers.end());
  CHECK(*nth == expected[n]);
  CHECK(std::all_of(numbers.begin(), nth, [&](Number x) { return !(*nth < x); }));
  CHECK(std::all_of(nth, numbers.end(), [&](Number x) { return !(x < *nth); }));
}

/// More numbers than are handed to the standard library at once: all different, sorted, few
/// different ones, all alike
void test_selections()
{
  const std::size_t size = 1500000;
  test::Generator generator(1);
  std::vector<double> numbers(size), sorted(size), few(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    numbers[i] = test::random_number(-1, 1, generator);
    sorted[i] = double(i);
    few[i] = double(generator() % 3);
  }
  for (const std::vector<double>& values : {numbers, sorted, few, std::vector<double>(size, 1.)})
    for (std::size_t n : {std::size_t(0), size / 20, size / 2, size - 1})
      test_selection(values, n);
}

/// None of a block, all of one, and some.
template <typename ConcurrencyTag>
void test_values_are_kept_in_order()
{
  const std::size_t n = 1003, block_size = 10;
  const auto triple = [](std::size_t i) -> std::optional<std::size_t> {
    const std::size_t block = i / block_size;
    return block % 3 == 0 || (block % 3 == 1 && i % 2 == 0) ? std::nullopt : std::optional(3 * i);
  };
  CGAL::L0_resampling::internal::Buffer<std::size_t> values(n), none;
  std::iota(values.begin(), values.end(), std::size_t(0));
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < n; ++i)
    if (const std::optional<std::size_t> value = triple(i))
      expected.push_back(*value);
  CGAL::L0_resampling::internal::keep_by_blocks<ConcurrencyTag>(block_size, triple, values);
  CHECK(std::equal(values.begin(), values.end(), expected.begin(), expected.end()));
  CGAL::L0_resampling::internal::keep_by_blocks<ConcurrencyTag>(block_size, triple, none);
  CHECK(none.empty());
}

#ifdef CGAL_LINKED_WITH_TBB
/// A callback may wait for a loop of its own. No block of the loop that it was called from runs on
/// its thread meanwhile, so that it may hold what such a block needs; and nobody else calls it.
void test_callback_with_a_loop()
{
  using namespace CGAL::L0_resampling;
  const auto pause = [](int microseconds) {
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
  };
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
  thread_local bool is_in_callback = false;
  std::atomic<bool> is_block_inside{false}, is_alone{true};
  std::atomic<int> number_inside{0}, number_of_calls{0};
  const auto callback = [&](double) {
    is_alone = ++number_inside == 1 && is_alone;
    ++number_of_calls;
    is_in_callback = true;
    std::atomic<bool> is_elsewhere{false}; // then there is something to wait for
    tbb::parallel_for(
      0, 2,
      [&](int) {
        for (int i = 0; i < 100 && is_in_callback && !is_elsewhere; ++i)
          pause(200);
        if (!is_in_callback)
        {
          is_elsewhere = true;
          pause(5000);
        }
      },
      tbb::simple_partitioner());
    is_in_callback = false;
    --number_inside;
    return true;
  };
  tbb::task_arena(8).execute([&]() { // however few cores there are
    Report report;
    internal::Memory_counter memory;
    internal::Progress progress(callback, report, memory);
    progress.begin_stage("blocks", 1, 1);
    while (number_of_calls < 20)
      for_each_block<CGAL::Parallel_tag>(4000, 1, [&](std::size_t, std::size_t) {
        is_block_inside = is_in_callback || is_block_inside;
        pause(200);
      });
  });
  CHECK(!is_block_inside);
  CHECK(is_alone);
}
#endif

template <typename ConcurrencyTag>
void test_all()
{
  test_values_are_kept_in_order<ConcurrencyTag>();
  test_loops_are_watched<ConcurrencyTag>();
  test_every_index_once_in_fixed_blocks<ConcurrencyTag>();
  test_sum_is_in_the_order_of_the_blocks<ConcurrencyTag>();
  test_sum_of_a_type_of_ones_own<ConcurrencyTag>();
  test_exceptions_pass<ConcurrencyTag>();
}

} // namespace

int main()
{
  test_selections();
  test_buffers_and_sorts_are_watched();
  test_all<CGAL::Sequential_tag>();
#ifdef CGAL_LINKED_WITH_TBB
  for (const std::size_t threads : {1, 2, 5})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    test_all<CGAL::Parallel_tag>();
  }
  test_callback_with_a_loop();
#endif
  return test::result();
}
