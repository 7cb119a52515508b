// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_OPTION_TABLE_H
#define L0_RESAMPLE_OPTION_TABLE_H

#include "command_line/Setting.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace l0_tool {

/*!
The rows of the table of options. Each becomes an option of the parser and a setting, so that
reports and the keys of runs by tiles have it, unless the row says that they are not told.
*/
class Option_table
{
public:
  using Json = nlohmann::ordered_json;
  using Value = std::function<Json()>;

private:
  CLI::App& m_app;
  std::vector<std::function<Setting()>>& m_settings;

  template <typename T>
  static Json json_of(const T& value)
  {
    return value;
  }

  template <typename T>
  static Json json_of(const std::optional<T>& value)
  {
    return value ? Json(*value) : Json();
  }

  CLI::Option* add(CLI::Option* option, Told told, const Value& value)
  {
    if (told != Told::TO_NOBODY)
      m_settings.push_back([name = option->get_single_name(), value, told]() {
        return Setting{name, value(), told};
      });
    return option;
  }

public:
  /// \param settings of the rows, to ask for when `app` has parsed
  Option_table(CLI::App& app, std::vector<std::function<Setting()>>& settings)
    : m_app(app), m_settings(settings)
  {}

  CLI::Option* add_flag(const std::string& name, bool& value, const std::string& description,
                        Told told = Told::TO_ALL)
  {
    return add(m_app.add_flag(name, value, description), told, [&value]() { return Json(value); });
  }

  /// \param names the long one, maybe behind a short one and a comma
  template <typename T>
  CLI::Option* add_option(const std::string& names, T& value, const std::string& description,
                          Told told = Told::TO_ALL)
  {
    return add_option(names, value, description, told, [&value]() { return json_of(value); });
  }

  /// \param setting what is told instead of `value`
  template <typename T>
  CLI::Option* add_option(const std::string& names, T& value, const std::string& description,
                          Told told, const Value& setting)
  {
    return add(m_app.add_option(names, value, description), told, setting);
  }

  /// An option whose text is parsed.
  /// \param parse makes a value of the name and the text
  template <typename T, typename Parse>
  CLI::Option* add_parsed(const std::string& name, T& value, const std::string& description,
                          const Parse& parse, Told told = Told::TO_ALL)
  {
    return add_text(
      name, [&value, name, parse](const std::string& text) { value = parse(name, text); },
      description, told, [&value]() { return json_of(value); });
  }

  /// An option whose text goes to a function.
  CLI::Option* add_text(const std::string& name,
                        const std::function<void(const std::string&)>& take,
                        const std::string& description, Told told, const Value& setting)
  {
    return add(m_app.add_option_function<std::string>(name, take, description), told, setting);
  }

  CLI::Option* get_option(const std::string& name) const { return m_app.get_option(name); }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_OPTION_TABLE_H
