// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_ARRAYS_H
#define CGAL_L0_PYTHON_ARRAYS_H

#include "Array_view.h"

#include <pybind11/numpy.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace l0_python {

/// \param array of the shape (n, 3) and of `float` or `double`, which the Python part of the
/// package sees to
inline Array_view view_of(const pybind11::array& array)
{
  Array_view view;
  view.data = static_cast<const char*>(array.data());
  view.row_stride = array.strides(0);
  view.column_stride = array.strides(1);
  view.size = std::size_t(array.shape(0));
  view.is_double = array.itemsize() == sizeof(double);
  return view;
}

/// A capsule that owns the object and deletes it.
/// \returns the capsule, and where the object is now
template <typename T>
std::pair<pybind11::capsule, T*> owned_by_python(T&& object)
{
  auto owned = std::make_unique<T>(std::move(object));
  T* const address = owned.get();
  const pybind11::capsule owner(address, [](void* pointer) { delete static_cast<T*>(pointer); });
  static_cast<void>(owned.release()); // to the capsule
  return {owner, address};
}

/// An array of that many columns that takes the numbers over; of one dimension if there is one
/// column.
template <typename T>
pybind11::array_t<T> array_of(std::vector<T>&& numbers, pybind11::ssize_t columns)
{
  const auto [owner, vector] = owned_by_python(std::move(numbers));
  std::vector<pybind11::ssize_t> shape = {pybind11::ssize_t(vector->size()) / columns};
  if (columns > 1)
    shape.push_back(columns);
  return pybind11::array_t<T>(shape, vector->data(), owner);
}

} // namespace l0_python

#endif // CGAL_L0_PYTHON_ARRAYS_H
