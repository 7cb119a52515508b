// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Command_of_shell.h"

#include <cstdint>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <io.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace l0_tool {
namespace {

/// Of the command's environment: what stands in a variable is no command, whatever is in it.
const std::string variable = "L0_RESAMPLE_INPUT";

[[noreturn]] void fail() { throw std::system_error(int(GetLastError()), std::system_category()); }

std::string with_variable(std::string command, const std::string& placeholder)
{
  const std::string reference = "\"%" + variable + "%\"";
  for (std::size_t at = command.find(placeholder); at != std::string::npos;
       at = command.find(placeholder, at + reference.size()))
    command.replace(at, placeholder.size(), reference);
  return command;
}

/// The environment of this process with the variable, each entry with its zero and one at the end.
std::vector<char> environment_with(const std::string& value)
{
  std::vector<char> result;
  const auto append = [&](const std::string& entry) {
    result.insert(result.end(), entry.begin(), entry.end());
    result.push_back('\0');
  };
  char* const entries = GetEnvironmentStringsA();
  for (const char* entry = entries; *entry != '\0'; entry += std::string(entry).size() + 1)
    append(entry);
  FreeEnvironmentStringsA(entries);
  append(variable + "=" + value);
  result.push_back('\0');
  return result;
}

/// A handle that is closed with the object.
class Handle
{
  HANDLE m_handle;

public:
  explicit Handle(HANDLE handle) : m_handle(handle) {}
  ~Handle()
  {
    if (m_handle != nullptr && m_handle != INVALID_HANDLE_VALUE)
      CloseHandle(m_handle);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  HANDLE get() const { return m_handle; }

  /// The caller closes it.
  HANDLE release()
  {
    const HANDLE handle = m_handle;
    m_handle = nullptr;
    return handle;
  }
};

/// A job ends with its last handle, and all that runs in it.
HANDLE make_job()
{
  const HANDLE job = CreateJobObjectA(nullptr, nullptr);
  JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits = {};
  limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
  if (job == nullptr
      || !SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits))
    fail();
  return job;
}

} // namespace

struct Command_of_shell::Process
{
  Handle job{make_job()}, process{nullptr};
  int output = -1;

  explicit Process(HANDLE started) : process(started) {}
  ~Process()
  {
    if (output >= 0)
      _close(output);
  }
};

Command_of_shell::Command_of_shell(const std::string& command, const std::string& placeholder,
                                   const std::string& argument)
{
  SECURITY_ATTRIBUTES inherited = {sizeof inherited, nullptr, TRUE};
  HANDLE ends[2];
  if (!CreatePipe(&ends[0], &ends[1], &inherited, 0))
    fail();
  Handle output(ends[0]);
  const Handle other_end(ends[1]);
  SetHandleInformation(output.get(), HANDLE_FLAG_INHERIT, 0);
  const Handle input(CreateFileA("NUL", GENERIC_READ, FILE_SHARE_READ | FILE_SHARE_WRITE,
                                 &inherited, OPEN_EXISTING, 0, nullptr));
  STARTUPINFOA startup = {};
  startup.cb = sizeof startup;
  startup.dwFlags = STARTF_USESTDHANDLES;
  startup.hStdInput = input.get();
  startup.hStdOutput = other_end.get();
  startup.hStdError = GetStdHandle(STD_ERROR_HANDLE);

  // With /s, cmd takes away the first and the last quote, and nothing else.
  std::string line = "cmd.exe /d /s /c \"" + with_variable(command, placeholder) + "\"";
  std::vector<char> environment = environment_with(argument);
  PROCESS_INFORMATION started = {};
  if (!CreateProcessA(nullptr, line.data(), nullptr, nullptr, TRUE, CREATE_SUSPENDED,
                      environment.data(), nullptr, &startup, &started))
    fail();
  const Handle thread(started.hThread);
  m_process = std::make_unique<Process>(started.hProcess);
  AssignProcessToJobObject(m_process->job.get(), started.hProcess);
  ResumeThread(thread.get());
  m_process->output = _open_osfhandle(reinterpret_cast<std::intptr_t>(output.release()),
                                      _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

Command_of_shell::~Command_of_shell() = default;

int Command_of_shell::output() const { return m_process->output; }

std::optional<std::string> Command_of_shell::wait()
{
  constexpr DWORD milliseconds = 100;
  if (WaitForSingleObject(m_process->process.get(), milliseconds) == WAIT_TIMEOUT)
    return std::nullopt;
  DWORD status = 0;
  if (!GetExitCodeProcess(m_process->process.get(), &status))
    fail();
  return status == 0 ? std::string() : "ended with status " + std::to_string(status);
}

} // namespace l0_tool
