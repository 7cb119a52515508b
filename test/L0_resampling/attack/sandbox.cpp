// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sandbox.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <utility>

#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace attack {
namespace {

bool write_all(int pipe, const void* bytes, std::size_t size)
{
  for (std::size_t written = 0; written < size;)
  {
    const ssize_t n = write(pipe, static_cast<const char*>(bytes) + written, size - written);
    if (n < 0 && errno != EINTR)
      return false;
    written += n < 0 ? 0 : std::size_t(n);
  }
  return true;
}

struct Question
{
  std::size_t index, patience;
};

enum class Reading
{
  DONE,
  ENDED,
  TOO_LATE
};

/// \param seconds_left counted down while this process waits; without end if there are none to
/// count. The time for which somebody has stopped both processes does not count.
Reading read_all(int pipe, void* bytes, std::size_t size, std::size_t* seconds_left = nullptr)
{
  for (std::size_t done = 0; done < size;)
  {
    if (seconds_left)
    {
      pollfd ready{pipe, POLLIN, 0};
      const int events = poll(&ready, 1, 1000);
      if (events == 0 && (*seconds_left)-- == 0)
        return Reading::TOO_LATE;
      if (events <= 0)
        continue;
    }
    const ssize_t n = read(pipe, static_cast<char*>(bytes) + done, size - done);
    if (n == 0 || (n < 0 && errno != EINTR))
      return Reading::ENDED;
    done += n < 0 ? 0 : std::size_t(n);
  }
  return Reading::DONE;
}

void limit_bytes(std::size_t bytes)
{
  const rlimit both{bytes, bytes};
  if (bytes > 0)
    setrlimit(RLIMIT_AS, &both);
}

/// Of processor time from now on
void limit_seconds(std::size_t seconds)
{
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const rlimit soft{rlim_t(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + 2 + seconds,
                    RLIM_INFINITY};
  setrlimit(RLIMIT_CPU, &soft);
}

[[noreturn]] void be_the_child(const std::function<std::string(std::size_t)>& f,
                               const Limits& limits, int questions, int answers)
{
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  limit_bytes(limits.bytes);
  for (Question question; read_all(questions, &question, sizeof(question)) == Reading::DONE;)
  {
    limit_seconds(question.patience * limits.cpu_seconds);
    std::string answer;
    try
    {
      answer = f(question.index);
    }
    catch (const std::exception& e)
    {
      answer = std::string("an exception came through: ") + e.what();
    }
    const std::size_t size = answer.size();
    if (!write_all(answers, &size, sizeof(size)) || !write_all(answers, answer.data(), size))
      _exit(2);
  }
  _exit(0); // what the parent has to do at its end is not to be done here too
}

} // namespace

Sandbox::Sandbox(std::function<std::string(std::size_t)> f, const Limits& limits)
  : m_function(std::move(f)), m_limits(limits)
{
  signal(SIGPIPE, SIG_IGN); // a child that has died is seen where it is read
}

Sandbox::~Sandbox() { end_child(); }

void Sandbox::end_child()
{
  if (m_child < 0)
    return;
  kill(m_child, SIGKILL);
  wait_for_end();
}

void Sandbox::start_child()
{
  int questions[2], answers[2];
  if (pipe(questions) != 0 || pipe(answers) != 0)
    throw std::runtime_error("no pipe");
  m_child = fork();
  if (m_child < 0)
    throw std::runtime_error("no process");
  if (m_child == 0)
  {
    close(questions[1]);
    close(answers[0]);
    be_the_child(m_function, m_limits, questions[0], answers[1]);
  }
  close(questions[0]);
  close(answers[1]);
  m_questions = questions[1];
  m_answers = answers[0];
}

/// \returns the status of the child
int Sandbox::wait_for_end()
{
  close(m_questions);
  close(m_answers);
  int status = 0;
  waitpid(m_child, &status, 0);
  m_child = -1;
  return status;
}

std::string Sandbox::operator()(std::size_t i, std::size_t patience)
{
  if (m_child < 0)
    start_child();
  std::size_t seconds_left = patience * m_limits.wall_seconds;
  const Question question{i, patience};
  write_all(m_questions, &question, sizeof(question));
  std::size_t size = 0;
  std::string answer;
  Reading reading = read_all(m_answers, &size, sizeof(size), &seconds_left);
  if (reading == Reading::DONE)
  {
    answer.resize(size);
    reading = read_all(m_answers, &answer[0], size, &seconds_left);
  }
  if (reading == Reading::DONE)
    return answer;
  if (reading == Reading::TOO_LATE)
  {
    end_child();
    return "it does not end";
  }
  const int status = wait_for_end();
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL
             ? "it takes too long"
             : std::string("killed: ") + strsignal(WTERMSIG(status));
  return "the process ended with status " + std::to_string(WEXITSTATUS(status));
}

} // namespace attack
