// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Shard.h"

#include "basis/signals.h"

#include <algorithm>
#include <numeric>

namespace l0_tool {

Shard_writer::Shard_writer(const std::string& path, const std::string& path_of_rows,
                           std::uint64_t key, const Block_lattice& lattice, std::size_t row_size,
                           std::uint64_t bytes)
  : m_file(path, key),
    m_file_of_rows(row_size > 0 ? std::make_unique<Task_file_writer>(path_of_rows, key) : nullptr),
    m_lattice(lattice), m_row_size(row_size),
    m_most_points(std::size_t((std::min)(bytes, most_bytes) / (sizeof(Sorted_point) + row_size)))
{
  m_run.reserve(m_most_points); // a long array takes memory where it is written only
  m_rows.reserve(m_most_points * row_size);
}

void Shard_writer::add(const std::array<double, 3>& point, const std::vector<char>& row)
{
  const Block block = m_lattice.block_of(point);
  std::uint32_t place;
  if (!m_run.empty() && m_blocks[m_run.back().place] == block)
    place = m_run.back().place;
  else {
    const auto [found, is_new] = m_places.emplace(block, std::uint32_t(m_blocks.size()));
    if (is_new)
      m_blocks.push_back(block);
    place = found->second;
  }
  m_run.push_back({point, place, std::uint32_t(m_run.size())});
  m_rows.insert(m_rows.end(), row.begin(), row.end());
  if (m_run.size() >= m_most_points)
    write_run();
}

void Shard_writer::write_run()
{
  throw_if_interrupted();
  std::vector<std::uint32_t> ranks(m_blocks.size());
  std::uint32_t rank = 0;
  for (const auto& [block, place] : m_places)
    ranks[place] = rank++;
  std::sort(m_run.begin(), m_run.end(), [&](const Sorted_point& a, const Sorted_point& b) {
    return a.place != b.place ? ranks[a.place] < ranks[b.place] : a.sequence < b.sequence;
  });
  const std::uint64_t first = m_number_of_points;
  for (std::size_t i = 0; i < m_run.size(); ++i) {
    if (i == 0 || m_run[i].place != m_run[i - 1].place)
      m_runs.push_back({m_blocks[m_run[i].place], m_number_of_points, 0});
    ++m_runs.back().count;
    ++m_number_of_points;
    m_file.write(m_run[i].point);
    if (m_file_of_rows) {
      const std::uint32_t sequence = m_run[i].sequence;
      m_file_of_rows->write(first + sequence);
      m_file_of_rows->write_bytes({m_rows.data() + sequence * m_row_size, m_row_size});
    }
  }
  m_run.clear();
  m_rows.clear();
  m_places.clear();
  m_blocks.clear();
}

void Shard_writer::commit()
{
  if (!m_run.empty())
    write_run();
  m_run = {};
  m_rows = {};
  const std::uint64_t begin_of_runs = m_file.size();
  std::stable_sort(m_runs.begin(), m_runs.end(),
                   [](const Block_run& a, const Block_run& b) { return a.block < b.block; });
  m_file.write_all(m_runs);
  m_file.write(begin_of_runs);
  if (m_file_of_rows)
    m_file_of_rows->commit();
  m_file.commit();
}

Shards::Shards(const std::vector<std::string>& paths, std::uint64_t key,
               const Block_lattice& lattice)
  : m_lattice(lattice)
{
  for (const std::string& path : paths) {
    auto file = std::make_unique<Task_file>(path, key);
    file->seek(file->size() - sizeof(std::uint64_t));
    file->seek(file->read<std::uint64_t>());
    std::vector<Block_run> runs;
    file->read_all(runs);
    m_shards.push_back({std::move(file), std::move(runs)});
  }
}

std::vector<Block_run>::iterator Shards::first_run(std::vector<Block_run>& runs, const Block& low)
{
  return std::partition_point(runs.begin(), runs.end(),
                              [&](const Block_run& run) { return run.block < low; });
}

void Shards::read(const Block_run& run, Shard& shard, std::vector<std::array<double, 3>>& points)
{
  throw_if_interrupted();
  points.resize(std::size_t(run.count));
  shard.file->seek(run.first * sizeof(std::array<double, 3>));
  shard.file->read_bytes(run.count * sizeof(std::array<double, 3>),
                         reinterpret_cast<char*>(points.data()));
}

} // namespace l0_tool
