// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgL0ResamplingConcepts

What `CGAL::L0_resampling::write_tile_value()` writes to and
`CGAL::L0_resampling::read_tile_value()` reads from, in the same order: a file, say. A class may
have the functions for one of both only.

Types `T` are `bool`, or plain as `CGAL::L0_resampling::Is_plain` says.

\cgalConcept
*/
class L0ResamplingTileArchive
{
public:
  /// Writes a value.
  template <typename T>
  void write(const T& value);

  /// Writes values, and how many they are.
  template <typename T, typename Allocator>
  void write_all(const std::vector<T, Allocator>& values);

  /// Reads a value.
  template <typename T>
  T read();

  /// Reads values.
  template <typename T, typename Allocator>
  void read_all(std::vector<T, Allocator>& values);
};
