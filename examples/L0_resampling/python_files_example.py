# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [files]
import cgal_l0

scan = cgal_l0.read_points("scan.ply")
with cgal_l0.progress_bar() as callback:
    positions, normals, sources, confidences = cgal_l0.l0_resample_point_set(
        scan.points, callback=callback, source_indices=True, feature_confidences=True)
# Further numbers of each point are those of the nearest point of the scan
properties = {name: values[sources] for name, values in scan.properties.items()}
cgal_l0.write_points("clean.ply", positions, normals, {**properties, "confidence": confidences})
cgal_l0.snapshot(scan.points, positions, normals, path="picture.png")
# [files]
