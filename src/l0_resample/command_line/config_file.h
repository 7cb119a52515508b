// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_CONFIG_FILE_H
#define L0_RESAMPLE_CONFIG_FILE_H

#include <string>
#include <vector>

namespace CLI {

class App;

} // namespace CLI

namespace l0_tool {

/*!
Reads the lines "option = value" of a file, where option is the long name of one without dashes, and
the value of one that takes none is true or false. Empty lines and those that begin with # are
skipped.

\param command_line what has been parsed: it goes before the file, so that what it says, and what
       cannot go with that, is left out
\returns the words of a command line
\throws CLI::ParseError, with the line, for what a command line could not have, a second line of one
        option, and a file that cannot be read
*/
std::vector<std::string> read_config(const std::string& path, const CLI::App& command_line);

} // namespace l0_tool

#endif // L0_RESAMPLE_CONFIG_FILE_H
