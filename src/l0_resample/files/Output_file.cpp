// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Output_file.h"

#include "basis/Failure.h"
#include "basis/signals.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace l0_tool {
namespace {

constexpr std::size_t buffer_size = 256 * 1024;

std::string message(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_to_write(const std::string& path, const std::string& what)
{
  const std::string name = path == standard_stream ? "standard output" : path;
  throw Failure(OUTPUT_NOT_WRITTEN, name + ": cannot be written: " + what);
}

bool is_special_file(const struct stat& status)
{
  return !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

std::string directory_of(const std::string& target)
{
  const std::filesystem::path path = target;
  return path.parent_path().string();
}

bool is_open_for_writing(int descriptor)
{
  const int flags = fcntl(descriptor, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

/// Waits where a descriptor of others does not block.
void wait_until_writable(int descriptor)
{
  pollfd waiting = {descriptor, POLLOUT, 0};
  poll(&waiting, 1, -1);
  throw_if_interrupted();
}

} // namespace

Output_file::Output_file(const std::string& path, Existing_file existing)
  : m_path(path), m_existing(existing)
{
  m_buffer.reserve(buffer_size);
  const Destination destination = destination_of(path);
  struct stat old;
  const bool exists = !destination.descriptor && stat(path.c_str(), &old) == 0;
  if (destination.descriptor || (exists && is_special_file(old)))
    open_directly(destination);
  else if (!exists && errno != ENOENT)
    fail(message(errno));
  else {
    m_target = destination.path;
    open_temporary();
    if (exists)
      keep_permissions(old.st_mode & 07777);
  }
}

void Output_file::open_directly(const Destination& destination)
{
  if (!destination.descriptor)
    m_descriptor = open(m_path.c_str(), O_WRONLY | O_CLOEXEC);
  else if (is_open_for_writing(*destination.descriptor))
    m_descriptor = fcntl(*destination.descriptor, F_DUPFD_CLOEXEC, 0);
  else
    errno = EBADF;
  if (m_descriptor < 0) {
    const int error = errno;
    throw_if_interrupted(); // while the other end of a pipe was waited for
    fail(message(error));
  }
}

void Output_file::open_temporary()
{
  // The process number tells programs apart, the counter what an earlier, killed one of that number
  // has left.
  const std::string process = std::to_string(getpid());
  const std::string stem = directory_of(m_target) + "/.l0_resample-" + process + "-";
  for (int attempt = 0; m_descriptor < 0; ++attempt) {
    m_temporary = stem + std::to_string(attempt) + ".tmp";
    m_descriptor = open(m_temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (m_descriptor < 0 && (errno != EEXIST || attempt == 1000)) {
      const int error = errno;
      m_temporary.clear();
      fail(message(error));
    }
  }
}

void Output_file::keep_permissions(unsigned mode)
{
  if (fchmod(m_descriptor, mode) == 0)
    return;
  const int error = errno;
  close(m_descriptor);
  unlink(m_temporary.c_str());
  fail(message(error));
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
    else if (errno == EAGAIN)
      wait_until_writable(m_descriptor);
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

  move_into_place();

  // The file is in its place; that its name survives a power cut is the directory's affair, and
  // some file systems cannot promise it.
  const int directory = open(directory_of(m_target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (directory >= 0) {
    fsync(directory);
    close(directory);
  }
}

void Output_file::move_into_place()
{
  const char *from = m_temporary.c_str(), *to = m_target.c_str();
  const unsigned flags = m_existing == Existing_file::KEEP ? RENAME_NOREPLACE : 0;
  int error = renameat2(AT_FDCWD, from, AT_FDCWD, to, flags) == 0 ? 0 : errno;
  if (flags != 0 && (error == EEXIST || error == EINVAL))
    check_nothing_is_replaced({m_path});
  if (error == EINVAL) // this file system knows no flags
    error = std::rename(from, to) == 0 ? 0 : errno;
  if (error != 0)
    fail(message(error));
  m_temporary.clear();
}

void Output_file::fail(const std::string& what) const { fail_to_write(m_path, what); }

void check_writable(const std::string& path, std::uint64_t size)
{
  const Destination destination = destination_of(path);
  if (destination.descriptor) {
    if (!is_open_for_writing(*destination.descriptor))
      fail_to_write(path, message(EBADF));
    return;
  }
  struct stat old;
  const bool exists = stat(path.c_str(), &old) == 0;
  if (!exists && errno != ENOENT)
    fail_to_write(path, message(errno));
  if (exists && S_ISDIR(old.st_mode))
    fail_to_write(path, "it is a directory");
  if (exists
      && access(path.c_str(), W_OK)
           != 0) // rename() would replace even a file that is write-protected
    fail_to_write(path, message(errno));
  if (exists && is_special_file(old))
    return;

  const std::string directory = directory_of(destination.path);
  if (access(directory.c_str(), W_OK | X_OK) != 0)
    fail_to_write(path, directory + ": " + message(errno));
  struct statvfs disk;
  if (statvfs(directory.c_str(), &disk) == 0 && disk.f_blocks > 0 && disk.f_frsize > 0
      && size / disk.f_frsize >= disk.f_bavail)
    fail_to_write(path, "about " + std::to_string(size)
                          + " bytes are needed, the disk has room for "
                          + std::to_string(std::uint64_t(disk.f_bavail) * disk.f_frsize));
}

} // namespace l0_tool
