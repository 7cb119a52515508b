// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILE_FOLDER_H
#define L0_RESAMPLE_TILE_FOLDER_H

#include <cstddef>
#include <string>

namespace l0_tool {

/// The folder of what a run of `--as-one` keeps until all is done, in its output directory.
constexpr const char* work_folder = "work";

/// The file that tells of the tiles.
constexpr const char* index_name = "index.json";

/// \param extension with its dot
std::string tile_name(std::size_t tile, const std::string& extension);

/// Whether a run with this output directory may write or remove a file of that path.
/// \param extension of the tiles, with its dot
bool is_file_of_run(const std::string& directory, const std::string& path,
                    const std::string& extension);

/// Of a directory that has no run: what others have there stays.
/// \param may_replace whether files may be replaced; the folder of a run is never another one
/// \throws Failure with OUTPUT_NOT_WRITTEN
void check_directory_of_new_run(const std::string& directory, const std::string& extension,
                                bool may_replace);

} // namespace l0_tool

#endif // L0_RESAMPLE_TILE_FOLDER_H
