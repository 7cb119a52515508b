// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_HALF_SAMPLING_H
#define CGAL_L0_RESAMPLING_INTERNAL_HALF_SAMPLING_H

#include <CGAL/L0_resampling/Quadratic_problem.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The greedy two-element partitions of Algorithm 2, and the room for them, which is kept from one
/// set to the next.
template <typename FT>
class Pair_partitioner
{
public:
  /*!
  The partition \f$ K_{p_i} \f$ that Algorithm 2 finds for a set of `n` points: pairs by ascending
  distance, equal distances by the lower index of the pair, then by the higher.

  Algorithm 2 sorts all n^2/2 distances. Its result does not need them: since the order of the pairs
  is total, it is the one matching in which every pair, once the pairs before it are gone, is that
  of two points which are nearest to each other. Such pairs may be taken as they are found. They are
  found by going from a point to its nearest neighbor, from there to its nearest neighbor, and so
  on, which only ever leads to lesser pairs and so ends. That looks at each point at most 1.5 times
  and takes O(n) memory, whatever the points are, all equal included.

  \param positions xyz interleaved, 3n numbers whose squared distances are finite
  \returns the partner of each of the n points, the point itself if it is left over, as is one point
  of an odd set;
           valid until the next call
  */
  const std::vector<Index>& operator()(const FT* positions, std::size_t n)
  {
    load(positions, n);
    m_chain.clear();
    while (m_size > 1)
    {
      if (m_chain.empty())
        m_chain.push_back(m_points[0]);
      const Index nearest = nearest_neighbor(m_chain.back());
      if (m_chain.size() > 1 && m_chain[m_chain.size() - 2] == nearest)
      {
        const Index point = m_chain.back();
        m_partners[point] = nearest;
        m_partners[nearest] = point;
        remove(point);
        remove(nearest);
        m_chain.resize(m_chain.size() - 2);
      }
      else
        m_chain.push_back(nearest);
    }
    return m_partners;
  }

private:
  static constexpr std::size_t lanes = 8; // enough independent minima to hide the latency of each
  using Lanes = Eigen::Array<FT, int(lanes), 1>;
  using Const_lanes = Eigen::Map<const Lanes>;

  /// Fills up with points at infinity, so that whole lanes can be read and the filling
  /// is never nearest.
  void load(const FT* positions, std::size_t n)
  {
    const std::size_t padded_size = (n + lanes - 1) / lanes * lanes;
    const FT infinity = std::numeric_limits<FT>::infinity();
    m_x.assign(padded_size, infinity);
    m_y.assign(padded_size, infinity);
    m_z.assign(padded_size, infinity);
    m_distances.resize(padded_size);
    m_points.resize(n);
    m_slots.resize(n);
    m_partners.resize(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      m_x[i] = positions[3 * i];
      m_y[i] = positions[3 * i + 1];
      m_z[i] = positions[3 * i + 2];
      m_points[i] = m_slots[i] = m_partners[i] = Index(i);
    }
    m_size = n;
  }

  /// The remaining point nearest to `point`, of several the one with the lowest index. For the
  /// pairs of one point that is their order in Algorithm 2.
  Index nearest_neighbor(Index point)
  {
    const std::size_t slot = m_slots[point];
    const FT x = m_x[slot], y = m_y[slot], z = m_z[slot];
    m_x[slot] = std::numeric_limits<FT>::infinity(); // a point is not its own neighbor
    Lanes least = Lanes::Constant(std::numeric_limits<FT>::infinity());
    for (std::size_t s = 0; s < m_size; s += lanes)
    {
      const Lanes dx = Const_lanes(&m_x[s]) - x;
      const Lanes dy = Const_lanes(&m_y[s]) - y;
      const Lanes dz = Const_lanes(&m_z[s]) - z;
      const Lanes squared_distance = dx * dx + dy * dy + dz * dz;
      Eigen::Map<Lanes>(m_distances.data() + s) = squared_distance;
      least = (least.min)(squared_distance);
    }
    m_x[slot] = x;

    const FT minimum_squared_distance = least.minCoeff();
    Index nearest = (std::numeric_limits<Index>::max)();
    for (std::size_t s = 0; s < m_size; s += lanes)
      if (Const_lanes(&m_distances[s]).minCoeff() == minimum_squared_distance)
        for (std::size_t l = s; l < (std::min)(s + lanes, m_size); ++l)
          if (m_distances[l] == minimum_squared_distance)
            nearest = (std::min)(nearest, m_points[l]);
    return nearest;
  }

  void remove(Index point)
  {
    const std::size_t slot = m_slots[point], last = --m_size;
    m_x[slot] = m_x[last];
    m_y[slot] = m_y[last];
    m_z[slot] = m_z[last];
    m_points[slot] = m_points[last];
    m_slots[m_points[slot]] = Index(slot);
    m_x[last] = std::numeric_limits<FT>::infinity();
  }

  std::size_t m_size = 0;        // points without a partner
  std::vector<FT> m_x, m_y, m_z; // their coordinates, then infinity
  std::vector<FT> m_distances;   // their squared distances to the point that is looked at
  std::vector<Index> m_points;   // their indices
  std::vector<Index> m_slots;    // for each of those points its place in the arrays above
  std::vector<Index> m_chain;    // each but the first the nearest neighbor of the one before
  std::vector<Index> m_partners; // the result
};

/*!
Replaces each pair of a partition by one point, which makes \f$ \hat{M}_{p_i} \f$ of
\f$ M_{p_i} \f$. The paper drops the weights \f$ 1/v_j \f$ here; ours add up, and the point is the
mean by those weights, which is the midpoint of Eq. (13) where they are equal. So the fit term keeps
its minimum, and \f$ A^T A \f$ and \f$ A^T b \f$ do not change. The new points stand in the order of
the lower indices of their pairs.

\param partners what `Pair_partitioner` returns for these points
\param positions xyz interleaved, of as many points as there are partners; overwritten from the
front
\param weights one number a point, not negative; overwritten from the front
\returns the new number of points
*/
template <typename FT>
std::size_t merge_pairs(const std::vector<Index>& partners, FT* positions, FT* weights)
{
  std::size_t size = 0;
  for (std::size_t i = 0; i < partners.size(); ++i)
  {
    const std::size_t j = partners[i];
    if (j < i)
      continue;
    const FT weight = j == i ? weights[i] : weights[i] + weights[j];
    // two points without weight still have a place
    const FT share = j == i ? FT(0) : weight > 0 ? weights[j] / weight : FT(0.5);
    for (std::size_t c = 0; c < 3; ++c)
      positions[3 * size + c] = positions[3 * i + c]
                                + share * (positions[3 * j + c] - positions[3 * i + c]);
    weights[size] = weight;
    ++size;
  }
  return size;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_HALF_SAMPLING_H
