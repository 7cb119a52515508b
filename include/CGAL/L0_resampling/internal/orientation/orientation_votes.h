// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_VOTES_H
#define CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_VOTES_H

#include <CGAL/L0_resampling/internal/core/Signed_union_find.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/core/parallel_sort.h>
#include <CGAL/L0_resampling/internal/core/random_bits.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Two samples near each other, and `orientation_agreement()` of them.
struct Edge
{
  float agreement;
  Index i, k;
};
constexpr std::size_t edges_per_block = 16384;

/// The sum of the agreements of edges between two samples or, read for their representatives,
/// between two sets.
struct Vote
{
  Index a, b;
  double agreement, total;
};

/// Adds up votes between the same two, in the order of these.
/// \param number_of_samples that may vote
template <typename ConcurrencyTag>
void add_up_votes(std::size_t number_of_samples, Buffer<Vote>& votes)
{
  // of samples that follow each other; there are few votes of each
  const std::size_t votes_per_bucket = 4096,
                    number_of_buckets = (std::min)(votes.size() / votes_per_bucket + 1,
                                                   std::size_t(1024)),
                    samples_per_bucket = (number_of_samples + number_of_buckets - 1)
                                         / number_of_buckets;
  const std::vector<std::size_t> first_votes = partition_into_buckets<ConcurrencyTag>(
    number_of_buckets,
    [divisor = Index(samples_per_bucket)](const Vote& v) { return std::size_t(v.a / divisor); },
    votes);
  std::vector<std::size_t> numbers_of_sums(number_of_buckets);
  for_each_block<ConcurrencyTag>(number_of_buckets, 1, [&](std::size_t bucket, std::size_t) {
    Vote* const first = votes.data() + first_votes[bucket];
    const std::size_t size = first_votes[bucket + 1] - first_votes[bucket],
                      first_sample = bucket * samples_per_bucket, long_list = 16384;
    std::vector<std::size_t> ends(samples_per_bucket + 1, 0);
    for (std::size_t n = 0; n < size; ++n)
      ++ends[first[n].a - first_sample + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<Vote> sorted(size);
    for (std::size_t n = 0; n < size; ++n)
      sorted[ends[first[n].a - first_sample]++] = first[n];

    const auto is_before = [](const Vote& v, const Vote& w) {
      return v.b != w.b                   ? v.b < w.b
             : v.agreement != w.agreement ? v.agreement < w.agreement
                                          : v.total < w.total;
    };
    std::size_t number_of_comparisons = 0, number_of_sums = 0;
    for (std::size_t k = 0, begin = 0; k < samples_per_bucket; begin = ends[k++])
    {
      const auto of_sample = sorted.begin() + std::ptrdiff_t(begin),
                 end = sorted.begin() + std::ptrdiff_t(ends[k]);
      if (end - of_sample > std::ptrdiff_t(long_list))
        std::sort(of_sample, end, watched_order(is_before, number_of_comparisons));
      else
        std::sort(of_sample, end, is_before);
      for (auto v = of_sample; v != end; ++v)
        if (v != of_sample && v->b == (v - 1)->b)
        {
          first[number_of_sums - 1].agreement += v->agreement;
          first[number_of_sums - 1].total += v->total;
        }
        else
          first[number_of_sums++] = *v;
    }
    numbers_of_sums[bucket] = number_of_sums;
  });
  auto end = votes.begin();
  for (std::size_t bucket = 0; bucket < number_of_buckets; ++bucket)
  {
    const auto first = votes.begin() + std::ptrdiff_t(first_votes[bucket]);
    end = std::copy(first, first + std::ptrdiff_t(numbers_of_sums[bucket]), end);
    poll_for_cancellation();
  }
  votes.resize(std::size_t(end - votes.begin()));
}

/// Adds up votes between the same two as they come. Where most are, looking up costs a third of
/// sorting them.
class Vote_sums
{
  Buffer<Vote>& m_sums;
  std::vector<Index> m_slots; // at least every second one empty; the others lead to a sum
  static constexpr Index empty = (std::numeric_limits<Index>::max)();

public:
  /// \param sums out: in the order in which each two first come
  Vote_sums(std::size_t maximum_number_of_votes, Buffer<Vote>& sums) : m_sums(sums)
  {
    std::size_t size = 2;
    while (size < 2 * maximum_number_of_votes)
      size *= 2;
    m_slots.assign(size, empty);
  }

  void add(const Vote& vote)
  {
    const std::uint64_t key = (std::uint64_t(vote.a) << 32) | vote.b;
    for (std::size_t slot = std::size_t(random_bits(0, key));; ++slot)
    {
      Index& place = m_slots[slot & (m_slots.size() - 1)];
      if (place == empty)
      {
        place = Index(m_sums.size());
        m_sums.push_back(vote);
        return;
      }
      Vote& sum = m_sums[place];
      if (sum.a == vote.a && sum.b == vote.b)
      {
        sum.agreement += vote.agreement;
        sum.total += vote.total;
        return;
      }
    }
  }
};

/// The vote between the sets of two samples, or of two sets before they were joined to others;
/// nothing if they are one set.
/// \param find finds the set of a sample
template <typename Find>
std::optional<Vote> vote_between_sets(const Find& find, const Vote& vote)
{
  const auto [root_a, sign_a] = find(vote.a);
  const auto [root_b, sign_b] = find(vote.b);
  if (root_a == root_b)
    return std::nullopt;
  return Vote{(std::min)(root_a, root_b), (std::max)(root_a, root_b),
              sign_a * sign_b * vote.agreement, vote.total};
}

/// The votes of the edges between sets: one for each pair of sets that touch, in the order of the
/// pairs.
template <typename ConcurrencyTag>
Buffer<Vote> votes_of_edges(const Buffer<Edge>& edges, const Signed_union_find& sets)
{
  Buffer<Vote> votes = append_by_blocks<ConcurrencyTag>(
    edges.size(), edges_per_block, Counting_allocator<Vote>(edges.get_allocator()),
    [&](std::size_t begin, std::size_t end, Buffer<Vote>& votes_of_block) {
      Vote_sums sums(end - begin, votes_of_block);
      for (std::size_t e = begin; e < end; ++e)
        if (const auto vote = vote_between_sets([&](Index i) { return sets.find(i); },
                                                {edges[e].i, edges[e].k, edges[e].agreement,
                                                 std::abs(edges[e].agreement)}))
          sums.add(*vote);
    });
  add_up_votes<ConcurrencyTag>(sets.size(), votes);
  return votes;
}

/// Sets of samples, and the votes between them.
struct Voting
{
  Signed_union_find sets;
  Buffer<Vote> votes; // added up
};

/// Replaces the votes between sets before they were joined by those between the sets as they are
/// now.
template <typename ConcurrencyTag>
void pass_votes_on(Voting& voting)
{
  Buffer<Vote>& votes = voting.votes;
  const auto find = [&](Index i) { return voting.sets.find_and_compress(i); };
  std::size_t size = 0;
  for_each_in_order(votes.size(), [&](std::size_t n) {
    if (const auto vote = vote_between_sets(find, votes[n]))
      votes[size++] = *vote;
  });
  votes.resize(size);
  add_up_votes<ConcurrencyTag>(voting.sets.size(), votes);
}

/// Joins sets that touch by majority: round by round, each set merges with the neighbor of the
/// strongest vote.
/// \param sure the share of the votes, in [0, 1], that the winning side has to be ahead by
template <typename ConcurrencyTag>
void join_by_votes(double sure, Voting& voting)
{
  const Buffer<Vote>& votes = voting.votes;
  const std::size_t none = (std::numeric_limits<std::size_t>::max)();
  Buffer<std::size_t> strongest =
    filled_buffer(voting.sets.size(), none,
                  votes.get_allocator()); // the vote of each set that it joins by
  const auto is_stronger = [&](std::size_t v, std::size_t w) {
    const double a = std::abs(votes[v].agreement), b = std::abs(votes[w].agreement);
    return a != b ? a > b : v < w;
  };
  for (bool is_joined = true; is_joined;)
  {
    is_joined = false;
    for_each_in_order(votes.size(),
                      [&](std::size_t n) { strongest[votes[n].a] = strongest[votes[n].b] = none; });
    for_each_in_order(votes.size(), [&](std::size_t n) {
      if (std::abs(votes[n].agreement) >= sure * votes[n].total)
        for (const Index set : {votes[n].a, votes[n].b})
          if (strongest[set] == none || is_stronger(n, strongest[set]))
            strongest[set] = n;
    });
    for_each_in_order(votes.size(), [&](std::size_t n) {
      if (strongest[votes[n].a] == n || strongest[votes[n].b] == n)
      {
        voting.sets.join(votes[n].a, votes[n].b, votes[n].agreement < 0 ? -1 : 1);
        is_joined = true;
      }
    });
    pass_votes_on<ConcurrencyTag>(voting);
  }
  voting.sets.compress();
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ORIENTATION_VOTES_H
