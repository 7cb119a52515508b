// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TILE_COUNTS_H
#define CGAL_L0_RESAMPLING_TILE_COUNTS_H

#include <CGAL/license/L0_resampling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// A cube of a lattice through the origin of the input's coordinates: its place on each axis.
using Block = std::array<std::int64_t, 3>;

/// \ingroup PkgL0ResamplingRef
/// Cubes whose side is a power of two, so that eight of one lattice make one of the next.
class Block_lattice
{
  int m_exponent;
  double m_factor; // blocks per length

public:
  static constexpr int least_exponent = -1000, largest_exponent = 1000; // whose powers are normal

  explicit Block_lattice(int exponent = least_exponent)
    : m_exponent(exponent), m_factor(std::ldexp(1., -exponent))
  {}

  int exponent() const { return m_exponent; }
  double side() const { return std::ldexp(1., m_exponent); }

  /// \param point in the unit of the input: three numbers that follow each other at `data()`
  template <typename Point>
  Block block_of(const Point& point) const
  {
    Block block;
    for (std::size_t axis = 0; axis < block.size(); ++axis)
      block[axis] = std::int64_t(
        std::floor(double(point.data()[axis]) * m_factor)); // the product is exact
    return block;
  }

  /// Whether the numbers of the blocks of coordinates of this size are far from overflow.
  bool can_number(double largest_coordinate) const
  {
    return largest_coordinate * m_factor < double(std::int64_t(1) << 40);
  }
};

/// \ingroup PkgL0ResamplingRef
/// A box of blocks, both corners included.
struct Block_box
{
  Block low, high;

  bool contains(const Block& block) const
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (block[axis] < low[axis] || block[axis] > high[axis])
        return false;
    return true;
  }

  Block_box grown(std::int64_t margin) const
  {
    Block_box box = *this;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box.low[axis] -= margin;
      box.high[axis] += margin;
    }
    return box;
  }
};

/// \ingroup PkgL0ResamplingRef
/// The blocks whose samples one task finds, and how many points it looks at for that.
struct Tile
{
  Block_box box;                            ///< of its blocks that hold points
  std::uint64_t number_of_points;           ///< of its own blocks
  std::uint64_t number_of_points_with_halo; ///< and of those around
};

/// \ingroup PkgL0ResamplingRef
/// What a call that resamples points holds at most.
struct Bytes_of_call
{
  std::uint64_t per_point, per_sample;
};

/*!
\ingroup PkgL0ResamplingRef

Counts the points of each block, while points come in any order and from several places: by these
counts a cloud is cut into tiles. The blocks are as small as limits on their number allow, so that
the tiles do not depend on the order. Counts of several parts of a cloud may be added up.
*/
class Tile_counts
{
  struct Hash
  {
    std::size_t operator()(const Block& block) const
    {
      std::uint64_t bits = 0;
      for (const std::int64_t place : block)
      {
        bits = (bits ^ std::uint64_t(place)) * 0x9e3779b97f4a7c15u;
        bits ^= bits >> 29;
      }
      return std::size_t(bits);
    }
  };

  Block_lattice m_lattice;
  std::unordered_map<Block, std::uint64_t, Hash> m_counts;
  std::uint64_t m_number_of_points = 0;
  std::array<double, 3> m_low = {}, m_high = {};

  /// Makes the blocks 2^`levels` times as large.
  void coarsen_by(int levels)
  {
    std::unordered_map<Block, std::uint64_t, Hash> counts;
    for (const auto& [block, count] : m_counts)
    {
      Block larger = block;
      for (std::int64_t& place : larger)
        place >>= (std::min)(levels, 63); // rounds down
      counts[larger] += count;
    }
    m_counts = std::move(counts);
    m_lattice = Block_lattice(m_lattice.exponent() + levels);
  }

  void coarsen_to(int exponent)
  {
    if (m_lattice.exponent() < exponent)
      coarsen_by(exponent - m_lattice.exponent());
  }

  /// Along the Z-order curve, on which the blocks within a larger one follow each other.
  static bool precedes(const Block& a, const Block& b)
  {
    std::size_t axis = 0;
    std::uint64_t largest = 0; // difference, as its highest bit has it
    for (std::size_t k = 0; k < a.size(); ++k)
    {
      const std::uint64_t difference = std::uint64_t(a[k] ^ b[k]);
      if (largest < difference && largest < (largest ^ difference))
      {
        axis = k;
        largest = difference;
      }
    }
    return a[axis] < b[axis];
  }

  /// From this level on two blocks are within the same one; never, if a sign differs.
  static std::size_t level_in_common(const Block& a, const Block& b)
  {
    std::uint64_t difference = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis)
      difference |= std::uint64_t(a[axis] ^ b[axis]);
    std::size_t level = 0;
    for (; difference != 0; difference >>= 1)
      ++level;
    return level;
  }

  /// Makes the blocks as large as it takes, and no larger, for `are_few(number)` to hold.
  template <typename F>
  void coarsen_until(const F& are_few)
  {
    if (are_few(m_counts.size()))
      return;
    std::vector<Block> blocks;
    blocks.reserve(m_counts.size());
    for (const auto& [block, count] : m_counts)
      blocks.push_back(block);
    std::sort(blocks.begin(), blocks.end(), precedes);
    std::array<std::size_t, 65> joined = {}; // blocks, by the level at which they are
    for (std::size_t i = 1; i < blocks.size(); ++i)
      ++joined[level_in_common(blocks[i - 1], blocks[i])];
    std::size_t number = blocks.size();
    int levels = 0;
    while (levels < 64 && !are_few(number))
      number -= joined[std::size_t(++levels)];
    coarsen_by((std::min)(levels, Block_lattice::largest_exponent - m_lattice.exponent()));
  }

  void keep_limit()
  {
    coarsen_until([](std::size_t number) { return number <= most_blocks; });
  }

  /// Not at each block too many, as points go on coming.
  void keep_working_limit()
  {
    if (m_counts.size() > 2 * most_blocks)
      keep_limit();
  }

public:
  static constexpr std::size_t most_blocks = std::size_t(1) << 18;
  /// Smaller blocks would make more of a tile's points its halo's than their number gains.
  static constexpr std::uint64_t fewest_points_per_block = 256; // in the mean

  Tile_counts() = default;

  /// Blocks with their counts, as `blocks()` gives them.
  Tile_counts(int exponent, const std::vector<std::pair<Block, std::uint64_t>>& blocks,
              const std::array<double, 3>& low, const std::array<double, 3>& high)
    : m_lattice(exponent), m_counts(blocks.begin(), blocks.end()), m_low(low), m_high(high)
  {
    for (const auto& [block, count] : blocks)
      m_number_of_points += count;
  }

  /// \param point finite
  void add(const std::array<double, 3>& point)
  {
    double largest = 0;
    for (const double coordinate : point)
      largest = (std::max)(largest, std::abs(coordinate));
    Block_lattice lattice = m_lattice;
    while (!lattice.can_number(largest))
      lattice = Block_lattice(lattice.exponent() + 1);
    coarsen_to(lattice.exponent());
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      m_low[axis] = m_number_of_points == 0 ? point[axis] : (std::min)(m_low[axis], point[axis]);
      m_high[axis] = m_number_of_points == 0 ? point[axis] : (std::max)(m_high[axis], point[axis]);
    }
    ++m_number_of_points;
    ++m_counts[m_lattice.block_of(point)];
    keep_working_limit();
  }

  void add(Tile_counts other)
  {
    if (other.m_number_of_points == 0)
      return;
    if (m_number_of_points == 0)
    {
      *this = std::move(other);
      return;
    }
    coarsen_to(other.m_lattice.exponent());
    other.coarsen_to(m_lattice.exponent());
    for (const auto& [block, count] : other.m_counts)
      m_counts[block] += count;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      m_low[axis] = (std::min)(m_low[axis], other.m_low[axis]);
      m_high[axis] = (std::max)(m_high[axis], other.m_high[axis]);
    }
    m_number_of_points += other.m_number_of_points;
    keep_working_limit();
  }

  /// Once all points are counted: makes the blocks so large that there are not too many, and that
  /// they hold enough points.
  void finish()
  {
    keep_limit();
    coarsen_until([&](std::size_t number) {
      return number <= 1 || m_number_of_points >= fewest_points_per_block * number;
    });
  }

  const Block_lattice& lattice() const { return m_lattice; }
  std::uint64_t number_of_points() const { return m_number_of_points; }
  const std::array<double, 3>& low() const { return m_low; }
  const std::array<double, 3>& high() const { return m_high; }

  /// Those that hold points, in lexicographic order. As long as points come, there may be twice as
  /// many as `most_blocks`.
  std::vector<std::pair<Block, std::uint64_t>> blocks() const
  {
    std::vector<std::pair<Block, std::uint64_t>> sorted(m_counts.begin(), m_counts.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILE_COUNTS_H
