// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Attack.h"

#include <cstdlib>
#include <fstream>
#include <ios>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace attack {
namespace {

template <typename T>
std::string text_of(const T& value)
{
  std::ostringstream stream;
  if constexpr (std::is_enum_v<T>)
    stream << int(value);
  else
    stream << std::hexfloat << value;
  return stream.str();
}

template <typename T>
std::string text_of(const std::optional<T>& value)
{
  return value ? text_of(*value) : "";
}

// The streams of the standard library write hexadecimal digits, infinities and NaN, and do not read
// them.
void read_text(const std::string& text, double& value)
{
  value = std::strtod(text.c_str(), nullptr);
}
void read_text(const std::string& text, std::size_t& value)
{
  value = std::strtoull(text.c_str(), nullptr, 10);
}
void read_text(const std::string& text, int& value) { value = std::atoi(text.c_str()); }
void read_text(const std::string& text, bool& value) { value = text == "1"; }
void read_text(const std::string& text, Solver& value) { value = Solver(std::atoi(text.c_str())); }

template <typename T>
void read_text(const std::string& text, std::optional<T>& value)
{
  value = T();
  read_text(text, *value);
}

} // namespace

void write_attack(const std::string& path, const Attack& attack)
{
  std::ofstream file(path);
  file << "name " << attack.name << "\n";
  for_each_parameter([&](const char* name, auto member) {
    const std::string text = text_of(attack.parameters.*member);
    if (text != text_of(Parameters().*member))
      file << name << " " << text << "\n";
  });
  file << "points\n";
  for (std::size_t i = 0; i < attack.points.size(); ++i)
  {
    for (const Vector& v : {attack.points[i], attack.normals[i]})
      file << text_of(v[0]) << " " << text_of(v[1]) << " " << text_of(v[2]) << " ";
    file << "\n";
  }
  if (!file.flush())
    throw std::runtime_error(path + " cannot be written");
}

Attack read_attack(const std::string& path)
{
  std::ifstream file(path);
  Attack attack;
  std::string line;
  while (std::getline(file, line) && line != "points")
  {
    const std::size_t blank = line.find(' ');
    const std::string word = line.substr(0, blank),
                      text = blank == std::string::npos ? "" : line.substr(blank + 1);
    bool is_known = word == "name";
    if (is_known)
      attack.name = text;
    for_each_parameter([&](const char* parameter, auto member) {
      if (word == parameter)
      {
        is_known = true;
        read_text(text, attack.parameters.*member);
      }
    });
    if (!is_known)
      throw std::runtime_error(path + ": '" + word + "' is no parameter");
  }
  if (line != "points")
    throw std::runtime_error(path + ": no points");
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string text;
    Vector row[2];
    for (Vector& v : row)
      for (double& x : v)
      {
        if (!(words >> text))
          throw std::runtime_error(path + ": a point and its normal are six numbers");
        read_text(text, x);
      }
    attack.points.push_back(row[0]);
    attack.normals.push_back(row[1]);
  }
  return attack;
}

} // namespace attack
