// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Command_output.h"

#include "basis/Failure.h"
#include "basis/signals.h"

#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace l0_tool {
namespace {

/// With the shell's first argument in place of each placeholder, so that it quotes nothing.
std::string with_argument(std::string command)
{
  const std::string_view placeholder = Command_output::placeholder, argument = "\"$1\"";
  for (std::size_t at = command.find(placeholder); at != std::string::npos;
       at = command.find(placeholder, at + argument.size()))
    command.replace(at, placeholder.size(), argument);
  return command;
}

/// Attributes of the new process: a group of its own, and signals as a program expects them.
class Spawn_settings
{
public:
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;

  explicit Spawn_settings(int output)
  {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawnattr_init(&attributes);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes, &signals);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ})
      sigaddset(&signals, signal);
    posix_spawnattr_setsigdefault(&attributes, &signals);
    posix_spawnattr_setflags(&attributes, short(POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF
                                                | POSIX_SPAWN_SETSIGMASK));
  }
  ~Spawn_settings()
  {
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
  Spawn_settings(const Spawn_settings&) = delete;
  Spawn_settings& operator=(const Spawn_settings&) = delete;
};

std::string what_ended(int status)
{
  if (WIFSIGNALED(status))
    return "was ended by signal " + std::to_string(WTERMSIG(status));
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

} // namespace

Command_output::Command_output(const std::string& command, const std::string& path)
  : m_command(command)
{
  const auto refuse = [&](int error) {
    throw Failure(RUN_TIME_FAILURE, "'" + m_command + "' cannot be started: "
                                      + std::generic_category().message(error));
  };
  std::string words[] = {"sh", "-c", with_argument(command), "sh", path};
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    refuse(errno);
  const Spawn_settings settings(ends[1]);
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(),
                       words[3].data(), words[4].data(), nullptr};
  const int error = posix_spawn(&m_process, "/bin/sh", &settings.actions, &settings.attributes,
                                arguments, environ);
  close(ends[1]);
  if (error != 0) {
    close(ends[0]);
    refuse(error);
  }
  m_descriptor = ends[0];
}

Command_output::~Command_output()
{
  close(m_descriptor);
  if (m_process < 0)
    return;
  kill(-m_process, SIGTERM);
  while (waitpid(m_process, nullptr, 0) < 0 && errno == EINTR)
    ;
}

void Command_output::wait()
{
  if (m_process < 0)
    return;
  int status = 0;
  while (waitpid(m_process, &status, 0) < 0) {
    if (errno != EINTR)
      throw Failure(RUN_TIME_FAILURE,
                    "'" + m_command + "': " + std::generic_category().message(errno));
    throw_if_interrupted();
  }
  m_process = -1;
  if (status != 0)
    throw Failure(INPUT_REFUSED, "'" + m_command + "' " + what_ended(status));
}

} // namespace l0_tool
