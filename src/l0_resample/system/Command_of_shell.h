// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_COMMAND_OF_SHELL_H
#define L0_RESAMPLE_COMMAND_OF_SHELL_H

#include <memory>
#include <optional>
#include <string>

namespace l0_tool {

/// A running command of the system's shell.
class Command_of_shell
{
public:
  /// Starts the command, with nothing on its standard input.
  /// \param placeholder in the command, which stands for `argument`, one word whatever is in it
  /// \throws std::system_error where it cannot be started
  Command_of_shell(const std::string& command, const std::string& placeholder,
                   const std::string& argument);

  /// Ends the command and what it has started, if they have not ended.
  ~Command_of_shell();

  Command_of_shell(const Command_of_shell&) = delete;
  Command_of_shell& operator=(const Command_of_shell&) = delete;

  /// Where its standard output is read; closed with the object.
  int output() const;

  /// Waits for its end.
  /// \returns what was not as it should be, such as "ended with status 1", or an empty text;
  /// nothing where an interrupt may have come first
  /// \throws std::system_error
  std::optional<std::string> wait();

private:
  struct Process;
  std::unique_ptr<Process> m_process;
};

} // namespace l0_tool

#endif // L0_RESAMPLE_COMMAND_OF_SHELL_H
