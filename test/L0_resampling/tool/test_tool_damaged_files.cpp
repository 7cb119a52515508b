// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of l0_resample with files of all formats that were good: damaged in one place or
// several, cut anywhere, or compressed so that they stand for many bytes.

#include "tool/test_tool_reading.h"
#include "tool/test_tool_hostile.h"

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

// Damaged, cut, and small files that stand for many bytes
void test_hostile_gzip()
{
  const std::string ply = ply_header("binary_little_endian", "element vertex 1\n" + float_xyz)
                          + std::string(12, '\0');
  const std::string good = gzip(ply);
  CHECK(read(".ply", good).points.size() == 1);
  for (std::size_t length = 0; length < good.size(); ++length)
    CHECK(refusal(".ply", good.substr(0, length)).status == INPUT_REFUSED);
  CHECK(refusal(".ply", good.substr(0, 40)).says("points.ply: the compressed data end early"));
  CHECK(refusal(".xyz", std::string("\x1f\x8b", 2)).says("the compressed data end early"));
  CHECK(refusal(".xyz", "\x1f\x8b no such method").says("data are damaged: unknown compression"));
  std::string damaged = gzip("1 2 3\n4 5 6\n");
  damaged[damaged.size() - 8] ^= 1; // the checksum
  CHECK(refusal(".xyz", damaged).says("data are damaged: incorrect data check"));
  CHECK(refusal(".xyz", gzip("1 2 3\n") + "4 5 6\n").says("are damaged: incorrect header check"));

  // Announced, and there
  forget_allocations();
  const std::string announced = gzip(
    ply_header("binary_little_endian", "element vertex 100000\n" + float_xyz));
  CHECK(
    refusal(".ply", announced).says("100000 points are announced, but the compressed file has "));
  CHECK(refusal(".ply", gzip(ply_header("binary_little_endian",
                                        "element vertex 1537228672809129302\n" + float_xyz)))
          .says("are announced"));
  CHECK(refusal(".ply", gzip(ply_header("binary_little_endian", "element vertex 10\n" + float_xyz)))
          .says("more bytes are expected"));
  CHECK(maximum_allocation() <= maximum_memory_of_a_refusal);
  const std::string bomb = gzip(std::string(20000000, '\n'));
  CHECK(bomb.size() < 100000);
  forget_allocations();
  CHECK(refusal(".xyz", bomb).says("more than 200 times as many bytes"));
  CHECK(refusal(".xyz", gzip(bomb)).status == INPUT_REFUSED); // what it stands for is no text
  CHECK(maximum_allocation() <= maximum_memory_of_a_refusal);
}

// A file that announces its number of points is refused wherever it is cut.
void test_truncated_files()
{
  std::string binary = ply_header("binary_little_endian",
                                  "element vertex 3\n" + float_xyz + "property list uchar int v\n");
  for (int i = 0; i < 3; ++i)
    binary += bytes_of(float(i), false) + bytes_of(1.f, false) + bytes_of(2.f, false) + "\x01"
              + bytes_of(std::int32_t(i), false);
  CHECK(read(".ply", binary).points.size() == 3);
  for (std::size_t length = 0; length < binary.size(); ++length)
    CHECK(refusal(".ply", binary.substr(0, length)).status == INPUT_REFUSED);

  std::string floats;
  for (int i = 0; i < 9; ++i)
    floats += bytes_of(float(i), false);
  for (const auto& [extension, bytes] :
       {std::pair<const char*, std::string>{".pcd", pcd_header("", "4 4 4", "F F F", "3", "binary")
                                                      + floats},
        {".pcd", pcd_header("", "4 4 4", "F F F", "3", "binary_compressed")
                   + pcd_block(36, "\x1f" + floats.substr(0, 32) + "\x03" + floats.substr(32))},
        {".npy", npy_file(npy_header("<f4", "(3, 3)"), floats)}})
  {
    CHECK(read(extension, bytes).points.size() == 3);
    for (std::size_t length = 0; length < bytes.size(); ++length)
      CHECK(refusal(extension, bytes.substr(0, length)).status == INPUT_REFUSED);
  }

  const std::string columns = npy_file("{'descr': '<f4', 'fortran_order': True, 'shape': (3, 3)}",
                                       floats);
  CHECK(read(".npy", columns).points.size() == 3);
  for (std::size_t length = 0; length < columns.size(); ++length)
    CHECK(refusal(".npy", columns.substr(0, length)).status == INPUT_REFUSED);

  const std::string rows = "0 1 2\n3 4 5\n6 7 8\n";
  for (const auto& [extension, text] :
       {std::pair<const char*, std::string>{".off", "OFF\n3 0 0\n" + rows},
        {".xyz", "3\n" + rows},
        {".ply", ply_header("ascii", "element vertex 3\n" + float_xyz) + rows},
        {".pcd", pcd_header("", "4 4 4", "F F F", "3", "ascii") + rows}})
    for (std::size_t length = 1; length < text.size() - 1;
         ++length) // without the last line end it is still whole
      CHECK(refusal(extension, text.substr(0, length)).status == INPUT_REFUSED);
}

// Whatever bytes are changed, the reader gives finite points or refuses.
void test_changed_bytes()
{
  const std::vector<std::pair<std::string, std::string>> files = {
    {".xyz", "0.5 1 2 0 0 1\n3 -4e2 5 0 1 0\n6 7 8 1 0 0\n"},
    {".csv", "x,y,z,nx,ny,nz,\"a\"\n0.5,1,2,0,0,1,9\n3,-4e2,5,0,1,0,\"8\"\n6,7,8,1,0,0,7\n"},
    {".obj", "v 0.5 1 2\nvn 0 0 1\nv 3 -4e2 5\nvn 0 1 0\nv 6 7 8\nvn 1 0 0\n"},
    {".off", "NOFF\n3 1 0\n0.5 1 2 0 0 1\n3 -4e2 5 0 1 0\n6 7 8 1 0 0\n3 0 1 2\n"},
    {".ply", ply_header("ascii", "element vertex 2\n" + float_xyz + "property list uchar int v\n")
               + "0.5 1 2 1 7\n3 -4e2 5 0\n"},
    {".ply", ply_header("binary_big_endian",
                        "element vertex 2\n" + float_xyz + "property list uchar int v\n")
               + bytes_of(1.f, true) + bytes_of(2.f, true) + bytes_of(3.f, true)
               + std::string(1, '\0') + bytes_of(1.f, true) + bytes_of(2.f, true)
               + bytes_of(3.f, true) + "\x01" + bytes_of(std::int32_t(5), true)},
    {".pcd", pcd_header(" normal_x normal_y normal_z", "4 4 4 4 4 4", "F F F F F F", "2", "ascii")
               + "0.5 1 2 0 0 1\n3 -4e2 5 0 1 0\n"},
    {".pcd", pcd_header(" i", "4 4 4 2", "F F F I", "2", "binary") + three_floats + "ab"
               + three_floats + "cd"},
    {".pcd", pcd_header(" i", "4 4 4 2", "F F F I", "2", "binary_compressed")
               + pcd_block(28, "\x0b" + three_floats + std::string("\xe0\x01\x0b\x02xyz", 7))},
    {".npy", npy_file("{'descr': '<u8', 'fortran_order': True, 'shape': (1, 3)}",
                      three_floats + three_floats)},
    {".npy", npy_file(npy_header("<f4", "(2, 3)"), three_floats + three_floats)}};
  std::mt19937 random(11);
  Damaged_files damaged;
  for (int round = 0; round < 2000; ++round)
    for (const auto& [extension, bytes] : files)
    {
      std::string changed = bytes;
      for (unsigned k = 0; k < 1 + random() % 3; ++k)
        changed[random() % changed.size()] = random() % 2 ? char(random() % 256)
                                                          : "0123456789+-.eE \n\r"[random() % 18];
      damaged.add(
        [&, extension = extension]() { return read(extension, changed, with_normals()); });
    }
  damaged.check();
}

} // namespace

int main()
{
  test_hostile_gzip();
  test_truncated_files();
  test_changed_bytes();
  return test::result();
}
