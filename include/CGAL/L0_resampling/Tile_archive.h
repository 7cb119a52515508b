// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_TILE_ARCHIVE_H
#define CGAL_L0_RESAMPLING_TILE_ARCHIVE_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Is_plain.h>
#include <CGAL/L0_resampling/Tile_findings.h>
#include <CGAL/L0_resampling/Tile_stitching.h>
#include <CGAL/L0_resampling/internal/cloud/Facts_of_cloud.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>
#include <CGAL/L0_resampling/internal/tiles/Neighbors_of_tile.h>
#include <CGAL/L0_resampling/internal/tiles/Points_of_tile.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \cond SKIP_IN_MANUAL
template <>
struct Is_plain<Tile_sample>
  : std::bool_constant<is_made_of(&Tile_sample::position, &Tile_sample::normal, &Tile_sample::tree)>
{};
template <>
struct Is_plain<Tile_findings>
  : std::bool_constant<is_made_of(
      &Tile_findings::number_of_outliers, &Tile_findings::number_of_degenerate_neighborhoods,
      &Tile_findings::number_of_output_points, &Tile_findings::number_of_lonely_samples,
      &Tile_findings::number_of_unexplained_samples,
      &Tile_findings::number_of_unexplained_samples_there, &Tile_findings::unexplained_center)>
{};
template <>
struct Is_plain<Seam_report>
  : std::bool_constant<is_made_of(&Seam_report::number_of_samples, &Seam_report::number_of_matches,
                                  &Seam_report::number_of_opposed,
                                  &Seam_report::sum_of_squared_distances)>
{};
template <>
struct Is_plain<internal::Scales>
  : std::bool_constant<is_made_of(&internal::Scales::spacing, &internal::Scales::noise)>
{};
template <>
struct Is_plain<internal::Range_of_scales>
  : std::bool_constant<is_made_of(&internal::Range_of_scales::least,
                                  &internal::Range_of_scales::median,
                                  &internal::Range_of_scales::largest)>
{};
template <>
struct Is_plain<internal::Morton_cells>
  : std::bool_constant<is_made_of(&internal::Morton_cells::size)>
{};
template <>
struct Is_plain<internal::Scale_of_seed>
  : std::bool_constant<is_made_of(&internal::Scale_of_seed::scale, &internal::Scale_of_seed::reach,
                                  &internal::Scale_of_seed::within)>
{};
template <>
struct Is_plain<internal::Point_in_cloud>
  : std::bool_constant<is_made_of(
      &internal::Point_in_cloud::units, &internal::Point_in_cloud::index,
      &internal::Point_in_cloud::number_of_samples, &internal::Point_in_cloud::scale,
      &internal::Point_in_cloud::is_own)>
{};
template <>
struct Is_plain<internal::Disks_of_tile>
  : std::bool_constant<is_made_of(&internal::Disks_of_tile::units,
                                  &internal::Disks_of_tile::number_of_thinned_blocks,
                                  &internal::Disks_of_tile::keeps_outliers)>
{};
template <>
struct Is_plain<internal::Spread_in_ball>
  : std::bool_constant<is_made_of(&internal::Spread_in_ball::minors,
                                  &internal::Spread_in_ball::trace)>
{};
template <>
struct Is_plain<internal::Points_of_ball>
  : std::bool_constant<is_made_of(&internal::Points_of_ball::count,
                                  &internal::Points_of_ball::spread)>
{};
template <>
struct Is_plain<internal::Points_of_tile::Run>
  : std::bool_constant<is_made_of(&internal::Points_of_tile::Run::key,
                                  &internal::Points_of_tile::Run::end,
                                  &internal::Points_of_tile::Run::neighbors)>
{};
template <>
struct Is_plain<internal::Sums_over_points>
  : std::bool_constant<is_made_of(
      &internal::Sums_over_points::units, &internal::Sums_over_points::points,
      &internal::Sums_over_points::distinct, &internal::Sums_over_points::units_of_all,
      &internal::Sums_over_points::neighbors)>
{};
template <>
struct Is_plain<internal::Run_of_cells>
  : std::bool_constant<is_made_of(&internal::Run_of_cells::key, &internal::Run_of_cells::sums)>
{};
template <>
struct Is_plain<internal::Cloud_totals>
  : std::bool_constant<is_made_of(&internal::Cloud_totals::disks, &internal::Cloud_totals::sums,
                                  &internal::Cloud_totals::area)>
{};
template <>
struct Is_plain<internal::Histogram::Count>
  : std::bool_constant<is_made_of(&internal::Histogram::Count::number,
                                  &internal::Histogram::Count::count)>
{};
/// \endcond

namespace internal {

// What values consist of: `f` is called with each part, in one order for writing and for reading.

template <typename F>
void visit_parts(Vector& v, const F& f)
{
  for (int axis = 0; axis < 3; ++axis)
    f(v[axis]);
}

template <typename F>
void visit_parts(Place_of_frame& place, const F& f)
{
  f(place.exponent);
  f(place.origin);
}

template <typename F>
void visit_parts(Facts& extents, const F& f)
{
  f(extents.number_of_points);
  f(extents.box_diagonal);
  f(extents.robust_diagonal);
  f(extents.exponent_of_input);
  f(extents.scales);
}

template <typename F>
void visit_parts(Facts_of_cloud& facts, const F& f)
{
  f(facts.frame);
  f(facts.extents);
  f(facts.scales);
  f(facts.range_of_scales);
  f(facts.median_number_of_neighbors);
  f(facts.mean_number_of_neighbors);
  f(facts.has_plain_blocks);
  f(facts.units_of_disks);
  f(facts.area);
  f(facts.units_of_starts);
  f(facts.number_of_points);
  f(facts.number_of_places);
  f(facts.field);
}

template <typename F>
void visit_parts(Neighbor_counts& counts, const F& f)
{
  f(counts.minimum_scale);
  f(counts.maximum_scale);
  f(counts.scales);
  f(counts.neighbors);
}

template <typename F>
void visit_parts(Neighbors_of_tile& found, const F& f)
{
  f(found.scales);
  f(found.counts);
}

template <typename F>
void visit_parts(Medians_of_cloud& medians, const F& f)
{
  f(medians.scales);
  f(medians.number_of_neighbors);
}

template <typename F>
void visit_parts(Points_of_tile& points, const F& f)
{
  f(points.disks);
  f(points.points);
  f(points.order);
  f(points.are_distinct);
  f(points.are_first);
  f(points.balls);
  f(points.runs);
}

template <typename F>
void visit_parts(Share_of_tile& share, const F& f)
{
  f(share.area_per_unit);
  f(share.runs);
}

template <typename F>
void visit_parts(Unoriented_samples& samples, const F& f)
{
  f(samples.own);
  f(samples.leaders_elsewhere);
}

/// Writes the parts that it is called with.
template <typename Archive>
class Part_writer
{
  Archive& m_archive;

public:
  explicit Part_writer(Archive& archive) : m_archive(archive) {}

  template <typename T>
  void operator()(const T& value) const
  {
    if constexpr (Is_plain<T>::value || std::is_same<T, bool>::value)
      m_archive.write(value);
    else
      visit_parts(const_cast<T&>(value), *this); // which changes nothing
  }
  template <typename T>
  void operator()(const std::optional<T>& value) const
  {
    (*this)(value.has_value());
    if (value)
      (*this)(*value);
  }
  template <typename T, typename Allocator>
  void operator()(const std::vector<T, Allocator>& values) const
  {
    m_archive.write_all(values);
  }
  void operator()(const Histogram& histogram) const { (*this)(histogram.sorted_counts()); }
  void operator()(const std::shared_ptr<const Scale_field>& field) const
  {
    (*this)(field != nullptr);
    if (!field)
      return;
    (*this)(field->seeds.cells());
    (*this)(field->radius);
    (*this)(field->seeds.codes());
    (*this)(field->scales);
  }
};

/// Reads them.
template <typename Archive>
class Part_reader
{
  Archive& m_archive;

  template <typename T>
  T read() const
  {
    T value{};
    (*this)(value);
    return value;
  }

public:
  explicit Part_reader(Archive& archive) : m_archive(archive) {}

  template <typename T>
  void operator()(T& value) const
  {
    if constexpr (Is_plain<T>::value || std::is_same<T, bool>::value)
      value = m_archive.template read<T>();
    else
      visit_parts(value, *this);
  }
  template <typename T>
  void operator()(std::optional<T>& value) const
  {
    value.reset();
    if (read<bool>())
      value = read<T>();
  }
  template <typename T, typename Allocator>
  void operator()(std::vector<T, Allocator>& values) const
  {
    m_archive.read_all(values);
  }
  void operator()(Histogram& histogram) const
  {
    histogram = Histogram();
    for (const auto& [number, count] : read<std::vector<Histogram::Count>>())
      histogram.add(number, count);
  }
  void operator()(std::shared_ptr<const Scale_field>& field) const
  {
    field = nullptr;
    if (!read<bool>())
      return;
    const auto cells = read<Morton_cells>();
    const auto radius = read<double>();
    auto codes = read<Buffer<std::uint64_t>>();
    auto scales = read<Buffer<Scale_of_seed>>();
    field = std::make_shared<const Scale_field>(
      Scale_field{Morton_places(cells, std::move(codes)), radius, std::move(scales)});
  }
};

} // namespace internal

/// \ingroup PkgL0ResamplingRef
/// Writes a value that a step of `Tiled_resampling` has given.
/// \param archive what is written of a model of `L0ResamplingTileArchive`
/// \param value of a type that the class names, or a `Unoriented_samples`
template <typename Archive, typename Value>
void write_tile_value(Archive& archive, const Value& value)
{
  internal::Part_writer<Archive> write(archive);
  write(value);
}

/// \ingroup PkgL0ResamplingRef
/// Reads what `write_tile_value()` has written.
/// \param archive what is read of a model of `L0ResamplingTileArchive`
template <typename Value, typename Archive>
Value read_tile_value(Archive& archive)
{
  Value value{};
  internal::Part_reader<Archive> read(archive);
  read(value);
  return value;
}

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_TILE_ARCHIVE_H
