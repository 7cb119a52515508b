// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What does not depend on the caller's types, which the library `CGAL::L0_resampling_compiled`
// holds compiled. With it, programs compile their own part only: reading the range and writing the
// result.

#ifndef CGAL_L0_RESAMPLING_INTERNAL_COMPILED_TEMPLATES_H
#define CGAL_L0_RESAMPLING_INTERNAL_COMPILED_TEMPLATES_H

#include <CGAL/L0_resampling/internal/driver/orient_point_set.h>
#include <CGAL/L0_resampling/internal/driver/resample.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile.h>

#include <CGAL/tags.h>

#include <array>
#include <functional>
#include <vector>

/// The instantiations for a concurrency tag and a number type, of the solver and of the caller's
/// kernel. `declaration` is `template`, or `extern template`.
#define CGAL_L0_COMPILED_TEMPLATES(declaration, Tag, FT)                                           \
  declaration Oriented_points<FT> resample<Tag, FT>(Buffer<Vector>&, Buffer<Local_vector>&,        \
                                                    Buffer<Local_vector>&, const Parameters&,      \
                                                    Any_solver<FT>&, Progress&, Report&,           \
                                                    Facts_of_cloud&);                              \
  declaration Buffer<std::array<FT, 3>> rounded_positions<Tag, FT>(const Buffer<Vector>&,          \
                                                                   const Input&, double, bool);    \
  declaration void nearest_input_points<Tag, FT>(                                                  \
    const Point_tree_3&, const Buffer<std::array<FT, 3>>&, Progress&, Near_points&);

/// Those for a concurrency tag alone.
#define CGAL_L0_COMPILED_TEMPLATES_OF_TAG(declaration, Tag)                                        \
  declaration Oriented_representatives orient_point_set<Tag>(                                      \
    Buffer<Vector>&, Buffer<Local_vector>&, Buffer<Local_vector>&, const Parameters&, Progress&,   \
    Report&);                                                                                      \
  declaration Scales scales_of_regions<Tag>(                                                       \
    Buffer<Vector>&, const std::function<bool(const Vector&)>&, const Facts_of_cloud&, Progress&); \
  declaration Facts_of_cloud facts_of_points<Tag, float>(Buffer<Vector>&, const Parameters&,       \
                                                         Any_solver<float>&, Progress&, Report&,   \
                                                         std::vector<Point_in_cloud>&);            \
  declaration Share_of_tile share_of_tile<Tag, float>(Buffer<Vector>&, const Facts_of_cloud&,      \
                                                      const Parameters&, const Room_of_tile&,      \
                                                      Any_solver<float>&, Progress&, Report&);     \
  declaration std::vector<Point_in_cloud> points_of_tile<Tag, float>(                              \
    Buffer<Vector>&, const Facts_of_cloud&, const Parameters&, const Room_of_tile&,                \
    const Starts_of_runs&, Any_solver<float>&, Progress&, Report&);                                \
  declaration Samples_of_tile<float> resample_tile<Tag, float>(                                    \
    Buffer<Vector>&, const std::vector<Point_in_cloud>&, const Facts_of_cloud&, const Parameters&, \
    Any_solver<float>&, Progress&, Report&);

#ifdef CGAL_L0_LINKED_WITH_COMPILED

namespace CGAL {
namespace L0_resampling {
namespace internal {

CGAL_L0_COMPILED_TEMPLATES(extern template, Sequential_tag, float)
CGAL_L0_COMPILED_TEMPLATES(extern template, Sequential_tag, double)
CGAL_L0_COMPILED_TEMPLATES_OF_TAG(extern template, Sequential_tag)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_L0_COMPILED_TEMPLATES(extern template, Parallel_tag, float)
CGAL_L0_COMPILED_TEMPLATES(extern template, Parallel_tag, double)
CGAL_L0_COMPILED_TEMPLATES_OF_TAG(extern template, Parallel_tag)
#endif

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_LINKED_WITH_COMPILED

#endif // CGAL_L0_RESAMPLING_INTERNAL_COMPILED_TEMPLATES_H
