// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_TILE_ROWS_H
#define L0_RESAMPLE_TILE_ROWS_H

#include "formats/Point_rows.h"
#include "tiles/Task_file.h"

#include <CGAL/L0_resampling/Tile_stitching.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

using CGAL::L0_resampling::Tile_sample;

/// A sample that is on a crease, or was moved away from one.
struct Moved_sample
{
  std::uint64_t place; ///< among the samples of its tile
  std::array<double, 3> position;
  std::array<float, 3> normal; ///< on its side
  std::uint32_t mark;          ///< as `marks_of_creases()`
};

Oriented_point oriented_point(const Moved_sample& sample);

/// Those of the samples of results that have these, with marks of creases.
Property_table with_marks(Property_table properties);

/// The samples of some tiles with their properties, which are read from files, a few at a time.
class Tile_rows : public Point_rows
{
  struct Part
  {
    std::string path, path_of_properties;
    std::vector<signed char> signs;  // of its trees
    std::vector<Moved_sample> moved; // by their places
    std::size_t end;                 // the number of rows up to the last one of this part
  };

  static constexpr std::size_t rows_at_once = 4096;

  std::uint64_t m_key;
  std::vector<Part> m_parts;
  std::size_t m_carried_size;     // of a row of a file
  Property_table m_properties;    // without rows
  std::optional<Property> m_mark; // of these

  /// Rows of one of the files of a part.
  template <typename Value>
  struct Window
  {
    std::size_t part = 0; ///< that is open
    std::unique_ptr<Task_file> file;
    std::vector<Value> values; ///< of the rows from `first` on
    std::size_t first = 0, end = 0;
  };

  // What was read last, for one thread as `Point_rows` says
  mutable Window<Tile_sample> m_samples;
  mutable Window<char> m_rows;
  mutable Point m_point;
  mutable std::vector<char> m_row; // if there are marks

  /// Moves the window to row i and what follows, unless it has it.
  /// \param per_row values of each row
  template <typename Value>
  void move(Window<Value>& window, std::string Part::*path, std::size_t i,
            std::size_t per_row) const;
  const Tile_sample& sample(std::size_t i) const;
  /// \returns null if creases leave it where it is
  const Moved_sample* moved(std::size_t i) const;
  std::size_t begin_of(std::size_t part) const { return part == 0 ? 0 : m_parts[part - 1].end; }

public:
  /// \param key of the run
  /// \param carried the properties of the samples, without rows
  /// \param has_marks whether there are marks of creases as well
  Tile_rows(std::uint64_t key, const Property_table& carried, bool has_marks);

  /// \param path of what a tile has found: a file that begins with its samples
  /// \param path_of_properties of the rows of these, if there are properties
  /// \param moved by their places
  void add(const std::string& path, const std::string& path_of_properties,
           const std::vector<signed char>& signs, std::size_t size,
           std::vector<Moved_sample> moved);

  std::size_t size() const override { return m_parts.empty() ? 0 : m_parts.back().end; }
  const Point& point(std::size_t i) const override;
  Vector normal(std::size_t i) const override;
  const Property_table& properties() const override { return m_properties; }
  const char* property_row(std::size_t i) const override;
};

} // namespace l0_tool

#endif // L0_RESAMPLE_TILE_ROWS_H
