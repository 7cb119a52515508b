// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_CUDA_RESAMPLER_H
#define CGAL_L0_RESAMPLING_CUDA_RESAMPLER_H

#include <CGAL/license/L0_resampling.h>

#ifndef CGAL_L0_LINKED_WITH_CUDA
#error "CUDA_resampler.h needs CUDA: link with CGAL::L0_CUDA_support"
#endif

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/find_near_points.h>
#include <CGAL/L0_resampling/internal/creases/Placed_creases.h>
#include <CGAL/L0_resampling/internal/device/Device_progress.h>
#include <CGAL/L0_resampling/internal/device/Device_session.h>
#include <CGAL/L0_resampling/internal/device/cuda_answer.h>
#include <CGAL/L0_resampling/internal/device/cuda_device_arrays.h>
#include <CGAL/L0_resampling/internal/device/cuda_interface.h>
#include <CGAL/L0_resampling/internal/interface/Given_parameters.h>
#include <CGAL/L0_resampling/internal/interface/Point_data.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/interface/checked_types.h>
#include <CGAL/L0_resampling/internal/interface/features_of_result.h>
#include <CGAL/L0_resampling/internal/interface/output_iterators.h>
#include <CGAL/L0_resampling/internal/interface/points_of_range.h>
#include <CGAL/L0_resampling/internal/interface/rounded_positions.h>
#include <CGAL/L0_resampling/named_parameters.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// Whether a CUDA device can be used by this program, on this machine, now.
/// \param reason out, if not null: why not
inline bool is_cuda_device_usable(std::string* reason = nullptr)
{
  const internal::cuda::Answer answer = internal::cuda::find_device();
  if (reason)
    *reason = answer.message;
  return answer.status == internal::cuda::Status::DONE;
}

/*!
\ingroup PkgL0ResamplingRef

Resamples one point set again and again on a CUDA device, as an application does in which somebody
moves sliders: the points are brought to the device once, and a call like the last one allocates
nothing there. The first call does not know how much memory it will need, and may hold more than
those after it, in pieces: `maximum_memory` bounds that too. The work is that of
`l0_resample_point_set<CUDA_tag>()`, which makes one object for one call.

An object uses the device that is current when it is made. Calls of one object from several threads
wait for each other.

\tparam Kernel a model of `Kernel` whose `FT` is `float` or `double`
*/
template <typename Kernel>
class CUDA_resampler
{
  using FT = typename Kernel::FT;
  using Point = typename Kernel::Point_3;
  using Normal = typename Kernel::Vector_3;

  internal::Device_session m_session;
  internal::Input m_box; // without points
  std::size_t m_size = 0, m_number_of_dropped_points = 0;
  bool m_has_hints = false, m_has_viewpoints = false; // of the points: one of both at most

public:
  /// \throws Device_error if there is no usable device
  CUDA_resampler() : m_session(internal::new_device_session()) {}

  /// Brings points to the device, in place of those it holds.
  /// \param points as for `l0_resample_point_set()`, read by all threads of the host if its
  /// iterators have random access
  /// \param np `point_map`, `normal_map`, `orientation_hint_map`, `viewpoint_map` and
  /// `drop_non_finite` of `l0_resample_point_set()`; `maximum_memory` is of the device; others are
  /// checked
  /// \throws std::invalid_argument for what `l0_resample_point_set()` refuses
  /// \throws std::bad_alloc if the device has not enough memory for the points, or is not allowed
  /// it
  /// \throws Device_error if the device fails
  ///
  /// What the property maps throw passes through. In all of these cases the object then holds no
  /// points.
  template <typename PointRange, typename NamedParameters = parameters::Default_named_parameters>
  void upload(const PointRange& points, const NamedParameters& np = parameters::default_values())
  {
    const auto point_map = internal::point_map_of(points, np);
    const auto normal_map = internal::normal_map_of(np);
    if constexpr (internal::input_fits<Kernel, std::decay_t<decltype(point_map)>,
                                       std::decay_t<decltype(normal_map)>, NamedParameters>())
      upload(points, point_map, normal_map, np);
  }

  /// Resamples the points that the last `upload()` brought; of none, the result is empty. A named
  /// parameter that is not given has its default, whatever an earlier call had.
  /// \param out takes one `std::pair<Point_3, Vector_3>`, or `Point_3`, for each point of the
  /// result
  /// \param np as for `l0_resample_point_set()`, without those that `upload()` reads, and without
  /// `sparse_linear_solver` and `source_index_map`
  /// \returns the output iterator behind the last pair written
  /// \throws std::invalid_argument for a parameter out of its range
  /// \throws std::bad_alloc if memory does not suffice, on the device or here
  /// \throws Device_error if the device fails
  ///
  /// What the callback, the maps of the result and the output iterator throw passes through.
  template <typename OutputIterator,
            typename NamedParameters = parameters::Default_named_parameters>
  OutputIterator resample(OutputIterator out,
                          const NamedParameters& np = parameters::default_values())
  {
    static_assert(
      parameters::is_default_parameter<NamedParameters, internal_np::source_index_map_t>::value,
      "The points are on the device only: l0_resample_point_set<CUDA_tag>() can tell the indices.");
    const auto write = [&](std::size_t size, const auto& pair_of,
                           const internal::Point_data& data) {
      internal::write_point_data(np, data, size, [](std::size_t i) { return i; });
      internal::write_creases<Kernel>(np, data.creases);
      internal::write_outliers(np, data.outliers);
      internal::write_result<Kernel>(size, pair_of, out);
    };
    if constexpr (internal::output_fits<NamedParameters>()
                  && internal::iterator_fits<Kernel, OutputIterator>())
      resample_and_write([](const auto&, Near_points&) {}, write, np);
    return out;
  }

  /// As `resample()`, but the result stays on the device until the next call.
  /// \param np without what is written for each point
  /// \param report of the call
  /// \returns whether there is a result
  template <typename NamedParameters>
  bool resample_on_device(const NamedParameters& np, Report& report)
  {
    static_assert(
      parameters::is_default_parameter<NamedParameters,
                                       internal_np::crease_output_iterator_t>::value
        && parameters::is_default_parameter<NamedParameters,
                                            internal_np::corner_output_iterator_t>::value,
      "Creases are found on the host: resample() can tell them.");
    static_assert(parameters::is_default_parameter<NamedParameters,
                                                   internal_np::outlier_output_iterator_t>::value,
                  "resample() can tell which points are outliers.");
    internal::Parameters parameters;
    if (!compute(np, parameters, report))
      return false;
    report.number_of_output_points = parameters.number_of_output_points;
    return true;
  }

  /// Writes the result to arrays on the device.
  /// \param report of the call that made the result
  /// \param positions, normals three numbers for each of its points
  void download_to_device(const Report& report, FT* positions, FT* normals)
  {
    using namespace internal;
    const std::array<std::array<FT, 3>, 2> box = box_of_result<FT>(m_box, report.neighbor_radius);
    bool may_have_equal_points = false;
    throw_if_failed(cuda::download_to_device(*m_session, box[0].data(), box[1].data(), positions,
                                             normals, may_have_equal_points));
    const std::size_t m = report.number_of_output_points;
    if (!may_have_equal_points || !is_separate(m, report))
      return;
    // The host separates them, as those of every other call.
    Buffer<Vector> exact(m, Vector::Zero());
    std::vector<float> unused_normals(3 * m);
    throw_if_failed(cuda::download(*m_session, coordinates(exact), unused_normals.data()));
    const Buffer<std::array<FT, 3>> rounded =
      rounded_positions<Parallel_if_available_tag, FT>(exact, m_box, report.neighbor_radius, true);
    throw_if_failed(
      cuda::copy_to_device(*m_session, rounded.data(), m * sizeof(rounded[0]), positions));
  }

  /// \cond SKIP_IN_MANUAL
  // For `l0_resample_point_set()`, which has the points at hand.
  template <typename PointRange, typename PointMap, typename Write, typename NamedParameters>
  void resample(const PointRange& points, PointMap point_map, std::size_t near_count,
                const Write& write, const NamedParameters& np)
  {
    using namespace internal;
    const auto find_near = [&](const Buffer<std::array<FT, 3>>& positions,
                               Near_points& near_points) {
      Report unwanted_report;
      Memory_counter memory;
      Progress progress(nullptr, unwanted_report, memory);
      near_points = internal::find_near_points<Parallel_if_available_tag>(
        points, point_map, positions, number_of_near_points(Given_parameters(np), near_count),
        progress, memory);
    };
    resample_and_write(find_near, write, np);
  }

  // For callers whose points are on the device already, and whose result stays there, such as the
  // Python package.

  /// \throws Device_error if the device cannot be used
  explicit CUDA_resampler(int device)
  {
    internal::cuda::Session* session = nullptr;
    const internal::cuda::Answer answer = internal::cuda::create_on(device, session);
    m_session.reset(session);
    internal::throw_if_failed(answer);
  }

  internal::cuda::Session& session() { return *m_session; }

  /// As `upload()`.
  /// \param normals, hints, viewpoints null for none; not both of the latter
  /// \param np `drop_non_finite` and `maximum_memory`; others are checked
  template <typename NamedParameters>
  void upload_from_device(const internal::cuda::Device_rows& points, std::size_t size,
                          const internal::cuda::Device_rows* normals,
                          const internal::cuda::Device_rows* hints,
                          const internal::cuda::Device_rows* viewpoints, const NamedParameters& np)
  {
    using namespace internal;
    m_size = m_number_of_dropped_points = 0;
    m_box.is_kept.clear(); // of points of the host
    m_has_hints = hints != nullptr;
    m_has_viewpoints = viewpoints != nullptr;
    Given_sides{false, false, m_has_viewpoints, m_has_hints}.check_at_most_one();
    const Given_parameters given(np);
    const bool drop_non_finite = given.drop_non_finite.value_or(false);
    const Parameters checked = checked_parameters(given, size);
    refuse_noises_of_points(checked);
    if (size == 0)
      return;
    cuda::Device_points taken;
    throw_if_failed(cuda::upload_from_device(*m_session, points, size, normals,
                                             viewpoints ? viewpoints : hints, viewpoints != nullptr,
                                             drop_non_finite, checked.maximum_memory, taken));
    if (taken.first_non_finite < size && !drop_non_finite)
    {
      cuda::Device_rows row = points;
      row.data = static_cast<const char*>(points.data)
                 + std::ptrdiff_t(taken.first_non_finite) * points.row_stride;
      Vector point;
      throw_if_failed(cuda::copy_to_host(*m_session, row, 1, point.data()));
      refuse_non_finite_point(taken.first_non_finite, point);
    }
    m_size = taken.size;
    m_number_of_dropped_points = size - taken.size;
    m_box.low = Eigen::Map<const Vector>(taken.low);
    m_box.high = Eigen::Map<const Vector>(taken.high);
  }

  /// The confidences of the result, found on the host.
  internal::Buffer<float> feature_confidences(const Report& report, double sharpness_angle)
  {
    using namespace internal;
    const std::size_t m = report.number_of_output_points;
    Buffer<Vector> positions(m, Vector::Zero());
    std::vector<float> normals(3 * m);
    throw_if_failed(cuda::download(*m_session, coordinates(positions), normals.data()));
    Buffer<float> confidences;
    estimate_feature_confidences(positions, normals, sharpness_angle, confidences);
    return confidences;
  }

  // Values of the last result; noises and deviations of a call that was asked for them.

  internal::Buffer<float> side_confidences(std::size_t number_of_samples)
  {
    return values_of_result(number_of_samples, &internal::cuda::Values_of_result::side_confidences);
  }
  internal::Buffer<float> neighbor_radii(std::size_t number_of_samples, const Report& report)
  {
    return internal::neighbor_radii(values_of_result(number_of_samples,
                                                     &internal::cuda::Values_of_result::scales),
                                    number_of_samples, report.neighbor_radius);
  }
  internal::Buffer<float> noises(std::size_t number_of_samples, const Report& report)
  {
    return internal::lengths_of_input(values_of_result(number_of_samples,
                                                       &internal::cuda::Values_of_result::noises),
                                      report.neighbor_radius);
  }
  internal::Buffer<float> position_deviations(std::size_t number_of_samples, const Report& report)
  {
    return internal::lengths_of_input(
      values_of_result(number_of_samples, &internal::cuda::Values_of_result::position_deviations),
      report.neighbor_radius);
  }
  internal::Buffer<float> normal_deviations(std::size_t number_of_samples)
  {
    return values_of_result(number_of_samples,
                            &internal::cuda::Values_of_result::normal_deviations);
  }

private:
  internal::Buffer<float> values_of_result(std::size_t number_of_samples,
                                           float* internal::cuda::Values_of_result::*wanted)
  {
    internal::Buffer<float> values(number_of_samples, 0.f);
    internal::cuda::Values_of_result arrays;
    arrays.*wanted = values.data();
    internal::throw_if_failed(internal::cuda::download_values(*m_session, arrays));
    return values;
  }

  /// Runs the stages; the result stays on the device.
  /// \param parameters out: those that were checked
  /// \returns whether there is a result; if not, none was asked for, or the callback cancelled
  template <typename NamedParameters>
  bool compute(const NamedParameters& np, internal::Parameters& parameters, Report& report)
  {
    static_assert(
      parameters::is_default_parameter<NamedParameters, internal_np::sparse_linear_solver_t>::value,
      "On the device there is one solver. CUDA_least_squares_solver_traits runs beside the stages "
      "of the CPU.");
    return compute(internal::Given_parameters(np), parameters, report);
  }

  /// The device does not take them.
  static void refuse_noises_of_points(const internal::Parameters& parameters)
  {
    internal::check_parameter(!parameters.is_noise_given_by_point, "point_noise_map", "given",
                              "a concurrency tag of the CPU beside it");
  }

  bool compute(const internal::Given_parameters& given, internal::Parameters& parameters,
               Report& report)
  {
    using namespace internal;
    report = Report();
    report.device = "cuda";
    report.device_reason = "asked for";
    report.number_of_input_points = m_size;
    report.number_of_dropped_points = m_number_of_dropped_points;
    parameters = checked_parameters(given, m_size);
    refuse_noises_of_points(parameters);
    Given_sides sides = given_sides(given);
    sides.viewpoint_map = m_has_viewpoints;
    sides.orientation_hint_map = m_has_hints;
    sides.check_at_most_one();
    parameters.hints_are_viewpoints = m_has_viewpoints;
    if (parameters.number_of_output_points == 0)
      return false;

    Device_progress progress(given.callback);
    cuda::Call_report call;
    cuda::Answer answer = cuda::resample(*m_session, parameters, progress.as_callback(), call);
    fill_report(call, report);
    progress.rethrow_exception_of_callback();
    throw_if_failed(answer);
    if (answer.status == cuda::Status::CANCELLED)
    {
      report.outcome = Outcome::CANCELLED;
      return false;
    }
    return true;
  }

  /// Of a call that was asked for them.
  internal::Buffer<Index> outliers(const Report& report) const
  {
    const unsigned* const first = internal::cuda::outliers(*m_session);
    return internal::places_in_range({first, first + report.number_of_outliers}, m_box);
  }

  /// Whether the points of a result have to differ.
  bool is_separate(std::size_t m, const Report& report) const
  {
    return report.number_of_distinct_points >= (std::min)(m_size - report.number_of_outliers, m);
  }

  template <typename FindNear, typename Write, typename NamedParameters>
  void resample_and_write(const FindNear& find_near, const Write& write, const NamedParameters& np)
  {
    using namespace internal;
    Report unwanted_report;
    Report* const wanted_report = report_of_call(np);
    Report& report = wanted_report ? *wanted_report : unwanted_report;
    Parameters parameters;
    if (!compute(np, parameters, report))
      return;
    const std::size_t m = parameters.number_of_output_points;
    Buffer<Vector> positions(m, Vector::Zero());
    std::vector<float> normals(3 * m);
    throw_if_failed(cuda::download(*m_session, coordinates(positions), normals.data()));
    Point_data data;
    if (parameters.with_creases)
      data.creases = find_creases(
        spacing_of_creases(report.sample_spacing, report.estimated_spacing), positions, normals);
    const Buffer<std::array<FT, 3>> rounded = rounded_positions<Parallel_if_available_tag, FT>(
      positions, m_box, report.neighbor_radius, is_separate(m, report));
    find_near(rounded, data.near_points);
    if (parameters.with_feature_confidences)
      estimate_feature_confidences(positions, normals, parameters.sharpness_angle,
                                   data.feature_confidences);
    if (parameters.with_side_confidences)
      data.side_confidences = side_confidences(m);
    if (parameters.with_neighbor_radii)
      data.neighbor_radii = neighbor_radii(m, report);
    if (parameters.with_noises)
      data.noises = noises(m, report);
    if (parameters.with_deviations)
    {
      data.position_deviations = position_deviations(m, report);
      data.normal_deviations = normal_deviations(m);
    }
    if (parameters.with_outliers)
      data.outliers = outliers(report);
    report.number_of_output_points = m;
    const auto pair_of = [&](std::size_t i) {
      return std::make_pair(Point(rounded[i][0], rounded[i][1], rounded[i][2]),
                            Normal(FT(normals[3 * i]), FT(normals[3 * i + 1]),
                                   FT(normals[3 * i + 2])));
    };
    write(m, pair_of, data);
  }

public:
  template <typename PointRange, typename PointMap, typename NormalMap, typename NamedParameters>
  void upload(const PointRange& points, PointMap point_map, NormalMap normal_map,
              const NamedParameters& np)
  {
    using namespace internal;
    m_size = 0;
    Report report;
    const Given_parameters given(np);
    // checked before any point is looked at
    const Parameters checked =
      checked_parameters(given, std::size_t(std::distance(points.begin(), points.end())));
    Input input;
    read_points<Parallel_if_available_tag>(points, point_map, given.drop_non_finite.value_or(false),
                                           report, input);
    read_normals_if_given<Parallel_if_available_tag>(points, normal_map, input);
    read_hints_if_given<Parallel_if_available_tag>(points, point_map, np, input);
    m_has_viewpoints = checked.hints_are_viewpoints;
    m_has_hints = !input.hints.empty() && !m_has_viewpoints;
    m_number_of_dropped_points = report.number_of_dropped_points;
    m_box.low = input.low;
    m_box.high = input.high;
    m_box.is_kept = std::move(input.is_kept);
    if (input.points.empty())
      return;
    throw_if_failed(cuda::upload(*m_session, coordinates(input.points), input.points.size(),
                                 input.normals.empty() ? nullptr : input.normals.front().data(),
                                 input.hints.empty() ? nullptr : input.hints.front().data(),
                                 checked.maximum_memory));
    m_size = input.points.size();
  }
  /// \endcond
};

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_CUDA_RESAMPLER_H
