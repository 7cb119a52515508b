// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_POINT_COLLECTOR_H
#define L0_RESAMPLE_POINT_COLLECTOR_H

#include "basis/Point_cloud.h"
#include "files/Input_file.h"
#include "formats/Point_filter.h"
#include "formats/Property_values.h"
#include "formats/read_points.h"

#include <CGAL/Bbox_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace l0_tool {

/// x, y, z and, where the file has them, nx, ny, nz.
using Point_row = std::array<double, 6>;

/// What three numbers of a row that may be a normal are.
enum class Vectors
{
  UNNAMED,         ///< of columns without names
  NAMED_BY_FILE,   ///< said to be normals
  NAMED_BY_CALLER, ///< the same, and not to be questioned
};

inline double length_of(const Vector& vector)
{
  return std::hypot(vector.x(), vector.y(), vector.z());
}

/// Whether a vector of this length is a unit vector, but for roundings in texts.
bool is_unit_length(double length);

/// Takes the points that a reader finds and keeps the limits of `Read_options`.
class Point_collector
{
  const Input_file& m_file;
  Read_options m_options;
  Point_filter m_filter;
  std::optional<Vectors> m_vectors; // that come with the rows
  bool m_is_organized = false;
  std::uint64_t m_number_of_unit_vectors = 0;
  std::uint64_t m_number_of_other_vectors = 0;   // that are not 0
  std::uint64_t m_number_of_missing_vectors = 0; // that are not finite
  std::array<bool, 3> m_has_axes = {};           // whether a unit vector is x, y or z
  bool m_has_directions = false;                 // or another one
  std::uint64_t m_number_of_rows = 0;
  std::uint64_t m_buffer_size = 0;
  std::vector<std::uint64_t> m_missing_rows; // of which no point was kept, if normals come behind
  bool m_are_normals_behind = false;
  std::vector<char> m_next_properties; // of the next row
  Property_values m_values;
  CGAL::Bbox_3 m_box;                        // of the points
  std::optional<bool> m_is_single_precision; // of what `set_type_in_row()` has told
  std::array<bool, 3> m_are_wide = {};       // whether x, y, z are integers of 64 bits
  Point_cloud m_cloud;

  [[noreturn]] void refuse_memory() const;
  void check_limits(std::uint64_t number_of_points) const;
  void warn_of_rounding();
  void choose_types();
  void leave_out();
  void look_at_direction(const Vector& vector);
  bool look_like_colors() const;
  void check_vectors();
  void check_viewpoint();
  void warn_of_degrees();

public:
  Point_collector(const Input_file& file, const Read_options& options)
    : m_file(file), m_options(options), m_filter(options)
  {}

  /// Says that from the first row on there are three numbers that may be a normal. They are normals
  /// if at least 95 % of these vectors, not counting those that are 0 or NaN, have length 1 within
  /// 1 %, or if the caller says so; but not those of columns without names that are colors of 0 and
  /// 1, see `look_like_colors()`.
  void set_vectors(Vectors vectors) { m_vectors = vectors; }

  /// Says that the normals of all rows come behind the last row, by `set_normals()`.
  void set_normals_behind() { m_are_normals_behind = true; }

  /// Looks at the length of a vector that is to be one of the normals.
  /// \returns it with length 1, unless it is 0 or not finite, or has that length within 1 %
  Vector unit_vector(const Vector& vector);

  /// \param normals one for each row, or none if the caller does not want them
  void set_normals(std::vector<Vector>&& normals);

  bool wants_normals() const { return m_options.with_normals; }

  /// Says of which type a number of all rows is in the file; of texts nobody says it.
  /// \param index of the number in a row
  /// \param type nothing for integers of 64 bits
  void set_type_in_row(std::size_t index, std::optional<Number_type> type);

  void set_viewpoint(const std::array<double, 3>& viewpoint) { m_cloud.viewpoint = viewpoint; }

  /// Says that the points are an image, for messages.
  void set_organized() { m_is_organized = true; }

  /// Says what tells that x and y are degrees.
  /// \throws Failure if the options refuse these
  void set_degrees(const std::string& reason);

  /// Says that the columns behind the third, or the one so named, have no names.
  /// \param hint what a refusal says beside how to name them
  /// \throws Failure if the options refuse these
  void leave_out_rest(const std::string& last, const std::string& hint = "");

  bool wants_properties() const { return m_options.with_properties; }

  bool has_decimal_commas() const { return m_options.has_decimal_commas; }

  const std::string& how_to_name_columns() const { return m_options.how_to_name_columns; }

  bool wants_wide_colors() const { return m_options.with_wide_colors; }

  /// Says that each row has this one too. Only if they are wanted, and before the first row.
  /// \param type nothing if the values have to tell, as those of texts and integers of 64 bits:
  ///        then rows have doubles
  /// \returns its index
  std::size_t add_property(const std::string& name, std::optional<Number_type> type);

  std::size_t number_of_properties() const { return m_cloud.properties.properties().size(); }

  /// Where the next row's value of a property goes, before `add()`.
  char* property(std::size_t index)
  {
    return m_next_properties.data() + m_cloud.properties.properties()[index].offset;
  }

  /// The same for a number of any type.
  void set(std::size_t index, double value)
  {
    encode(value, m_cloud.properties.properties()[index].type, property(index));
  }

  /// The same for a number in a file, of a type that is read and that the property has been added
  /// with.
  void set(std::size_t index, const Type_in_file& type, const char* bytes, bool swap)
  {
    if (type.wide)
      set(index, type.wide->decode(bytes, swap));
    else
      copy_number(bytes, *type.number, swap, property(index));
  }

  /// The same for a word of a text.
  /// \returns whether it is a number of the type
  bool set(std::size_t index, const Type_in_file& type, std::string_view word);

  /// Makes room for `count` points, each of at least `row_size` bytes in the file.
  /// \throws Failure if the file cannot hold them, or the limits forbid them
  void announce(std::uint64_t count, std::uint64_t row_size);

  /// Says that the reader will hold all of `count` points in a buffer of so many bytes.
  /// \throws Failure if the limits forbid that
  void announce_buffer(std::uint64_t count, std::uint64_t buffer_size);

  /// Says of how many bytes the buffer of the reader is by now.
  void set_buffer_size(std::uint64_t size);

  /// Makes room for `count` points, which the file is known to hold.
  void reserve(std::uint64_t count);

  void add(const Point_row& row);

  void warn(const std::string& what) { m_cloud.warnings.push_back(m_file.path() + ": " + what); }

  void note(const std::string& what) { m_cloud.notes.push_back(m_file.path() + ": " + what); }

  void set_las_origin(const Las_origin& origin) { m_cloud.las = origin; }

  void set_las_colors(Las_colors colors) { m_cloud.las_colors = colors; }

  std::uint64_t number_of_rows() const { return m_number_of_rows; }

  /// After the last row; see `Property_table::narrow()`.
  void set_types(const std::vector<Number_type>& types, const std::vector<unsigned>& shifts = {});

  const std::vector<Property>& properties() const { return m_cloud.properties.properties(); }

  /// Of the points so far.
  const CGAL::Bbox_3& box() const { return m_box; }

  Point_cloud take();
};

} // namespace l0_tool

#endif // L0_RESAMPLE_POINT_COLLECTOR_H
