// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CUDA_INTERFACE_H
#define CGAL_L0_RESAMPLING_INTERNAL_CUDA_INTERFACE_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the library `CGAL_L0_CUDA` defines and headers call: plain structs, built-in types and no
/// exception cross this border, so that the two sides may be built by different compilers, and
/// users never need that of CUDA.
namespace cuda {

enum class Status
{
  DONE,
  CANCELLED,
  OUT_OF_MEMORY, ///< of the device, or above the caller's limit
  NOT_FINITE,    ///< the solver met a value that is not finite
  NO_DEVICE,     ///< none that can be used: no driver, no device, or code for another one
  DEVICE_FAILED
};

/// How a call ended, and for failures why.
struct Answer
{
  Status status = Status::DONE;
  char message[240] = "";
};

/// One turn of Algorithm 1; energies as in `Iteration_report`.
struct Iteration
{
  double penalty;
  double fit_energy, regularization_energy, normal_energy, sparsity_energy;
  double active_pair_share;
  double relative_residual;
  std::size_t solver_iterations;
  bool regularized;
  bool converged;
};

struct Stage
{
  const char* name; ///< static
  double seconds;   ///< by the device's clock
  std::size_t peak_bytes;
};

/// What a call did; lengths in the unit of the input.
struct Call_report
{
  std::size_t number_of_outliers;
  std::size_t number_of_distinct_points;
  std::size_t number_of_degenerate_neighborhoods;
  std::size_t number_of_lonely_samples;
  std::size_t number_of_unexplained_samples, number_of_unexplained_samples_there;
  double unexplained_center[3], unexplained_radius; ///< in the coordinates of the input
  std::size_t number_of_self_neighbor_pairs;
  double neighbor_radius, least_neighbor_radius, median_neighbor_radius, largest_neighbor_radius;
  double normal_filter_radius, estimated_spacing, estimated_noise, sample_spacing;
  double oriented_share, right_side_share, hinted_share, extent_share;
  std::size_t peak_bytes;

  Stage* stages; ///< owned by the session, valid until its next call
  std::size_t number_of_stages;

  Iteration* iterations; ///< owned by the session, valid until its next call
  std::size_t number_of_iterations;
};

/// Asked now and then, with a share in [0, 1] that never falls; `false` cancels. Must not throw.
struct Progress_callback
{
  bool (*function)(void* context,
                   double share) = nullptr; ///< null for none, which spares the device the waiting
  void* context = nullptr;
};

/// Holds a point set on a device, and the memory to resample it again and again.
struct Session;

/// Whether a device can be used: the answer of a call that would have to.
Answer find_device();

/// \param session out: to be given back by `destroy()`; null unless DONE
Answer create(Session*& session);

void destroy(Session* session) noexcept;

/// Brings points to the device, in place of those it held before.
/// \param points xyz interleaved, finite
/// \param size from 1 to 2^32 - 2
/// \param normals, hints unit or zero vectors, xyz interleaved, or null
/// \param maximum_memory that the session may hold on the device, in bytes; `resample()` has it
/// among its parameters
Answer upload(Session& session, const double* points, std::size_t size, const float* normals,
              const float* hints, std::size_t maximum_memory);

/// Resamples the points of the session. The result stays on the device until the next call.
/// \param parameters checked, in the unit of the input
Answer resample(Session& session, const Parameters& parameters, Progress_callback progress,
                Call_report& report);

/// Brings the result to the host: positions in the coordinates of the input, normals of unit
/// length; xyz interleaved.
Answer download(Session& session, double* positions, float* normals);

/// Numbers of the points of a result, an array each; null for those that are not wanted. Noises and
/// deviations only of a call whose parameters ask for them, their lengths in units of the radius.
struct Values_of_result
{
  float* side_confidences = nullptr; ///< how sure the sides are
  float* scales = nullptr;           ///< 1 for all, where the radius is the same everywhere
  float* noises = nullptr;
  float *position_deviations = nullptr, *normal_deviations = nullptr;
};

/// Brings to the host what `wanted` has arrays for.
Answer download_values(Session& session, const Values_of_result& wanted);

/// Which of the points of the session the last call has left out, ascending, as many as its report
/// says; only of a call whose parameters ask for them. Owned by the session, valid until the next
/// call.
const unsigned* outliers(const Session& session);

/// A sparse matrix in compressed rows.
template <typename FT>
struct Sparse_matrix
{
  long long number_of_rows, number_of_columns;
  const long long* offsets; ///< number_of_rows + 1 entries, the first 0
  const long long* columns; ///< offsets[number_of_rows] entries, ascending in each row
  const FT* values;
};

/// What `solve_least_squares()` did.
struct Least_squares_report
{
  std::size_t iterations;
  double relative_residual; ///< |A^T (b - A x)| / |A^T b|
  double seconds;           ///< by the device's clock, without the way there and back
};

/// Conjugate gradients on the normal equations of min |A x - b|, which are never formed (CGLS), by
/// cuSPARSE and cuBLAS.
/// \param matrix, transposed A and its transpose: a product with a stored transpose is faster, and
/// the same from run to run
/// \param x in: the initial guess; out: the solution, if DONE
Answer solve_least_squares(const Sparse_matrix<float>& matrix,
                           const Sparse_matrix<float>& transposed, const float* rhs,
                           double tolerance, std::size_t maximum_number_of_iterations, float* x,
                           Least_squares_report& report);
Answer solve_least_squares(const Sparse_matrix<double>& matrix,
                           const Sparse_matrix<double>& transposed, const double* rhs,
                           double tolerance, std::size_t maximum_number_of_iterations, double* x,
                           Least_squares_report& report);

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CUDA_INTERFACE_H
