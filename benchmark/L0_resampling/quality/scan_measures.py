# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures a resampled scan against the scan itself, without a ground truth. Needs NumPy and SciPy.

All measures compare distances with the local spacing, the mean distance to six neighbors, since the
density of a scan falls by orders of magnitude from near to far.
"""

import lzma
from dataclasses import dataclass

import numpy
from scipy.spatial import cKDTree

PLY_TYPES = {
    "float": "f4",
    "float32": "f4",
    "double": "f8",
    "float64": "f8",
    "char": "i1",
    "int8": "i1",
    "uchar": "u1",
    "uint8": "u1",
    "short": "i2",
    "int16": "i2",
    "ushort": "u2",
    "uint16": "u2",
    "int": "i4",
    "int32": "i4",
    "uint": "u4",
    "uint32": "u4",
}
SAMPLE = 30_000  # points whose surroundings are measured, at most
NEIGHBORS = 6
LOST, GHOST, ADRIFT = 3, 2, 1.5  # spacings
POINTS_OF_DENSITY = 64
AWAY_SINE = 0.17  # a normal that faces away from the sensor by more than 10 degrees


@dataclass
class Cloud:
    positions: numpy.ndarray
    normals: numpy.ndarray  # None where the file has none
    views: numpy.ndarray  # the same

    def __len__(self):
        return len(self.positions)


def read_cloud(path):
    """A binary little-endian PLY file, which may be compressed with xz.

    Raises ValueError for another format, or where there is no point.
    """
    opened = lzma.open if path.suffix == ".xz" else open
    with opened(path, "rb") as stream:
        count, fields, is_vertex = 0, [], False
        for line in iter(stream.readline, b""):
            words = line.decode("latin-1").split()
            if words[:1] == ["format"] and words[1] != "binary_little_endian":
                raise ValueError(f"{path}: not a binary little-endian PLY file")
            if words[:1] == ["element"]:
                is_vertex = words[1] == "vertex"
                count = int(words[2]) if is_vertex else count
            elif words[:1] == ["property"] and is_vertex:
                fields.append((words[2], "<" + PLY_TYPES[words[1]]))
            elif words == ["end_header"]:
                break
        rows = numpy.frombuffer(stream.read(), numpy.dtype(fields), count)
    if count == 0:
        raise ValueError(f"{path}: has no points")

    def columns(*names):
        return numpy.stack([rows[name].astype(float) for name in names], 1)

    names = rows.dtype.names
    return Cloud(
        columns("x", "y", "z"),
        columns("nx", "ny", "nz") if "nx" in names else None,
        rows["view"] if "view" in names else None,
    )


class Comparison:
    """Points of a scan that are lost, and points of a result where the scan has none."""

    def __init__(self, scan, result):
        """`scan` and `result` are arrays of positions."""
        self.scan, self.result = scan, result
        self.scan_tree, self.result_tree = cKDTree(scan), cKDTree(result)
        own = self._spacing(self.scan_tree, scan)
        self.spacing = numpy.median(self._spacing(self.result_tree, result))
        to_result, self.nearest_of_result = self.result_tree.query(scan)
        self.is_lost = to_result > LOST * numpy.maximum(self.spacing, own)
        to_scan, nearest = self.scan_tree.query(result)
        self.is_ghost = to_scan > GHOST * numpy.maximum(self.spacing, own[nearest])
        self.is_adrift = to_scan > ADRIFT * own[nearest]

    @staticmethod
    def _spacing(tree, positions):
        count = min(NEIGHBORS, tree.n - 1)
        return (
            tree.query(positions, count + 1)[0][:, 1:].mean(1)
            if count > 0
            else numpy.zeros(len(positions))
        )

    def unevenness(self):
        """Standard deviation of the spacing over the mean spacing of the twelve points around."""
        points = self.result[numpy.random.default_rng(0).permutation(len(self.result))[:SAMPLE]]
        distances, around = self.result_tree.query(points, min(13, len(self.result)))
        own = distances[:, 1 : NEIGHBORS + 1].mean(1)
        near = self._spacing(self.result_tree, self.result[around[:, 1:].ravel()]).reshape(
            len(points), -1
        )
        return float((own / near.mean(1)).std())

    def density_ratios(self):
        """Density of the result over that of the scan, if it had as many points: in the balls of
        the `POINTS_OF_DENSITY` points nearest to points of the scan."""
        places = self.scan[numpy.random.default_rng(0).permutation(len(self.scan))[:SAMPLE]]
        count = min(POINTS_OF_DENSITY, len(self.scan))
        radii = self.scan_tree.query(places, count)[0].reshape(len(places), -1)[:, -1]
        in_scan, in_result = (
            tree.query_ball_point(places, radii * (1 + 1e-9), return_length=True) / tree.n
            for tree in (self.scan_tree, self.result_tree)
        )
        return in_result / in_scan

    def measures(self):
        """Shares are percent; `box` is the diagonal of the inner 99 %'s box, over the scan's."""

        def extent(positions):
            return numpy.linalg.norm(
                numpy.subtract(*numpy.quantile(positions, [0.995, 0.005], axis=0))
            )

        thin, dense = numpy.quantile(self.density_ratios(), [0.05, 0.95])
        return {
            "lost": 100 * float(self.is_lost.mean()),
            "ghosts": 100 * float(self.is_ghost.mean()),
            "adrift": 100 * float(self.is_adrift.mean()),
            "box": float(extent(self.result) / extent(self.scan)),
            "uneven": self.unevenness(),
            "thin": float(thin),
            "dense": float(dense),
        }


def away_from_viewpoint(result, viewpoint):
    """Share of normals that face away from the sensor, in percent, by more than 10 degrees."""
    to_sensor = viewpoint - result.positions
    to_sensor /= numpy.linalg.norm(to_sensor, axis=1)[:, None]
    return 100 * float(((to_sensor * result.normals).sum(1) < -AWAY_SINE).mean())


def turned_up(result):
    """Of the normals that are near the vertical, the share that points upwards, in percent."""
    is_ground = abs(result.normals[:, 2]) > 0.8
    return 100 * float((result.normals[is_ground, 2] > 0).mean()) if is_ground.any() else 100.0


def angle_to_plane(scan, result, low, high, tolerance):
    """Mean angle in degrees between normals on a flat part and the plane of that part of the scan.

    The plane is fitted to the scan's points in the box from `low` to `high` by RANSAC.
    Raises ValueError where there are no points.
    """
    inside = scan[((scan >= low) & (scan <= high)).all(1)]
    on_part = ((result.positions >= low) & (result.positions <= high)).all(1)
    if len(inside) < 3 or not on_part.any():
        raise ValueError("no points where the plane should be")
    random = numpy.random.default_rng(0)
    best = (0, None, None)
    for _ in range(400):
        a, b, c = inside[random.integers(0, len(inside), 3)]
        normal = numpy.cross(b - a, c - a)
        length = numpy.linalg.norm(normal)
        if length > 0:
            normal /= length
            support = (abs((inside - a) @ normal) < tolerance).sum()
            best = max(best, (support, a, normal), key=lambda plane: plane[0])
    _, center, normal = best
    for _ in range(3):
        near = inside[abs((inside - center) @ normal) < 2 * tolerance]
        center = near.mean(0)
        normal = numpy.linalg.svd((near - center)[:20000], full_matrices=False)[2][2]
    on_plane = on_part & (abs((result.positions - center) @ normal) < 2 * tolerance)
    cosines = numpy.clip(abs(result.normals[on_plane] @ normal), 0, 1)
    return float(numpy.degrees(numpy.arccos(cosines)).mean())
