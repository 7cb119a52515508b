// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H
#define CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H

#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>

#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// `sort_by_key()` of a range, by one thread: radix sort, and what has equal keys after it.
template <typename Iterator, typename Key, typename Less>
void sort_range_by_key(Iterator begin, Iterator end, const Key& key, const Less& less)
{
  boost::sort::spreadsort::integer_sort(
    begin, end, [&](const auto& a, unsigned shift) -> std::uint64_t { return key(a) >> shift; },
    [&](const auto& a, const auto& b) { return key(a) < key(b); });
  std::size_t number_of_comparisons = 0;
  for (Iterator first = begin, last = begin; first != end; first = last)
  {
    last = std::find_if(first, end, [&](const auto& a) { return key(a) != key(*first); });
    std::sort(first, last, watched_order(less, number_of_comparisons));
  }
}

/// Puts the values into buckets, in the order that they have.
/// \param bucket_of tells the bucket of a value
/// \returns the first place of each bucket, and the number of values
template <typename ConcurrencyTag, typename Value, typename F>
std::vector<std::size_t> partition_into_buckets(std::size_t number_of_buckets, const F& bucket_of,
                                                Buffer<Value>& values)
{
  const std::size_t values_per_block = 8192, n = values.size();
  const std::size_t number_of_blocks = (n + values_per_block - 1) / values_per_block;
  std::vector<std::size_t> places(number_of_blocks * number_of_buckets,
                                  0); // of the values of a block in a bucket
  for_each_block<ConcurrencyTag>(n, values_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      ++places[begin / values_per_block * number_of_buckets + bucket_of(values[i])];
  });
  std::vector<std::size_t> first_places;
  std::size_t place = 0;
  for (std::size_t bucket = 0; bucket < number_of_buckets; ++bucket)
  {
    first_places.push_back(place);
    for (std::size_t block = 0; block < number_of_blocks; ++block)
    {
      std::size_t& count = places[block * number_of_buckets + bucket];
      place += count;
      count = place - count;
    }
  }
  first_places.push_back(n);

  Buffer<Value> partitioned(n, values.get_allocator());
  for_each_block<ConcurrencyTag>(n, values_per_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      partitioned[places[begin / values_per_block * number_of_buckets + bucket_of(values[i])]++] =
        values[i];
  });
  values.swap(partitioned);
  return first_places;
}

/// Puts the values into `number_of_buckets` buckets, a power of two, so that no key of a bucket is
/// larger than one of the next. Few are much larger than the others, unless many keys are equal.
/// \returns the first place of each bucket, and the number of values
template <typename ConcurrencyTag, typename Value, typename Key>
std::vector<std::size_t> partition_by_key(std::size_t number_of_buckets, const Key& key,
                                          Buffer<Value>& values)
{
  const std::size_t samples_per_bucket = 32, n = values.size();
  std::vector<std::uint64_t> bounds; // of the bucket k: [bounds[k], bounds[k + 1])
  for (std::size_t k = 0, size = number_of_buckets * samples_per_bucket; k < size; ++k)
    bounds.push_back(key(values[n / size * k]));
  std::sort(bounds.begin(), bounds.end());
  for (std::size_t k = 0; k < number_of_buckets; ++k)
    bounds[k] = bounds[k * samples_per_bucket];
  const auto bucket_of = [&](const Value& value) {
    std::size_t bucket = 0; // binary search without a branch
    for (std::size_t step = number_of_buckets / 2; step > 0; step /= 2)
      bucket += step * std::size_t(bounds[bucket + step] <= key(value));
    return bucket;
  };
  return partition_into_buckets<ConcurrencyTag>(number_of_buckets, bucket_of, values);
}

/// Sorts by a key, a `std::uint64_t`, and values of equal keys by `less`, an order without ties, so
/// that the result does not depend on the number of threads.
template <typename ConcurrencyTag, typename Value, typename Key, typename Less>
void sort_by_key(Buffer<Value>& values, const Key& key, const Less& less)
{
  const std::size_t too_few_for_threads = 16384,
                    large_bucket = 131072; // of the latter, sorting takes some 20 ms
  std::size_t number_of_buckets = std::is_convertible<ConcurrencyTag, Parallel_tag>::value ? 64 : 1;
  while (number_of_buckets < 1024 && values.size() / number_of_buckets > large_bucket)
    number_of_buckets *= 2;
  if (number_of_buckets == 1 || values.size() < too_few_for_threads)
    return sort_range_by_key(values.begin(), values.end(), key, less);
  const std::vector<std::size_t> first_places = partition_by_key<ConcurrencyTag>(number_of_buckets,
                                                                                 key, values);
  for_each_block<ConcurrencyTag>(number_of_buckets, 1, [&](std::size_t bucket, std::size_t) {
    sort_range_by_key(values.begin() + std::ptrdiff_t(first_places[bucket]),
                      values.begin() + std::ptrdiff_t(first_places[bucket + 1]), key, less);
  });
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_PARALLEL_SORT_H
