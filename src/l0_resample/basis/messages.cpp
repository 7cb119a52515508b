// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "basis/messages.h"

#include <algorithm>
#include <iostream>

namespace l0_tool {
namespace {

void print(const char* kind, const std::string& text)
{
  std::cerr << "l0_resample: " << kind << on_one_line(text) << std::endl;
}

} // namespace

std::string on_one_line(std::string text)
{
  constexpr char delete_character = 127;
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == delete_character; };
  std::replace_if(text.begin(), text.end(), is_control, '?');
  return text;
}

void print_error(const std::string& error)
{
  if (!error.empty())
    print("", error);
}

void print_notes(const std::vector<std::string>& notes)
{
  for (const std::string& note : notes)
    print("note: ", note);
}

void print_warnings(const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
    print("warning: ", warning);
}

} // namespace l0_tool
