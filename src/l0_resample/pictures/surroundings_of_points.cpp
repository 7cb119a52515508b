// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/surroundings_of_points.h"

#include "basis/Sample_of_surface.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace l0_tool {
namespace {

Vector unit_or_zero(const Vector& v)
{
  const double length = std::sqrt(v.squared_length());
  return length > 0 && std::isfinite(length) ? v / length : CGAL::NULL_VECTOR;
}

/// Whether there is a sharp edge that stands out between two oriented points. Where normals are
/// about opposite, one of them is rather wrong.
bool are_across_convex_edge(const Point& p, const Vector& normal_of_p, const Point& q,
                            const Vector& normal_of_q)
{
  const double cosine = normal_of_p * normal_of_q;
  return cosine < 0.87 && cosine > -0.71 // 30 and 135 degrees
         && (q - p) * (normal_of_q - normal_of_p) > 0;
}

/// Adds the nearest point across an edge, and the nearest one across an edge from both.
void find_points_across_edges(std::size_t i, const std::vector<Point>& points,
                              const Sample_of_surface& sample,
                              const Sample_of_surface::Search& nearest,
                              std::vector<Surroundings>& result)
{
  auto& found = result[i].across_edges;
  std::size_t count = 0;
  for (const auto& [sample_index, squared_distance] : nearest) {
    const std::size_t j = sample.index_in_cloud(sample_index);
    const auto is_across = [&](std::size_t k) {
      return are_across_convex_edge(points[k], result[k].normal, points[j], result[j].normal);
    };
    if (is_across(i) && (count == 0 || is_across(*found[0])))
      found[count++] = j;
    if (count == found.size())
      return;
  }
}

template <typename F>
void for_each(std::size_t n, const F& f)
{
  constexpr std::size_t block_size = 1024;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, block_size),
                    [&](const tbb::blocked_range<std::size_t>& block) {
                      for (std::size_t i = block.begin(); i < block.end(); ++i)
                        f(i);
                    });
}

} // namespace

std::vector<Surroundings> surroundings_of_points(const std::vector<Point>& points,
                                                 const std::vector<Vector>& normals)
{
  constexpr std::size_t number_of_nearest = 16;
  std::vector<Surroundings> result(points.size());
  for (std::size_t i = 0; i < normals.size(); ++i)
    result[i].normal = unit_or_zero(normals[i]);
  if (points.size() < 2)
    return result;

  const Sample_of_surface sample(points.size(),
                                 [&](std::size_t i) -> const Point& { return points[i]; });
  std::vector<double> spacings(points.size());
  for_each(sample.points().size(), [&](std::size_t sample_index) {
    const std::size_t i = sample.index_in_cloud(sample_index);
    const Sample_of_surface::Search nearest = sample.nearest(points[i], number_of_nearest);
    spacings[i] = sample.spacing(nearest);
    if (normals.empty())
      result[i].normal = sample.normal_of_plane(nearest);
    else
      find_points_across_edges(i, points, sample, nearest, result);
  });
  for_each(points.size(), [&](std::size_t i) {
    if (sample.has(i))
      return;
    const std::size_t j = sample.index_in_cloud(sample.nearest(points[i], 1).begin()->first);
    spacings[i] = spacings[j];
    result[i].across_edges = result[j].across_edges;
    if (normals.empty())
      result[i].normal = result[j].normal;
  });

  const double usual = median(spacings);
  for (std::size_t i = 0; i < points.size(); ++i)
    result[i].spacing = (std::clamp)(spacings[i], usual / 2, 2 * usual);
  return result;
}

} // namespace l0_tool
