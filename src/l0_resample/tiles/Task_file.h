// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TASK_FILE_H
#define L0_RESAMPLE_TASK_FILE_H

#include "files/Output_file.h"

#include <CGAL/L0_resampling/Is_plain.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace l0_tool {

using CGAL::L0_resampling::is_made_of;

/// Whether values of `T` can go to files as they are in memory, so that equal results are equal
/// files. Each class of the tool that is written has a specialization.
template <typename T>
struct Is_plain : CGAL::L0_resampling::Is_plain<T>
{};

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
Writes what a task of a run has found, as a model of `L0ResamplingTileArchive`. The file is there as
a whole or not at all, as `Output_file` has it, and tells at its end which run it belongs to and
what its bytes sum up to.
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

  void write(bool value) { write(std::uint8_t(value ? 1 : 0)); }

  template <typename T>
  void write(const T& value)
  {
    static_assert(Is_plain<T>::value, "not all bytes mean something, or not any bytes are a value");
    write_bytes({reinterpret_cast<const char*>(&value), sizeof value});
  }

  /// The number of values, and these.
  template <typename T>
  void write_all(const T* values, std::size_t size)
  {
    static_assert(Is_plain<T>::value, "not all bytes mean something, or not any bytes are a value");
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

/// Reads what `Task_file_writer` has written, as a model of `L0ResamplingTileArchive`.
/// \throws Failure with RUN_TIME_FAILURE where the file is not what it should be
class Task_file
{
  std::string m_path;
  int m_descriptor = -1;
  std::uint64_t m_size = 0; // of what was written
  std::uint64_t m_checksum = 0;
  std::uint64_t m_position = 0;

  [[noreturn]] void fail(const std::string& what) const;

  /// Reads `n` bytes from `position` on.
  void read_at(std::uint64_t position, std::uint64_t n, char* target) const;

  /// The number that `write_all()` has written, of values that are there.
  template <typename T>
  std::uint64_t read_count()
  {
    const std::uint64_t count = read<std::uint64_t>();
    if (count > (m_size - m_position) / sizeof(T))
      fail("is damaged");
    return count;
  }

public:
  /// \param key of the run that it has to belong to
  Task_file(const std::string& path, std::uint64_t key);
  ~Task_file();
  Task_file(const Task_file&) = delete;
  Task_file& operator=(const Task_file&) = delete;

  /// Reads all of it, to see whether it is what was written.
  void verify() const;

  std::uint64_t size() const { return m_size; }
  void seek(std::uint64_t position) { m_position = position; }

  void read_bytes(std::uint64_t n, char* target);

  template <typename T>
  T read()
  {
    if constexpr (std::is_same<T, bool>::value)
      return read_number_below<std::uint8_t>(2) == 1;
    else {
      static_assert(Is_plain<T>::value, "what is damaged may be no value");
      T value;
      read_bytes(sizeof value, reinterpret_cast<char*>(&value));
      return value;
    }
  }

  /// A number that stands for one of so many things.
  template <typename T>
  T read_number_below(T end)
  {
    const T number = read<T>();
    if (number >= end)
      fail("is damaged");
    return number;
  }

  /// What `write_all()` has written.
  /// \param values out
  template <typename T, typename Allocator>
  void read_all(std::vector<T, Allocator>& values)
  {
    static_assert(Is_plain<T>::value, "what is damaged may be no value");
    const std::uint64_t count = read_count<T>();
    values.resize(static_cast<std::size_t>(count));
    read_bytes(count * sizeof(T), reinterpret_cast<char*>(values.data()));
  }

  /// Passes by what `read_all()` would read.
  template <typename T>
  void skip_all()
  {
    m_position += read_count<T>() * sizeof(T);
  }

  /// Reads some of many values, wherever `read()` would go on. For several threads at once.
  /// \param begin of the first of all values, in bytes
  /// \param values out
  template <typename T, typename Allocator>
  void read_some(std::uint64_t begin, std::uint64_t first, std::uint64_t count,
                 std::vector<T, Allocator>& values) const
  {
    static_assert(Is_plain<T>::value, "what is damaged may be no value");
    const std::uint64_t number = begin <= m_size ? (m_size - begin) / sizeof(T) : 0;
    if (first > number || count > number - first)
      fail("is damaged");
    values.resize(static_cast<std::size_t>(count));
    read_at(begin + first * sizeof(T), count * sizeof(T), reinterpret_cast<char*>(values.data()));
  }
};

/// Whether there is a file of this run at `path`, all of it.
/// \param reason out: why not, if there is something else
bool is_task_file(const std::string& path, std::uint64_t key, std::string& reason);

} // namespace l0_tool

#endif // L0_RESAMPLE_TASK_FILE_H
