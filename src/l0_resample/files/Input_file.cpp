// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "files/Input_file.h"

#include "basis/Failure.h"
#include "basis/signals.h"
#include "system/files_of_system.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace l0_tool {
namespace {

std::string last_error() { return std::generic_category().message(errno); }

int open_input(const std::string& path)
{
  if (path == "-")
    return duplicate(standard_input);
  return open_to_read(path);
}

} // namespace

Input_file::Input_file(const std::string& path, On_progress on_progress, const std::string& command)
  : m_path(path == "-" ? "standard input" : path), m_on_progress(std::move(on_progress)),
    m_command(command.empty() ? nullptr : std::make_unique<Command_output>(command, path)),
    m_descriptor(m_command ? m_command->descriptor() : open_input(path)),
    m_buffer(new char[buffer_size])
{
  if (m_descriptor < 0) {
    const std::string error = last_error();
    throw_if_interrupted(); // while the other end of a pipe was waited for
    throw Failure(INPUT_REFUSED, m_path + ": cannot be opened: " + error);
  }
  const std::optional<File_status> status = status_of(m_descriptor);
  if (!status || status->kind != File_kind::REGULAR)
    return;
  const std::int64_t begin = position_of(m_descriptor); // others may have read standard input
  // Files under /proc say that they are empty, and are not
  if (begin >= 0 && status->size > std::uint64_t(begin)) {
    m_begin_of_file = std::uint64_t(begin);
    m_size = status->size - m_begin_of_file;
  }
}

Input_file::~Input_file()
{
  if (m_descriptor >= 0 && !m_command)
    close_descriptor(m_descriptor);
}

// Appends to the unread part. Returns false at the end of the file.
bool Input_file::fill()
{
  throw_if_interrupted();
  if (m_size && m_on_progress && !m_is_ahead) {
    const std::uint64_t bytes_read = m_gzip ? m_gzip->compressed_bytes() : m_position;
    m_on_progress((std::min)(1., double(bytes_read) / double(*m_size)));
  }

  std::memmove(m_buffer.get(), m_buffer.get() + m_begin, m_end - m_begin);
  m_end -= m_begin;
  m_begin = 0;
  if (!m_is_compression_known && find_compression())
    return true;
  char* target = m_buffer.get() + m_end;
  const std::size_t room = buffer_size - m_end;
  const std::size_t n = m_gzip ? m_gzip->read(target, room) : read_descriptor(target, room);
  m_end += n;
  if (n == 0 && m_command)
    m_command->wait();
  return n > 0;
}

// Looks at the first bytes. Returns whether they are in the buffer now, not compressed.
bool Input_file::find_compression()
{
  m_is_compression_known = true;
  constexpr std::size_t needed = 2;
  while (m_end < needed) {
    const std::size_t n = read_descriptor(m_buffer.get() + m_end, needed - m_end);
    if (n == 0)
      break;
    m_end += n;
  }
  const std::string_view begin(m_buffer.get(), m_end);
  if (!Gzip_decoder::is_begin(begin))
    return m_end > 0;
  m_gzip.emplace(m_path, begin,
                 [this](char* target, std::size_t n) { return read_descriptor(target, n); });
  m_end = 0;
  return false;
}

std::size_t Input_file::read_descriptor(char* target, std::size_t n)
{
  for (;;) {
    const std::ptrdiff_t result = read_some(m_descriptor, target, n);
    if (result >= 0)
      return std::size_t(result);
    if (errno != EINTR)
      throw Failure(INPUT_REFUSED, m_path + ": cannot be read: " + last_error());
    throw_if_interrupted();
  }
}

void Input_file::look_at_begin_of_text()
{
  std::string_view begin;
  std::size_t end = 0; // of the first line
  const auto look = [&]() {
    begin = std::string_view(m_buffer.get() + m_begin, m_end - m_begin);
    end = (std::min)(begin.find_first_of("\r\n"), begin.size());
    return begin.size() - end > 1 || begin.size() > max_line_length;
  };
  while (!look() && fill())
    ;
  for (const std::string_view mark_of_utf16 : {"\xff\xfe", "\xfe\xff"})
    if (begin.substr(0, mark_of_utf16.size()) == mark_of_utf16)
      refuse("the text is one of UTF-16; save it as UTF-8 (iconv -f UTF-16 -t UTF-8)");
  const std::string_view rest = begin.substr(end);
  if (rest.size() > 1 && rest[0] == '\r' && rest[1] != '\r' && rest[1] != '\n')
    m_line_end = '\r';
}

std::optional<std::string_view> Input_file::read_line()
{
  constexpr std::string_view mark_of_utf8 = "\xef\xbb\xbf"; // Windows puts it before texts
  const bool is_first = m_position == 0;
  if (is_first)
    look_at_begin_of_text();
  m_in_text = true;
  ++m_line;
  std::size_t searched = 0;
  for (;;) {
    const char* begin = m_buffer.get() + m_begin;
    const std::size_t available = m_end - m_begin;
    const void* newline = std::memchr(begin + searched, m_line_end, available - searched);
    const std::size_t length = newline ? std::size_t(static_cast<const char*>(newline) - begin)
                                       : available;
    if (length > max_line_length)
      refuse("the line is longer than " + std::to_string(max_line_length) + " bytes");

    if (!newline) {
      searched = available;
      if (fill())
        continue;
      if (available == 0)
        return std::nullopt;
    }
    begin = m_buffer.get() + m_begin;
    const std::size_t consumed = length + (newline ? 1 : 0);
    m_begin += consumed;
    m_position += consumed;
    std::string_view line(begin, length);
    if (!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    if (is_first && line.substr(0, mark_of_utf8.size()) == mark_of_utf8)
      line.remove_prefix(mark_of_utf8.size());
    return line;
  }
}

const char* Input_file::read_bytes(std::size_t n)
{
  m_in_text = false;
  const std::string_view bytes = next_bytes(n);
  if (bytes.size() < n)
    refuse("the file ends here, where " + std::to_string(n - bytes.size())
           + " more bytes are expected");
  m_begin += n;
  m_position += n;
  return bytes.data();
}

std::string_view Input_file::next_bytes(std::size_t n)
{
  while (m_end - m_begin < n && fill())
    ;
  return {m_buffer.get() + m_begin, (std::min)(n, m_end - m_begin)};
}

void Input_file::skip_bytes(std::uint64_t n)
{
  check_count(n, 1, "bytes");
  while (n > 0) {
    const std::size_t block = std::size_t((std::min)(n, std::uint64_t(max_block_length)));
    read_bytes(block);
    n -= block;
  }
}

bool Input_file::look_ahead(std::uint64_t position, const std::function<void()>& read)
{
  if (!m_size || m_gzip)
    return false;
  const std::uint64_t here = m_position;
  if (position > *m_size)
    refuse("the file ends before byte " + std::to_string(position) + ", where it is said to go on");
  m_is_ahead = true;
  move_to(position);
  read();
  move_to(here);
  m_is_ahead = false;
  return true;
}

void Input_file::move_to(std::uint64_t position)
{
  if (!l0_tool::move_to(m_descriptor, m_begin_of_file + position))
    throw Failure(INPUT_REFUSED, m_path + ": cannot be read: " + last_error());
  m_begin = m_end = 0;
  m_position = position;
}

void Input_file::check_end()
{
  if (!m_gzip && !m_command)
    return;
  do {
    m_position += m_end - m_begin;
    m_begin = m_end = 0;
  } while (fill());
}

std::optional<std::uint64_t> Input_file::bytes_left() const
{
  if (!m_size || m_gzip)
    return std::nullopt;
  return *m_size > m_position ? *m_size - m_position : 0;
}

void Input_file::check_count(std::uint64_t count, std::uint64_t row_size,
                             const std::string& what) const
{
  const std::optional<std::uint64_t> left = bytes_left();
  if (m_size && m_gzip) {
    const std::uint64_t most = Gzip_decoder::maximum_bytes_of(*m_size);
    if (count > most / row_size)
      refuse(std::to_string(count) + " " + what
             + " are announced, but the compressed file has room for no more than "
             + std::to_string(most) + " bytes");
  }
  if (left && count > *left / row_size)
    refuse(std::to_string(count) + " " + what + " are announced, but only " + std::to_string(*left)
           + " bytes are left");
}

std::string Input_file::where() const
{
  return m_path
         + (m_in_text ? ": line " + std::to_string(m_line)
                      : ": byte " + std::to_string(m_position));
}

void Input_file::refuse(const std::string& what) const
{
  throw Failure(INPUT_REFUSED, where() + ": " + what);
}

} // namespace l0_tool
