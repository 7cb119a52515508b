// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_DLPACK_H
#define CGAL_L0_PYTHON_DLPACK_H

#include <cstdint>

namespace l0_python {

/// The binary interface of DLPack, by which libraries hand arrays to each other: what a capsule
/// named "dltensor" points to.
namespace dlpack {

struct Device
{
  std::int32_t type;
  std::int32_t id;
};

constexpr std::int32_t cuda = 2, cuda_managed = 13; // types of devices

struct Data_type
{
  std::uint8_t code;
  std::uint8_t bits;
  std::uint16_t lanes;
};

struct Tensor
{
  void* data;
  Device device;
  std::int32_t number_of_dimensions;
  Data_type data_type;
  std::int64_t* shape;
  std::int64_t* strides; // in elements; null for the order of C
  std::uint64_t byte_offset;
};

struct Managed_tensor
{
  Tensor tensor;
  void* context;
  void (*deleter)(Managed_tensor*);
};

constexpr const char* capsule_name = "dltensor";

} // namespace dlpack

} // namespace l0_python

#endif // CGAL_L0_PYTHON_DLPACK_H
