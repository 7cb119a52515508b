// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "device_arrays.h"

#include "dlpack.h"
#include "resample_on_device.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace l0_python {
namespace {

namespace py = pybind11;

/// Of an array in the order of C.
std::vector<std::int64_t> strides_of(const std::vector<std::int64_t>& shape, std::int64_t item_size)
{
  std::vector<std::int64_t> strides(shape.size(), item_size);
  for (std::size_t k = shape.size(); k-- > 1;)
    strides[k - 1] = strides[k] * shape[k];
  return strides;
}

Device_view view_of_interface(py::object owner, std::uintptr_t pointer,
                              std::vector<std::int64_t> shape,
                              const std::optional<std::vector<std::int64_t>>& strides,
                              const std::string& typestr, std::int64_t stream)
{
  const py::dtype dtype(typestr);
  Device_view view;
  view.owner = std::move(owner);
  view.data = reinterpret_cast<const char*>(pointer);
  view.strides = strides ? *strides : strides_of(shape, dtype.itemsize());
  view.shape = std::move(shape);
  view.dtype = py::str(static_cast<const py::object&>(dtype));
  view.device = device_of_pointer(pointer);
  view.stream = stream;
  return view;
}

std::string name_of(const dlpack::Data_type& type)
{
  const char* const names[] = {"int", "uint", "float", "opaque", "bfloat", "complex", "bool"};
  const std::size_t number_of_names = sizeof(names) / sizeof(names[0]);
  std::string name = type.code < number_of_names ? names[type.code]
                                                 : "type" + std::to_string(type.code) + "_";
  name += std::to_string(type.bits);
  return type.lanes == 1 ? name : name + "x" + std::to_string(type.lanes);
}

Device_view view_of_dlpack(const py::object& array)
{
  // Its memory is there once the legacy default stream has done what it holds then.
  const std::int64_t legacy_default_stream = 1;
  py::object capsule = array.attr("__dlpack__")(py::arg("stream") = legacy_default_stream);
  auto* managed = static_cast<dlpack::Managed_tensor*>(
    PyCapsule_GetPointer(capsule.ptr(), dlpack::capsule_name));
  if (!managed)
    throw py::error_already_set();
  // A capsule that nobody has taken over deletes the tensor with itself, so it can be the owner as
  // it is.
  const dlpack::Tensor& tensor = managed->tensor;
  Device_view view;
  view.owner = std::move(capsule);
  view.data = static_cast<const char*>(tensor.data) + tensor.byte_offset;
  view.shape.assign(tensor.shape, tensor.shape + tensor.number_of_dimensions);
  const std::int64_t item_size = tensor.data_type.bits * tensor.data_type.lanes / 8;
  view.strides = strides_of(view.shape, item_size);
  for (std::size_t k = 0; tensor.strides && k < view.shape.size(); ++k)
    view.strides[k] = tensor.strides[k] * item_size;
  view.dtype = name_of(tensor.data_type);
  view.device = tensor.device.id;
  view.stream = legacy_default_stream;
  return view;
}

std::string dtype_of(const Device_array& array)
{
  return (array.kind == 'f' ? "float" : "int") + std::to_string(8 * array.item_size);
}

py::dict interface_of(const Device_array& array)
{
  py::dict interface;
  interface["shape"] = py::tuple(py::cast(array.shape));
  interface["typestr"] = std::string("<") + array.kind + std::to_string(array.item_size);
  interface["data"] = py::make_tuple(reinterpret_cast<std::uintptr_t>(array.memory->data()), false);
  interface["strides"] = py::none();
  interface["stream"] = py::none(); // nobody has to wait
  interface["version"] = 3;
  return interface;
}

/// A tensor for others, with what it points to.
struct Exported_tensor
{
  dlpack::Managed_tensor managed;
  Device_array array;
};

void delete_exported(dlpack::Managed_tensor* managed)
{
  delete static_cast<Exported_tensor*>(managed->context);
}

void delete_unused_capsule(PyObject* capsule)
{
  if (PyCapsule_IsValid(capsule, dlpack::capsule_name))
  {
    auto* managed = static_cast<dlpack::Managed_tensor*>(
      PyCapsule_GetPointer(capsule, dlpack::capsule_name));
    managed->deleter(managed);
  }
}

/// The streams of others do not matter, since the numbers are there already.
py::object dlpack_of(const Device_array& array, const py::object&, const py::object&,
                     const std::optional<std::pair<int, int>>& dl_device,
                     const std::optional<bool>& copy)
{
  const std::pair<int, int> own_device(dlpack::cuda, array.memory->device());
  if ((dl_device && *dl_device != own_device) || copy.value_or(false))
    throw py::buffer_error(
      "a DeviceArray gives its own memory on its own device only; copy_to_host() copies it");
  auto exported = std::make_unique<Exported_tensor>();
  exported->array = array;
  dlpack::Tensor& tensor = exported->managed.tensor;
  tensor.data = array.memory->data();
  tensor.device = {dlpack::cuda, array.memory->device()};
  tensor.number_of_dimensions = std::int32_t(array.shape.size());
  tensor.data_type = {std::uint8_t(array.kind == 'f' ? 2 : 0), std::uint8_t(8 * array.item_size),
                      1};
  tensor.shape = exported->array.shape.data();
  tensor.strides = nullptr;
  tensor.byte_offset = 0;
  exported->managed.context = exported.get();
  exported->managed.deleter = &delete_exported;
  PyObject* const capsule = PyCapsule_New(&exported->managed, dlpack::capsule_name,
                                          &delete_unused_capsule);
  if (!capsule)
    throw py::error_already_set();
  static_cast<void>(exported.release()); // to the capsule
  return py::reinterpret_steal<py::object>(capsule);
}

py::array copy_to_host(const Device_array& array)
{
  py::array copy(py::dtype(dtype_of(array)), array.shape);
  copy_to_host(array, copy.mutable_data());
  return copy;
}

py::str representation_of(const Device_array& array)
{
  return py::str("<cgal_l0.DeviceArray of {}, shape {}, on cuda:{}>")
    .format(dtype_of(array), py::tuple(py::cast(array.shape)), array.memory->device());
}

} // namespace

void bind_device_arrays(py::module_& module)
{
  py::class_<Device_array>(
    module, "DeviceArray",
    "An array on a CUDA device, C-contiguous; given back when nobody uses it any more.\n\n"
    "It has __dlpack__ and __cuda_array_interface__, by which torch.from_dlpack(),\n"
    "cupy.asarray() and others use its memory without a copy. The numbers are there:\n"
    "nobody has to wait for them.")
    .def_property_readonly(
      "shape", [](const Device_array& array) { return py::tuple(py::cast(array.shape)); })
    .def_property_readonly("dtype", &dtype_of, "str, as NumPy names it")
    .def_property_readonly(
      "device", [](const Device_array& array) { return array.memory->device(); },
      "int, the number of the CUDA device")
    .def_property_readonly("__cuda_array_interface__", &interface_of)
    .def("__dlpack__", &dlpack_of, py::kw_only(), py::arg("stream") = py::none(),
         py::arg("max_version") = py::none(), py::arg("dl_device") = py::none(),
         py::arg("copy") = py::none())
    .def("__dlpack_device__",
         [](const Device_array& array) {
           return std::make_pair(int(dlpack::cuda), array.memory->device());
         })
    .def("__len__", [](const Device_array& array) { return array.shape[0]; })
    .def("__repr__", &representation_of)
    .def(
      "copy_to_host", [](const Device_array& array) { return copy_to_host(array); },
      "A copy, as a NumPy array.");

  py::class_<Device_view>(module, "DeviceView")
    .def(py::init(&view_of_interface), py::arg("owner"), py::arg("pointer"), py::arg("shape"),
         py::arg("strides"), py::arg("typestr"), py::arg("stream"))
    .def_static("of_dlpack", &view_of_dlpack, py::arg("array"))
    .def_property_readonly("shape",
                           [](const Device_view& view) { return py::tuple(py::cast(view.shape)); })
    .def_readonly("dtype", &Device_view::dtype)
    .def_readonly("device", &Device_view::device);

  module.def("device_of_pointer", &device_of_pointer, py::arg("pointer"));
  module.def("resample_on_device", &resample_on_device, py::arg("points"), py::arg("normals"),
             py::arg("orientation_hints"), py::arg("viewpoints"), py::arg("parameters"),
             py::arg("callback"));
}

} // namespace l0_python
