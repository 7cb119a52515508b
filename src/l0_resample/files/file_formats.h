// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_FILE_FORMATS_H
#define L0_RESAMPLE_FILE_FORMATS_H

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace l0_tool {

enum class File_format
{
  PLY,
  OFF,
  XYZ,
  PCD,
  NPY,
  CSV,
  OBJ,
  LAS
};

/// Whether points can be written in that format too.
bool is_written(File_format format);

/// With its dot, empty if there is none.
std::string lower_extension(const std::filesystem::path& path);

/// Whether the name is that of a file which gzip has made.
bool is_compressed(const std::string& path);

/// Whether the name is that of compressed LAS, which a command has to decompress.
bool is_laz(const std::string& path);

/// By the extension of `path`, maybe before .gz, in lower or upper case: .ply, .off, .xyz, .xyzn,
/// .pwn, .pts, .txt, .asc, .pcd, .npy, .csv, .obj, .las or .laz.
std::optional<File_format> format_of(const std::string& path);

/// By the first bytes of a file, eight or more: those of PLY, PCD, LAS, NPY, OFF and mostly of OBJ
/// tell their format.
std::optional<File_format> format_that_begins_with(std::string_view bytes);

/// The usual one, with its dot.
std::string extension_of(File_format format);

/// Why points are not written to such a file; empty if they are.
std::string reason_against_output(const std::string& path, File_format format);

/// What to say of a file whose extension tells no format, while `option` would.
std::string unknown_extension(const std::string& path, const std::string& option);

} // namespace l0_tool

#endif // L0_RESAMPLE_FILE_FORMATS_H
