// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The signed error by distance from edges, of points whose errors are known.

#include "failure_count.h"

#include "../../../benchmark/L0_resampling/quality/edge_bias.h"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace L0_benchmark;

namespace {

std::size_t count(const std::vector<Edge_bias>& bands)
{
  std::size_t sum = 0;
  for (const Edge_bias& band : bands)
    sum += band.number_of_points;
  return sum;
}

// Four steps of 0.25 by 0.25; the profile is extruded along z by 0.8.
const Triangle_mesh staircase = read_triangle_mesh(L0_TEST_DATA "/staircase.off");
const double percent = diagonal(bounding_box(staircase)) / 100;

double total_length(const std::vector<Segment_3>& segments)
{
  double sum = 0;
  for (const Segment_3& segment : segments)
    sum += std::sqrt(segment.squared_length());
  return sum;
}

void test_kinds_of_edges()
{
  const Sharp_edges edges = classify_edges(staircase);
  check(std::abs(total_length(edges.concave) - 3 * 0.8) < 1e-9, "three concave edges");
  // Two outlines of length 4, and 0.8 each: at the 4 steps, at the top behind, two at the bottom.
  check(std::abs(total_length(edges.convex) - (2 * 4 + 7 * 0.8)) < 1e-9,
        "convex edges are " + std::to_string(total_length(edges.convex)) + " long");
}

// One point, whose band and error in % of the diagonal are known.
void check_one(const Point_3& p, bool is_convex, int band, double error, int at = __builtin_LINE())
{
  const Edge_biases biases = measure_edge_bias({p}, staircase);
  const std::vector<Edge_bias>& bands = is_convex ? biases.convex : biases.concave;
  const Edge_bias& found = bands[std::size_t(band)];
  check(count(biases.convex) + count(biases.concave) == 1, "it is counted once", at);
  check(found.number_of_points == 1, "it is in another band", at);
  const double signed_error = found.mean_signed_error();
  check(std::abs(signed_error - error) < 1e-6, "its error is " + std::to_string(signed_error), at);
  check(std::abs(found.mean_absolute_error() - std::abs(error)) < 1e-6, "absolute error", at);
}

void test_bands_and_signs()
{
  // In the profile (1, 0.25) is the lowest convex edge of a step, (0.75, 0.25) the concave one.
  for (double side : {-0.1, 0.1})
  {
    check_one({1 - 0.3 * percent, 0.25 + side * percent, 0.4}, true, 0, side);
    check_one({1 - 1.5 * percent, 0.25 + side * percent, 0.4}, true, 2, side);
    check_one({1 + side * percent, 0.25 - 3 * percent, 0.4}, true, 3, side);
    check_one({0.75 + 0.7 * percent, 0.25 + side * percent, 0.4}, false, 1, side);
    check_one({0.75 + side * percent, 0.25 + 5 * percent, 0.4}, false, 4, side);
  }
  // Beside the edge itself, where the foot is on it.
  check_one({1 + 0.1 * percent, 0.25 + 0.1 * percent, 0.4}, true, 0, 0.1 * std::sqrt(2.));
}

void test_a_mesh_without_edges_is_refused()
{
  try
  {
    measure_edge_bias({{0, 0, 0}}, read_triangle_mesh(L0_TEST_DATA "/torus.off"));
  }
  catch (const std::invalid_argument&)
  {
    return;
  }
  check(false, "the torus has edges");
}

} // namespace

int main()
{
  test_kinds_of_edges();
  test_bands_and_signs();
  test_a_mesh_without_edges_is_refused();
  return number_of_failures == 0 ? 0 : 1;
}
