// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_RESAMPLE_ON_DEVICE_H
#define CGAL_L0_PYTHON_RESAMPLE_ON_DEVICE_H

#include "device_arrays.h"
#include "resample.h"

#include <cstdint>

namespace l0_python {

/*!
Resamples points that are in the memory of a CUDA device. Points and result are not copied to the
host, but for
- source indices, for which points and positions are, as these are searched for on the host;
- feature confidences, for which the result is;
- results that coincide after rounding to the number type of the points, which are separated on the
host.

\param points, normals, orientation_hints, viewpoints of one size, of shape (n, 3), of `float` or
`double` and on one device, which the Python part of the package sees to; all but the first may be
null

\returns positions, normals, source indices or None, feature confidences or None, and the report; or
None, if the callback cancelled
\throws what the function throws; `Device_error` if the module was built without CUDA
*/
pybind11::object resample_on_device(const Device_view& points, const Device_view* normals,
                                    const Device_view* orientation_hints,
                                    const Device_view* viewpoints, const Parameters& parameters,
                                    const pybind11::object& callback);

/// The number of the device that memory belongs to; 0 if that is not known.
int device_of_pointer(std::uintptr_t pointer);

void copy_to_host(const Device_array& array, void* target);

} // namespace l0_python

#endif // CGAL_L0_PYTHON_RESAMPLE_ON_DEVICE_H
