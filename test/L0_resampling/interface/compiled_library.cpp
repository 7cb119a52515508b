// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes results to the last bit. Built twice, with the compiled library and from headers alone:
// the test compares what the two programs write.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_ply_points.h>
#include <CGAL/L0_resampling/Eigen_cholesky_solver_traits.h>
#include <CGAL/l0_resample_point_set.h>

#include <cstdlib>
#include <fstream>
#include <ios>
#include <iostream>
#include <iterator>
#include <utility>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
namespace params = CGAL::parameters;

template <typename ConcurrencyTag, typename NamedParameters>
void write_result(const std::vector<Kernel::Point_3>& points, const NamedParameters& np)
{
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  CGAL::l0_resample_point_set<ConcurrencyTag>(points, std::back_inserter(result), np);
  std::cout << std::hexfloat;
  for (const auto& [p, n] : result)
    std::cout << p.x() << ' ' << p.y() << ' ' << p.z() << ' ' << n.x() << ' ' << n.y() << ' '
              << n.z() << '\n';
}

} // namespace

int main(int, char** arguments)
{
  using namespace CGAL::L0_resampling;
  std::ifstream file(arguments[1], std::ios::binary);
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_PLY(file, std::back_inserter(points)))
    return EXIT_FAILURE;
  for (const Method method : {Method::DEFAULT, Method::LOR, Method::ALOR})
  {
    write_result<CGAL::Parallel_if_available_tag>(points, params::resampling_method(method));
    write_result<CGAL::Sequential_tag>(points,
                                       params::resampling_method(method).sparse_linear_solver(
                                         Eigen_cholesky_solver_traits<double>()));
  }
}
