// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/files_of_system.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <limits>
#include <system_error>

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace l0_tool {
namespace {

HANDLE handle_of(int descriptor) { return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor)); }

/// The number of `errno` for an error of the system.
int error_number(DWORD error)
{
  switch (error) {
  case ERROR_FILE_NOT_FOUND:
  case ERROR_PATH_NOT_FOUND:
  case ERROR_INVALID_NAME: return ENOENT;
  case ERROR_ACCESS_DENIED:
  case ERROR_SHARING_VIOLATION: return EACCES;
  case ERROR_INVALID_HANDLE: return EBADF;
  case ERROR_FILE_EXISTS:
  case ERROR_ALREADY_EXISTS: return EEXIST;
  case ERROR_DISK_FULL: return ENOSPC;
  case ERROR_NO_DATA:
  case ERROR_BROKEN_PIPE: return EPIPE;
  case ERROR_OPERATION_ABORTED: return EINTR; // by CancelSynchronousIo()
  default: return EIO;
  }
}

bool fail()
{
  errno = error_number(GetLastError());
  return false;
}

std::optional<File_status> status_of_handle(HANDLE handle)
{
  File_status result;
  if (handle == INVALID_HANDLE_VALUE) {
    errno = EBADF;
    return std::nullopt;
  }
  if (GetFileType(handle) != FILE_TYPE_DISK)
    return result;
  BY_HANDLE_FILE_INFORMATION information;
  if (!GetFileInformationByHandle(handle, &information)) {
    fail();
    return std::nullopt;
  }
  const auto join = [](DWORD high, DWORD low) { return std::uint64_t(high) << 32 | low; };
  const bool is_folder = (information.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  result.kind = is_folder ? File_kind::FOLDER : File_kind::REGULAR;
  result.size = join(information.nFileSizeHigh, information.nFileSizeLow);
  result.number = {information.dwVolumeSerialNumber,
                   join(information.nFileIndexHigh, information.nFileIndexLow)};
  // in units of 100 ns since 1601
  const std::int64_t time = std::int64_t(join(information.ftLastWriteTime.dwHighDateTime,
                                              information.ftLastWriteTime.dwLowDateTime))
                            - 116444736000000000;
  result.seconds = time / 10000000;
  result.nanoseconds = long(time % 10000000) * 100;
  return result;
}

/// The largest part of a long block that a call takes.
unsigned part(std::size_t n)
{
  return unsigned((std::min)(n, std::size_t((std::numeric_limits<int>::max)())));
}

/// The result of a function of the C library, which does not know of cancelled calls.
std::ptrdiff_t number_of_bytes(int result)
{
  if (result < 0 && _doserrno == ERROR_OPERATION_ABORTED)
    errno = EINTR;
  return result;
}

} // namespace

std::optional<File_status> status_of(const std::string& path)
{
  const HANDLE handle = CreateFileA(path.c_str(), FILE_READ_ATTRIBUTES,
                                    FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr,
                                    OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS /* for folders */,
                                    nullptr);
  if (handle == INVALID_HANDLE_VALUE) {
    fail();
    return std::nullopt;
  }
  const std::optional<File_status> result = status_of_handle(handle);
  CloseHandle(handle);
  return result;
}

std::optional<File_status> status_of(int descriptor)
{
  return status_of_handle(handle_of(descriptor));
}

int open_to_read(const std::string& path)
{
  // which the system calls a matter of permissions
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    errno = EISDIR;
    return -1;
  }
  return _open(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

int open_to_write(const std::string& path)
{
  return _open(path.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT);
}

int create_to_write(const std::string& path)
{
  return _open(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT,
               _S_IREAD | _S_IWRITE);
}

int duplicate(int descriptor)
{
  HANDLE copy;
  if (!DuplicateHandle(GetCurrentProcess(), handle_of(descriptor), GetCurrentProcess(), &copy, 0,
                       FALSE, DUPLICATE_SAME_ACCESS)) {
    fail();
    return -1;
  }
  return _open_osfhandle(reinterpret_cast<std::intptr_t>(copy), _O_BINARY | _O_NOINHERIT);
}

int close_descriptor(int descriptor) { return _close(descriptor); }

std::ptrdiff_t read_some(int descriptor, char* target, std::size_t n)
{
  return number_of_bytes(_read(descriptor, target, part(n)));
}

std::ptrdiff_t read_some_at(int descriptor, std::uint64_t position, char* target, std::size_t n)
{
  OVERLAPPED place = {};
  place.Offset = DWORD(position);
  place.OffsetHigh = DWORD(position >> 32);
  DWORD count = 0;
  if (ReadFile(handle_of(descriptor), target, part(n), &count, &place))
    return std::ptrdiff_t(count);
  if (GetLastError() == ERROR_HANDLE_EOF)
    return 0;
  fail();
  return -1;
}

std::ptrdiff_t write_some(int descriptor, const char* bytes, std::size_t n)
{
  return number_of_bytes(_write(descriptor, bytes, part(n)));
}

void wait_until_writable(int) {} // All descriptors block.

std::int64_t position_of(int descriptor)
{
  return GetFileType(handle_of(descriptor)) == FILE_TYPE_DISK ? _telli64(descriptor) : -1;
}

bool move_to(int descriptor, std::uint64_t position)
{
  return _lseeki64(descriptor, std::int64_t(position), SEEK_SET) >= 0;
}

bool is_open_for_writing(int descriptor)
{
  return GetFileType(handle_of(descriptor)) != FILE_TYPE_UNKNOWN; // The rest is learned by writing.
}

bool is_terminal(int descriptor)
{
  DWORD mode;
  return GetConsoleMode(handle_of(descriptor), &mode) != 0;
}

bool may_write(const std::string& path) { return _access(path.c_str(), 2) == 0; }

// Lists of rights, which only an attempt to write asks, apply to a folder.
bool may_write_into(const std::string& folder) { return _access(folder.c_str(), 0) == 0; }

bool set_permissions(int, unsigned) { return true; } // They are those of the folder.

bool synchronize(int descriptor) { return FlushFileBuffers(handle_of(descriptor)) != 0 || fail(); }

void synchronize_folder(const std::string&) {} // move_file() does.

bool move_file(const std::string& from, const std::string& to, bool replaces)
{
  const DWORD flags = MOVEFILE_WRITE_THROUGH | (replaces ? MOVEFILE_REPLACE_EXISTING : 0);
  return MoveFileExA(from.c_str(), to.c_str(), flags) != 0 || fail();
}

unsigned long process_number() { return GetCurrentProcessId(); }

} // namespace l0_tool
