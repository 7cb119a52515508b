// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Named_columns.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "formats/Row_targets.h"
#include "formats/usual_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace l0_tool {
namespace {

bool is_name(const std::string& name)
{
  const auto is_visible = [](char c) { return c > ' ' && c <= '~'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), is_visible);
}

[[noreturn]] void refuse(const std::string& list, const std::string& what)
{
  throw Failure(WRONG_USAGE, "--columns " + list + ": " + what);
}

} // namespace

bool is_left_out(const std::string& name) { return name == "-" || name == "_"; }

bool have_coordinates(const Column_names& names)
{
  return std::all_of(row_names.begin(), row_names.begin() + 3, [&](std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  });
}

void leave_out_column(std::string& name, const std::string& reason, Point_collector& collector)
{
  if (collector.wants_properties())
    collector.warn("the column " + printable(name) + " is left out: " + reason);
  name = "-";
}

void check_column_names(const Input_file& file, Column_names& names, Point_collector& collector)
{
  constexpr std::size_t normal = 3; // the first of its names
  const auto index_of = [](const std::string& name) {
    return std::size_t(std::find(row_names.begin(), row_names.end(), name) - row_names.begin());
  };
  std::array<bool, unused + 1> is_there = {};
  for (const std::string& name : names)
    is_there[index_of(name)] = true;
  const bool has_normals = is_there[normal] && is_there[normal + 1] && is_there[normal + 2];
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto here = names.begin() + std::ptrdiff_t(k);
    const bool is_again = std::find(names.begin(), here, *here) != here;
    const std::size_t index = index_of(*here);
    if (is_again && index < unused)
      file.refuse("two columns " + *here);
    if (is_again && !is_left_out(*here))
      leave_out_column(*here, "another one has that name", collector);
    else if (index >= normal && index < unused && !has_normals)
      leave_out_column(*here, "a normal needs nx, ny and nz", collector);
  }
}

Column_names parse_column_names(const std::string& list)
{
  const std::vector<std::string_view> parts = split_at_commas(list);
  const Column_names names = usual_names(Column_names(parts.begin(), parts.end()));
  if (names.size() > max_number_of_columns)
    throw Failure(WRONG_USAGE, "--columns: more names than a file can have properties");
  const auto begin = names.begin(), end = names.end();
  const auto count = [&](std::string_view name) { return std::count(begin, end, name); };
  for (const std::string& name : names) {
    if (!is_name(name))
      refuse(list, printable(name) + " is not a name");
    if (!is_left_out(name) && count(name) > 1)
      refuse(list, printable(name) + " is there twice");
  }
  if (count("x") + count("y") + count("z") != 3)
    refuse(list, "x, y and z have to be among the names");
  const auto normal_coordinates = count("nx") + count("ny") + count("nz");
  if (normal_coordinates != 0 && normal_coordinates != 3)
    refuse(list, "a normal needs nx, ny and nz");
  return names;
}

Named_columns::Named_columns(const std::vector<Named_column>& columns, Vectors vectors,
                             Point_collector& collector)
  : m_collector(collector),
    m_may_number_rows(vectors == Vectors::UNNAMED && columns.size() > 3 && columns[0].name == "x")
{
  bool has_normals = false;
  for (const auto& [name, type] : columns) {
    std::size_t target = std::size_t(std::find(row_names.begin(), row_names.end(), name)
                                     - row_names.begin());
    has_normals = has_normals || (target >= 3 && target < unused);
    if (target == unused && !is_left_out(name) && collector.wants_properties())
      target = first_property + collector.add_property(name, type);
    m_targets.push_back(target);
  }
  if (has_normals)
    collector.set_vectors(vectors);
}

bool Named_columns::is_wanted(std::size_t column) const { return m_targets[column] != unused; }

void Named_columns::add(const std::vector<double>& values)
{
  const double first = values[0];
  m_may_number_rows = m_may_number_rows && std::floor(first) == first
                      && (!m_first || first == *m_first + 1);
  m_first = first;
  std::array<double, first_property> row = {};
  for (std::size_t k = 0; k < m_targets.size(); ++k)
    if (m_targets[k] < first_property)
      row[m_targets[k]] = values[k];
    else
      m_collector.set(m_targets[k] - first_property, values[k]);
  m_collector.add({row[0], row[1], row[2], row[3], row[4], row[5]});
}

void Named_columns::refuse_row_numbers(const Input_file& file) const
{
  constexpr std::uint64_t least = 10; // fewer may be coordinates
  if (m_may_number_rows && m_collector.number_of_rows() >= least)
    file.refuse("the first column numbers the points, and is no coordinate; "
                + m_collector.how_to_name_columns());
}

} // namespace l0_tool
