// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files.h"

#include "arrays.h"
#include "run_beside_python.h"

#include "basis/Failure.h"
#include "formats/Named_columns.h"
#include "formats/read_points.h"
#include "formats/write_points.h"
#include "pictures/render_snapshot.h"
#include "pictures/Image.h"
#include "pictures/views_around.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace l0_python {
namespace {

namespace py = pybind11;
using l0_tool::Number_type;
using l0_tool::Point;
using l0_tool::Point_cloud;
using l0_tool::Vector;

/// Thrown into a reader whose caller wants no more.
struct Cancelled
{};

/// The bytes of a file or of the system, which may be no text, as text.
py::str text_of(const std::string& bytes)
{
  PyObject* const text = PyUnicode_DecodeUTF8(bytes.data(), py::ssize_t(bytes.size()), "replace");
  if (!text)
    throw py::error_already_set();
  return py::reinterpret_steal<py::str>(text);
}

[[noreturn]] void raise(PyObject* type, const std::string& message)
{
  PyErr_SetObject(type, text_of(message).ptr());
  throw py::error_already_set();
}

/// Calls `function` with Python's exceptions for those of the program.
template <typename Function>
auto with_python_exceptions(const Function& function)
{
  try
  {
    return function();
  }
  catch (const l0_tool::Failure& failure)
  {
    raise(failure.status() == l0_tool::OUTPUT_NOT_WRITTEN ? PyExc_OSError
          : failure.status() == l0_tool::RUN_TIME_FAILURE ? PyExc_RuntimeError
                                                          : PyExc_ValueError,
          failure.what());
  }
}

/// By the name that the caller gives, or else by the extension of the file.
l0_tool::File_format format_of(const std::string& path, const std::optional<std::string>& name)
{
  const auto format = l0_tool::format_of(name ? "file." + *name : path);
  if (format)
    return *format;
  raise(PyExc_ValueError,
        name ? "format is '" + *name + "', which is none of the extensions that read_points() lists"
             : l0_tool::unknown_extension(path, "format="));
}

const char* typestr_of(Number_type type)
{
  switch (type)
  {
  case Number_type::INT8: return "i1";
  case Number_type::UINT8: return "u1";
  case Number_type::INT16: return "i2";
  case Number_type::UINT16: return "u2";
  case Number_type::INT32: return "i4";
  case Number_type::UINT32: return "u4";
  case Number_type::FLOAT32: return "f4";
  case Number_type::FLOAT64: break;
  }
  return "f8";
}

Number_type number_type_of(const py::dtype& dtype)
{
  const bool is_signed = dtype.kind() == 'i';
  switch (dtype.itemsize())
  {
  case 1: return is_signed ? Number_type::INT8 : Number_type::UINT8;
  case 2: return is_signed ? Number_type::INT16 : Number_type::UINT16;
  case 4:
    return dtype.kind() == 'f' ? Number_type::FLOAT32
           : is_signed         ? Number_type::INT32
                               : Number_type::UINT32;
  default: return Number_type::FLOAT64;
  }
}

/// Points or vectors, three numbers each, as an array that takes them over, or has them in single
/// precision.
template <typename Triple>
py::array array_of_triples(std::vector<Triple>&& triples, bool is_single)
{
  static_assert(sizeof(Triple) == 3 * sizeof(double));
  if (is_single)
  {
    std::vector<float> numbers;
    numbers.reserve(3 * triples.size());
    for (const Triple& triple : triples)
      numbers.insert(numbers.end(), {float(triple.x()), float(triple.y()), float(triple.z())});
    return array_of(std::move(numbers), 3);
  }
  const auto [owner, vector] = owned_by_python(std::move(triples));
  const std::vector<py::ssize_t> shape = {py::ssize_t(vector->size()), 3};
  return py::array_t<double>(shape, reinterpret_cast<const double*>(vector->data()), owner);
}

/// One record for each point, with the number types of the properties; the fields are named f0, f1,
/// ...
py::array records_of(l0_tool::Property_table&& table, std::size_t size)
{
  py::list names, formats, offsets;
  for (const l0_tool::Property& property : table.properties())
  {
    names.append("f" + std::to_string(py::len(names)));
    formats.append(typestr_of(property.type));
    offsets.append(property.offset);
  }
  const py::dtype dtype(names, formats, offsets, py::ssize_t(table.row_size()));
  const auto [owner, moved] = owned_by_python(std::move(table));
  if (moved->row_size() == 0 || size == 0)
    return py::array(dtype, std::vector<py::ssize_t>{py::ssize_t(size)});
  return py::array(dtype, std::vector<py::ssize_t>{py::ssize_t(size)}, moved->row(0), owner);
}

/// \returns points, normals or None, the names of the properties and their records, the number of
/// points dropped, and warnings; or None if cancelled
py::object read_points(const std::string& path, const std::optional<std::string>& format_name,
                       const std::optional<std::string>& columns, bool decimal_comma,
                       bool drop_non_finite, const std::string& decompression,
                       const py::object& callback)
{
  const l0_tool::File_format format = format_of(path, format_name);
  l0_tool::Read_options options;
  const bool is_text = format == l0_tool::File_format::XYZ || format == l0_tool::File_format::CSV;
  if (columns && !is_text && format != l0_tool::File_format::NPY)
    raise(PyExc_ValueError,
          "columns are given, but " + path + " is no text (XYZ or CSV) and no array (NPY)");
  if (decimal_comma && !is_text)
    raise(PyExc_ValueError, "decimal_comma is given, but " + path + " is no text (XYZ or CSV)");
  if (columns)
    options.columns = with_python_exceptions(
      [&]() { return l0_tool::parse_column_names(*columns); });
  options.drop_non_finite = drop_non_finite;
  options.decompression = decompression;
  options.has_decimal_commas = decimal_comma;
  options.degrees = l0_tool::Read_options::Degrees::WARN;
  options.with_normals = true;
  options.with_properties = true;
  Point_cloud cloud;
  const bool is_complete = with_python_exceptions([&]() {
    return run_beside_python(callback, [&](const std::function<bool(double)>& go_on) {
      try
      {
        cloud = l0_tool::read_points(path, format, options, [&](double share) {
          if (!go_on(share))
            throw Cancelled();
        });
      }
      catch (const Cancelled&)
      {}
    });
  });
  if (!is_complete)
    return py::none();
  const bool is_single = cloud.coordinate_type == Number_type::FLOAT32;
  const std::size_t size = cloud.points.size();
  const bool has_normals = !cloud.normals.empty();
  py::object normals = py::none();
  if (has_normals)
    normals = array_of_triples(std::move(cloud.normals), is_single);
  py::list names, warnings;
  for (const l0_tool::Property& property : cloud.properties.properties())
    names.append(text_of(property.name));
  for (const auto* messages : {&cloud.warnings, &cloud.notes})
    for (const std::string& message : *messages)
      warnings.append(text_of(message));
  return py::make_tuple(array_of_triples(std::move(cloud.points), is_single), normals, names,
                        records_of(std::move(cloud.properties), size),
                        cloud.number_of_dropped_points, warnings);
}

template <typename Triple>
std::vector<Triple> triples_of(const py::array& array)
{
  const Array_view view = view_of(array);
  const Row_map<Triple> map{view};
  std::vector<Triple> triples;
  triples.reserve(view.size);
  for (std::size_t i = 0; i < view.size; ++i)
    triples.push_back(get(map, i));
  return triples;
}

l0_tool::Property_table table_of(const py::array& records)
{
  l0_tool::Property_table table;
  const py::object names = records.dtype().attr("names");
  if (names.is_none())
    return table;
  const py::object fields = records.dtype().attr("fields");
  for (const py::handle name : names)
    table.add_property(name.cast<std::string>(),
                       number_type_of(py::tuple(fields[name])[0].cast<py::dtype>()));
  const auto row_size = std::size_t(records.itemsize());
  const auto* bytes = static_cast<const char*>(records.data());
  table.reserve(std::size_t(records.size()));
  for (std::size_t i = 0; i < std::size_t(records.size()); ++i)
    table.append(bytes + i * row_size);
  return table;
}

/// \param properties packed records
/// \returns the names of the properties that the format cannot hold
std::vector<std::string> write_points(const std::string& path,
                                      const std::optional<std::string>& format_name,
                                      const py::array& points,
                                      const std::optional<py::array>& normals,
                                      const py::array& properties)
{
  const l0_tool::File_format format = format_of(path, format_name);
  const std::string reason = l0_tool::reason_against_output(path, format);
  if (!reason.empty())
    raise(PyExc_ValueError, reason);
  Point_cloud cloud;
  cloud.points = triples_of<Point>(points);
  if (normals)
    cloud.normals = triples_of<Vector>(*normals);
  cloud.properties = table_of(properties);
  const bool is_single = points.itemsize() == sizeof(float);
  cloud.coordinate_type = is_single ? Number_type::FLOAT32 : Number_type::FLOAT64;
  return with_python_exceptions([&]() {
    const py::gil_scoped_release without_lock;
    return l0_tool::write_point_cloud(path, format, cloud);
  });
}

py::array snapshot(const py::array& points, const std::optional<py::array>& input_normals,
                   const py::array& positions, const py::array& normals,
                   const std::optional<py::array_t<float>>& feature_confidences,
                   bool colors_of_normals, const std::optional<std::array<double, 3>>& view,
                   const std::optional<std::array<double, 3>>& up, int number_of_views,
                   const std::optional<std::string>& path)
{
  Point_cloud input;
  input.points = triples_of<Point>(points);
  if (input_normals)
    input.normals = triples_of<Vector>(*input_normals);
  const Point_map position_map{view_of(positions)};
  const Normal_map normal_map{view_of(normals)};
  std::vector<l0_tool::Oriented_point> result;
  for (std::size_t i = 0; i < position_map.array.size; ++i)
    result.emplace_back(get(position_map, i), get(normal_map, i));
  std::vector<float> confidences;
  if (feature_confidences)
    confidences.assign(feature_confidences->data(),
                       feature_confidences->data() + feature_confidences->size());

  using Colors = l0_tool::Snapshot_colors;
  const Colors colors = colors_of_normals ? Colors::NORMALS : Colors::SHADED;
  return with_python_exceptions([&]() -> py::array {
    std::vector<unsigned char> bytes;
    std::vector<py::ssize_t> shape;
    {
      const py::gil_scoped_release without_lock;
      const std::vector<l0_tool::View> views =
        l0_tool::views_around(l0_tool::choose_view(result, {view, up, {}}), number_of_views);
      const l0_tool::Image image = l0_tool::render_snapshot(input, result, views, {}, confidences,
                                                            {}, colors);
      bytes = l0_tool::srgb_bytes(image);
      shape = {image.height, image.width, 3};
      if (path)
        l0_tool::write_png(*path, image);
    }
    const auto [owner, pixels] = owned_by_python(std::move(bytes));
    return py::array_t<unsigned char>(shape, pixels->data(), owner);
  });
}

} // namespace

void bind_files(py::module_& module)
{
  module.def("read_points", &read_points, py::arg("path"), py::arg("format"), py::arg("columns"),
             py::arg("decimal_comma"), py::arg("drop_non_finite"), py::arg("decompression"),
             py::arg("callback"));
  module.def("write_points", &write_points, py::arg("path"), py::arg("format"), py::arg("points"),
             py::arg("normals"), py::arg("properties"));
  module.def("snapshot", &snapshot, py::arg("points"), py::arg("input_normals"),
             py::arg("positions"), py::arg("normals"), py::arg("feature_confidences"),
             py::arg("colors_of_normals"), py::arg("view"), py::arg("up"),
             py::arg("number_of_views"), py::arg("path"));
}

} // namespace l0_python
