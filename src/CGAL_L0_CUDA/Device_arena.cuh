// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_DEVICE_ARENA_CUH
#define CGAL_L0_CUDA_DEVICE_ARENA_CUH

#include "cuda_check.cuh"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// What all arenas of a session may hold together.
struct Memory_limit
{
  std::size_t limit;
  std::size_t held = 0;
};

/*!
A stack of device arrays. What a call takes it gives back at its end without freeing it, so that the next call of that size allocates
nothing. The first chunk has the size that was reserved; if that was too little there are more chunks, which the next `reserve()` merges.
*/
class Device_arena
{
  static constexpr std::size_t alignment = 256;

  struct Chunk
  {
    char* data;
    std::size_t size;
  };

  Memory_limit& m_limit;
  std::vector<Chunk> m_chunks;
  std::size_t m_chunk = 0, m_offset = 0; // the next array starts there
  std::size_t m_in_use = 0;

public:
  /// A height of the stack.
  struct Mark
  {
    std::size_t chunk, offset, in_use;
  };

  explicit Device_arena(Memory_limit& limit) : m_limit(limit) {}
  Device_arena(const Device_arena&) = delete;
  Device_arena& operator=(const Device_arena&) = delete;
  ~Device_arena() { free_all(); }

  /// Frees everything; an error, as after a failed kernel, has nobody left to hear it.
  void free_all() noexcept
  {
    for (const Chunk& chunk : m_chunks)
    {
      cudaFree(chunk.data);
      m_limit.held -= chunk.size;
    }
    cudaGetLastError();
    m_chunks.clear();
    m_chunk = m_offset = m_in_use = 0;
  }

  /// Empties the stack and makes it one chunk that holds what it held so far, and `bytes` at least.
  void reserve(std::size_t bytes)
  {
    m_chunk = m_offset = m_in_use = 0;
    std::size_t size = 0;
    for (const Chunk& chunk : m_chunks)
      size += chunk.size;
    if (m_chunks.size() == 1 && size >= bytes)
      return;
    if (m_chunks.size() > 1 || size < bytes)
    {
      free_all();
      allocate((std::max)(size, bytes));
    }
  }

  /// An array of `count` values, not initialized.
  template <typename T>
  T* take(std::size_t count)
  {
    const std::size_t bytes = ((std::max)(count, std::size_t(1)) * sizeof(T) + alignment - 1) / alignment * alignment;
    while (m_chunk < m_chunks.size() && m_chunks[m_chunk].size - m_offset < bytes)
    {
      ++m_chunk;
      m_offset = 0;
    }
    if (m_chunk == m_chunks.size())
      allocate(bytes);
    T* const array = reinterpret_cast<T*>(m_chunks[m_chunk].data + m_offset);
    m_offset += bytes;
    m_in_use += bytes;
    return array;
  }

  Mark mark() const { return {m_chunk, m_offset, m_in_use}; }

  /// Gives back all that was taken since the mark. Kernels already launched may still use it: what comes next runs after them.
  void release(const Mark& mark)
  {
    m_chunk = mark.chunk;
    m_offset = mark.offset;
    m_in_use = mark.in_use;
  }

  std::size_t in_use() const { return m_in_use; }

private:
  void allocate(std::size_t bytes)
  {
    if (m_limit.held + bytes > m_limit.limit)
      throw Failure(Status::OUT_OF_MEMORY, "the device memory that the call needs is above the limit that was set");
    void* data = nullptr;
    CGAL_L0_CUDA_CHECK(cudaMalloc(&data, bytes));
    m_chunks.push_back({static_cast<char*>(data), bytes});
    m_limit.held += bytes;
  }
};

/// Gives back at the end of a scope what was taken in it.
class Arena_scope
{
  Device_arena& m_arena;
  Device_arena::Mark m_mark;

public:
  explicit Arena_scope(Device_arena& arena) : m_arena(arena), m_mark(arena.mark()) {}
  Arena_scope(const Arena_scope&) = delete;
  Arena_scope& operator=(const Arena_scope&) = delete;
  ~Arena_scope() { m_arena.release(m_mark); }
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_DEVICE_ARENA_CUH
