# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [pyvista]
import cgal_l0
import pyvista

scan = pyvista.read("scan.ply")
positions, normals = cgal_l0.l0_resample_point_set(scan.points)

clean = pyvista.PolyData(positions)
clean.point_data["Normals"] = normals
clean.save("clean.vtk")   # and clean.plot() shows the points
# [pyvista]
