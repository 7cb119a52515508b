// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INSTRUCTIONS_H
#define CGAL_L0_RESAMPLING_INSTRUCTIONS_H

#include <CGAL/license/L0_resampling.h>

#include <string>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Of the file that includes this one.
inline std::string instructions_of_compiler()
{
#if defined(__AVX512F__)
  std::string names = "AVX-512";
#elif defined(__AVX2__)
  std::string names = "AVX2";
#elif defined(__AVX__)
  std::string names = "AVX";
#else
  std::string names = "plain";
#endif
#if defined(__FMA__)
  names += ", FMA";
#endif
  return names;
}

} // namespace internal

/*!
\ingroup PkgL0ResamplingRef

The instructions that the stages are compiled for, such as "AVX2, FMA", or "plain" for those of
every processor of the architecture. They are those of the compiled library in programs that link
with it, of which the loader may have had several to choose from. With other instructions, results
differ by roundings.
*/
#ifdef CGAL_L0_LINKED_WITH_COMPILED
std::string instructions_of_stages();
#else
inline std::string instructions_of_stages() { return internal::instructions_of_compiler(); }
#endif

} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INSTRUCTIONS_H
