// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where creases meet: the class Curves_at_corner.

#include "test_support.h"

#include <CGAL/L0_resampling/internal/creases/Curves_at_corner.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using CGAL::L0_resampling::internal::Corner_of_creases;
using CGAL::L0_resampling::internal::Curves_at_corner;
using test::Vector;

/// \param direction of unit length, away from where the lines would meet, the origin
/// \param corner where noise has them meet: up to 3 from there, they bend towards it
/// \param length of the line, in places one apart
std::vector<Vector> line_to(const Vector& corner, const Vector& direction, int length)
{
  std::vector<Vector> places = {corner};
  for (double t = 1; t <= length; ++t)
  {
    const double share = (std::max)(0., 1 - t / 3);
    places.push_back(t * direction + share * share * corner);
  }
  return places;
}

const std::vector<Vector> directions = {Vector(1, 0, 0), Vector(0, 1, 0), Vector(0.6, 0, 0.8)};

Curves_at_corner lines_to(const Vector& corner, int length)
{
  Curves_at_corner curves;
  for (const Vector& direction : directions)
    curves.add(line_to(corner, direction, length));
  return curves;
}

/// Straight lines lead to where they would meet without noise, whatever they do near to it.
void test_lines()
{
  for (const Vector& corner : {Vector(0, 0, 0), Vector(1, 1, 0.8), Vector(-0.5, 1.2, -0.3)})
  {
    const Curves_at_corner curves = lines_to(corner, 20);
    CHECK(curves.is_corner());
    const Corner_of_creases found = curves.meeting();
    CHECK(found.position.norm() <= 0.05 * corner.norm() + 1e-9);
    CHECK(std::abs(found.rounding - (found.position - corner).norm()) < 1e-12);
  }
}

/// A corner stays where too little of its curves is out of the reach of its rounding.
void test_short_lines()
{
  const Vector corner(1, 1, 0.8);
  const Corner_of_creases found = lines_to(corner, 4).meeting();
  CHECK(found.position == corner && found.rounding == 0);
}

/// Arcs that meet at a sharp angle do not take the corner along their chords.
void test_arcs()
{
  const double radius = 8;
  Curves_at_corner curves;
  for (const double side : {-1., 1.})
  {
    std::vector<Vector> places;
    for (double t = 0; t <= 12; ++t)
      places.push_back(
        {side * radius * (1 - std::cos(t / radius)), radius * std::sin(t / radius), 0});
    curves.add(places);
  }
  std::vector<Vector> third;
  for (double t = 0; t <= 12; ++t)
    third.push_back({0, 0, t});
  curves.add(third);
  CHECK(curves.meeting().rounding < 0.5);
}

/// Two curves that go on in one direction make no corner, two that turn do.
void test_which_are_corners()
{
  const Vector origin(0, 0, 0);
  for (const double turn : {0.3, 1.2})
  {
    Curves_at_corner curves;
    curves.add(line_to(origin, Vector(1, 0, 0), 5));
    curves.add(line_to(origin, Vector(-std::cos(turn), std::sin(turn), 0), 5));
    CHECK(curves.is_corner() == (turn > 1));
  }
}

} // namespace

int main()
{
  test_lines();
  test_short_lines();
  test_arcs();
  test_which_are_corners();
  return test::result();
}
