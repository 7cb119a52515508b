// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_CREASES_OF_H
#define CGAL_L0_PYTHON_CREASES_OF_H

#include "arrays.h"
#include "resample.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace l0_python {

/// The creases and the corners of a result, as dictionaries of what `cgal_l0.Crease` and
/// `cgal_l0.Corner` are made of.
template <typename FT>
pybind11::tuple creases_of(const Result<FT>& result)
{
  using namespace pybind11::literals;
  const auto append = [](const auto& v, std::vector<double>& to) {
    to.insert(to.end(), {double(v.x()), double(v.y()), double(v.z())});
  };
  pybind11::list lines, corners;
  for (const auto& crease : result.creases)
  {
    std::vector<double> tangents, normals, angles(crease.angles);
    for (const auto& tangent : crease.tangents)
      append(tangent, tangents);
    for (const auto& of_faces : crease.normals)
      for (const auto& normal : of_faces)
        append(normal, normals);
    const auto size = pybind11::ssize_t(crease.points.size());
    lines.append(pybind11::dict(
      "points"_a = array_of(std::vector<std::int64_t>(crease.points.begin(), crease.points.end()),
                            1),
      "tangents"_a = array_of(std::move(tangents), 3),
      "normals"_a =
        array_of(std::move(normals), 3).reshape({size, pybind11::ssize_t(2), pybind11::ssize_t(3)}),
      "angles"_a = array_of(std::move(angles), 1), "is_closed"_a = crease.is_closed,
      "is_convex"_a = crease.is_convex, "confidence"_a = crease.confidence));
  }
  for (const auto& corner : result.corners)
  {
    std::vector<double> normals;
    for (const auto& normal : corner.normals)
      append(normal, normals);
    corners.append(
      pybind11::dict("point"_a = corner.point, "normals"_a = array_of(std::move(normals), 3)));
  }
  return pybind11::make_tuple(lines, corners);
}

} // namespace l0_python

#endif // CGAL_L0_PYTHON_CREASES_OF_H
