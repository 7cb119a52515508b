// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_PYTHON_FILES_H
#define CGAL_L0_PYTHON_FILES_H

#include <pybind11/pybind11.h>

namespace l0_python {

/// Adds the readers, the writers and the renderer of the program `l0_resample` to the module.
void bind_files(pybind11::module_& module);

} // namespace l0_python

#endif // CGAL_L0_PYTHON_FILES_H
