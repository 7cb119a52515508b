// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line/config_file.h"

#include "basis/Failure.h"
#include "basis/parse_numbers.h"
#include "command_line/command_line.h"
#include "files/Input_file.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string_view>

namespace l0_tool {
namespace {

constexpr std::array<std::string_view, 4> not_in_files = {"help", "version", "config", "output"};

/// Whether the command line has the option, or one that excludes it.
bool is_overruled(const CLI::Option& option)
{
  const std::set<CLI::Option*> excluded = option.get_excludes();
  return option.count() > 0
         || std::any_of(excluded.begin(), excluded.end(),
                        [](const CLI::Option* other) { return other->count() > 0; });
}

/// As if the word were all of a command line.
void check_word(const std::string& word, const Input_file& file)
{
  CLI::App app;
  Arguments ignored;
  add_options(app, ignored);
  try {
    app.parse(std::vector<std::string>{word});
  } catch (const CLI::ParseError& error) {
    file.refuse(error.what());
  } catch (const Failure& failure) {
    file.refuse(failure.what());
  }
}

class Config_reader
{
  Input_file m_file;
  const CLI::App& m_command_line;
  std::set<std::string> m_names;
  std::vector<std::string> m_words;

  const CLI::Option& find_option(const std::string& name)
  {
    const bool is_allowed = std::find(not_in_files.begin(), not_in_files.end(), name)
                            == not_in_files.end();
    const CLI::Option* option = is_allowed && name.size() > 1
                                  ? m_command_line.get_option_no_throw("--" + name)
                                  : nullptr;
    if (!option)
      m_file.refuse(printable(name) + " is no option that a file may have");
    if (!m_names.insert(name).second)
      m_file.refuse("a second line " + name);
    return *option;
  }

  void read_line(std::string_view line)
  {
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos)
      m_file.refuse("option = value expected, found " + printable(line));
    const std::string name(trimmed(line.substr(0, sign)));
    const std::string value(trimmed(line.substr(sign + 1)));
    const CLI::Option& option = find_option(name);
    const bool is_flag = option.get_items_expected_max() == 0;
    if (is_flag && value != "true" && value != "false")
      m_file.refuse(name + " is true or false, found " + printable(value));
    const std::string word = "--" + name + (is_flag ? "" : "=" + value);
    check_word(word, m_file);
    if (value != "false" && !is_overruled(option))
      m_words.push_back(word);
  }

public:
  Config_reader(const std::string& path, const CLI::App& command_line)
    : m_file(path), m_command_line(command_line)
  {}

  std::vector<std::string> read()
  {
    while (const std::optional<std::string_view> line = m_file.read_line())
      if (!is_empty_or_comment(*line))
        read_line(trimmed(*line));
    return m_words;
  }
};

} // namespace

std::vector<std::string> read_config(const std::string& path, const CLI::App& command_line)
{
  try {
    return Config_reader(path, command_line).read();
  } catch (const Failure& failure) {
    refuse_usage("--config: " + std::string(failure.what()));
  }
}

} // namespace l0_tool
