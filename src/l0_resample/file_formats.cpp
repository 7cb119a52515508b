// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "file_formats.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace l0_tool {

std::optional<File_format> format_of(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  if (extension == ".ply")
    return File_format::PLY;
  if (extension == ".off")
    return File_format::OFF;
  if (extension == ".xyz" || extension == ".pwn")
    return File_format::XYZ;
  return std::nullopt;
}

} // namespace l0_tool
