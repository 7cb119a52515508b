// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "tiles/Task_file.h"

#include "basis/Failure.h"
#include "basis/signals.h"
#include "system/files_of_system.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>

namespace l0_tool {
namespace {

constexpr std::uint64_t magic = 0x314b534154304cff; // ends in "L0TASK1"

struct Footer
{
  std::uint64_t key, size, checksum, magic_number;
};

} // namespace

void Checksum::add_word(const char* bytes)
{
  std::uint64_t word;
  std::memcpy(&word, bytes, sizeof word);
  m_value = (m_value ^ word) * 0x9e3779b97f4a7c15;
  m_value ^= m_value >> 32;
}

void Checksum::add(std::string_view bytes)
{
  while (m_size_of_rest > 0 && m_size_of_rest < sizeof m_rest && !bytes.empty()) {
    m_rest[m_size_of_rest++] = bytes.front();
    bytes.remove_prefix(1);
  }
  if (m_size_of_rest == sizeof m_rest) {
    add_word(m_rest);
    m_size_of_rest = 0;
  }
  for (; bytes.size() >= sizeof m_rest; bytes.remove_prefix(sizeof m_rest))
    add_word(bytes.data());
  if (!bytes.empty()) {
    std::memcpy(m_rest + m_size_of_rest, bytes.data(), bytes.size());
    m_size_of_rest += bytes.size();
  }
}

std::uint64_t Checksum::value() const
{
  Checksum whole = *this;
  std::memset(whole.m_rest + m_size_of_rest, 0, sizeof m_rest - m_size_of_rest);
  whole.add_word(whole.m_rest);
  return whole.m_value ^ m_size_of_rest;
}

void Task_file_writer::write_bytes(std::string_view bytes)
{
  constexpr std::size_t at_once = std::size_t(1) << 20;
  for (; !bytes.empty(); bytes.remove_prefix((std::min)(at_once, bytes.size()))) {
    const std::string_view next = bytes.substr(0, at_once);
    m_checksum.add(next);
    m_file.write(next);
    m_size += next.size();
  }
}

void Task_file_writer::commit()
{
  const Footer footer = {m_key, m_size, m_checksum.value(), magic};
  m_file.write({reinterpret_cast<const char*>(&footer), sizeof footer});
  m_file.commit();
}

Task_file::Task_file(const std::string& path, std::uint64_t key) : m_path(path)
{
  m_descriptor = open_to_read(path);
  if (m_descriptor < 0)
    fail("cannot be opened: " + std::generic_category().message(errno));
  const std::optional<File_status> status = status_of(m_descriptor);
  Footer footer = {};
  const bool has_footer = status && status->size >= sizeof footer
                          && read_some_at(m_descriptor, status->size - sizeof footer,
                                          reinterpret_cast<char*>(&footer), sizeof footer)
                               == std::ptrdiff_t(sizeof footer);
  if (!has_footer || footer.magic_number != magic || footer.size != status->size - sizeof footer) {
    close_descriptor(m_descriptor);
    fail("is damaged");
  }
  if (footer.key != key) {
    close_descriptor(m_descriptor);
    fail("belongs to another run");
  }
  m_size = footer.size;
  m_checksum = footer.checksum;
}

Task_file::~Task_file() { close_descriptor(m_descriptor); }

void Task_file::fail(const std::string& what) const
{
  throw Failure(RUN_TIME_FAILURE, m_path + ": " + what + "; --resume makes it again");
}

void Task_file::verify() const
{
  std::vector<char> bytes(std::size_t(1) << 20);
  Checksum checksum;
  for (std::uint64_t position = 0; position < m_size;) {
    throw_if_interrupted();
    const std::size_t n = std::size_t((std::min)(std::uint64_t(bytes.size()), m_size - position));
    read_at(position, n, bytes.data());
    checksum.add({bytes.data(), n});
    position += n;
  }
  if (checksum.value() != m_checksum)
    fail("is damaged");
}

void Task_file::read_bytes(std::uint64_t n, char* target)
{
  if (m_position > m_size || n > m_size - m_position)
    fail("is damaged");
  read_at(m_position, n, target);
  m_position += n;
}

void Task_file::read_at(std::uint64_t position, std::uint64_t n, char* target) const
{
  while (n > 0) {
    const std::ptrdiff_t count = read_some_at(m_descriptor, position, target,
                                              std::size_t((std::min)(n, std::uint64_t(1) << 30)));
    if (count < 0 && errno == EINTR)
      continue;
    if (count <= 0)
      fail("cannot be read");
    position += std::uint64_t(count);
    target += count;
    n -= std::uint64_t(count);
  }
}

bool is_task_file(const std::string& path, std::uint64_t key, std::string& reason)
{
  if (!status_of(path))
    return false;
  try {
    Task_file(path, key).verify();
    return true;
  } catch (const Failure& failure) {
    throw_if_interrupted();
    reason = failure.what();
    return false;
  }
}

} // namespace l0_tool
