// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_FILES_OF_SYSTEM_H
#define L0_RESAMPLE_FILES_OF_SYSTEM_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace l0_tool {

/*!
Files by descriptors, as POSIX has them and the C library of Windows too. A function that fails sets
`errno`: to EINTR where an interrupt ended it.
*/
constexpr int standard_input = 0, standard_output = 1, standard_error = 2;

enum class File_kind
{
  REGULAR,
  FOLDER,
  OTHER
};

struct File_status
{
  File_kind kind = File_kind::OTHER;
  std::uint64_t size = 0;                         ///< in bytes
  unsigned permissions = 0;                       ///< as chmod() has them
  std::pair<std::uint64_t, std::uint64_t> number; ///< of the file system, and of the file in it
  std::int64_t seconds = 0;                       ///< of the last change, since 1970
  long nanoseconds = 0;
};

/// Of the file that symbolic links lead to; nothing on failure.
std::optional<File_status> status_of(const std::string& path);
std::optional<File_status> status_of(int descriptor);

/// Descriptors that programs started by this one do not have; -1 on failure.
int open_to_read(const std::string& path);
int open_to_write(const std::string& path);
int create_to_write(const std::string& path); ///< fails where there is a file already
int duplicate(int descriptor);

/// \returns 0, or -1 on failure
int close_descriptor(int descriptor);

/// \returns the number of bytes, 0 at the end of the file, or -1 on failure
std::ptrdiff_t read_some(int descriptor, char* target, std::size_t n);

/// From a position in the file, wherever `read_some()` would go on. For several threads at once.
std::ptrdiff_t read_some_at(int descriptor, std::uint64_t position, char* target, std::size_t n);

/// \returns the number of bytes, or -1 on failure
std::ptrdiff_t write_some(int descriptor, const char* bytes, std::size_t n);

/// Waits where a descriptor does not block and EAGAIN was the answer.
void wait_until_writable(int descriptor);

/// Where `read_some()` goes on; -1 for what is no file.
std::int64_t position_of(int descriptor);

/// \returns whether `read_some()` goes on there
bool move_to(int descriptor, std::uint64_t position);

bool is_open_for_writing(int descriptor);
bool is_terminal(int descriptor);

/// Whether the permissions of a file, or of a folder for new files, let this process write.
bool may_write(const std::string& path);
bool may_write_into(const std::string& folder);

bool set_permissions(int descriptor, unsigned permissions);

/// Returns once what was written is on the disk.
bool synchronize(int descriptor);

/// The same for the names in a folder, as far as its file system can.
void synchronize_folder(const std::string& folder);

/// Gives a file another name in the same file system, at once.
/// \param replaces whether a file that has the name already gives way
bool move_file(const std::string& from, const std::string& to, bool replaces);

/// What tells running processes apart.
unsigned long process_number();

} // namespace l0_tool

#endif // L0_RESAMPLE_FILES_OF_SYSTEM_H
