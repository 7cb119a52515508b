// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "parse_options.h"

#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>

namespace l0_cloudcompare {
namespace {

using CGAL::L0_resampling::Method;

/// KEEP_DENSITY of -KEEP_DENSITY, -keep_density and --keep-density.
QString name_of(const QString& argument)
{
  QString name = argument.toUpper();
  while (name.startsWith('-'))
    name.remove(0, 1);
  return name.replace('-', '_');
}

[[noreturn]] void refuse(const QString& option, const QString& value, const char* expected)
{
  throw std::invalid_argument(
    QString("-%1: '%2' is not %3").arg(option, value, expected).toStdString());
}

std::uint64_t parse_count(const QString& option, const QString& value)
{
  bool is_good = false;
  const std::uint64_t count = value.toULongLong(&is_good);
  if (!is_good || count == 0)
    refuse(option, value, "a whole number above 0");
  return count;
}

// Its range is the library's to check.
double parse_number(const QString& option, const QString& value)
{
  bool is_good = false;
  const double number = value.toDouble(&is_good);
  if (!is_good)
    refuse(option, value, "a number");
  return number;
}

std::array<double, 3> parse_coordinates(const QString& option, const QString& value)
{
  const QStringList parts = value.split(',');
  std::array<double, 3> coordinates{};
  if (parts.size() != int(coordinates.size()))
    refuse(option, value, "three coordinates X,Y,Z");
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    coordinates[i] = parse_number(option, parts[int(i)]);
  return coordinates;
}

Method parse_method(const QString& option, const QString& value)
{
  static const std::map<QString, Method> methods = {
    {"DEFAULT", Method::DEFAULT}, {"LOR", Method::LOR}, {"ALOR", Method::ALOR}};
  const auto found = methods.find(value.toUpper());
  if (found == methods.end())
    refuse(option, value, "default, lor or alor");
  return found->second;
}

} // namespace

Resample_options parse_options(QStringList& arguments)
{
  Resample_options options;
  QString name;
  QString option_of_sides;
  const auto choose = [&](Sides sides) {
    if (!option_of_sides.isEmpty())
      throw std::invalid_argument(
        QString("-%1: excludes -%2").arg(name, option_of_sides).toStdString());
    option_of_sides = name;
    options.sides = sides;
  };
  const auto value = [&]() {
    if (arguments.isEmpty())
      throw std::invalid_argument(QString("-%1: a value is missing").arg(name).toStdString());
    return arguments.takeFirst();
  };
  const std::map<QString, std::function<void()>> readers = {
    {"POINTS", [&]() { options.number_of_points = parse_count(name, value()); }},
    {"PERCENTAGE", [&]() { options.percentage = parse_number(name, value()); }},
    {"NEIGHBOR_RADIUS", [&]() { options.neighbor_radius = parse_number(name, value()); }},
    {"METHOD", [&]() { options.method = parse_method(name, value()); }},
    {"VIEWPOINT",
     [&]() {
       const QString place = value();
       const bool is_sensor = place.toUpper() == "SENSOR";
       choose(is_sensor ? Sides::SENSOR : Sides::VIEWPOINT);
       if (!is_sensor)
         options.viewpoint = parse_coordinates(name, place);
     }},
    {"UP",
     [&]() {
       choose(Sides::UP);
       options.up = parse_coordinates(name, value());
     }},
    {"ORIENT_BY_NORMALS", [&]() { choose(Sides::NORMALS); }},
    {"KEEP_OUTLIERS", [&]() { options.keep_outliers = true; }},
    {"KEEP_DENSITY", [&]() { options.keep_density = true; }}};
  while (!arguments.isEmpty() && arguments.front().startsWith('-'))
  {
    name = name_of(arguments.front());
    const auto reader = readers.find(name);
    if (reader == readers.end())
      break;
    arguments.removeFirst();
    reader->second();
  }
  return options;
}

} // namespace l0_cloudcompare
