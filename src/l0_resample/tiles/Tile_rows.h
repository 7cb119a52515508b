// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILE_ROWS_H
#define L0_RESAMPLE_TILE_ROWS_H

#include "formats/Point_rows.h"
#include "tiles/Task_file.h"

#include <CGAL/L0_resampling/internal/tiles/stitch_tiles.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace l0_tool {

using CGAL::L0_resampling::internal::Tile_sample;

/// The samples of some tiles, which are read from files, a few at a time.
class Tile_rows : public Point_rows
{
  struct Part
  {
    std::string path;
    std::vector<signed char> signs; // of its trees
    std::size_t end;                // the number of rows up to the last one of this part
  };

  static constexpr std::size_t rows_at_once = 4096;

  std::uint64_t m_key;
  std::vector<Part> m_parts;
  Property_table m_no_properties;
  mutable std::size_t m_part = 0; // that is open
  mutable std::unique_ptr<Task_file> m_file;
  mutable std::vector<Tile_sample> m_samples;
  mutable std::size_t m_first = 0; // row of these
  mutable Point m_point;

  const Tile_sample& sample(std::size_t i) const;

public:
  /// \param key of the run
  explicit Tile_rows(std::uint64_t key) : m_key(key) {}

  /// \param path of what a tile has found: a file that begins with its samples
  void add(const std::string& path, const std::vector<signed char>& signs, std::size_t size);

  std::size_t size() const override { return m_parts.empty() ? 0 : m_parts.back().end; }
  const Point& point(std::size_t i) const override;
  Vector normal(std::size_t i) const override;
  const Property_table& properties() const override { return m_no_properties; }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_TILE_ROWS_H
