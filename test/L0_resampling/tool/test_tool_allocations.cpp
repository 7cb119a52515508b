// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Replaces the global operators. In a source file of its own, since compilers that see both sides
// take `std::free()` for a mistake.

#include "tool/test_tool_allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> largest{0};

} // namespace

void* operator new(std::size_t size)
{
  for (std::size_t before = largest; before < size;)
    if (largest.compare_exchange_weak(before, size))
      break;
  if (void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace tool_test {

std::size_t maximum_allocation() { return largest; }

void forget_allocations() { largest = 0; }

} // namespace tool_test
