// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What tasks of `--as-one` leave to each other: equal bytes for equal results, no values from
// damaged files that no task could have written, and shards that several threads read at once.

#include "test_support.h"

#include "basis/Failure.h"
#include "tiles/Input_properties.h"
#include "tiles/Shard.h"
#include "tiles/Task_file.h"
#include "tiles/tile_files.h"

#include <CGAL/L0_resampling/Source_box.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

namespace {

using namespace l0_tool;
namespace internal = CGAL::L0_resampling::internal;
using Place = std::array<double, 3>;

constexpr std::uint64_t key = 7;

/// A path that is free, and is so again at the end.
class Path
{
  std::string m_path;

public:
  Path()
  {
    static int number = 0;
    m_path = "task_file_" + std::to_string(getpid()) + "_" + std::to_string(number++);
  }
  ~Path() { unlink(m_path.c_str()); }
  Path(const Path&) = delete;
  Path& operator=(const Path&) = delete;

  const std::string& name() const { return m_path; }
  std::string bytes() const
  {
    std::ifstream stream(m_path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

/// A file with the right key and checksum.
template <typename... Values>
void write_values(const Path& path, const Values&... values)
{
  Task_file_writer file(path.name(), key);
  (file.write(values), ...);
  file.commit();
}

/// Facts that were put together in memory whose bytes had a value.
std::string bytes_of_facts(unsigned char in_memory_before)
{
  alignas(Facts_of_run) unsigned char memory[sizeof(Facts_of_run)];
  std::memset(memory, in_memory_before, sizeof memory);
  alignas(internal::Facts) unsigned char memory_of_extents[sizeof(internal::Facts)];
  std::memset(memory_of_extents, in_memory_before, sizeof memory_of_extents);
  auto* const extents = new (memory_of_extents) internal::Facts;
  extents->number_of_points = 5;
  extents->box_diagonal = 2;
  extents->robust_diagonal = 1;
  extents->exponent_of_input = 3;
  auto* const facts = new (memory) Facts_of_run;
  facts->of_cloud.frame = internal::Place_of_frame{2, internal::Vector(1, 2, 3)};
  facts->of_cloud.extents = *extents;
  facts->of_cloud.scales = internal::Scales{0.1, 0.2};
  facts->of_cloud.has_plain_blocks = true;
  facts->memory_of_tile = 1000;
  const Path path;
  write_facts(path.name(), key, *facts);
  facts->~Facts_of_run();
  return path.bytes();
}

/// Equal facts are equal files, whatever was in memory before, and are read as they were.
void check_bytes_of_facts()
{
  const std::string bytes = bytes_of_facts(0x00);
  CHECK(bytes == bytes_of_facts(0xff) && !bytes.empty());
  const Path path;
  std::ofstream(path.name(), std::ios::binary) << bytes;
  const Facts_of_run facts = read_facts(path.name(), key);
  CHECK(facts.memory_of_tile == 1000);
  CHECK(facts.of_cloud.frame->exponent == 2 && facts.of_cloud.frame->origin[2] == 3);
  CHECK(facts.of_cloud.extents->number_of_points == 5 && facts.of_cloud.extents->box_diagonal == 2
        && facts.of_cloud.extents->robust_diagonal == 1
        && facts.of_cloud.extents->exponent_of_input == 3);
  CHECK(facts.of_cloud.scales->noise == 0.2 && *facts.of_cloud.has_plain_blocks);
  CHECK(!facts.of_cloud.area && !facts.of_cloud.field);
}

/// A byte is a flag, or the number of a type, only if it is one that a task can have written.
void check_flags_and_types()
{
  for (const int byte : {0, 1, 2, 255})
  {
    const Path path;
    write_values(path, std::uint8_t(byte), std::uint8_t(byte)); // of both medians
    if (byte == 0)
      CHECK(!read_medians(path.name(), key).scales);
    else
      CHECK_THROWS(read_medians(path.name(), key), Failure);
  }
  const std::uint64_t no_characters = 0, one = 1;
  for (const std::uint8_t type : {std::uint8_t(number_of_types), std::uint8_t(255)})
  {
    const Path path;
    write_values(path, no_characters, one, no_characters, type, no_characters, // a property
                 std::uint8_t(0), std::uint8_t(0), no_characters);
    Task_file file(path.name(), key);
    CHECK_THROWS(read_properties(file), Failure);
  }
}

/// A number of values that the file cannot have, also one whose bytes are few modulo 2^64.
void check_counts()
{
  const std::uint64_t too_many[] = {7, std::uint64_t(1) << 62, ~std::uint64_t(0)};
  for (const std::uint64_t count : too_many)
  {
    const Path path;
    write_values(path, count, 1.f, 2.f, std::uint64_t(0), std::uint64_t(0));
    CHECK_THROWS(read_scales(path.name(), key), Failure);
    CHECK_THROWS(read_neighbor_counts(path.name(), key), Failure);
  }
  const Path path;
  write_values(path, std::uint64_t(0), 1.f, 2.f, std::uint64_t(0), std::uint64_t(0));
  CHECK(read_neighbor_counts(path.name(), key).maximum_scale == 2);
}

/// Points of some blocks in a row, in shards.
void write_shard(const Path& path, const CGAL::L0_resampling::Block_lattice& lattice,
                 int number_of_blocks)
{
  Shard_writer writer(path.name(), "", key, lattice, 0, 1 << 20);
  for (int i = 0; i < 100 * number_of_blocks; ++i)
    writer.add({double(i % number_of_blocks) + 0.5, double(i), 0.5}, {});
  writer.commit();
}

/// Runs of points that are not in the file.
void check_runs_beyond_the_end()
{
  const CGAL::L0_resampling::Block_lattice lattice(0);
  const std::uint64_t beyond[] = {1, std::uint64_t(1) << 61, ~std::uint64_t(0)};
  for (const std::uint64_t first : beyond)
    for (const std::uint64_t count : beyond)
    {
      const Path path;
      {
        Task_file_writer file(path.name(), key);
        file.write(Place{1, 2, 3}); // the only point
        const std::uint64_t begin_of_runs = file.size();
        file.write_all(std::vector<Block_run>{{Block{0, 0, 0}, first, count}});
        file.write(begin_of_runs);
        file.commit();
      }
      const Shards shards({path.name()}, key, lattice);
      if (first > 1 || count > 1) // else the points are those of the table behind them
        CHECK_THROWS(shards.for_each_point(CGAL::L0_resampling::Source_box{{0, 0, 0}, {1, 1, 1}},
                                           [](const Place&) {}),
                     Failure);
    }
}

/// A shard is read by several threads at once, each its own blocks.
void check_threads()
{
  const int number_of_blocks = 64, number_of_threads = 8;
  const CGAL::L0_resampling::Block_lattice lattice(0);
  const Path path;
  write_shard(path, lattice, number_of_blocks);
  const Shards shards({path.name()}, key, lattice);
  std::atomic<int> number_of_wrong{0}, number_of_points{0};
  std::vector<std::thread> threads;
  for (int t = 0; t < number_of_threads; ++t)
    threads.emplace_back([&, t]() {
      for (int x = t; x < number_of_blocks; x += number_of_threads)
        shards.for_each_point(CGAL::L0_resampling::Source_box{{double(x), 0, 0},
                                                              {double(x + 1), 6400, 1}},
                              [&](const Place& point) {
                                number_of_wrong += point[0] != x + 0.5;
                                ++number_of_points;
                              });
    });
  for (std::thread& thread : threads)
    thread.join();
  CHECK(number_of_wrong == 0);
  CHECK(number_of_points == 100 * number_of_blocks);
}

} // namespace

int main()
{
  check_bytes_of_facts();
  check_flags_and_types();
  check_counts();
  check_runs_beyond_the_end();
  check_threads();
  return test::result();
}
