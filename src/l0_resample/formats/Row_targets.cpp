// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/Row_targets.h"

#include "formats/usual_names.h"

#include <algorithm>
#include <array>

namespace l0_tool {

Targets find_targets(const Input_file& file, const std::vector<std::string>& own_names,
                     const std::vector<std::string>& names, const std::string& kind,
                     const std::function<std::string(std::size_t)>& reason_against)
{
  constexpr std::size_t normal = 3; // the first target of one
  Targets targets;
  std::array<std::size_t, unused> counts = {};
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto found = std::find(row_names.begin(), row_names.end(), names[k]);
    std::size_t target = std::size_t(found - row_names.begin());
    if (target < unused && is_name_of_other(own_names, names, k))
      target = unused;
    const std::string reason = target == unused ? "" : reason_against(k);
    if (!reason.empty() && target < normal)
      file.refuse("the " + kind + " " + names[k] + " is " + reason);
    if (!reason.empty())
      target = unused;
    targets.push_back(target);
    if (target < unused && ++counts[target] > 1)
      file.refuse("two of the name " + names[k] + " where one " + kind + " is expected");
  }
  for (std::size_t k = 0; k < normal; ++k)
    if (counts[k] == 0)
      file.refuse("there is no " + kind + " " + std::string(row_names[k]));
  if (counts[3] == 0 || counts[4] == 0 || counts[5] == 0)
    std::replace_if(
      targets.begin(), targets.end(), [](std::size_t target) { return target >= normal; }, unused);
  return targets;
}

bool have_normals(const Targets& targets)
{
  return std::find(targets.begin(), targets.end(), std::size_t(3)) != targets.end();
}

} // namespace l0_tool
