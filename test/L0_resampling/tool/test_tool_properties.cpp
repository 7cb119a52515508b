// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a file tells of each point beside its place goes through reader and writer as it is, or is
// named as left out.

#include "test_support.h"
#include "tool/test_tool_reading.h"

#include "formats/Named_columns.h"
#include "formats/write_points.h"

#include <cstdint>
#include <functional>

namespace {

using namespace l0_tool;
using namespace tool_test;

Point_cloud read_everything(const std::string& extension, const std::string& bytes)
{
  return read(extension, bytes, with_everything());
}

std::string written(const std::string& extension, const Point_cloud& cloud)
{
  const std::string path = scratch.file("written" + extension);
  write_point_cloud(path, *format_of(path), cloud);
  std::string bytes = read_bytes(path);
  CHECK(bytes.size() <= maximum_file_size(*format_of(path), cloud.points.size(), cloud.properties));
  return bytes;
}

std::vector<std::string> left_out(const std::string& extension, const Point_cloud& cloud)
{
  const std::string path = scratch.file("written" + extension);
  return write_point_cloud(path, *format_of(path), cloud);
}

double value(const Point_cloud& cloud, std::size_t row, const std::string& name)
{
  for (const Property& property : cloud.properties.properties())
    if (property.name == name)
      return decode(cloud.properties.row(row) + property.offset, property.type, false);
  throw std::runtime_error("no property " + name);
}

std::string names_of(const Point_cloud& cloud)
{
  std::string names;
  for (const Property& property : cloud.properties.properties())
    names += property.name + " ";
  return names;
}

// Every type, in ASCII and in both byte orders, between and behind the coordinates.
const std::string all_types = "element vertex 2\nproperty char a\nproperty float x\nproperty uchar "
                              "b\nproperty short c\nproperty float y\n"
                              "property ushort d\nproperty float z\nproperty int e\nproperty uint "
                              "f\nproperty float g\nproperty double h\n";

std::string binary_rows(bool big)
{
  std::string bytes;
  for (const int k : {0, 1})
    bytes += bytes_of(std::int8_t(-128), big) + bytes_of(0.1f, big)
             + bytes_of(std::uint8_t(255), big) + bytes_of(std::int16_t(-300), big)
             + bytes_of(2.f, big) + bytes_of(std::uint16_t(65535), big) + bytes_of(3.f, big)
             + bytes_of(std::int32_t(k), big) + bytes_of(std::uint32_t(4294967295u), big)
             + bytes_of(0.3f, big) + bytes_of(0.7, big);
  return bytes;
}

void test_types_of_ply()
{
  const Point_cloud little = read_everything(".ply", ply_header("binary_little_endian", all_types)
                                                       + binary_rows(false));
  const Point_cloud big = read_everything(".ply", ply_header("binary_big_endian", all_types)
                                                    + binary_rows(true));
  const Point_cloud text =
    read_everything(".ply", ply_header("ascii", all_types)
                              + "-128 0.1 255 -300 2 65535 3 0 4294967295 0.3 0.7\n"
                                "-128 0.1 255 -300 2 65535 3 1 4294967295 0.3 0.7\n");
  CHECK(value(little, 1, "a") == -128 && value(little, 1, "b") == 255
        && value(little, 1, "c") == -300);
  CHECK(value(little, 1, "d") == 65535 && value(little, 0, "e") == 0 && value(little, 1, "e") == 1);
  CHECK(value(little, 1, "f") == 4294967295. && value(little, 1, "g") == double(0.3f)
        && value(little, 1, "h") == 0.7);

  // Coordinates first, and as narrow as they were
  const std::string bytes = written(".ply", little);
  std::string expected = "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float "
                         "x\nproperty float y\nproperty float z\n"
                         "property char a\nproperty uchar b\nproperty short c\nproperty ushort "
                         "d\nproperty int e\nproperty uint f\n"
                         "property float g\nproperty double h\nend_header\n";
  for (const int k : {0, 1})
    expected += bytes_of(0.1f, false) + bytes_of(2.f, false) + bytes_of(3.f, false)
                + bytes_of(std::int8_t(-128), false) + bytes_of(std::uint8_t(255), false)
                + bytes_of(std::int16_t(-300), false) + bytes_of(std::uint16_t(65535), false)
                + bytes_of(std::int32_t(k), false) + bytes_of(std::uint32_t(4294967295u), false)
                + bytes_of(0.3f, false) + bytes_of(0.7, false);
  CHECK(bytes == expected);
  CHECK(written(".ply", big) == bytes);
  CHECK(written(".ply", text) == bytes);
  CHECK(written(".ply", read_everything(".ply", bytes)) == bytes);

  // Through PCD and back, binary and as text
  const std::string pcd = written(".pcd", little);
  CHECK(pcd.find(
          "FIELDS x y z a b c d e f g h\nSIZE 4 4 4 1 1 2 2 4 4 4 8\nTYPE F F F I U I U I U F F\n")
        != std::string::npos);
  CHECK(written(".ply", read_everything(".pcd", pcd)) == bytes);
  std::string pcd_text = pcd.substr(0, pcd.find("DATA")) + "DATA ascii\n";
  for (const char* e : {"0", "1"})
    pcd_text += std::string("0.1 2 3 -128 255 -300 65535 ") + e + " 4294967295 0.3 0.7\n";
  CHECK(written(".ply", read_everything(".pcd", pcd_text)) == bytes);

  const Failure_seen seen = failure_of([]() {
    read_everything(".ply",
                    ply_header("ascii", "element vertex 1\n" + float_xyz + "property uchar red\n")
                      + "1 2 3 256\n");
  });
  CHECK(seen.status == INPUT_REFUSED && seen.says("'256' is not a number of the type of 'red'"));
}

// Without being asked, a reader keeps nothing that takes memory.
void test_nobody_asks()
{
  const std::string bytes = ply_header("binary_little_endian", all_types) + binary_rows(false);
  CHECK(read(".ply", bytes).properties.properties().empty());
  Read_options options = with_everything();
  options.max_memory = 2 * (sizeof(Point) + 26) - 1; // 26: the properties of a row
  const Failure_seen seen = failure_of([&]() { read(".ply", bytes, options); });
  CHECK(seen.status == RUN_TIME_FAILURE);
  ++options.max_memory;
  CHECK(read(".ply", bytes, options).points.size() == 2);
}

void test_dropped_points()
{
  Read_options options = with_everything();
  options.drop_non_finite = true;
  const Point_cloud cloud =
    read(".ply",
         ply_header("ascii", "element vertex 3\n" + float_xyz + "property int id\n")
           + "1 2 3 10\nnan 2 3 20\n4 5 6 30\n",
         options);
  CHECK(cloud.points.size() == 2 && value(cloud, 0, "id") == 10 && value(cloud, 1, "id") == 30);
}

void test_colors()
{
  // PCL packs them into the bytes of a float, or of an integer with alpha.
  const std::string rows = bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false);
  for (const auto& [name, type] :
       std::vector<std::pair<std::string, std::string>>{{"rgb", "F"}, {"rgb", "U"}, {"RGB", "U"}})
  {
    std::string file = pcd_header(" " + name, "4 4 4 4", "F F F " + type, "1", "binary");
    file.append(rows).append(bytes_of(std::uint32_t(0xff102030), false));
    const Point_cloud cloud = read_everything(".pcd", file);
    CHECK(names_of(cloud) == "red green blue ");
    CHECK(value(cloud, 0, "red") == 0x10 && value(cloud, 0, "green") == 0x20
          && value(cloud, 0, "blue") == 0x30);
  }
  const Point_cloud alpha = read_everything(".pcd",
                                            pcd_header(" rgba", "4 4 4 4", "F F F U", "1", "ascii")
                                              + "1 2 3 4279246896\n"); // 0xff102030
  CHECK(value(alpha, 0, "blue") == 0x30 && value(alpha, 0, "alpha") == 0xff);
  CHECK(written(".pcd", alpha).find("FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F U\n")
        != std::string::npos);
  CHECK(written(".pcd", alpha).substr(written(".pcd", alpha).size() - 4)
        == bytes_of(0xff102030u, false));
  CHECK(written(".off", alpha) == "COFF\n1 0 0\n1 2 3 16 32 48 255\n");
  CHECK(written(".ply", read_everything(".off", written(".off", alpha))).find("property double x")
        != std::string::npos);

  // Behind the normals; in another order, and with other properties around
  const Point_cloud cloud = read_everything(
    ".ply",
    ply_header(
      "ascii",
      "element vertex 1\n" + float_xyz
        + "property uchar blue\nproperty short i\nproperty uchar green\nproperty uchar red\n"
          "property float nx\nproperty float ny\nproperty float nz\n")
      + "1 2 3 4 5 6 7 0 0 1\n");
  CHECK(written(".off", cloud) == "CNOFF\n1 0 0\n1 2 3 0 0 1 7 6 4\n");
  CHECK(left_out(".off", cloud) == std::vector<std::string>{"i"});
  CHECK(written(".pcd", cloud).find("FIELDS x y z normal_x normal_y normal_z i rgb\n")
        != std::string::npos);
  CHECK(left_out(".pcd", cloud).empty() && left_out(".ply", cloud).empty());
  CHECK(left_out(".xyz", cloud).size() == 4 && left_out(".npy", cloud).size() == 4);
  CHECK(names_of(read_everything(".pcd", written(".pcd", cloud))) == "i red green blue ");
  CHECK(written(".xyz", cloud) == "1 2 3 0 0 1\n");

  // OFF with colors from 0 to 1, and of a kind that nobody knows
  const Point_cloud shares = read_everything(".off",
                                             "STCNOFF\n1 0 0\n1 2 3 0 0 1 0.5 1 0.25 0.125 7 8\n");
  CHECK(value(shares, 0, "red") == 0.5 && value(shares, 0, "alpha") == 0.125
        && shares.warnings.size() == 1);
  const Point_cloud small = read_everything(".off", "stcnoff\n1 0 0\n1 2 3 0 0 1 7 8 9 5 6\n");
  CHECK(small.properties.properties().size() == 3 && small.normals.size() == 1);
  CHECK(read_everything(".off", "coff\n1 0 0\n1 2 3 7 8 9\n").warnings.empty());
  for (const char* text :
       {"OFF\n2 0 0\n1 2 3 7 8 9\n1 2 3 7 8 9\n", "NOFF\n1 0 0\n1 2 3 0 0 1 7 8 9\n"})
  {
    const Point_cloud unnamed = read_everything(".off", text);
    CHECK(unnamed.properties.properties().empty() && unnamed.warnings.size() == 1);
    CHECK(unnamed.warnings[0].find("the last 3 numbers of the rows are left out")
          != std::string::npos);
  }
  const Point_cloud map = read_everything(".off", "COFF\n1 0 0\n1 2 3 17\n");
  CHECK(names_of(map).empty() && map.warnings.size() == 1);
  CHECK(
    failure_of([]() { read_everything(".off", "COFF\n2 0 0\n1 2 3 4 5 6\n1 2 3 4 5\n"); }).status
    == INPUT_REFUSED);
}

// Columns of a text that have names: their types come from all of their numbers.
void test_names_of_columns()
{
  Read_options options = with_everything();
  const auto header_of = [&](const std::string& list, const std::string& rows) {
    options.columns = parse_column_names(list);
    const std::string bytes = written(".ply", read(".xyz", rows, options));
    const std::string before = "property double z\n";
    return bytes.substr(bytes.find(before) + before.size());
  };
  const std::string end = "end_header\n";
  const std::string xyz = bytes_of(1., false) + bytes_of(2., false) + bytes_of(3., false);
  CHECK(header_of("red,z,y,-,x,alpha", "0 3 2 word 1 9\n255 3 2 word 1 0\n")
        == "property uchar red\nproperty uchar alpha\n" + end + xyz + std::string("\0\x09", 2) + xyz
             + std::string("\xff\0", 2));
  CHECK(header_of("x,y,z,a,b", "1 2 3 -7 4294967295\n")
        == "property int a\nproperty uint b\n" + end + xyz + bytes_of(std::int32_t(-7), false)
             + bytes_of(std::uint32_t(4294967295u), false));
  CHECK(header_of("x,y,z,a,_", "1 2 3 7 0\n1 2 3 0.5 0\n")
        == "property double a\n" + end + xyz + bytes_of(7., false) + xyz + bytes_of(.5, false));
  CHECK(header_of("x,y,z,a", "1 2 3 4294967296\n")
        == "property double a\n" + end + xyz + bytes_of(4294967296., false));
  // All channels of a color are bytes, or all have 16 bits, or none of them is whole.
  for (const auto& [number, type] : {std::pair<std::string, std::string>("256", "ushort"),
                                     {"65535", "ushort"},
                                     {"65536", "double"},
                                     {"0.5", "double"},
                                     {"-1", "double"},
                                     {"nan", "double"}})
    CHECK(header_of("x,y,z,red,blue", "1 2 3 1 " + number + "\n")
            .find("property " + type + " red\nproperty " + type + " blue\n")
          == 0);
  options.with_properties = false;
  CHECK(header_of("x,y,z,red", "1 2 3 1\n") == end + xyz);
  options.with_properties = true;

  // As other programs spell them
  for (const char* list : {"x_coord,y_coord,z_coord,Rf,Gf,Bf",
                           "Coord_X,Coord_Y,Coord_Z,color_red,color_green,color_blue"})
    CHECK(parse_column_names(list) == (Column_names{"x", "y", "z", "red", "green", "blue"}));

  for (const char* bad :
       {"", "x,y", "x,y,z,x", "x,y,z,nx", "x,y,z,", "x,y,z,a b", "x,y,z,a,a", "x,y,z,\xc3\xa4"})
    CHECK(failure_of([&]() { parse_column_names(bad); }).status == WRONG_USAGE);
  CHECK(failure_of([&]() {
          header_of("x,y,z,a", "1 2 3 4\n1 2 3 4 5\n");
        }).says("line 2: --columns names 4, found 5"));
  CHECK(
    failure_of([&]() { header_of("x,y,z,a", "1 2 3 b\n"); }).says("line 1: 'b' is not a number"));
}

// Where a file has normals, or none
void test_normals()
{
  const Point_cloud bare = read_everything(".xyz", "0.1 2 3\n4 5 6\n");
  CHECK(written(".xyz", bare) == "0.1 2 3\n4 5 6\n");
  CHECK(written(".off", bare) == "OFF\n2 0 0\n0.1 2 3\n4 5 6\n");
  CHECK(written(".npy", bare).find("'<f8', 'fortran_order': False, 'shape': (2, 3)")
        != std::string::npos);
  CHECK(written(".ply", bare).find("nx") == std::string::npos);
  CHECK(written(".pcd", bare).find("normal_x") == std::string::npos);
  CHECK(read_everything(".ply", written(".ply", bare)).points == bare.points);
  CHECK(read_everything(".npy", written(".npy", bare)).points == bare.points);

  const Point_cloud single = read_everything(
    ".npy", npy_file(npy_header("<f4", "(1, 6)"), std::string(20, '\0') + bytes_of(1.f, false)));
  CHECK(written(".npy", single).find("'<f4'") != std::string::npos);
  CHECK(read_everything(".npy", written(".npy", single)).normals.size() == 1);
}

void test_what_is_left_out()
{
  const Point_cloud lists =
    read_everything(".ply", ply_header("ascii", "element vertex 1\n" + float_xyz
                                                  + "property list uchar int id\nelement face 3\n"
                                                    "property list uchar int v\n")
                              + "1 2 3 1 9\n0\n0\n0\n");
  CHECK(names_of(lists).empty() && lists.warnings.size() == 2);
  CHECK(lists.warnings[0].find("the lists 'id'") != std::string::npos);
  CHECK(lists.warnings[1].find("3 of 'face'") != std::string::npos);

  const Point_cloud wide =
    read_everything(".pcd", "VERSION .7\nFIELDS x y z _ t h many\nSIZE 4 4 4 1 8 2 1\nTYPE F F "
                            "F U U I U\nCOUNT 1 1 1 4 1 2 1001\nWIDTH 1\n"
                            "HEIGHT 1\nPOINTS 1\nDATA binary\n"
                              + std::string(12 + 4 + 8, '\0') + bytes_of(std::int16_t(7), false)
                              + bytes_of(std::int16_t(8), false) + std::string(1001, 'm'));
  CHECK(names_of(wide) == "t h_0 h_1 ");
  CHECK(value(wide, 0, "h_0") == 7 && value(wide, 0, "h_1") == 8);
  CHECK(wide.warnings.size() == 1); // many, and not the padding

  CHECK(read_everything(".xyz", "1 2 3 4\n").warnings.size() == 1);
  CHECK(read_everything(".xyz", "1 2 3 0 0 1\n").warnings.empty());

  // A name that the format has for something else
  const Point_cloud twice = read_everything(".pcd", pcd_header(" normal_x normal_y normal_z nx",
                                                               "4 4 4 4 4 4 4", "F F F F F F F",
                                                               "1", "ascii")
                                                      + "1 2 3 0 0 1 9\n");
  CHECK(left_out(".ply", twice) == std::vector<std::string>{"nx"}
        && left_out(".pcd", twice).empty());
  CHECK(twice.normals == std::vector<Vector>{Vector(0, 0, 1)} && value(twice, 0, "nx") == 9);
}

// All formats keep them alike: as narrow as values allow, and rounded where a double does that.
void test_integers_of_64_bits()
{
  using Rows = std::vector<std::int64_t>;
  const auto clouds_of = [](const Rows& rows) {
    const std::string n = std::to_string(rows.size());
    std::string text, little, big, pcd;
    for (const std::int64_t id : rows)
    {
      text += "1 2 3 " + std::to_string(id) + "\n";
      for (const bool is_big : {false, true})
        (is_big ? big : little) += bytes_of(1.f, is_big) + bytes_of(2.f, is_big)
                                   + bytes_of(3.f, is_big) + bytes_of(id, is_big);
    }
    const std::string ply = "element vertex " + n + "\n" + float_xyz + "property int64 id\n";
    return std::vector<Point_cloud>{
      read_everything(".xyz", "# x y z id\n" + text),
      read_everything(".ply", ply_header("ascii", ply) + text),
      read_everything(".ply", ply_header("binary_little_endian", ply) + little),
      read_everything(".ply", ply_header("binary_big_endian", ply) + big),
      read_everything(".pcd", pcd_header(" id", "4 4 4 8", "F F F I", n, "ascii") + text),
      read_everything(".pcd", pcd_header(" id", "4 4 4 8", "F F F I", n, "binary") + little)};
  };
  constexpr std::int64_t limit = std::int64_t(1) << 53;
  for (const Point_cloud& cloud : clouds_of({-7, 9}))
  {
    CHECK(cloud.properties.find("id")->type == Number_type::INT32 && cloud.warnings.empty());
    CHECK(value(cloud, 0, "id") == -7 && value(cloud, 1, "id") == 9);
  }
  for (const Point_cloud& cloud : clouds_of({1 - limit, limit - 1}))
  {
    CHECK(!cloud.properties.find("id")->is_measured && cloud.warnings.empty());
    CHECK(value(cloud, 0, "id") == double(1 - limit) && value(cloud, 1, "id") == double(limit - 1));
  }
  for (const Point_cloud& cloud : clouds_of({3, 10 * limit + 1}))
  {
    CHECK(value(cloud, 1, "id") == double(10 * limit) && cloud.warnings.size() == 1
          && cloud.warnings[0].find("numbers of 'id' are rounded") != std::string::npos);
  }
  for (const char* word : {"0.5", "-1", "2e19", "many"})
    CHECK(refusal(".ply",
                  ply_header("ascii", "element vertex 1\n" + float_xyz + "property uint64 id\n")
                    + "1 2 3 " + word + "\n",
                  with_everything())
            .says("is not a number of the type of 'id'"));
}

// What tells labels and marks of no data from measurements are all values.
void test_meanings()
{
  const auto property_of = [](const std::function<std::string(int)>& value_of, int number,
                              const std::string& name = "depth") {
    std::string text = "# x y z " + name + "\n";
    for (int i = 0; i < number; ++i)
      text += "1 2 3 " + value_of(i) + "\n";
    return *read_everything(".xyz", text).properties.find(name);
  };
  const auto fraction = [](int i) { return std::to_string(i) + ".25"; };
  const auto labels = [&](int i) { return i == 7 ? "nan" : fraction(i % 20); };
  CHECK(!property_of(labels, 201).is_measured && property_of(labels, 200).is_measured);
  const auto bytes = [&](int i) { return fraction(i % 256); };
  CHECK(!property_of(bytes, 10000).is_measured && property_of(bytes, 2000).is_measured);
  CHECK(property_of([&](int i) { return fraction(i % 257); }, 10000).is_measured);

  using Marks = std::vector<double>;
  const auto with_mark = [&](const std::string& mark) {
    return [&, mark](int i) { return i % 30 == 3 ? mark : fraction(i); };
  };
  for (const std::string mark : {"-9999", "-3.5e38", "1e30"})
  {
    const Property marked = property_of(with_mark(mark), 100);
    CHECK(marked.is_measured && marked.no_data == Marks{std::stod(mark)});
    CHECK(property_of(with_mark(mark), 30).no_data.empty()); // of one point
  }
  CHECK(property_of(with_mark("-90"), 100).no_data.empty()); // near to the others
  CHECK(property_of(fraction, 100).no_data.empty());
  CHECK(property_of(with_mark("-9999"), 100, "red").no_data.empty());
  // Whole numbers are labels, and need no mark
  const Property whole = property_of([](int i) { return i % 9 ? std::to_string(i) : "-9999"; }, 50);
  CHECK(!whole.is_measured && whole.no_data.empty());
}

} // namespace

int main()
{
  test_types_of_ply();
  test_integers_of_64_bits();
  test_meanings();
  test_nobody_asks();
  test_dropped_points();
  test_colors();
  test_names_of_columns();
  test_normals();
  test_what_is_left_out();
  return test::result();
}
