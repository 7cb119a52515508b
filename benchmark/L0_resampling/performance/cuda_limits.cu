// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures what a CUDA device can do at most: bytes a second from its memory and from its cache,
// and operations a second; and how long it takes at least to launch a kernel, to wait for a number,
// and to add up over all threads of a launch. Prints one JSON object.

#include <cooperative_groups.h>
#include <cooperative_groups/reduce.h>
#include <cuda_runtime.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

namespace {

void demand(cudaError_t error)
{
  if (error != cudaSuccess)
    throw std::runtime_error(cudaGetErrorString(error));
}

/// The median of the seconds that what `f` launches takes.
template <typename F>
double seconds_of(const F& f)
{
  cudaEvent_t start, stop;
  demand(cudaEventCreate(&start));
  demand(cudaEventCreate(&stop));
  std::vector<double> seconds;
  for (int i = 0; i < 15; ++i) {
    float milliseconds = 0;
    demand(cudaEventRecord(start));
    f();
    demand(cudaEventRecord(stop));
    demand(cudaEventSynchronize(stop));
    demand(cudaGetLastError());
    demand(cudaEventElapsedTime(&milliseconds, start, stop));
    seconds.push_back(milliseconds * 1e-3);
  }
  demand(cudaEventDestroy(start));
  demand(cudaEventDestroy(stop));
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

/// Every block reads the whole array, from another place on.
__global__ void read_again_and_again(const float4* values, std::size_t size, float* sum)
{
  float own = 0;
  for (std::size_t i = threadIdx.x; i < size; i += blockDim.x) {
    const float4 v = __ldcg(values + (i + blockIdx.x * 4096) % size);
    own += v.x + v.y + v.z + v.w;
  }
  if (own == 12345) // never, but the compiler does not know
    *sum = own;
}

constexpr int operations_of_thread = 4096;

/// \tparam T `float` or `double`
template <typename T>
__global__ void multiply_and_add(T factor, T* sums)
{
  T chains[8];
  for (int c = 0; c < 8; ++c)
    chains[c] = T(threadIdx.x + unsigned(c));
  for (int i = 0; i < operations_of_thread / 8; ++i)
    for (int c = 0; c < 8; ++c)
      chains[c] = chains[c] * factor + factor;
  for (int c = 0; c < 8; ++c)
    if (chains[c] == T(12345))
      *sums = chains[c];
}

template <typename T>
double operations_a_second(unsigned blocks, void* memory)
{
  const double seconds = seconds_of(
    [&]() { multiply_and_add<<<blocks, 256>>>(T(0.999), static_cast<T*>(memory)); });
  return 2. * operations_of_thread * blocks * 256 / seconds;
}

__global__ void do_nothing() {}

/// Seconds from one kernel to the next, which has nothing to do.
double seconds_of_launch()
{
  const int number_of_launches = 1000;
  const double seconds = seconds_of([&]() {
    for (int i = 0; i < number_of_launches; ++i)
      do_nothing<<<1, 32>>>();
  });
  return seconds / number_of_launches;
}

/// Seconds from the end of a kernel to the begin of the next one, if the host reads a number in
/// between.
/// \param number on the device
double seconds_of_read(const int* number, double of_launch)
{
  const int number_of_reads = 200;
  int* staging = nullptr;
  demand(cudaMallocHost(&staging, sizeof(int)));
  const double seconds = seconds_of([&]() {
    for (int i = 0; i < number_of_reads; ++i) {
      do_nothing<<<1, 32>>>();
      demand(cudaMemcpyAsync(staging, number, sizeof(int), cudaMemcpyDeviceToHost));
      demand(cudaStreamSynchronize(nullptr));
    }
  });
  demand(cudaFreeHost(staging));
  return seconds / number_of_reads - of_launch;
}

constexpr unsigned threads_of_sum = 512; // as many as the solver has

/// The sum of two numbers of each thread, again and again: over warps, blocks and the grid, in a
/// fixed order, with one barrier of the grid each time.
/// \param partial_sums two arrays, of two numbers for each block, which take turns
__global__ void __launch_bounds__(threads_of_sum, 2)
  add_up(int times, double2* partial_sums, double* result)
{
  namespace groups = cooperative_groups;
  const auto warp = groups::tiled_partition<32>(groups::this_thread_block());
  __shared__ double2 sums_of_warps[threads_of_sum / 32];
  const auto sum_over_block = [&](double2 values) {
    const groups::plus<double> plus;
    values = {groups::reduce(warp, values.x, plus), groups::reduce(warp, values.y, plus)};
    __syncthreads(); // the last sum has been read
    if (warp.thread_rank() == 0)
      sums_of_warps[warp.meta_group_rank()] = values;
    __syncthreads();
    values = {0, 0};
    if (warp.thread_rank() < warp.meta_group_size())
      values = sums_of_warps[warp.thread_rank()];
    return double2{groups::reduce(warp, values.x, plus), groups::reduce(warp, values.y, plus)};
  };
  double2 values = {1, 2};
  for (int i = 0; i < times; ++i) {
    double2* const partial = partial_sums + (i % 2 == 0 ? 0 : gridDim.x);
    values = sum_over_block(values);
    if (threadIdx.x == 0)
      partial[blockIdx.x] = values;
    groups::this_grid().sync();
    values = {0, 0};
    for (unsigned b = threadIdx.x; b < gridDim.x; b += blockDim.x) {
      const double2 of_block = __ldcg(partial + b);
      values = {values.x + of_block.x, values.y + of_block.y};
    }
    values = sum_over_block(values);
    values = {1 + 1e-9 * values.x, 2}; // so that each waits for the one before
  }
  if (blockIdx.x == 0 && threadIdx.x == 0)
    *result = values.x;
}

/// Seconds of a sum over all threads of a launch that fills the device as the solver's does.
double seconds_of_sum(int number_of_multiprocessors, void* memory)
{
  double* result = static_cast<double*>(memory);
  double2* partial_sums = reinterpret_cast<double2*>(result + 32);
  const auto run = [&](int times) {
    void* arguments[] = {&times, &partial_sums, &result};
    return seconds_of([&]() {
      demand(cudaLaunchCooperativeKernel(reinterpret_cast<void*>(add_up),
                                         dim3(2 * number_of_multiprocessors), dim3(threads_of_sum),
                                         arguments, 0, nullptr));
    });
  };
  return (run(1100) - run(100)) / 1000;
}

} // namespace

int main()
{
  try {
    cudaDeviceProp device;
    demand(cudaGetDeviceProperties(&device, 0));
    const std::size_t bytes = std::size_t(2) << 30, bytes_in_cache = std::size_t(16) << 20;
    char *from = nullptr, *to = nullptr;
    demand(cudaMalloc(&from, bytes));
    demand(cudaMalloc(&to, bytes));
    demand(cudaMemset(from, 1, bytes));
    const double copy = seconds_of(
      [&]() { demand(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice)); });
    const unsigned blocks = unsigned(device.multiProcessorCount) * 8;
    const std::size_t size = bytes_in_cache / sizeof(float4);
    const double reads = seconds_of([&]() {
      read_again_and_again<<<blocks, 256>>>(reinterpret_cast<const float4*>(from), size,
                                            reinterpret_cast<float*>(to));
    });
    const double launch = seconds_of_launch();
    std::cout << "{\"device\": \"" << device.name
              << "\", \"multiprocessors\": " << device.multiProcessorCount
              << ", \"memory_bytes_a_second\": " << 2. * double(bytes) / copy
              << ", \"cache_bytes_a_second\": " << double(bytes_in_cache) * blocks / reads
              << ", \"float_operations_a_second\": " << operations_a_second<float>(blocks * 16, to)
              << ", \"double_operations_a_second\": "
              << operations_a_second<double>(blocks * 16, to) << ", \"launch_seconds\": " << launch
              << ", \"read_seconds\": "
              << seconds_of_read(reinterpret_cast<const int*>(from), launch)
              << ", \"sum_seconds\": " << seconds_of_sum(device.multiProcessorCount, to) << "}"
              << std::endl;
    demand(cudaFree(from));
    demand(cudaFree(to));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "cuda_limits: " << error.what() << "\n";
    return 1;
  }
}
