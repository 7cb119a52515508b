// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Never linked nor run: all public headers, and the function for every tag, solver, and kind of
// range that it knows, for compilers to look at.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>
#include <CGAL/L0_resampling/CUDA_least_squares_solver_traits.h>
#include <CGAL/L0_resampling/CUDA_resampler.h>
#include <CGAL/L0_resampling/Crease.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>
#include <CGAL/L0_resampling/Quadratic_problem.h>
#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/Solver_report.h>
#include <CGAL/L0_resampling/Tile_archive.h>
#include <CGAL/L0_resampling/find_near_points.h>
#include <CGAL/L0_resampling/named_parameters.h>
#include <CGAL/L0_resampling/tags.h>
#include <CGAL/L0_resampling/warnings.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_estimate_scales.h>
#include <CGAL/l0_orient_normals.h>
#include <CGAL/l0_resample_point_set.h>
#include <CGAL/l0_resample_tiles.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

template <typename Kernel, typename ConcurrencyTag>
void resample()
{
  using Pair = std::pair<typename Kernel::Point_3, typename Kernel::Vector_3>;
  using namespace CGAL::L0_resampling;
  namespace parameters = CGAL::parameters;

  const std::vector<typename Kernel::Point_3> points;
  const std::vector<Pair> pairs;
  std::vector<Pair> result;
  CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result));
  CGAL::l0_resample_point_set<ConcurrencyTag>(
    pairs, std::back_inserter(result),
    parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
        .normal_map(CGAL::Second_of_pair_property_map<Pair>())
        .callback([](double) { return true; })
      | parameters::resampling_method(Method::LOR));
  if constexpr (!std::is_same_v<ConcurrencyTag, CGAL::CUDA_tag>) // which has its own solver
  {
    CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result),
                                                parameters::sparse_linear_solver(
                                                  Eigen_cholesky_solver_traits<>()));
    CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result),
                                                parameters::sparse_linear_solver(
                                                  Eigen_least_squares_solver_traits<>()));
    std::vector<std::size_t> sources;
    std::vector<double> confidences;
    CGAL::l0_resample_point_set<ConcurrencyTag>(
      points, std::back_inserter(result),
      parameters::source_index_map(CGAL::make_property_map(sources))
        .viewpoint(typename Kernel::Point_3(0, 0, 1))
        .feature_confidence_map(CGAL::make_property_map(confidences))
        .side_confidence_map(CGAL::make_property_map(confidences))
        .neighbor_radius_map(CGAL::make_property_map(confidences))
        .noise_map(CGAL::make_property_map(confidences))
        .position_deviation_map(CGAL::make_property_map(confidences))
        .normal_deviation_map(CGAL::make_property_map(confidences))
        .keep_density(true)
        .noise(0.1)
        .outlier_sensitivity(2));
    CGAL::l0_resample_point_set<ConcurrencyTag>(
      points, std::back_inserter(result),
      parameters::point_noise_map(
        CGAL::Constant_property_map<typename Kernel::Point_3, double>(0.1)));
    std::vector<Crease<Kernel>> creases;
    std::vector<Crease_corner<Kernel>> corners;
    CGAL::l0_resample_point_set<ConcurrencyTag>(
      points, std::back_inserter(result),
      parameters::crease_output_iterator(std::back_inserter(creases))
        .corner_output_iterator(std::back_inserter(corners)));
    CGAL::l0_estimate_scales<ConcurrencyTag>(points);
    find_near_points<ConcurrencyTag>(points, points, 3);
    std::vector<std::size_t> outliers;
    CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result),
                                                parameters::outlier_output_iterator(
                                                  std::back_inserter(outliers)));
    CGAL::l0_resample_point_set<ConcurrencyTag>(
      points, std::back_inserter(result),
      parameters::viewpoint_map(CGAL::Identity_property_map<typename Kernel::Point_3>()));
    CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result),
                                                parameters::up_direction(
                                                  typename Kernel::Vector_3(0, 0, 1)));
  }

  CGAL::Point_set_3<typename Kernel::Point_3> point_set, resampled;
  CGAL::l0_resample_point_set<ConcurrencyTag>(point_set, resampled);
  CGAL::l0_orient_normals<ConcurrencyTag>(resampled);
  CGAL::l0_orient_normals<ConcurrencyTag>(
    result, parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
                .normal_map(CGAL::Second_of_pair_property_map<Pair>())
              | parameters::viewpoint(typename Kernel::Point_3(0, 0, 1)));
}

// Models of the concepts of tiles
struct One_point
{
  template <typename F>
  void for_each_point(const CGAL::L0_resampling::Source_box& /*box*/, const F& f) const
  {
    f(std::array<double, 3>());
  }
};

struct One_result
{
  CGAL::L0_resampling::Tile_result result;

  void put(std::size_t /*tile*/, CGAL::L0_resampling::Tile_result r) { result = std::move(r); }
  const CGAL::L0_resampling::Tile_result& get(std::size_t /*tile*/) const { return result; }
  void finish(std::size_t /*tile*/, const std::vector<CGAL::L0_resampling::Tile_sample>& samples)
  {
    result.samples = samples;
  }
};

template <typename ConcurrencyTag>
void resample_tiles()
{
  using Kernel = CGAL::Simple_cartesian<double>;

  One_result sink;
  std::vector<CGAL::L0_resampling::Crease<Kernel>> creases;
  CGAL::L0_resampling::Report report;
  CGAL::l0_resample_tiles<ConcurrencyTag>(One_point(), sink, 1 << 20,
                                          CGAL::parameters::crease_output_iterator(
                                            std::back_inserter(creases))
                                            .resampling_report(&report)
                                            .number_of_output_points(1));
}

} // namespace

int main()
{
  using Exact_predicates = CGAL::Exact_predicates_inexact_constructions_kernel;
  resample<Exact_predicates, CGAL::Sequential_tag>();
  resample<Exact_predicates, CGAL::Parallel_tag>();
  resample<Exact_predicates, CGAL::CUDA_tag>();
  resample<CGAL::Simple_cartesian<float>, CGAL::Sequential_tag>();
  resample_tiles<CGAL::Sequential_tag>();
  resample_tiles<CGAL::Parallel_tag>();
  resample_tiles<CGAL::CUDA_tag>();
}
