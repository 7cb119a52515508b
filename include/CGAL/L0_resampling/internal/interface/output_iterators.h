// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_OUTPUT_ITERATORS_H
#define CGAL_L0_RESAMPLING_INTERNAL_OUTPUT_ITERATORS_H

#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/L0_resampling/internal/core/Buffer.h>
#include <CGAL/L0_resampling/internal/creases/Placed_creases.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Whether `*out++ = value` is possible, for an `out` of the first type.
template <typename OutputIterator, typename Value, typename = void>
struct Takes : std::false_type
{};
template <typename OutputIterator, typename Value>
struct Takes<OutputIterator, Value, std::void_t<decltype(*std::declval<OutputIterator&>()++)>>
  : std::is_assignable<decltype(*std::declval<OutputIterator&>()++), Value>
{};
/// Boost's iterator says that it takes everything, so its function is asked.
template <typename Function, typename Value>
struct Takes<boost::iterators::function_output_iterator<Function>, Value>
  : std::is_invocable<Function&, Value>
{};

/// Whether the iterator takes pairs of a position and a normal, as that of
/// `edge_aware_upsample_point_set()` does.
template <typename Kernel, typename OutputIterator>
constexpr bool takes_pairs =
  Takes<OutputIterator, std::pair<typename Kernel::Point_3, typename Kernel::Vector_3>>::value;

/// Whether the iterator takes positions, as that of `wlop_simplify_and_regularize_point_set()`
/// does.
template <typename Kernel, typename OutputIterator>
constexpr bool takes_points = Takes<OutputIterator, typename Kernel::Point_3>::value;

/// Writes a result: pairs, or their positions to an iterator that does not take pairs.
/// \param pair_of called with the place of a point in the result
/// \param out ends behind the last one written
/// Of each crease and corner of a result.
template <typename Kernel, typename NamedParameters>
void write_creases(const NamedParameters& np, const Placed_creases& found)
{
  using Normal = typename Kernel::Vector_3;
  using FT = typename Kernel::FT;
  const auto normal_of = [](const Vector& v) { return Normal(FT(v.x()), FT(v.y()), FT(v.z())); };
  if_given(np, internal_np::crease_output_iterator, [&](auto out) {
    constexpr bool takes_creases = Takes<decltype(out), Crease<Kernel>>::value;
    static_assert(takes_creases, "crease_output_iterator has to take "
                                 "CGAL::L0_resampling::Crease<Kernel>, of the kernel of the "
                                 "points.");
    if constexpr (takes_creases)
      for (const Placed_crease& placed : found.creases)
      {
        Crease<Kernel> crease;
        crease.points.assign(placed.samples.begin(), placed.samples.end());
        for (const Crease_vertex& vertex : placed.vertices)
        {
          crease.tangents.push_back(normal_of(vertex.tangent));
          crease.normals.push_back({normal_of(vertex.normals[0]), normal_of(vertex.normals[1])});
          crease.angles.push_back(vertex.angle * 180 / double(EIGEN_PI));
        }
        crease.is_closed = placed.is_closed;
        crease.is_convex = placed.is_convex;
        crease.confidence = placed.confidence;
        *out++ = crease;
      }
  });
  if_given(np, internal_np::corner_output_iterator, [&](auto out) {
    constexpr bool takes_corners = Takes<decltype(out), Crease_corner<Kernel>>::value;
    static_assert(takes_corners, "corner_output_iterator has to take "
                                 "CGAL::L0_resampling::Crease_corner<Kernel>, of the kernel of "
                                 "the points.");
    if constexpr (takes_corners)
      for (const Placed_corner& placed : found.corners)
      {
        Crease_corner<Kernel> corner;
        corner.point = placed.sample;
        for (const Vector& normal : placed.normals)
          corner.normals.push_back(normal_of(normal));
        *out++ = corner;
      }
  });
}

/// Writes which points of the range are outliers, if the caller asks for them.
template <typename NamedParameters>
void write_outliers(const NamedParameters& np, const Buffer<Index>& outliers)
{
  if_given(np, internal_np::outlier_output_iterator, [&](auto out) {
    constexpr bool takes_indices = Takes<decltype(out), std::size_t>::value;
    static_assert(takes_indices, "outlier_output_iterator has to take std::size_t, the places of "
                                 "the outliers in the range.");
    if constexpr (takes_indices)
      for (const Index outlier : outliers)
        *out++ = std::size_t(outlier);
  });
}

template <typename Kernel, typename OutputIterator, typename PairOf>
void write_result(std::size_t size, const PairOf& pair_of, OutputIterator& out)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    if constexpr (takes_pairs<Kernel, OutputIterator>)
      *out++ = pair_of(i);
    else
      *out++ = pair_of(i).first;
  }
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_OUTPUT_ITERATORS_H
