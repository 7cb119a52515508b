// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_HUGE_PAGES_H
#define CGAL_L0_RESAMPLING_INTERNAL_HUGE_PAGES_H

#include <cstddef>
#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// Asks the system for huge pages where some lie within an array that is not written yet: large
/// arrays take fewer page faults then. Does nothing where the system has none.
inline void prefer_huge_pages(void* array, std::size_t size) noexcept
{
#if defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t size_of_page = std::uintptr_t(1) << 21; // at least
  const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(array),
                       begin = (first + size_of_page - 1) / size_of_page * size_of_page,
                       end = (first + size) / size_of_page * size_of_page;
  if (begin < end)
    madvise(static_cast<char*>(array) + (begin - first), end - begin, MADV_HUGEPAGE); // may fail
#else
  (void)array;
  (void)size;
#endif
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_HUGE_PAGES_H
