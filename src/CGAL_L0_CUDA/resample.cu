// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Extent.cuh"
#include "plane_fits.cuh"
#include "stages.cuh"

#include <CGAL/L0_resampling/internal/Parameters.h>
#include <CGAL/L0_resampling/internal/cuda_interface.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

/// Thrown once the caller wants no more; never leaves the library.
struct Cancelled {};

constexpr double pi = 3.141592653589793;

double square(double x) { return x * x; }

/// As `sensible_radius()` on the CPU, for a bounding box.
double sensible_radius(double radius, const double (&low)[3], const double (&high)[3])
{
  const double x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2], diagonal = std::sqrt(x * x + y * y + z * z);
  if (!(diagonal > 0))
    return 1;
  return (std::min)((std::max)(radius, std::ldexp(diagonal, -200)), diagonal);
}

double normal_bandwidth(double angle) { return (std::max)(square(1 - std::cos(angle * pi / 180)), 1e-12); }

/// The lengths of a call, in its frame; as on the CPU.
struct Lengths
{
  Frame frame;
  double low[3], high[3];   // bounding box of the points
  double radius, filter_radius, self_neighbor_radius, sample_spacing, cell_size, smallest_cell_size;

  /// Scales frame and box so that `r`, a length in the frame, comes to lie in [1, 2).
  /// \returns the factor
  double scale_to(double r)
  {
    const double scale = frame.scale_to(r);
    for (double* corner : {low, high})
      for (int axis = 0; axis < 3; ++axis)
        corner[axis] *= scale;
    return scale;
  }
};

/// Chooses the lengths that the caller left open, as the CPU does.
/// \param scales_in called with the frame of the paper's radius, and that radius there, if spacing and noise of the points are wanted
template <typename Scales_in>
Lengths choose_lengths(const Extent& extent, unsigned n, const Parameters& parameters, const Scales_in& scales_in, Call_report& report)
{
  const bool is_default = parameters.method == Method::DEFAULT;
  const double m = double(parameters.number_of_output_points);
  Lengths lengths;
  lengths.frame = extent.frame;
  std::copy(extent.low, extent.low + 3, lengths.low);
  std::copy(extent.high, extent.high + 3, lengths.high);
  const double paper_radius = sensible_radius(extent.robust_diagonal / std::cbrt(double(n)), lengths.low, lengths.high);
  double diagonal = extent.robust_diagonal * lengths.scale_to(paper_radius);
  lengths.radius = std::ldexp(paper_radius, -std::ilogb(paper_radius));
  lengths.sample_spacing = diagonal / std::sqrt(m);
  if (is_default)
  {
    const Scales scales = scales_in(lengths);
    lengths.radius = std::hypot(radius_per_spacing * scales.spacing, radius_per_noise * scales.noise);
    lengths.sample_spacing = scales.spacing * std::sqrt(n / m);
    report.estimated_spacing = lengths.frame.length_of_input(scales.spacing);
    report.estimated_noise = lengths.frame.length_of_input(scales.noise);
  }
  if (parameters.neighbor_radius > 0)
    lengths.radius = lengths.frame.length_in_frame(parameters.neighbor_radius);
  lengths.radius = sensible_radius(lengths.radius, lengths.low, lengths.high);

  const double scale = lengths.scale_to(lengths.radius);
  lengths.radius *= scale;
  lengths.sample_spacing *= scale;
  lengths.filter_radius = parameters.normal_filter_radius > 0
    ? sensible_radius(lengths.frame.length_in_frame(parameters.normal_filter_radius), lengths.low, lengths.high)
    : (is_default ? default_filter_radius_factor : 1.) * lengths.radius;
  lengths.self_neighbor_radius = is_default ? (std::min)(self_neighbor_radius_per_spacing * lengths.sample_spacing, lengths.radius)
                                            : self_neighbor_radius_factor * lengths.radius;
  lengths.smallest_cell_size = std::ldexp(diagonal * scale, -18);
  lengths.cell_size = (std::max)(lengths.filter_radius > lengths.radius ? lengths.filter_radius / 2 : lengths.radius,
                                 lengths.smallest_cell_size);
  report.neighbor_radius = lengths.frame.length_of_input(lengths.radius);
  report.normal_filter_radius = lengths.frame.length_of_input(lengths.filter_radius);
  return lengths;
}

/// Restores the caller's device at the end of a call.
class Device_scope
{
  int m_previous = 0;

public:
  explicit Device_scope(int device)
  {
    CGAL_L0_CUDA_CHECK(cudaGetDevice(&m_previous));
    CGAL_L0_CUDA_CHECK(cudaSetDevice(device));
  }
  Device_scope(const Device_scope&) = delete;
  Device_scope& operator=(const Device_scope&) = delete;
  ~Device_scope() { cudaSetDevice(m_previous); }
};

__global__ void do_nothing() {}

/// \returns the caller's device, once a kernel of ours has run there
int usable_device()
{
  int count = 0, device = 0;
  CGAL_L0_CUDA_CHECK(cudaGetDeviceCount(&count));
  if (count == 0)
    throw Failure(Status::NO_DEVICE, "cudaGetDeviceCount: there is no device");
  CGAL_L0_CUDA_CHECK(cudaGetDevice(&device));
  cudaFuncAttributes attributes;
  CGAL_L0_CUDA_CHECK(cudaFuncGetAttributes(&attributes, do_nothing));
  int is_cooperative = 0;
  CGAL_L0_CUDA_CHECK(cudaDeviceGetAttribute(&is_cooperative, cudaDevAttrCooperativeLaunch, device));
  if (!is_cooperative)
    throw Failure(Status::NO_DEVICE, "the device has no cooperative launches");
  return device;
}

} // namespace

struct Session
{
  std::mutex mutex;
  int device;
  bool is_broken = false;            // after an error of a kernel no call of this process will work
  cudaStream_t stream = nullptr;
  int number_of_multiprocessors = 0;
  Memory_limit memory_limit{(std::numeric_limits<std::size_t>::max)()};
  Device_arena input{memory_limit}, arena{memory_limit}, scratch{memory_limit};

  unsigned size = 0;
  const double* points = nullptr;
  const float* normals = nullptr;    // null if none were given
  bool all_normals_given = false;
  Extent extent;
  bool has_scales = false;
  Scales scales;                     // of the points, in the frame of the paper's radius; found when first wanted

  unsigned number_of_samples = 0;
  double* positions = nullptr;       // the result, at the bottom of the arena
  float* sample_normals = nullptr;
  std::vector<Iteration> iterations;
  std::vector<cudaEvent_t> events;

  explicit Session(int d) : device(d)
  {
    CGAL_L0_CUDA_CHECK(cudaDeviceGetAttribute(&number_of_multiprocessors, cudaDevAttrMultiProcessorCount, device));
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

  Workplace workplace() { return {arena, scratch, stream, number_of_multiprocessors}; }

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

namespace {

/// Names the stages, times them on the device, and asks the caller whether to go on.
class Stages
{
  Session& m_session;
  Progress_callback m_progress;
  Call_report& m_report;
  double m_done = 0, m_share = 0;

public:
  Stages(Session& session, Progress_callback progress, Call_report& report) : m_session(session), m_progress(progress), m_report(report) {}

  /// \param share of the whole call
  void begin(const char* name, double share)
  {
    record();
    m_done += m_share;
    m_share = share;
    m_report.stages[m_report.number_of_stages++] = {name, 0, 0};
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
    for (std::size_t i = 0; i < m_report.number_of_stages; ++i)
    {
      float milliseconds = 0;
      CGAL_L0_CUDA_CHECK(cudaEventElapsedTime(&milliseconds, m_session.event(i), m_session.event(i + 1)));
      m_report.stages[i].seconds = milliseconds * 1e-3;
    }
  }

private:
  void record()
  {
    note_memory();
    CGAL_L0_CUDA_CHECK(cudaEventRecord(m_session.event(m_report.number_of_stages), m_session.stream));
  }

  void note_memory()
  {
    if (m_report.number_of_stages > 0)
      m_report.stages[m_report.number_of_stages - 1].peak_bytes = m_session.memory_limit.held;
    m_report.peak_bytes = (std::max)(m_report.peak_bytes, m_session.memory_limit.held);
  }
};

Iteration iteration_report(const Parameters& parameters, const Minimization& minimization, double penalty, bool regularized,
                           std::size_t number_of_pairs, const Turn_result& result)
{
  const double unit = 1 / minimization.squared_radius;
  return {penalty, result.fit_energy * unit, result.regularization_energy * unit, penalty * result.squared_normal_misfit * unit,
          parameters.normal_weight * square(minimization.sparsity_unit) * double(result.number_of_active_pairs) * unit,
          number_of_pairs ? double(result.number_of_active_pairs) / double(number_of_pairs) : 0,
          result.relative_residual, result.solver_iterations, regularized, bool(result.converged)};
}

std::vector<double> penalties(const Parameters& parameters)
{
  std::vector<double> values;
  double penalty = parameters.initial_penalty;
  do
  {
    values.push_back(penalty);
    penalty *= parameters.penalty_growth;
  } while (penalty <= parameters.maximum_penalty);
  return values;
}

/// Bytes of the two stacks for n points and m samples with as many neighbors as is usual; what is missing is added on the way, once.
struct Memory_estimate { std::size_t arena, scratch; };
Memory_estimate estimate_memory(std::size_t n, std::size_t m, bool is_default)
{
  const std::size_t slack = std::size_t(1) << 20;
  const std::size_t of_points = 42 * n, of_sample_grid = 36 * m, of_neighbors = is_default ? 96 * m : 64 * m, of_graph = 120 * m;
  const std::size_t arena = is_default ? 72 * m + (std::max)(of_points + of_sample_grid + of_neighbors, of_graph)
                                       : 56 * m + (std::max)({of_points + of_sample_grid, of_sample_grid + of_neighbors, of_graph});
  return {arena + slack, (std::max)(50 * n, is_default ? 190 * m : 164 * m) + slack};
}

/// What a call carries from stage to stage.
struct Call
{
  const Parameters& parameters;
  Workplace workplace;
  Stages& stages;
  Call_report& report;
  Lengths lengths;
  Minimization minimization;
  std::vector<double> penalties;
  Turn_result* turn_results;                  // on the device, one for each penalty
  std::vector<std::size_t> numbers_of_pairs;  // of self neighbors, one for each penalty
  Samples samples;

  Positions sample_positions() const { return {samples.positions, samples.size, Frame(), true}; }

  /// Sorts the samples into cells, and puts them in that order.
  Cell_grid sort_samples(const Cell_frame& frame)
  {
    const Cell_grid grid = build_grid(sample_positions(), nullptr, frame, workplace.arena, workplace.scratch, workplace.stream);
    reorder(workplace, grid.order, samples);
    return grid;
  }

  Cell_frame self_frame(double cell_size) const
  {
    return Cell_frame::around(lengths.low, lengths.high, cell_size, lengths.self_neighbor_radius);
  }
};

/// The input points with all that the stages find out about them.
struct Prepared_points
{
  Cell_grid grid;
  float4* normals;             // filtered, and 1/v_j
};

/// Section 3.1 and Eq. (5): normals and density weights of the input.
Prepared_points prepare_points(Session& session, Call& call, const Positions& positions)
{
  const Workplace& workplace = call.workplace;
  const Lengths& lengths = call.lengths;
  const Parameters& parameters = call.parameters;
  const double longest_query = (std::max)(lengths.radius, lengths.filter_radius);
  Prepared_points points;
  points.grid = build_grid(positions, session.normals, Cell_frame::around(lengths.low, lengths.high, lengths.cell_size, longest_query),
                           workplace.arena, workplace.scratch, workplace.stream);
  call.report.number_of_distinct_points = points.grid.number_of_distinct;
  points.normals = workplace.arena.take<float4>(points.grid.size);

  const Arena_scope scope(workplace.scratch);
  float4 *normals = points.normals, *filtered = workplace.scratch.take<float4>(points.grid.size);
  const auto blocks_for_radius = [&](double radius) {
    return find_blocks(points.grid, points.grid, cells_in_reach(radius, lengths.cell_size), maximum_number_of_candidates, workplace.scratch,
                       workplace.stream);
  };
  const Cell_blocks filter_blocks = blocks_for_radius(lengths.filter_radius);
  if (!session.all_normals_given)
  {
    call.stages.begin("PCA normals", 0.1);
    const double pca_radius = pca_radius_factor * lengths.radius;
    const bool shares_blocks = cells_in_reach(pca_radius, lengths.cell_size) == cells_in_reach(lengths.filter_radius, lengths.cell_size);
    call.report.number_of_degenerate_neighborhoods =
      estimate_pca_normals(workplace, positions, points.grid, shares_blocks ? filter_blocks : blocks_for_radius(pca_radius), pca_radius, normals);
  }
  if (session.normals)
    take_given_normals(workplace, points.grid, session.normals, normals);

  call.stages.begin("filter normals", 0.4);
  const float squared_bandwidth = float(call.minimization.squared_bandwidth);
  const auto bandwidth = [&](double factor) { return float(normal_bandwidth(factor * parameters.sharpness_angle)); };
  const std::size_t number_of_passes = parameters.number_of_normal_filter_iterations;
  const std::size_t number_of_refits = parameters.method == Method::DEFAULT ? (std::min)(number_of_normal_refits, number_of_passes) : 0;
  for (std::size_t i = 0; i < number_of_passes; ++i)
  {
    if (i + number_of_refits >= number_of_passes)
    {
      refit_normals(workplace, points.grid, filter_blocks, lengths.filter_radius, squared_bandwidth, bandwidth(fit_angle_factor), normals,
                    filtered);
      std::swap(normals, filtered);
    }
    filter_normals(workplace, points.grid, filter_blocks, lengths.filter_radius, squared_bandwidth, bandwidth(1), normals, filtered);
    std::swap(normals, filtered);
    call.stages.ask(double(i + 1) / double(number_of_passes));
  }
  if (normals != points.normals)
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(points.normals, normals, points.grid.size * sizeof(float4), cudaMemcpyDeviceToDevice,
                                       workplace.stream));

  call.stages.begin("density weights", 0.08);
  compute_input_density_weights(workplace, points.grid, filter_blocks, lengths.filter_radius, squared_bandwidth, points.normals);
  return points;
}

/// Section 3.2: the fit term of LOR and ALOR, collapsed.
void fit_to_all_points(Call& call, const Prepared_points& points)
{
  const Workplace& workplace = call.workplace;
  call.stages.begin("original neighbors", 0.1);
  const Arena_scope scope(workplace.arena);
  const Cell_grid sample_grid =
    build_grid(call.sample_positions(), nullptr, points.grid.frame, workplace.arena, workplace.scratch, workplace.stream);
  const Cell_blocks blocks = find_blocks(sample_grid, points.grid, cells_in_reach(call.lengths.radius, call.lengths.cell_size),
                                         maximum_number_of_candidates, workplace.arena, workplace.stream);
  call.report.number_of_lonely_samples =
    collapse_fit_term(workplace, sample_grid, blocks, points.grid, points.normals, call.lengths.radius, call.samples);
}

/// Section 3.3: Algorithm 1, with the self neighbors of the start.
void minimize_alternatingly(Call& call)
{
  const Workplace& workplace = call.workplace;
  call.stages.begin("self neighbors", 0.03);
  const Cell_grid grid = call.sort_samples(call.self_frame((std::max)(call.lengths.self_neighbor_radius, call.lengths.smallest_cell_size)));
  const Neighbor_lists neighbors = find_self_neighbors(workplace, grid, call.lengths.self_neighbor_radius);
  call.report.number_of_self_neighbor_pairs = neighbors.number_of_pairs;
  call.numbers_of_pairs.assign(call.penalties.size(), neighbors.number_of_pairs);

  call.stages.begin("L0 minimization", 0.12);
  const Arena_scope scope(workplace.scratch);
  const Turn_arrays arrays = take_turn_arrays(workplace, call.samples.size, neighbors.number_of_pairs);
  for (std::size_t i = 0; i < call.penalties.size(); ++i)
  {
    const bool regularize = call.parameters.method != Method::ALOR || i % 2 == 0;
    minimize_once(workplace, call.minimization, call.penalties[i], regularize, neighbors, grid, call.samples, arrays, call.turn_results + i);
    call.stages.ask(double(i + 1) / double(call.penalties.size()));
  }
}

/// Algorithm 1 as the default method runs it, see `minimize_with_refinement()` on the CPU.
void minimize_with_refinement(Call& call, const Prepared_points& points)
{
  const Workplace& workplace = call.workplace;
  const Lengths& lengths = call.lengths;
  const double bandwidth = normal_bandwidth(fit_angle_factor * call.parameters.sharpness_angle);
  const int reach = cells_in_reach(lengths.radius, lengths.cell_size);
  const bool one_grid_is_enough = lengths.self_neighbor_radius <= lengths.cell_size;
  const Cell_frame self_frame = one_grid_is_enough ? points.grid.frame : call.self_frame(lengths.self_neighbor_radius);
  const auto fit = [&](const Cell_grid& sample_grid, bool is_in_order) {
    const Cell_blocks blocks = find_blocks(sample_grid, points.grid, reach, maximum_number_of_candidates, workplace.arena, workplace.stream);
    fit_compatible_points(workplace, sample_grid, is_in_order, blocks, points.grid, points.normals, lengths.radius, bandwidth, call.samples);
  };
  const auto fit_in_cells_of_points = [&]() {
    const Arena_scope scope(workplace.arena);
    fit(build_grid(call.sample_positions(), nullptr, points.grid.frame, workplace.arena, workplace.scratch, workplace.stream), false);
  };

  call.stages.begin("L0 minimization", 0.35);
  for (std::size_t i = 0; i < call.penalties.size(); ++i)
  {
    const Arena_scope scope(workplace.arena);
    const Cell_grid grid = call.sort_samples(self_frame);
    if (one_grid_is_enough)
      fit(grid, true);
    else
      fit_in_cells_of_points();
    const Neighbor_lists neighbors = find_self_neighbors(workplace, grid, lengths.self_neighbor_radius);
    call.report.number_of_self_neighbor_pairs = neighbors.number_of_pairs;
    call.numbers_of_pairs.push_back(neighbors.number_of_pairs);
    {
      const Arena_scope turn_scope(workplace.scratch);
      const Turn_arrays arrays = take_turn_arrays(workplace, call.samples.size, neighbors.number_of_pairs);
      minimize_once(workplace, call.minimization, call.penalties[i], true, neighbors, grid, call.samples, arrays, call.turn_results + i);
    }
    repel_tangentially(workplace, grid, neighbors, lengths.sample_spacing, lengths.radius, number_of_repulsion_steps, call.samples);
    call.stages.ask(double(i + 1) / double(call.penalties.size()));
  }
  fit_in_cells_of_points();
  take_fitted_positions(workplace, call.samples);
}

/// The stages of the paper, one after the other.
void run(Session& session, const Parameters& parameters, Stages& stages, Call_report& report)
{
  const unsigned n = session.size, m = unsigned(parameters.number_of_output_points);
  const bool is_default = parameters.method == Method::DEFAULT;
  session.number_of_samples = 0;
  const Memory_estimate estimate = estimate_memory(n, m, is_default);
  session.arena.reserve(estimate.arena);
  session.scratch.reserve(estimate.scratch);
  const Workplace workplace = session.workplace();

  stages.begin("sort points", 0.05);
  const auto scales_in = [&](const Lengths& lengths) {
    if (!session.has_scales)
      session.scales = estimate_scales(workplace, {session.points, n, lengths.frame, false}, lengths.low, lengths.high, lengths.radius);
    session.has_scales = true;
    return session.scales;
  };
  const Lengths lengths = choose_lengths(session.extent, n, parameters, scales_in, report);
  Call call = {parameters, workplace, stages, report, lengths,
               {square(lengths.radius), square(spatial_bandwidth_factor * lengths.filter_radius), sparsity_unit_factor * lengths.radius,
                parameters.normal_weight, parameters.regularization_weight},
               penalties(parameters), nullptr, {}, Samples()};
  std::vector<Turn_result> results(call.penalties.size());
  call.turn_results = session.arena.take<Turn_result>(results.size());
  call.samples = take_samples(session.arena, m, is_default);
  {
    const Arena_scope points_scope(session.arena);
    const Positions positions = {session.points, n, lengths.frame, false};
    const Prepared_points points = prepare_points(session, call, positions);
    stages.begin("initial samples", 0.02);
    initialize_samples(workplace, positions, points.grid, points.normals, lengths.radius, parameters.random_seed, call.samples);
    if (is_default)
      minimize_with_refinement(call, points);
    else
      fit_to_all_points(call, points);
  }
  if (!is_default)
    minimize_alternatingly(call);
  CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(results.data(), call.turn_results, results.size() * sizeof(Turn_result), cudaMemcpyDeviceToHost,
                                     session.stream));

  stages.begin("orient normals", 0.1);
  report.oriented_share = orient_normals(workplace, lengths.low, lengths.high, unsigned(parameters.number_of_orientation_neighbors),
                                         lengths.sample_spacing, call.samples);
  leave_frame(workplace, lengths.frame, call.samples);
  stages.end();

  session.iterations.clear();
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    if (!results[i].is_finite)
      throw Failure(Status::NOT_FINITE, "The quadratic problem or its initial guess has values that are not finite.");
    const bool regularized = parameters.method != Method::ALOR || i % 2 == 0;
    session.iterations.push_back(iteration_report(parameters, call.minimization, call.penalties[i], regularized,
                                                  call.numbers_of_pairs[i], results[i]));
  }
  report.iterations = session.iterations.data();
  report.number_of_iterations = session.iterations.size();
  session.positions = call.samples.positions;
  session.sample_normals = reinterpret_cast<float*>(call.samples.fit);
  session.number_of_samples = m;
}

Answer answer(Status status, const char* message)
{
  Answer result;
  result.status = status;
  std::snprintf(result.message, sizeof(result.message), "%s", message);
  return result;
}

/// Runs `f`, and turns what it throws into an answer.
template <typename F>
Answer guarded(Session* session, const F& f)
{
  try
  {
    if (!session)
    {
      f();
      return Answer();
    }
    const std::lock_guard<std::mutex> lock(session->mutex);
    if (session->is_broken)
      return answer(Status::DEVICE_FAILED, "the device failed in an earlier call");
    const Device_scope device(session->device);
    try
    {
      f();
    }
    catch (const Failure& failure)
    {
      // Only an error of a kernel outlives its call, and shows in the next one.
      session->is_broken = cudaStreamSynchronize(session->stream) != cudaSuccess;
      cudaGetLastError();
      if (failure.status() == Status::OUT_OF_MEMORY)
      {
        session->arena.free_all();
        session->scratch.free_all();
        session->number_of_samples = 0;
      }
      throw;
    }
    return Answer();
  }
  catch (const Cancelled&) { return answer(Status::CANCELLED, ""); }
  catch (const Failure& failure) { return answer(failure.status(), failure.what()); }
  catch (const std::bad_alloc&) { return answer(Status::OUT_OF_MEMORY, "the host has no memory"); }
  catch (const std::exception& error) { return answer(Status::DEVICE_FAILED, error.what()); }
}

} // namespace

Answer find_device()
{
  return guarded(nullptr, []() { usable_device(); });
}

Answer create(Session*& session)
{
  session = nullptr;
  return guarded(nullptr, [&]() { session = std::make_unique<Session>(usable_device()).release(); });
}

void destroy(Session* session) noexcept
{
  if (!session)
    return;
  int previous = 0;
  const bool has_previous = cudaGetDevice(&previous) == cudaSuccess;
  cudaSetDevice(session->device);
  delete session;
  if (has_previous)
    cudaSetDevice(previous);
  cudaGetLastError();
}

Answer upload(Session& session, const double* points, std::size_t size, const float* normals, std::size_t maximum_memory)
{
  return guarded(&session, [&]() {
    session.size = 0;
    session.has_scales = false;
    session.number_of_samples = 0;
    session.memory_limit.limit = maximum_memory;
    const std::size_t bytes_of_points = 3 * sizeof(double) * size, bytes_of_normals = normals ? 3 * sizeof(float) * size : 0;
    session.input.reserve(bytes_of_points + bytes_of_normals + 1024);
    double* const device_points = session.input.take<double>(3 * size);
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(device_points, points, bytes_of_points, cudaMemcpyHostToDevice, session.stream));
    session.points = device_points;
    session.normals = nullptr;
    session.all_normals_given = false;
    session.scratch.reserve(34 * size + (std::size_t(1) << 20));
    if (normals)
    {
      float* const device_normals = session.input.take<float>(3 * size);
      CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(device_normals, normals, bytes_of_normals, cudaMemcpyHostToDevice, session.stream));
      session.normals = device_normals;
      session.all_normals_given = !has_zero(session.workplace(), device_normals, unsigned(size));
    }
    session.extent = find_extent(session.workplace(), device_points, unsigned(size));
    session.size = unsigned(size);
  });
}

Answer resample(Session& session, const Parameters& parameters, Progress_callback progress, Call_report& report)
{
  report = Call_report();
  return guarded(&session, [&]() {
    if (session.size == 0)
      throw Failure(Status::DEVICE_FAILED, "there are no points on the device");
    session.memory_limit.limit = parameters.maximum_memory;
    Stages stages(session, progress, report);
    run(session, parameters, stages, report);
  });
}

Answer download(Session& session, double* positions, float* normals)
{
  return guarded(&session, [&]() {
    const std::size_t m = session.number_of_samples;
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(positions, session.positions, 3 * m * sizeof(double), cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(cudaMemcpyAsync(normals, session.sample_normals, 3 * m * sizeof(float), cudaMemcpyDeviceToHost, session.stream));
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(session.stream));
  });
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
