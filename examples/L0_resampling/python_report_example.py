# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [report]
import cgal_l0

scan = cgal_l0.read_points("scan.ply")
positions, normals, report = cgal_l0.l0_resample_point_set(scan.points, report=True)
print("spacing", report.estimated_spacing, "noise", report.estimated_noise)
print(report.number_of_outliers, "outliers left out")
print(f"{report.oriented_share:.0%} reliably oriented")
for stage in report.stages:
    print(stage.name, stage.seconds)
# [report]
