// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEST_ATTACK_READER_H
#define L0_RESAMPLE_TEST_ATTACK_READER_H

#include "basis/Failure.h"
#include "formats/read_points.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace tool_test {

/// A file that exists in memory alone, since a disk would be what limits the number of attacks.
class Memory_file
{
  int m_descriptor = memfd_create("points", MFD_CLOEXEC);

public:
  Memory_file() = default;
  ~Memory_file() { close(m_descriptor); }
  Memory_file(const Memory_file&) = delete;
  Memory_file& operator=(const Memory_file&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

  void set_bytes(const std::uint8_t* bytes, std::size_t size)
  {
    if (ftruncate(m_descriptor, 0) != 0 || pwrite(m_descriptor, bytes, size, 0) != ssize_t(size))
      std::abort();
  }
};

inline void require(bool holds, const char* what)
{
  if (holds)
    return;
  std::cerr << "failed: " << what << std::endl;
  std::abort();
}

/// Of a refusal or a warning: one line that names the file, and nothing that a terminal would obey.
inline void require_message(const std::string& message, const std::string& path)
{
  require(message.compare(0, path.size(), path) == 0, "the message begins with the file");
  for (const char c : message)
    require(static_cast<unsigned char>(c) >= ' ' && c != '\x7f',
            "no control character is in the message");
}

/// Reads the bytes as a file of that format. They are either refused, with a line that names the
/// file, or give points that can be used, no more of them than bytes; else the program ends.
inline void attack_reader(l0_tool::File_format format, const std::uint8_t* bytes, std::size_t size)
{
  static Memory_file file;
  file.set_bytes(bytes, size);
  // one of the ways, as twice the work an attack would be half the attacks
  const bool is_lenient = size % 2 == 0;
  l0_tool::Read_options options;
  options.drop_non_finite = is_lenient;
  options.with_normals = is_lenient;
  options.with_properties = size / 2 % 2 == 0;
  options.only_first_returns = format == l0_tool::File_format::LAS && options.with_properties
                               && size / 4 % 2 == 0;
  options.with_wide_colors = size / 8 % 2 == 0;
  try
  {
    const l0_tool::Point_cloud cloud = l0_tool::read_points(file.path(), format, options);
    require(cloud.points.size() + cloud.number_of_dropped_points
              <= l0_tool::Gzip_decoder::maximum_bytes_of(size),
            "no more points than bytes, also if these are compressed");
    require(cloud.normals.empty() || cloud.normals.size() == cloud.points.size(),
            "a normal for each point, or none");
    require(is_lenient || cloud.number_of_dropped_points == 0,
            "no point is dropped without a word");
    for (const l0_tool::Point& p : cloud.points)
      require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
              "points are finite");
    require(options.with_properties || cloud.properties.row_size() == 0,
            "only the properties that are wanted");
    for (const l0_tool::Property& property : cloud.properties.properties())
      for (std::size_t i = 0; i < cloud.points.size(); ++i)
        cloud.properties.value(i, property); // AddressSanitizer sees that it is there
    for (const auto* messages : {&cloud.warnings, &cloud.notes})
      for (const std::string& message : *messages)
        require_message(message, file.path());
  }
  catch (const l0_tool::Failure& failure)
  {
    require(failure.status() == l0_tool::INPUT_REFUSED, "the file is refused");
    require_message(failure.what(), file.path());
  }
}

} // namespace tool_test

#endif // L0_RESAMPLE_TEST_ATTACK_READER_H
