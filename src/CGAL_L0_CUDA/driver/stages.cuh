// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_STAGES_CUH
#define CGAL_L0_CUDA_STAGES_CUH

#include "search/Cell_grid.cuh"

#include <CGAL/L0_resampling/internal/device/cuda_interface.h>
#include <CGAL/L0_resampling/internal/kernels/side_of_normal.h>
#include <CGAL/L0_resampling/internal/plan/Plan.h>
#include <CGAL/L0_resampling/internal/core/Point_in_cloud.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// Where a stage works: arrays that outlive it come from `arena`, the others from `scratch`.
struct Execution_context
{
  Device_arena& arena;
  Device_arena& scratch;
  cudaStream_t stream;
  int number_of_multiprocessors;
};

/// A number on the device, or a struct of numbers, 0 at first, in the scratch arena.
template <typename T>
class Device_counter
{
  Device_arena& m_scratch;
  T* m_value;
  cudaStream_t m_stream;

public:
  explicit Device_counter(const Execution_context& context)
    : m_scratch(context.scratch), m_value(context.scratch.take<T>(1)), m_stream(context.stream)
  {
    CGAL_L0_CUDA_CHECK(cudaMemsetAsync(m_value, 0, sizeof(T), m_stream));
  }

  T* address() const { return m_value; }

  /// Waits for the device.
  T read() const { return m_scratch.read(m_value, m_stream); }
};

/// Finds the points off the cloud, as `find_outliers()` on the CPU.
/// \param low, high corners of the box of the points
/// \param radius of the ball, at scale 1
/// \param extent of the cloud, outliers left out
/// \param kept out, as many as there are positions: the indices of the others, ascending
/// \returns the number of outliers; if it is 0, `kept` means nothing. Waits for the device
unsigned find_outliers(const Execution_context& context, const Positions& positions,
                       const double (&low)[3], const double (&high)[3], double radius,
                       double extent, const Outlier_thresholds& thresholds, unsigned* kept);

/// Thins points where they crowd, as `thin_crowds()` on the CPU. Waits for the device.
/// \param positions those that `grid` was built of
/// \param size out: the number of points that are kept
/// \param numbers_of_points out, on the device: how many points each one of these stands for
/// \returns which points of the input are kept, in the order of the grid, from the arena; null for
/// all
const unsigned* thin_crowds(const Execution_context& context, const Positions& positions,
                            const Cell_grid& grid, unsigned& size,
                            const unsigned*& numbers_of_points);

/// The field of scales, read at the points.
struct Scales_of_points
{
  const float* scales; // from the arena; null if all are 1
  Range_of_scales range;
};

/// Estimates the field of scales, as `estimate_scale_field()` on the CPU. Waits for the device.
/// \param extent of the points, outliers left out
/// \param usual of the cloud
Scales_of_points estimate_scale_field(const Execution_context& context, const Positions& positions,
                                      double extent, const Reference_scales& usual);

// The normals of the input, Section 3.1. They are float4; the fourth number is the density weight
// 1/v_j in the end.

/// Fits planes to the points in balls of `radius`, and in larger ones where that determines none.
/// \param positions those that `grid` was built of
/// \param numbers_of_points how many points of the input each one stands for; null if only for
/// itself
/// \returns the number of points of the input whose first ball spans no plane
std::size_t estimate_pca_normals(const Execution_context& context, const Positions& positions,
                                 const Cell_grid& grid, const Cell_blocks& blocks, double radius,
                                 bool looks_beyond_strips, const unsigned* numbers_of_points,
                                 float4* normals);

/// Puts given normals in the order of the grid, in place of those of `normals`, where they are not
/// zero.
/// \param normals in and out
void take_given_normals(const Execution_context& context, const Cell_grid& grid,
                        const float* given_normals, float4* normals);

/// Takes some of a list of vectors.
/// \param list `size` indices
void take_listed(const Execution_context& context, const float* vectors, const unsigned* list,
                 unsigned size, float* taken);

/// Whether one of the vectors is zero; waits for the device.
bool has_zero(const Execution_context& context, const float* vectors, unsigned size);

/// What the balls of Eq. (5) hold, counted on the device.
struct Ball_counts
{
  unsigned long long neighbors; // of all points
  unsigned long long
    sparse; // balls that hold fewer than `minimum_number_of_points_of_plane` points
};

/// Eq. (1), (2) for all points, once.
/// \param counts out, on the device, if not null: the balls are counted, and the sum of Eq. (5)
/// goes to the fourth number of each normal
void filter_normals(const Execution_context& context, const Cell_grid& grid,
                    const Cell_blocks& blocks, double radius, float squared_bandwidth,
                    float normal_bandwidth, const float4* normals, float4* filtered,
                    Ball_counts* counts);

/// Corrects filtered normals by the positions, as `refit_normals()` on the CPU.
void refit_normals(const Execution_context& context, const Cell_grid& grid,
                   const Cell_blocks& blocks, const Fit_kernel<double>& kernel,
                   const float4* normals, float4* refitted);

/// The sums of Eq. (5), as `filter_normals()`, where no pass of the filter is run.
void sum_up_input_density(const Execution_context& context, const Cell_grid& grid,
                          const Cell_blocks& blocks, double radius, float squared_bandwidth,
                          float4* normals, Ball_counts* counts);

/// Eq. (5) for the input: turns the sums of Eq. (5) into 1/v_j.
/// \param counts null where sparse points shall not count more than dense ones: all are 1 then
/// \param known_mean mean number of neighbors; 0 if it is that of the counts
void invert_input_density(const Execution_context& context, unsigned size,
                          const Ball_counts* counts, double known_mean, float4* normals);

/// The areas of the surface that points stand for, as `areas_of_points()` on the CPU, to the bit.
struct Areas
{
  const unsigned long long* of_cells; // units of what each point of a cell stands for
  double area_per_unit;
  double total; // of all points
};

/// \param radius of the disk that the points in a ball share
double area_per_unit_of(double radius);

/// Waits for the device. The areas are taken from the arena.
/// \param radius of the disk that the points in a ball share
Areas areas_of_points(const Execution_context& context, const Cell_grid& grid, double radius,
                      unsigned number_of_samples);

/// S, and what the fit term of Eq. (6) ties it to.
struct Samples
{
  unsigned size = 0;
  double* positions = nullptr;     // xyz interleaved, in the frame
  float4* normals = nullptr;       // and a number that a stage may use
  float4* fit = nullptr;           // from the sample to c_i, and W_i; null in the refinement
  Short_vector* outward = nullptr; // as on the CPU; default method only
  unsigned char* are_support_points = nullptr; // as on the CPU; default method only
  float* scales = nullptr;                     // as on the CPU: null if all are 1
  float* spreading_radii = nullptr;  // as on the CPU: null unless the density of the input is kept
  float4* hints = nullptr;           // as on the CPU: null if the caller has none
  unsigned* start_indices = nullptr; // as on the CPU: null if no samples follow others
  float* side_confidences = nullptr; // how sure the sides are, once they are chosen
  float* noises = nullptr;       // of the points of the last fit; null unless they are asked for
  float* noise_ratios = nullptr; // as on the CPU, 1 until they are found; in the refinement only
  Side_after_refinement* sides = nullptr; // likewise
  // as on the CPU: null unless they are asked for; in the order before the refinement
  float *position_deviations = nullptr, *normal_deviations = nullptr;
  // Of a tile of a cloud only: whether the tile keeps them, and the trees of the orientation
  unsigned char* are_own = nullptr;
  unsigned* trees = nullptr;

  Positions in_frame() const { return {positions, size, Frame(), true, nullptr, scales}; }

#ifdef __CUDACC__
  __device__ float scale(unsigned i) const { return Scales_view{scales}[i]; }
  __device__ bool is_own(unsigned i) const { return !are_own || are_own[i]; }
#endif
};

/// Samples that start close to a crowd of others and are not worked on, as on the CPU.
struct Duplicate_samples
{
  unsigned size = 0;
  unsigned* leaders = nullptr;            // of each follower, by the first order of the samples
  double* offsets = nullptr;              // from there to the follower, xyz interleaved
  unsigned char* are_own = nullptr;       // as of samples
  unsigned* numbers_of_samples = nullptr; // of each leader, itself included; null without followers
};

/// Leaves out the samples of crowds but for a few, which the others follow. Waits for the device.
/// \param frame of cells of the radius of the self neighbors, or of levels of spreading radii
/// \returns arrays from the scratch arena
Duplicate_samples take_followers(const Execution_context& context, const Cell_frame& frame,
                                 Samples& samples);

/// Appends the positions of the followers, and what the result has of each point beside.
void append_followers(const Execution_context& context, const Duplicate_samples& followers,
                      Samples& samples);

/// How many of the samples are so, counted on the device; of a tile, its own.
struct Sample_counts
{
  unsigned lonely;      // without an original neighbor, or without a compatible one in the last fit
  unsigned unexplained; // by one sheet with the noise that was estimated
  unsigned oriented, hinted; // surely, and as hints say
  Wide confidence;           // the sum over the samples, in `units_per_confidence`

  /// Confidences, and winding numbers, are added up in fixed point.
  static constexpr double units_per_confidence = 1 << 30;
};

/// What samples may have beside positions, normals and fit.
struct Kinds_of_sample_data
{
  bool of_default_method, scales, spreading_radii, hints, of_tile, noises, deviations;
};

Samples take_samples(Device_arena& arena, unsigned size, const Kinds_of_sample_data& kinds);

/// Puts sample `order[i]` in place `i`, with all that is known of it before sides are found.
void reorder(const Execution_context& context, const unsigned* order, const Samples& samples);

/// Puts the samples in the order that they have when their sides are found, as `order_of_places()`
/// on the CPU: it follows from the set of their places alone. Waits for the device.
/// \param low, high corners of a box that holds the samples, but for a few
/// \param order out, if not null: where each sample was before
void sort_by_places(const Execution_context& context, const double (&low)[3],
                    const double (&high)[3], double cell_size, const Samples& samples,
                    unsigned* order);

/// Keeps those samples only that are listed, in the order of the list.
void keep_listed(const Execution_context& context, const unsigned* list, unsigned size,
                 Samples& samples);

/// Where the samples of a part of a cloud start.
struct Known_starts
{
  const Point_in_cloud* points; // of the session, on the device
  // of the cloud:
  std::size_t number_of_points;  // without outliers, and thinned
  std::size_t number_of_places;  // where these are
  std::size_t number_of_samples; // that were asked for
};

/// What the points hand on to the samples that start on them.
struct Sources_of_samples
{
  const float4* normals;
  const Areas* areas;  // null for none
  bool spreads_evenly; // by area, if there are areas, and not as the points do
  const float* hints;  // in the order of the input, xyz interleaved; null for none
  double maximum_spreading_radius;
  const Known_starts* known; // null if they are to be chosen
};

/// How many samples start on each point of the grid, or near it, as they are chosen.
/// \param areas null if they spread as the points do
/// \param numbers out: one for each point
void count_starts(const Execution_context& context, const Cell_grid& grid, const Areas* areas,
                  unsigned number_of_samples, std::size_t seed, unsigned* numbers);

/// The first S, chosen as the CPU chooses it, or as it is known.
/// \param isolated_radius of the ball around a point that is alone
/// \param spacing of an even set of samples
void initialize_samples(const Execution_context& context, const Positions& positions,
                        const Cell_grid& grid, const Sources_of_samples& points, double radius,
                        double isolated_radius, double spacing, std::size_t seed,
                        const Samples& samples);

/// The fit term of LOR and ALOR: weight and centroid of the original neighbors.
/// \param blocks of `grid` around the cells of `sample_grid`
/// \param numbers_of_samples how many samples each one stands for; null if only for itself
/// \param counts out, on the device; 0 at first
void collapse_fit_term(const Execution_context& context, const Cell_grid& sample_grid,
                       const Cell_blocks& blocks, const Cell_grid& grid, const float4* normals,
                       double radius, const Samples& samples, const unsigned* numbers_of_samples,
                       Sample_counts* counts);

/// As `Range_of_pairs` on the CPU, in `float`.
struct Range_of_pairs
{
  float radius;
  const float *scales, *spreading_radii; // null for none

#ifdef __CUDACC__
  __device__ bool is_one_for_all() const { return !scales && !spreading_radii; }
  __device__ float scale(unsigned i) const { return Scales_view{scales}[i]; }

  /// How far away a neighbor of the sample may be.
  __device__ float limit(unsigned i) const
  {
    const float of_scale = scales ? fminf(radius, scales[i]) : radius;
    return spreading_radii ? fminf(of_scale, spreading_radii[i]) : of_scale;
  }
  /// \param limit_i, limit_k of the samples of the pair
  __device__ static float squared(float limit_i, float limit_k)
  {
    const float range = fminf(limit_i, limit_k);
    return range * range;
  }
#endif
};

/// The self neighbors in compressed rows. Where the row of a sample begins stands in the fourth
/// number of its point, in place of the cell.
struct Neighbor_lists
{
  unsigned* indices = nullptr;
  std::size_t number_of_pairs = 0;

#ifdef __CUDACC__
  /// The place of the first pair of sample i, and that behind its last.
  __device__ uint2 row(const int4* points, unsigned size, unsigned i) const
  {
    return {unsigned(points[i].w),
            i + 1 < size ? unsigned(points[i + 1].w) : unsigned(number_of_pairs)};
  }
#endif
};

/// Waits for the device. The lists are taken from the arena; the points of the grid lose their
/// cells.
/// \param range_of of the samples, in the order of the grid
Neighbor_lists find_self_neighbors(const Execution_context& context, const Cell_grid& grid,
                                   const Range_of_pairs& range_of);

/// What a turn of Algorithm 1 leaves on the device.
struct Turn_result
{
  double fit_energy, regularization_energy, squared_normal_misfit;
  unsigned long long number_of_active_pairs;
  double right_hand_side_scale; // largest norm of a right-hand side, of this turn and those before
  double relative_residual;     // to that
  unsigned solver_iterations, converged;
  unsigned long long is_finite; // as long, so that there is no gap in what is copied
};

/// One vector a sample, each coordinate by itself, so that neighboring threads read neighboring
/// numbers.
struct Vectors
{
  float* values;
  unsigned size;

#ifdef __CUDACC__
  __device__ float3 get(unsigned i) const
  {
    return {values[i], values[std::size_t(size) + i], values[2 * std::size_t(size) + i]};
  }
  __device__ void set(unsigned i, float3 v) const
  {
    values[i] = v.x;
    values[std::size_t(size) + i] = v.y;
    values[2 * std::size_t(size) + i] = v.z;
  }
#endif
};

/// The arrays of a turn; they keep their place from turn to turn.
struct Turn_arrays
{
  float4* directions[2]; // of this step and of the next
  Vectors r;
  float* blocks;
  double* partial_sums;
};

/// From the scratch arena.
Turn_arrays take_turn_arrays(const Execution_context& context, unsigned number_of_samples);

/// One turn of Algorithm 1: moves the samples, in `samples` and in the points of `grid`, to the
/// minimum of Eq. (10).
/// \param samples in the order of `grid`
/// \param last_result of the turn before this one, on the device; null if there is none
void minimize_once(const Execution_context& context, const Minimization_parameters& parameters,
                   const Turn& of_plan, const Neighbor_lists& neighbors, const Cell_grid& grid,
                   const Samples& samples, const Turn_arrays& arrays,
                   const Turn_result* last_result, Turn_result* result);

// The default method

/// What a fit is to tell of the samples, on the device; null for what nobody asks.
struct Outcomes_of_fit
{
  Sample_counts* counts = nullptr;          // in and out: lonely and unexplained samples add up
  unsigned char* are_unexplained = nullptr; // out, for each sample
};

/// The fit to compatible points; normals of the samples change, and have the variance of the fit as
/// their fourth number.
/// \param sample_grid of the same cells as `grid`
/// \param is_in_order whether the samples are in the order of their grid
void fit_compatible_points(const Execution_context& context, const Cell_grid& sample_grid,
                           bool is_in_order, const Cell_blocks& blocks, const Cell_grid& grid,
                           const float4* normals, const Fit_kernel<double>& kernel,
                           const Samples& samples, const Outcomes_of_fit& outcomes);

/// A sample, and how many there are within a radius, itself included.
struct Crowded_sample
{
  double position[3] = {0, 0, 0};
  unsigned number_of_samples = 0;
};

/// Of the listed samples, and of a tile of its own ones, the one that has most of the listed within
/// `radius`, as `most_crowded_place()` on the CPU; of none, one without samples. Waits for the
/// device.
/// \param are_listed a flag for each sample
/// \param low, high corners of the box of the points
Crowded_sample most_crowded_sample(const Execution_context& context, const Samples& samples,
                                   const unsigned char* are_listed, const double (&low)[3],
                                   const double (&high)[3], double radius);

/// Spreads the samples within the surface, by steps that the radius of the fit limits. The points
/// of the grid are used up.
/// \param places the points of the grid when the neighbors were found
/// \param range of the neighbors, there
void repel_tangentially(const Execution_context& context, const Cell_grid& sample_grid,
                        const Neighbor_lists& neighbors, const int4* places, double range,
                        double spacing, double radius, std::size_t number_of_steps,
                        const Samples& samples);

/// Moves the samples to what they were fitted to.
void take_fitted_positions(const Execution_context& context, const Samples& samples);

/// Moves the samples onto quadrics, as `project_to_local_quadrics()` on the CPU. Waits for the
/// device.
/// \param frame of cells half as large as the ball
void project_to_local_quadrics(const Execution_context& context, const Cell_frame& frame,
                               const Fit_kernel<double>& kernel, const Samples& samples);

/// What the caller says of the sides that normals point to, as on the CPU. Samples may have hints
/// of their own besides.
struct Side_hints
{
  bool has_viewpoint;  // of all samples
  Viewpoint viewpoint; // in the frame
  bool are_viewpoints; // whether this, or what the samples have, is what they were seen from

#ifdef __CUDACC__
  /// A unit vector, or zero.
  __device__ double3 direction_of(const Samples& samples, std::size_t i) const
  {
    if (samples.hints)
      return to_double(xyz(samples.hints[i]));
    if (!has_viewpoint)
      return {0, 0, 0};
    double direction[3];
    viewpoint.find_direction(samples.positions + 3 * i, direction);
    return {direction[0], direction[1], direction[2]};
  }

  struct Viewpoint_cosine
  {
    bool is_known;
    double value; // 0 if it is not known
  };
  /// Of the angle between the normal and the direction to what the sample was seen from.
  __device__ Viewpoint_cosine viewpoint_cosine(const Samples& samples, std::size_t i) const
  {
    const double3 direction = are_viewpoints ? direction_of(samples, i) : double3{0, 0, 0};
    return {dot(direction, direction) > 0, dot(to_double(xyz(samples.normals[i])), direction)};
  }
  __device__ int certain_side_of(const Samples& samples, std::size_t i) const
  {
    return certain_side(viewpoint_cosine(samples, i).value);
  }
#endif
};

/// Turns the normals of the samples to one side: that of viewpoints and hints where these are
/// clear, else outwards.
/// \param low, high corners of a box that holds the samples, but for a few
/// \param counts out, on the device: what `orient_normals()` on the CPU returns; 0 at first
void orient_normals(const Execution_context& context, const double (&low)[3],
                    const double (&high)[3], unsigned number_of_neighbors, double spacing,
                    const Side_hints& hints, const Samples& samples, Sample_counts* counts);

/// Takes the positions of the samples out of the frame, and puts their normals, xyz interleaved, in
/// the place of the fit.
void leave_frame(const Execution_context& context, const Frame& frame, const Samples& samples);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_STAGES_CUH
