// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_BATCH_H
#define L0_RESAMPLE_BATCH_H

#include "files/file_formats.h"

#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// One input of a batch, and where its result goes.
struct Batch_item
{
  std::string input;
  std::string output; ///< empty if there is a `refusal`
  File_format input_format = File_format::PLY;
  File_format output_format = File_format::PLY;
  std::string refusal; ///< a line that says why the input cannot be read; empty if it may be
};

/*!
Plans a batch: the result of `a/scan.xyz`, or of `a/scan.xyz.gz`, goes to `directory/scan.xyz`, or
to `directory/scan.ply` if the output format is PLY.

\param inputs files, and folders, which stand for those of their files that have a known extension,
in the order of
       their names
\param input_format of all inputs; by their extensions, if not given
\param output_format of all results; that of the input and its extension, if not given, and PLY for
       an input of a format that is only read

An input whose extension is not known, and a folder that cannot be read or has no file with a
known extension, stay in the batch with a refusal: a glob of the shell brings them along.

\throws Failure with WRONG_USAGE, before anything is written, if a result would take the place of
        an input or of another result, or if an input is standard input, which has no name
*/
std::vector<Batch_item> plan_batch(const std::vector<std::string>& inputs,
                                   const std::string& directory,
                                   std::optional<File_format> input_format,
                                   std::optional<File_format> output_format);

/// The files, and those of folders, in the same order each time, with their formats.
/// \param input_format of all of them; by their extensions, if not given
/// \throws Failure with INPUT_REFUSED for the first one that cannot be read
std::vector<Batch_item> parts_of_cloud(const std::vector<std::string>& inputs,
                                       std::optional<File_format> input_format);

} // namespace l0_tool

#endif // L0_RESAMPLE_BATCH_H
