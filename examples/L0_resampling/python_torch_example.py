# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [torch]
import cgal_l0
import torch

scan = torch.from_numpy(cgal_l0.read_points("scan.ply").points)
if torch.cuda.is_available():
    points = scan.cuda()
    result = cgal_l0.l0_resample_point_set(points)   # on the device
    positions, normals = map(torch.from_dlpack, result)
else:
    positions, normals = map(torch.from_numpy, cgal_l0.l0_resample_point_set(scan))
print(positions.device, positions.shape)
# [torch]
