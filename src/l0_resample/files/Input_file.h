// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_INPUT_FILE_H
#define L0_RESAMPLE_INPUT_FILE_H

#include "files/Command_output.h"
#include "files/Gzip_decoder.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace l0_tool {

/// Reads a file, a pipe or what a command makes of a file once, from begin to end, through a buffer
/// of fixed size: no content can make it allocate more. What gzip has compressed, whatever its name
/// is, is read as what it stands for. Every member throws Failure, with the status INPUT_REFUSED
/// where the file is to blame.
class Input_file
{
public:
  using On_progress = std::function<void(double)>;

  static constexpr std::size_t max_line_length = 64 * 1024;
  static constexpr std::size_t max_block_length = 64 * 1024;

  /// \param path "-" for the rest of standard input
  /// \param on_progress called now and then with the share of the file that was read, in [0, 1];
  /// never for a pipe
  /// \param command whose output is read in place of the file, as of `Command_output`; empty for
  /// none
  explicit Input_file(const std::string& path, On_progress on_progress = {},
                      const std::string& command = {});
  ~Input_file();
  Input_file(const Input_file&) = delete;
  Input_file& operator=(const Input_file&) = delete;

  /// The next line without its end (LF, CR LF, or CR alone if the first line has that) and, at the
  /// begin of the file, without the mark of UTF-8; nothing at the end of the file. Valid until the
  /// next call.
  std::optional<std::string_view> read_line();

  /// The next `n` bytes, `n` at most `max_block_length`. Valid until the next call.
  const char* read_bytes(std::size_t n);

  /// The same, or as many as there are, which are still to be read.
  std::string_view next_bytes(std::size_t n);

  void skip_bytes(std::uint64_t n);

  /// How many bytes were read.
  std::uint64_t position() const { return m_position; }

  /// Calls `read`, for which the file goes on at `position`, and then comes back to where it was.
  /// \returns false, without a call, for a pipe and for a compressed file
  bool look_ahead(std::uint64_t position, const std::function<void()>& read);

  /// Reads a compressed file, or the output of a command, to its end, as what it holds is only
  /// known to be sound then.
  void check_end();

  /// Nothing for a pipe, and for a compressed file.
  std::optional<std::uint64_t> bytes_left() const;

  /// Refuses a count that the rest of the file cannot hold, before anybody allocates for it.
  /// \param row_size the least number of bytes a row takes, > 0
  void check_count(std::uint64_t count, std::uint64_t row_size, const std::string& what) const;

  /// "file: line 7" or "file: byte 123", whichever of `read_line()` and `read_bytes()` was used
  /// last.
  std::string where() const;

  [[noreturn]] void refuse(const std::string& what) const;

  /// For messages: "standard input" for "-".
  const std::string& path() const { return m_path; }

private:
  static constexpr std::size_t buffer_size = 2 * max_line_length;

  std::size_t read_descriptor(char* target, std::size_t n);
  bool find_compression();
  bool fill();
  void move_to(std::uint64_t position);
  void look_at_begin_of_text();

  std::string m_path;
  On_progress m_on_progress;
  std::unique_ptr<Command_output> m_command; // if its output is read
  int m_descriptor;
  std::uint64_t m_begin_of_file = 0;   // where others may have left standard input
  std::optional<std::uint64_t> m_size; // of the file on the disk, from there on
  bool m_is_compression_known = false;
  std::optional<Gzip_decoder> m_gzip; // if the file is compressed
  std::unique_ptr<char[]> m_buffer;   // not initialized: a small file touches little of it
  std::size_t m_begin = 0, m_end = 0; // the unread part of the buffer
  std::uint64_t m_position = 0;       // in the file, of m_begin
  std::uint64_t m_line = 0;
  char m_line_end = '\n';
  bool m_in_text = true;
  bool m_is_ahead = false;
};

} // namespace l0_tool

#endif // L0_RESAMPLE_INPUT_FILE_H
