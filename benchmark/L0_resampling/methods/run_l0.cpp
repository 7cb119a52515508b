// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// CGAL::l0_resample_point_set(), with its report.

#include "method_program.h"

#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>
#include <CGAL/l0_resample_point_set.h>

#ifdef CGAL_L0_LINKED_WITH_CUDA
#include <CGAL/L0_resampling/CUDA_least_squares_solver_traits.h>
#endif

#include <iterator>
#include <map>

namespace {

using namespace L0_benchmark;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;

#ifdef CGAL_L0_LINKED_WITH_CUDA
const std::vector<std::string> solver_names = {"block", "cholesky", "rows", "cuda_rows"};
#else
const std::vector<std::string> solver_names = {"block", "cholesky", "rows"};
#endif

const std::map<std::string, Method> methods = {
  {"default", Method::DEFAULT}, {"lor", Method::LOR}, {"alor", Method::ALOR}};

/// Resamples with the solver that the command line names; "block" is the function's own default.
template <typename ConcurrencyTag>
void resample(const std::vector<Point>& points, std::size_t number_of_output_points, Method method,
              const std::string& solver, double normal_weight, Report& report,
              Oriented_points& result)
{
  namespace solvers = CGAL::L0_resampling;
  const auto out = std::back_inserter(result);
  const auto parameters = CGAL::parameters::number_of_output_points(number_of_output_points)
                          | CGAL::parameters::resampling_method(method)
                          | CGAL::parameters::normal_weight(normal_weight)
                          | CGAL::parameters::resampling_report(&report);
  if (solver == "block")
    CGAL::l0_resample_point_set<ConcurrencyTag>(points, out, parameters);
  else if (solver == "cholesky")
    CGAL::l0_resample_point_set<ConcurrencyTag>(points, out,
                                                parameters.sparse_linear_solver(
                                                  solvers::Eigen_cholesky_solver_traits<double>()));
#ifdef CGAL_L0_LINKED_WITH_CUDA
  else if (solver == "cuda_rows")
    CGAL::l0_resample_point_set<ConcurrencyTag>(
      points, out,
      parameters.sparse_linear_solver(solvers::CUDA_least_squares_solver_traits<double>()));
#endif
  else
    CGAL::l0_resample_point_set<ConcurrencyTag>(
      points, out,
      parameters.sparse_linear_solver(solvers::Eigen_least_squares_solver_traits<double>()));
}

Json to_json(const Report& report)
{
  std::size_t solver_iterations = 0;
  for (const CGAL::L0_resampling::Iteration_report& iteration : report.iterations)
    solver_iterations += iteration.solver.iterations;

  Json stages = Json::array();
  for (const CGAL::L0_resampling::Stage_report& stage : report.stages)
    stages.push_back(
      {{"name", stage.name}, {"seconds", stage.seconds}, {"peak_bytes", stage.peak_bytes}});

  return {{"peak_bytes", report.peak_bytes},
          {"neighbor_radius", report.neighbor_radius},
          {"estimated_noise", report.estimated_noise},
          {"number_of_outliers", report.number_of_outliers},
          {"number_of_unexplained_samples", report.number_of_unexplained_samples},
          {"number_of_self_neighbor_pairs", report.number_of_self_neighbor_pairs},
          {"outer_iterations", report.iterations.size()},
          {"solver_iterations", solver_iterations},
          {"converged", report.converged},
          {"oriented_share", report.oriented_share},
          {"stages", stages}};
}

} // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  std::string method = "default", solver = "block";
  double normal_weight = 0.9; // the function's own default
  CLI::App& app = command_line("CGAL::l0_resample_point_set()");
  arguments.add_to(app);
  app.add_option("--method", method)->check(CLI::IsMember(methods));
  app
    .add_option("--solver", solver,
                "block: the default, on 3x3 blocks; cholesky: of the normal equations; "
                "rows: least-squares conjugate gradients on the paper's rows; cuda_rows: the same "
                "on a CUDA device, "
                "where built with CUDA")
    ->check(CLI::IsMember(solver_names));
  app.add_option("--normal-weight", normal_weight, "lambda")->check(CLI::NonNegativeNumber);

  return run_program(app, argc, argv, [&] {
    const std::vector<Point> points = read_positions(arguments.input);

    Report report;
    Oriented_points result(arguments.number_of_output_points);
    result.clear();
    if (solver == "cuda_rows") // the first call starts the device
    {
      resample<CGAL::Parallel_tag>(points, arguments.number_of_output_points, methods.at(method),
                                   solver, normal_weight, report, result);
      result.clear();
    }
    Measurement measurement;
    with_concurrency_tag(arguments.number_of_threads, [&](auto tag) {
      measurement.phase("l0_resample", [&] {
        resample<decltype(tag)>(points, arguments.number_of_output_points, methods.at(method),
                                solver, normal_weight, report, result);
      });
    });
    Json measured = measurement.result();
    measured["report"] = to_json(report);

    write_oriented_points(arguments.output, result);
    print_result("run_l0", arguments, points.size(), result.size(),
                 {{"method", method}, {"solver", solver}, {"normal_weight", normal_weight}},
                 measured);
  });
}
