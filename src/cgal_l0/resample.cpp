// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "resample.h"

#include "named_parameters_of.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>

#include <boost/range/irange.hpp>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace l0_python {
namespace {

/// Appends the pairs that the function writes to the arrays of a result. The report knows their
/// number before the first is written.
template <typename FT>
class Result_inserter
{
  Result<FT>* m_result;

public:
  using iterator_category = std::output_iterator_tag;
  using value_type = void;
  using difference_type = void;
  using pointer = void;
  using reference = void;

  explicit Result_inserter(Result<FT>& result) : m_result(&result) {}

  Result_inserter& operator*() { return *this; }
  Result_inserter& operator++() { return *this; }
  Result_inserter& operator++(int) { return *this; }

  template <typename Point, typename Vector>
  Result_inserter& operator=(const std::pair<Point, Vector>& pair)
  {
    if (m_result->positions.empty())
    {
      m_result->positions.reserve(3 * m_result->report.number_of_output_points);
      m_result->normals.reserve(3 * m_result->report.number_of_output_points);
    }
    const Point& p = pair.first;
    const Vector& n = pair.second;
    m_result->positions.insert(m_result->positions.end(), {p.x(), p.y(), p.z()});
    m_result->normals.insert(m_result->normals.end(), {n.x(), n.y(), n.z()});
    return *this;
  }
};

/// Appends what is put to it, which comes in the order of the points.
template <typename T>
struct Appending_map
{
  using key_type = std::size_t;
  using value_type = T;
  using reference = T;
  using category = boost::writable_property_map_tag;

  std::vector<T>* values;

  friend void put(const Appending_map& map, std::size_t, T value) { map.values->push_back(value); }
};

template <typename FT>
Result<FT> resample_with_tag(const Array_view& points, const Vectors_of_points<Array_view>& vectors,
                             const Parameters& parameters,
                             const std::function<bool(double)>& callback, bool on_device)
{
  Result<FT> result;
  const auto if_wanted = [](bool is_wanted, const auto& map) {
    return is_wanted ? std::make_optional(map) : std::nullopt;
  };
  const auto if_there = [](const Array_view* view) {
    return view ? std::make_optional(Normal_map{*view}) : std::nullopt;
  };
  const auto np =
    named_parameters_of(parameters, callback, result.report)
      .normal_map(if_there(vectors.normals))
      .orientation_hint_map(if_there(vectors.orientation_hints))
      .viewpoint_map(vectors.viewpoints ? std::make_optional(Point_map{*vectors.viewpoints})
                                        : std::nullopt)
      .point_noise_map(vectors.noises ? std::make_optional(Number_map{*vectors.noises})
                                      : std::nullopt)
      .source_index_map(
        if_wanted(parameters.source_indices, Appending_map<std::int64_t>{&result.source_indices}))
      .feature_confidence_map(
        if_wanted(parameters.feature_confidences, Appending_map<FT>{&result.feature_confidences}))
      .side_confidence_map(
        if_wanted(parameters.side_confidences, Appending_map<FT>{&result.side_confidences}))
      .neighbor_radius_map(
        if_wanted(parameters.neighbor_radii, Appending_map<FT>{&result.neighbor_radii}))
      .noise_map(if_wanted(parameters.noises, Appending_map<FT>{&result.noises}))
      .position_deviation_map(
        if_wanted(parameters.position_deviations, Appending_map<FT>{&result.position_deviations}))
      .normal_deviation_map(
        if_wanted(parameters.normal_deviations, Appending_map<FT>{&result.normal_deviations}))
      .crease_output_iterator(if_wanted(parameters.creases, std::back_inserter(result.creases)))
      .corner_output_iterator(if_wanted(parameters.creases, std::back_inserter(result.corners)))
      .outlier_output_iterator(if_wanted(parameters.outliers, std::back_inserter(result.outliers)))
      .point_map(Point_map{points})
      .geom_traits(CGAL::Simple_cartesian<FT>());
  const auto range = boost::irange(std::size_t(0), points.size);
#ifdef CGAL_L0_LINKED_WITH_CUDA
  if (on_device)
    CGAL::l0_resample_point_set<CGAL::CUDA_tag>(range, Result_inserter<FT>(result), np);
  else
#else
  static_cast<void>(on_device);
#endif
    CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(range, Result_inserter<FT>(result),
                                                                 np);
  return result;
}

template <typename FT>
Result<FT> resample_on_any_device(const Array_view& points,
                                  const Vectors_of_points<Array_view>& vectors,
                                  const Parameters& parameters,
                                  const std::function<bool(double)>& callback)
{
  Result<FT> result;
  const auto resample_there = [&](bool gpu) {
    result = resample_with_tag<FT>(points, vectors, parameters, callback, gpu);
  };
  const l0_common::Device_request request = {parameters.device, "device='cuda'", ""};
  const std::string reason = l0_common::run_on_chosen(
    request, [&]() { resample_there(true); }, [&]() { resample_there(false); });
  result.report.device_reason = reason;
  return result;
}

} // namespace

void in_arena(const Parameters& parameters, const std::function<void()>& work)
{
  if (parameters.threads && (*parameters.threads < 1 || *parameters.threads > 4096))
    throw std::invalid_argument("threads is " + std::to_string(*parameters.threads)
                                + ", expected 1 to 4096");
  // An arena limits this call alone, where tbb::global_control would limit every other one of the
  // process too.
  tbb::task_arena arena(parameters.threads ? int(*parameters.threads)
                                           : int(tbb::task_arena::automatic));
  arena.execute(work);
}

template <typename FT>
Result<FT> resample(const Array_view& points, const Vectors_of_points<Array_view>& vectors,
                    const Parameters& parameters, const std::function<bool(double)>& callback)
{
  Result<FT> result;
  in_arena(parameters,
           [&]() { result = resample_on_any_device<FT>(points, vectors, parameters, callback); });
  return result;
}

template Result<float> resample(const Array_view&, const Vectors_of_points<Array_view>&,
                                const Parameters&, const std::function<bool(double)>&);
template Result<double> resample(const Array_view&, const Vectors_of_points<Array_view>&,
                                 const Parameters&, const std::function<bool(double)>&);

} // namespace l0_python
