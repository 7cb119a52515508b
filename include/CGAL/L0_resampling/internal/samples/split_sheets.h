// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_SPLIT_SHEETS_H
#define CGAL_L0_RESAMPLING_INTERNAL_SPLIT_SHEETS_H

#include <CGAL/L0_resampling/internal/kernels/cells_of_refinement.h>
#include <CGAL/L0_resampling/internal/samples/Gathered_values.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
Finds samples between two sheets that were taken for one, and puts each on one of them. The points
of sheets t apart scatter by \f$ \sigma^2 + t^2/4 \f$ about a quadric through both, in any ball:
what bends or ends makes that depend on the ball, and larger noise has another kurtosis. Of those so
found, those stay that most samples around agree with. Sides are chosen so that those around a
sample cancel.

Where the points do not scatter as the noise of the cloud, they tell that of the place.
*/
template <typename ConcurrencyTag>
class Sheet_splitter
{
  using L = Lanes<Local>;
  using Local_vector = Eigen::Matrix<Local, 3, 1>;

  const Lengths_of_refinement& m_lengths;
  const Search_grid_3& m_grid;
  const Buffer<float>& m_scales; // none if all are 1
  const double m_minimum_cell_size;
  const Buffer<Disk>& m_disks;
  Progress& m_progress;
  Buffer<Vector>& m_positions;
  Buffer<Local_vector>& m_normals;
  Buffer<float>& m_noise_ratios;
  Buffer<Split_of_sheet> m_splits;
  Buffer<signed char> m_sides;

  double scale(std::size_t i) const { return double(m_grid.scale(i)); }

  /// \param make_visitor called with which sample stands where in the cells; null if each stands in
  /// its own place
  template <typename Make_visitor>
  void for_each_cell_in(double units, const Make_visitor& make_visitor) const
  {
    const double radius = units * m_lengths.unit;
    const auto visit = [&](const Search_grid_3& grid, const Buffer<Vector>& positions,
                           const Index* order) {
      for_each_cell<Local, ConcurrencyTag>(grid, positions, grid, positions,
                                           cells_in_reach(radius, grid.cell_size()), m_progress,
                                           [&]() { return make_visitor(order); });
    };
    if (is_reached_in_cells(radius, m_grid.cell_size()))
    {
      visit(m_grid, m_positions, nullptr);
      return;
    }
    const Sorted_queries sorted(ConcurrencyTag(), m_positions,
                                Cell_sizes((std::max)(radius / 2, m_minimum_cell_size), m_scales));
    visit(sorted.grid, sorted.points, sorted.order.data());
  }

  static Index sample_at(const Index* order, Index place) { return order ? order[place] : place; }

  /// \param condition of a sample
  template <typename Condition>
  static bool is_any(const Search_grid_3::Range& queries, const Index* order,
                     const Condition& condition)
  {
    for (Index q = queries.first; q < queries.second; ++q)
      if (condition(sample_at(order, q)))
        return true;
    return false;
  }

  double known_noise_ratio(std::size_t i) const
  {
    return m_lengths.is_noise_known ? double(view_of_scales(m_noise_ratios)[i]) : 1;
  }

  void look_at(std::size_t i, const Local_vector& center, Local_points<Local>& candidates,
               const Gathered_values<Local, 8>& values)
  {
    const double radius = radius_of_split * m_lengths.unit * scale(i),
                 noise = m_lengths.at(scale(i), known_noise_ratio(i)).noise_of_disk();
    const Local highest = Local(maximum_height_of_sheets * noise), unit = Local(1 / radius),
                squared_inner = Local(square(inner_share_of_split));
    const Vector normal = m_normals[i].template cast<double>();
    const Tangent_frame frame({normal.x(), normal.y(), normal.z()});
    const auto dot = [](const L& x, const L& y, const L& z, const Triple& a) {
      return x * Local(a.x) + y * Local(a.y) + z * Local(a.z);
    };
    Moments_of_sheets<L> all, inner;
    candidates.for_each_run_in_ball(
      center, Local(square(radius) + square(highest)), [&](std::size_t k, const L& squared) {
        const L nx = values.load(5, k), ny = values.load(6, k), nz = values.load(7, k),
                dx = L::load(&candidates.x[k]) - center[0],
                dy = L::load(&candidates.y[k]) - center[1],
                dz = L::load(&candidates.z[k]) - center[2];
        const L cosine = dot(nx, ny, nz, frame.normal), off = dot(dx, dy, dz, frame.normal),
                height = off + cosine * values.load(0, k);
        const L within = (squared - off * off) * (unit * unit);
        const L is_of_sheets =
          where_less(abs(off), highest,
                     where_less(-abs(cosine), -minimum_cosine_of_sheets, values.load(2, k)));
        const L z = values.load(0, k),
                u = (dot(dx, dy, dz, frame.u) + z * dot(nx, ny, nz, frame.u)) * unit,
                v = (dot(dx, dy, dz, frame.v) + z * dot(nx, ny, nz, frame.v)) * unit;
        const L near = at_least(L(Local(1)) - within, 0),
                nearer = at_least(L(Local(1)) - within * (1 / squared_inner), 0);
        const auto add_to = [&](Moments_of_sheets<L>& sums, const L& share) {
          sums.add(u, v, height, values.load(1, k), values.load(3, k), values.load(4, k),
                   share * share * is_of_sheets);
        };
        add_to(all, near);
        add_to(inner, nearer);
      });
    const auto sum = [](const L& lanes) { return double(lanes.sum()); };
    const double squared_noise = square(noise);
    const Scatter_in_ball of_ball(all.template transformed<double>(sum), squared_noise),
      of_inner(inner.template transformed<double>(sum), squared_noise);
    m_splits[i] = Split_of_sheet(of_ball, of_inner, squared_noise, m_lengths.unit * scale(i));
    if (!m_lengths.is_noise_known)
      m_noise_ratios[i] = noise_ratio(of_ball, of_inner, m_splits[i], noise);
  }

  void find_splits()
  {
    for_each_cell_in(radius_of_split, [&](const Index* order) {
      return [&, order, values = Gathered_values<Local, 8>()](Search_grid_3::Range queries,
                                                              Local_points<Local>& candidates,
                                                              const Vector& origin) mutable {
        values.gather(candidates, [&](Index place, Local(&own)[8]) {
          const Index k = sample_at(order, place);
          const Disk& disk = m_disks[k];
          own[0] = disk.height;
          own[1] = (std::max)(disk.squared_height - disk.height * disk.height, 0.f);
          own[2] = disk.weight;
          own[3] = disk.squared_height;
          own[4] = disk.fourth_power;
          for (int axis = 0; axis < 3; ++axis)
            own[5 + axis] = m_normals[k][axis];
        });
        for (Index q = queries.first; q < queries.second; ++q)
        {
          const Index i = sample_at(order, q);
          look_at(i, (m_positions[i] - origin).template cast<Local>(), candidates, values);
        }
      };
    });
  }

  /// Keeps those that most around agree with.
  void keep_agreed(double units, double share, double share_sure)
  {
    Buffer<Split_of_sheet> kept(m_splits.size(), m_splits.get_allocator());
    for_each_cell_in(units, [&](const Index* order) {
      return [&, order, values = Gathered_values<Local, 6>()](Search_grid_3::Range queries,
                                                              Local_points<Local>& candidates,
                                                              const Vector& origin) mutable {
        if (!is_any(queries, order, [&](Index i) { return m_splits[i].half_distance > 0; }))
          return;
        values.gather(candidates, [&](Index place, Local(&own)[6]) {
          const Index k = sample_at(order, place);
          own[0] = 1;
          own[1] = m_splits[k].half_distance > 0;
          own[2] = m_splits[k].is_sure;
          for (int axis = 0; axis < 3; ++axis)
            own[3 + axis] = m_normals[k][axis];
        });
        for (Index q = queries.first; q < queries.second; ++q)
        {
          const Index i = sample_at(order, q);
          if (!(m_splits[i].half_distance > 0))
            continue;
          const Local_vector center = (m_positions[i] - origin).template cast<Local>(),
                             normal = m_normals[i];
          const Local squared = Local(square(units * m_lengths.unit * scale(i)));
          L sums[3];
          candidates.for_each_run_in_ball(center, squared, [&](std::size_t k, const L& d) {
            const L cosine = values.load(3, k) * normal[0] + values.load(4, k) * normal[1]
                             + values.load(5, k) * normal[2];
            for (int a = 0; a < 3; ++a)
              sums[a] += where_less(d, squared,
                                    where_less(-abs(cosine), -minimum_cosine_of_majority,
                                               values.load(a, k)));
          });
          const Local all = sums[0].sum(), flagged = sums[1].sum(), sure = sums[2].sum();
          if (flagged > Local(share) * all && sure > Local(share_sure) * flagged)
            kept[i] = m_splits[i];
        }
      };
    });
    m_splits.swap(kept);
  }

  /// Each goes to the side that fewer of those around it are on.
  void balance_sides(int turn)
  {
    Buffer<signed char> sides = copy_of(m_sides);
    for_each_cell_in(radius_of_balance, [&](const Index* order) {
      return [&, order, values = Gathered_values<Local, 3>()](Search_grid_3::Range queries,
                                                              Local_points<Local>& candidates,
                                                              const Vector& origin) mutable {
        if (!is_any(queries, order, [&](Index i) { return m_sides[i] != 0; }))
          return;
        values.gather(candidates, [&](Index place, Local(&own)[3]) {
          const Index k = sample_at(order, place);
          for (int axis = 0; axis < 3; ++axis)
            own[axis] = Local(m_sides[k]) * m_normals[k][axis];
        });
        for (Index q = queries.first; q < queries.second; ++q)
        {
          const Index i = sample_at(order, q);
          const Vector& p = m_positions[i];
          if (m_sides[i] == 0 || !is_balanced_in(turn, p.data()))
            continue;
          const Local_vector center = (p - origin).template cast<Local>(), normal = m_normals[i];
          const double unit = m_lengths.unit * scale(i);
          const Local squared = Local(square(radius_of_balance * unit)),
                      per = Local(1 / square(unit));
          L sum;
          candidates.for_each_run_in_ball(center, squared, [&](std::size_t k, const L& d) {
            const L cosine = values.load(0, k) * normal[0] + values.load(1, k) * normal[1]
                             + values.load(2, k) * normal[2];
            sum += where_less(d, squared, cosine * decay(d * per));
          });
          const Local others = sum.sum() - Local(m_sides[i]);
          if (others != 0)
            sides[i] = others > 0 ? -1 : 1;
        }
      };
    });
    m_sides.swap(sides);
  }

public:
  /// \param grid, scales of the samples
  Sheet_splitter(const Lengths_of_refinement& lengths, const Search_grid_3& grid,
                 const Buffer<float>& scales, double minimum_cell_size, const Buffer<Disk>& disks,
                 Progress& progress, Buffer<Vector>& positions, Buffer<Local_vector>& normals,
                 Buffer<float>& noise_ratios)
    : m_lengths(lengths), m_grid(grid), m_scales(scales), m_minimum_cell_size(minimum_cell_size),
      m_disks(disks), m_progress(progress), m_positions(positions), m_normals(normals),
      m_noise_ratios(noise_ratios), m_splits(positions.size(), positions.get_allocator()),
      m_sides(positions.size(), positions.get_allocator())
  {}

  /// \param splits whether sheets are split, beside finding the noise
  /// \returns which of two sheets each sample was put on, 1 or -1, or 0 if none; empty if none was
  Buffer<signed char> operator()(bool splits)
  {
    const Buffer<signed char> none(m_sides.get_allocator());
    find_splits();
    if (!splits)
      return none;
    keep_agreed(radius_of_majority, share_of_majority, 0);
    keep_agreed(radius_of_region, share_of_region, share_of_sure_ones);
    bool are_any_split = false;
    for_each_in_order(m_splits.size(), [&](std::size_t i) {
      m_sides[i] = first_side(m_splits[i], m_positions[i].data());
      are_any_split = are_any_split || m_sides[i] != 0;
    });
    if (!are_any_split)
      return none;
    for (int turn = 0; turn < number_of_balances; ++turn)
      balance_sides(turn);
    for_each_in_order(m_splits.size(), [&](std::size_t i) {
      if (m_sides[i] == 0)
        return;
      const double height = double(m_splits[i].middle)
                            + m_sides[i] * double(m_splits[i].half_distance);
      m_positions[i] += height * m_normals[i].template cast<double>();
      m_normals[i] *= Local(m_sides[i]);
    });
    return std::move(m_sides);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_SPLIT_SHEETS_H
