// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_CELL_GRID_CUH
#define CGAL_L0_CUDA_CELL_GRID_CUH

#include "core/Device_arena.cuh"
#include "search/Frame.cuh"

#include <CGAL/L0_resampling/internal/kernels/levels_of_scales.h>

#include <cstdint>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

using Key = unsigned long long;

/*!
How space is cut into cells, and the fixed-point numbers that positions are on the device.

A key holds the cell's number on each axis, x in the lowest bits, in as few bits as the cloud needs,
which makes the sort short; and above them the level, if points have scales. Keys ascend as those of
`Search_grid_3` do, and clamp as those do.

A coordinate is `units_per_length` times the one in the frame, modulo 2^32. Differences of such
numbers are exact whatever the extent of the cloud, as long as the points are within 2^31 units of
each other, and points that a query looks at are.
*/
struct Cell_frame
{
  double cell_size; // of points of scale 1
  double units_per_length;
  double first[3];   // cell on each axis, of points of scale 1
  unsigned count[3]; // of these cells on each axis
  int bits[3];
  bool has_levels;
  double low[3], high[3]; // of the box of the points

  /// \param low, high corners of the box of the points
  /// \param longest_query the largest distance at which points are looked at, at least
  /// \param has_levels whether the points have scales
  static Cell_frame around(const double (&low)[3], const double (&high)[3], double cell_size,
                           double longest_query, bool has_levels = false);

  int total_bits() const { return bits[0] + bits[1] + bits[2] + (has_levels ? 4 : 0); }

  __host__ __device__ double size_of_level(int level) const
  {
    return cell_size * size_of_cells(level);
  }

  static constexpr double half_range = 1 << 19; // cells, as in Search_grid_3

  /// Cells of each level beyond the box of the points. A block of up to four cells to each side is
  /// to be inside, also in the finest cells that it looks at: where it is not, all points of its
  /// rows are candidates, and the order of sums depends on the box.
  static constexpr double margin = 16;
  static_assert(margin * margin > 5 * 5 * (1 << levels_in_reach), "sizes grow by the root of 2");

  /// The first cell of a level on an axis.
  __host__ __device__ double first_of_level(int level, int axis) const
  {
    return fmax(floor(low[axis] / size_of_level(level)) - margin, -half_range);
  }

  /// The number of cells of a level on an axis.
  __host__ __device__ unsigned count_of_level(int level, int axis) const
  {
    const double last = fmin(floor(high[axis] / size_of_level(level)) + margin, half_range - 1);
    return unsigned(last - first_of_level(level, axis)) + 1;
  }
  __host__ __device__ float unit() const { return float(1 / units_per_length); }

  __device__ Key key(double3 p, float scale) const
  {
    const double coordinates[3] = {p.x, p.y, p.z};
    if (has_levels)
    {
      const int level = level_of_scale(scale);
      Key key = Key(level);
      for (int axis = 2; axis >= 0; --axis)
      {
        const double cell = fmin(
          fmax(floor(coordinates[axis] / size_of_level(level)) - first_of_level(level, axis), 0.),
          double(count_of_level(level, axis) - 1));
        key = (key << bits[axis]) | Key(cell);
      }
      return key;
    }
    Key key = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
      const double cell = fmin(fmax(floor(coordinates[axis] / cell_size) - first[axis], 0.),
                               double(count[axis] - 1));
      key = (key << bits[axis]) | Key(cell);
    }
    return key;
  }

  __host__ __device__ Key key_of_cell(unsigned x, unsigned y, unsigned z) const
  {
    return (((Key(z) << bits[1]) | y) << bits[0]) | x;
  }

  __host__ __device__ Key key_of_cell(int level, unsigned x, unsigned y, unsigned z) const
  {
    return (Key(level) << (bits[0] + bits[1] + bits[2])) | key_of_cell(x, y, z);
  }

  __host__ __device__ int level_of_key(Key key) const
  {
    return has_levels ? int(key >> (bits[0] + bits[1] + bits[2])) : level_of_one;
  }

  __host__ __device__ uint3 cell_of_key(Key key) const
  {
    return {unsigned(key & ((Key(1) << bits[0]) - 1)),
            unsigned((key >> bits[0]) & ((Key(1) << bits[1]) - 1)),
            unsigned((key >> (bits[0] + bits[1])) & ((Key(1) << bits[2]) - 1))};
  }

  __device__ int3 fixed_point(double3 p) const
  {
    const auto modulo = [](double x) {
      return int(unsigned((unsigned long long)(__double2ll_rn(x))));
    };
    return {modulo(p.x * units_per_length), modulo(p.y * units_per_length),
            modulo(p.z * units_per_length)};
  }
};

/// From `b` to `a`, in lengths of the frame.
__device__ inline float3 difference(int4 a, int4 b, float unit)
{
  return {unit * float(int(unsigned(a.x) - unsigned(b.x))),
          unit * float(int(unsigned(a.y) - unsigned(b.y))),
          unit * float(int(unsigned(a.z) - unsigned(b.z)))};
}

/// Points sorted by cell, and within a cell by coordinates, in the order of `Search_grid_3`. Arrays
/// on the device.
struct Cell_grid
{
  Cell_frame frame;
  unsigned size = 0;
  unsigned number_of_cells = 0;
  unsigned number_of_distinct = 0;
  int4* points = nullptr;               // fixed-point coordinates, and the cell
  unsigned* order = nullptr;            // where each stood before
  unsigned char* is_first = nullptr;    // of the points that are equal to it
  Key* keys = nullptr;                  // of the cells, ascending
  unsigned* begins = nullptr;           // the first point of each cell, and the number of points
  float* scales = nullptr;              // of the points; null if all are 1
  unsigned levels = 1u << level_of_one; // a bit for each that has cells

#ifdef __CUDACC__
  __device__ float scale(unsigned i) const { return Scales_view{scales}[i]; }
#endif

  /// Once nobody asks for it, and its arrays go.
  void forget_order()
  {
    order = nullptr;
    is_first = nullptr;
  }
};

/// Of the cell in the middle of a block: where it begins, in fixed-point numbers.
struct Block_center
{
  int begin_y, begin_z;
  unsigned stride; // of a block with too many points, every `stride`-th is used
  int
    // whether no cell of the block is an outermost one, whose points may be further away than
    // fixed-point numbers tell
    is_inside;
};

/// Where a row of cells lies across x, where the rows of a block differ in size.
struct Row_place
{
  int begin_y, begin_z; // in fixed-point numbers
  float size;           // of the cells; 0 where points may be further away than these tell

#ifdef __CUDACC__
  /// As `Offset_in_row::squared_reach()`.
  __device__ float squared_reach(float squared_radius, int4 center, float unit) const;
#endif
};

/// The runs of points in the block of cells around each cell of another grid, or of the same.
struct Cell_blocks
{
  int reach = 0;
  int number_of_rows = 0;          // (2 reach + 1)^2; where there are levels, that of each differs
  uint2* ranges = nullptr;         // number_of_rows for each cell; `[x, y)`
  Block_center* centers = nullptr; // one for each cell
  // where there are levels: the first range of each cell, and the place of each range
  unsigned long long* begins = nullptr;
  Row_place* places = nullptr;

#ifdef __CUDACC__
  __device__ const uint2* ranges_of(unsigned cell) const
  {
    return ranges + (begins ? begins[cell] : (unsigned long long)(cell) * unsigned(number_of_rows));
  }
  __device__ int number_of_ranges(unsigned cell) const
  {
    return begins ? int(begins[cell + 1] - begins[cell]) : number_of_rows;
  }
#endif
};

/// Sorts points into cells.
/// \param normals of the points, xyz interleaved, or null: the order of points that are equal
/// \param arena takes the arrays of the grid
/// \param arena_of_order takes those of them that tell of the order before; it may be `scratch`
Cell_grid build_grid(const Positions& positions, const float* normals, const Cell_frame& frame,
                     Device_arena& arena, Device_arena& arena_of_order, Device_arena& scratch,
                     cudaStream_t stream);

/// The same, with one arena for all arrays of the grid.
inline Cell_grid build_grid(const Positions& positions, const float* normals,
                            const Cell_frame& frame, Device_arena& arena, Device_arena& scratch,
                            cudaStream_t stream)
{
  return build_grid(positions, normals, frame, arena, arena, scratch, stream);
}

/// \param reach cells to each side
/// \param maximum_number_of_candidates to look at in a block
Cell_blocks find_blocks(const Cell_grid& query_grid, const Cell_grid& grid, int reach,
                        unsigned maximum_number_of_candidates, Device_arena& arena,
                        cudaStream_t stream);

/// The cells to each side that a ball can touch.
int cells_in_reach(double radius, double cell_size);

/// Lists the indices of the values that are not 0, ascending.
/// \returns their number; waits for the device
unsigned list_flagged(const unsigned char* flags, unsigned size, unsigned* indices,
                      Device_arena& scratch, cudaStream_t stream);

/// offsets[i] = counts[0] + ... + counts[i - 1], for i up to `size`; counts[size] is read and has
/// no part in it. The two arrays may be one.
/// \tparam T `unsigned` or `unsigned long long`
template <typename T>
void sum_up(const T* counts, unsigned size, T* offsets, Device_arena& scratch, cudaStream_t stream);

/// Sorts numbers.
/// \tparam T `unsigned`, `unsigned long long` or `double`
/// \returns where they are: in one of the arrays
template <typename T>
T* sort_values(T* values, T* other, unsigned size, Device_arena& scratch, cudaStream_t stream);

#ifdef __CUDACC__

/// Threads that share a query.
constexpr int lanes = 4;

/// Of a shorter row of cells all points are looked at, which takes less time than two searches.
constexpr unsigned shortest_searched_row = 48;

/// The first of the keys that is not below `key`.
__device__ inline unsigned lower_bound(const Key* keys, unsigned size, Key key)
{
  unsigned first = 0;
  while (size > 0)
  {
    const unsigned half = size / 2;
    if (keys[first + half] < key)
    {
      first += half + 1;
      size -= half + 1;
    }
    else
      size = half;
  }
  return first;
}

/// The points of a row of cells of the block around a cell, of `(2 reach + 1)^2` rows.
__device__ inline uint2 range_of_row(const Cell_grid& grid, uint3 center, int reach, int row)
{
  const int width = 2 * reach + 1;
  const long long z = (long long)(center.z) + row / width - reach,
                  y = (long long)(center.y) + row % width - reach;
  const Cell_frame& frame = grid.frame;
  if (z < 0 || z >= frame.count[2] || y < 0 || y >= frame.count[1])
    return {0, 0};
  const unsigned low = center.x < unsigned(reach) ? 0 : center.x - unsigned(reach);
  const unsigned high = min(center.x + unsigned(reach), frame.count[0] - 1);
  const Key last = frame.key_of_cell(high, unsigned(y), unsigned(z));
  const unsigned begin = lower_bound(grid.keys, grid.number_of_cells,
                                     frame.key_of_cell(low, unsigned(y), unsigned(z)));
  unsigned end = begin;
  while (end < grid.number_of_cells && grid.keys[end] <= last)
    ++end;
  return {grid.begins[begin], grid.begins[end]};
}

/// From a point to cells of a size on one axis, at least.
/// \param offset of the point from where the cells begin
__device__ inline float distance_to_cells(float offset, float size)
{
  return fmaxf(0, fmaxf(-offset, offset - size) - 1e-5f * size); // rounding
}

__device__ inline float Row_place::squared_reach(float squared_radius, int4 center,
                                                 float unit) const
{
  const auto distance = [&](int coordinate, int begin) {
    return distance_to_cells(unit * float(int(unsigned(coordinate) - unsigned(begin))), size);
  };
  const float dy = distance(center.y, begin_y), dz = distance(center.z, begin_z);
  return squared_radius - dy * dy - dz * dz;
}

/// Where in its cell a point is, across the rows of cells.
struct Offset_in_row
{
  float y, z;

  __device__ Offset_in_row(const Block_center& block, int4 center, float unit)
    : y(unit * float(int(unsigned(center.y) - unsigned(block.begin_y)))),
      z(unit * float(int(unsigned(center.z) - unsigned(block.begin_z))))
  {}

  /// What a ball around the point has left of its squared radius at the distance of a row of the
  /// block; not positive if it does not reach it.
  __device__ float squared_reach(float squared_radius, float cell_size, int reach, int row) const
  {
    const int width = 2 * reach + 1;
    const float dy = distance_to_cells(y - float(row % width - reach) * cell_size, cell_size),
                dz = distance_to_cells(z - float(row / width - reach) * cell_size, cell_size);
    return squared_radius - dy * dy - dz * dz;
  }
};

/// Of a block with too many points every `stride`-th is used, as `Local_points` does on the CPU:
/// counted from the first point of the block on, row after row.
/// \param ranges the rows of the block
/// \returns what the indices of those points of a row that are used equal modulo the stride
__device__ inline unsigned phase_of_row(const uint2* ranges, int row)
{
  unsigned number_before = 0;
#pragma unroll 2 // registers are scarce, and few blocks have too many points
  for (int before = 0; before < row; ++before)
    number_before += ranges[before].y - ranges[before].x;
  return ranges[row].x - number_before;
}

/*!
Calls `f(j, point)` for the points around a point that may be within `radius`, those of one of
`lanes` threads. Two points are read at a time. As long as `f` does not branch, what it reads of two
points is under way at once, too; and a warp seldom has no thread whose point is within the radius.

The points of a row of cells ascend in x: of each row only the part is looked at that the ball can
reach at the row's distance, which two searches find. Each thread of a group searches in another
row.

\param grid that of the points, of the same cells as that of the center
\param center fixed-point coordinates, and its cell in `blocks`
*/
template <typename F>
__device__ inline void for_each_candidate(const Cell_grid& grid, const Cell_blocks& blocks,
                                          int4 center, unsigned lane, float radius, const F& f)
{
  const unsigned group_mask = ((1u << lanes) - 1) << (threadIdx.x % 32 / lanes * lanes);
  const Block_center block = blocks.centers[center.w];
  const unsigned stride = block.stride, shift = unsigned(__ffs(int(stride))) - 1;
  const uint2* const ranges = blocks.ranges_of(unsigned(center.w));
  const int number_of_ranges = blocks.number_of_ranges(unsigned(center.w));
  const Row_place* const places = blocks.begins ? blocks.places + blocks.begins[center.w] : nullptr;
  const float cell_size = float(grid.frame.cell_size);
  const float unit = grid.frame.unit(), squared_radius = radius * radius;
  const Offset_in_row offset(block, center, unit);

  for (int first_row = 0; first_row < number_of_ranges; first_row += lanes)
  {
    uint2 range = {0, 0};
    const int row = first_row + int(lane);
    if (row < number_of_ranges)
    {
      float squared_reach;
      bool is_inside;
      if (places)
      {
        const Row_place own = places[row];
        squared_reach = own.squared_reach(squared_radius, center, unit);
        is_inside = own.size > 0;
      }
      else
      {
        squared_reach = offset.squared_reach(squared_radius, cell_size, blocks.reach, row);
        is_inside = block.is_inside;
      }
      if (squared_reach > 0 || !is_inside)
      {
        range = ranges[row];
        if (is_inside && range.y - range.x > shortest_searched_row)
        {
          const int reach =
            int(sqrtf(squared_reach) * 1.00001f * float(grid.frame.units_per_length)) + 1;
          const auto search = [&](int limit) {
            unsigned first = range.x, size = range.y - range.x;
            while (size > 0)
            {
              const unsigned half = size / 2;
              const bool is_before = int(unsigned(grid.points[first + half].x) - unsigned(center.x))
                                     < limit;
              first = is_before ? first + half + 1 : first;
              size = is_before ? size - half - 1 : half;
            }
            return first;
          };
          range.x = search(-reach);
          range.y = search(reach + 1);
        }
      }
    }
    // The points of the rows one after the other, dealt out to the lanes in turn
    static_assert(lanes == 4, "the rows that lanes have found are told apart one by one");
    unsigned first = range.x;
    if (stride > 1 && range.x < range.y) // a power of two
      first += (phase_of_row(ranges, row) - range.x) & (stride - 1);
    const unsigned own_count = range.x < range.y && first < range.y
                                 ? ((range.y - 1 - first) >> shift) + 1
                                 : 0;
    unsigned begins[lanes],
      ends
        // of each row: where it would begin if it held the points of those before, too; and how
        // many it and those hold
        [lanes];
    unsigned total = 0;
#pragma unroll
    for (int r = 0; r < lanes; ++r)
    {
      begins[r] = __shfl_sync(group_mask, first, r, lanes) - (total << shift);
      total += __shfl_sync(group_mask, own_count, r, lanes);
      ends[r] = total;
    }
    const auto place = [&](unsigned t) {
      const unsigned begin = t < ends[0]   ? begins[0]
                             : t < ends[1] ? begins[1]
                             : t < ends[2] ? begins[2]
                                           : begins[3];
      return begin + (t << shift); // modulo 2^32
    };
    unsigned t = lane;
    for (; t + lanes < total; t += 2 * lanes)
    {
      const unsigned j = place(t), next = place(t + lanes);
      const int4 point = grid.points[j], next_point = grid.points[next];
      f(j, point);
      f(next, next_point);
    }
    if (t < total)
    {
      const unsigned j = place(t);
      f(j, grid.points[j]);
    }
  }
}

#endif // __CUDACC__

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_CELL_GRID_CUH
