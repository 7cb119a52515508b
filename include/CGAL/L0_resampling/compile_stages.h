// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_COMPILE_STAGES_H
#define CGAL_L0_RESAMPLING_COMPILE_STAGES_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>
#include <CGAL/L0_resampling/instructions.h>
#include <CGAL/L0_resampling/internal/core/parallel_for.h>
#include <CGAL/L0_resampling/internal/creases/find_creases_impl.h>
#include <CGAL/L0_resampling/internal/driver/orient_point_set_impl.h>
#include <CGAL/L0_resampling/internal/driver/resample_impl.h>
#include <CGAL/L0_resampling/internal/interface/resample_on_cpu.h>
#include <CGAL/L0_resampling/internal/interface/rounded_positions.h>
#include <CGAL/L0_resampling/internal/search/nearest_input_points.h>
#include <CGAL/L0_resampling/internal/tiles/facts_of_tile_impl.h>
#include <CGAL/L0_resampling/internal/tiles/find_creases_of_tiles_impl.h>
#include <CGAL/L0_resampling/internal/tiles/orient_tiles_impl.h>
#include <CGAL/L0_resampling/internal/tiles/resample_tile_impl.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// Of a concurrency tag and a number type, of the solver and of the caller's kernel.
#define CGAL_L0_COMPILE_STAGES_OF(Tag, FT)                                                         \
  template class Block_chebyshev_solver_traits<FT, Tag>;                                           \
  template class Block_conjugate_gradient_solver_traits<FT, Tag>;                                  \
  namespace internal {                                                                             \
  template Oriented_points<FT> resample<Tag, FT>(Buffer<Vector>&, Buffer<Local_vector>&,           \
                                                 Buffer<Local_vector>&, const Parameters&,         \
                                                 Any_solver<FT>&, Progress&, Report&,              \
                                                 Facts_of_cloud&, Buffer<float>);                  \
  template Buffer<std::array<FT, 3>> rounded_positions<Tag, FT>(const Buffer<Vector>&,             \
                                                                const Input&, double, bool);       \
  template Placed_creases find_creases<Tag, FT>(double, Progress&, Buffer<Vector>&,                \
                                                Buffer<Eigen::Matrix<FT, 3, 1>>&);                 \
  template void nearest_input_points<Tag, FT>(const Point_tree_3&,                                 \
                                              const Buffer<std::array<FT, 3>>&, Progress&,         \
                                              Near_points&);                                       \
  template void resample_on_cpu<Tag, FT, float>(const Call_of_any_types&, Any_solver<float>&,      \
                                                const Result_function<FT, float>&);                \
  template void resample_on_cpu<Tag, FT, double>(const Call_of_any_types&, Any_solver<double>&,    \
                                                 const Result_function<FT, double>&);              \
  }

/*!
\ingroup PkgL0ResamplingRef

Compiles the stages of `CGAL::l0_resample_point_set()`, `CGAL::l0_orient_normals()` and
`CGAL::l0_resample_tiles()` for a concurrency tag, in the file where it stands: in one file of a
program, outside of all namespaces, for each tag that the program has calls with. All files of the
program define `CGAL_L0_LINKED_WITH_COMPILED`, and so do not compile the stages themselves. See
\ref secCompiled.

\param Tag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`
*/
#define CGAL_L0_COMPILE_STAGES_FOR(Tag)                                                            \
  namespace CGAL {                                                                                 \
  namespace L0_resampling {                                                                        \
  CGAL_L0_COMPILE_STAGES_OF(Tag, float)                                                            \
  CGAL_L0_COMPILE_STAGES_OF(Tag, double)                                                           \
  namespace internal {                                                                             \
  template void report_plan<Tag>(Buffer<Vector>&, const Parameters&, Progress&, Report&,           \
                                 Buffer<float>);                                                   \
  template Oriented_representatives orient_point_set<Tag>(Buffer<Vector>&, Buffer<Local_vector>&,  \
                                                          Buffer<Local_vector>&,                   \
                                                          const Parameters&, Progress&, Report&);  \
  template Places_of_tile count_places<Tag>(Buffer<Vector>&, const Own_blocks&,                    \
                                            const Facts_of_cloud&);                                \
  template std::vector<Ball_sample> look_at_balls<Tag>(Buffer<Vector>&, const Own_blocks&,         \
                                                       const Facts_of_cloud&,                      \
                                                       const Ranks_of_runs&, std::size_t,          \
                                                       Progress&);                                 \
  template std::vector<Placed_seed> look_at_seeds<Tag>(Buffer<Vector>&, const Own_blocks&,         \
                                                       const Facts_of_cloud&,                      \
                                                       const Ranks_of_runs&, Progress&);           \
  template std::vector<Placed_seed> seeds_of_outermost<Tag>(const std::vector<std::uint64_t>&,     \
                                                            const Facts_of_cloud&,                 \
                                                            const Ranks_of_runs&, Progress&);      \
  template Neighbors_of_tile find_neighbors_of_tile<Tag>(Buffer<Vector>&, const Facts_of_cloud&,   \
                                                         const Parameters&, const Own_blocks&,     \
                                                         Progress&, Report&);                      \
  template Facts_of_cloud facts_of_points<Tag, float>(Buffer<Vector>&, const Parameters&,          \
                                                      Any_solver<float>&, Progress&, Report&,      \
                                                      Buffer<Point_in_cloud>&);                    \
  template Points_of_tile find_points_of_tile<Tag, float>(Buffer<Vector>&, Buffer<float>,          \
                                                          const Facts_of_cloud&,                   \
                                                          const Parameters&, const Own_blocks&,    \
                                                          Any_solver<float>&, Progress&, Report&); \
  template Samples_of_tile<float> resample_tile<Tag, float>(Buffer<Vector>&,                       \
                                                            const Buffer<Point_in_cloud>&,         \
                                                            const Facts_of_cloud&, bool,           \
                                                            const Parameters&, Any_solver<float>&, \
                                                            Progress&, Report&);                   \
  template void orient_tiles<Tag>(const Facts_of_cloud&, const Plan&, const Parameters&,           \
                                  Progress&, Samples_to_orient&);                                  \
  template Creases_of_tiles find_creases_of_tiles<Tag>(std::size_t, double,                        \
                                                       const Samples_of_tiles&, Progress&,         \
                                                       Memory_counter&);                           \
  }                                                                                                \
  }                                                                                                \
  }

#if defined(CGAL_L0_LINKED_WITH_COMPILED) || defined(DOXYGEN_RUNNING)
/*!
\ingroup PkgL0ResamplingRef

Compiles what has no concurrency tag: once in a program that has `CGAL_L0_COMPILE_STAGES_FOR()`.
*/
#define CGAL_L0_COMPILE_STAGES()                                                                   \
  namespace CGAL {                                                                                 \
  namespace L0_resampling {                                                                        \
  template class Eigen_cholesky_solver_traits<double>;                                             \
  template class Eigen_least_squares_solver_traits<double>;                                        \
  std::string instructions_of_stages() { return internal::instructions_of_compiler(); }            \
  namespace internal {                                                                             \
  template Loop_watcher*& loop_watcher<void>();                                                    \
  }                                                                                                \
  }                                                                                                \
  }
#else
#define CGAL_L0_COMPILE_STAGES()                                                                   \
  static_assert(false, "Define CGAL_L0_LINKED_WITH_COMPILED for all files of the program.");
#endif

#endif // CGAL_L0_RESAMPLING_COMPILE_STAGES_H
