// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats/write_points.h"

#include "basis/Failure.h"
#include "basis/Number_type.h"
#include "formats/Las_layout.h"
#include "formats/Output_columns.h"
#include "formats/Point_rows.h"
#include "formats/write_las.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>

namespace l0_tool {
namespace {

using Row = std::array<double, 6>;

constexpr std::array<double, 3> origin = {};
constexpr std::size_t longest_number = 24; // "-2.2250738585072014e-308"

/// What stands in a row of a file.
struct Layout
{
  bool has_normals;
  bool is_single; ///< coordinates and normals, that is
  std::vector<Output_column> others;
  std::array<double, 3> viewpoint; ///< in PCD, where the origin says that nobody knows

  std::size_t number_of_coordinates() const { return has_normals ? 6 : 3; }
};

Row row_of(const Point_rows& rows, std::size_t i)
{
  const Point& point = rows.point(i);
  const Vector normal = rows.normal(i);
  return {point.x(), point.y(), point.z(), normal.x(), normal.y(), normal.z()};
}

/// Appends the shortest text that reads as the same number.
template <typename Number>
void append_number(Number number, std::string& text)
{
  std::array<char, longest_number> digits;
  text.append(digits.data(),
              std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

/// Other columns are numbers of one byte, as OFF has them.
void append_text(const Row& row, const char* properties, const Layout& layout, std::string& text)
{
  const auto append = [&](auto number) {
    append_number(number, text);
    text += ' ';
  };
  for (std::size_t k = 0; k < layout.number_of_coordinates(); ++k)
    if (layout.is_single)
      append(float(row[k]));
    else
      append(row[k]);
  for (const Output_column& column : layout.others)
    append(unsigned(static_cast<unsigned char>(properties[column.bytes.front()])));
  text.back() = '\n';
}

void append_binary(const Row& row, const char* properties, const Layout& layout, std::string& bytes)
{
  for (std::size_t k = 0; k < layout.number_of_coordinates(); ++k)
    if (layout.is_single)
      append_little_endian<std::uint32_t>(float(row[k]), bytes);
    else
      append_little_endian<std::uint64_t>(row[k], bytes);
  for (const Output_column& column : layout.others)
    for (const std::size_t byte : column.bytes)
      bytes += byte == Output_column::zero ? '\0' : properties[byte];
}

/// Whether `float` holds the points to a millionth of their diagonal: not if they lie far from the
/// origin, or beyond its range.
bool is_single_precision_enough(const Point_rows& rows)
{
  constexpr double share = 1e-6;
  double largest = 0, squared_diagonal = 0;
  for (int axis = 0; axis < 3 && rows.size() > 0; ++axis) {
    double low = rows.point(0)[axis], high = low;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      low = (std::min)(low, rows.point(i)[axis]);
      high = (std::max)(high, rows.point(i)[axis]);
    }
    largest = (std::max)({largest, std::abs(low), std::abs(high)});
    squared_diagonal += (high - low) * (high - low);
  }
  using Limits = std::numeric_limits<float>;
  const double rounding = (std::max)(largest * double(Limits::epsilon()) / 2,
                                     double(Limits::denorm_min()));
  return largest < double((Limits::max)()) && rounding <= share * std::sqrt(squared_diagonal);
}

std::string ply_name(Number_type type)
{
  switch (type) {
  case Number_type::INT8: return "char";
  case Number_type::UINT8: return "uchar";
  case Number_type::INT16: return "short";
  case Number_type::UINT16: return "ushort";
  case Number_type::INT32: return "int";
  case Number_type::UINT32: return "uint";
  case Number_type::FLOAT32: return "float";
  case Number_type::FLOAT64: break;
  }
  return "double";
}

char pcd_letter(Number_type type)
{
  switch (type) {
  case Number_type::INT8:
  case Number_type::INT16:
  case Number_type::INT32: return 'I';
  case Number_type::UINT8:
  case Number_type::UINT16:
  case Number_type::UINT32: return 'U';
  case Number_type::FLOAT32:
  case Number_type::FLOAT64: break;
  }
  return 'F';
}

/// Coordinates, normals and others, by the names that the format has for the first six.
std::vector<Output_column> all_columns(const Layout& layout,
                                       const std::array<const char*, 6>& names)
{
  std::vector<Output_column> columns;
  for (std::size_t k = 0; k < layout.number_of_coordinates(); ++k)
    columns.push_back(
      {names[k], layout.is_single ? Number_type::FLOAT32 : Number_type::FLOAT64, {}});
  columns.insert(columns.end(), layout.others.begin(), layout.others.end());
  return columns;
}

std::string ply_header(std::size_t number_of_points, const Layout& layout)
{
  std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex "
                     + std::to_string(number_of_points) + "\n";
  for (const Output_column& column : all_columns(layout, {"x", "y", "z", "nx", "ny", "nz"}))
    text += "property " + ply_name(column.type) + " " + column.name + "\n";
  return text + "end_header\n";
}

std::string pcd_header(std::size_t number_of_points, const Layout& layout)
{
  std::string fields = "FIELDS", sizes = "\nSIZE", types = "\nTYPE", counts = "\nCOUNT";
  for (const Output_column& column :
       all_columns(layout, {"x", "y", "z", "normal_x", "normal_y", "normal_z"})) {
    fields += " " + column.name;
    sizes += " " + std::to_string(size_of(column.type));
    types += std::string(" ") + pcd_letter(column.type);
    counts += " 1";
  }
  std::string viewpoint;
  for (const double coordinate : layout.viewpoint) {
    append_number(coordinate, viewpoint);
    viewpoint += ' ';
  }
  const std::string n = std::to_string(number_of_points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + sizes + types
         + counts + "\nWIDTH " + n + "\nHEIGHT 1\nVIEWPOINT " + viewpoint + "1 0 0 0\nPOINTS " + n
         + "\nDATA binary\n";
}

std::string off_header(std::size_t number_of_points, const Layout& layout)
{
  return std::string(layout.others.empty() ? "" : "C") + (layout.has_normals ? "N" : "") + "OFF\n"
         + std::to_string(number_of_points) + " 0 0\n";
}

std::string npy_header(std::size_t number_of_points, const Layout& layout)
{
  std::string text = std::string("{'descr': '") + (layout.is_single ? "<f4" : "<f8")
                     + "', 'fortran_order': False, 'shape': (" + std::to_string(number_of_points)
                     + ", " + std::to_string(layout.number_of_coordinates()) + "), }";
  // The data begins at a multiple of 64 bytes, behind ten bytes of magic and length, the text and a
  // line end.
  text.append(63 - (10 + text.size()) % 64, ' ');
  text += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + char(text.size()) + '\0' + text;
}

std::string header_of(File_format format, std::size_t number_of_points, const Layout& layout)
{
  switch (format) {
  case File_format::PLY: return ply_header(number_of_points, layout);
  case File_format::OFF: return off_header(number_of_points, layout);
  case File_format::XYZ: return "";
  case File_format::PCD: return pcd_header(number_of_points, layout);
  case File_format::NPY:
  case File_format::CSV: // which is not written, nor is OBJ
  case File_format::OBJ:
  case File_format::LAS: break; // which has a writer of its own
  }
  return npy_header(number_of_points, layout);
}

bool is_text(File_format format)
{
  return format == File_format::OFF || format == File_format::XYZ;
}

void write_columns(Output_file& file, File_format format, const Point_rows& rows,
                   const Layout& layout)
{
  file.write(header_of(format, rows.size(), layout));
  const auto append_row = is_text(format) ? append_text : append_binary;
  std::string bytes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    bytes.clear();
    append_row(row_of(rows, i), rows.property_row(i), layout, bytes);
    file.write(bytes);
  }
}

/// \param layout without its other columns, which the format chooses
/// \returns the names of the properties that the format cannot hold
std::vector<std::string> write_rows(const std::string& path, File_format format,
                                    const Point_rows& rows, Layout layout,
                                    const std::optional<Las_origin>& las, Existing_file existing)
{
  const std::string reason = reason_against_output(path, format);
  if (!reason.empty())
    throw Failure(OUTPUT_NOT_WRITTEN, reason);
  if (format == File_format::LAS) {
    Output_file file(path, existing);
    const std::vector<std::string> left_out = write_las(file, path, rows, layout.has_normals, las);
    file.commit();
    return left_out;
  }
  const Output_columns chosen = choose_columns(rows.properties(), format, layout.has_normals);
  layout.others = chosen.columns;
  if (format == File_format::PCD)
    layout.is_single = layout.is_single || is_single_precision_enough(rows);
  Output_file file(path, existing);
  write_columns(file, format, rows, layout);
  file.commit();
  return chosen.left_out;
}

} // namespace

void write_points(const std::string& path, File_format format,
                  const std::vector<Oriented_point>& points, Existing_file existing)
{
  write_rows(path, format, Oriented_rows(points, {}), {true, false, {}, origin}, {}, existing);
}

std::vector<std::string> write_point_rows(const std::string& path, File_format format,
                                          const Point_rows& rows,
                                          const std::optional<Las_origin>& las,
                                          const std::optional<std::array<double, 3>>& viewpoint,
                                          Existing_file existing)
{
  return write_rows(path, format, rows, {true, false, {}, viewpoint.value_or(origin)}, las,
                    existing);
}

std::vector<std::string> write_points(const std::string& path, File_format format,
                                      const Resampled_points& result, Existing_file existing)
{
  return write_rows(path, format, Oriented_rows(result.points, result.properties),
                    {true, false, {}, result.viewpoint.value_or(origin)}, result.las, existing);
}

std::vector<std::string> write_point_cloud(const std::string& path, File_format format,
                                           const Point_cloud& cloud, Existing_file existing)
{
  return write_rows(path, format, Cloud_rows(cloud),
                    {!cloud.normals.empty(),
                     cloud.coordinate_type == Number_type::FLOAT32,
                     {},
                     cloud.viewpoint.value_or(origin)},
                    cloud.las, existing);
}

std::vector<std::string> properties_left_out(File_format format, const Property_table& properties,
                                             const std::optional<Las_origin>& las)
{
  if (format == File_format::LAS)
    return choose_las_layout(Oriented_rows({}, properties), true, las).left_out;
  return choose_columns(properties, format, true).left_out;
}

std::uint64_t maximum_file_size(File_format format, std::uint64_t number_of_points,
                                const Property_table& properties,
                                const std::optional<Las_origin>& las)
{
  if (format == File_format::LAS)
    return maximum_las_size(number_of_points, properties, las);
  std::uint64_t header_size = 1024;
  for (const Property& property : properties.properties())
    header_size += property.name.size() + 32;
  // In text, of properties only four channels of a color, each of three digits and a blank
  const std::uint64_t row_size = is_text(format) ? 6 * (longest_number + 1) + 4 * 4
                                                 : sizeof(Row) + properties.row_size();
  return header_size + number_of_points * row_size;
}

} // namespace l0_tool
