// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// For tests that read many small files: what is to be in a file is handed over as bytes.

#ifndef L0_RESAMPLE_TEST_TOOL_READING_H
#define L0_RESAMPLE_TEST_TOOL_READING_H

#include "tool/test_tool_support.h"

#include "formats/read_points.h"

#include <zlib.h>

#include <stdexcept>
#include <string>

namespace tool_test {

/// Of the files of a program.
inline const Scratch_folder scratch;

/// Writes `bytes` into a file and reads them as points.
inline l0_tool::Point_cloud read(const std::string& extension, const std::string& bytes,
                                 const l0_tool::Read_options& options = {})
{
  const std::string path = scratch.file("points" + extension);
  write_bytes(path, bytes);
  return l0_tool::read_points(path, *l0_tool::format_of(path), options);
}

/// Why `read()` refuses them.
inline Failure_seen refusal(const std::string& extension, const std::string& bytes,
                            const l0_tool::Read_options& options = {})
{
  return failure_of([&]() { read(extension, bytes, options); });
}

inline l0_tool::Read_options with_normals()
{
  l0_tool::Read_options options;
  options.with_normals = true;
  return options;
}

inline l0_tool::Read_options with_everything()
{
  l0_tool::Read_options options = with_normals();
  options.with_properties = true;
  return options;
}

/// As the program gzip compresses.
inline std::string gzip(const std::string& bytes)
{
  constexpr int with_gzip_header = 16, maximum_memory_level = 9;
  z_stream stream = {};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + with_gzip_header,
                   maximum_memory_level, Z_DEFAULT_STRATEGY)
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

#endif // L0_RESAMPLE_TEST_TOOL_READING_H
