// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Replaces the global operators. In a source file of its own, since compilers that see both sides
// take `std::free()` for a mistake.

#include "promises/failing_allocation.h"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> is_failing{false};
std::atomic<long> allocations_left{0};
std::atomic<long> number_of_living{0};

void* allocate(std::size_t size)
{
  if (is_failing && --allocations_left < 0)
    throw std::bad_alloc();
  void* const p = std::malloc(size ? size : 1);
  if (!p)
    throw std::bad_alloc();
  ++number_of_living;
  return p;
}

void deallocate(void* p) noexcept
{
  if (p)
    --number_of_living;
  std::free(p);
}

} // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* p) noexcept { deallocate(p); }
void operator delete[](void* p) noexcept { deallocate(p); }
void operator delete(void* p, std::size_t) noexcept { deallocate(p); }
void operator delete[](void* p, std::size_t) noexcept { deallocate(p); }

namespace test {

void fail_after_allocations(long number)
{
  allocations_left = number;
  is_failing = true;
}

void stop_failing_allocations() { is_failing = false; }

long number_of_living_allocations() { return number_of_living; }

} // namespace test
