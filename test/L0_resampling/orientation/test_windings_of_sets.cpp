// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "orientation/orientation_support.h"

#include <CGAL/L0_resampling/internal/orientation/orientation_field.h>

#include <cmath>
#include <numeric>
#include <vector>

using namespace test;

/// Sets that know nothing of each other yet.
Field_of_sets field_of(const std::vector<Index>& roots, const std::vector<Index>& trees,
                       const std::vector<int>& signs)
{
  Field_of_sets field;
  field.roots = roots;
  field.trees = trees;
  field.signs = signs;
  field.agreements.assign(roots.size() * roots.size(), 0);
  field.unary_terms.assign(roots.size(), 0);
  return field;
}

bool is_near(double a, double b) { return std::abs(a - b) <= 1e-5 * std::abs(b); }

/// Two sets of a tree, and one that is a tree by itself: what the agreements are by hand.
void check_agreements()
{
  Windings_of_sets windings({0, 2, 3, 4});
  const std::vector<std::vector<double>> values = {{0.25, 0.5, 0.125}, {0.125, -0.25, 0.5}};
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t i = 0; i < 3; ++i)
      windings.at(a, i) = float(values[a][i]);
  windings.at(2, 3) = 0.75;
  Field_of_sets field = field_of({0, 5, 9}, {0, 0, 9}, {1, -1, 1});
  field.agreements[1] = field.agreements[3] = 7; // what is there already
  const double samples_per_dipole = 20;
  windings.add_to<CGAL::Parallel_if_available_tag>(field, samples_per_dipole);

  const double weight = weight_of_windings(3 * samples_per_dipole, 3),
               products = 0.25 * 0.125 - 0.5 * 0.25 + 0.125 * 0.5,
               agreement = 7 + weight * winding_agreement(products, 0.875, 0.375, 3);
  CHECK(is_near(field.agreements[1], agreement));
  CHECK(is_near(field.agreements[3], agreement));
  for (std::size_t zero : {0, 2, 4, 5, 6, 7, 8})
    CHECK(field.agreements[zero] == 0);
  CHECK(is_near(field.unary_terms[0], weight * minimum_gain_of_windings));
  CHECK(is_near(field.unary_terms[1], -weight * minimum_gain_of_windings / 2));
}

/// Dipoles that have the same winding number everywhere agree, those that make it uneven do not;
/// and those that take it away do not, as even as that is.
void check_winding_agreement()
{
  const double n = 8, half = 0.25 * n; // sum of a set with 1/4 everywhere
  CHECK(winding_agreement(n / 16, half, half, n) > 0);
  CHECK(winding_agreement(-n / 16, half, -half, n) < 0);
  CHECK(winding_agreement(n / 16, 0, 0, n) < 0); // both up here, and down there
}

/// The points of faces, one after the other, and how many each has.
struct Sized_faces
{
  Oriented_points points;
  std::vector<std::size_t> sizes;
};

/// Each face is a set of its own, all of one tree.
struct Faces
{
  Buffer<Vector> positions, normals;
  std::vector<Index> roots;
  Signed_union_find sets = Signed_union_find(0, {});

  Faces(const Sized_faces& faces)
    : positions(to_buffer(faces.points.points)), normals(to_buffer(faces.points.normals)),
      sets(faces.points.points.size(), {})
  {
    Index first = 0;
    for (const std::size_t size : faces.sizes)
    {
      roots.push_back(first);
      for (std::size_t i = 1; i < size; ++i)
        sets.join(first, first + Index(i), 1);
      first += Index(size);
    }
  }
};

/// Each point is a dipole.
Windings_of_sets windings_of(const Faces& faces, double spacing, Field_of_sets& field)
{
  std::vector<Index> samples(faces.positions.size());
  std::iota(samples.begin(), samples.end(), Index(0));
  return add_dipoles<CGAL::Sequential_tag>(
    dipoles_of_field<CGAL::Sequential_tag>(samples, faces.sets, faces.positions, faces.normals,
                                           spacing * spacing, field),
    spacing, field);
}

/// Turns faces to the sides that their winding numbers ask for, and nothing else.
/// \returns the signs, that of the first face being 1
std::vector<int> turned_by_windings(const Faces& faces, double spacing, std::vector<int> signs)
{
  Field_of_sets field = field_of(faces.roots, std::vector<Index>(faces.roots.size(), 0), signs);
  const Windings_of_sets windings = windings_of(faces, spacing, field);
  field.agreements.assign(field.agreements.size(), 0);
  windings.add_to<CGAL::Sequential_tag>(field, 1);
  field.flip_disagreeing_sets();
  for (std::size_t a = field.signs.size(); a-- > 0;)
    field.signs[a] *= field.signs[0];
  return field.signs;
}

/// The faces of a cube, of `n` by `n` points each but the first ones, which have `k` times as many
/// to a side.
Sized_faces cube_of_faces(std::size_t number_of_faces, int n, std::size_t number_of_dense_ones = 0,
                          int k = 1)
{
  Sized_faces faces;
  for (std::size_t face = 0; face < number_of_faces; ++face)
  {
    const int axis = int(face % 3), side = face < 3 ? 1 : -1,
              number = face < number_of_dense_ones ? k * n : n;
    for (int x = 0; x < number; ++x)
      for (int y = 0; y < number; ++y)
      {
        Vector p;
        p[axis] = side;
        p[(axis + 1) % 3] = (2 * x + 1.) / number - 1;
        p[(axis + 2) % 3] = (2 * y + 1.) / number - 1;
        faces.points.points.push_back(p);
        faces.points.normals.push_back(side * Vector::Unit(axis));
      }
    faces.sizes.push_back(std::size_t(number) * std::size_t(number));
  }
  return faces;
}

/// A cube of any signs becomes one with its outside out, even if its spacing is only roughly known.
void check_cubes()
{
  const std::vector<int> right(6, 1);
  for (int turned = 0; turned < 64; ++turned)
  {
    std::vector<int> signs;
    for (int face = 0; face < 6; ++face)
      signs.push_back((turned >> face) & 1 ? -1 : 1);
    for (const double error : {1., 1.5})
      CHECK(turned_by_windings(cube_of_faces(6, 12), error / 6, signs) == right);
  }
}

/// Points so far away that squares of distances are no numbers of single precision tell nothing.
void check_far_points()
{
  Sized_faces faces = cube_of_faces(6, 12);
  for (const Vector& place : {Vector(1e25, 1e25, 1e25), Vector(1e25, 1e25, 2e25)})
  {
    faces.points.points.push_back(place);
    faces.points.normals.push_back(Vector(1, 1, 1).normalized());
  }
  faces.sizes.push_back(2);
  std::vector<int> signs = turned_by_windings(faces, 1. / 6, {1, -1, -1, 1, 1, -1, 1});
  signs.pop_back();
  CHECK(signs == std::vector<int>(6, 1));
}

/// A face that has sixteen times as many points as the others stands for hardly more: at its rim,
/// where a dipole has fewer others around it.
void check_crowded_face()
{
  const auto winding_at_opposite_face = [](int factor) {
    const Faces faces = cube_of_faces(6, 12, 1, factor);
    Field_of_sets field = field_of(faces.roots, std::vector<Index>(6, 0), std::vector<int>(6, 1));
    Windings_of_sets windings = windings_of(faces, 1. / 6, field);
    return windings.at(0, faces.roots[3]);
  };
  CHECK(std::abs(winding_at_opposite_face(4) / winding_at_opposite_face(1) - 1) < 0.5);
}

/// Two faces that meet at an edge, an open surface, stay as they are, right or wrong: there is not
/// enough to win.
void check_edge()
{
  for (const std::vector<int>& signs : {std::vector<int>{1, 1}, std::vector<int>{1, -1}})
    CHECK(turned_by_windings(cube_of_faces(2, 12), 1. / 6, signs) == signs);
}

int main()
{
  check_agreements();
  check_winding_agreement();
  check_cubes();
  check_far_points();
  check_crowded_face();
  check_edge();
  return result();
}
