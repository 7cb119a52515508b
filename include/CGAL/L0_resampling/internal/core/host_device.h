// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_HOST_DEVICE_H
#define CGAL_L0_RESAMPLING_INTERNAL_HOST_DEVICE_H

// Marks a formula that the CPU stages and the CUDA kernels share.
#ifdef __CUDACC__
#define CGAL_L0_HOST_DEVICE __host__ __device__
#else
#define CGAL_L0_HOST_DEVICE
#endif

#endif // CGAL_L0_RESAMPLING_INTERNAL_HOST_DEVICE_H
