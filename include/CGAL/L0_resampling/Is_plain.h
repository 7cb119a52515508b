// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_IS_PLAIN_H
#define CGAL_L0_RESAMPLING_IS_PLAIN_H

#include <CGAL/license/L0_resampling.h>

#include <array>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace L0_resampling {

/// \ingroup PkgL0ResamplingRef
/// Whether values of `T` can be stored as they are in memory: all of their bytes mean something,
/// and any bytes are a value. So equal values are equal bytes, and what is damaged is at worst
/// another value. It holds for numbers, and for classes that have a specialization, see
/// `is_made_of()`.
template <typename T>
struct Is_plain : std::bool_constant<std::is_arithmetic<T>::value && !std::is_same<T, bool>::value>
{};
/// \cond SKIP_IN_MANUAL
template <typename T, std::size_t n>
struct Is_plain<std::array<T, n>> : Is_plain<T>
{};
/// \endcond

/// \ingroup PkgL0ResamplingRef
/// Whether a class has these members and nothing else, no gap between them either, and all of them
/// are plain.
template <typename T, typename... Members>
constexpr bool is_made_of(Members T::*...)
{
  return (sizeof(Members) + ...) == sizeof(T) && (Is_plain<Members>::value && ...);
}

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_IS_PLAIN_H
