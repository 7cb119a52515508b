// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_NPY_HEADER_H
#define L0_RESAMPLE_NPY_HEADER_H

#include "files/Input_file.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace l0_tool {

/// Of a record: numbers of one type, one after the other.
struct Npy_field
{
  std::string name, parent; ///< the parent if it is one of a record within the record
  std::string type;         ///< as NumPy has it, such as "<f4"
  std::uint64_t count;
};

struct Npy_header
{
  std::optional<std::vector<Npy_field>> fields; ///< one without a name of a plain array
  bool has_records = false;
  std::optional<bool> is_column_by_column;
  std::optional<std::vector<std::uint64_t>> shape;
};

/// Reads to the end of the header: at most 1000 fields, and records within records 8 deep.
/// \throws Failure with what is at fault
Npy_header read_npy_header(Input_file& file);

} // namespace l0_tool

#endif // L0_RESAMPLE_NPY_HEADER_H
