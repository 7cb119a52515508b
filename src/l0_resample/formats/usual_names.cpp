// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/usual_names.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace l0_tool {
namespace {

constexpr std::size_t minimum_size = 3; // of a kind; a color may have a fourth channel
using Spelling = std::array<std::string_view, 4>;

/// Other spellings of the names that its first one has, as `folded()` leaves them: first come those
/// which go before others.
struct Kind_of_name
{
  Spelling names;
  std::vector<Spelling> spellings;
  std::vector<std::string_view> names_of_all; ///< of a column of three or four values
};

const std::vector<Kind_of_name>& kinds()
{
  // points0 and normals0 are those of ParaView, diffusered is that of VCG, rf that of CloudCompare,
  // cartesianx that of E57, tx that of trajectories; xm is also what is left of X [m]
  static const std::vector<Kind_of_name> all = {
    {{"x", "y", "z"},
     {{"x", "y", "z"},
      {"points0", "points1", "points2"},
      {"positionx", "positiony", "positionz"},
      {"pointx", "pointy", "pointz"},
      {"posx", "posy", "posz"},
      {"coordx", "coordy", "coordz"},
      {"xcoord", "ycoord", "zcoord"},
      {"xcoordinate", "ycoordinate", "zcoordinate"},
      {"cartesianx", "cartesiany", "cartesianz"},
      {"tx", "ty", "tz"},
      {"xm", "ym", "zm"},
      {"xmm", "ymm", "zmm"},
      {"px", "py", "pz"},
      {"east", "north", "height"},
      {"east", "north", "elevation"},
      {"east", "north", "up"},
      {"easting", "northing", "height"},
      {"easting", "northing", "elevation"},
      {"easting", "northing", "elev"},
      {"easting", "northing", "z"}},
     {"xyz", "point", "points", "position", "positions", "pos", "coordinates", "coords"}},
    {{"nx", "ny", "nz"},
     {{"nx", "ny", "nz"},
      {"normalx", "normaly", "normalz"},
      {"normalsx", "normalsy", "normalsz"},
      {"normx", "normy", "normz"},
      {"vnx", "vny", "vnz"},
      {"normals0", "normals1", "normals2"},
      {"normal0", "normal1", "normal2"}},
     {"normal", "normals", "nxyz", "normalxyz"}},
    {{"red", "green", "blue", "alpha"},
     {{"red", "green", "blue", "alpha"},
      {"r", "g", "b", "a"},
      {"diffusered", "diffusegreen", "diffuseblue", "diffusealpha"},
      {"rf", "gf", "bf", "af"},
      {"colorr", "colorg", "colorb", "colora"},
      {"rgbr", "rgbg", "rgbb", "rgba"},
      {"rgb0", "rgb1", "rgb2", "rgb3"},
      {"colorred", "colorgreen", "colorblue", "coloralpha"}},
     {"rgb", "rgba", "color", "colors"}}};
  return all;
}

bool are_there(const std::vector<std::string>& names, const Spelling& spelling)
{
  return std::all_of(spelling.begin(), spelling.begin() + minimum_size, [&](std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

} // namespace

std::string folded(std::string_view name)
{
  std::string text;
  for (const char c : name)
    if (c >= 'A' && c <= 'Z')
      text += char(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
      text += c;
  return text;
}

std::string without_prefix(std::string_view name)
{
  constexpr std::string_view prefix = "scalar";
  const std::string text = folded(name);
  return text.size() > prefix.size() && text.compare(0, prefix.size(), prefix) == 0
           ? text.substr(prefix.size())
           : text;
}

std::vector<std::string> usual_names(std::vector<std::string> names)
{
  std::vector<std::string> as_spelled, stripped;
  std::transform(names.begin(), names.end(), std::back_inserter(as_spelled), folded);
  std::transform(names.begin(), names.end(), std::back_inserter(stripped), without_prefix);
  for (const Kind_of_name& kind : kinds()) {
    if (are_there(names, kind.names))
      continue;
    for (const std::vector<std::string>& spelled : {as_spelled, stripped}) {
      const auto found = std::find_if(kind.spellings.begin(), kind.spellings.end(),
                                      [&](const Spelling& s) { return are_there(spelled, s); });
      if (found == kind.spellings.end())
        continue;
      for (std::size_t k = 0; k < names.size(); ++k) {
        const auto name = std::find(found->begin(), found->end(), spelled[k]);
        if (!spelled[k].empty() && name != found->end())
          names[k] = kind.names[std::size_t(name - found->begin())];
      }
      break;
    }
  }
  return names;
}

bool is_name_of_other(const std::vector<std::string>& own_names,
                      const std::vector<std::string>& names, std::size_t k)
{
  if (own_names[k] != names[k])
    return false;
  for (std::size_t j = 0; j < names.size(); ++j)
    if (names[j] == names[k] && own_names[j] != names[j])
      return true;
  return false;
}

std::vector<std::string> names_of_values(const std::string& name, std::size_t number_of_values)
{
  if (number_of_values == 1)
    return {name};
  const std::string spelled = folded(name);
  const Kind_of_name* kind = nullptr;
  for (const Kind_of_name& any : kinds())
    if (std::find(any.names_of_all.begin(), any.names_of_all.end(), spelled)
        != any.names_of_all.end())
      kind = &any;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < number_of_values; ++k) {
    const bool is_usual = kind && number_of_values >= minimum_size && k < kind->names.size()
                          && !kind->names[k].empty();
    names.push_back(is_usual ? std::string(kind->names[k]) : name + "_" + std::to_string(k));
  }
  return names;
}

} // namespace l0_tool
