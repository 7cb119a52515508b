// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_DEVICE_ARRAYS_H
#define CGAL_L0_PYTHON_DEVICE_ARRAYS_H

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace l0_python {

/// An array of the caller in the memory of a CUDA device, and what keeps it alive.
struct Device_view
{
  pybind11::object owner;
  const char* data = nullptr;
  std::vector<std::int64_t> shape, strides; // strides in bytes
  std::string dtype;                        // as NumPy names it
  int device = 0;
  std::int64_t stream = -1; ///< after whose present work the array is there; negative for none

  std::size_t size() const { return std::size_t(shape[0]); }
};

/// Memory of a CUDA device, given back with its last owner.
class Device_memory
{
  int m_device;
  void* m_data;

public:
  Device_memory(int device, void* data) : m_device(device), m_data(data) {}
  Device_memory(const Device_memory&) = delete;
  Device_memory& operator=(const Device_memory&) = delete;
  ~Device_memory();

  int device() const { return m_device; }
  void* data() const { return m_data; }
};

/// An array of a result, in the order of C.
struct Device_array
{
  std::shared_ptr<Device_memory> memory;
  std::vector<std::int64_t> shape;
  char kind = 'f'; ///< as NumPy has it: 'f' or 'i'
  int item_size = 4;

  std::size_t bytes() const
  {
    std::size_t product = std::size_t(item_size);
    for (const std::int64_t extent : shape)
      product *= std::size_t(extent);
    return product;
  }
};

/// Adds arrays on CUDA devices, and the function that resamples them there, to the module.
void bind_device_arrays(pybind11::module_& module);

} // namespace l0_python

#endif // CGAL_L0_PYTHON_DEVICE_ARRAYS_H
