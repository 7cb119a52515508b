// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The module cgal_l0._core. What users see is __init__.py.

#include "arrays.h"
#include "creases_of.h"
#include "device_arrays.h"
#include "dictionary_of.h"
#include "files.h"
#include "orient.h"
#include "resample.h"
#include "run_beside_python.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace l0_python {
namespace {

namespace py = pybind11;
using CGAL::L0_resampling::Method;

/// \returns positions, normals, source indices, feature confidences, side confidences, radii,
/// noises, deviations, outliers, creases, and the report; or None, if the callback cancelled. What
/// is not wanted is empty.
template <typename FT>
py::object resample_as(const Array_view& points, const Vectors_of_points<Array_view>& vectors,
                       const Parameters& parameters, const py::object& callback)
{
  Result<FT> result;
  const bool is_complete =
    run_beside_python(callback, [&](const std::function<bool(double)>& go_on) {
      result = resample<FT>(points, vectors, parameters, go_on);
    });
  if (!is_complete)
    return py::none();
  const py::dict report = dictionary_of(result.report);
  return py::make_tuple(
    array_of(std::move(result.positions), 3), array_of(std::move(result.normals), 3),
    array_of(std::move(result.source_indices), 1),
    array_of(std::move(result.feature_confidences), 1),
    array_of(std::move(result.side_confidences), 1), array_of(std::move(result.neighbor_radii), 1),
    array_of(std::move(result.noises), 1), array_of(std::move(result.position_deviations), 1),
    array_of(std::move(result.normal_deviations), 1), array_of(std::move(result.outliers), 1),
    creases_of(result), report);
}

/// \returns normals and the report; or None, if the callback cancelled.
template <typename FT>
py::object orient_as(const Array_view& points, const Vectors_of_points<Array_view>& vectors,
                     const Parameters& parameters, const py::object& callback)
{
  Oriented_normals<FT> result;
  const bool is_complete =
    run_beside_python(callback, [&](const std::function<bool(double)>& go_on) {
      result = orient<FT>(points, vectors, parameters, go_on);
    });
  if (!is_complete)
    return py::none();
  const py::dict report = dictionary_of(result.report);
  return py::make_tuple(array_of(std::move(result.normals), 3), report);
}

/// Views of the arrays that are given.
class Given_vectors
{
  std::array<std::optional<Array_view>, 4> m_views;

public:
  Vectors_of_points<Array_view> vectors;

  Given_vectors(const std::optional<py::array>& normals,
                const std::optional<py::array>& orientation_hints,
                const std::optional<py::array>& viewpoints,
                const std::optional<py::array>& noises = std::nullopt)
    : vectors{view(normals, m_views[0]), view(orientation_hints, m_views[1]),
              view(viewpoints, m_views[2]), view(noises, m_views[3])}
  {}
  Given_vectors(const Given_vectors&) = delete;
  Given_vectors& operator=(const Given_vectors&) = delete;

private:
  static const Array_view* view(const std::optional<py::array>& array,
                                std::optional<Array_view>& place)
  {
    if (array)
      place = view_of(*array);
    return place ? &*place : nullptr;
  }
};

py::object resample_arrays(const py::array& points, const std::optional<py::array>& normals,
                           const std::optional<py::array>& orientation_hints,
                           const std::optional<py::array>& viewpoints,
                           const std::optional<py::array>& noises, const Parameters& parameters,
                           const py::object& callback)
{
  const Array_view view = view_of(points);
  const Given_vectors given(normals, orientation_hints, viewpoints, noises);
  return view.is_double ? resample_as<double>(view, given.vectors, parameters, callback)
                        : resample_as<float>(view, given.vectors, parameters, callback);
}

/// The result has the number type of the normals, or else that of the points.
py::object orient_arrays(const py::array& points, const std::optional<py::array>& normals,
                         const std::optional<py::array>& orientation_hints,
                         const std::optional<py::array>& viewpoints, const Parameters& parameters,
                         const py::object& callback)
{
  const Array_view view = view_of(points);
  const Given_vectors given(normals, orientation_hints, viewpoints);
  const bool is_double = given.vectors.normals ? given.vectors.normals->is_double : view.is_double;
  return is_double ? orient_as<double>(view, given.vectors, parameters, callback)
                   : orient_as<float>(view, given.vectors, parameters, callback);
}

const char* expected(const Parameters::Number&) { return "a number"; }
const char* expected(const Parameters::Count&) { return "a whole number"; }
const char* expected(const Parameters::Size&) { return "a whole number"; }
const char* expected(const Parameters::Flag&) { return "True or False"; }
const char* expected(const Parameters::Place&) { return "three coordinates"; }

/// The class Parameters, and a dictionary of what is expected of its members that are values.
void bind_parameters(py::module_& module)
{
  py::class_<Parameters> parameters(module, "Parameters");
  py::dict expected_of_values;
  const auto add = [&](const char* name, auto member) {
    parameters.def_readwrite(name, member);
    expected_of_values[name] = expected(Parameters().*member);
  };
  parameters.def(py::init([](Method method) {
                   Parameters of_method;
                   of_method.resampling_method = method;
                   return of_method;
                 }),
                 py::arg("resampling_method") = Method::DEFAULT);
#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED) add(#X, &Parameters::X);
#define CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED) add(#X, &Parameters::X);
#include <CGAL/L0_resampling/value_parameters.h>
  add("threads", &Parameters::threads);
  parameters.def_readwrite("source_indices", &Parameters::source_indices)
    .def_readwrite("feature_confidences", &Parameters::feature_confidences)
    .def_readwrite("side_confidences", &Parameters::side_confidences)
    .def_readwrite("neighbor_radii", &Parameters::neighbor_radii)
    .def_readwrite("noises", &Parameters::noises)
    .def_readwrite("position_deviations", &Parameters::position_deviations)
    .def_readwrite("normal_deviations", &Parameters::normal_deviations)
    .def_readwrite("creases", &Parameters::creases)
    .def_readwrite("outliers", &Parameters::outliers)
    .def_readwrite("device", &Parameters::device);
  module.attr("expected") = expected_of_values;
}

} // namespace
} // namespace l0_python

PYBIND11_MODULE(_core, module)
{
  using namespace l0_python;
#if PYBIND11_VERSION_MAJOR == 2 && PYBIND11_VERSION_MINOR < 12
  // It would read NumPy 2's descriptions of arrays as those of NumPy 1, and numbers of `double` as
  // such of `float`.
  if (py::module_::import("numpy").attr("__version__").cast<std::string>().substr(0, 2) != "1.")
    throw py::import_error(
      "cgal_l0 was built with a pybind11 before 2.12, which does not know NumPy 2");
#endif
  module.doc() = "What cgal_l0 is made of. Use cgal_l0.l0_resample_point_set().";
  module.attr("__version__") = CGAL_L0_VERSION;
  py::register_exception_translator([](std::exception_ptr error) {
    try
    {
      std::rethrow_exception(error);
    }
    catch (const std::bad_alloc&)
    {
      PyErr_SetString(PyExc_MemoryError, "not enough memory, or less than maximum_memory allows");
    }
  });

  py::enum_<Method>(module, "Method")
    .value("default", Method::DEFAULT)
    .value("lor", Method::LOR)
    .value("alor", Method::ALOR);
  py::enum_<Device>(module, "Device")
    .value("cpu", Device::CPU)
    .value("cuda", Device::CUDA)
    .value("auto", Device::AUTO);

  bind_parameters(module);
  module.def("resample", &resample_arrays, py::arg("points"), py::arg("normals"),
             py::arg("orientation_hints"), py::arg("viewpoints"), py::arg("noises"),
             py::arg("parameters"), py::arg("callback"));
  module.def("orient", &orient_arrays, py::arg("points"), py::arg("normals"),
             py::arg("orientation_hints"), py::arg("viewpoints"), py::arg("parameters"),
             py::arg("callback"));
  bind_device_arrays(module);
  bind_files(module);
}
