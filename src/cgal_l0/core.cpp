// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The module cgal_l0._core. What users see is __init__.py.

#include "resample.h"
#include "run_beside_python.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace l0_python {
namespace {

namespace py = pybind11;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;

/// \throws std::invalid_argument unless the array has the shape (n, 3); __init__.py sees to its number type
Array_view view_of(const py::array& array, const char* name)
{
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw std::invalid_argument(std::string("l0_resample_point_set: ") + name + " has the shape "
                                + py::str(array.attr("shape")).cast<std::string>() + ", expected (n, 3)");
  Array_view view;
  view.data = static_cast<const char*>(array.data());
  view.row_stride = array.strides(0);
  view.column_stride = array.strides(1);
  view.size = std::size_t(array.shape(0));
  view.is_double = array.itemsize() == sizeof(double);
  return view;
}

/// An array of that many columns that takes the numbers over; of one dimension if there is one column.
template <typename T>
py::array_t<T> array_of(std::vector<T>&& numbers, py::ssize_t columns)
{
  auto owned = std::make_unique<std::vector<T>>(std::move(numbers));
  std::vector<T>* vector = owned.get();
  const py::capsule owner(vector, [](void* pointer) { delete static_cast<std::vector<T>*>(pointer); });
  static_cast<void>(owned.release()); // to the capsule
  std::vector<py::ssize_t> shape = {py::ssize_t(vector->size()) / columns};
  if (columns > 1)
    shape.push_back(columns);
  return py::array_t<T>(shape, vector->data(), owner);
}

/// By the names of the C++ members.
py::dict dictionary_of(const Report& report)
{
  using namespace py::literals;
  py::list iterations, stages;
  for (const CGAL::L0_resampling::Iteration_report& i : report.iterations)
    iterations.append(py::dict("penalty"_a = i.penalty, "regularized"_a = i.regularized, "fit_energy"_a = i.fit_energy,
                               "regularization_energy"_a = i.regularization_energy, "normal_energy"_a = i.normal_energy,
                               "sparsity_energy"_a = i.sparsity_energy, "active_pair_share"_a = i.active_pair_share,
                               "solver"_a = py::dict("iterations"_a = i.solver.iterations,
                                                     "relative_residual"_a = i.solver.relative_residual,
                                                     "converged"_a = i.solver.converged)));
  for (const CGAL::L0_resampling::Stage_report& s : report.stages)
    stages.append(py::dict("name"_a = s.name, "seconds"_a = s.seconds, "peak_bytes"_a = s.peak_bytes));
  return py::dict("number_of_input_points"_a = report.number_of_input_points,
                  "number_of_dropped_points"_a = report.number_of_dropped_points,
                  "number_of_outliers"_a = report.number_of_outliers,
                  "number_of_distinct_points"_a = report.number_of_distinct_points,
                  "number_of_output_points"_a = report.number_of_output_points,
                  "number_of_degenerate_neighborhoods"_a = report.number_of_degenerate_neighborhoods,
                  "number_of_lonely_samples"_a = report.number_of_lonely_samples,
                  "number_of_self_neighbor_pairs"_a = report.number_of_self_neighbor_pairs,
                  "neighbor_radius"_a = report.neighbor_radius, "normal_filter_radius"_a = report.normal_filter_radius,
                  "estimated_spacing"_a = report.estimated_spacing, "estimated_noise"_a = report.estimated_noise,
                  "oriented_share"_a = report.oriented_share, "hinted_share"_a = report.hinted_share,
                  "iterations"_a = iterations, "converged"_a = report.converged, "stages"_a = stages,
                  "peak_bytes"_a = report.peak_bytes, "device"_a = report.device,
                  "device_reason"_a = report.device_reason);
}

/// \returns positions, normals, source indices, feature confidences and the report; or None, if the callback cancelled. What is not
/// wanted is empty.
template <typename FT>
py::object resample_as(const Array_view& points, const Array_view* normals, const Array_view* orientation_hints,
                       const Parameters& parameters, const py::object& callback)
{
  Result<FT> result;
  const bool is_complete = run_beside_python(callback, [&](const std::function<bool(double)>& go_on) {
    result = resample<FT>(points, normals, orientation_hints, parameters, go_on);
  });
  if (!is_complete)
    return py::none();
  const py::dict report = dictionary_of(result.report);
  return py::make_tuple(array_of(std::move(result.positions), 3), array_of(std::move(result.normals), 3),
                        array_of(std::move(result.source_indices), 1),
                        array_of(std::move(result.feature_confidences), 1), report);
}

py::object resample_arrays(const py::array& points, const std::optional<py::array>& normals,
                           const std::optional<py::array>& orientation_hints, const Parameters& parameters,
                           const py::object& callback)
{
  const Array_view point_view = view_of(points, "points");
  std::optional<Array_view> normal_view, hint_view;
  if (normals)
    normal_view = view_of(*normals, "normals");
  if (orientation_hints)
    hint_view = view_of(*orientation_hints, "orientation_hints");
  const Array_view* given_normals = normal_view ? &*normal_view : nullptr;
  const Array_view* given_hints = hint_view ? &*hint_view : nullptr;
  return point_view.is_double ? resample_as<double>(point_view, given_normals, given_hints, parameters, callback)
                              : resample_as<float>(point_view, given_normals, given_hints, parameters, callback);
}

} // namespace
} // namespace l0_python

PYBIND11_MODULE(_core, module)
{
  using namespace l0_python;
#if PYBIND11_VERSION_MAJOR == 2 && PYBIND11_VERSION_MINOR < 12
  // It would read NumPy 2's descriptions of arrays as those of NumPy 1, and numbers of `double` as such of `float`.
  if (py::module_::import("numpy").attr("__version__").cast<std::string>().substr(0, 2) != "1.")
    throw py::import_error("cgal_l0 was built with a pybind11 before 2.12, which does not know NumPy 2");
#endif
  module.doc() = "What cgal_l0 is made of. Use cgal_l0.l0_resample_point_set().";
  module.attr("__version__") = CGAL_L0_VERSION;

  py::enum_<Method>(module, "Method").value("default", Method::DEFAULT).value("lor", Method::LOR).value("alor", Method::ALOR);
  py::enum_<Device>(module, "Device").value("cpu", Device::CPU).value("cuda", Device::CUDA).value("auto", Device::AUTO);

  py::class_<Parameters>(module, "Parameters")
    .def(py::init(&default_parameters), py::arg("resampling_method") = Method::DEFAULT)
    .def_readwrite("resampling_method", &Parameters::resampling_method)
    .def_readwrite("number_of_output_points", &Parameters::number_of_output_points)
    .def_readwrite("select_percentage", &Parameters::select_percentage)
    .def_readwrite("neighbor_radius", &Parameters::neighbor_radius)
    .def_readwrite("normal_filter_radius", &Parameters::normal_filter_radius)
    .def_readwrite("sharpness_angle", &Parameters::sharpness_angle)
    .def_readwrite("number_of_normal_filter_iterations", &Parameters::number_of_normal_filter_iterations)
    .def_readwrite("normal_weight", &Parameters::normal_weight)
    .def_readwrite("regularization_weight", &Parameters::regularization_weight)
    .def_readwrite("initial_penalty", &Parameters::initial_penalty)
    .def_readwrite("maximum_penalty", &Parameters::maximum_penalty)
    .def_readwrite("penalty_growth", &Parameters::penalty_growth)
    .def_readwrite("keep_density", &Parameters::keep_density)
    .def_readwrite("viewpoint", &Parameters::viewpoint)
    .def_readwrite("source_indices", &Parameters::source_indices)
    .def_readwrite("feature_confidences", &Parameters::feature_confidences)
    .def_readwrite("number_of_orientation_neighbors", &Parameters::number_of_orientation_neighbors)
    .def_readwrite("random_seed", &Parameters::random_seed)
    .def_readwrite("drop_non_finite", &Parameters::drop_non_finite)
    .def_readwrite("drop_outliers", &Parameters::drop_outliers)
    .def_readwrite("maximum_memory", &Parameters::maximum_memory)
    .def_readwrite("threads", &Parameters::threads)
    .def_readwrite("device", &Parameters::device);

  module.def("resample", &resample_arrays, py::arg("points"), py::arg("normals"), py::arg("orientation_hints"),
             py::arg("parameters"), py::arg("callback"));
}
