// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Command_output.h"

#include "basis/Failure.h"
#include "basis/signals.h"

#include <optional>
#include <system_error>

namespace l0_tool {

Command_output::Command_output(const std::string& command, const std::string& path)
  : m_command(command)
{
  try {
    m_process = std::make_unique<Command_of_shell>(command, placeholder, path);
  } catch (const std::system_error& error) {
    throw Failure(RUN_TIME_FAILURE,
                  "'" + m_command + "' cannot be started: " + error.code().message());
  }
}

void Command_output::wait()
{
  std::optional<std::string> end;
  try {
    while (!(end = m_process->wait()))
      throw_if_interrupted();
  } catch (const std::system_error& error) {
    throw Failure(RUN_TIME_FAILURE, "'" + m_command + "': " + error.code().message());
  }
  if (!end->empty())
    throw Failure(INPUT_REFUSED, "'" + m_command + "' " + *end);
}

} // namespace l0_tool
