// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Times the stages on a CUDA device: a mesh is sampled with noise, and its points are resampled
// again and again. Prints one JSON object.

#include "../common/command_line.h"
#include "../common/sample_mesh.h"

#include <CGAL/L0_resampling/CUDA_resampler.h>

#include <nlohmann/json.hpp>

#include <cuda_runtime.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace parameters = CGAL::parameters;
using CGAL::L0_resampling::Method;
using CGAL::L0_resampling::Report;
using Resampler = CGAL::L0_resampling::CUDA_resampler<L0_benchmark::Kernel>;
using Json = nlohmann::ordered_json;

const std::map<std::string, Method> methods = {
  {"default", Method::DEFAULT}, {"lor", Method::LOR}, {"alor", Method::ALOR}};

void demand(cudaError_t error)
{
  if (error != cudaSuccess)
    throw std::runtime_error(cudaGetErrorString(error));
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Median, least and greatest of the seconds that `f` takes by the host's clock.
template <typename F>
Json seconds_of(std::size_t repetitions, const F& f)
{
  using Clock = std::chrono::steady_clock;
  std::vector<double> seconds;
  for (std::size_t i = 0; i < repetitions; ++i) {
    const Clock::time_point start = Clock::now();
    f();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  return {{"median", median(seconds)},
          {"least", *std::min_element(seconds.begin(), seconds.end())},
          {"greatest", *std::max_element(seconds.begin(), seconds.end())}};
}

/// Bytes a second, read and written, of a copy on the device that is much larger than its caches.
double copy_bandwidth()
{
  const std::size_t bytes = std::size_t(2) << 30;
  void *from = nullptr, *to = nullptr;
  cudaEvent_t start, stop;
  demand(cudaMalloc(&from, bytes));
  demand(cudaMalloc(&to, bytes));
  demand(cudaMemset(from, 1, bytes));
  demand(cudaEventCreate(&start));
  demand(cudaEventCreate(&stop));
  std::vector<double> bandwidths;
  for (int i = 0; i < 12; ++i) {
    float milliseconds = 0;
    demand(cudaEventRecord(start));
    demand(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice));
    demand(cudaEventRecord(stop));
    demand(cudaEventSynchronize(stop));
    demand(cudaEventElapsedTime(&milliseconds, start, stop));
    bandwidths.push_back(2. * double(bytes) / (milliseconds * 1e-3));
  }
  demand(cudaEventDestroy(start));
  demand(cudaEventDestroy(stop));
  demand(cudaFree(from));
  demand(cudaFree(to));
  return median(bandwidths);
}

std::string name_of_device()
{
  cudaDeviceProp properties;
  demand(cudaGetDeviceProperties(&properties, 0));
  return properties.name;
}

/// The median over the runs of the seconds of each stage.
class Stage_times
{
  std::vector<std::string> m_names;
  std::vector<std::vector<double>> m_seconds;
  std::vector<std::size_t> m_peak_bytes;

public:
  void add(const Report& report)
  {
    m_names.resize(report.stages.size());
    m_seconds.resize(report.stages.size());
    m_peak_bytes.resize(report.stages.size());
    for (std::size_t s = 0; s < report.stages.size(); ++s) {
      m_names[s] = report.stages[s].name;
      m_seconds[s].push_back(report.stages[s].seconds);
      m_peak_bytes[s] = report.stages[s].peak_bytes;
    }
  }

  Json result() const
  {
    Json stages = Json::array();
    for (std::size_t s = 0; s < m_names.size(); ++s)
      stages.push_back(
        {{"name", m_names[s]}, {"seconds", median(m_seconds[s])}, {"peak_bytes", m_peak_bytes[s]}});
    return stages;
  }
};

} // namespace

int main(int argc, char** argv)
{
  std::string mesh_path, method = "default";
  L0_benchmark::Sampling sampling;
  sampling.noise = 0.5;
  std::size_t m = 0; // points of the result
  double radius_in_spacings = 0, noise_in_spacings = -1;
  std::size_t repetitions = 50;
  bool measures_bandwidth = false;
  CLI::App& app = L0_benchmark::command_line("l0_resample_point_set<CUDA_tag>(), stage by stage");
  app.add_option("mesh", mesh_path, "triangle mesh, OFF")->required()->check(CLI::ExistingFile);
  app.add_option("--points-in", sampling.number_of_points, "points sampled from the mesh")
    ->capture_default_str();
  app.add_option("--noise", sampling.noise, "% of the bounding box's diagonal")
    ->capture_default_str();
  app.add_option("--noise-in-spacings", noise_in_spacings,
                 "in place of --noise: multiples of the spacing of the points, so that clouds of "
                 "any size are alike");
  app.add_option("--points", m, "number of output points")->required();
  app.add_option("--method", method)->check(CLI::IsMember(methods))->capture_default_str();
  app.add_option("--radius-in-spacings", radius_in_spacings,
                 "of the input, for a cost that is linear in its size; 0: the method's rule");
  app.add_option("--repetitions", repetitions)->check(CLI::PositiveNumber)->capture_default_str();
  app.add_flag("--bandwidth", measures_bandwidth, "measure the copy bandwidth of the device too");
  if (const std::optional<int> status = L0_benchmark::read_command_line(app, argc, argv))
    return *status;

  try {
    const L0_benchmark::Triangle_mesh mesh = L0_benchmark::read_triangle_mesh(mesh_path);
    const double spacing = std::sqrt(L0_benchmark::Area_sampler(mesh).area()
                                     / double(sampling.number_of_points));
    if (noise_in_spacings >= 0)
      sampling.noise = 100 * noise_in_spacings * spacing
                       / L0_benchmark::diagonal(L0_benchmark::bounding_box(mesh));
    const std::vector<L0_benchmark::Point_3> points = L0_benchmark::sample_mesh(mesh, sampling);
    Resampler resampler;
    Report report;
    std::vector<std::pair<L0_benchmark::Point_3, L0_benchmark::Vector_3>> resampled;
    const auto np = parameters::resampling_method(methods.at(method))
                      .number_of_output_points(m)
                      .neighbor_radius(radius_in_spacings > 0
                                         ? std::make_optional(radius_in_spacings * spacing)
                                         : std::nullopt)
                      .resampling_report(&report);
    const auto upload = [&]() { resampler.upload(points); };
    const auto resample = [&]() { resampler.resample_on_device(np, report); };
    const auto resample_and_download = [&]() {
      resampled.clear();
      resampler.resample(std::back_inserter(resampled), np);
    };
    for (int i = 0; i < 3; ++i) {
      upload();
      resample_and_download();
    }
    Stage_times stages;
    const Json device_resident = seconds_of(repetitions, [&]() {
      resample();
      stages.add(report);
    });
    const Json host_to_host = seconds_of((std::max)(repetitions / 5, std::size_t(3)), [&]() {
      upload();
      resample_and_download();
    });
    const Json uploading = seconds_of((std::max)(repetitions / 5, std::size_t(3)), upload);
    std::size_t solver_iterations = 0;
    for (const auto& iteration : report.iterations)
      solver_iterations += iteration.solver.iterations;

    Json result = {{"device", name_of_device()},
                   {"mesh", mesh_path},
                   {"noise", sampling.noise},
                   {"points_in", points.size()},
                   {"points_out", m},
                   {"method", method},
                   {"radius_in_spacings", radius_in_spacings},
                   {"repetitions", repetitions},
                   {"device_resident_seconds", device_resident},
                   {"host_to_host_seconds", host_to_host},
                   {"upload_seconds", uploading},
                   {"stages", stages.result()},
                   {"neighbor_radius", report.neighbor_radius},
                   {"number_of_self_neighbor_pairs", report.number_of_self_neighbor_pairs},
                   {"turns", report.iterations.size()},
                   {"solver_iterations", solver_iterations},
                   {"oriented_share", report.oriented_share},
                   {"degenerate_neighborhoods", report.number_of_degenerate_neighborhoods},
                   {"peak_bytes_a_point", double(report.peak_bytes) / double(points.size())}};
    if (measures_bandwidth)
      result["copy_bytes_a_second"] = copy_bandwidth();
    std::cout << result.dump() << std::endl;
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "run_l0_cuda: " << error.what() << "\n";
    return 1;
  }
}
