// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEST_TOOL_GZIP_H
#define L0_RESAMPLE_TEST_TOOL_GZIP_H

#include <zlib.h>

#include <stdexcept>
#include <string>

namespace tool_test {

/// As the program gzip compresses.
inline std::string gzip(const std::string& bytes)
{
  constexpr int with_gzip_header = 16, most_memory = 9;
  z_stream stream = {};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + with_gzip_header,
                   most_memory, Z_DEFAULT_STRATEGY)
      != Z_OK)
    throw std::runtime_error("no memory to compress");
  std::string compressed(deflateBound(&stream, uLong(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(compressed.data());
  stream.avail_out = uInt(compressed.size());
  const int status = deflate(&stream, Z_FINISH);
  compressed.resize(compressed.size() - stream.avail_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END)
    throw std::runtime_error("not compressed");
  return compressed;
}

} // namespace tool_test

#endif // L0_RESAMPLE_TEST_TOOL_GZIP_H
