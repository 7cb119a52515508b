// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of l0_resample: no file, however wrong, gives anything but its points or a refusal that says where, nor
// takes more memory than its size justifies.

#include "test_support.h"
#include "test_tool_support.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <random>

namespace {

std::size_t largest_allocation = 0;

} // namespace

// None of the three is inlined, lest the compiler takes malloc() and free() for the wrong partners of delete and new.

[[gnu::noinline]] void* operator new(std::size_t size)
{
  largest_allocation = (std::max)(largest_allocation, size);
  if (void* memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept
{
  std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace {

using namespace l0_tool;
using namespace tool_test;

const Scratch_folder scratch;

Point_cloud read(const std::string& extension, const std::string& bytes, const Read_options& options = {})
{
  return tool_test::read(scratch, extension, bytes, options);
}

Failure_seen refusal(const std::string& extension, const std::string& bytes, const Read_options& options = {})
{
  return failure_of([&]() { read(extension, bytes, options); });
}

struct Hostile_file
{
  const char* extension;
  std::string bytes;
  const char* expected;   // a part of the message
};

// Each of them is refused with its own reason, and with no more memory than the reader's fixed buffer and what a
// message takes.
void test_hostile_files()
{
  const std::string ascii_vertex = "element vertex 1\n" + float_xyz;
  const std::string three_floats = bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false);
  const auto binary = [](const std::string& elements, const std::string& body) {
    return ply_header("binary_little_endian", elements) + body;
  };
  const std::vector<Hostile_file> files = {
    // numbers
    {".xyz", "1 2 0,5\n", "line 1: '0,5' is not a number"},
    {".xyz", "1 2 3\n1 2 3x\n", "line 2: '3x' is not a number"},
    {".xyz", "1 2 0x10\n", "'0x10' is not a number"},
    {".xyz", "1 2 1e999\n", "'1e999' is not a number"},
    {".xyz", "1 2 +-3\n", "'+-3' is not a number"},
    {".xyz", "1 2 \x1b[31m\n", "'?[31m' is not a number"},
    {".xyz", "1 2 nan\n", "line 1: a coordinate is not finite"},
    {".xyz", "1 2 3\n1 -inf 3\n", "line 2: a coordinate is not finite"},
    {".xyz", std::string("1 2 3\0 4\n", 9), "is not a number"},
    // columns and counts
    {".xyz", "1 2\n", "a point needs 3 numbers, found 2"},
    {".xyz", "1 2 3\n1 2 3 4\n", "line 2: 3 columns expected"},
    {".xyz", "1 2 3 4 5 6\n1 2 3\n", "line 2: 6 columns expected"},
    {".xyz", "3\n1 2 3\n4 5 6\n", "3 points are announced, but only 12 bytes"},
    {".xyz", "3\n1.5 2.5 3.5\n4.5 5.5 6.5\n", "the file ends after 2 points"},
    {".xyz", "18446744073709551615\n1 2 3\n", "are announced"},
    {".xyz", "5\n7\n1 2 3\n4 5 6\n7 8 9\n1 2 3\n4 5 6\n", "a point needs 3 numbers, found 1"},
    {".xyz", std::string(70000, '1'), "longer than 65536 bytes"},
    {".xyz", std::string(300000, ' '), "longer than 65536 bytes"},
    // OFF
    {".off", "", "the word OFF"},
    {".off", "# nothing\n\n", "the word OFF"},
    {".off", "PLY\n", "does not begin with OFF"},
    {".off", "4OFF\n1 0 0\n1 2 3 4\n", "does not begin with OFF"},
    {".off", "OFF BINARY\n", "binary OFF"},
    {".off", "OFF\n", "the number of vertices is expected"},
    {".off", "OFF\n-1 0 0\n", "'-1' is not a number of vertices"},
    {".off", "OFF\n1e3 0 0\n", "'1e3' is not a number of vertices"},
    {".off", "OFF\n4000000000 0 0\n1 2 3\n", "are announced"},
    {".off", "OFF\n2 0 0\n1 2 3.00000000000\n", "another vertex is expected"},
    {".off", "OFF\n1 0 0\n1 2    \n", "3 numbers expected, found 2"},
    {".off", "NOFF\n1 0 0\n1 2 3 4 5        \n", "6 numbers expected, found 5"},
    // the header of PLY
    {".ply", "", "does not begin with the line \"ply\""},
    {".ply", "plywood\n", "does not begin with the line \"ply\""},
    {".ply", "ply\n", "ends within its header"},
    {".ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "ends within its header"},
    {".ply", "ply\n" + ascii_vertex + "end_header\n1 2 3\n", "no line that begins with \"format\""},
    {".ply", "ply\nformat ascii 2.0\n", "version 1.0"},
    {".ply", "ply\nformat binary_middle_endian 1.0\n", "'binary_middle_endian' is not a format"},
    {".ply", "ply\nformat ascii 1.0\nfancy\n", "line 3: 'fancy' is not a keyword"},
    {".ply", ply_header("ascii", "element vertex -1\n" + float_xyz), "'-1' is not a number of elements"},
    {".ply", ply_header("ascii", "element vertex 99999999999999999999\n" + float_xyz), "is not a number of elements"},
    {".ply", ply_header("ascii", "element vertex\n" + float_xyz), "'' is not a number of elements"},
    {".ply", ply_header("ascii", float_xyz), "a property before the first element"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty quad x\n"), "'quad' is not a type"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty float\n"), "a property without a name"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty list float int x\n"), "floating-point type"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty list\n"), "'' is not a type"},
    {".ply", ply_header("ascii", "element face 0\nproperty list uchar int v\n"), "no element \"vertex\""},
    {".ply", ply_header("ascii", "element vertex 1\nproperty float x\nproperty float y\n") + "1 2\n", "no property z"},
    {".ply", ply_header("ascii", ascii_vertex + "property float x\n") + "1 2 3 4\n", "two properties x"},
    {".ply",
     ply_header("ascii", "element vertex 1\nproperty list uchar int x\nproperty int y\nproperty int z\n") + "0 2 3\n",
     "property x of the vertices is a list"},
    {".ply", ply_header("ascii", "element vertex 1\n") + "1 2 3\n", "no property x"},
    {".ply", "ply\nformat ascii 1.0\ncomment " + std::string(70000, 'c') + "\n", "longer than 65536 bytes"},
    // rows of PLY
    {".ply", ply_header("ascii", "element vertex 1000000000\n" + float_xyz) + "1 2 3\n",
     "1000000000 points are announced"},
    {".ply", ply_header("ascii", "element vertex 2\n" + float_xyz) + "1 2 3.0000000\n", "another row is expected"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2    \n", "ends before its property 'z'"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2 3 4\n", "more values than its 3 properties"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2 z\n", "'z' is not a number"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2 nan\n", "not finite"},
    {".ply", ply_header("ascii", ascii_vertex + "property list uchar int v\n") + "1 2 3 4294967295 1\n",
     "ends before its property 'v'"},
    {".ply", ply_header("ascii", ascii_vertex + "property list uchar int v\n") + "1 2 3 -1\n",
     "'-1' is not the length of a list"},
    {".ply", ply_header("ascii", "element a 1000000000\nproperty int i\n" + ascii_vertex) + "1\n1 2 3\n",
     "rows of 'a' are announced"},
    {".ply", binary("element vertex 2\n" + float_xyz, three_floats),
     "2 points are announced, but only 12 bytes are left"},
    {".ply", binary("element vertex 18446744073709551615\n" + float_xyz, three_floats), "are announced"},
    // times 12 is 8 in 64 bits
    {".ply", binary("element vertex 1537228672809129302\n" + float_xyz, three_floats),
     "are announced"},
    {".ply", binary(ascii_vertex, bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(std::nanf(""), false)),
     "not finite"},
    {".ply",
     binary("element vertex 1\n" + float_xyz + "property list uint double v\n", three_floats + "\xff\xff\xff\xff"),
     "34359738360 bytes are announced"},
    {".ply", binary("element vertex 1\nproperty list int uchar v\n" + float_xyz, "\xff\xff\xff\xff" + three_floats),
     "negative length"},
    {".ply", binary("element vertex 2\nproperty list uchar uchar v\n" + float_xyz,
                    std::string(1, '\0') + three_floats + "\x0c" + three_floats),
     "the file ends here, where 4 more bytes"},
    {".ply", binary("element face 4000000000\nproperty list uchar int v\n" + ascii_vertex, three_floats),
     "rows of 'face'"},
  };
  for (const Hostile_file& file : files) {
    const std::string path = scratch.file(std::string("hostile") + file.extension);
    write_bytes(path, file.bytes);
    largest_allocation = 0;
    const Failure_seen seen = failure_of([&]() { read_points(path, *format_of(path), {}); });
    if (!CHECK(seen.status == INPUT_REFUSED && seen.says(file.expected) && seen.says(path + ": ")))
      std::cerr << "  expected \"" << file.expected << "\", found status " << seen.status << ", \"" << seen.message
                << "\"\n";
    CHECK(seen.message.find('\n') == std::string::npos);
    if (!CHECK(largest_allocation <= 512 * 1024))
      std::cerr << "  " << largest_allocation << " bytes allocated for \"" << file.expected << "\"\n";
  }

  std::string many_properties = "element vertex 1\n" + float_xyz;
  for (int i = 0; i < 1000; ++i)
    many_properties += "property float p" + std::to_string(i) + "\n";
  CHECK(refusal(".ply", ply_header("ascii", many_properties)).says("more than 1000 properties"));
  std::string many_elements;
  for (int i = 0; i < 101; ++i)
    many_elements += "element e 0\n";
  CHECK(refusal(".ply", ply_header("ascii", many_elements)).says("more than 100 elements"));
  std::string long_header;
  for (int i = 0; i < 30; ++i)
    long_header += "comment " + std::string(40000, 'c') + "\n";
  CHECK(refusal(".ply", ply_header("ascii", long_header + ascii_vertex) + "1 2 3\n").says("longer than 1048576 bytes"));

  CHECK(failure_of([]() { read_points(scratch.file("missing.ply"), File_format::PLY, {}); }).says("No such file"));
  CHECK(failure_of([]() { read_points(scratch.file(""), File_format::PLY, {}); }).says("Is a directory"));
}

// A file that announces its number of points is refused wherever it is cut.
void test_truncated_files()
{
  std::string binary =
    ply_header("binary_little_endian", "element vertex 3\n" + float_xyz + "property list uchar int v\n");
  for (int i = 0; i < 3; ++i)
    binary += bytes_of(float(i), false) + bytes_of(1.f, false) + bytes_of(2.f, false) + "\x01"
              + bytes_of(std::int32_t(i), false);
  CHECK(read(".ply", binary).points.size() == 3);
  for (std::size_t length = 0; length < binary.size(); ++length)
    CHECK(refusal(".ply", binary.substr(0, length)).status == INPUT_REFUSED);

  const std::string rows = "0 1 2\n3 4 5\n6 7 8\n";
  for (const auto& [extension, text] :
       {std::pair<const char*, std::string>{".off", "OFF\n3 0 0\n" + rows}, {".xyz", "3\n" + rows},
        {".ply", ply_header("ascii", "element vertex 3\n" + float_xyz) + rows}})
    for (std::size_t length = 1; length < text.size() - 1; ++length)   // without the last line end it is still whole
      CHECK(refusal(extension, text.substr(0, length)).status == INPUT_REFUSED);
}

// Whatever bytes are changed, the reader gives finite points or refuses.
void test_changed_bytes()
{
  const std::vector<std::pair<std::string, std::string>> files = {
    {".xyz", "0.5 1 2 0 0 1\n3 -4e2 5 0 1 0\n6 7 8 1 0 0\n"},
    {".off", "NOFF\n3 1 0\n0.5 1 2 0 0 1\n3 -4e2 5 0 1 0\n6 7 8 1 0 0\n3 0 1 2\n"},
    {".ply", ply_header("ascii",
     "element vertex 2\n" + float_xyz + "property list uchar int v\n") + "0.5 1 2 1 7\n3 -4e2 5 0\n"},
    {".ply", ply_header("binary_big_endian", "element vertex 2\n" + float_xyz + "property list uchar int v\n")
             + bytes_of(1.f, true) + bytes_of(2.f, true) + bytes_of(3.f, true) + std::string(1, '\0')
             + bytes_of(1.f, true) + bytes_of(2.f, true) + bytes_of(3.f, true) + "\x01"
             + bytes_of(std::int32_t(5), true)}};
  std::mt19937 random(11);
  largest_allocation = 0;
  std::size_t wrong = 0, read_well = 0;
  for (int round = 0; round < 2000; ++round)
    for (const auto& [extension, bytes] : files) {
      std::string changed = bytes;
      for (unsigned k = 0; k < 1 + random() % 3; ++k)
        changed[random() % changed.size()] =
          random() % 2 ? char(random() % 256) : "0123456789+-.eE \n\r"[random() % 18];
      const Failure_seen seen = failure_of([&, extension = extension]() {
        const Point_cloud cloud = read(extension, changed, with_normals());
        ++read_well;
        for (const Point& p : cloud.points)
          wrong += !std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z());
        wrong += !cloud.normals.empty() && cloud.normals.size() != cloud.points.size();
      });
      wrong += seen.status != 0 && seen.status != INPUT_REFUSED;
    }
  CHECK(wrong == 0);
  CHECK(read_well > 500 && read_well < 7500);   // the changes did reach both
  CHECK(largest_allocation <= 512 * 1024);
}

} // namespace

int main()
{
  test_hostile_files();
  test_truncated_files();
  test_changed_bytes();
  return test::result();
}
