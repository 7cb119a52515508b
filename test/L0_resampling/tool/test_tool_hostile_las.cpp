// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The reader of LAS: as test_tool_hostile_files.cpp has it for the other formats.

#include "tool/test_tool_reading.h"
#include "tool/test_tool_hostile.h"
#include "tool/test_tool_las.h"

#include <cstdint>
#include <limits>
#include <random>

namespace {

using namespace l0_tool;
using namespace tool_test;

// Where the numbers of the header stand.
constexpr std::size_t version_at = 24, header_size_at = 94, points_at = 96, records_at = 100,
                      format_at = 104, point_size_at = 105, count_at = 107, scale_at = 131,
                      offset_at = 155, first_extended_at = 235, extended_at = 243,
                      long_count_at = 247;

Las_file good_file(unsigned minor, unsigned format, std::size_t number_of_points = 2)
{
  Las_file file;
  file.minor = minor;
  file.format = format;
  file.points.assign(number_of_points, Las_point().bytes(format));
  return file;
}

/// With records of all kinds that are looked at.
Las_file full_file()
{
  Las_file file = good_file(4, 7);
  file.records = {las_record("LASF_Projection", 2112, "WKT"),
                  las_record("LASF_Spec", 4,
                             extra_bytes("NormalX", 9) + extra_bytes("NormalY", 9)
                               + extra_bytes("NormalZ", 9)
                               + extra_bytes("height", 5, 8, {0.5, 0, 0})),
                  las_record("other", 1, "data")};
  for (std::string& point : file.points)
    point += le(0.f) + le(0.f) + le(1.f) + le(std::uint32_t(9));
  file.extended_records = {las_extended_record("LASF_Projection", 2111, "more"),
                           las_extended_record("other", 7, std::string(100, 'o'))};
  return file;
}

struct Hostile_file
{
  std::string bytes;
  const char* expected; // a part of the message
};

std::vector<Hostile_file> hostile_files()
{
  const std::string old = good_file(2, 3).bytes();
  const std::string recent = full_file().bytes();
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  const auto changed = [](const std::string& file, std::size_t position, auto number) {
    return with_bytes(file, position, le(number));
  };
  const auto with_record = [](const std::string& record) {
    Las_file file = good_file(2, 3);
    file.records = {record};
    return file.bytes();
  };
  const auto with_extended_record = [](const std::string& record) {
    Las_file file = good_file(4, 6);
    file.extended_records = {record};
    return file.bytes();
  };
  // the field that says how long an extended record is, from the end of its head on
  const std::size_t end_of_head = with_extended_record(las_extended_record("a", 1, "")).size();
  const auto with_extended_length = [&](const std::string& user, std::uint64_t length) {
    return changed(with_extended_record(las_extended_record(user, 4, "ab")), end_of_head - 40,
                   length);
  };
  const auto projections = [&](std::size_t number) {
    Las_file file = good_file(2, 3);
    file.records.assign(number, las_record("LASF_Projection", 1, std::string(60000, 'x')));
    return file.bytes();
  };
  const auto described = [&](const std::string& fields) {
    return with_record(las_record("LASF_Spec", 4, fields));
  };
  std::string many_fields;
  for (int i = 0; i < 340; ++i)
    many_fields += extra_bytes("f" + std::to_string(i), 21);
  using Byte = std::uint8_t;
  using Short = std::uint16_t;
  using Int = std::uint32_t;
  using Long = std::uint64_t;
  return {
    {"", "the file is empty"},
    {old.substr(0, 226), "1 more bytes are expected"},
    {"LASG" + old.substr(4), "does not begin as a LAS file does"},
    {std::string(400, '\0'), "does not begin as a LAS file does"},
    {changed(old, version_at, Byte(2)), "LAS 1.0 to 1.4 expected, found 2.2"},
    {changed(old, version_at + 1, Byte(5)), "LAS 1.0 to 1.4 expected, found 1.5"},
    {changed(old, version_at + 1, Byte(255)), "found 1.255"},
    {changed(old, header_size_at, Short(226)),
     "the header has 226 bytes, but that of LAS 1.2 has 227"},
    {changed(old, header_size_at, Short(0)), "the header has 0 bytes"},
    {changed(recent, header_size_at, Short(374)), "374 bytes, but that of LAS 1.4 has 375"},
    {changed(changed(old, header_size_at, Short(65535)), points_at, Int(70000)),
     "65308 bytes are announced"},
    {changed(old, points_at, Int(226)), "the points begin at byte 226, within the header"},
    {changed(old, points_at, Int(0)), "within the header"},
    {changed(old, points_at, Int(4294967295u)), "bytes are announced"},
    {changed(old, points_at, Int(old.size())), "2 points are announced, but only 0 bytes are left"},
    {changed(old, format_at, Byte(11)), "format 0 to 10 expected, found 11"},
    {changed(old, format_at, Byte(63)), "format 0 to 10 expected, found 63"},
    {changed(old, format_at, Byte(128 + 3)), "LAZ is not read: give a command"},
    {changed(old, format_at, Byte(64 + 3)), "LAZ is not read"},
    {with_record(las_record("laszip encoded", 22204, "z")), "LAZ is not read"},
    {changed(old, point_size_at, Short(33)), "a point of format 3 has 34 bytes, not 33"},
    {changed(old, point_size_at, Short(0)), "a point of format 3 has 34 bytes, not 0"},
    {changed(old, point_size_at, Short(65535)), "2 points are announced, but only 68 bytes"},
    {changed(old, count_at, Int(3)), "3 points are announced, but only 68 bytes are left"},
    {changed(old, count_at, Int(4294967295u)), "4294967295 points are announced"},
    {changed(recent, long_count_at, Long(-1)), "more than a file can hold"},
    {changed(good_file(4, 6).bytes(), long_count_at, Long(614891469123651721u)),
     "points are announced, more than a file can hold"}, // times 30 is 14 in 64 bits
    {changed(good_file(4, 6).bytes(), long_count_at, Long(100000000000u)),
     "100000000000 points are announced, but only 60 bytes are left"},
    {changed(old, scale_at, 0.), "a scale of the coordinates is 0 or not finite"},
    {changed(old, scale_at + 8, nan), "a scale of the coordinates"},
    {changed(old, scale_at + 16, infinity), "a scale of the coordinates"},
    {changed(old, offset_at + 8, nan), "an offset of the coordinates is not finite"},
    {changed(old, offset_at + 16, -infinity), "an offset of the coordinates is not finite"},
    {with_bytes(changed(old, scale_at, 1e300), 227, le(std::int32_t(2147483647))), "not finite"},
    // records
    {changed(old, records_at, Int(1)),
     "1 more records are announced, but the points begin after 0"},
    {changed(old, records_at, Int(4294967295u)), "4294967295 more records are announced"},
    {changed(with_record(las_record("a", 1, "bc")), 227 + 20, Short(3)),
     "a record of 3 bytes, but the points begin after 2"},
    {changed(with_record(las_record("a", 1, "bc")), 227 + 20, Short(65535)),
     "a record of 65535 bytes"},
    {projections(18), "the records of the coordinate system have more than 1048576 bytes"},
    {described(extra_bytes("a", 1).substr(1)), "191 bytes, which is no multiple of 192"},
    {described(extra_bytes("a", 31)), "a field of type 31, which is not one of LAS"},
    {described(extra_bytes("a", 255)), "a field of type 255"},
    {described(extra_bytes("a", 3, 8)), "a scale that is 0 or not finite"},
    {described(extra_bytes("a", 3, 8, {nan, 1, 1})), "a scale that is 0 or not finite"},
    {described(extra_bytes("a", 3, 16, {1, 1, 1}, {infinity, 0, 0})), "not finite"},
    {described(extra_bytes("a", 13, 8, {1, 0, 1})), "a scale that is 0"},
    {described(many_fields), "more than 1000 fields"},
    // extended records
    {changed(recent, first_extended_at, Long(0)), "begin at byte 0, before the points end"},
    {changed(recent, first_extended_at, Long(375)), "before the points end"},
    {changed(recent, first_extended_at, Long(recent.size() + 1)), "the file ends before byte"},
    {changed(recent, first_extended_at, Long(-1)),
     "the file ends before byte 18446744073709551615"},
    {changed(recent, extended_at, Int(3)), "1 extended records are announced, but only 0 bytes"},
    {changed(recent, extended_at, Int(4294967295u)), "4294967295 extended records are announced"},
    {with_extended_length("a", 3), "3 bytes of an extended record are announced, but only 2"},
    {with_extended_length("a", Long(-1)), "18446744073709551615 bytes of an extended record"},
    {with_extended_length("LASF_Projection", Long(1) << 40), "bytes of an extended record"},
    {with_extended_record(las_extended_record("LASF_Spec", 4, std::string(65536, 'x'))),
     "the record of extra bytes has 65536 bytes"},
    {with_extended_record(las_extended_record("laszip encoded", 22204, "z")), "LAZ is not read"},
  };
}

// Each of them is refused with its own reason.
void test_hostile_files()
{
  const std::vector<Hostile_file> files = hostile_files();
  for (const Hostile_file& file : files)
    check_refusal(".las", file.bytes, file.expected, everything());
  CHECK(files.size() > 50);

  // A whole file is not refused, nor one with much that nobody looks at
  CHECK(read_las(full_file().bytes()).points.size() == 2);
  Las_file padded_file = good_file(2, 3);
  padded_file.before_points = std::string(100000, 'p');
  CHECK(read_las(padded_file.bytes()).points.size() == 2);
  const std::string beyond = with_bytes(good_file(2, 3).bytes(), scale_at, le(1e300));
  const std::string infinite = with_bytes(beyond, 227, le(std::int32_t(2147483647)));
  Read_options lenient = everything();
  lenient.drop_non_finite = true;
  CHECK(read_las(infinite, lenient).number_of_dropped_points == 1);
  // Names reach a terminal only as letters
  Las_file named = good_file(2, 0);
  named.records = {las_record("LASF_Spec", 4, extra_bytes("\x1b[31m a\n", 7))};
  for (std::string& point : named.points)
    point += std::string(8, '\xff'); // which is rounded
  const Point_cloud cloud = read_las(named.bytes());
  CHECK(cloud.warnings.size() == 1 && cloud.warnings[0].find("'_[31m_a_'") != std::string::npos);
}

// A file is refused wherever it is cut, on a disk as in a pipe and compressed.
void test_truncated_files()
{
  for (const Las_file& file : {full_file(), good_file(0, 1), good_file(3, 5)})
  {
    const std::string bytes = file.bytes();
    CHECK(read_las(bytes).points.size() == 2);
    CHECK(read_las(gzip(bytes)).points.size() == 2);
    for (std::size_t length = 0; length < bytes.size(); ++length)
    {
      CHECK(failure_of([&]() { read_las(bytes.substr(0, length)); }).status == INPUT_REFUSED);
      CHECK(failure_of([&]() { read_las(gzip(bytes.substr(0, length))); }).status == INPUT_REFUSED);
    }
  }
}

// Whatever bytes are changed, the reader gives finite points or refuses.
void test_changed_bytes()
{
  const std::vector<std::string> files = {full_file().bytes(), good_file(2, 3).bytes(),
                                          good_file(4, 10).bytes()};
  std::mt19937 random(12);
  Damaged_files damaged;
  for (int round = 0; round < 4000; ++round)
    for (const std::string& bytes : files)
    {
      std::string changed = bytes;
      for (unsigned k = 0; k < 1 + random() % 3; ++k)
        changed[random() % changed.size()] = char(random() % 256);
      damaged.add([&]() { return read_las(changed); });
    }
  damaged.check();
}

} // namespace

int main()
{
  test_hostile_files();
  test_truncated_files();
  test_changed_bytes();
  return test::result();
}
