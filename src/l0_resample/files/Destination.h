// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_DESTINATION_H
#define L0_RESAMPLE_DESTINATION_H

#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// The name of standard input as INPUT, and of standard output where something is written.
constexpr const char* standard_stream = "-";

/// Where the bytes written to a path go.
struct Destination
{
  std::optional<int> descriptor; ///< one that the program was started with
  std::string path;              ///< without symbolic links, unless there is a descriptor
};

/*!
Follows the symbolic links of `path`, the last of which may lead to a file that does not exist yet.
"-" is descriptor 1. A path that leads to /proc/self/fd/N, as /dev/stdout and /dev/fd/N do, is
descriptor N: it may be redirected to a regular file to which others write as well.

\throws Failure with OUTPUT_NOT_WRITTEN if `path` is relative and there is no current folder
*/
Destination destination_of(const std::string& path);

/// Whether both are the same file, or the same descriptor. An empty path is no file.
bool are_same_file(const std::string& path, const std::string& other);

/// Whether writing to `path` would replace a regular file.
bool would_replace_file(const std::string& path);

/// \throws Failure with OUTPUT_NOT_WRITTEN if a regular file has one of the names
void check_nothing_is_replaced(const std::vector<std::string>& paths);

/// Whether `path` is what the program's standard output goes to.
bool is_standard_output(const std::string& path);

} // namespace l0_tool

#endif // L0_RESAMPLE_DESTINATION_H
