// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_MERGE_DISKS_H
#define CGAL_L0_RESAMPLING_INTERNAL_MERGE_DISKS_H

#include <CGAL/L0_resampling/internal/core/parallel_sort.h>
#include <CGAL/L0_resampling/internal/kernels/merged_disk.h>
#include <CGAL/L0_resampling/internal/search/Search_grid_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// The disks that surfaces are fitted to, sorted for a grid.
struct Fitted_disks
{
  const Buffer<Vector>& positions;
  const Buffer<Local_vector>& normals;
  const Buffer<float>& heights;      ///< of the points over the disk
  const Buffer<float>& informations; ///< how many points it stands for, of the noise of the cloud
  const Buffer<float>& scales;       ///< none if all are 1
};

/// Owns such disks.
struct Merged_disks
{
  Buffer<Vector> positions;
  Buffer<Local_vector> normals;
  Buffer<float> heights, informations, scales;

  explicit Merged_disks(const Counting_allocator<Vector>& allocator)
    : positions(allocator), normals(allocator), heights(allocator), informations(allocator),
      scales(allocator)
  {}

  Fitted_disks view() const { return {positions, normals, heights, informations, scales}; }

  /// For a grid of such cells.
  template <typename ConcurrencyTag>
  void sort(double cell_size)
  {
    const Buffer<Index> order =
      Search_grid_3::sorted_order<ConcurrencyTag>(positions, Cell_sizes(cell_size, scales));
    apply_order<ConcurrencyTag>(order, positions);
    apply_order<ConcurrencyTag>(order, normals);
    apply_order<ConcurrencyTag>(order, heights);
    apply_order<ConcurrencyTag>(order, informations);
    if (!scales.empty())
      apply_order<ConcurrencyTag>(order, scales);
  }
};

/// Joins disks that share a cell and a face, so that large balls hold few of them: their means
/// weighted by their points. Moments of the first order are kept.
/// \param cell_size at scale 1
template <typename ConcurrencyTag>
Merged_disks merge_disks(const Fitted_disks& disks, double cell_size)
{
  const Cell_sizes sizes(cell_size, disks.scales);
  const Buffer<Index> order = Search_grid_3::sorted_order<ConcurrencyTag>(disks.positions, sizes);
  const Buffer<Vector> sorted = values_in_order<ConcurrencyTag>(order, disks.positions);
  const Buffer<float> scales = listed_scales(sizes.scales, order);
  const Search_grid_3 grid(ConcurrencyTag(), sorted, Cell_sizes(cell_size, scales));

  const auto allocator = disks.positions.get_allocator();
  Merged_disks merged(allocator);
  std::vector<Merged_disk> of_cell;
  std::vector<float> scales_of_cell;
  for (std::size_t cell = 0; cell < grid.number_of_cells(); ++cell)
  {
    of_cell.clear();
    scales_of_cell.clear();
    const Search_grid_3::Range members = grid.points_of_cell(cell);
    const double height_of_face = maximum_height_of_merged * grid.size_of_cell(cell);
    for (Index s = members.first; s < members.second; ++s)
    {
      const Index k = order[s];
      const auto triple = [](const auto& v) {
        return Triple{double(v[0]), double(v[1]), double(v[2])};
      };
      const Merged_disk disk(triple(disks.positions[k]), triple(disks.normals[k]), disks.heights[k],
                             disks.informations[k]);
      std::size_t m = 0;
      while (m < of_cell.size() && !of_cell[m].is_of_face(disk, height_of_face))
        ++m;
      if (m < of_cell.size())
        of_cell[m].add(disk);
      else
      {
        of_cell.push_back(disk);
        if (!scales.empty())
          scales_of_cell.push_back(scales[s]);
      }
    }
    for (const Merged_disk& disk : of_cell)
    {
      const Triple p = disk.position(), n = disk.normal();
      merged.positions.push_back({p.x, p.y, p.z});
      merged.normals.push_back(Vector(n.x, n.y, n.z).cast<Local>());
      merged.heights.push_back(float(disk.height()));
      merged.informations.push_back(float(disk.information));
    }
    merged.scales.insert(merged.scales.end(), scales_of_cell.begin(), scales_of_cell.end());
  }
  return merged;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_MERGE_DISKS_H
