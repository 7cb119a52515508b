// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of l0_resample: no file, however wrong, gives anything but its points or a refusal
// that says where, nor takes more memory than its size justifies. Here: files that are wrong in one
// place, each refused with its own reason.

#include "tool/test_tool_hostile.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

struct Hostile_file
{
  const char* extension;
  std::string bytes;
  const char* expected; // a part of the message
};

const std::string ascii_vertex = "element vertex 1\n" + float_xyz;

void check_refusals(const std::vector<Hostile_file>& files)
{
  for (const Hostile_file& file : files)
    check_refusal(file.extension, file.bytes, file.expected, with_everything());
}

void test_hostile_texts()
{
  check_refusals({
    // numbers
    {".xyz", "1 2 0,5\n", "line 1: a point needs 3 numbers, found 2; --decimal-comma reads"},
    {".xyz", "1 2 3\n1 2 0,5\n", "line 2: '0,5' is not a number; --decimal-comma reads"},
    {".xyz", "1 2 3\n1 2 3x\n", "line 2: '3x' is not a number"},
    {".xyz", "1 2 0x10\n", "'0x10' is not a number"},
    {".xyz", "1 2 1e999\n", "'1e999' is not a number"},
    {".xyz", "1 2 +-3\n", "'+-3' is not a number"},
    {".xyz", "1 2 \x1b[31m\n", "'?[31m' is not a number"},
    {".xyz", "1 2 nan\n", "line 1: a coordinate is not finite"},
    {".xyz", "1 2 3\n1 -inf 3\n", "line 2: a coordinate is not finite"},
    {".xyz", std::string("1 2 3\0 4\n", 9), "is not a number"},
    {".obj", "v 1,5 2 3\n", "'1,5' is not a number; XYZ and CSV alone have decimal commas"},
    {".off", "OFF\n1 0 0\n1,5 2 3\n", "'1,5' is not a number; XYZ and CSV alone"},
    // other formats
    {".xyz", "OFF\n1 0 0\n1 2 3\n", "begins as one of OFF, which --input-format off reads"},
    {".xyz", "v 1 2 3\n", "begins as one of OBJ, which --input-format obj reads"},
    {".csv", "v -.5 2 3\n", "begins as one of OBJ, which --input-format obj reads"},
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
    // CSV
    {".csv", "", "no line that names columns x, y and z"},
    {".csv", "# nothing\n//\n\n", "no line that names columns x, y and z"},
    {".csv", "1,2,3\n", "line 1: the line does not name columns x, y and z"},
    {".csv", "# \"\nx,y\n1,2\n", "line 2: the line does not name columns x, y and z"},
    {".csv", "x,y,z,\"a\n1,2,3,4\n", "line 1: the line does not name"},
    {".csv", "x,y,z,x\n1,2,3,4\n", "two columns x"},
    {".csv", "X,y,z,X\n1,2,3,4\n", "two columns x"},
    {".csv", "x,y,z,Nx,Ny,Nz,NZ\n1,2,3,4,5,6,7\n", "two columns nz"},
    {".csv", "x,y,z\n1,2\n", "line 2: 3 columns have names, found 2"},
    {".csv", "x,y,z\n1,2,3\n1,2,3,4\n", "line 3: 3 columns have names, found 4"},
    {".csv", "x;y;z\n1,5;2;3\n", "line 2: '1,5' is not a number"},
    {".csv", "x,y,z\n1,2,\"3\n\"\n", "line 2: a cell in quotes does not end in its line"},
    {".csv", "x,y,z\n1,2,\"3\"\"\n", "line 2: a cell in quotes does not end in its line"},
    {".csv", "x,y,z\n1,2,\"3\"4\n", "line 2: '4' stands behind a cell in quotes"},
    {".csv", "x,y,z\n1,2,\n", "line 2: a coordinate is not finite"},
    {".csv", "x,y,z\n1,2,nan\n", "line 2: a coordinate is not finite"},
    {".csv", "x,y,z\n1,2," + std::string(70000, '3') + "\n", "longer than 65536 bytes"},
    {".csv", "x,y,z\n" + std::string(1000, ',') + "\n", "line 2: more than 1000 columns"},
    // OBJ
    {".obj", "", "line 1: the file has no vertex"},
    {".obj", "f 1 2 3\nvn 0 0 1\n", "the file has no vertex"},
    {".obj", "v 1 2\n", "line 1: 3 numbers expected, found 2"},
    {".obj", "v 1 2 3\nvn 0 0\n", "line 2: 3 numbers expected, found 2"},
    {".obj", "v 1 2 0,5\n", "'0,5' is not a number"},
    {".obj", "v 1 2 \\ \n3\n", "'\\' is not a number"},
    {".obj", "v 1 2\\\n", "3 numbers expected, found 2"},
    {".obj", std::string(40000, 'f') + "\\\n" + std::string(40000, 'f') + "\\\n",
     "with those that go on with it"},
    {".obj", "v 1 2 3\nv 1 nan 3\n", "line 2: a coordinate is not finite"},
    {".obj", "v 1 2 3\n" + std::string(70000, 'f'), "longer than 65536 bytes"},
    // OFF
    {".off", "", "the file is empty"},
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
  });
  CHECK(failure_of([&]() {
          read(".csv", "x,y,z,a\n1,2,3,4\n1,2,3,few\n", with_everything());
        }).says("line 3: 'few' is not a number"));
  CHECK(failure_of([&]() {
          read(".obj", "v 1 2 3 1 0 1\nv 1 2 3\n", with_everything());
        }).says("line 2: a vertex with a color expected as the first one is, found 3 numbers"));
  CHECK(failure_of([&]() {
          read(".obj", "v 1 2 3 1 0 red\n", with_everything());
        }).says("'red' is not a number"));
}

void test_hostile_ply()
{
  const auto binary = [](const std::string& elements, const std::string& body) {
    return ply_header("binary_little_endian", elements) + body;
  };
  check_refusals({
    // the header of PLY
    {".ply", "", "the file is empty"},
    {".ply", "plywood\n", "does not begin with the line \"ply\""},
    {".ply", "ply\n", "ends within its header"},
    {".ply", "ply\nformat ascii 1.0\nelement vertex 1\n", "ends within its header"},
    {".ply", "ply\n" + ascii_vertex + "end_header\n1 2 3\n", "no line that begins with \"format\""},
    {".ply", "ply\nformat ascii 2.0\n", "version 1.0"},
    {".ply", "ply\nformat binary_middle_endian 1.0\n", "'binary_middle_endian' is not a format"},
    {".ply", "ply\nformat ascii 1.0\nfancy\n", "line 3: 'fancy' is not a keyword"},
    {".ply", ply_header("ascii", "element vertex -1\n" + float_xyz),
     "'-1' is not a number of elements"},
    {".ply", ply_header("ascii", "element vertex 99999999999999999999\n" + float_xyz),
     "is not a number of elements"},
    {".ply", ply_header("ascii", "element vertex\n" + float_xyz), "'' is not a number of elements"},
    {".ply", ply_header("ascii", float_xyz), "a property before the first element"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty quad x\n"),
     "the property x is of type 'quad'"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty float\n"),
     "a property without a name"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty list float int x\n"),
     "which is no integer"},
    {".ply", ply_header("ascii", "element vertex 1\nproperty list\n"), "without a type"},
    {".ply", ply_header("ascii", "element face 0\nproperty list uchar int v\n"),
     "no element \"vertex\""},
    {".ply",
     ply_header("ascii", "element vertex 1\nproperty float x\nproperty float y\n") + "1 2\n",
     "no property z"},
    {".ply", ply_header("ascii", ascii_vertex + "property float x\n") + "1 2 3 4\n",
     "two of the name x where one property is expected"},
    {".ply",
     ply_header("ascii",
                "element vertex 1\nproperty list uchar int x\nproperty int y\nproperty int z\n")
       + "0 2 3\n",
     "the property x is a list"},
    {".ply", ply_header("ascii", "element vertex 1\n") + "1 2 3\n", "no property x"},
    {".ply", "ply\nformat ascii 1.0\ncomment " + std::string(70000, 'c') + "\n",
     "longer than 65536 bytes"},
    // rows of PLY
    {".ply", ply_header("ascii", "element vertex 1000000000\n" + float_xyz) + "1 2 3\n",
     "1000000000 points are announced"},
    {".ply", ply_header("ascii", "element vertex 2\n" + float_xyz) + "1 2 3.0000000\n",
     "another row is expected"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2    \n", "ends before its property 'z'"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2 3 4\n", "more values than its 3 properties"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2 z\n", "'z' is not a number"},
    {".ply", ply_header("ascii", ascii_vertex) + "1 2 nan\n", "not finite"},
    {".ply",
     ply_header("ascii", ascii_vertex + "property list uchar int v\n") + "1 2 3 4294967295 1\n",
     "ends before its property 'v'"},
    {".ply", ply_header("ascii", ascii_vertex + "property list uchar int v\n") + "1 2 3 -1\n",
     "'-1' is not the length of a list"},
    {".ply",
     ply_header("ascii", "element a 1000000000\nproperty int i\n" + ascii_vertex) + "1\n1 2 3\n",
     "rows of 'a' are announced"},
    {".ply", binary("element vertex 2\n" + float_xyz, three_floats),
     "2 points are announced, but only 12 bytes are left"},
    {".ply", binary("element vertex 18446744073709551615\n" + float_xyz, three_floats),
     "are announced"},
    // times 12 is 8 in 64 bits
    {".ply", binary("element vertex 1537228672809129302\n" + float_xyz, three_floats),
     "are announced"},
    {".ply",
     binary(ascii_vertex,
            bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(std::nanf(""), false)),
     "not finite"},
    {".ply",
     binary("element vertex 1\n" + float_xyz + "property list uint double v\n",
            three_floats + "\xff\xff\xff\xff"),
     "34359738360 bytes are announced"},
    {".ply",
     binary("element vertex 1\nproperty list int uchar v\n" + float_xyz,
            "\xff\xff\xff\xff" + three_floats),
     "a length that cannot be"},
    {".ply",
     binary("element vertex 2\nproperty list uchar uchar v\n" + float_xyz,
            std::string(1, '\0') + three_floats + "\x0c" + three_floats),
     "the file ends here, where 4 more bytes"},
    {".ply",
     binary("element face 4000000000\nproperty list uchar int v\n" + ascii_vertex, three_floats),
     "rows of 'face'"},
  });

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
  CHECK(refusal(".ply", ply_header("ascii", long_header + ascii_vertex) + "1 2 3\n")
          .says("longer than 1048576 bytes"));
}

void test_hostile_pcd()
{
  // a PCD file with another line in place of the one that begins as it does
  const auto pcd = [](const std::string& line, const std::string& body = "1 2 3\n") {
    std::string header = pcd_header("", "4 4 4", "F F F", "1", "ascii");
    const std::size_t begin = header.find(line.substr(0, line.find(' ') + 1));
    return header.replace(begin, header.find('\n', begin) - begin, line) + body;
  };
  const auto pcd_without = [&](const std::string& keyword) {
    std::string file = pcd(keyword + " ");
    const std::size_t begin = file.find(keyword);
    return file.erase(begin, file.find('\n', begin) - begin + 1);
  };
  const auto packed = [](const std::string& compressed, std::uint32_t size,
                         const std::string& number_of_points = "1") {
    return pcd_header("", "4 4 4", "F F F", number_of_points, "binary_compressed")
           + pcd_block(size, compressed);
  };
  check_refusals({
    // PCD
    {".pcd", "", "the file is empty"},
    {".pcd", "# nothing\n", "ends within its header"},
    {".pcd", "ply\n", "begins as one of PLY, which --input-format ply reads"},
    {".pcd", pcd("VERSION 1.0"), "version 0.7 of PCD or an older one expected, found '1.0'"},
    {".pcd", pcd("VERSION "), "found ''"},
    {".pcd", pcd("VIEWPOINT 0\nFANCY 1"), "line 9: 'FANCY' is not a keyword"},
    {".pcd", pcd("VIEWPOINT 0\nWIDTH 1"), "a second line WIDTH"},
    {".pcd", pcd_without("FIELDS"), "no line FIELDS"},
    {".pcd", pcd_without("SIZE"), "no line SIZE"},
    {".pcd", pcd_without("TYPE"), "no line TYPE"},
    {".pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nDATA ascii\n1 2 3\n",
     "no line POINTS and no line WIDTH"},
    {".pcd",
     "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 4294967296\nHEIGHT 4294967296\nDATA ascii\n",
     "more than a file can hold"},
    {".pcd", pcd_without("DATA"), "'1' is not a keyword"},
    {".pcd", pcd("FIELDS "), "0 fields, but SIZE has 3 words"},
    {".pcd", pcd("FIELDS x y z w"), "4 fields, but SIZE has 3 words"},
    {".pcd", pcd("SIZE 4 4"), "3 fields, but SIZE has 2 words"},
    {".pcd", pcd("SIZE 4 4 3"), "'3' is not a size"},
    {".pcd", pcd("SIZE 4 4 -4"), "'-4' is not a size"},
    {".pcd", pcd("SIZE 4 4 18446744073709551615"), "is not a size"},
    {".pcd", pcd("TYPE F F"), "3 fields, but TYPE has 2 words"},
    {".pcd", pcd("TYPE F F Q"), "the field z is of type 'Q' of 4 bytes"},
    {".pcd", pcd("SIZE 4 4 2"), "the field z is of type 'F' of 2 bytes"},
    {".pcd", pcd("VIEWPOINT 0\nCOUNT 1 1"), "3 fields, but COUNT has 2 words"},
    {".pcd", pcd("VIEWPOINT 0\nCOUNT 1 1 0"), "the field z is one of 0 values"},
    {".pcd", pcd("VIEWPOINT 0\nCOUNT 1 1 99999999999"), "is not a number of values"},
    {".pcd", pcd("VIEWPOINT 0\nCOUNT 1 1 2"), "the field z is one of 2 values"},
    {".pcd", pcd("FIELDS x y y"), "two of the name y where one field is expected"},
    {".pcd", pcd("FIELDS x y w"), "no field z"},
    {".pcd", pcd("WIDTH 2"), "WIDTH times HEIGHT"},
    {".pcd", pcd("HEIGHT 0"), "WIDTH times HEIGHT"},
    {".pcd", pcd("WIDTH -1"), "'-1' is not a number of columns"},
    // times 4294967296 is 0 in 64 bits
    {".pcd", pcd("WIDTH 4294967296\nHEIGHT 4294967296\nPOINTS 0\nDATA ascii"),
     "WIDTH times HEIGHT"},
    {".pcd", pcd("POINTS one"), "'one' is not a number of points"},
    {".pcd", packed("", 8).substr(0, packed("", 8).size() - 1), "1 more bytes are expected"},
    {".pcd", packed("abc", 12).substr(0, packed("abc", 12).size() - 1),
     "3 compressed bytes are announced, but only 2 bytes are left"},
    {".pcd", packed("abc", 11), "11 bytes before compression are announced for 1 points of 12"},
    {".pcd", packed("", 12), "0 compressed bytes cannot hold the announced 12"},
    // three bytes may stand for 264, and for no more
    {".pcd", packed(three_floats, 1200000000, "100000000"),
     "12 compressed bytes cannot hold the announced 1200000000"},
    {".pcd", packed("\x0b" + three_floats.substr(0, 11), 12), "end within a block"},
    {".pcd", packed(std::string("\0a\x20", 3), 12), "end within a block"},
    {".pcd", packed(std::string("\0a\xe0", 3), 12), "end within a block"},
    {".pcd", packed(std::string("\0a\x20\1", 4), 12), "leads to before their begin"},
    {".pcd", packed(std::string("\0a\x3f\xff", 4), 12), "leads to before their begin"},
    {".pcd", packed(std::string("\0a\xe0\x03\0", 5), 12), "hold more than the announced 12"},
    {".pcd", packed("\x0b" + three_floats + std::string(2, '\0'), 12),
     "hold more than the announced 12"},
    {".pcd", packed(std::string("\0a\xe0\x01\0", 5), 12), "hold 11 bytes, announced are 12"},
    {".pcd", packed("\x0b" + bytes_of(std::nanf(""), false) + three_floats.substr(0, 8), 12),
     "not finite"},
    {".pcd", pcd("DATA base64"), "'base64' is not a kind of DATA"},
    {".pcd", pcd("WIDTH 1000000000\nHEIGHT 1\nPOINTS 1000000000\nDATA ascii"),
     "1000000000 points are announced"},
    {".pcd", pcd("WIDTH 18446744073709551615\nHEIGHT 1\nPOINTS 18446744073709551615\nDATA binary"),
     "are announced"},
    // times 12 is 8 in 64 bits
    {".pcd",
     pcd("WIDTH 1537228672809129302\nHEIGHT 1\nPOINTS 1537228672809129302\nDATA binary",
         three_floats),
     "are announced"},
    {".pcd", pcd("VIEWPOINT 0", "1 2\n    "), "ends before its field 'z'"},
    {".pcd", pcd("VIEWPOINT 0", "1 2 3 4\n"), "more than its 3 values"},
    {".pcd", pcd("VIEWPOINT 0", "1 2 0,5\n"), "'0,5' is not a number"},
    {".pcd", pcd("VIEWPOINT 0", "nan nan nan\n"), "not finite"},
    {".pcd", pcd("VIEWPOINT 0", "\n\n\n\n\n\n"), "another row is expected"},
    {".pcd", pcd("DATA binary", three_floats.substr(0, 11)),
     "1 points are announced, but only 11 bytes are left"},
    {".pcd", pcd("DATA binary", bytes_of(std::nanf(""), false) + three_floats), "not finite"},
    {".pcd", pcd_header("", "8 4 4", "B F F", "1", "binary") + three_floats + three_floats,
     "the field x is of type 'B' of 8 bytes"},
    {".pcd",
     "VERSION 0.7\nFIELDS x y z _\nSIZE 4 4 4 1\nTYPE F F F U\nCOUNT 1 1 1 100\nWIDTH 2\nHEIGHT "
     "1\nPOINTS 2\n"
     "DATA binary\n"
       + three_floats + std::string(150, 'p'),
     "2 points are announced, but only 162 bytes are left"},
    {".pcd", "VERSION 0.7\n# " + std::string(70000, 'c') + "\n", "longer than 65536 bytes"},
  });

  std::string many_fields;
  for (int i = 0; i < 1000; ++i)
    many_fields += " f" + std::to_string(i);
  CHECK(
    refusal(".pcd", pcd_header(many_fields, "4", "F", "1", "ascii")).says("more than 1000 fields"));
  std::string long_pcd;
  for (int i = 0; i < 30; ++i)
    long_pcd += "# " + std::string(40000, 'c') + "\n";
  long_pcd += pcd_header("", "4 4 4", "F F F", "1", "ascii") + "1 2 3\n";
  CHECK(refusal(".pcd", long_pcd).says("longer than 1048576 bytes"));
}

void test_hostile_npy()
{
  const auto npy = [&](const std::string& header) { return npy_file(header, three_floats); };
  const auto records = [](const std::string& fields, const std::string& shape) {
    return "{'descr': [" + fields + "], 'fortran_order': False, 'shape': " + shape + "}";
  };
  const auto repeated = [](int times, const std::string& text) {
    std::string all;
    for (int k = 0; k < times; ++k)
      all += text;
    return all;
  };
  check_refusals({
    // NPY
    {".npy", "", "the file is empty"},
    {".npy", "NUMPY\x01\x00", "does not begin as an NPY file does"},
    {".npy", std::string("\x93NUMPY\x01\x00\x10", 9), "1 more bytes are expected"},
    {".npy", std::string("\x93NUMPY\x04\x00\x00\x00", 10),
     "version 1, 2 or 3 of NPY expected, found 4"},
    {".npy", std::string("\x93NUMPY\x01\x00\xff\xff", 10) + "{}", "65533 more bytes are expected"},
    {".npy", std::string("\x93NUMPY\x02\x00\xff\xff\xff\xff", 12) + "{}",
     "longer than 65536 bytes"},
    {".npy", npy(""), "the header has '' where { is expected"},
    {".npy", npy("{"), "where ' is expected"},
    {".npy", npy("{}"), "lacks one of descr"},
    {".npy", npy("{'descr': '<f4', 'shape': (1, 3)}"), "lacks one of descr"},
    {".npy", npy("{'descr': '<f4"), "a string of the header does not end"},
    {".npy", npy("{'descr' '<f4'}"), "where : is expected"},
    {".npy", npy("{'descr': '<f4' 'shape': (1, 3)}"), "where } is expected"},
    {".npy", npy("{'descr': '<f4', 'descr': '<f4'}"), "'descr' twice"},
    {".npy", npy("{'color': 'red'}"), "'color' is not a name"},
    {".npy", npy("{'descr': [('x', '<f4')], 'fortran_order': False, 'shape': (1,)}"),
     "the records have no fields x, y and z; --columns can name theirs, which are 'x'"},
    {".npy", npy("{'descr': [], 'fortran_order': False, 'shape': (1,)}"), "have no fields"},
    {".npy", npy("{'descr': [('x', '<f4'"), "where ) is expected"},
    {".npy", npy("{'descr': [('x', '<f4')"), "where ] is expected"},
    {".npy", npy("{'descr': [('x', '<f4', (0,))]}"), "more than 1000 values, or none"},
    {".npy", npy("{'descr': [('x', '<f4', (4294967296, 4294967296))]}"), "or none"},
    {".npy", npy("{'descr': " + std::string(100, '[') + "}"), "where ( is expected"},
    {".npy", npy("{'descr': " + repeated(9, "[('a', ") + "}"), "nested more than 8 deep"},
    {".npy", npy("{'descr': [('a', [('b', [('x', '<f4')], (1000,))], (1000,))]}"),
     "more than 1000 fields"},
    {".npy", npy(records("('x', '|O'), ('y', '<f4'), ('z', '<f4')", "(1,)")), "of type '|O'"},
    {".npy", npy(records("('x', '<U999999999'), ('y', '<f4')", "(1,)")), "more than 65536 bytes"},
    {".npy", npy(records("('x', '<f4', (1000,)), ('y', '<f4')", "(1,)")), "more than 1000 numbers"},
    {".npy", npy(records("('x', '<f4'), ('y', '<f4'), ('z', '<f4'), ('X', '<f4')", "(2,)")),
     "2 points are announced, but only 12 bytes"},
    {".npy", npy(records("('X', '<f4'), ('y', '<f4'), ('z', '<f4'), ('X', '<f4')", "(1,)")),
     "two columns x"},
    {".npy", npy(records("('x', '<f4'), ('y', '<f4'), ('z', '<f4')", "(4294967296, 4294967296)")),
     "numbers that fit"},
    {".npy", npy(records("('x', '<f4'), ('y', '<f4'), ('z', '<f4')", "(4294967295, 4294967296)")),
     "are announced"},
    {".npy", npy("{'fortran_order': 0}"), "where False is expected"},
    {".npy", npy("{'shape': (1, 3"), "where ) is expected"},
    {".npy", npy("{'shape': (-1, 3)}"), "numbers that fit"},
    {".npy", npy("{'shape': (,)}"), "numbers that fit"},
    {".npy", npy("{'shape': (99999999999999999999, 3)}"), "numbers that fit"},
    {".npy", npy("{'shape': (" + std::string(200, '1') + ",)}"), "numbers that fit"},
    {".npy", npy("{'shape': (1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,3)"),
     "numbers that fit"},
    {".npy", npy(npy_header("<f4", "(1, 3)") + "import os"),
     "goes on after its end with 'import os'"},
    {".npy", npy(npy_header("<c8", "(1, 3)")), "of type '<c8', expected floating-point numbers or"},
    {".npy", npy(npy_header("|i4", "(1, 3)")), "of type '|i4'"},
    {".npy", npy(npy_header("i4", "(1, 3)")), "of type 'i4'"},
    {".npy", npy(npy_header("<i16", "(1, 3)")), "of type '<i16'"},
    {".npy", npy(npy_header("", "(1, 3)")), "of type ''"},
    {".npy", npy(npy_header("|O", "(1, 3)")), "of type '|O'"},
    {".npy", npy(npy_header("<f1", "(1, 3)")), "of type '<f1'"},
    {".npy", npy(npy_header("<f4", "(3,)")), "not of shape"},
    {".npy", npy(npy_header("<f4", "()")), "not of shape"},
    {".npy", npy(npy_header("<f4", "(1, 1001)")), "not of shape"},
    {".npy", npy(npy_header("<f4", "(1, 4)")), "only 12 bytes are left"},
    {".npy", npy(npy_header("<f4", "(3, 1)")), "not of shape"},
    {".npy", npy(npy_header("<f4", "(1, 3, 1)")), "not of shape"},
    {".npy", npy("{'descr': '<f4', 'fortran_order': True, 'shape': (2, 3)}"),
     "2 points are announced, but only 12 bytes are left"},
    {".npy", npy("{'descr': '<f4', 'fortran_order': True, 'shape': (1537228672809129302, 3)}"),
     "are announced"},
    {".npy", npy(npy_header("<f4", "(2, 3)")),
     "2 points are announced, but only 12 bytes are left"},
    {".npy", npy(npy_header("<f4", "(18446744073709551615, 3)")), "are announced"},
    {".npy", npy(npy_header("<f4", "(1537228672809129302, 3)")), "are announced"},
    {".npy", npy_file(npy_header("<f4", "(1, 3)"), bytes_of(std::nanf(""), false) + three_floats),
     "not finite"},
  });
}

void test_missing_files()
{
  CHECK(failure_of([]() {
          read_points(scratch.file("missing.ply"), File_format::PLY, {});
        }).says("No such file"));
  CHECK(failure_of([]() {
          read_points(scratch.file(""), File_format::PLY, {});
        }).says("Is a directory"));
}

} // namespace

int main()
{
  test_hostile_texts();
  test_hostile_ply();
  test_hostile_pcd();
  test_hostile_npy();
  test_missing_files();
  return test::result();
}
