// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TEST_TOOL_SUPPORT_H
#define L0_RESAMPLE_TEST_TOOL_SUPPORT_H

#include "basis/Failure.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>

namespace tool_test {

/// A new, empty folder that is gone at the end.
class Scratch_folder
{
  std::filesystem::path m_path;

public:
  Scratch_folder()
  {
    std::random_device random;
    do
      m_path = std::filesystem::temp_directory_path()
               / ("l0_resample_test_" + std::to_string(random()));
    while (!std::filesystem::create_directory(m_path));
  }

  ~Scratch_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  Scratch_folder(const Scratch_folder&) = delete;
  Scratch_folder& operator=(const Scratch_folder&) = delete;

  std::string file(const std::string& name) const { return (m_path / name).string(); }

  std::size_t number_of_files() const
  {
    return std::size_t(std::distance(std::filesystem::directory_iterator(m_path),
                                     std::filesystem::directory_iterator()));
  }
};

inline void write_bytes(const std::string& path, const std::string& bytes)
{
  // Some file systems wait for the disk where a file is cut to nothing and written again.
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary) << bytes;
}

inline std::string read_bytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The exit status and the message of the Failure that `function` throws; status 0 if it throws
/// none.
struct Failure_seen
{
  int status = 0;
  std::string message;

  bool says(const std::string& part) const { return message.find(part) != std::string::npos; }
};

inline Failure_seen failure_of(const std::function<void()>& function)
{
  try
  {
    function();
  }
  catch (const l0_tool::Failure& failure)
  {
    return {failure.status(), failure.what()};
  }
  return {};
}

inline bool is_big_endian_machine()
{
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

template <typename T>
std::string bytes_of(T value, bool big_endian)
{
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return big_endian == is_big_endian_machine() ? bytes : std::string(bytes.rbegin(), bytes.rend());
}

inline std::string ply_header(const std::string& format, const std::string& elements)
{
  return "ply\nformat " + format + " 1.0\ncomment made for a test\n" + elements + "end_header\n";
}

/// Of a PCD file with fields x, y, z and maybe more.
inline std::string pcd_header(const std::string& more_fields, const std::string& sizes,
                              const std::string& types, const std::string& number_of_points,
                              const std::string& data)
{
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z" + more_fields
         + "\nSIZE " + sizes + "\nTYPE " + types + "\nWIDTH " + number_of_points
         + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number_of_points + "\nDATA " + data
         + "\n";
}

/// The data of a PCD file of the kind `binary_compressed`.
inline std::string pcd_block(std::uint32_t size, const std::string& compressed)
{
  return bytes_of(std::uint32_t(compressed.size()), false) + bytes_of(size, false) + compressed;
}

/// An NPY file of version 1 with the text as its header.
inline std::string npy_file(const std::string& header, const std::string& body = "")
{
  return std::string("\x93NUMPY\x01\x00", 8) + bytes_of(std::uint16_t(header.size()), false)
         + header + body;
}

inline std::string npy_header(const std::string& type, const std::string& shape)
{
  return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }\n";
}

const std::string float_xyz = "property float x\nproperty float y\nproperty float z\n";

/// The coordinates of the point (1, 2, 3) in binary.
const std::string three_floats = bytes_of(1.f, false) + bytes_of(2.f, false) + bytes_of(3.f, false);

} // namespace tool_test

#endif // L0_RESAMPLE_TEST_TOOL_SUPPORT_H
