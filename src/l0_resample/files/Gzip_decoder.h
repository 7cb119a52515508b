// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_GZIP_DECODER_H
#define L0_RESAMPLE_GZIP_DECODER_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace l0_tool {

/// Decompresses what gzip has made, members one behind the other included.
class Gzip_decoder
{
public:
  /// Writes up to so many bytes and returns their number, 0 at the end.
  using Source = std::function<std::size_t(char*, std::size_t)>;

  /// Whether a file that begins with these bytes is compressed.
  static bool is_begin(std::string_view bytes) { return bytes.substr(0, 2) == "\x1f\x8b"; }

  /// The most bytes that so many compressed ones may stand for: more than those of points do, and
  /// less than gzip can. It keeps a small file from filling the memory.
  static std::uint64_t maximum_bytes_of(std::uint64_t compressed_bytes);

  /// \param name of the file, for messages
  /// \param begin what was read of it already
  Gzip_decoder(const std::string& name, std::string_view begin, Source source);
  ~Gzip_decoder();

  /// As a `Source`.
  /// \throws Failure with INPUT_REFUSED where the data are damaged, end early or stand for too much
  std::size_t read(char* target, std::size_t n);

  /// So far.
  std::uint64_t compressed_bytes() const { return m_compressed_bytes; }

private:
  struct Stream;

  bool has_input();
  [[noreturn]] void refuse(const std::string& what) const;

  std::string m_name;
  Source m_source;
  std::string m_input;
  std::unique_ptr<Stream> m_stream;
  bool m_is_within_member = true;
  std::uint64_t m_compressed_bytes = 0;
  std::uint64_t m_bytes = 0;
};

} // namespace l0_tool

#endif // L0_RESAMPLE_GZIP_DECODER_H
