// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints a hash of the result of each case, so that a restructuring, which must not change results,
// can be checked: compare_result_hashes.py compares two such lists. One line has the name of the
// case, the method, the number of threads, the number of points, the hash of what was written
// (positions, normals, indices and confidences) and that of the report, without times and memory.
// Hashes depend on the processor and the compiler, so that none are stored.
//
//   result_hashes [NAME...]     all cases, or these
//
// Ends with 1 if the results of one and of two threads differ.

#include "../attack/call.h"
#include "cases.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <iterator>

namespace {

/// 64 bits of FNV-1a.
class Hash
{
  std::uint64_t m_value = 0xcbf29ce484222325;

public:
  std::uint64_t value() const { return m_value; }

  template <typename Number>
  void add(Number number)
  {
    std::array<unsigned char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), &number, sizeof(Number));
    for (const unsigned char byte : bytes)
      m_value = (m_value ^ byte) * 0x100000001b3;
  }

  template <typename Numbers>
  void add_all(const Numbers& numbers)
  {
    add(std::uint64_t(std::size(numbers)));
    for (const auto& number : numbers)
      add(number);
  }
};

struct Hashes
{
  std::size_t number_of_points;
  std::uint64_t result, report;

  friend bool operator==(const Hashes& a, const Hashes& b)
  {
    return a.number_of_points == b.number_of_points && a.result == b.result && a.report == b.report;
  }
};

std::uint64_t hash_of_result(const attack::Answer& answer)
{
  Hash hash;
  hash.add(int(answer.ending));
  hash.add_all(answer.message);
  for (const auto* vectors : {&answer.points, &answer.normals})
  {
    hash.add(std::uint64_t(vectors->size()));
    for (const test::Vector& v : *vectors)
      for (const double coordinate : v)
        hash.add(coordinate);
  }
  hash.add_all(answer.sources);
  hash.add_all(answer.confidences);
  return hash.value();
}

std::uint64_t hash_of_report(const CGAL::L0_resampling::Report& report)
{
  Hash hash;
  hash.add(int(report.outcome));
  hash.add(report.number_of_input_points);
  hash.add(report.number_of_dropped_points);
  hash.add(report.number_of_outliers);
  hash.add(report.number_of_distinct_points);
  hash.add(report.number_of_output_points);
  hash.add(report.number_of_degenerate_neighborhoods);
  hash.add(report.number_of_lonely_samples);
  hash.add(report.number_of_unexplained_samples);
  hash.add(report.number_of_self_neighbor_pairs);
  hash.add(report.neighbor_radius);
  hash.add(report.normal_filter_radius);
  hash.add(report.estimated_spacing);
  hash.add(report.estimated_noise);
  hash.add(report.sample_spacing);
  hash.add(report.oriented_share);
  hash.add(report.hinted_share);
  for (const CGAL::L0_resampling::Iteration_report& iteration : report.iterations)
  {
    hash.add(iteration.penalty);
    hash.add(iteration.regularized);
    hash.add(iteration.fit_energy);
    hash.add(iteration.regularization_energy);
    hash.add(iteration.normal_energy);
    hash.add(iteration.sparsity_energy);
    hash.add(iteration.active_pair_share);
    hash.add(iteration.solver.iterations);
    hash.add(iteration.solver.relative_residual);
  }
  hash.add(report.converged);
  return hash.value();
}

Hashes hashes_of(const attack::Attack& input, bool in_parallel)
{
  const attack::Answer answer = attack::call(input, in_parallel);
  return {answer.points.size(), hash_of_result(answer), hash_of_report(answer.report)};
}

void print(const attack::Attack& input, const char* method, int threads, const Hashes& hashes)
{
  std::printf("%-20s %-7s %d ", input.name.c_str(), method, threads);
  std::printf("%6zu %016" PRIx64 " ", hashes.number_of_points, hashes.result);
  std::printf("%016" PRIx64 "\n", hashes.report);
  std::fflush(stdout);
}

/// \returns whether one and two threads give the same
bool print_hashes(attack::Attack& input)
{
  const char* const methods[] = {"default", "lor", "alor"}; // in the order of `Method`
  bool threads_agree = true;
  for (int method = 0; method < 3; ++method)
  {
    input.parameters.method = method;
    const Hashes of_one = hashes_of(input, false), of_two = hashes_of(input, true);
    print(input, methods[method], 1, of_one);
    print(input, methods[method], 2, of_two);
    threads_agree = threads_agree && of_one == of_two;
  }
  return threads_agree;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
#ifdef CGAL_LINKED_WITH_TBB
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
#endif
    const std::vector<std::string> names(argv + 1, argv + argc);
    bool has_case = false, threads_agree = true;
    for (attack::Attack& input : result_hashes::all_cases(L0_TEST_DATA))
    {
      if (!names.empty() && std::find(names.begin(), names.end(), input.name) == names.end())
        continue;
      has_case = true;
      if (print_hashes(input))
        continue;
      threads_agree = false;
      std::cerr << input.name << ": one and two threads differ" << std::endl;
    }
    if (!has_case)
      std::cerr << "no case has that name" << std::endl;
    return has_case && threads_agree ? 0 : 1;
  }
  catch (const std::exception& e)
  {
    std::cerr << e.what() << std::endl;
    return 1;
  }
}
