// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Command_of_shell.h"

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

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

/// With the shell's first argument in place of each placeholder, so that it quotes nothing.
std::string with_argument(std::string command, const std::string& placeholder)
{
  const std::string_view argument = "\"$1\"";
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

struct Command_of_shell::Process
{
  int output = -1;
  pid_t number = -1; // and the group of those that it starts
};

Command_of_shell::Command_of_shell(const std::string& command, const std::string& placeholder,
                                   const std::string& argument)
  : m_process(std::make_unique<Process>())
{
  std::string words[] = {"sh", "-c", with_argument(command, placeholder), "sh", argument};
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    fail(errno);
  const Spawn_settings settings(ends[1]);
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(),
                       words[3].data(), words[4].data(), nullptr};
  const int error = posix_spawn(&m_process->number, "/bin/sh", &settings.actions,
                                &settings.attributes, arguments, environ);
  close(ends[1]);
  if (error != 0) {
    close(ends[0]);
    fail(error);
  }
  m_process->output = ends[0];
}

Command_of_shell::~Command_of_shell()
{
  close(m_process->output);
  if (m_process->number < 0)
    return;
  kill(-m_process->number, SIGTERM);
  while (waitpid(m_process->number, nullptr, 0) < 0 && errno == EINTR)
    ;
}

int Command_of_shell::output() const { return m_process->output; }

std::optional<std::string> Command_of_shell::wait()
{
  if (m_process->number < 0)
    return std::string();
  int status = 0;
  if (waitpid(m_process->number, &status, 0) < 0) {
    if (errno != EINTR)
      fail(errno);
    return std::nullopt;
  }
  m_process->number = -1;
  return status == 0 ? std::string() : what_ended(status);
}

} // namespace l0_tool
