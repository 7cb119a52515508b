// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Property_interpolator.h"

#include "basis/Point_cloud.h"
#include "basis/signals.h"
#include "tasks/carry_properties.h"

#include <CGAL/L0_resampling/find_near_points.h>
#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/range/irange.hpp>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace l0_tool {
namespace {

using CGAL::L0_resampling::Index;
using CGAL::L0_resampling::Near_points;

constexpr std::size_t records_at_once = 4096;

} // namespace

/// Points of some blocks, as they were read, and their rows.
struct Property_interpolator::Points
{
  std::vector<std::array<double, 3>> places;
  std::vector<Index> order; ///< that of the files and of the points there
  Property_table properties;
};

Property_interpolator::Property_interpolator(const Shards& shards,
                                             const std::vector<std::string>& paths_of_rows,
                                             std::uint64_t key, const Block_lattice& lattice,
                                             const Counted_blocks& blocks,
                                             const Property_table& properties, std::uint64_t memory)
  : m_shards(shards), m_paths_of_rows(paths_of_rows), m_key(key), m_lattice(lattice),
    m_blocks(blocks), m_nearest_blocks(blocks, CGAL::L0_resampling::number_of_averaged_points),
    m_properties(properties), m_memory(memory)
{}

std::vector<char> Property_interpolator::carry(const std::vector<Tile_sample>& samples,
                                               const std::function<void(double)>& on_progress)
{
  m_samples = &samples;
  m_on_progress = on_progress;
  m_number_done = 0;
  m_order.clear();
  m_order.reserve(samples.size());
  for (const Tile_sample& sample : samples)
    m_order.emplace_back(m_lattice.block_of(sample.position), std::uint32_t(m_order.size()));
  tbb::parallel_sort(m_order.begin(), m_order.end());
  m_result.resize(samples.size() * m_properties.row_size());
  carry_to(0, samples.size());
  return std::move(m_result);
}

/// Of the samples from `begin` to `end` in their order by blocks.
void Property_interpolator::carry_to(std::size_t begin, std::size_t end)
{
  if (begin == end)
    return;
  const std::vector<char> wanted = blocks_near(begin, end);
  std::uint64_t number_of_points = 0;
  for (std::size_t i = 0; i < m_blocks.size(); ++i)
    number_of_points += wanted[i] != 0 ? m_blocks[i].second : 0;
  const Bytes_of_call bytes = bytes_of_call(m_properties.row_size());
  const std::size_t middle = middle_of(begin, end);
  const double needed = double(number_of_points) * double(bytes.per_point)
                        + double(m_samples->size()) * double(bytes.per_sample);
  if (needed > double(m_memory) && middle < end) {
    carry_to(begin, middle);
    carry_to(middle, end);
    return;
  }
  carry_from(read(wanted, std::size_t(number_of_points)), begin, end);
  m_number_done += end - begin;
  m_on_progress(double(m_number_done) / double(m_samples->size()));
}

/// Where the samples of a block begin, so that about half of all are before; `end` if they are all
/// of one block.
std::size_t Property_interpolator::middle_of(std::size_t begin, std::size_t end) const
{
  const Block block = m_order[begin + (end - begin) / 2].first;
  const auto at = [&](std::size_t i) { return m_order.begin() + std::ptrdiff_t(i); };
  const auto is_before = [&](const auto& sample) { return sample.first < block; };
  const auto is_not_behind = [&](const auto& sample) { return sample.first <= block; };
  const auto first = std::partition_point(at(begin), at(end), is_before);
  const auto last = std::partition_point(first, at(end), is_not_behind);
  return std::size_t((first == at(begin) ? last : first) - m_order.begin());
}

std::vector<char> Property_interpolator::blocks_near(std::size_t begin, std::size_t end) const
{
  std::vector<char> wanted(m_blocks.size(), 0);
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin && m_order[i].first == m_order[i - 1].first)
      continue;
    throw_if_interrupted();
    m_nearest_blocks.for_each(m_order[i].first, [&](std::size_t block) { wanted[block] = 1; });
  }
  return wanted;
}

Property_interpolator::Points Property_interpolator::read(const std::vector<char>& wanted,
                                                          std::size_t number_of_points) const
{
  const auto is_wanted = [&](const Block& block) {
    const auto found = std::partition_point(m_blocks.begin(), m_blocks.end(),
                                            [&](const auto& b) { return b.first < block; });
    return found != m_blocks.end() && found->first == block
           && wanted[std::size_t(found - m_blocks.begin())] != 0;
  };
  const auto first = std::find(wanted.begin(), wanted.end(), char(1));
  const auto behind = std::find(wanted.rbegin(), wanted.rend(), char(1));
  const Block low = m_blocks[std::size_t(first - wanted.begin())].first,
              last = m_blocks[std::size_t(wanted.rend() - behind) - 1].first;

  Points points;
  points.properties = m_properties;
  points.places.reserve(number_of_points);
  points.properties.reserve(number_of_points);
  std::vector<std::pair<std::uint64_t, Index>> order; // by the number of a point in its file
  order.reserve(number_of_points);
  std::vector<std::size_t> ends; // of the points of each shard
  std::vector<char> records;
  const std::size_t record_size = sizeof(std::uint64_t) + m_properties.row_size();
  for (std::size_t shard = 0; shard < m_shards.size(); ++shard) {
    const Task_file rows(m_paths_of_rows[shard], m_key);
    const auto add = [&](const Block_run& run, const std::vector<std::array<double, 3>>& places) {
      for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t of_these = i % records_at_once;
        if (of_these == 0) {
          const std::size_t size = (std::min)(records_at_once, places.size() - i);
          rows.read_some(0, (run.first + i) * record_size, size * record_size, records);
        }
        const char* const record = records.data() + of_these * record_size;
        std::uint64_t number;
        std::memcpy(&number, record, sizeof number);
        order.emplace_back(number, Index(order.size()));
        points.places.push_back(places[i]);
        points.properties.append(record + sizeof number);
      }
    };
    m_shards.for_each_run_of(shard, low, last, is_wanted, add);
    ends.push_back(order.size());
  }

  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    tbb::parallel_sort(order.begin() + std::ptrdiff_t(begin), order.begin() + std::ptrdiff_t(end));
    begin = end;
  }
  points.order.reserve(order.size());
  for (const auto& [number, place] : order)
    points.order.push_back(place);
  return points;
}

void Property_interpolator::carry_from(Points points, std::size_t begin, std::size_t end)
{
  const auto point_at = [](const std::array<double, 3>& p) { return Point(p[0], p[1], p[2]); };
  const auto point_of_rank = [&](std::size_t rank) {
    return point_at(points.places[points.order[rank]]);
  };
  const auto point_of_sample = [&](std::size_t i) {
    return point_at((*m_samples)[m_order[i].second].position);
  };
  Near_points near = CGAL::L0_resampling::find_near_points<CGAL::Parallel_if_available_tag>(
    boost::irange(std::size_t(0), points.order.size()), boost::irange(begin, end),
    CGAL::L0_resampling::number_of_averaged_points,
    CGAL::parameters::point_map(boost::make_function_property_map<std::size_t>(point_of_rank))
      .query_point_map(boost::make_function_property_map<std::size_t>(point_of_sample))
      .callback([](double) { return !is_interrupted(); }));
  throw_if_interrupted();
  near.renumber([&](Index rank) { return points.order[rank]; });

  const Property_table rows = carried_properties(points.properties, near, {}, {}, end - begin);
  const std::size_t row_size = rows.row_size();
  for (std::size_t i = begin; i < end; ++i)
    std::copy_n(rows.row(i - begin), row_size, m_result.data() + m_order[i].second * row_size);
}

} // namespace l0_tool
