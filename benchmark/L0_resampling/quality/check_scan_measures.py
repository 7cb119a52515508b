#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the measures of scans on known cases: check_scan_measures.py SCRATCH_FOLDER"""

import lzma
import sys
from pathlib import Path

try:
    import numpy

    import scan_measures
    import scan_pictures
except ImportError as error:
    print(f"skipped: {error}; Debian has it as python3-numpy, python3-scipy or python3-matplotlib")
    sys.exit(77)


def grid(count, spacing, z=0.0):
    x, y = numpy.meshgrid(numpy.arange(count) * spacing, numpy.arange(count) * spacing)
    return numpy.stack([x.ravel(), y.ravel(), numpy.full(x.size, z)], 1)


def oriented(positions, normal):
    return scan_measures.Cloud(
        positions, numpy.tile(numpy.array(normal, float), (len(positions), 1)), None
    )


def check_equal_clouds():
    scan = grid(60, 1.0)
    measures = scan_measures.Comparison(scan, scan).measures()
    assert measures["lost"] == measures["ghosts"] == measures["adrift"] == 0, measures
    assert measures["box"] == 1, measures
    assert measures["uneven"] < 0.1, measures  # the rows at the border alone
    moved = scan + numpy.random.default_rng(1).normal(0, 0.3, scan.shape)
    assert scan_measures.Comparison(scan, moved).measures()["uneven"] > 0.1


def check_density():
    """A result that is half as dense as the scan on one side, and three times on the other."""
    scan = grid(60, 1.0)
    left = scan[:, 0] < 30
    measures = scan_measures.Comparison(scan, scan).measures()
    assert measures["thin"] == measures["dense"] == 1, measures
    shares = numpy.where(left, 0.2, 0.6)
    random = numpy.random.default_rng(1)
    result = scan[random.uniform(size=len(scan)) < shares]
    measures = scan_measures.Comparison(scan, result).measures()
    assert 0.2 < measures["thin"] < 0.5 and 1.5 < measures["dense"] < 2, measures


def check_lost():
    """A quarter of the scan, far away, and sparse as it is a third of the box."""
    scan = numpy.concatenate([grid(60, 1.0), grid(20, 10.0, 500.0) + (300, 0, 0)])
    measures = scan_measures.Comparison(scan, scan[:3600]).measures()
    assert measures["lost"] == 10, measures
    assert measures["box"] < 0.2, measures
    thinned = scan[::2]  # a spacing that grows by sqrt(2) loses nothing, near or far
    assert scan_measures.Comparison(scan, thinned).measures()["lost"] == 0


def check_ghosts_and_adrift():
    scan = grid(60, 1.0)
    inner = scan[(scan[:, :2] > 5).all(1) & (scan[:, :2] < 54).all(1)]
    for height, ghosts, adrift in (
        (1.0, 0, 0),
        (2.1, 0, 50),
        (2.6, 50, 50),
    ):  # spacing: (4 + 2 * sqrt(2)) / 6 = 1.14
        result = numpy.concatenate([inner, inner + (0, 0, height)])
        measures = scan_measures.Comparison(scan, result).measures()
        assert (measures["ghosts"], measures["adrift"]) == (ghosts, adrift), (height, measures)


def check_normals():
    cloud = oriented(grid(30, 0.1), (0, 0, 1))
    assert scan_measures.away_from_viewpoint(cloud, numpy.array([1.0, 1, 5])) == 0
    assert scan_measures.away_from_viewpoint(cloud, numpy.array([1.0, 1, -5])) == 100
    assert scan_measures.turned_up(cloud) == 100
    assert scan_measures.turned_up(oriented(cloud.positions, (0, 0, -1))) == 0
    tilted = oriented(cloud.positions, (0, numpy.sin(0.1), -numpy.cos(0.1)))
    angle = scan_measures.angle_to_plane(
        cloud.positions, tilted, numpy.full(3, -1.0), numpy.full(3, 4.0), 0.01
    )
    assert abs(angle - numpy.degrees(0.1)) < 1e-6, angle


def check_reader(folder):
    """Plain and compressed, with a property that is none of ours."""
    header = (
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
        "property float x\nproperty float y\n"
        "property float z\nproperty uchar intensity\nproperty int view\nend_header\n"
    )
    rows = numpy.array([(1, 2, 3, 9, 0), (4, 5, 6, 8, 1), (7, 8, 9, 7, 2)], "<f4,<f4,<f4,u1,<i4")
    plain, compressed = folder / "three.ply", folder / "three.ply.xz"
    plain.write_bytes(header.encode() + rows.tobytes())
    compressed.write_bytes(lzma.compress(plain.read_bytes()))
    for path in (plain, compressed):
        cloud = scan_measures.read_cloud(path)
        assert cloud.positions.tolist() == [[1, 2, 3], [4, 5, 6], [7, 8, 9]], cloud
        assert cloud.views.tolist() == [0, 1, 2] and cloud.normals is None, cloud
    plain.write_bytes(header.replace("binary_little_endian", "ascii").encode())
    try:
        scan_measures.read_cloud(plain)
    except ValueError:
        return
    raise AssertionError("an ASCII file is read as a binary one")


def check_slices():
    cut = scan_pictures.parse_slice("z 1.3 0.2 4 5 2")
    assert (cut.axis, cut.position, cut.thickness, cut.center, cut.size) == (
        2,
        1.3,
        0.2,
        (4, 5),
        2,
    ), cut
    try:
        scan_pictures.parse_slice("w 1 2")
    except ValueError:
        return
    raise AssertionError("w is no axis")


if __name__ == "__main__":
    scratch = Path(sys.argv[1])
    scratch.mkdir(parents=True, exist_ok=True)
    check_equal_clouds()
    check_density()
    check_lost()
    check_ghosts_and_adrift()
    check_normals()
    check_reader(scratch)
    check_slices()
