// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_INTERNAL_COUNTED_CLOUD_H
#define CGAL_L0_RESAMPLING_INTERNAL_COUNTED_CLOUD_H

#include <CGAL/L0_resampling/Source_box.h>
#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/cloud/working_frame.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/tiles/Block_counts.h>
#include <CGAL/L0_resampling/internal/tiles/Tiling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// A cloud that is not in memory: how many points each block has, and what that tells.
class Counted_cloud
{
  Block_lattice m_lattice;
  std::vector<std::pair<Block, std::uint64_t>> m_blocks;
  std::array<double, 3> m_low, m_high;
  std::uint64_t m_number_of_points;
  double m_box_diagonal = 0, m_robust_diagonal = 0; // the latter to within a block
  Vector m_middle = Vector::Zero();                 // of each coordinate, likewise: the median

public:
  explicit Counted_cloud(Block_counts counts)
  {
    counts.finish();
    m_lattice = counts.lattice();
    m_blocks = counts.blocks();
    m_low = counts.low();
    m_high = counts.high();
    m_number_of_points = counts.number_of_points();
    if (m_blocks.empty())
      return;
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      sum += square(m_high[axis] - m_low[axis]);
      m_middle[Eigen::Index(axis)] =
        Quantiles_of_blocks(counts, axis).coordinate_at(m_number_of_points / 2);
    }
    m_box_diagonal = std::sqrt(sum);
    m_robust_diagonal = robust_diagonal_of_blocks(counts);
  }

  const Block_lattice& lattice() const { return m_lattice; }
  const std::vector<std::pair<Block, std::uint64_t>>& blocks() const { return m_blocks; }
  std::uint64_t number_of_points() const { return m_number_of_points; }
  const std::array<double, 3>& low() const { return m_low; }
  const std::array<double, 3>& high() const { return m_high; }

  Source_box source_box(const Block_box& box) const
  {
    Source_box source;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      source.low[axis] = double(box.low[axis]) * m_lattice.side();
      source.high[axis] = double(box.high[axis] + 1) * m_lattice.side();
    }
    return source;
  }

  /// Appends the points of some blocks.
  template <typename Source>
  void read(const Source& source, const Block_box& box, Buffer<Vector>& points) const
  {
    source.for_each_point(source_box(box), [&](const std::array<double, 3>& p) {
      points.push_back(Vector(p[0], p[1], p[2]));
    });
  }

  /// What is known of the cloud before any point is read again: all but the scales.
  Facts_of_cloud facts() const
  {
    const double largest = (std::max)(Vector(m_low.data()).cwiseAbs().maxCoeff(),
                                      Vector(m_high.data()).cwiseAbs().maxCoeff());
    const int exponent = Working_frame::exponent_of(largest);
    const auto scaled = [&](double x) { return std::ldexp(x, exponent); };
    Facts_of_cloud facts;
    facts.frame = Place_of_frame{exponent, m_middle.unaryExpr(scaled)};
    facts.extents = Facts{std::size_t(m_number_of_points), scaled(m_box_diagonal),
                          scaled(m_robust_diagonal), exponent};
    return facts;
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_COUNTED_CLOUD_H
