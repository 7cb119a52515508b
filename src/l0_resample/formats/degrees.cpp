// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/degrees.h"

#include "basis/Number_type.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace l0_tool {
namespace {

constexpr std::uint16_t geo_key_directory = 34735, wkt_of_coordinate_system = 2112;

/// The value of a key that stands in the directory itself.
std::optional<unsigned> geo_key(std::string_view directory, unsigned key)
{
  constexpr unsigned undefined = 0;
  constexpr std::size_t size = 8; // of an entry: key, where its value is, count, value
  for (std::size_t at = size; at + size <= directory.size(); at += size) {
    const auto part = [&](std::size_t k) {
      return unsigned(little_endian_at(directory.data() + at + 2 * k, 2));
    };
    if (part(0) == key && part(1) == 0 && part(3) != undefined)
      return part(3);
  }
  return std::nullopt;
}

Horizontal_system system_of_keys(std::string_view directory)
{
  constexpr unsigned model_type = 1024, geographic_type = 2048, projected_type = 3072;
  constexpr unsigned projected = 1, geographic = 2, geocentric = 3;
  const unsigned model = geo_key(directory, model_type).value_or(0);
  const bool names_projection = geo_key(directory, projected_type).has_value(),
             names_globe = geo_key(directory, geographic_type).has_value();
  Horizontal_system system = {false, false, "its GeoTIFF keys say"};
  system.is_geographic = model == geographic
                         || (model != projected && model != geocentric && names_globe
                             && !names_projection);
  system.is_told = system.is_geographic || model == projected || model == geocentric
                   || names_projection;
  return system;
}

/// The keywords of WKT, which stand before brackets, in upper case; what is in quotes is none.
std::vector<std::string> keywords_of(std::string_view wkt)
{
  std::vector<std::string> keywords;
  std::string word;
  bool is_quoted = false;
  for (const char c : wkt) {
    is_quoted = is_quoted != (c == '"');
    const bool is_letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
    if (!is_quoted && (is_letter || (c >= '0' && c <= '9')))
      word += c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
    else if (!is_quoted && (c == '[' || c == '(') && !word.empty())
      keywords.push_back(std::move(word));
    if (is_quoted || (!is_letter && !(c >= '0' && c <= '9') && c != ' ' && c != '\n' && c != '\t'))
      word.clear();
  }
  return keywords;
}

Horizontal_system system_of_wkt(std::string_view wkt)
{
  const std::vector<std::string> keywords = keywords_of(wkt);
  const auto has_any = [&](const std::vector<std::string_view>& names) {
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
      return std::find(keywords.begin(), keywords.end(), name) != keywords.end();
    });
  };
  // A projected system has a geographic one within, and GEODCRS may be one of lengths too
  const bool has_lengths =
    has_any({"PROJCS", "PROJCRS", "PROJECTEDCRS", "GEOCCS", "LOCAL_CS", "ENGCRS", "ENGINEERINGCRS"})
    || folded(wkt).find("cscartesian3") != std::string::npos;
  const bool has_globe = has_any({"GEOGCS", "GEOGCRS", "GEOGRAPHICCRS", "GEODCRS", "GEODETICCRS"});
  return {has_lengths || has_globe, has_globe && !has_lengths, "its WKT says"};
}

constexpr double maximum_longitude = 360, maximum_latitude = 90;

bool is_on_globe(const CGAL::Bbox_3& box)
{
  const bool is_empty = box.xmin() > box.xmax();
  const auto are_within = [&](double x, double y) {
    return box.xmin() >= -x && box.xmax() <= x && box.ymin() >= -y && box.ymax() <= y;
  };
  return !is_empty
         && (are_within(maximum_longitude, maximum_latitude)
             || are_within(maximum_latitude, maximum_longitude));
}

double width_of(const CGAL::Bbox_3& box)
{
  return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
}

/// The origin of local coordinates is where somebody has put it, within what was measured or
/// beside it. Degrees are as near to theirs in the Gulf of Guinea only.
bool is_off_origin(const CGAL::Bbox_3& box)
{
  const auto distance = [](double low, double high) { return (std::max)({low, -high, 0.}); };
  return std::hypot(distance(box.xmin(), box.xmax()), distance(box.ymin(), box.ymax()))
         > width_of(box);
}

/// How many times as large as in x and y a height has to be. A metre is 0.00001 degrees, so hills
/// of a part in a thousand are 100 times as high as wide; a pole of 0.1 m by 6 m is so 60 times.
constexpr double minimum_ratio = 100;

bool are_hills_of_degrees(const CGAL::Bbox_3& box)
{
  const double narrow = (std::min)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  return narrow > 0 && box.zmax() - box.zmin() > minimum_ratio * width_of(box);
}

} // namespace

Horizontal_system horizontal_system_of(const Las_origin& origin)
{
  Horizontal_system by_keys, by_wkt;
  for (const Las_record& record : origin.coordinate_system)
    if (record.id == geo_key_directory)
      by_keys = system_of_keys(record.data);
    else if (record.id == wkt_of_coordinate_system)
      by_wkt = system_of_wkt(record.data);
  const bool is_wkt_meant = (origin.global_encoding & Las_origin::wkt) != 0;
  return by_wkt.is_told && (is_wkt_meant || !by_keys.is_told) ? by_wkt : by_keys;
}

bool look_like_degrees(const CGAL::Bbox_3& box)
{
  return is_on_globe(box) && is_off_origin(box) && are_hills_of_degrees(box);
}

bool look_like_degrees(const CGAL::Bbox_3& box, const Las_origin& origin)
{
  // In degrees, a larger scale is a lattice with more than a metre between neighbors
  constexpr double maximum_scale = 1e-5;
  const double scale = (std::max)(std::abs(origin.scale[0]), std::abs(origin.scale[1]));
  const bool are_heights_coarse = std::abs(origin.scale[2]) >= minimum_ratio * scale;
  return scale <= maximum_scale && is_on_globe(box) && is_off_origin(box)
         && (are_heights_coarse || are_hills_of_degrees(box));
}

} // namespace l0_tool
