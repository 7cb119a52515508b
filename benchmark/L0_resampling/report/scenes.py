# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packs points and meshes for the viewer of the page: 16 bits a coordinate, 8 a part of a normal, deflated, base64."""

import base64
import zlib

import numpy

PLY_TYPES = {"float": "<f4", "float32": "<f4", "double": "<f8", "float64": "<f8", "uchar": "u1", "uint8": "u1", "int": "<i4"}


def read_ply(path):
    """Positions, and normals or None, of a binary PLY file with vertices only."""
    with open(path, "rb") as stream:
        count, fields = 0, []
        for line in iter(stream.readline, b""):
            words = line.decode("ascii").split()
            if words[:2] == ["element", "vertex"]:
                count = int(words[2])
            elif words[:1] == ["property"]:
                fields.append((words[2], PLY_TYPES[words[1]]))
            elif words == ["end_header"]:
                break
        data = numpy.frombuffer(stream.read(), dtype=numpy.dtype(fields), count=count)
    positions = numpy.stack([data[name] for name in ("x", "y", "z")], axis=1).astype(float)
    names = data.dtype.names
    if "nx" not in names:
        return positions, None
    return positions, numpy.stack([data[name] for name in ("nx", "ny", "nz")], axis=1).astype(float)


def read_off(path):
    """Vertices and triangles."""
    with open(path, encoding="ascii") as stream:
        words = stream.read().split()
    vertices, triangles = int(words[1]), int(words[2])
    numbers = numpy.array(words[4:4 + 3 * vertices + 4 * triangles], dtype=float)
    return numbers[:3 * vertices].reshape(-1, 3), numbers[3 * vertices:].reshape(-1, 4)[:, 1:].astype(int)


def packed(*arrays):
    return base64.b64encode(zlib.compress(b"".join(array.tobytes() for array in arrays), 9)).decode("ascii")


class Frame:
    """The box of all pictures of a figure, so that they have one camera. The viewer sees it in a sphere of radius 1."""

    def __init__(self, positions):
        # what a few outliers reach does not count
        low, high = numpy.quantile(positions, [0.001, 0.999], axis=0)
        self.center, self.radius = (low + high) / 2, float(numpy.linalg.norm(high - low)) / 2

    def quantized(self, positions):
        inside = numpy.clip((positions - self.center) / self.radius, -1, 1)
        return numpy.round(inside * 32767).astype("<i2")

    def spacing(self, positions):
        """Of so many points on a surface as large as half the box's, which is near enough to draw them."""
        x, y, z = (positions.max(axis=0) - positions.min(axis=0)) / self.radius
        return float(numpy.sqrt((x * y + y * z + z * x) / len(positions)))


def pack_scene(scene, files, frame, largest_error):
    """What the viewer gets of a scene: its points and, where there is one, its mesh, colored by its distance to the truth."""
    positions, normals = read_ply(files / scene["points"])
    result = {"title": scene["title"], "remark": scene.get("remark", ""), "spacing": frame.spacing(positions),
              "points": {"count": len(positions), "has_normals": normals is not None and not scene.get("is_raw", False)}}
    parts = [frame.quantized(positions)]
    if result["points"]["has_normals"]:
        parts.append(numpy.round(normals * 127).astype("i1"))
    result["points"]["data"] = packed(*parts)
    if "mesh" in scene:
        vertices, triangles = read_off(files / scene["mesh"])
        errors = numpy.zeros(len(vertices))
        if "values" in scene:
            errors = numpy.fromfile(files / scene["values"], dtype="<f4").reshape(-1, 2)[:, 0]
        result["mesh"] = {"vertices": len(vertices), "triangles": len(triangles), "has_errors": "values" in scene,
                          "data": packed(triangles.astype("<u4"), frame.quantized(vertices),
                                         numpy.round(numpy.clip(errors / largest_error, 0, 1) * 255).astype("u1"))}
    return result


# Where the eye is, and which way is up, of inputs that do not stand on the xy plane
CAMERAS = {"armadillo.off": ((-0.9, 0.7, -3.7), (0, 1, 0)), "hippo1.ply": ((2.2, 1.9, 2.6), (0, 1, 0))}
CAMERA = ((2.2, -2.6, 1.9), (0, 0, 1))


def pack_figure(scenes, files, mesh, noise_percent=None):
    """All scenes of a figure, seen by one camera. The color of the largest error is twice the noise."""
    largest_error = 2 * noise_percent if noise_percent else 1
    eye, up = CAMERAS.get(mesh, CAMERA)
    frame = Frame(numpy.concatenate([read_ply(files / scene["points"])[0] for scene in scenes]))
    return {"largest_error": largest_error, "eye": eye, "up": up, "scenes": [pack_scene(scene, files, frame, largest_error) for scene in scenes]}
