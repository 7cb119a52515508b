// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sandbox.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <exception>
#include <stdexcept>

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace attack {
namespace {

void limit(int resource, std::size_t value)
{
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

[[noreturn]] void be_the_child(const std::function<std::string()>& f, const Limits& limits, int pipe)
{
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, limits.cpu_seconds);
  if (limits.bytes > 0)
    limit(RLIMIT_AS, limits.bytes);
  std::string answer;
  try
  {
    answer = f();
  }
  catch (const std::exception& e)
  {
    answer = std::string("an exception came through: ") + e.what();
  }
  for (std::size_t written = 0; written < answer.size();)
  {
    const ssize_t n = write(pipe, answer.data() + written, answer.size() - written);
    if (n < 0)
      _exit(2);
    written += std::size_t(n);
  }
  _exit(0); // what the parent has to do at its end is not to be done here too
}

} // namespace

std::string in_sandbox(const std::function<std::string()>& f, const Limits& limits)
{
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("no pipe");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("no process");
  if (child == 0)
  {
    close(ends[0]);
    be_the_child(f, limits, ends[1]);
  }
  close(ends[1]);

  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(limits.wall_seconds);
  std::string answer;
  bool hangs = false;
  for (;;)
  {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd ready{ends[0], POLLIN, 0};
    const int events = left > 0 ? poll(&ready, 1, int(left)) : 0;
    if (events < 0 && errno == EINTR)
      continue;
    char buffer[4096];
    const ssize_t n = events > 0 ? read(ends[0], buffer, sizeof(buffer)) : 0;
    hangs = events == 0;
    if (n <= 0)
      break;
    answer.append(buffer, std::size_t(n));
  }
  close(ends[0]);
  if (hangs)
    kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (hangs)
    return "it does not end";
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL
             ? "it takes too long"
             : std::string("killed: ") + strsignal(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0)
    return "the process ended with status " + std::to_string(WEXITSTATUS(status));
  return answer;
}

} // namespace attack
