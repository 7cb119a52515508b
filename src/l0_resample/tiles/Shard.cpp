// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Shard.h"

#include "basis/signals.h"

#include <algorithm>

namespace l0_tool {

Shard_writer::Shard_writer(const std::string& path, const std::string& path_of_rows,
                           std::uint64_t key, const Block_lattice& lattice, std::size_t row_size,
                           std::uint64_t bytes)
  : m_file(path, key),
    m_file_of_rows(row_size > 0 ? std::make_unique<Task_file_writer>(path_of_rows, key) : nullptr),
    m_lattice(lattice), m_row_size(row_size),
    m_maximum_number_of_points(
      std::size_t((std::min)(bytes, maximum_bytes) / (bytes_per_point + row_size)))
{
  // a long array takes memory where it is written only
  m_points.reserve(m_maximum_number_of_points);
  m_block_numbers.reserve(m_maximum_number_of_points);
  m_rows.reserve(m_maximum_number_of_points * row_size);
}

void Shard_writer::add(const std::array<double, 3>& point, const std::vector<char>& row)
{
  const Block block = m_lattice.block_of(point);
  std::uint32_t number;
  if (!m_points.empty() && m_last_block == block)
    number = m_block_numbers.back();
  else {
    number = m_blocks.emplace(block, std::uint32_t(m_counts.size())).first->second;
    if (number == m_counts.size())
      m_counts.push_back(0);
    m_last_block = block;
  }
  ++m_counts[number];
  m_points.push_back(point);
  m_block_numbers.push_back(number);
  m_rows.insert(m_rows.end(), row.begin(), row.end());
  if (m_points.size() >= m_maximum_number_of_points)
    write_run();
}

void Shard_writer::write_run()
{
  throw_if_interrupted();
  const std::uint64_t first = m_number_of_points;
  std::vector<std::uint32_t> next(m_counts.size()); // where the next point of each block goes
  for (const auto& [block, number] : m_blocks) {
    m_runs.push_back({block, m_number_of_points, m_counts[number]});
    next[number] = std::uint32_t(m_number_of_points - first);
    m_number_of_points += m_counts[number];
  }
  std::vector<std::uint32_t> order(m_points.size());
  for (std::size_t i = 0; i < m_points.size(); ++i)
    order[next[m_block_numbers[i]]++] = std::uint32_t(i);
  for (const std::uint32_t i : order) {
    m_file.write(m_points[i]);
    if (m_file_of_rows) {
      m_file_of_rows->write(first + i);
      m_file_of_rows->write_bytes({m_rows.data() + i * m_row_size, m_row_size});
    }
  }
  m_points.clear();
  m_block_numbers.clear();
  m_rows.clear();
  m_blocks.clear();
  m_counts.clear();
}

void Shard_writer::commit()
{
  if (!m_points.empty())
    write_run();
  m_points = {};
  m_block_numbers = {};
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

std::vector<Block_run>::const_iterator Shards::first_run(const std::vector<Block_run>& runs,
                                                         const Block& low)
{
  return std::partition_point(runs.begin(), runs.end(),
                              [&](const Block_run& run) { return run.block < low; });
}

void Shards::read(const Block_run& run, const Shard& shard,
                  std::vector<std::array<double, 3>>& points)
{
  throw_if_interrupted();
  shard.file->read_some(0, run.first, run.count, points);
}

} // namespace l0_tool
