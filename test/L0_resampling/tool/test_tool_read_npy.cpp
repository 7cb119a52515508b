// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The reader of NPY: all types of numbers in either byte order, and all orders of columns.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace l0_tool;
using namespace tool_test;

void test_npy()
{
  for (const bool big : {false, true})
  {
    const std::string order = big ? ">" : "<";
    std::string singles, doubles, units;
    const double unit[] = {0, 1. / 3, 2. / 3, .6, 0, -.8};
    for (int k = 0; k < 6; ++k)
    {
      units += bytes_of(unit[k], big);
      singles += bytes_of(float(k) / 3, big);
      doubles += bytes_of(double(k) / 3, big);
    }
    const auto single = [](int k) { return double(float(k) / 3); };
    CHECK(read(".npy", npy_file(npy_header(order + "f4", "(2, 3)"), singles)).points
          == (std::vector<Point>{Point(0, single(1), single(2)), Point(1, single(4), single(5))}));
    CHECK(read(".npy", npy_file(npy_header(order + "f8", "(2,3)"), doubles), with_normals())
            .normals.empty());
    const Point_cloud cloud = read(".npy", npy_file(npy_header(order + "f8", "(1, 6)"), units),
                                   with_normals());
    CHECK(cloud.points == std::vector<Point>{Point(0, 1. / 3, 2. / 3)});
    CHECK(cloud.normals == std::vector<Vector>{Vector(.6, 0, -.8)});
    CHECK(read(".npy", npy_file(npy_header(order + "f8", "(1, 3)"), doubles)).warnings.size() == 1);
  }
  // another order of the names, no comma at the end, a long header of version 2
  const std::string header = "{'shape':(0,3),'fortran_order':False,'descr':'<f4'}"
                             + std::string(100, ' ') + "\n";
  CHECK(read(".npy", npy_file(header)).points.empty());
  const std::string version_2 = std::string("\x93NUMPY\x02\x00", 8)
                                + bytes_of(std::uint32_t(header.size()), false) + header;
  CHECK(read(".npy", version_2).points.empty());
}

template <typename T>
void test_npy_integers(const std::string& type)
{
  for (const std::string& order :
       sizeof(T) == 1 ? std::vector<std::string>{"|", "<"} : std::vector<std::string>{"<", ">"})
  {
    const T lowest = (std::numeric_limits<T>::min)(), highest = (std::numeric_limits<T>::max)();
    std::string body;
    for (const T number : {T(1), lowest, highest})
      body += bytes_of(number, order == ">");
    const Point_cloud cloud = read(".npy", npy_file(npy_header(order + type, "(1, 3)"), body));
    CHECK(cloud.points == std::vector<Point>{Point(1, double(lowest), double(highest))});
    CHECK((cloud.coordinate_type == Number_type::FLOAT32) == (sizeof(T) <= 2));
  }
}

// Column by column, as numpy.save() writes the transpose of an array
void test_npy_in_the_order_of_fortran()
{
  const auto header = [](const std::string& shape) {
    return "{'descr': '<f8', 'fortran_order': True, 'shape': " + shape + ", }\n";
  };
  std::string doubles;
  for (int k = 0; k < 12; ++k)
    doubles += bytes_of(double(k), false);
  const std::string points = npy_file(header("(4, 3)"), doubles);
  CHECK(read(".npy", points).points
        == (std::vector<Point>{Point(0, 4, 8), Point(1, 5, 9), Point(2, 6, 10), Point(3, 7, 11)}));
  std::string units = doubles.substr(0, 48);
  for (const double number : {1., 0., 0., .6, 0., .8})
    units += bytes_of(number, false);
  const Point_cloud cloud = read(".npy", npy_file(header("(2, 6)"), units), with_normals());
  CHECK(cloud.points == (std::vector<Point>{Point(0, 2, 4), Point(1, 3, 5)}));
  CHECK(cloud.normals == (std::vector<Vector>{Vector(1, 0, 0), Vector(0, .6, .8)}));
  const Point_cloud colored = read(".npy", npy_file(header("(2, 6)"), doubles), with_everything());
  CHECK(colored.points == cloud.points && colored.normals.empty());
  CHECK(colored.warnings.size() == 1
        && colored.warnings[0].find("no unit vectors and not taken for normals; --columns")
             != std::string::npos);
  CHECK(read(".npy", npy_file(header("(0, 3)"))).points.empty());
  // As Python 2 has written it
  CHECK(read(".npy", npy_file(header("(4L, 3L)"), doubles)).points == read(".npy", points).points);
  std::string quoted = header("(4, 3)");
  std::replace(quoted.begin(), quoted.end(), '\'', '"');
  CHECK(read(".npy", npy_file(quoted, doubles)).points == read(".npy", points).points);
  CHECK(read(".npy", points + "more").warnings.size() == 1);

  const std::size_t n = 20000; // more than a block of the file
  std::string many;
  for (std::size_t k = 0; k < 3 * n; ++k)
    many += bytes_of(double(k), false);
  const Point_cloud large = read(".npy", npy_file(header("(20000, 3)"), many));
  CHECK(large.points.size() == n && large.points.back() == Point(n - 1, 2 * n - 1, 3 * n - 1));

  // The columns take memory too
  Read_options options;
  options.max_memory = 4 * sizeof(Point) + 96;
  CHECK(read(".npy", points, options).points.size() == 4);
  --options.max_memory;
  CHECK(refusal(".npy", points, options).status == RUN_TIME_FAILURE);
}

// Columns that the caller names, and numbers of 16 bits
void test_npy_with_more_columns()
{
  std::string body;
  for (const double number : {1., 2., 3., 7., 4., 5., 6., 8.})
    body += bytes_of(number, false);
  const std::string four = npy_file(npy_header("<f8", "(2, 4)"), body);
  const std::vector<Point> two = {Point(1, 2, 3), Point(4, 5, 6)};
  Read_options options = with_everything();
  const Point_cloud unnamed = read(".npy", four, options);
  CHECK(unnamed.points == two && unnamed.properties.properties().empty());
  CHECK(unnamed.warnings.size() == 1
        && unnamed.warnings[0].find("--columns can name them") != std::string::npos);
  std::string numbered;
  for (int i = 0; i < 20; ++i)
    for (const double number : {double(i), 2. * i, 3., 4.})
      numbered += bytes_of(number, false);
  CHECK(refusal(".npy", npy_file(npy_header("<f8", "(20, 4)"), numbered))
          .says("the first column numbers the points"));
  options.columns = {"x", "y", "z", "label"};
  const Point_cloud named = read(".npy", four, options);
  CHECK(named.points == two && named.warnings.empty());
  CHECK(named.properties.properties().at(0).name == "label");
  CHECK(named.properties.value(1, named.properties.properties()[0]) == 8);
  options.columns = {"x", "y", "z"};
  CHECK(refusal(".npy", four, options).says("--columns names 3, found 4 columns"));
  CHECK(refusal(".npy", npy_file(npy_header("<f8", "(4, 2)"), body)).says("not of shape (n, 3)"));

  // The pixels of an image, and points that are columns
  for (const char* shape : {"(1, 2, 4)", "(2, 1, 4)", "(1, 1, 2, 4)"})
    CHECK(read(".npy", npy_file(npy_header("<f8", shape), body)).points == two);
  CHECK(refusal(".npy",
                npy_file("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 1, 4), }\n", body))
          .says("not of shape (n, 3)"));
  CHECK(refusal(".npy", npy_file(npy_header("<f8", "(3, 17)"), std::string(3 * 17 * 8, '\0')))
          .says("its transpose has them in rows"));
  CHECK(refusal(".npy", npy_file(npy_header("<f8", "(99999999999, 99999999999, 3)"), body)).status
        == INPUT_REFUSED);
  CHECK(refusal(".npy", "PK\3\4 points.npy").says("NPZ"));

  // 1, -2, 65504, the least one above 0, infinity
  const auto half = [](std::uint16_t bits, bool big) { return bytes_of(bits, big); };
  for (const bool big : {false, true})
  {
    const std::string halves = half(0x3c00, big) + half(0xc000, big) + half(0x7bff, big)
                               + half(0x0001, big) + half(0x3555, big) + half(0x8000, big);
    const Point_cloud cloud = read(".npy",
                                   npy_file(npy_header(big ? ">f2" : "<f2", "(2, 3)"), halves));
    CHECK(
      cloud.points
      == (std::vector<Point>{Point(1, -2, 65504), Point(std::ldexp(1, -24), 0.333251953125, 0)}));
    CHECK(cloud.coordinate_type == Number_type::FLOAT32);
    CHECK(refusal(".npy", npy_file(npy_header(big ? ">f2" : "<f2", "(1, 3)"),
                                   half(0x7c00, big) + half(0, big) + half(0, big)))
            .says("not finite"));
  }
}

void test_npy_of_records()
{
  const auto file = [](const std::string& fields, const std::string& shape,
                       const std::string& body) {
    return npy_file(
      "{'descr': [" + fields + "], 'fortran_order': False, 'shape': " + shape + ", }\n", body);
  };
  const auto f = [](float number) { return bytes_of(number, false); };
  const std::string xyz = f(1) + f(2) + f(3);
  const std::vector<Point> one = {Point(1, 2, 3)};
  const auto value = [](const Point_cloud& cloud, std::size_t k) {
    return cloud.properties.value(0, cloud.properties.properties().at(k));
  };

  // Names, a color of three values, padding, an integer of 64 bits, a text, a title
  const Point_cloud cloud = read(
    ".npy",
    file("('X', '<f4'), ('Y', '<f4'), ('Z', '<f4'), ('normals', '<f4', (3,)), ('', '|V2'), "
         "('rgb', '|u1', (3,)), ('label', '>i8'), ('note', '<U2'), (('a title', 'time'), '<f8')",
         "(1,)",
         xyz + f(0) + f(0) + f(1) + "pp" + "\x09\x08\x07" + bytes_of(std::int64_t(-5), true)
           + "12345678" + bytes_of(.5, false)),
    with_everything());
  CHECK(cloud.points == one && cloud.normals == std::vector<Vector>{Vector(0, 0, 1)});
  CHECK(cloud.warnings.size() == 1
        && cloud.warnings[0].find("'note' is left out: of type <U2") != std::string::npos);
  CHECK(cloud.properties.properties().size() == 5);
  CHECK(cloud.properties.properties()[0].name == "red" && value(cloud, 0) == 9);
  CHECK(cloud.properties.properties()[3].type == Number_type::INT32 && value(cloud, 3) == -5);
  CHECK(cloud.properties.properties()[4].type == Number_type::FLOAT64 && value(cloud, 4) == .5);

  // Records within records, whose names are there twice
  for (const char* fields : {"('position', [('x', '<f4'), ('y', '<f4'), ('z', '<f4')]), "
                             "('normal', [('x', '<f4'), ('y', '<f4'), ('z', '<f4')])",
                             "('xyz', '<f4', (3,)), ('normal', '<f4', 3)"})
  {
    const bool has_plain_shape = std::string(fields).find(", 3)") != std::string::npos;
    const std::string bytes = file(fields, "(1, 1)", xyz + f(0) + f(-1) + f(0));
    if (has_plain_shape)
    {
      CHECK(refusal(".npy", bytes).says("is expected"));
      continue;
    }
    const Point_cloud nested = read(".npy", bytes, with_everything());
    CHECK(nested.points == one && nested.normals == std::vector<Vector>{Vector(0, -1, 0)});
    CHECK(nested.properties.properties().empty());
  }

  // Names of the caller, of all numbers
  Read_options options = with_everything();
  options.columns = {"x", "y", "z", "height"};
  const std::string odd = file("('a', '<f4', (2,)), ('b', '<f4'), ('c', '|u1')", "(1,)",
                               xyz + "\5");
  CHECK(read(".npy", odd, options).points == one && value(read(".npy", odd, options), 0) == 5);
  CHECK(
    refusal(".npy", odd).says("no fields x, y and z; --columns can name theirs, which are 'a_0'"));
}

} // namespace

int main()
{
  test_npy();
  test_npy_integers<std::int8_t>("i1");
  test_npy_integers<std::uint8_t>("u1");
  test_npy_integers<std::int16_t>("i2");
  test_npy_integers<std::uint16_t>("u2");
  test_npy_integers<std::int32_t>("i4");
  test_npy_integers<std::uint32_t>("u4");
  test_npy_integers<std::int64_t>("i8");
  test_npy_integers<std::uint64_t>("u8");
  test_npy_in_the_order_of_fortran();
  test_npy_with_more_columns();
  test_npy_of_records();
  return test::result();
}
