// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_SESSION_CUH
#define CGAL_L0_CUDA_SESSION_CUH

#include "cloud/Extent.cuh"
#include "cloud/plane_fits.cuh"

#include <CGAL/L0_resampling/internal/core/Parameters.h>

#include <nvtx3/nvToolsExt.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Thrown once the caller wants no more; never leaves the library.
struct Cancelled
{};

/// What stands for the points of the session once they are oriented, in the arena.
struct Oriented_representatives
{
  const unsigned* of_points = nullptr; // for each point of the session, which one stands for it
  const float* normals = nullptr;      // xyz interleaved
  const float* mean_normals = nullptr; // of those around, likewise
  unsigned size = 0;
};

/// The samples of a tile that has found no sides, before they were projected, in the arena.
struct Unoriented_samples
{
  double* positions = nullptr; // xyz interleaved, in the frame
  float* normals = nullptr;    // likewise
  unsigned char* are_own = nullptr;
  unsigned size = 0;
};

struct Session
{
  std::mutex mutex;
  int device;
  bool is_broken = false; // after an error of a kernel no call of this process will work
  cudaStream_t stream = nullptr;
  int number_of_multiprocessors = 0;
  Memory_limit memory_limit{(std::numeric_limits<std::size_t>::max)()};
  Device_block input_memory{memory_limit}, working_memory{memory_limit};
  Device_arena input{input_memory, Device_arena::End::LOW};
  Device_arena arena{working_memory, Device_arena::End::LOW},
    scratch{working_memory, Device_arena::End::HIGH};

  unsigned size = 0;
  const double* points = nullptr;
  const float* normals = nullptr; // null if none were given
  bool all_normals_given = false;
  const float* hints = nullptr;                    // null if none were given
  const Point_in_cloud* points_in_cloud = nullptr; // of a tile; else null
  Extent extent;
  bool has_scales = false;
  Scales scales; // of the points, in the frame of the paper's radius; found when first wanted

  unsigned number_of_samples = 0;
  double* positions = nullptr; // the result, at the bottom of the arena
  float* sample_normals = nullptr;
  float* side_confidences = nullptr;
  float* sample_scales = nullptr; // null if all are 1
  float* sample_noises = nullptr; // null unless they are asked for
  float *position_deviations = nullptr, *normal_deviations = nullptr; // likewise
  unsigned* trees = nullptr;                                          // of a tile
  unsigned char* are_own = nullptr;                                   // likewise
  Unoriented_samples unoriented;                                      // likewise
  Oriented_representatives representatives; // the result of a call that only orients
  std::vector<unsigned> outliers; // of the points, ascending; only of a call that asks for them
  std::vector<Stage> stages;
  std::vector<Iteration> iterations;
  std::vector<cudaEvent_t> events;

  explicit Session(int d) : device(d)
  {
    CGAL_L0_CUDA_CHECK(
      cudaDeviceGetAttribute(&number_of_multiprocessors, cudaDevAttrMultiProcessorCount, device));
    CGAL_L0_CUDA_CHECK(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking));
  }

  ~Session()
  {
    for (cudaEvent_t event : events)
      cudaEventDestroy(event);
    if (stream)
      cudaStreamDestroy(stream);
    cudaGetLastError();
  }

  /// Forgets the last result and what else the last call left, and makes room for the next.
  void reserve(std::size_t bytes)
  {
    forget_result();
    working_memory.reserve(bytes);
  }

  void forget_result()
  {
    number_of_samples = 0;
    outliers.clear();
    unoriented = Unoriented_samples();
    representatives = Oriented_representatives();
    arena.clear();
    scratch.clear();
  }

  struct Input_arrays
  {
    double* points;
    float* normals; // null for none
    float* hints;   // null for none
  };

  /// Forgets the points, and makes room for others.
  Input_arrays reserve_input(std::size_t number_of_points, bool with_normals, bool with_hints,
                             std::size_t maximum_memory)
  {
    size = 0;
    has_scales = false;
    memory_limit.limit = maximum_memory;
    const std::size_t bytes_of_vectors = 3 * sizeof(float) * number_of_points;
    input.clear();
    input_memory.reserve(3 * sizeof(double) * number_of_points
                         + (with_normals ? bytes_of_vectors : 0)
                         + (with_hints ? bytes_of_vectors : 0) + 1024);
    const Input_arrays arrays = {input.take<double>(3 * number_of_points),
                                 with_normals ? input.take<float>(3 * number_of_points) : nullptr,
                                 with_hints ? input.take<float>(3 * number_of_points) : nullptr};
    reserve(39 * number_of_points + (std::size_t(1) << 20));
    return arrays;
  }

  /// Takes the points that were written to these arrays, of which there may be fewer than was
  /// reserved for. Waits for the device.
  void filter_input(const Input_arrays& arrays, unsigned number_of_points)
  {
    points = arrays.points;
    normals = arrays.normals;
    hints = arrays.hints;
    points_in_cloud = nullptr;
    all_normals_given = normals && !has_zero(context(), normals, number_of_points);
    extent = find_extent(context(), points, number_of_points);
    size = number_of_points;
  }

  /// Takes the points of a tile, in place of those of `filter_input()`, in the frame of its cloud.
  /// Waits for the device.
  /// \param robust_diagonal of the cloud
  void take_tile(const double* tile_points, const Point_in_cloud* known, unsigned number_of_points,
                 const Frame& frame, double robust_diagonal)
  {
    points = tile_points;
    normals = hints = nullptr;
    points_in_cloud = known;
    all_normals_given = false;
    extent.frame = frame;
    extent.robust_diagonal = robust_diagonal;
    find_box(context(), points, number_of_points, extent.low_of_input, extent.high_of_input);
    for (int axis = 0; axis < 3; ++axis)
    {
      extent.low[axis] = frame.enter(extent.low_of_input[axis], axis);
      extent.high[axis] = frame.enter(extent.high_of_input[axis], axis);
      extent.trimmed[axis] = extent.high[axis] - extent.low[axis];
    }
    size = number_of_points;
  }

  Execution_context context() { return {arena, scratch, stream, number_of_multiprocessors}; }

  cudaEvent_t event(std::size_t i)
  {
    while (events.size() <= i)
    {
      cudaEvent_t created;
      CGAL_L0_CUDA_CHECK(cudaEventCreate(&created));
      events.push_back(created);
    }
    return events[i];
  }
};

/// Names the stages, times them on the device, and asks the caller whether to go on.
class Stages
{
  Session& m_session;
  Progress_callback m_progress;
  Call_report& m_report;
  double m_done = 0, m_share = 0;
  bool m_is_in_range = false;

public:
  Stages(Session& session, Progress_callback progress, Call_report& report)
    : m_session(session), m_progress(progress), m_report(report)
  {
    m_session.stages.clear();
  }
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;
  ~Stages() { end_range(); }

  /// \param share of the whole call
  void begin(const char* name, double share)
  {
    end_range();
    record();
    nvtxRangePushA(name); // for profilers
    m_is_in_range = true;
    m_done += m_share;
    m_share = share;
    m_session.stages.push_back({name, 0, 0});
    m_report.stages = m_session.stages.data();
    m_report.number_of_stages = m_session.stages.size();
    ask(0);
  }

  /// Asks the caller, once the device has done what it was given so far.
  /// \param done share of the running stage
  void ask(double done)
  {
    note_memory();
    if (!m_progress.function)
      return;
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(m_session.stream));
    if (!m_progress.function(m_progress.context, (std::min)(1., m_done + done * m_share)))
      throw Cancelled();
  }

  /// After the last stage; waits for the device.
  void end()
  {
    record();
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(m_session.stream));
    for (std::size_t i = 0; i < m_session.stages.size(); ++i)
    {
      float milliseconds = 0;
      CGAL_L0_CUDA_CHECK(
        cudaEventElapsedTime(&milliseconds, m_session.event(i), m_session.event(i + 1)));
      m_session.stages[i].seconds = milliseconds * 1e-3;
    }
  }

private:
  void end_range()
  {
    if (m_is_in_range)
      nvtxRangePop();
    m_is_in_range = false;
  }

  void record()
  {
    note_memory();
    CGAL_L0_CUDA_CHECK(cudaEventRecord(m_session.event(m_session.stages.size()), m_session.stream));
  }

  void note_memory()
  {
    const std::size_t peak = m_session.input_memory.used()
                             + m_session.working_memory.take_peak_of_stage();
    if (!m_session.stages.empty())
    {
      Stage& stage = m_session.stages.back();
      stage.peak_bytes = (std::max)(stage.peak_bytes, peak);
    }
    m_report.peak_bytes = (std::max)(m_report.peak_bytes, m_session.memory_limit.held);
  }
};

/// All stages of a call. The result is left in the session.
void run_stages(Session& session, const Parameters& parameters, Stages& stages,
                Call_report& report);

/// The same for a call that only orients.
void run_orientation(Session& session, const Parameters& parameters, Stages& stages,
                     Call_report& report);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_SESSION_CUH
