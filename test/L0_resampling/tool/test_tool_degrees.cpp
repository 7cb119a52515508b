// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// x and y in degrees are no lengths, as heights are: what tells it, records of LAS or coordinates.

#include "test_support.h"
#include "tool/test_tool_reading.h"
#include "tool/test_tool_las.h"

#include <cmath>

namespace {

using namespace l0_tool;
using namespace tool_test;

/// Keys of GeoTIFF: each with a value in the directory itself.
std::string geo_keys(const std::vector<std::array<unsigned, 2>>& keys)
{
  std::string data = le(std::uint16_t(1)) + le(std::uint16_t(1)) + le(std::uint16_t(0))
                     + le(std::uint16_t(keys.size()));
  for (const auto& [key, value] : keys)
    data += le(std::uint16_t(key)) + le(std::uint16_t(0)) + le(std::uint16_t(1))
            + le(std::uint16_t(value));
  return data;
}

// Wherever they stand
void test_records()
{
  const std::string user = "LASF_Projection";
  const std::string globe =
                      "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.25]],"
                      "UNIT[\"degree\",0.0174]]",
                    town = "PROJCS[\"UTM\"," + globe + ",PROJECTION[\"Transverse_Mercator\"]]";
  const std::string recent = "GEOGCRS [\"a PROJCS in name only\", CS[ellipsoidal,2]]",
                    recent_town = "PROJCRS[\"UTM\",BASEGEOGCRS[\"WGS 84\"],CS[Cartesian,2]]",
                    geocentric = "GEODCRS[\"earth\",CS[Cartesian,3]]",
                    geocentric_in_small = "geodcrs [\"earth\", cs [cartesian, 3]]";
  Read_options options = everything();
  options.degrees = Read_options::Degrees::REFUSE;
  Las_file file;
  file.minor = 4;
  file.format = 6;
  Las_point far;
  far.x = far.y = far.z = 100;
  file.points = {Las_point().bytes(6), far.bytes(6)};
  const auto is_refused = [&]() {
    const Failure_seen seen = failure_of([&]() { read_las(file.bytes(), options); });
    CHECK(
      seen.status == 0
      || (seen.status == INPUT_REFUSED && seen.says("degrees") && seen.says("--allow-degrees")));
    // from begin to end, as of a pipe, too
    CHECK(failure_of([&]() { read_las(gzip(file.bytes()), options); }).status == seen.status);
    CHECK(read_las(file.bytes()).degrees.empty() == (seen.status == 0));
    return seen.status != 0;
  };
  for (const bool is_behind : {false, true})
  {
    const auto record = [&](unsigned id, const std::string& data) {
      auto& records = is_behind ? file.extended_records : file.records;
      records.push_back(is_behind ? las_extended_record(user, id, data)
                                  : las_record(user, id, data));
    };
    const auto is_refused_with = [&](unsigned id, const std::string& data) {
      file.records = file.extended_records = {};
      record(id, data);
      return is_refused();
    };
    CHECK(is_refused_with(34735, geo_keys({{1024, 2}, {2048, 4326}})));
    CHECK(is_refused_with(34735, geo_keys({{2048, 4326}})));
    CHECK(is_refused_with(34735, geo_keys({{1024, 0}, {2048, 4326}, {3072, 0}}))); // undefined ones
    CHECK(!is_refused_with(34735, geo_keys({{1024, 1}, {2048, 4326}, {3072, 32632}})));
    CHECK(!is_refused_with(34735, geo_keys({{2048, 4326}, {3072, 32632}})));
    CHECK(!is_refused_with(34735, geo_keys({{1024, 3}, {2048, 4978}})));
    CHECK(!is_refused_with(34735, geo_keys({{1024, 2}}).substr(0, 13)));
    for (const unsigned encoding : {0u, 16u})
    {
      file.encoding = encoding;
      for (const std::string& wkt : {globe, "COMPD_CS[\"both\"," + globe + ",VERT_CS[\"NN\"]]",
                                     recent, std::string("geogcs(\"x\")")})
        CHECK(is_refused_with(2112, wkt));
      for (const std::string& wkt :
           {town, recent_town, geocentric, geocentric_in_small, std::string("GEOCCS[\"x\"]"),
            std::string("LOCAL_CS[\"GEOGCS[\"]"), std::string()})
        CHECK(!is_refused_with(2112, wkt));
      // Of two the one that the file means
      file.records = file.extended_records = {};
      record(34735, geo_keys({{1024, 2}}));
      record(2112, town);
      CHECK(is_refused() == (encoding == 0));
    }
    file.encoding = 0;
  }
}

/// The extents of a file that tells no system, and how it holds them.
struct Extents
{
  std::array<double, 3> low, high, scale, offset;

  Las_file file() const
  {
    Las_file file;
    file.scale = scale;
    file.offset = offset;
    for (const auto& corner : {low, high})
    {
      std::array<std::int32_t, 3> at = {};
      for (std::size_t k = 0; k < 3; ++k)
        at[k] = std::int32_t(std::lround((corner[k] - offset[k]) / scale[k]));
      Las_point point;
      point.x = at[0];
      point.y = at[1];
      point.z = at[2];
      point.flags = 0;
      file.points.push_back(point.bytes(0));
    }
    return file;
  }
};

Read_options refusing()
{
  Read_options options = everything();
  options.degrees = Read_options::Degrees::REFUSE;
  return options;
}

bool is_refused(const Extents& extents)
{
  const Failure_seen seen = failure_of([&]() { read_las(extents.file().bytes(), refusing()); });
  CHECK(seen.status == 0 || (seen.status == INPUT_REFUSED && seen.says("its coordinates tell")));
  CHECK(read_las(extents.file().bytes()).degrees.empty() == (seen.status == 0));
  return seen.status != 0;
}

const std::array<double, 3> none = {0, 0, 0}, tenth_of_micro = {1e-7, 1e-7, 1e-7};

void test_degrees_by_coordinates()
{
  const std::array<double, 3> low = {7.1, 50.7, 60}, high = {7.115, 50.709, 90};
  for (const std::array<double, 3>& offset : {none, {7, 50, 0}, {7.1, 50.7, 60}})
  {
    CHECK(is_refused({low, high, tenth_of_micro, offset}));
    CHECK(is_refused({low, high, {1e-7, 1e-7, 0.001}, offset}));
    CHECK(is_refused({low, high, {1e-8, 1e-8, 0.01}, offset}));
    CHECK(is_refused({low, high, {1e-6, 1e-6, 1e-6}, offset}));
    CHECK(is_refused({low, high, {1e-5, 1e-5, 0.01}, offset}));
  }
  CHECK(is_refused({low, high, {1e-9, 1e-9, 0.01}, {7, 50, 0}}));
  // Everywhere on the globe: west, south, beside a meridian or the equator, 0 to 360, wide lands
  CHECK(is_refused({{-122.5, 37.7, 3}, {-122.4, 37.8, 90}, {1e-7, 1e-7, 0.01}, {-122, 37, 0}}));
  CHECK(is_refused({{-43.3, -23, 3}, {-43.2, -22.9, 700}, tenth_of_micro, none}));
  CHECK(is_refused({{-0.01, 51.4, 3}, {0.01, 51.5, 70}, tenth_of_micro, none}));
  CHECK(is_refused({{36.8, -0.01, 1600}, {36.81, 0.01, 1640}, {1e-7, 1e-7, 0.01}, none}));
  CHECK(is_refused({{300, 10, 3}, {300.1, 10.1, 90}, {2e-7, 2e-7, 0.01}, {300, 10, 0}}));
  CHECK(is_refused({{-5, 40, 0}, {5, 50, 2000}, {1e-6, 1e-6, 1e-6}, {-5, 40, 0}}));
  // The latitude first
  CHECK(is_refused({{7.1, 120, 100}, {7.11, 120.01, 130}, {1e-6, 1e-6, 0.001}, {7, 120, 0}}));
  CHECK(is_refused({{35.7, 139.7, 20}, {35.71, 139.71, 60}, tenth_of_micro, {35.7, 139.7, 0}}));
}

void test_lengths_by_coordinates()
{
  // A small object on its turntable, in metres with z in millimetres, and in metres
  CHECK(!is_refused({{-0.15, -0.1, 0}, {0.15, 0.1, 150}, {1e-6, 1e-6, 0.001}, none}));
  CHECK(!is_refused({{-0.15, -0.1, 0}, {0.15, 0.1, 0.15}, tenth_of_micro, none}));
  CHECK(!is_refused({{0, 0, 0}, {0.3, 0.2, 0.15}, {1e-7, 1e-7, 1e-4}, none}));
  CHECK(!is_refused({{0.4, 0.1, 0.9}, {0.7, 0.3, 1.1}, {1e-8, 1e-8, 1e-8}, {0.4, 0.1, 0.9}}));
  // In millimetres
  CHECK(!is_refused({{10, 12, 0}, {310, 85, 150}, {1e-4, 1e-4, 1e-4}, none}));
  // A pole, beside the scanner and far from it, and a plumb line at the origin
  CHECK(!is_refused({{4, 3, -1.5}, {4.1, 3.1, 6.5}, tenth_of_micro, none}));
  CHECK(!is_refused({{60, 20, -1.5}, {60.1, 20.1, 6.5}, {1e-6, 1e-6, 1e-6}, none}));
  CHECK(!is_refused({{-0.01, -0.01, -90}, {0.01, 0.01, 0}, {1e-6, 1e-6, 1e-6}, none}));
  // Even one that is as thin as a wire, in the scale of a scanner
  CHECK(!is_refused({{60, 20, -1.5}, {60.02, 20.02, 6.5}, {1e-4, 1e-4, 1e-4}, none}));
  // A facade, a mast, a room, a shaft
  CHECK(!is_refused({{-20, 30, -2}, {20, 31, 25}, tenth_of_micro, none}));
  CHECK(!is_refused({{50, 7, 0}, {51, 8, 50}, tenth_of_micro, none}));
  CHECK(!is_refused({{-3, -4, -1.5}, {5, 2, 1.5}, {1e-6, 1e-6, 1e-5}, none}));
  CHECK(!is_refused({{-2.5, -2.5, -1000}, {2.5, 2.5, 0}, {1e-6, 1e-6, 1e-6}, none}));
  // Not on the globe
  CHECK(!is_refused({{500, 50.7, 100}, {500.01, 50.71, 130}, {1e-6, 1e-6, 0.001}, {500, 50, 0}}));
  CHECK(!is_refused({{97.1, 120, 100}, {97.11, 120.01, 130}, {1e-6, 1e-6, 0.001}, {7, 120, 0}}));
}

// Coordinates that can only be degrees are refused whatever the records name, for the same reason
// wherever it is told, and it is told once.
void test_records_of_degrees()
{
  const Extents land = {{7.1, 50.7, 60}, {7.115, 50.709, 90}, tenth_of_micro, none};
  const std::string tell = "its coordinates tell, whatever ";
  struct Case
  {
    unsigned id;
    std::string data, reason;
  };
  for (const auto& [id, data, reason] :
       {Case{2112, "PROJCS[\"UTM\"]", tell + "its WKT says"},
        Case{2112, "GEOCCS[\"x\"]", tell + "its WKT says"},
        Case{34735, geo_keys({{1024, 1}, {3072, 32632}}), tell + "its GeoTIFF keys say"},
        Case{34735, geo_keys({{1024, 3}}), tell + "its GeoTIFF keys say"},
        Case{34735, geo_keys({{1026, 1}}), "its coordinates tell"},
        Case{2112, "GEOGCS[\"WGS 84\"]", "its WKT says"},
        Case{34735, geo_keys({{1024, 2}}), "its GeoTIFF keys say"}})
  {
    Las_file file = land.file();
    file.minor = 4;
    for (const bool is_behind : {false, true})
    {
      const std::string user = "LASF_Projection";
      file.records = file.extended_records = {};
      if (is_behind)
        file.extended_records = {las_extended_record(user, id, data)};
      else
        file.records = {las_record(user, id, data)};
      Read_options options = refusing();
      for (const bool is_in_tiles : {false, true})
      {
        if (is_in_tiles)
          options.on_point = [](const Point&, const Property_table&, const char*) {};
        const Failure_seen seen = failure_of([&]() { read_las(file.bytes(), options); });
        CHECK(seen.status == INPUT_REFUSED && seen.says("as " + reason + ", so that"));
        CHECK(seen.says("filters.reprojection") && seen.says("--allow-degrees"));
      }
      CHECK(read_las(file.bytes()).degrees == reason && read_las(file.bytes()).warnings.empty());
      options = {};
      options.degrees = Read_options::Degrees::WARN;
      for (const std::string& bytes : {file.bytes(), gzip(file.bytes())})
      {
        const std::vector<std::string> warnings = read_las(bytes, options).warnings;
        CHECK(warnings.size() == 1
              && warnings[0].find("as " + reason + ", so that") != std::string::npos);
      }
    }
  }
}

// Other formats warn of hills of degrees.
void test_other_formats()
{
  Read_options warning;
  warning.degrees = Read_options::Degrees::WARN;
  const auto number_of_warnings = [&](const std::string& text) {
    return tool_test::read(".xyz", text, warning).warnings.size();
  };
  CHECK(number_of_warnings("7.1 50.7 100\n7.101 50.701 120\n") == 1);
  CHECK(!tool_test::read(".xyz", "7.1 50.7 100\n7.101 50.701 120\n", {}).degrees.empty());
  CHECK(tool_test::read(".xyz", "7.1 50.7 100\n7.4 50.9 120\n", {}).degrees.empty());
  CHECK(number_of_warnings("35.7 139.7 100\n35.701 139.701 120\n") == 1); // in the other order
  CHECK(number_of_warnings("135.7 139.7 100\n135.701 139.701 120\n") == 0);
  CHECK(number_of_warnings("7.1 50.7 100\n7.4 50.9 120\n") == 0);
  CHECK(number_of_warnings("0 0 0\n0.01 0.01 20\n") == 0);
}

} // namespace

int main()
{
  test_records();
  test_degrees_by_coordinates();
  test_lengths_by_coordinates();
  test_records_of_degrees();
  test_other_formats();
  return test::result();
}
