// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/file_formats.h"

#include "basis/parse_numbers.h"

#include <string_view>
#include <utility>

namespace l0_tool {

std::string lower_extension(const std::filesystem::path& path)
{
  return lower_case(path.extension().string());
}

bool is_written(File_format format)
{
  return format != File_format::CSV && format != File_format::OBJ;
}

bool is_compressed(const std::string& path) { return lower_extension(path) == ".gz"; }

bool is_laz(const std::string& path) { return lower_extension(path) == ".laz"; }

std::optional<File_format> format_of(const std::string& path)
{
  std::filesystem::path uncompressed = path;
  if (is_compressed(path))
    uncompressed.replace_extension();
  const std::string extension = lower_extension(uncompressed);
  if (extension == ".ply")
    return File_format::PLY;
  if (extension == ".off")
    return File_format::OFF;
  if (extension == ".xyz" || extension == ".xyzn" || extension == ".pwn" || extension == ".pts"
      || extension == ".txt" || extension == ".asc")
    return File_format::XYZ;
  if (extension == ".pcd")
    return File_format::PCD;
  if (extension == ".npy")
    return File_format::NPY;
  if (extension == ".csv")
    return File_format::CSV;
  if (extension == ".obj")
    return File_format::OBJ;
  if (extension == ".las" || extension == ".laz")
    return File_format::LAS;
  return std::nullopt;
}

std::optional<File_format> format_that_begins_with(std::string_view bytes)
{
  constexpr std::pair<std::string_view, File_format> begins[] = {
    {"ply\n", File_format::PLY},    {"ply\r", File_format::PLY},   {"# .PCD", File_format::PCD},
    {"VERSION ", File_format::PCD}, {"LASF", File_format::LAS},    {"\x93NUMPY", File_format::NPY},
    {"OFF\n", File_format::OFF},    {"OFF\r", File_format::OFF},   {"NOFF", File_format::OFF},
    {"COFF", File_format::OFF},     {"mtllib ", File_format::OBJ},
  };
  for (const auto& [begin, format] : begins)
    if (bytes.substr(0, begin.size()) == begin)
      return format;
  // A text may name its columns in a line that begins with v, too.
  constexpr std::string_view vertex = "v ", begins_of_numbers = "+-.0123456789";
  const bool is_vertex = bytes.substr(0, vertex.size()) == vertex
                         && bytes.find_first_of(begins_of_numbers) == vertex.size();
  return is_vertex ? std::optional(File_format::OBJ) : std::nullopt;
}

std::string extension_of(File_format format)
{
  switch (format) {
  case File_format::PLY: return ".ply";
  case File_format::OFF: return ".off";
  case File_format::XYZ: return ".xyz";
  case File_format::PCD: return ".pcd";
  case File_format::NPY: return ".npy";
  case File_format::CSV: return ".csv";
  case File_format::OBJ: return ".obj";
  case File_format::LAS: break;
  }
  return ".las";
}

std::string reason_against_output(const std::string& path, File_format format)
{
  if (is_compressed(path))
    return path + ": compressed files are read, but not written";
  if (is_laz(path))
    return path + ": LAZ is not written: write .las and compress it (laszip, PDAL)";
  if (!is_written(format))
    return path
           + ": CSV and OBJ are read, but not written; .ply, .off, .xyz, .pcd, .npy and .las are";
  return "";
}

std::string unknown_extension(const std::string& path, const std::string& option)
{
  const std::string extension = lower_extension(path);
  for (const std::string_view other : {".e57", ".ptx", ".bin", ".stl"})
    if (extension == other)
      return path + ": files of " + extension.substr(1)
             + " are neither read nor written; CloudCompare converts them to .ply";
  if (extension == ".npz")
    return path + ": archives of NumPy are neither read nor written; numpy.save() writes .npy";
  return path
         + ": the extension is not .ply, .off, .xyz, .xyzn, .pwn, .pts, .txt, .asc, .pcd, .npy, "
           ".csv, .obj or "
           ".las; "
         + option + " tells what the file is";
}

} // namespace l0_tool
