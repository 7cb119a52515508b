# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The recipes of the manual in Python; run it in a folder with the scans."""

# [range]
import cgal_l0

scan = cgal_l0.read_points("range.ply")
positions, normals, report = cgal_l0.l0_resample_point_set(
    scan.points, viewpoint=(4.6, 2.2, -3.3), report=True)
print(f"{report.hinted_share:.0%} turned to the scanner, extent {report.extent_share:.0%}")
# [range]
assert report.hinted_share > 0.99 and report.extent_share > 0.95

# [photos]
scan = cgal_l0.read_points("photos.ply")
positions, normals, report = cgal_l0.l0_resample_point_set(
    scan.points, number_of_output_points=8000, report=True)
print(f"{report.number_of_outliers} outliers, "
      f"noise {report.estimated_noise / report.estimated_spacing:.2f} spacings")
# [photos]
assert len(positions) == 8000 and 100 < report.number_of_outliers < 500

# [lidar]
import numpy

scan = cgal_l0.read_points("survey.ply")
stations = numpy.loadtxt("stations.txt")
positions, normals, report = cgal_l0.l0_resample_point_set(
    scan.points, viewpoints=stations[scan.properties["view"]], report=True)
print(f"radii from {report.least_neighbor_radius:.2f} to {report.largest_neighbor_radius:.2f}, "
      f"{report.hinted_share:.0%} turned to their station")
# [lidar]
assert report.largest_neighbor_radius > 2 * report.least_neighbor_radius
assert report.hinted_share > 0.95

# [part]
scan = cgal_l0.read_points("part.ply")
positions, normals, confidences = cgal_l0.l0_resample_point_set(
    scan.points, number_of_output_points=10000, feature_confidences=True)
edges = positions[confidences > 0.8]
cgal_l0.write_points("part_edges.ply", edges)
# [part]
assert 100 < len(edges) < 3000

# [poisson]
scan = cgal_l0.read_points("body.ply")
positions, normals, report = cgal_l0.l0_resample_point_set(
    scan.points, select_percentage=100, report=True)
print(f"{report.oriented_share:.0%} have one orientation")
cgal_l0.write_points("for_poisson.ply", positions, normals)
# [poisson]
assert report.oriented_share > 0.99


# [registration]
def spacing_of(points):
    return cgal_l0.l0_resample_point_set(
        points, number_of_output_points=1, report=True)[-1].estimated_spacing


first, second = (cgal_l0.read_points(f"{name}.ply").points for name in ("first", "second"))
spacing = max(spacing_of(first), spacing_of(second))
even = [cgal_l0.l0_resample_point_set(
            points, select_percentage=min(100, 100 * (spacing_of(points) / spacing)**2))
        for points in (first, second)]
# [registration]
assert len(even[1][0]) == 4000 and 0.85 < len(even[0][0]) / 4000 < 1.15
