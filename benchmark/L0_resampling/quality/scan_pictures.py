# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""One page of pictures of scans and their results. Needs NumPy and Matplotlib.

Each scan has a row: the scan and its result as the sensor sees them, and slices of both. Points of
the scan that are lost are red, and so are points of the result that are adrift; ghosts are magenta,
normals that face away from the sensor orange.
"""

from dataclasses import dataclass

import matplotlib

matplotlib.use("agg")
import numpy
from matplotlib import pyplot

GREY, RED, MAGENTA, ORANGE, BLUE = (
    (0.6, 0.6, 0.6),
    (0.9, 0, 0),
    (1, 0, 1),
    (1, 0.55, 0),
    (0.1, 0.3, 0.7),
)
WIDE = 100  # degrees; wider fields of view are drawn as panoramas


@dataclass
class Slice:
    """Points whose coordinate `axis` is in an interval, and a window of the other two, or None."""

    axis: int
    position: float
    thickness: float
    center: tuple = None
    size: float = None

    def __str__(self):
        return f"{'xyz'[self.axis]} = {self.position:.4g} +- {self.thickness / 2:.2g}"


def parse_slice(text):
    """'z 1.3 0.2' or, with a window, 'z 1.3 0.2 4.5 -2 3'. Raises ValueError for anything else."""
    words = text.split()
    if len(words) not in (3, 6) or words[0] not in ("x", "y", "z"):
        raise ValueError(
            f"'{text}' is no slice: axis, position, thickness, and a window's center and size"
        )
    numbers = [float(word) for word in words[1:]]
    window = ((numbers[2], numbers[3]), numbers[4]) if len(words) == 6 else ()
    return Slice("xyz".index(words[0]), *numbers[:2], *window)


def default_slices(positions):
    """Across the shortest and the longest side of the box, through the median."""
    extent = numpy.subtract(*numpy.quantile(positions, [0.995, 0.005], axis=0))
    middle = numpy.median(positions, axis=0)
    thickness = 0.01 * numpy.linalg.norm(extent)
    return [
        Slice(int(axis), float(middle[axis]), float(thickness))
        for axis in (extent.argmin(), extent.argmax())
    ]


class Camera:
    """Maps points to the picture: azimuth and elevation, a camera's image, or a slanted view."""

    def __init__(self, positions, viewpoint):
        self.viewpoint = viewpoint
        if viewpoint is None:
            self.kind = "slanted"
            return
        rays = positions - viewpoint
        rays /= numpy.linalg.norm(rays, axis=1)[:, None]
        forward = rays.mean(0)
        length = numpy.linalg.norm(forward)
        spread = numpy.degrees(numpy.arccos(numpy.clip(rays @ forward / max(length, 1e-12), -1, 1)))
        self.kind = (
            "panorama" if length < 0.3 or numpy.quantile(spread, 0.99) > WIDE / 2 else "camera"
        )
        self.forward = forward / max(length, 1e-12)

    def __call__(self, positions):
        if self.kind == "slanted":
            x, y, z = positions.T
            return numpy.stack([x + 0.35 * y, z + 0.5 * y], 1)
        rays = positions - self.viewpoint
        if self.kind == "panorama":
            azimuth = numpy.degrees(numpy.arctan2(rays[:, 1], rays[:, 0]))
            return numpy.stack(
                [-azimuth, numpy.degrees(numpy.arctan2(rays[:, 2], numpy.hypot(*rays[:, :2].T)))], 1
            )
        # A camera that looks along z has y downwards, as depth cameras do; any other has z upwards.
        up = numpy.array([0.0, -1, 0] if abs(self.forward[2]) > 0.8 else [0.0, 0, 1])
        right = numpy.cross(self.forward, up)
        right /= numpy.linalg.norm(right)
        depth = numpy.maximum(rays @ self.forward, 1e-9)
        return (
            numpy.stack([rays @ right, rays @ numpy.cross(right, self.forward)], 1) / depth[:, None]
        )


def draw(panel, places, colors, title, size):
    panel.scatter(*places.T, s=size, c=colors, linewidths=0, rasterized=True)
    panel.set_title(title, fontsize=9)
    panel.tick_params(labelsize=6)


def shaded(result, viewpoint):
    """Grey levels of a lamp at the sensor or, without one, above to the left."""
    if viewpoint is None:
        light = numpy.array([-0.4, -0.5, 0.77])
        cosines = abs(result.normals @ light)
    else:
        to_sensor = viewpoint - result.positions
        cosines = abs((to_sensor * result.normals).sum(1) / numpy.linalg.norm(to_sensor, axis=1))
    return numpy.repeat((0.15 + 0.75 * cosines)[:, None], 3, axis=1)


def result_colors(result, comparison, viewpoint):
    colors = shaded(result, viewpoint)
    if viewpoint is not None:
        to_sensor = viewpoint - result.positions
        to_sensor /= numpy.linalg.norm(to_sensor, axis=1)[:, None]
        colors[(to_sensor * result.normals).sum(1) < -0.17] = ORANGE
    colors[comparison.is_adrift] = RED
    colors[comparison.is_ghost] = MAGENTA
    return colors


def draw_slice(panels, cut, clouds):
    """Scan and result beside each other, in the same window."""
    axes = [axis for axis in range(3) if axis != cut.axis]
    limits = None
    for panel, (title, positions, colors, normals) in zip(panels, clouds):
        inside = abs(positions[:, cut.axis] - cut.position) <= cut.thickness / 2
        places = positions[inside][:, axes]
        draw(
            panel,
            places,
            colors[inside],
            f"{title}, {cut}",
            numpy.clip(8000 / max(len(places), 1), 1.5, 12),
        )
        if limits is None and len(places) > 0:
            limits = numpy.quantile(places, [0.002, 0.998], axis=0)
            if cut.center is not None:
                limits = numpy.array(cut.center) + cut.size / 2 * numpy.array([[-1, -1], [1, 1]])
        if limits is None:
            continue
        if normals is not None:
            length = 0.02 * numpy.linalg.norm(limits[1] - limits[0])
            panel.quiver(
                *places.T,
                *normals[inside][:, axes].T,
                color=BLUE,
                angles="xy",
                scale_units="xy",
                scale=1 / length,
                width=0.001,
                headwidth=0,
                headlength=0,
                headaxislength=0,
            )
        margin = 0.03 * (limits[1] - limits[0]).max()
        panel.set_xlim(limits[0, 0] - margin, limits[1, 0] + margin)
        panel.set_ylim(limits[0, 1] - margin, limits[1, 1] + margin)
        panel.set_aspect("equal", adjustable="box")


@dataclass
class Row:
    """What a row of the page shows. `slices` may be empty."""

    title: str
    scan: object  # a Cloud
    result: object
    comparison: object
    viewpoint: object  # an array, or None
    slices: list


def draw_row(panels, row):
    camera = Camera(row.scan.positions, row.viewpoint)
    size = 2.5 if len(row.scan) < 30_000 else 0.8
    scan_colors = numpy.tile(GREY, (len(row.scan), 1))
    scan_colors[row.comparison.is_lost] = RED
    colors = result_colors(row.result, row.comparison, row.viewpoint)
    lost, adrift = 100 * row.comparison.is_lost.mean(), 100 * row.comparison.is_adrift.mean()
    ghosts = 100 * row.comparison.is_ghost.mean()
    places = camera(row.scan.positions)
    draw(panels[0], places, scan_colors, f"{row.title}: scan, lost {lost:.2f} % (red)", size)
    draw(
        panels[1],
        camera(row.result.positions),
        colors,
        f"result, adrift {adrift:.2f} % (red), ghosts {ghosts:.2f} % (magenta)",
        size,
    )
    low, high = numpy.quantile(places, [0.001, 0.999], axis=0)
    for panel in panels[:2]:
        panel.set_xlim(low[0], high[0])
        panel.set_ylim(low[1], high[1])
        if camera.kind != "panorama":
            panel.set_aspect("equal", adjustable="box")
    clouds = (
        ("scan", row.scan.positions, scan_colors, None),
        ("result", row.result.positions, colors, row.result.normals),
    )
    for number, cut in enumerate((row.slices or default_slices(row.scan.positions))[:2]):
        draw_slice(panels[2 + 2 * number : 4 + 2 * number], cut, clouds)


def draw_page(path, rows):
    """A PNG file with a row of six panels for each of `rows`."""
    figure, panels = pyplot.subplots(
        len(rows), 6, figsize=(27, 4.2 * len(rows)), squeeze=False, layout="constrained"
    )
    for row_panels, row in zip(panels, rows):
        draw_row(row_panels, row)
    figure.savefig(path, dpi=75)
    pyplot.close(figure)
