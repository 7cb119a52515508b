// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_FILE_FORMATS_H
#define L0_RESAMPLE_FILE_FORMATS_H

#include <optional>
#include <string>

namespace l0_tool {

enum class File_format { PLY, OFF, XYZ };

/// By the extension of `path`, in lower or upper case: .ply, .off, .xyz or .pwn.
std::optional<File_format> format_of(const std::string& path);

} // namespace l0_tool

#endif // L0_RESAMPLE_FILE_FORMATS_H
