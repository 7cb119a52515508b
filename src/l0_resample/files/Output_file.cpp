// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Output_file.h"

#include "basis/Failure.h"
#include "basis/signals.h"
#include "system/files_of_system.h"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

namespace l0_tool {
namespace {

constexpr std::size_t buffer_size = 256 * 1024;

std::string message(int error) { return std::generic_category().message(error); }

[[noreturn]] void fail_to_write(const std::string& path, const std::string& what)
{
  const std::string name = path == standard_stream ? "standard output" : path;
  throw Failure(OUTPUT_NOT_WRITTEN, name + ": cannot be written: " + what);
}

std::string directory_of(const std::string& target)
{
  const std::filesystem::path path = target;
  return path.parent_path().string();
}

} // namespace

Output_file::Output_file(const std::string& path, Existing_file existing)
  : m_path(path), m_existing(existing)
{
  m_buffer.reserve(buffer_size);
  const Destination destination = destination_of(path);
  if (destination.descriptor) {
    open_directly(destination);
    return;
  }
  const std::optional<File_status> old = status_of(path);
  if (old && old->kind == File_kind::OTHER)
    open_directly(destination);
  else if (!old && errno != ENOENT)
    fail(message(errno));
  else {
    m_target = destination.path;
    open_temporary();
    if (old)
      keep_permissions(old->permissions);
  }
}

void Output_file::open_directly(const Destination& destination)
{
  if (!destination.descriptor)
    m_descriptor = open_to_write(m_path);
  else if (is_open_for_writing(*destination.descriptor))
    m_descriptor = duplicate(*destination.descriptor);
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
  const std::string process = std::to_string(process_number());
  const std::string stem = directory_of(m_target) + "/.l0_resample-" + process + "-";
  for (int attempt = 0; m_descriptor < 0; ++attempt) {
    m_temporary = stem + std::to_string(attempt) + ".tmp";
    m_descriptor = create_to_write(m_temporary);
    if (m_descriptor < 0 && (errno != EEXIST || attempt == 1000)) {
      const int error = errno;
      m_temporary.clear();
      fail(message(error));
    }
  }
}

void Output_file::keep_permissions(unsigned mode)
{
  if (set_permissions(m_descriptor, mode))
    return;
  const int error = errno;
  close_descriptor(m_descriptor);
  std::remove(m_temporary.c_str());
  fail(message(error));
}

Output_file::~Output_file()
{
  if (m_descriptor >= 0)
    close_descriptor(m_descriptor);
  if (!m_temporary.empty())
    std::remove(m_temporary.c_str());
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
    const std::ptrdiff_t n = write_some(m_descriptor, rest.data(), rest.size());
    if (n >= 0)
      rest.remove_prefix(std::size_t(n));
    else if (errno == EINTR)
      throw_if_interrupted();
    else if (errno == EAGAIN) { // a descriptor of others that does not block
      wait_until_writable(m_descriptor);
      throw_if_interrupted();
    } else
      fail(message(errno));
  }
  m_buffer.clear();
}

void Output_file::commit()
{
  flush();
  if (!m_temporary.empty() && !synchronize(m_descriptor))
    fail(message(errno));
  const int descriptor = m_descriptor;
  m_descriptor = -1;
  if (close_descriptor(descriptor) != 0)
    fail(message(errno));
  if (m_temporary.empty())
    return;

  move_into_place();

  // The file is in its place; that its name survives a power cut is the directory's affair, and
  // some file systems cannot promise it.
  synchronize_folder(directory_of(m_target));
}

void Output_file::move_into_place()
{
  const bool replaces = m_existing == Existing_file::REPLACE;
  if (!move_file(m_temporary, m_target, replaces)) {
    const int error = errno;
    if (!replaces && error == EEXIST)
      check_nothing_is_replaced({m_path});
    fail(message(error));
  }
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
  const std::optional<File_status> old = status_of(path);
  if (!old && errno != ENOENT)
    fail_to_write(path, message(errno));
  if (old && old->kind == File_kind::FOLDER)
    fail_to_write(path, "it is a directory");
  if (old && !may_write(path)) // move_file() would replace even a file that is write-protected
    fail_to_write(path, message(errno));
  if (old && old->kind == File_kind::OTHER)
    return;

  const std::string directory = directory_of(destination.path);
  if (!may_write_into(directory))
    fail_to_write(path, directory + ": " + message(errno));
  std::error_code error;
  const std::filesystem::space_info disk = std::filesystem::space(directory, error);
  if (!error && disk.capacity > 0 && size >= disk.available)
    fail_to_write(path, "about " + std::to_string(size)
                          + " bytes are needed, the disk has room for "
                          + std::to_string(disk.available));
}

} // namespace l0_tool
