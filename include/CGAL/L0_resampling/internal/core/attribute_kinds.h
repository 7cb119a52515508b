// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_ATTRIBUTE_KINDS_H
#define CGAL_L0_RESAMPLING_INTERNAL_ATTRIBUTE_KINDS_H

#include <cstddef>
#include <string>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// How many near points an average is taken of: about those of four points of a result of half as
/// many.
constexpr std::size_t number_of_averaged_points = 8;

/// Whether integers of this name are averaged as numbers of floating-point types are: those of
/// colors, which PLY files have channel by channel. Other integers are labels, of which there is no
/// mean.
inline bool is_color_channel(const std::string& name)
{
  return name == "red" || name == "green" || name == "blue" || name == "alpha";
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_ATTRIBUTE_KINDS_H
