// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orientation_support.h"

#include <CGAL/L0_resampling/internal/orientation/orientation_field.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

using namespace test;

/// A dipole has no field through a wide sheet, neither in its own plane nor over it; with what lies
/// on the other side of a line it agrees.
void check_dipole_and_sheet()
{
  const double step = 0.2, reach = 100, squared_core = squared_core_of_dipole(1);
  const auto agreement = [&](double height, double first) {
    double sum = 0;
    for (double x = first; x <= reach; x += step)
      for (double y = -reach; y <= reach; y += step)
        if (const double squared_distance = x * x + y * y + height * height;
            squared_distance <= reach * reach)
          sum += step * step
                 * dipole_agreement(1., height * height, squared_distance, squared_core);
    return sum;
  };
  for (const double height : {0., 0.25, 0.5, 1., 2., 4.})
    CHECK(std::abs(agreement(height, -reach)) < 0.1);
  const double to_line = 0.5;
  CHECK(
    std::abs(agreement(0, to_line + step / 2) - 2 * to_line / (to_line * to_line + squared_core))
    < 0.1); // Biot and Savart
}

/// Which of the six faces of a cube has this normal: opposite ones differ by 3.
std::size_t face_of(const Vector& normal)
{
  Eigen::Index axis;
  normal.cwiseAbs().maxCoeff(&axis);
  return std::size_t(axis) + (normal[axis] > 0 ? 3 : 0);
}

/// Six faces, each of one mind but of any sign. Few votes between them, all of them wrong, do not
/// keep the field from turning each outwards; many do.
void check_field(Generator& generator)
{
  const Oriented_points cube = cube_points(3000, 2, generator);
  for (const double number_of_votes : {0., 1., 1000.})
    for (std::size_t turned = 0; turned < 64; ++turned)
    {
      const auto own_sign = [&](std::size_t face) { return (turned >> face) & 1 ? -1 : 1; };
      Buffer<Vector> normals;
      Voting voting{Signed_union_find(cube.points.size(), {}), {}};
      std::vector<Index> first(6, Index(cube.points.size()));
      for (std::size_t i = 0; i < cube.points.size(); ++i)
      {
        normals.push_back(own_sign(face_of(cube.normals[i])) * cube.normals[i]);
        Index& first_of_face = first[face_of(cube.normals[i])];
        first_of_face = (std::min)(first_of_face, Index(i));
        voting.sets.join(first_of_face, Index(i), 1);
      }
      Signed_union_find trees = voting.sets;
      for (std::size_t a = 0; a < 6; ++a)
      {
        trees.join(first[0], first[a],
                   a == 4 ? -own_sign(0) * own_sign(a)
                          : own_sign(0) * own_sign(a)); // one face is turned
        for (std::size_t b = 0; b < a; ++b)
          if (a != b + 3) // neighbors: all votes are for that
            voting.votes.push_back(
              {first[a], first[b],
               number_of_votes * own_sign(a) * own_sign(b) * (a == 4 || b == 4 ? -1 : 1),
               number_of_votes});
      }
      pass_votes_on<CGAL::Sequential_tag>(voting);
      const bool is_turned = join_by_field<CGAL::Parallel_if_available_tag>(
        trees, to_buffer(cube.points), normals, 0.09, voting);
      CHECK(is_turned == (number_of_votes < 1000));
      if (!is_turned)
        continue;
      CHECK(voting.votes.empty()); // all are one set
      for (std::size_t face = 0; face < 6; ++face)
      {
        const auto [root, sign] = voting.sets.find(first[face]);
        const auto [root_of_others, sign_of_others] = voting.sets.find(first[0]);
        CHECK(root == root_of_others);
        CHECK(sign * own_sign(face) == sign_of_others * own_sign(0));
      }
    }
}

/// Faces that are turned together, and whose edges would not let one turn alone, are turned back
/// together; unless the edges to the others are for that they stay.
/// \param first_turned of the faces that are
void check_field_of_groups(std::size_t first_turned, Generator& generator)
{
  const Oriented_points cube = cube_points(3000, 2, generator);
  Voting voting{Signed_union_find(cube.points.size(), {}), {}};
  std::vector<Index> first(6, Index(cube.points.size()));
  for (std::size_t i = 0; i < cube.points.size(); ++i)
  {
    Index& first_of_face = first[face_of(cube.normals[i])];
    first_of_face = (std::min)(first_of_face, Index(i));
    voting.sets.join(first_of_face, Index(i), 1);
  }
  Signed_union_find trees = voting.sets;
  for (std::size_t face = 1; face < 6; ++face)
    trees.join(first[0], first[face], face >= first_turned ? -1 : 1);
  for (const double votes_for_others : {0., 1000.})
  {
    Voting with_votes = voting;
    for (std::size_t a = 0; a < 6; ++a)
      for (std::size_t b = 0; b < a; ++b)
      {
        const bool are_of_one_group = a < first_turned || b >= first_turned;
        const double number_of_votes = are_of_one_group ? 300 : votes_for_others;
        with_votes.votes.push_back({first[b], first[a],
                                    are_of_one_group ? number_of_votes : -number_of_votes,
                                    number_of_votes});
      }
    pass_votes_on<CGAL::Sequential_tag>(with_votes);
    const bool is_turned = join_by_field<CGAL::Parallel_if_available_tag>(
      trees, to_buffer(cube.points), to_buffer(cube.normals), 0.09, with_votes);
    CHECK(is_turned == (votes_for_others == 0));
    const auto sign_of = [&](std::size_t face) { return with_votes.sets.find(first[face]).second; };
    for (std::size_t face = 1; is_turned && face < 6; ++face)
      CHECK(sign_of(face) == sign_of(0));
  }
}

/// Two spots of a torus whose normals are parallel, one behind the other, would have one of them
/// turned, if there were nothing in between. Whether the rest takes part or is too scattered to,
/// they are left as they are.
void check_field_of_spots(std::size_t n, Generator& generator)
{
  const Oriented_points torus =
    evenly(n, [&](std::size_t size) { return torus_points(size, generator); });
  const Buffer<Vector> positions = to_buffer(torus.points), normals = to_buffer(torus.normals);
  Voting voting{Signed_union_find(n, {}), {}};
  for (const Vector& center : {Vector(1.4, 0, 0), Vector(-0.6, 0, 0)})
  {
    std::vector<Index> nearest(n);
    std::iota(nearest.begin(), nearest.end(), Index(0));
    std::partial_sort(nearest.begin(), nearest.begin() + 8, nearest.end(), [&](Index i, Index k) {
      return (positions[i] - center).squaredNorm() < (positions[k] - center).squaredNorm();
    });
    for (std::size_t place = 1; place < 8; ++place)
      voting.sets.join(nearest[0], nearest[place], 1);
  }
  Signed_union_find trees = voting.sets;
  for (Index i = 1; i < n; ++i)
    trees.join(0, i, 1);
  CHECK(!join_by_field<CGAL::Parallel_if_available_tag>(
    trees, positions, normals, std::sqrt(1.6 * EIGEN_PI * EIGEN_PI / double(n)), voting));
}

/// Of few samples each counts, even where each is a set of its own.
void check_field_of_single_samples(Generator& generator)
{
  const std::size_t n = 300;
  const Oriented_points cube =
    evenly(n, [&](std::size_t size) { return cube_points(size, 2, generator); });
  const Buffer<Vector> positions = to_buffer(cube.points), normals = to_buffer(cube.normals);
  Voting voting{Signed_union_find(n, {}), {}};
  Signed_union_find trees = voting.sets;
  for (Index i = 1; i < n; ++i)
    trees.join(0, i, i % 10 == 0 ? -1 : 1);
  CHECK(join_by_field<CGAL::Parallel_if_available_tag>(trees, positions, normals,
                                                       std::sqrt(24. / double(n)), voting));
  const int sign_of_first = voting.sets.find(0).second;
  for (Index i = 1; i < n; ++i)
    CHECK(voting.sets.find(i).second == sign_of_first);
}

int main()
{
  Generator generator(10);
  check_dipole_and_sheet();
  check_field(generator);
  check_field_of_groups(4, generator);
  check_field_of_groups(3, generator);
  for (const std::size_t n : {300, 1000}) // all take part, or too few
    check_field_of_spots(n, generator);
  check_field_of_single_samples(generator);
  return result();
}
