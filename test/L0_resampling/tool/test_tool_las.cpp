// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// LAS: every version and point format, extra bytes, coordinate systems and filters, and the way
// back. test_tool_write_las.cpp has what is written of other points, test_tool_degrees.cpp what
// tells that x and y are degrees, and test_tool_hostile_las.cpp the files that are refused.

#include "test_support.h"
#include "tool/test_tool_reading.h"
#include "tool/test_tool_las.h"

namespace {

using namespace l0_tool;
using namespace tool_test;

std::map<std::string, double> expected_values(const Las_point& p, unsigned format)
{
  const double angle = format < 6 ? p.angle : double(float(p.angle * 0.006));
  std::map<std::string, double> all = {{"intensity", p.intensity},
                                       {"return_number", p.return_number},
                                       {"number_of_returns", p.number_of_returns},
                                       {"scan_direction_flag", p.direction},
                                       {"edge_of_flight_line", p.edge},
                                       {"classification", p.classification},
                                       {"classification_flags", p.flags},
                                       {"scan_angle", angle},
                                       {"user_data", p.user_data},
                                       {"point_source_id", p.source}};
  if (format >= 6)
    all["scanner_channel"] = p.channel;
  if (format != 0 && format != 2)
    all["gps_time"] = p.time;
  if (format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10)
    for (std::size_t k = 0; k < 3; ++k)
      all[std::array<const char*, 3>{"red", "green", "blue"}[k]] = p.color[k];
  if (format == 8 || format == 10)
    all["nir"] = p.infrared;
  return all;
}

// All versions and formats are read, and written again byte by byte, but for waveforms.
void test_versions_and_formats()
{
  Las_point first, second;
  first.x = 63701234;
  first.y = -84902833;
  first.z = 2147483647;
  second.x = -2147483647;
  second.number_of_returns = second.return_number = 7;
  second.direction = 0;
  second.edge = 1;
  second.classification = 31;
  second.flags = 0;
  second.channel = 3;
  second.angle = 127;
  second.intensity = 65535;
  for (unsigned minor = 0; minor <= 4; ++minor)
    for (unsigned format = 0; format <= 10; ++format)
    {
      if (format >= 6 && minor < 4)
        continue;
      Las_file file;
      file.minor = minor;
      file.format = format;
      file.points = {first.bytes(format), second.bytes(format)};
      const std::string bytes = file.bytes();
      const Point_cloud cloud = read_las(bytes);
      CHECK(cloud.points.size() == 2 && cloud.normals.empty() && !cloud.file_has_normals);
      CHECK(cloud.points[0]
            == Point(63701234 * 0.01 + 1000, -84902833 * 0.01 + 2000, 2147483647 * 0.001 - 5));
      CHECK(values(cloud, 0) == expected_values(first, format));
      CHECK(values(cloud, 1) == expected_values(second, format));
      CHECK(cloud.warnings.empty() && cloud.coordinate_type == Number_type::FLOAT64);
      const bool has_waveforms = format == 4 || format == 5 || format >= 9;
      CHECK(cloud.notes.size() == (has_waveforms ? 1 : 0));

      // format, and the one without waveforms
      static constexpr std::array<unsigned, 11> written_as = {0, 1, 2, 3, 1, 3, 6, 7, 8, 6, 8};
      const std::string again = written(cloud);
      CHECK(integer_at(again, 104, 1) == written_as[format]);
      CHECK(integer_at(again, 25, 1) == (format < 6 ? 2 : 4));
      CHECK(point_bytes(again, 0) == first.bytes(written_as[format]));
      CHECK(point_bytes(again, 1) == second.bytes(written_as[format]));
      CHECK(again.substr(131, 48) == bytes.substr(131, 48)); // scales and offsets
      CHECK(double_at(again, 179) == cloud.points[0].x());
      CHECK(double_at(again, 187) == cloud.points[1].x());
      // returns
      CHECK(integer_at(again, format < 6 ? 115 : 263, 4) == 1
            && integer_at(again, format < 6 ? 111 : 255, 4) == 0);
      CHECK(format < 6 || integer_at(again, 255 + 6 * 8, 8) == 1);
      CHECK(written(read_las(again)) == again);
    }
}

// A count of 64 bits, a header that is longer than its version, points that are longer than their
// format.
void test_what_is_longer()
{
  Las_file file;
  file.minor = 4;
  file.format = 6;
  file.points = {Las_point().bytes(6) + "12345", Las_point().bytes(6) + "12345"};
  file.before_points = "padding";
  std::string bytes = file.bytes();
  const Point_cloud cloud = read_las(bytes);
  CHECK(cloud.points.size() == 2 && cloud.properties.properties().size() == 12);
  CHECK(cloud.warnings.size() == 1
        && cloud.warnings[0].find("5 bytes of each point are left out") != std::string::npos);
  bytes = with_bytes(bytes, 94, le(std::uint16_t(375 + 7))); // the padding belongs to the header
  CHECK(read_las(bytes).points.size() == 2);
  bytes = with_bytes(with_bytes(bytes, 107, le(2u)), 247, le(std::uint64_t(0)));
  CHECK(read_las(bytes).points.size() == 2); // the count of older versions
  CHECK(read_las(bytes + "more").warnings.size() == 2);
  CHECK(read_las(bytes, {}).warnings.empty()); // nobody asks for properties
  CHECK(read_las(bytes, {}).properties.properties().empty());
  CHECK(read_las(Las_file().bytes()).points.empty());
}

void test_extra_bytes()
{
  // All types, with and without scale; two or three numbers; bytes without a meaning
  std::string record, data;
  const auto add = [&](const std::string& description, const std::string& number) {
    record += description;
    data += number;
  };
  add(extra_bytes("u8", 1), le(std::uint8_t(200)));
  add(extra_bytes("i8", 2), le(std::int8_t(-100)));
  add(extra_bytes("u16", 3), le(std::uint16_t(60000)));
  add(extra_bytes("i16", 4), le(std::int16_t(-30000)));
  add(extra_bytes("u32", 5), le(std::uint32_t(4000000000u)));
  add(extra_bytes("i32", 6), le(std::int32_t(-2000000000)));
  add(extra_bytes("u64", 7), le(std::uint64_t(1)));
  add(extra_bytes("i64", 8, 24, {0.5, 0, 0}, {3, 0, 0}), le(std::int64_t(-9)));
  add(extra_bytes("f32", 9), le(0.1f));
  add(extra_bytes("f64", 10), le(0.1));
  add(extra_bytes("two", 14), le(std::int16_t(-1)) + le(std::int16_t(2)));
  add(extra_bytes("three", 21, 8, {0.5, 2, 3}), std::string("\1\2\3"));
  add(extra_bytes("", 0, 3), "???");
  add(extra_bytes("with a \xc3\xa4", 1), std::string("\x11"));
  add(extra_bytes("", 1), std::string("\x12"));
  add(extra_bytes("shifted", 2, 16, {7, 0, 0}, {100, 0, 0}), std::string("\xff"));
  std::map<std::string, double> expected = expected_values(Las_point(), 1);
  expected.insert({{"u8", 200},
                   {"i8", -100},
                   {"u16", 60000},
                   {"i16", -30000},
                   {"u32", 4e9},
                   {"i32", -2e9},
                   {"u64", 1},
                   {"i64", -1.5},
                   {"f32", double(0.1f)},
                   {"f64", 0.1},
                   {"two_0", -1},
                   {"two_1", 2},
                   {"three_0", 0.5},
                   {"three_1", 4},
                   {"three_2", 9},
                   {"shifted", 99},
                   {"with_a_\xc3\xa4", 0x11},
                   {"extra_bytes_14", 0x12}});
  Las_file file;
  file.minor = 4;
  file.format = 1;
  file.points.assign(3, Las_point().bytes(1) + data);
  file.records = {las_record("other", 4, "not these"), las_record("LASF_Spec", 4, record)};
  const Point_cloud cloud = read_las(file.bytes());
  CHECK(values(cloud, 2) == expected);
  CHECK(cloud.warnings.empty());

  // They are written in their types, and read the same
  const Point_cloud again = read_las(written(cloud));
  CHECK(values(again, 2) == expected && again.warnings.empty());
  for (std::size_t k = 0; k < cloud.properties.properties().size(); ++k)
    CHECK(again.properties.properties()[k].type == cloud.properties.properties()[k].type);

  // In two records, one of which stands behind the points
  Las_file late = file;
  late.records = {las_record("LASF_Spec", 4, record.substr(0, 10 * 192))};
  late.extended_records = {las_extended_record("else", 4, std::string(100000, 'e')),
                           las_extended_record("LASF_Spec", 4, record.substr(10 * 192))};
  const Point_cloud of_late = read_las(late.bytes());
  expected["extra_bytes_4"] = expected["extra_bytes_14"]; // counted within its record
  expected.erase("extra_bytes_14");
  CHECK(values(of_late, 2) == expected && of_late.warnings.empty());
  const Point_cloud compressed = read_las(gzip(late.bytes()));
  CHECK(compressed.points == of_late.points && values(compressed, 0).size() < expected.size());
  CHECK(compressed.warnings.size() == 2
        && compressed.warnings[1].find("comes too late") != std::string::npos);

  // More is described than there is
  for (std::string& point : file.points)
    point.pop_back();
  const Point_cloud without = read_las(file.bytes());
  CHECK(values(without, 0) == expected_values(Las_point(), 1));
  CHECK(without.warnings.size() == 1
        && without.warnings[0].find("55 of them are described, but a point has 54")
             != std::string::npos);
}

void test_normals()
{
  const auto cloud_of = [](const std::array<std::string, 3>& names, unsigned type,
                           const std::string& normal) {
    Las_file file;
    file.minor = 4;
    file.format = 6;
    file.points.assign(2, Las_point().bytes(6) + normal);
    file.records = {las_record("LASF_Spec", 4,
                               extra_bytes(names[0], type) + extra_bytes(names[1], type)
                                 + extra_bytes(names[2], type))};
    return read_las(file.bytes());
  };
  const std::string doubles = le(0.6) + le(0.) + le(0.8), floats = le(0.f) + le(0.6f) + le(-0.8f);
  const Point_cloud of_doubles = cloud_of({"nx", "ny", "nz"}, 10, doubles);
  CHECK(of_doubles.normals.size() == 2 && of_doubles.normals[1] == Vector(0.6, 0, 0.8));
  const Point_cloud of_floats = cloud_of({"NormalX", "NormalY", "NormalZ"}, 9, floats);
  CHECK(of_floats.file_has_normals && of_floats.normals.size() == 2
        && of_floats.normals[0] == Vector(0, double(0.6f), double(-0.8f)));
  CHECK(values(of_floats, 0) == expected_values(Las_point(), 6));
  CHECK(written(of_floats).find(padded("NormalX", 32)) != std::string::npos);
  CHECK(read_las(written(of_floats)).normals == of_floats.normals);
  CHECK(cloud_of({"normal_x", "normal_y", "normal_z"}, 9, floats).normals == of_floats.normals);
  // No normals: a name is missing, or they are integers, or of another length
  CHECK(cloud_of({"nx", "ny", "n"}, 9, floats).normals.empty());
  CHECK(cloud_of({"nx", "NormalY", "nz"}, 9, floats).normals.empty());
  CHECK(cloud_of({"nx", "ny", "nz"}, 9, le(9.f) + floats.substr(4)).normals.empty());
  const Point_cloud integers = cloud_of({"nx", "ny", "nz"}, 6, floats);
  CHECK(integers.normals.empty() && values(integers, 0).count("nx") == 1);
}

void test_coordinate_system()
{
  const std::string keys = las_record("LASF_Projection", 34735, std::string("\1\0\1\0\0\0", 6)),
                    text = las_record("LASF_Projection", 34737, "WGS 84|"),
                    wkt = las_record("LASF_Projection", 2112, "PROJCS[\"UTM\"]");
  Las_file file;
  file.minor = 3;
  file.format = 1;
  file.encoding = 1 + 2 + 8 + 16; // standard time; waveforms; what version 1.4 alone has
  file.points = {Las_point().bytes(1)};
  file.records = {las_record("other", 2, "x"), keys, text};
  const std::string old = written(read_las(file.bytes()));
  CHECK(records_of(old) == keys + text && integer_at(old, 100, 4) == 2);
  CHECK(integer_at(old, 25, 1) == 2 && integer_at(old, 6, 2) == 1);

  // WKT needs 1.4, also for the points of older versions
  file.minor = 4;
  file.records = {wkt};
  const std::string recent = written(read_las(file.bytes()));
  CHECK(integer_at(recent, 25, 1) == 4 && integer_at(recent, 104, 1) == 1);
  CHECK(integer_at(recent, 6, 2) == 1 + 8 + 16 && records_of(recent) == wkt);
  CHECK(integer_at(recent, 107, 4) == 1 && integer_at(recent, 247, 8) == 1);

  // Behind the points, in a file and in what can only be read from begin to end
  file.format = 6;
  file.points = {Las_point().bytes(6)};
  file.records = {};
  file.extended_records = {las_extended_record("other", 2112, "y"),
                           las_extended_record("LASF_Projection", 2112, "PROJCS[\"UTM\"]"),
                           las_extended_record("LASF_Projection", 2112, std::string(65536, 'w'))};
  for (const std::string& bytes : {file.bytes(), gzip(file.bytes())})
  {
    const Point_cloud cloud = read_las(bytes);
    CHECK(cloud.warnings.size() == 1
          && cloud.warnings[0].find("longer than 65535 bytes") != std::string::npos);
    CHECK(records_of(written(cloud)) == wkt);
  }

  // Bytes that had no meaning before 1.2
  file = Las_file();
  file.minor = 1;
  file.encoding = 65535;
  CHECK(integer_at(written(read_las(file.bytes())), 6, 2) == 0);
}

void test_colors()
{
  Las_file file;
  file.format = 2;
  Las_point point;
  point.color = {65535, 257 * 200, 129};
  file.points = {point.bytes(2)};
  Read_options options = everything();
  options.with_wide_colors = false;
  const auto color_of = [&](const Point_cloud& cloud) {
    std::map<std::string, double> all = values(cloud, 0);
    return std::array<double, 3>{all["red"], all["green"], all["blue"]};
  };
  const Point_cloud narrow = read_las(file.bytes(), options);
  CHECK((color_of(narrow) == std::array<double, 3>{255, 200, 0}));
  for (const Property& property : narrow.properties.properties())
    CHECK(property.name != "red" || property.type == Number_type::UINT8);
  CHECK((color_of(read_las(file.bytes())) == std::array<double, 3>{65535, 257 * 200, 129}));
  CHECK((color_of(read_las(written(narrow))) == std::array<double, 3>{65535, 257 * 200, 0}));
  // Exact for both ways to make 16 bits of a byte
  for (const unsigned factor : {256u, 257u})
    for (unsigned byte = 0; byte < 256; ++byte)
    {
      point.color = {255 * factor, byte * factor, 0};
      file.points = {point.bytes(2)};
      CHECK(
        (color_of(read_las(file.bytes(), options)) == std::array<double, 3>{255, double(byte), 0}));
    }
  // Which of both they are, or none, whether they become bytes or not
  const std::pair<Las_colors, std::vector<std::array<unsigned, 3>>> kinds[] = {
    {Las_colors::NONE, {{0, 0, 0}, {0, 0, 0}}},
    {Las_colors::BYTES, {{0, 200, 0}, {255, 1, 2}}},
    {Las_colors::SCALED_BYTES, {{256, 0, 51200}, {0, 0, 65280}}},
    {Las_colors::SCALED_BYTES, {{257, 0, 51400}, {0, 0, 65535}}},
    {Las_colors::FINE, {{256, 0, 0}, {257, 0, 0}}},
    {Las_colors::FINE, {{65535, 0, 0}, {0, 1, 0}}}};
  for (const auto& [kind, colors] : kinds)
  {
    file.points = {};
    for (const std::array<unsigned, 3>& color : colors)
    {
      point.color = color;
      file.points.push_back(point.bytes(2));
    }
    CHECK(read_las(file.bytes(), options).las_colors == kind);
    CHECK(read_las(file.bytes()).las_colors == kind);
  }
  // Of bytes that nobody has scaled
  point.color = {255, 0, 7};
  file.points = {point.bytes(2)};
  CHECK((color_of(read_las(file.bytes(), options)) == std::array<double, 3>{255, 0, 7}));
  CHECK(point_bytes(written(read_las(file.bytes())), 0) == file.points[0]);
}

void test_filters()
{
  const auto point = [](unsigned classification, unsigned return_number, unsigned flags) {
    Las_point p;
    p.x = int(classification * 10 + return_number);
    p.classification = classification;
    p.return_number = return_number;
    p.flags = flags;
    return p;
  };
  for (const unsigned format : {0u, 6u})
  {
    Las_file file;
    file.minor = 4;
    file.format = format;
    file.scale = {1, 1, 1};
    file.offset = {0, 0, 0};
    for (const Las_point& p : {point(2, 1, 0), point(2, 2, 3), point(6, 1, 4), point(6, 0, 0),
                               point(5, 1, 1), point(2, 3, 7)})
      file.points.push_back(p.bytes(format));
    const auto found = [&](std::vector<unsigned> classes, bool only_first) {
      Read_options options = everything();
      options.classes = std::move(classes);
      options.only_first_returns = only_first;
      const Point_cloud cloud = read_las(file.bytes(), options);
      std::vector<double> xs;
      for (std::size_t i = 0; i < cloud.points.size(); ++i)
      {
        xs.push_back(cloud.points[i].x());
        CHECK(values(cloud, i)["classification"] == std::floor(xs[i] / 10));
      }
      std::string notes;
      for (const std::string& note : cloud.notes)
        notes += note.substr(note.rfind(": ") + 2) + "\n";
      return std::make_pair(xs, notes);
    };
    using Xs = std::vector<double>;
    const std::string withheld = "2 points are left out, which the file has flagged as withheld\n";
    const auto filtered = [](int n) {
      return std::to_string(n) + " points are left out by --keep-classes or --first-returns\n";
    };
    CHECK(found({}, false) == std::make_pair(Xs{21, 22, 60, 51}, withheld));
    CHECK(found({2}, false) == std::make_pair(Xs{21, 22}, withheld + filtered(2)));
    CHECK(found({6, 5}, false) == std::make_pair(Xs{60, 51}, withheld + filtered(2)));
    CHECK(found({}, true) == std::make_pair(Xs{21, 60, 51}, withheld + filtered(1)));
    CHECK(found({2, 200}, true) == std::make_pair(Xs{21}, withheld + filtered(3)));
    CHECK(found({200}, true) == std::make_pair(Xs{}, withheld + filtered(4)));
  }

  // Of other formats, those with such a property
  Read_options options = everything();
  options.classes = {2};
  const std::string ply = ply_header("ascii", "element vertex 2\n" + float_xyz
                                                + "property float classification\n");
  CHECK(tool_test::read(".ply", ply + "0 0 0 2\n1 1 1 3\n", options).points
        == std::vector<Point>{Point(0, 0, 0)});
  options.only_first_returns = true;
  const Failure_seen seen = failure_of(
    [&]() { tool_test::read(".ply", ply + "0 0 0 2\n1 1 1 3\n", options); });
  CHECK(seen.status == INPUT_REFUSED
        && seen.says("--first-returns is given, but the points have no property 'return_number'"));
  CHECK(failure_of([&]() {
          tool_test::read(".xyz", "1 2 3\n", options);
        }).says("--keep-classes is given, but the points have no property 'classification'"));
}

} // namespace

int main()
{
  test_versions_and_formats();
  test_what_is_longer();
  test_extra_bytes();
  test_normals();
  test_coordinate_system();
  test_colors();
  test_filters();
  return test::result();
}
