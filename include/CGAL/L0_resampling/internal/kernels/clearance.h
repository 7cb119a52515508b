// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_CLEARANCE_H
#define CGAL_L0_RESAMPLING_INTERNAL_CLEARANCE_H

#include <CGAL/L0_resampling/internal/core/host_device.h>
#include <CGAL/L0_resampling/internal/core/symmetric_eigen.h>
#include <CGAL/L0_resampling/internal/core/weights.h>

#include <cmath>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How far samples keep from the plane of the other face of a crease, per spacing of the samples.
constexpr double clearance_per_spacing = 0.35;

/// Within how many spacings the other face is looked for.
constexpr double reach_of_clearance = 3;

/// Samples whose normals have a smaller cosine, whichever side they point to, are of the other face
/// of a crease.
constexpr float maximum_cosine_across_crease = 0.87f;

/// Normals of one other face have a larger cosine with their mean; there are no more such faces.
constexpr double cosine_of_other_face = 0.9;
constexpr int number_of_other_faces = 3;

/// Less weight of samples is no face, and samples that are not in one plane, per spacing, are none.
constexpr double minimum_weight_of_face = 2.5, maximum_deviation_of_face = 0.3;

/*!
The other faces around a sample. On which side of one it belongs, whatever the sides of the normals,
the samples of its own face say.
*/
class Faces_around
{
  struct Face
  {
    Triple normals; ///< weighted sum
    double weight, height, squared_height;
  };
  Face m_faces[number_of_other_faces];
  int m_size = 0;
  Triple m_to_own = {0, 0, 0}; // from the sample in the middle

public:
  /// \param normal of a sample of another face, to whichever side
  /// \param to_center from it to the sample in the middle
  CGAL_L0_HOST_DEVICE void add(const Triple& normal, const Triple& to_center, double weight)
  {
    int f = 0;
    double cosine = 0;
    while (f < m_size
           && std::abs(cosine = dot(normalized(m_faces[f].normals), normal))
                <= cosine_of_other_face)
      ++f;
    if (f == number_of_other_faces)
      return;
    if (f == m_size)
      m_faces[m_size++] = {{0, 0, 0}, 0, 0, 0};
    const Triple other = (cosine < 0 ? -1. : 1.) * normal;
    const double height = dot(other, to_center);
    m_faces[f].normals = m_faces[f].normals + weight * other;
    m_faces[f].weight += weight;
    m_faces[f].height += weight * height;
    m_faces[f].squared_height += weight * height * height;
  }

  /// \param to_own from the sample in the middle to the middle of those of its own face
  CGAL_L0_HOST_DEVICE void set_own_face(const Triple& to_own) { m_to_own = to_own; }

  /// The way within its tangent plane on which a sample gets clear of the other faces.
  /// \param spacing of the samples
  CGAL_L0_HOST_DEVICE Triple way_out(const Triple& normal, double spacing) const
  {
    Triple way = {0, 0, 0};
    for (int f = 0; f < m_size; ++f)
    {
      const Face& face = m_faces[f];
      if (face.weight < minimum_weight_of_face)
        continue;
      const double height = face.height / face.weight,
                   variance = face.squared_height / face.weight - height * height;
      if (variance > square(maximum_deviation_of_face * spacing))
        continue;
      const Triple other = normalized(face.normals);
      const double cosine = dot(other, normal), sine = std::sqrt(at_least(1 - cosine * cosine, 0)),
                   side = height + dot(other, m_to_own) > 0 ? 1 : -1, minimum_sine = 0.3;
      if (sine < minimum_sine)
        continue;
      const double missing = at_most(clearance_per_spacing * spacing * sine - side * height,
                                     spacing);
      if (missing > 0)
        way = way + side * missing / (sine * sine) * (other + -cosine * normal);
    }
    const double length = std::sqrt(dot(way, way));
    return length > spacing ? spacing / length * way : way;
  }
};

/// How a surface bends around a sample, as a form on space: the heights over the tangent plane are
/// half of its values.
struct Bend
{
  float xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

/// \param u, v the axes of the surface's tangent plane
CGAL_L0_HOST_DEVICE inline Bend bend_of(double uu, double uv, double vv, const Triple& u,
                                        const Triple& v)
{
  const auto entry = [&](double au, double av, double bu, double bv) {
    return float(2 * uu * au * bu + uv * (au * bv + av * bu) + 2 * vv * av * bv);
  };
  return {entry(u.x, v.x, u.x, v.x), entry(u.x, v.x, u.y, v.y), entry(u.x, v.x, u.z, v.z),
          entry(u.y, v.y, u.y, v.y), entry(u.y, v.y, u.z, v.z), entry(u.z, v.z, u.z, v.z)};
}

/// A sample that slides along the surface.
struct Slide
{
  Triple way, normal;

  /// \param tangent_way within the tangent plane; a steeper slope than that of 20 degrees on the
  /// way is not taken
  CGAL_L0_HOST_DEVICE Slide(const Triple& tangent_way, const Triple& old_normal, const Bend& bend)
    : way({0, 0, 0}), normal(old_normal)
  {
    const Symmetric_matrix form = {bend.xx, bend.xy, bend.xz, bend.yy, bend.yz, bend.zz};
    const Triple slope = multiply(form, tangent_way);
    const double steepest = 0.12;
    if (dot(slope, slope) > steepest)
      return;
    way = tangent_way + dot(slope, tangent_way) / 2 * old_normal;
    normal = normalized(old_normal + -1. * slope);
  }
};

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_CLEARANCE_H
