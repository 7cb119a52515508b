// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "core/cuda_check.cuh"

#include <cublas_v2.h>
#include <cusparse.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

namespace {

using cuda::check;

void check(cusparseStatus_t status, const char* call)
{
  if (status != CUSPARSE_STATUS_SUCCESS)
    throw Failure(status == CUSPARSE_STATUS_ALLOC_FAILED
                      || status == CUSPARSE_STATUS_INSUFFICIENT_RESOURCES
                    ? Status::OUT_OF_MEMORY
                    : Status::DEVICE_FAILED,
                  std::string(call) + ": " + cusparseGetErrorString(status));
}

void check(cublasStatus_t status, const char* call)
{
  if (status != CUBLAS_STATUS_SUCCESS)
    throw Failure(status == CUBLAS_STATUS_ALLOC_FAILED ? Status::OUT_OF_MEMORY
                                                       : Status::DEVICE_FAILED,
                  std::string(call) + ": " + cublasGetStatusString(status));
}

/// Something of CUDA that has to be given back.
template <typename T, auto release>
class Handle
{
  T m_value{};

public:
  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle()
  {
    if (m_value)
      release(m_value);
  }

  T* address() { return &m_value; }
  operator T() const { return m_value; }
};

using Stream = Handle<cudaStream_t, cudaStreamDestroy>;
using Event = Handle<cudaEvent_t, cudaEventDestroy>;
using Sparse_handle = Handle<cusparseHandle_t, cusparseDestroy>;
using Dense_handle = Handle<cublasHandle_t, cublasDestroy>;
using Matrix_descriptor = Handle<cusparseConstSpMatDescr_t, cusparseDestroySpMat>;
using Vector_descriptor = Handle<cusparseDnVecDescr_t, cusparseDestroyDnVec>;

template <typename T>
class Array
{
  Handle<void*, cudaFree> m_data;

public:
  explicit Array(std::size_t count)
  {
    check(cudaMalloc(m_data.address(), count * sizeof(T)), "cudaMalloc");
  }

  Array(const T* from, std::size_t count, cudaStream_t stream) : Array(count)
  {
    check(cudaMemcpyAsync(data(), from, count * sizeof(T), cudaMemcpyHostToDevice, stream),
          "cudaMemcpyAsync");
  }

  T* data() const { return static_cast<T*>(static_cast<void*>(m_data)); }
};

template <typename FT>
constexpr cudaDataType data_type = sizeof(FT) == sizeof(double) ? CUDA_R_64F : CUDA_R_32F;

// BLAS for both number types
void axpy(cublasHandle_t h, std::int64_t n, double a, const double* x, double* y)
{
  check(cublasDaxpy_64(h, n, &a, x, 1, y, 1), "cublasDaxpy");
}
void axpy(cublasHandle_t h, std::int64_t n, float a, const float* x, float* y)
{
  check(cublasSaxpy_64(h, n, &a, x, 1, y, 1), "cublasSaxpy");
}
void scal(cublasHandle_t h, std::int64_t n, double a, double* x)
{
  check(cublasDscal_64(h, n, &a, x, 1), "cublasDscal");
}
void scal(cublasHandle_t h, std::int64_t n, float a, float* x)
{
  check(cublasSscal_64(h, n, &a, x, 1), "cublasSscal");
}
double norm(cublasHandle_t h, std::int64_t n, const double* x)
{
  double result = 0;
  check(cublasDnrm2_64(h, n, x, 1, &result), "cublasDnrm2");
  return result;
}
double norm(cublasHandle_t h, std::int64_t n, const float* x)
{
  float result = 0;
  check(cublasSnrm2_64(h, n, x, 1, &result), "cublasSnrm2");
  return result;
}

/// A vector on the device, as cuSPARSE and cuBLAS see it.
template <typename FT>
struct Vector
{
  std::int64_t size;
  Array<FT> values;
  Vector_descriptor descriptor;

  explicit Vector(std::int64_t n) : size(n), values(std::size_t(n))
  {
    check(cusparseCreateDnVec(descriptor.address(), n, values.data(), data_type<FT>),
          "cusparseCreateDnVec");
  }

  FT* data() const { return values.data(); }
};

/// A matrix on the device, and its product with vectors.
template <typename FT>
class Matrix
{
  cusparseHandle_t m_handle;
  Array<long long> m_offsets, m_columns;
  Array<FT> m_values;
  Matrix_descriptor m_descriptor;
  Handle<void*, cudaFree> m_scratch;

public:
  /// \param x, y vectors of the sizes of those that will be multiplied
  Matrix(const Sparse_matrix<FT>& matrix, cusparseHandle_t handle, const Vector<FT>& x,
         const Vector<FT>& y, cudaStream_t stream)
    : m_handle(handle), m_offsets(matrix.offsets, std::size_t(matrix.number_of_rows) + 1, stream),
      m_columns(matrix.columns, std::size_t(matrix.offsets[matrix.number_of_rows]), stream),
      m_values(matrix.values, std::size_t(matrix.offsets[matrix.number_of_rows]), stream)
  {
    check(cusparseCreateConstCsr(m_descriptor.address(), matrix.number_of_rows,
                                 matrix.number_of_columns, matrix.offsets[matrix.number_of_rows],
                                 m_offsets.data(), m_columns.data(), m_values.data(),
                                 CUSPARSE_INDEX_64I, CUSPARSE_INDEX_64I, CUSPARSE_INDEX_BASE_ZERO,
                                 data_type<FT>),
          "cusparseCreateConstCsr");
    const FT one = 1, zero = 0;
    std::size_t bytes = 0;
    check(cusparseSpMV_bufferSize(m_handle, CUSPARSE_OPERATION_NON_TRANSPOSE, &one, m_descriptor,
                                  x.descriptor, &zero, y.descriptor, data_type<FT>, algorithm,
                                  &bytes),
          "cusparseSpMV_bufferSize");
    if (bytes > 0)
      check(cudaMalloc(m_scratch.address(), bytes), "cudaMalloc");
    check(cusparseSpMV_preprocess(m_handle, CUSPARSE_OPERATION_NON_TRANSPOSE, &one, m_descriptor,
                                  x.descriptor, &zero, y.descriptor, data_type<FT>, algorithm,
                                  m_scratch),
          "cusparseSpMV_preprocess");
  }

  /// y = A x
  void multiply(const Vector<FT>& x, Vector<FT>& y) const
  {
    const FT one = 1, zero = 0;
    check(cusparseSpMV(m_handle, CUSPARSE_OPERATION_NON_TRANSPOSE, &one, m_descriptor, x.descriptor,
                       &zero, y.descriptor, data_type<FT>, algorithm, m_scratch),
          "cusparseSpMV");
  }

private:
  // the one whose result is documented to be bitwise the same from run to run
  static constexpr cusparseSpMVAlg_t algorithm = CUSPARSE_SPMV_CSR_ALG2;
};

template <typename FT>
void solve(const Sparse_matrix<FT>& host_matrix, const Sparse_matrix<FT>& host_transposed,
           const FT* rhs, double tolerance, std::size_t maximum_number_of_iterations, FT* solution,
           Least_squares_report& report)
{
  Stream stream;
  Sparse_handle sparse;
  Dense_handle dense;
  Event start, stop;
  check(cudaStreamCreateWithFlags(stream.address(), cudaStreamNonBlocking),
        "cudaStreamCreateWithFlags");
  check(cusparseCreate(sparse.address()), "cusparseCreate");
  check(cublasCreate(dense.address()), "cublasCreate");
  check(cusparseSetStream(sparse, stream), "cusparseSetStream");
  check(cublasSetStream(dense, stream), "cublasSetStream");
  check(cudaEventCreate(start.address()), "cudaEventCreate");
  check(cudaEventCreate(stop.address()), "cudaEventCreate");

  const std::int64_t rows = host_matrix.number_of_rows, columns = host_matrix.number_of_columns;
  Vector<FT> x(columns), p(columns), s(columns), r(rows), q(rows);
  const Matrix<FT> matrix(host_matrix, sparse, p, q, stream),
    transposed(host_transposed, sparse, r, s, stream);
  check(cudaMemcpyAsync(x.data(), solution, std::size_t(columns) * sizeof(FT),
                        cudaMemcpyHostToDevice, stream),
        "cudaMemcpyAsync");
  check(cudaMemcpyAsync(r.data(), rhs, std::size_t(rows) * sizeof(FT), cudaMemcpyHostToDevice,
                        stream),
        "cudaMemcpyAsync");

  check(cudaEventRecord(start, stream), "cudaEventRecord");
  transposed.multiply(r, s); // A^T b
  const double norm_of_rhs = norm(dense, columns, s.data());
  matrix.multiply(x, q);
  axpy(dense, rows, FT(-1), q.data(), r.data()); // r = b - A x
  transposed.multiply(r, s);                     // s = A^T r
  check(cudaMemcpyAsync(p.data(), s.data(), std::size_t(columns) * sizeof(FT),
                        cudaMemcpyDeviceToDevice, stream),
        "cudaMemcpyAsync");
  double norm_of_s = norm(dense, columns, s.data());
  report.iterations = 0;
  while (norm_of_s > tolerance * norm_of_rhs && report.iterations < maximum_number_of_iterations)
  {
    matrix.multiply(p, q); // q = A p
    const double norm_of_q = norm(dense, rows, q.data());
    if (!(norm_of_q > 0))
      break;
    const double step = norm_of_s / norm_of_q * (norm_of_s / norm_of_q);
    axpy(dense, columns, FT(step), p.data(), x.data()); // x += |s|^2 / |q|^2 p
    axpy(dense, rows, FT(-step), q.data(), r.data());   // r -= |s|^2 / |q|^2 q
    transposed.multiply(r, s);                          // s = A^T r
    const double last_norm_of_s = std::exchange(norm_of_s, norm(dense, columns, s.data()));
    const double ratio = norm_of_s / last_norm_of_s;
    scal(dense, columns, FT(ratio * ratio), p.data());
    axpy(dense, columns, FT(1), s.data(), p.data()); // p = s + |s|^2 / |last s|^2 p
    ++report.iterations;
  }
  check(cudaEventRecord(stop, stream), "cudaEventRecord");
  if (!std::isfinite(norm_of_rhs) || !std::isfinite(norm_of_s))
    throw Failure(Status::NOT_FINITE,
                  "The quadratic problem or its initial guess has values that are not finite.");
  if (norm_of_rhs == 0)
    check(cudaMemsetAsync(x.data(), 0, std::size_t(columns) * sizeof(FT), stream),
          "cudaMemsetAsync");
  check(cudaMemcpyAsync(solution, x.data(), std::size_t(columns) * sizeof(FT),
                        cudaMemcpyDeviceToHost, stream),
        "cudaMemcpyAsync");
  check(cudaStreamSynchronize(stream), "cudaStreamSynchronize");
  report.relative_residual = norm_of_rhs > 0 ? norm_of_s / norm_of_rhs : 0;
  float milliseconds = 0;
  check(cudaEventElapsedTime(&milliseconds, start, stop), "cudaEventElapsedTime");
  report.seconds = milliseconds * 1e-3;
}

template <typename FT>
Answer guarded_solve(const Sparse_matrix<FT>& matrix, const Sparse_matrix<FT>& transposed,
                     const FT* rhs, double tolerance, std::size_t maximum_number_of_iterations,
                     FT* x, Least_squares_report& report)
{
  Answer answer = find_device();
  if (answer.status != Status::DONE)
    return answer;
  try
  {
    solve(matrix, transposed, rhs, tolerance, maximum_number_of_iterations, x, report);
  }
  catch (const Failure& failure)
  {
    answer.status = failure.status();
    std::snprintf(answer.message, sizeof(answer.message), "%s", failure.what());
  }
  catch (const std::exception& error)
  {
    answer.status = Status::DEVICE_FAILED;
    std::snprintf(answer.message, sizeof(answer.message), "%s", error.what());
  }
  return answer;
}

} // namespace

Answer solve_least_squares(const Sparse_matrix<float>& matrix,
                           const Sparse_matrix<float>& transposed, const float* rhs,
                           double tolerance, std::size_t maximum_number_of_iterations, float* x,
                           Least_squares_report& report)
{
  return guarded_solve(matrix, transposed, rhs, tolerance, maximum_number_of_iterations, x, report);
}

Answer solve_least_squares(const Sparse_matrix<double>& matrix,
                           const Sparse_matrix<double>& transposed, const double* rhs,
                           double tolerance, std::size_t maximum_number_of_iterations, double* x,
                           Least_squares_report& report)
{
  return guarded_solve(matrix, transposed, rhs, tolerance, maximum_number_of_iterations, x, report);
}

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
