// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TASK_FILE_H
#define L0_RESAMPLE_TASK_FILE_H

#include "files/Output_file.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace l0_tool {

/// A number that differs for different bytes, but for accidents; of all that was added so far.
class Checksum
{
  std::uint64_t m_value = 0xcbf29ce484222325;
  char m_rest[8];
  std::size_t m_size_of_rest = 0;

  void add_word(const char* bytes);

public:
  void add(std::string_view bytes);
  std::uint64_t value() const;
};

/*!
Writes what a task of a run has found. The file is there as a whole or not at all, as `Output_file`
has it, and tells at its end which run it belongs to and what its bytes sum up to.
*/
class Task_file_writer
{
  Output_file m_file;
  std::uint64_t m_key;
  std::uint64_t m_size = 0;
  Checksum m_checksum;

public:
  /// \param key of the run
  Task_file_writer(const std::string& path, std::uint64_t key) : m_file(path), m_key(key) {}

  void write_bytes(std::string_view bytes);

  template <typename T>
  void write(const T& value)
  {
    static_assert(std::is_trivially_copyable<T>::value, "what is no plain data has pointers");
    write_bytes({reinterpret_cast<const char*>(&value), sizeof value});
  }

  /// The number of values, and these.
  template <typename T>
  void write_all(const T* values, std::size_t size)
  {
    static_assert(std::is_trivially_copyable<T>::value, "what is no plain data has pointers");
    write(std::uint64_t(size));
    write_bytes({reinterpret_cast<const char*>(values), size * sizeof(T)});
  }
  template <typename T, typename Allocator>
  void write_all(const std::vector<T, Allocator>& values)
  {
    write_all(values.data(), values.size());
  }

  std::uint64_t size() const { return m_size; }

  void commit();
};

/// Reads what `Task_file_writer` has written.
/// \throws Failure with RUN_TIME_FAILURE where the file is not what it should be
class Task_file
{
  std::string m_path;
  int m_descriptor = -1;
  std::uint64_t m_size = 0; // of what was written
  std::uint64_t m_checksum = 0;
  std::uint64_t m_position = 0;

  [[noreturn]] void fail(const std::string& what) const;

public:
  /// \param key of the run that it has to belong to
  Task_file(const std::string& path, std::uint64_t key);
  ~Task_file();
  Task_file(const Task_file&) = delete;
  Task_file& operator=(const Task_file&) = delete;

  /// Reads all of it, to see whether it is what was written.
  void verify() const;

  std::uint64_t size() const { return m_size; }
  std::uint64_t position() const { return m_position; }
  void seek(std::uint64_t position) { m_position = position; }

  void read_bytes(std::uint64_t n, char* target);

  template <typename T>
  T read()
  {
    T value;
    read_bytes(sizeof value, reinterpret_cast<char*>(&value));
    return value;
  }

  /// What `write_all()` has written.
  /// \param values out
  template <typename T, typename Allocator>
  void read_all(std::vector<T, Allocator>& values)
  {
    const std::uint64_t count = read<std::uint64_t>();
    if (count > (m_size - m_position) / sizeof(T))
      fail("is damaged");
    values.resize(static_cast<std::size_t>(count));
    read_bytes(count * sizeof(T), reinterpret_cast<char*>(values.data()));
  }
};

/// Whether there is a file of this run at `path`, all of it.
/// \param reason out: why not, if there is something else
bool is_task_file(const std::string& path, std::uint64_t key, std::string& reason);

} // namespace l0_tool

#endif // L0_RESAMPLE_TASK_FILE_H
