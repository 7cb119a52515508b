// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_OUTPUT_FILE_H
#define L0_RESAMPLE_OUTPUT_FILE_H

#include "files/Destination.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace l0_tool {

/// What to do with a regular file that has the name of the one to write.
enum class Existing_file
{
  KEEP, ///< and fail
  REPLACE
};

/*!
Writes a file as a whole or not at all: into a temporary file beside it, which takes its place in
`commit()` once every byte is on the disk. Without `commit()` the temporary is removed and an older
file of that name stays what it was. What is no regular file, such as a pipe, is written to
directly, and so is a descriptor that is open already, such as /dev/stdout, whatever it is
redirected to; see `destination_of()`.

Every member throws Failure with OUTPUT_NOT_WRITTEN, or with the status of an interrupt.
*/
class Output_file
{
public:
  /// A symbolic link is followed. The permissions of an older file are kept.
  explicit Output_file(const std::string& path, Existing_file existing = Existing_file::REPLACE);
  ~Output_file();
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  void write(std::string_view bytes);
  void commit();

private:
  void open_directly(const Destination& destination);
  void open_temporary();
  void keep_permissions(unsigned mode);
  void flush();
  void move_into_place();
  [[noreturn]] void fail(const std::string& what) const;

  std::string m_path;   // as the user gave it, for messages
  std::string m_target; // without symbolic links
  Existing_file m_existing;
  std::string m_temporary; // empty where m_target is written directly
  int m_descriptor = -1;
  std::string m_buffer;
};

/// Finds out before the long work whether an Output_file for `path` can be made and its disk has
/// room for `size` bytes.
/// \throws Failure with OUTPUT_NOT_WRITTEN if not
void check_writable(const std::string& path, std::uint64_t size);

} // namespace l0_tool

#endif // L0_RESAMPLE_OUTPUT_FILE_H
