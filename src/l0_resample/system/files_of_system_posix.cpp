// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/files_of_system.h"

#include <cerrno>
#include <cstdio>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace l0_tool {
namespace {

File_status file_status(const struct stat& status)
{
  File_status result;
  result.kind = S_ISREG(status.st_mode)   ? File_kind::REGULAR
                : S_ISDIR(status.st_mode) ? File_kind::FOLDER
                                          : File_kind::OTHER;
  result.size = std::uint64_t(status.st_size);
  result.permissions = status.st_mode & 07777;
  result.number = {std::uint64_t(status.st_dev), std::uint64_t(status.st_ino)};
  result.seconds = status.st_mtim.tv_sec;
  result.nanoseconds = status.st_mtim.tv_nsec;
  return result;
}

} // namespace

std::optional<File_status> status_of(const std::string& path)
{
  struct stat status;
  if (stat(path.c_str(), &status) != 0)
    return std::nullopt;
  return file_status(status);
}

std::optional<File_status> status_of(int descriptor)
{
  struct stat status;
  if (fstat(descriptor, &status) != 0)
    return std::nullopt;
  return file_status(status);
}

int open_to_read(const std::string& path) { return open(path.c_str(), O_RDONLY | O_CLOEXEC); }

int open_to_write(const std::string& path) { return open(path.c_str(), O_WRONLY | O_CLOEXEC); }

int create_to_write(const std::string& path)
{
  return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

int duplicate(int descriptor) { return fcntl(descriptor, F_DUPFD_CLOEXEC, 0); }

int close_descriptor(int descriptor) { return close(descriptor); }

std::ptrdiff_t read_some(int descriptor, char* target, std::size_t n)
{
  return read(descriptor, target, n);
}

std::ptrdiff_t read_some_at(int descriptor, std::uint64_t position, char* target, std::size_t n)
{
  return pread(descriptor, target, n, off_t(position));
}

std::ptrdiff_t write_some(int descriptor, const char* bytes, std::size_t n)
{
  return write(descriptor, bytes, n);
}

void wait_until_writable(int descriptor)
{
  pollfd waiting = {descriptor, POLLOUT, 0};
  poll(&waiting, 1, -1);
}

std::int64_t position_of(int descriptor) { return lseek(descriptor, 0, SEEK_CUR); }

bool move_to(int descriptor, std::uint64_t position)
{
  return lseek(descriptor, off_t(position), SEEK_SET) >= 0;
}

bool is_open_for_writing(int descriptor)
{
  const int flags = fcntl(descriptor, F_GETFL);
  return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

bool is_terminal(int descriptor) { return isatty(descriptor) != 0; }

bool may_write(const std::string& path) { return access(path.c_str(), W_OK) == 0; }

bool may_write_into(const std::string& folder) { return access(folder.c_str(), W_OK | X_OK) == 0; }

bool set_permissions(int descriptor, unsigned permissions)
{
  return fchmod(descriptor, mode_t(permissions)) == 0;
}

bool synchronize(int descriptor) { return fsync(descriptor) == 0; }

void synchronize_folder(const std::string& folder)
{
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0)
    return;
  fsync(descriptor);
  close(descriptor);
}

bool move_file(const std::string& from, const std::string& to, bool replaces)
{
  const unsigned flags = replaces ? 0 : RENAME_NOREPLACE;
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) == 0)
    return true;
  if (errno != EINVAL)
    return false;
  // This file system knows no flags.
  if (!replaces && status_of(to)) {
    errno = EEXIST;
    return false;
  }
  return std::rename(from.c_str(), to.c_str()) == 0;
}

unsigned long process_number() { return static_cast<unsigned long>(getpid()); }

} // namespace l0_tool
