// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_DEVICE_ARENA_CUH
#define CGAL_L0_CUDA_DEVICE_ARENA_CUH

#include "core/cuda_check.cuh"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// What a session may hold on the device.
struct Memory_limit
{
  std::size_t limit;
  std::size_t held = 0;
};

/*!
A block of device memory from whose two ends two stacks of arrays grow, so that it has to be as
large as both together are at most, and not as the largest of each. What a call takes it gives back
at its end without freeing it, so that the next call of that size allocates nothing. What does not
fit is allocated by itself, and the next `reserve()` makes the block so large that it would have.
*/
class Device_block
{
  struct Piece
  {
    char* data;
    std::size_t size;
    bool is_taken;
  };

  Memory_limit& m_limit;
  char* m_data = nullptr;
  std::size_t m_size = 0, m_low = 0, m_high = 0; // free is what lies between
  std::vector<Piece> m_pieces;
  std::size_t m_in_pieces = 0, m_peak = 0, m_peak_of_stage = 0;
  void* m_staging = nullptr;

public:
  static constexpr std::size_t alignment = 256;
  static constexpr std::size_t size_of_staging = 256;

  explicit Device_block(Memory_limit& limit) : m_limit(limit) {}
  Device_block(const Device_block&) = delete;
  Device_block& operator=(const Device_block&) = delete;
  ~Device_block()
  {
    free_all();
    cudaFreeHost(m_staging);
    cudaGetLastError();
  }

  /// Frees everything; an error, as after a failed kernel, has nobody left to hear it.
  void free_all() noexcept
  {
    for (const Piece& piece : m_pieces)
      cudaFree(piece.data);
    cudaFree(m_data);
    cudaGetLastError();
    for (const Piece& piece : m_pieces)
      m_limit.held -= piece.size;
    m_limit.held -= m_size;
    m_pieces.clear();
    m_data = nullptr;
    m_size = m_low = m_high = m_in_pieces = 0;
  }

  /// Makes the block, whose stacks are empty, hold what they held so far, and `bytes` at least.
  void reserve(std::size_t bytes)
  {
    const bool is_above_limit = m_limit.held > m_limit.limit; // which may have been set anew
    const std::size_t size = (std::max)(bytes, is_above_limit ? 0 : m_peak);
    m_peak = 0;
    if (!is_above_limit && m_pieces.empty() && m_size >= size)
      return;
    free_all();
    const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
    m_data = allocate(rounded);
    m_size = m_high = rounded;
  }

  /// What the stacks hold.
  std::size_t used() const { return m_low + (m_size - m_high) + m_in_pieces; }

  /// The most that the stacks held at once since the last call of this function.
  std::size_t take_peak_of_stage()
  {
    const std::size_t peak = m_peak_of_stage;
    m_peak_of_stage = used();
    return peak;
  }

  /// Page-locked, so that what is copied there need not be copied twice.
  void* staging()
  {
    if (!m_staging)
      CGAL_L0_CUDA_CHECK(cudaMallocHost(&m_staging, size_of_staging));
    return m_staging;
  }

private:
  friend class Device_arena;

  char* allocate(std::size_t bytes)
  {
    if (m_limit.held + bytes > m_limit.limit)
      throw Failure(Status::OUT_OF_MEMORY,
                    "the device memory that the call needs is above the limit that was set");
    void* data = nullptr;
    CGAL_L0_CUDA_CHECK(cudaMalloc(&data, bytes));
    m_limit.held += bytes;
    return static_cast<char*>(data);
  }

  std::size_t take_piece(std::size_t bytes)
  {
    std::size_t i = 0;
    while (i < m_pieces.size() && (m_pieces[i].is_taken || m_pieces[i].size < bytes))
      ++i;
    if (i == m_pieces.size())
    {
      m_pieces.reserve(i + 1); // first: what comes after the allocation must not fail
      m_pieces.push_back({allocate(bytes), bytes, false});
    }
    m_pieces[i].is_taken = true;
    m_in_pieces += m_pieces[i].size;
    return i;
  }

  void give_back_piece(std::size_t i)
  {
    m_pieces[i].is_taken = false;
    m_in_pieces -= m_pieces[i].size;
  }

  void note_peak()
  {
    m_peak = (std::max)(m_peak, used());
    m_peak_of_stage = (std::max)(m_peak_of_stage, used());
  }
};

/// One of the two stacks of a block.
class Device_arena
{
public:
  enum class End
  {
    LOW,
    HIGH
  };

private:
  Device_block& m_block;
  End m_end;
  std::vector<std::size_t> m_pieces; // that the stack has taken

public:
  /// A height of the stack.
  struct Mark
  {
    std::size_t offset, number_of_pieces;
  };

  Device_arena(Device_block& block, End end) : m_block(block), m_end(end) {}
  Device_arena(const Device_arena&) = delete;
  Device_arena& operator=(const Device_arena&) = delete;

  /// An array of `count` values, not initialized.
  template <typename T>
  T* take(std::size_t count)
  {
    constexpr std::size_t alignment = Device_block::alignment;
    const std::size_t bytes = ((std::max)(count, std::size_t(1)) * sizeof(T) + alignment - 1)
                              / alignment * alignment;
    char* array;
    if (m_block.m_high - m_block.m_low < bytes)
    {
      m_pieces.reserve(m_pieces.size() + 1);
      m_pieces.push_back(m_block.take_piece(bytes));
      array = m_block.m_pieces[m_pieces.back()].data;
    }
    else if (m_end == End::LOW)
    {
      array = m_block.m_data + m_block.m_low;
      m_block.m_low += bytes;
    }
    else
    {
      m_block.m_high -= bytes;
      array = m_block.m_data + m_block.m_high;
    }
    m_block.note_peak();
    return reinterpret_cast<T*>(array);
  }

  /// Bytes that are free between the two stacks.
  std::size_t room() const { return m_block.m_high - m_block.m_low; }

  Mark mark() const
  {
    return {m_end == End::LOW ? m_block.m_low : m_block.m_high, m_pieces.size()};
  }

  /// Gives back all that was taken since the mark. Kernels already launched may still use it: what
  /// comes next runs after them.
  void release(const Mark& mark)
  {
    (m_end == End::LOW ? m_block.m_low : m_block.m_high) = mark.offset;
    while (m_pieces.size() > mark.number_of_pieces)
    {
      m_block.give_back_piece(m_pieces.back());
      m_pieces.pop_back();
    }
  }

  /// Gives everything back.
  void clear() { release({m_end == End::LOW ? 0 : m_block.m_size, 0}); }

  /// A value of the device's memory, which is there once the stream has done its work, and until
  /// the next one is fetched or read.
  template <typename T>
  const T* fetch(const T* address, cudaStream_t stream)
  {
    static_assert(sizeof(T) <= Device_block::size_of_staging, "no room for so large a value");
    T* const staging = static_cast<T*>(m_block.staging());
    CGAL_L0_CUDA_CHECK(
      cudaMemcpyAsync(staging, address, sizeof(T), cudaMemcpyDeviceToHost, stream));
    return staging;
  }

  /// A value of the device's memory. Waits for the device.
  template <typename T>
  T read(const T* address, cudaStream_t stream)
  {
    const T* const value = fetch(address, stream);
    CGAL_L0_CUDA_CHECK(cudaStreamSynchronize(stream));
    return *value;
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
