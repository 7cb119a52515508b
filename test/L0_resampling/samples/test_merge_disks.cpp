// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "normals/naive_normal_filter.h"
#include "samples/sorted_samples.h"
#include "stage_support.h"

#include <CGAL/L0_resampling/internal/samples/merge_disks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace test;

const double cell_size = 0.2;

struct Naive_disk
{
  Vector position, normal;
  double height, information;
};

Merged_disks make_disks(const std::vector<Naive_disk>& naive, const Buffer<float>& scales = {})
{
  Merged_disks disks{Counting_allocator<Vector>()};
  for (const Naive_disk& d : naive)
  {
    disks.positions.push_back(d.position);
    disks.normals.push_back(d.normal.cast<Local>());
    disks.heights.push_back(float(d.height));
    disks.informations.push_back(float(d.information));
  }
  disks.scales = copy_of(scales);
  return disks;
}

std::vector<Naive_disk> naive_disks(const Merged_disks& disks)
{
  std::vector<Naive_disk> naive;
  for (std::size_t k = 0; k < disks.positions.size(); ++k)
    naive.push_back({disks.positions[k], disks.normals[k].cast<double>(), double(disks.heights[k]),
                     double(disks.informations[k])});
  return naive;
}

Merged_disks merged(const Merged_disks& disks)
{
  Merged_disks result = merge_disks<CGAL::Parallel_if_available_tag>(disks.view(), cell_size);
  const Merged_disks sequential = merge_disks<CGAL::Sequential_tag>(disks.view(), cell_size);
  CHECK(result.positions == sequential.positions && result.normals == sequential.normals
        && result.heights == sequential.heights && result.informations == sequential.informations
        && result.scales == sequential.scales);
  CHECK(result.scales.size() == (disks.scales.empty() ? 0 : result.positions.size()));
  return result;
}

bool comes_before(const Vector& a, const Vector& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// Weighted means of all that share a cell, have normals within 18 degrees, and points within a
/// fifth of a cell of each other's planes, in the order of x, y and z.
struct Naive_merged
{
  std::array<double, 4> cell; // its size and place
  double information;
  Vector positions, feet, normals;

  Vector normal() const { return normals.normalized(); }
  Vector position() const { return positions / information; }
};

std::vector<Naive_merged> merged_naively(std::vector<Naive_disk> disks, const Buffer<float>& scales)
{
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < disks.size(); ++k)
    order.push_back(k);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return comes_before(disks[a].position, disks[b].position);
  });
  std::vector<Naive_merged> result;
  for (const std::size_t k : order)
  {
    const Naive_disk& d = disks[k];
    // cells grow by roots of two, and are at least as large as the scale asks for
    const double level = scales.empty() ? 0 : std::ceil(2 * std::log2(double(scales[k])) - 1e-6),
                 size = cell_size * std::exp2(level / 2);
    const std::array<double, 4> cell = {size, std::floor(d.position.x() / size),
                                        std::floor(d.position.y() / size),
                                        std::floor(d.position.z() / size)};
    const Vector foot = d.position + d.height * d.normal;
    const auto is_of_face = [&](const Naive_merged& m) {
      return m.cell == cell && std::abs(m.normal().dot(d.normal)) > 0.95
             && std::abs(d.normal.dot(foot - m.feet / m.information)) < size / 5;
    };
    auto found = std::find_if(result.begin(), result.end(), is_of_face);
    if (found == result.end())
      found = result.insert(result.end(),
                            {cell, 0, Vector::Zero(), Vector::Zero(), Vector::Zero()});
    const double w = (std::max)(d.information, 1e-6);
    found->information += w;
    found->positions += w * d.position;
    found->feet += w * foot;
    found->normals += (found->normals.dot(d.normal) < 0 ? -w : w) * d.normal;
  }
  std::sort(result.begin(), result.end(), [](const Naive_merged& a, const Naive_merged& b) {
    return comes_before(a.position(), b.position());
  });
  return result;
}

/// Disks of a noisy wedge and of a noisy sphere, some of them without points.
std::vector<Naive_disk> any_disks(Generator& generator)
{
  std::vector<Naive_disk> disks;
  for (Oriented_points cloud : {wedge_points(1500, generator), sphere_points(1500, 0.9, generator)})
  {
    add_gaussian_noise(cloud.points, 0.02, generator);
    cloud.normals = noisy_normals(cloud.normals, 0.1, generator);
    for (std::size_t i = 0; i < cloud.points.size(); ++i)
      disks.push_back({cloud.points[i], cloud.normals[i].cast<Local>().cast<double>(),
                       double(float(std::normal_distribution<>(0, 0.05)(generator))),
                       i % 10 == 0 ? 0 : double(float(random_number(0, 3, generator)))});
  }
  return disks;
}

std::vector<Vector> positions_of(const std::vector<Naive_disk>& disks)
{
  std::vector<Vector> positions;
  for (const Naive_disk& d : disks)
    positions.push_back(d.position);
  return positions;
}

void check_formula(bool have_even_scales, Generator& generator)
{
  const std::vector<Naive_disk> disks = any_disks(generator);
  const Buffer<float> scales = make_scales(positions_of(disks), have_even_scales);
  std::vector<Naive_disk> result = naive_disks(merged(make_disks(disks, scales)));
  std::sort(result.begin(), result.end(), [](const Naive_disk& a, const Naive_disk& b) {
    return comes_before(a.position, b.position);
  });
  const std::vector<Naive_merged> expected = merged_naively(disks, scales);
  CHECK(expected.size() < disks.size() / 2);
  if (!CHECK(result.size() == expected.size()))
    return;
  double off = 0;
  for (std::size_t m = 0; m < result.size(); ++m)
  {
    const Naive_merged& e = expected[m];
    const double height = e.normal().dot(e.feet / e.information - e.position());
    off = (std::max)({off, (result[m].position - e.position()).norm(),
                      (result[m].normal - e.normal()).norm(), std::abs(result[m].height - height),
                      std::abs(result[m].information / e.information - 1)});
  }
  CHECK(off < 1e-6);
}

/// Points and places are as many, and have the same mean, before and after; where normals are the
/// same, so has what lies below the disks.
void check_sums(Generator& generator)
{
  const auto sums = [](const std::vector<Naive_disk>& disks) {
    Eigen::Matrix<double, 7, 1> sum = Eigen::Matrix<double, 7, 1>::Zero();
    for (const Naive_disk& d : disks)
    {
      sum[0] += d.information;
      sum.segment<3>(1) += d.information * d.position;
      sum.tail<3>() += d.information * (d.position + d.height * d.normal);
    }
    return sum;
  };
  const std::vector<Naive_disk> disks = any_disks(generator);
  const Eigen::Matrix<double, 7, 1> difference = sums(naive_disks(merged(make_disks(disks))))
                                                 - sums(disks);
  CHECK(difference.head<4>().norm() < 1e-3);
  std::vector<Naive_disk> along_one_normal = disks;
  for (Naive_disk& d : along_one_normal)
    d.normal = Vector::UnitY();
  const Merged_disks result = merged(make_disks(along_one_normal));
  CHECK(result.positions.size() < disks.size());
  CHECK((sums(naive_disks(result)) - sums(along_one_normal)).norm() < 1e-3);
}

/// Two disks of a cell become one unless they are of two faces or of two sheets.
void check_pairs()
{
  const Vector p(0.05, 0.05, 0.1), beside(0.06, 0.05, 0.1), above(0.05, 0.05, 0.13);
  const auto number = [&](const Naive_disk& a, const Naive_disk& b) {
    return merged(make_disks({a, b})).positions.size();
  };
  const Vector up = Vector::UnitZ();
  const auto tilted = [](double degrees) {
    const double angle = degrees * EIGEN_PI / 180;
    return Vector(std::sin(angle), 0, std::cos(angle));
  };
  CHECK(number({p, up, 0, 1}, {beside, up, 0, 1}) == 1);
  CHECK(number({p, up, 0, 1}, {beside, tilted(17), 0, 1}) == 1);
  CHECK(number({p, up, 0, 1}, {beside, tilted(19), 0, 1}) == 2);
  CHECK(number({p, up, 0, 1}, {beside, -up, 0, 1}) == 1);
  CHECK(number({p, up, 0, 1}, {above, -up, 0, 1}) == 1);
  CHECK(number({p, up, 0, 1}, {p + 0.09 * up, -up, 0, 1}) == 2);
  CHECK(number({p, up, 0, 1}, {above, up, 0, 1}) == 1);
  CHECK(number({p, up, -0.02, 1}, {above, up, 0, 1}) == 2); // the points are further apart
  CHECK(number({p, up, 0.02, 1}, {above, up, 0, 1}) == 1);
  CHECK(number({p, up, 0, 1}, {p + cell_size * Vector::UnitX(), up, 0, 1}) == 2);
}

void check_few()
{
  CHECK(merged(make_disks({})).positions.empty());
  const Naive_disk one = {Vector(1, 2, 3), Vector(0.6f, 0, 0.8f), 0.25, 2};
  const std::vector<Naive_disk> result = naive_disks(merged(make_disks({one})));
  CHECK(result.size() == 1 && (result[0].position - one.position).norm() < 1e-12
        && (result[0].normal - one.normal).norm() < 1e-6 && is_close(result[0].height, 0.25, 1e-6)
        && result[0].information == 2);
}

/// What is sorted together stays together.
void check_sorting(Generator& generator)
{
  const std::vector<Naive_disk> disks = any_disks(generator);
  const Buffer<float> scales = make_scales(positions_of(disks), false);
  Merged_disks sorted = make_disks(disks, scales);
  sorted.sort<CGAL::Parallel_if_available_tag>(cell_size);
  const Buffer<Index> order = Search_grid_3::sorted_order<CGAL::Sequential_tag>(
    to_buffer(positions_of(disks)), Cell_sizes(cell_size, scales));
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const Naive_disk& d = disks[order[k]];
    CHECK(sorted.positions[k] == d.position && sorted.normals[k] == d.normal.cast<Local>()
          && double(sorted.heights[k]) == d.height
          && double(sorted.informations[k]) == d.information
          && sorted.scales[k] == scales[order[k]]);
  }
}

int main()
{
  Generator generator(20261128);
  for (const bool have_even_scales : {true, false})
    check_formula(have_even_scales, generator);
  check_sums(generator);
  check_pairs();
  check_few();
  check_sorting(generator);
  return result();
}
