// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/peak_of_memory.h"

#include <fstream>
#include <string>

namespace l0_tool {

// `getrusage()` would count what the process was before it became this program.
std::uint64_t peak_of_memory()
{
  const std::string field = "VmHWM:";
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.compare(0, field.size(), field) == 0)
      return std::stoull(line.substr(field.size())) * 1024;
  return 0;
}

} // namespace l0_tool
