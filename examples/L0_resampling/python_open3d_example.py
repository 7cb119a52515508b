# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [open3d]
import cgal_l0
import numpy
import open3d

scan = open3d.io.read_point_cloud("scan.ply")
positions, normals = cgal_l0.l0_resample_point_set(numpy.asarray(scan.points))

clean = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(positions))
clean.normals = open3d.utility.Vector3dVector(normals)
mesh, densities = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(clean, depth=7)
open3d.io.write_triangle_mesh("mesh.ply", mesh)
# [open3d]
