// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_DICTIONARY_OF_H
#define CGAL_L0_PYTHON_DICTIONARY_OF_H

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/warnings.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace l0_python {

/// By the names of the C++ members.
inline pybind11::dict dictionary_of(const CGAL::L0_resampling::Report& report)
{
  namespace py = pybind11;
  using namespace py::literals;
  py::list iterations, stages;
  for (const CGAL::L0_resampling::Iteration_report& i : report.iterations)
    iterations.append(py::dict(
      "penalty"_a = i.penalty, "regularized"_a = i.regularized, "fit_energy"_a = i.fit_energy,
      "regularization_energy"_a = i.regularization_energy, "normal_energy"_a = i.normal_energy,
      "sparsity_energy"_a = i.sparsity_energy, "active_pair_share"_a = i.active_pair_share,
      "solver"_a = py::dict("iterations"_a = i.solver.iterations,
                            "relative_residual"_a = i.solver.relative_residual,
                            "converged"_a = i.solver.converged)));
  for (const CGAL::L0_resampling::Stage_report& s : report.stages)
    stages.append(
      py::dict("name"_a = s.name, "seconds"_a = s.seconds, "peak_bytes"_a = s.peak_bytes));
  py::list warnings;
  for (const CGAL::L0_resampling::Warning warning : CGAL::L0_resampling::warnings(report))
    warnings.append(CGAL::L0_resampling::message_of(warning, report));
  return py::dict(
    "number_of_input_points"_a = report.number_of_input_points,
    "number_of_dropped_points"_a = report.number_of_dropped_points,
    "number_of_outliers"_a = report.number_of_outliers,
    "number_of_distinct_points"_a = report.number_of_distinct_points,
    "number_of_output_points"_a = report.number_of_output_points,
    "number_of_degenerate_neighborhoods"_a = report.number_of_degenerate_neighborhoods,
    "number_of_lonely_samples"_a = report.number_of_lonely_samples,
    "number_of_unexplained_samples"_a = report.number_of_unexplained_samples,
    "unexplained_center"_a = report.unexplained_center,
    "unexplained_radius"_a = report.unexplained_radius,
    "number_of_unexplained_samples_there"_a = report.number_of_unexplained_samples_there,
    "number_of_self_neighbor_pairs"_a = report.number_of_self_neighbor_pairs,
    "neighbor_radius"_a = report.neighbor_radius,
    "least_neighbor_radius"_a = report.least_neighbor_radius,
    "median_neighbor_radius"_a = report.median_neighbor_radius,
    "largest_neighbor_radius"_a = report.largest_neighbor_radius,
    "normal_filter_radius"_a = report.normal_filter_radius,
    "estimated_spacing"_a = report.estimated_spacing, "estimated_noise"_a = report.estimated_noise,
    "sample_spacing"_a = report.sample_spacing, "oriented_share"_a = report.oriented_share,
    "right_side_share"_a = report.right_side_share, "hinted_share"_a = report.hinted_share,
    "extent_share"_a = report.extent_share, "warnings"_a = warnings, "iterations"_a = iterations,
    "converged"_a = report.converged, "stages"_a = stages, "peak_bytes"_a = report.peak_bytes,
    "device"_a = report.device, "device_reason"_a = report.device_reason);
}

} // namespace l0_python

#endif // CGAL_L0_PYTHON_DICTIONARY_OF_H
