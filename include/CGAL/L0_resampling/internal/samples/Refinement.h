// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_REFINEMENT_H
#define CGAL_L0_RESAMPLING_INTERNAL_REFINEMENT_H

#include <CGAL/L0_resampling/internal/kernels/cells_of_refinement.h>
#include <CGAL/L0_resampling/internal/samples/Samples.h>
#include <CGAL/L0_resampling/internal/samples/find_deviations.h>
#include <CGAL/L0_resampling/internal/samples/fit_disks.h>
#include <CGAL/L0_resampling/internal/samples/keep_clear_of_creases.h>
#include <CGAL/L0_resampling/internal/samples/merge_disks.h>
#include <CGAL/L0_resampling/internal/samples/share_points.h>
#include <CGAL/L0_resampling/internal/samples/split_sheets.h>
#include <CGAL/L0_resampling/internal/samples/weigh_by_risk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/*!
One round of the refinement: the arrays of it, and what runs on them. The surface is a mixture of
disks, one a sample, which the points scatter about. Surfaces are fitted not to points but to the
disks of balls of several sizes, which are few and have little noise, and averaged by their risk.
*/
template <typename ConcurrencyTag>
class Refinement
{
  const Lengths_of_refinement m_lengths;
  const double m_minimum_cell_size;
  Progress& m_progress;
  const double m_cell_size;
  const Buffer<Index> m_order; // of the samples
  Buffer<Vector> m_positions;
  Buffer<Local_vector> m_normals;
  const Buffer<float> m_scales; // none if all are 1
  Buffer<float> m_noise_ratios;
  Buffer<signed char> m_sheets; // which of two each was put on, 1 or -1; none if none was split
  const Search_grid_3 m_grid;
  Buffer<Disk> m_disks;
  Buffer<float> m_heights, m_informations; // of the disks
  Buffer<Surface_of_disks> m_predictions, m_references;
  Buffer<Surfaces_of_scale> m_surfaces, m_smallest_surfaces;
  Buffer<Mean_surface> m_means;
  Buffer<Bend> m_bends;
  Buffer<Deviations> m_deviations; // none unless asked for

  Lengths_of_refinement lengths_at(std::size_t i) const
  {
    return m_lengths.at(double(m_grid.scale(i)), double(view_of_scales(m_noise_ratios)[i]));
  }
  double unit(std::size_t i) const { return m_lengths.unit * double(m_grid.scale(i)); }

  template <typename F>
  void for_each_sample(const F& f)
  {
    for_each_block<ConcurrencyTag>(m_positions.size(), 1024,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (std::size_t i = begin; i < end; ++i)
                                       f(i);
                                   });
  }

public:
  /// At most, while the reference is found.
  static constexpr std::size_t bytes_of_sample =
    2 * sizeof(Index) + sizeof(Vector) + sizeof(Local_vector) + sizeof(Disk) + 3 * sizeof(float)
    + 2 * sizeof(Surface_of_disks) + 2 * sizeof(Surfaces_of_scale) + sizeof(Mean_surface)
    + sizeof(Values_of_differences);

  template <typename FT>
  Refinement(const Lengths_of_refinement& lengths, double cell_size_of_points,
             double minimum_cell_size, const Samples<FT>& samples, Progress& progress)
    : m_lengths(lengths), m_minimum_cell_size(minimum_cell_size), m_progress(progress),
      m_cell_size(cell_size_of_refinement(lengths, cell_size_of_points)),
      m_order(Search_grid_3::sorted_order<ConcurrencyTag>(samples.positions,
                                                          Cell_sizes(m_cell_size, samples.scales))),
      m_positions(values_in_order<ConcurrencyTag>(m_order, samples.positions)),
      m_normals(m_positions.size(), allocator()),
      m_scales(listed_scales(view_of_scales(samples.scales), m_order)),
      m_noise_ratios(listed_scales(view_of_scales(samples.noise_ratios), m_order)),
      m_sheets(allocator()),
      m_grid(ConcurrencyTag(), m_positions, Cell_sizes(m_cell_size, m_scales)),
      m_disks(allocator()), m_heights(m_positions.size(), allocator()),
      m_informations(m_positions.size(), allocator()),
      m_predictions(m_positions.size(), allocator()), m_references(m_positions.size(), allocator()),
      m_surfaces(m_positions.size(), allocator()), m_smallest_surfaces(allocator()),
      m_means(m_positions.size(), allocator()), m_bends(allocator()), m_deviations(allocator())
  {
    for_each_sample(
      [&](std::size_t i) { m_normals[i] = samples.normals[m_order[i]].template cast<Local>(); });
  }

  /// \param scales of the points; none if all are 1
  /// \param widening of the noise
  void share_points(const Search_grid_3& grid, const Buffer<Vector>& points,
                    const Buffer<float>& scales, double widening = 1)
  {
    if (grid.cell_size() == m_cell_size)
      return share_points(grid, points, widening);
    const Sorted_queries sorted(ConcurrencyTag(), points, Cell_sizes(m_cell_size, scales));
    share_points(sorted.grid, sorted.points, widening);
  }

  /// Finds the noise around each sample, where the caller does not know it, and splits merged
  /// sheets.
  /// \param are_sides_known whether it is known what the points were seen from: then two sheets are
  /// one wall that was seen twice, as both sides of a plate never are
  void split_sheets(bool are_sides_known)
  {
    if (!m_lengths.is_noise_known)
      m_noise_ratios.resize(m_positions.size());
    m_sheets = Sheet_splitter<ConcurrencyTag>(m_lengths, m_grid, m_scales, m_minimum_cell_size,
                                              m_disks, m_progress, m_positions, m_normals,
                                              m_noise_ratios)(!are_sides_known);
  }

  void fit_disks(int scale_of_fit)
  {
    const double units = radius_of_fit(scale_of_fit), radius = units * m_lengths.unit;
    const Fitted_disks all = {m_positions, m_normals, m_heights, m_informations, m_scales};
    const auto fit = [&](const Samples_to_fit& samples, const Search_grid_3& grid,
                         const Fitted_disks& disks) {
      internal::fit_disks<ConcurrencyTag>(
        samples, grid, disks, cells_in_reach(radius, grid.cell_size()),
        [&](std::size_t i) { return units * unit(i); },
        [&](std::size_t i) { return lengths_at(i).deviation(m_disks[i]); },
        m_lengths.noise_of_disk(), scale_of_fit, m_progress, m_predictions, m_surfaces);
    };
    if (scale_of_fit < first_scale_of_merged_disks)
    {
      fit({m_grid, m_positions, nullptr, m_normals}, m_grid, all);
      return;
    }
    const double cell_size = (std::max)(radius / 2, m_minimum_cell_size);
    Merged_disks disks = merge_disks<ConcurrencyTag>(all, (std::max)(cell_of_merged_disks * radius,
                                                                     m_minimum_cell_size));
    disks.sort<ConcurrencyTag>(cell_size);
    const Search_grid_3 grid(ConcurrencyTag(), disks.positions,
                             Cell_sizes(cell_size, disks.scales));
    const Sorted_queries queries(ConcurrencyTag(), m_positions, Cell_sizes(cell_size, m_scales));
    fit({queries.grid, queries.points, queries.order.data(), m_normals}, grid, disks.view());
  }

  /// Of each scale, in order. Surfaces of the smallest balls wait for their reference.
  void weigh_by_risk(int scale_of_fit)
  {
    if (scale_of_fit < scale_of_reference)
    {
      m_smallest_surfaces = copy_of(m_surfaces);
      return;
    }
    if (scale_of_fit == scale_of_reference)
    {
      for_each_sample([&](std::size_t i) {
        m_references[i] = reference_of(m_surfaces[i].quadric, m_smallest_surfaces[i].quadric,
                                       lengths_at(i).share_of_smallest_reference());
      });
      weigh(m_smallest_surfaces, radius_of_bias(0));
      release(m_smallest_surfaces);
    }
    weigh(m_surfaces, radius_of_bias(scale_of_fit));
  }

  /// Moves the samples to the mean of their surfaces.
  void take_mean_surfaces()
  {
    release(m_predictions);
    release(m_references);
    release(m_surfaces);
    m_bends.resize(m_positions.size());
    for_each_sample([&](std::size_t i) {
      const Vector normal = m_normals[i].template cast<double>();
      const Settled_on_mean settled(m_means[i], {normal.x(), normal.y(), normal.z()},
                                    lengths_at(i));
      m_positions[i] += settled.height * normal;
      m_normals[i] = Vector(settled.normal.x, settled.normal.y, settled.normal.z).cast<Local>();
      m_bends[i] = settled.bend;
    });
  }

  void keep_clear_of_creases()
  {
    internal::keep_clear_of_creases<ConcurrencyTag>(m_bends, m_lengths.spacing, m_minimum_cell_size,
                                                    m_progress, m_positions, m_normals);
  }

  /// Of the samples where they are now, by the fits of this round.
  void find_deviations()
  {
    m_deviations.resize(m_positions.size());
    const double radius = Ball_of_normals::maximum_radius(m_lengths);
    const Sorted_queries sorted(ConcurrencyTag(), m_positions,
                                Cell_sizes((std::max)(radius, m_minimum_cell_size), m_scales));
    internal::find_deviations<ConcurrencyTag>(
      sorted, m_normals, [&](std::size_t i) { return Variances_of_fit(m_means[i], lengths_at(i)); },
      [&](std::size_t i) { return Ball_of_normals(lengths_at(i)); },
      cells_in_reach(radius, sorted.grid.cell_size()), m_progress, m_deviations);
  }

  template <typename FT>
  void write_to(Samples<FT>& samples)
  {
    samples.noise_ratios.resize(m_noise_ratios.size());
    for_each_sample([&](std::size_t i) {
      samples.positions[m_order[i]] = m_positions[i];
      samples.normals[m_order[i]] = m_normals[i].template cast<FT>();
      if (!m_noise_ratios.empty())
        samples.noise_ratios[m_order[i]] = m_noise_ratios[i];
      if (!m_sheets.empty() && m_sheets[i] != 0)
        samples.sides[m_order[i]] = Side_after_refinement::OUTWARDS;
      if (!m_deviations.empty())
      {
        samples.position_deviations[m_order[i]] = m_deviations[i].position;
        samples.normal_deviations[m_order[i]] = m_deviations[i].normal;
      }
    });
  }

private:
  auto allocator() const { return m_positions.get_allocator(); }

  /// \param grid of the points, with cells as those of the samples
  void share_points(const Search_grid_3& grid, const Buffer<Vector>& points, double widening)
  {
    Buffer<Disk_kernel<Local>> kernels(m_positions.size(), allocator());
    for_each_sample(
      [&](std::size_t i) { kernels[i] = lengths_at(i).widened(widening).kernel_of_disk(); });
    m_disks = internal::share_points<ConcurrencyTag>(
      grid, points, {m_grid, m_positions, m_normals, kernels},
      cells_in_reach(m_lengths.widened(widening).reach_of_disk(), m_cell_size), m_progress);
    for_each_sample([&](std::size_t i) {
      m_heights[i] = m_disks[i].height;
      m_informations[i] = lengths_at(i).information(m_disks[i], m_lengths.noise_of_disk());
    });
  }

  void weigh(const Buffer<Surfaces_of_scale>& surfaces, double units)
  {
    internal::weigh_by_risk<ConcurrencyTag>(
      m_grid, m_positions, m_normals, m_references, surfaces,
      [&](std::size_t i) { return units * unit(i); },
      cells_in_reach(units * m_lengths.unit, m_cell_size), m_progress, m_means);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_REFINEMENT_H
