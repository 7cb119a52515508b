// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_COMMAND_OUTPUT_H
#define L0_RESAMPLE_COMMAND_OUTPUT_H

#include "system/Command_of_shell.h"

#include <memory>
#include <string>

namespace l0_tool {

/// What a command of the shell writes to its standard output.
class Command_output
{
public:
  /// Where the name of the file goes in a command.
  static constexpr const char* placeholder = "{}";

  /// Starts the command, with nothing on its standard input.
  /// \param path in place of each `placeholder`, as one word whatever is in it
  /// \throws Failure with RUN_TIME_FAILURE where it cannot be started
  Command_output(const std::string& command, const std::string& path);

  /// Where to read; closed with the object.
  int descriptor() const { return m_process->output(); }

  /// Waits for the end of the command, whose output is read.
  /// \throws Failure with INPUT_REFUSED where its status is not 0
  void wait();

private:
  std::string m_command;
  std::unique_ptr<Command_of_shell> m_process; // ended with the object
};

} // namespace l0_tool

#endif // L0_RESAMPLE_COMMAND_OUTPUT_H
