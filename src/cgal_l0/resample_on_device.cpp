// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "resample_on_device.h"

#ifdef CGAL_L0_LINKED_WITH_CUDA

#include "dictionary_of.h"
#include "named_parameters_of.h"
#include "run_beside_python.h"

#include <CGAL/L0_resampling/CUDA_resampler.h>
#include <CGAL/L0_resampling/find_near_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <boost/range/irange.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace l0_python {
namespace {

namespace py = pybind11;
namespace internal = CGAL::L0_resampling::internal;
namespace cuda = CGAL::L0_resampling::internal::cuda;

cuda::Device_rows rows_of(const Device_view& view)
{
  return {view.data, view.strides[0], view.strides[1], view.dtype == "float64"};
}

/// Of numbers that follow each other.
template <typename T>
Array_view view_of_numbers(const std::vector<T>& coordinates)
{
  return {reinterpret_cast<const char*>(coordinates.data()), 3 * sizeof(T), sizeof(T),
          coordinates.size() / 3, std::is_same<T, double>::value};
}

/// A call for points of one number type.
template <typename FT>
class Device_call
{
  using Kernel = CGAL::Simple_cartesian<FT>;
  using Resampler = CGAL::L0_resampling::CUDA_resampler<Kernel>;

  const Device_view& m_points;
  const Vectors_of_points<Device_view> m_vectors;
  const Parameters& m_parameters;
  Resampler m_resampler; // made in the calling thread, to which a stream of its own may belong
  std::size_t m_size_of_result = 0;
  CGAL::L0_resampling::Report m_report;
  std::optional<Device_array> m_positions, m_normals_of_result, m_source_indices,
    m_feature_confidences, m_side_confidences, m_neighbor_radii, m_noises, m_position_deviations,
    m_normal_deviations;

public:
  Device_call(const Device_view& points, const Vectors_of_points<Device_view>& vectors,
              const Parameters& parameters)
    : m_points(points), m_vectors(vectors), m_parameters(parameters), m_resampler(points.device)
  {
    for (const Device_view* view :
         {&points, vectors.normals, vectors.orientation_hints, vectors.viewpoints})
      if (view && view->stream >= 0)
        internal::throw_if_failed(cuda::wait_for(m_resampler.session(), view->stream));
  }

  py::object result(const py::object& callback)
  {
    const bool is_complete = run_beside_python(callback,
                                               [&](const std::function<bool(double)>& go_on) {
                                                 in_arena(m_parameters, [&]() { compute(go_on); });
                                               });
    if (!is_complete)
      return py::none();
    return py::make_tuple(m_positions, m_normals_of_result, m_source_indices, m_feature_confidences,
                          m_side_confidences, m_neighbor_radii, m_noises, m_position_deviations,
                          m_normal_deviations, dictionary_of(m_report));
  }

private:
  void compute(const std::function<bool(double)>& callback)
  {
    std::array<std::optional<cuda::Device_rows>, 3> rows_of_vectors;
    const auto rows_of_given =
      [](const Device_view* view,
         std::optional<cuda::Device_rows>& rows) -> const cuda::Device_rows* {
      if (view)
        rows = rows_of(*view);
      return rows ? &*rows : nullptr;
    };
    // only asks for noises and deviations, which are taken from the device below
    const auto if_wanted = [](bool is_wanted) {
      const auto map = CGAL::make_property_map(static_cast<FT*>(nullptr));
      return is_wanted ? std::make_optional(map) : std::nullopt;
    };
    const auto np = named_parameters_of(m_parameters, callback, m_report)
                      .position_deviation_map(if_wanted(m_parameters.position_deviations))
                      .normal_deviation_map(if_wanted(m_parameters.normal_deviations))
                      .noise_map(if_wanted(m_parameters.noises));
    m_resampler.upload_from_device(rows_of(m_points), m_points.size(),
                                   rows_of_given(m_vectors.normals, rows_of_vectors[0]),
                                   rows_of_given(m_vectors.orientation_hints, rows_of_vectors[1]),
                                   rows_of_given(m_vectors.viewpoints, rows_of_vectors[2]), np);
    m_resampler.resample_on_device(np, m_report);
    m_report.device_reason = "the points are on it";
    m_size_of_result = m_report.number_of_output_points;
    const std::int64_t rows = std::int64_t(m_size_of_result);
    m_positions = new_array({rows, 3}, 'f', sizeof(FT));
    m_normals_of_result = new_array({rows, 3}, 'f', sizeof(FT));
    if (m_size_of_result > 0)
      m_resampler.download_to_device(m_report, static_cast<FT*>(m_positions->memory->data()),
                                     static_cast<FT*>(m_normals_of_result->memory->data()));
    if (m_parameters.source_indices)
      m_source_indices = on_device(source_indices());
    if (m_parameters.feature_confidences)
      m_feature_confidences = on_device(feature_confidences());
    const auto of_float = [](const internal::Buffer<float>& values) {
      return std::vector<FT>(values.begin(), values.end());
    };
    if (m_parameters.side_confidences)
      m_side_confidences = on_device(of_float(m_resampler.side_confidences(m_size_of_result)));
    if (m_parameters.neighbor_radii)
      m_neighbor_radii = on_device(
        of_float(m_resampler.neighbor_radii(m_size_of_result, m_report)));
    if (m_parameters.noises)
      m_noises = on_device(of_float(m_resampler.noises(m_size_of_result, m_report)));
    if (m_parameters.position_deviations)
      m_position_deviations = on_device(
        of_float(m_resampler.position_deviations(m_size_of_result, m_report)));
    if (m_parameters.normal_deviations)
      m_normal_deviations = on_device(of_float(m_resampler.normal_deviations(m_size_of_result)));
  }

  Device_array new_array(const std::vector<std::int64_t>& shape, char kind, std::size_t item_size)
  {
    Device_array array{nullptr, shape, kind, int(item_size)};
    void* data = nullptr;
    if (array.bytes() > 0)
      internal::throw_if_failed(cuda::allocate(m_resampler.session(), array.bytes(), data));
    array.memory = std::make_shared<Device_memory>(m_points.device, data);
    return array;
  }

  template <typename T>
  Device_array on_device(const std::vector<T>& values)
  {
    Device_array array = new_array({std::int64_t(values.size())},
                                   std::is_integral<T>::value ? 'i' : 'f', sizeof(T));
    if (!values.empty())
      internal::throw_if_failed(cuda::copy_to_device(m_resampler.session(), values.data(),
                                                     array.bytes(), array.memory->data()));
    return array;
  }

  std::vector<std::int64_t> source_indices()
  {
    if (m_size_of_result == 0)
      return {};
    std::vector<FT> positions(3 * m_size_of_result);
    copy_to_host(*m_positions, positions.data());
    std::vector<double> points(3 * m_points.size());
    internal::throw_if_failed(
      cuda::copy_to_host(m_resampler.session(), rows_of(m_points), m_points.size(), points.data()));
    const CGAL::L0_resampling::Near_points near_points =
      CGAL::L0_resampling::find_near_points<CGAL::Parallel_if_available_tag>(
        boost::irange(std::size_t(0), m_points.size()),
        boost::irange(std::size_t(0), m_size_of_result), 1,
        CGAL::parameters::point_map(Point_map{view_of_numbers(points)})
          .query_point_map(Point_map{view_of_numbers(positions)}));
    std::vector<std::int64_t> indices;
    indices.reserve(m_size_of_result);
    for (std::size_t i = 0; i < m_size_of_result; ++i)
      indices.push_back(std::int64_t(near_points.nearest(i)));
    return indices;
  }

  std::vector<FT> feature_confidences()
  {
    const double angle = m_parameters.sharpness_angle.value_or(
      internal::Parameters().sharpness_angle);
    const internal::Buffer<float> confidences = m_size_of_result > 0
                                                  ? m_resampler.feature_confidences(m_report, angle)
                                                  : internal::Buffer<float>();
    return std::vector<FT>(confidences.begin(), confidences.end());
  }
};

} // namespace

Device_memory::~Device_memory()
{
  if (m_data)
    cuda::give_back(m_device, m_data);
}

int device_of_pointer(std::uintptr_t pointer)
{
  int device = 0;
  const cuda::Answer answer = cuda::find_device_of(reinterpret_cast<const void*>(pointer), device);
  return answer.status == cuda::Status::DONE ? device : 0;
}

void copy_to_host(const Device_array& array, void* target)
{
  if (array.bytes() > 0)
    internal::throw_if_failed(
      cuda::copy_to_host(array.memory->device(), array.memory->data(), array.bytes(), target));
}

pybind11::object resample_on_device(const Device_view& points, const Device_view* normals,
                                    const Device_view* orientation_hints,
                                    const Device_view* viewpoints, const Parameters& parameters,
                                    const pybind11::object& callback)
{
  const Vectors_of_points<Device_view> vectors = {normals, orientation_hints, viewpoints};
  if (points.dtype == "float64")
    return Device_call<double>(points, vectors, parameters).result(callback);
  return Device_call<float>(points, vectors, parameters).result(callback);
}

} // namespace l0_python

#else // without CUDA

#include <CGAL/L0_resampling/Solver_report.h>

#include <string>

namespace l0_python {

Device_memory::~Device_memory() = default;

int device_of_pointer(std::uintptr_t) { return 0; }

void copy_to_host(const Device_array&, void*) {} // there are no such arrays

pybind11::object resample_on_device(const Device_view& points, const Device_view*,
                                    const Device_view*, const Device_view*, const Parameters&,
                                    const pybind11::object&)
{
  throw CGAL::L0_resampling::Device_error("points is on cuda:" + std::to_string(points.device)
                                          + ", but this module was built without CUDA");
}

} // namespace l0_python

#endif // CGAL_L0_LINKED_WITH_CUDA
