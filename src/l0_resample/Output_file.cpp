// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_file.h"

#include "Failure.h"
#include "signals.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace l0_tool {
namespace {

constexpr std::size_t buffer_size = 256 * 1024;

std::string message(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_to_write(const std::string& path, const std::string& what)
{
  throw Failure(OUTPUT_NOT_WRITTEN, path + ": cannot be written: " + what);
}

bool is_special_file(const struct stat& status) { return !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode); }

// Where the file really is, so that a symbolic link stays one.
std::string resolve(const std::string& path)
{
  struct stat status;
  if (stat(path.c_str(), &status) == 0 && is_special_file(status))
    return path; // /dev/stdout may lead to a pipe, which is at no place
  std::error_code error;
  std::filesystem::path resolved = std::filesystem::absolute(path, error);
  if (!error)
    resolved = std::filesystem::weakly_canonical(resolved, error);
  if (error)
    fail_to_write(path, error.message());
  return resolved.string();
}

std::string directory_of(const std::string& target) { return std::filesystem::path(target).parent_path().string(); }

} // namespace

Output_file::Output_file(const std::string& path) : m_path(path), m_target(resolve(path))
{
  m_buffer.reserve(buffer_size);
  struct stat old;
  const bool exists = stat(path.c_str(), &old) == 0;
  if (exists && is_special_file(old)) {
    m_descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (m_descriptor < 0) {
      const int error = errno;
      throw_if_interrupted(); // while the other end of a pipe was waited for
      fail(message(error));
    }
    return;
  }

  // The process number tells programs apart, the counter what an earlier, killed one of that number has left.
  for (int attempt = 0; m_descriptor < 0; ++attempt) {
    m_temporary = directory_of(m_target) + "/.l0_resample-" + std::to_string(getpid()) + "-" + std::to_string(attempt)
                  + ".tmp";
    m_descriptor = open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (m_descriptor < 0 && (errno != EEXIST || attempt == 1000)) {
      const int error = errno;
      m_temporary.clear();
      fail(message(error));
    }
  }
  if (exists && fchmod(m_descriptor, old.st_mode & 07777) != 0) {
    const int error = errno;
    close(m_descriptor);
    unlink(m_temporary.c_str());
    fail(message(error));
  }
}

Output_file::~Output_file()
{
  if (m_descriptor >= 0)
    close(m_descriptor);
  if (!m_temporary.empty())
    unlink(m_temporary.c_str());
}

void Output_file::write(std::string_view bytes)
{
  m_buffer += bytes;
  if (m_buffer.size() >= buffer_size)
    flush();
}

void Output_file::flush()
{
  throw_if_interrupted();
  std::string_view rest = m_buffer;
  while (!rest.empty()) {
    const ssize_t n = ::write(m_descriptor, rest.data(), rest.size());
    if (n >= 0)
      rest.remove_prefix(std::size_t(n));
    else if (errno == EINTR)
      throw_if_interrupted();
    else
      fail(message(errno));
  }
  m_buffer.clear();
}

void Output_file::commit()
{
  flush();
  if (!m_temporary.empty() && fsync(m_descriptor) != 0)
    fail(message(errno));
  const int descriptor = m_descriptor;
  m_descriptor = -1;
  if (close(descriptor) != 0)
    fail(message(errno));
  if (m_temporary.empty())
    return;

  if (std::rename(m_temporary.c_str(), m_target.c_str()) != 0)
    fail(message(errno));
  m_temporary.clear();

  // The file is in its place; that its name survives a power cut is the directory's affair, and some file systems
  // cannot promise it.
  const int directory = open(directory_of(m_target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory >= 0) {
    fsync(directory);
    close(directory);
  }
}

void Output_file::fail(const std::string& what) const { fail_to_write(m_path, what); }

void check_writable(const std::string& path, std::uint64_t size)
{
  struct stat old;
  const bool exists = stat(path.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode))
    fail_to_write(path, "it is a directory");
  if (exists && access(path.c_str(), W_OK) != 0) // rename() would replace even a file that is write-protected
    fail_to_write(path, message(errno));
  if (exists && is_special_file(old))
    return;

  const std::string directory = directory_of(resolve(path));
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    fail_to_write(path, directory + ": " + message(errno));
  struct statvfs disk;
  if (statvfs(directory.c_str(), &disk) == 0 && disk.f_blocks > 0 && disk.f_frsize > 0
      && size / disk.f_frsize >= disk.f_bavail)
    fail_to_write(path, "about " + std::to_string(size) + " bytes are needed, the disk has room for "
                          + std::to_string(std::uint64_t(disk.f_bavail) * disk.f_frsize));
}

bool is_standard_output(const std::string& path)
{
  struct stat file, standard_output;
  return stat(path.c_str(), &file) == 0 && fstat(STDOUT_FILENO, &standard_output) == 0
         && file.st_dev == standard_output.st_dev && file.st_ino == standard_output.st_ino;
}

} // namespace l0_tool
