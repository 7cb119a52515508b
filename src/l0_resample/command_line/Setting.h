// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_SETTING_H
#define L0_RESAMPLE_SETTING_H

#include <nlohmann/json.hpp>

#include <string>

namespace l0_tool {

/// Who gets to know the value of an option.
enum class Told
{
  TO_ALL,    ///< reports, and the key of a run by tiles: a result depends on it
  TO_REPORT, ///< the key has what follows from it, or tiles do not depend on it
  TO_KEY,    ///< the report has what follows from it, or nothing but tiles depends on it
  TO_NOBODY  ///< no result depends on it, or no report and no tiles go with it
};

/// An option as the command line leaves it, be it given or not.
struct Setting
{
  std::string name;             ///< the long one, without dashes
  nlohmann::ordered_json value; ///< null if there is none
  Told told;
};

} // namespace l0_tool

#endif // L0_RESAMPLE_SETTING_H
