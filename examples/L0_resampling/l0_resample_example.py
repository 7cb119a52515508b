# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [example]
import cgal_l0, numpy
points = numpy.loadtxt("scan.xyz")   # an array of shape (n, 3), float32 or float64
positions, normals = cgal_l0.l0_resample_point_set(points, number_of_output_points=20000)
# [example]
