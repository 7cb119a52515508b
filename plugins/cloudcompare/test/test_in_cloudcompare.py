#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command -L0_RESAMPLE of the plugin, in CloudCompare without windows, on a sphere whose halves
have other colors and classes: test_in_cloudcompare.py PROGRAM PLUGIN."""

import math
import os
import random
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

SIZE, NOISE, CLASS_ABOVE, CLASS_BELOW = 6000, 0.01, 6, 2
CENTER = (500000, 5000000, 100)  # as maps have it, so that CloudCompare shifts the cloud
PROPERTIES = ("x", "y", "z", "red", "green", "blue", "nx", "ny", "nz", "scalar_class")

failures = 0


def check(is_good, what):
    global failures
    if not is_good:
        failures += 1
        print(f"FAILED: {what}")


def write_sphere(path, inwards=False):
    """Noisy points of a sphere, red above and blue below, with normals outwards or inwards."""
    generator = random.Random(1)
    lines = []
    for _ in range(SIZE):
        d = [generator.gauss(0, 1) for _ in range(3)]
        length = math.sqrt(sum(c * c for c in d))
        d = [c / length for c in d]
        radius = 1 + NOISE * generator.gauss(0, 1)
        p = [center + radius * c for center, c in zip(CENTER, d)]
        is_above = d[2] > 0
        numbers = [*p, 255 * is_above, 0, 255 * (not is_above),
                   *(-c if inwards else c for c in d), CLASS_ABOVE if is_above else CLASS_BELOW]
        lines.append(" ".join(str(int(n)) if isinstance(n, bool) else f"{n:.12g}" for n in numbers))
    header = ["ply", "format ascii 1.0", f"element vertex {SIZE}"]
    for name in PROPERTIES:
        kind = {"x": "double", "y": "double", "z": "double", "red": "uchar", "green": "uchar",
                "blue": "uchar"}.get(name, "float")
        header.append(f"property {kind} {name}")
    path.write_text("\n".join([*header, "end_header", *lines, ""]))


def write_plane(path, height):
    """A PTX of a level plane, seen by a scanner that stands so much above it."""
    columns, rows = 60, 50
    x, y, z = CENTER
    z += height
    axes = "1 0 0\n0 1 0\n0 0 1"
    matrix = f"1 0 0 0\n0 1 0 0\n0 0 1 0\n{x} {y} {z} 1"
    points = [f"{0.1 * (i - columns / 2):.3f} {0.1 * (j - rows / 2):.3f} {-height:.3f} 0.5"
              for i in range(columns) for j in range(rows)]
    path.write_text("\n".join([str(columns), str(rows), f"{x} {y} {z}", axes, matrix, *points, ""]))


def read_ply(path):
    """The vertices of a binary little-endian PLY, as dictionaries."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    lines = header.decode().splitlines()
    size = next(int(line.split()[-1]) for line in lines if line.startswith("element vertex"))
    columns = [line.split()[1:] for line in lines if line.startswith("property")]
    letters = {"double": "d", "float": "f", "uchar": "B"}
    row = struct.Struct("<" + "".join(letters[kind] for kind, _ in columns))
    names = [name for _, name in columns]
    return [dict(zip(names, values)) for values in row.iter_unpack(body[:size * row.size])]


class Cloudcompare:
    """Runs the program in a folder, with the plugin where it looks for those of the user."""

    def __init__(self, program, plugin, folder):
        self.program, self.folder = program, folder
        plugins = folder / "data/CCCorp/CloudCompare/plugins"
        plugins.mkdir(parents=True)
        (plugins / Path(plugin).name).symlink_to(Path(plugin).resolve())
        self.environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen", "HOME": str(folder),
                            "XDG_DATA_HOME": str(folder / "data"),
                            "XDG_CONFIG_HOME": str(folder / "config")}

    def run(self, *options, source="sphere.ply"):
        """Resamples with the options: the exit status, what was said, the points or None."""
        result = self.folder / f"{Path(source).stem}_L0_RESAMPLED.ply"
        result.unlink(missing_ok=True)
        process = subprocess.run(
            [self.program, "-SILENT", "-NO_TIMESTAMP", "-C_EXPORT_FMT", "PLY",
             "-PLY_EXPORT_FMT", "BINARY_LE", "-O", "-GLOBAL_SHIFT", "AUTO", source, "-L0_RESAMPLE",
             *options],
            cwd=self.folder, env=self.environment, text=True, timeout=300, check=False,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        points = read_ply(result) if result.exists() else None
        return process.returncode, process.stdout, points


def share(points, holds):
    return sum(map(holds, points)) / len(points)


def offset(point):
    return [point[name] - center for name, center in zip("xyz", CENTER)]


def outwards(point):
    return sum(a * point[name] for a, name in zip(offset(point), ("nx", "ny", "nz"))) > 0


def check_result(points, size, options):
    """Number, positions, normals of unit length, and colors and classes of the nearest points."""
    check(points is not None, f"{options}: no result")
    if points is None:
        return
    check(len(points) == size, f"{options}: {len(points)} points instead of {size}")
    mean = sum(abs(math.hypot(*offset(p)) - 1) for p in points) / len(points)
    check(mean < 0.5 * NOISE, f"{options}: mean distance {mean}")
    check(all(abs(math.hypot(p["nx"], p["ny"], p["nz"]) - 1) < 0.01 for p in points),
          f"{options}: a normal is not of unit length")
    away = [p for p in points if abs(offset(p)[2]) > 0.1]
    for p in away:
        is_above = offset(p)[2] > 0
        if (p["red"], p["blue"]) != ((255, 0) if is_above else (0, 255)):
            return check(False, f"{options}: the color of a point is not that of its source")
        if p["scalar_class"] != (CLASS_ABOVE if is_above else CLASS_BELOW):
            return check(False, f"{options}: the class of a point is not that of its source")


def check_refusal(cloudcompare, options, sentence, source="sphere.ply"):
    status, text, points = cloudcompare.run(*options, source=source)
    check(status != 0 and points is None, f"{options}: not refused")
    check(sentence in text, f"{options}: '{sentence}' is not in\n{text}")


def main():
    program, plugin = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_sphere(folder / "sphere.ply")
        write_sphere(folder / "inwards.ply", inwards=True)
        bare = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" \
               "property float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
        (folder / "bare.ply").write_text(bare)
        cloudcompare = Cloudcompare(program, plugin, folder)

        for options, size in (((), SIZE // 2), (("-PERCENTAGE", "20"), SIZE // 5),
                              (("-POINTS", "7000"), 7000),
                              (("--points", "1000", "--keep-density", "--keep-outliers"), 1000),
                              (("-METHOD", "lor", "-NEIGHBOR_RADIUS", "0.3", "-POINTS", "90"), 90)):
            status, text, points = cloudcompare.run(*options)
            check(status == 0, f"{options}: status {status}\n{text}")
            if "lor" not in options:
                check_result(points, size, options)
                check(share(points, outwards) > 0.99, f"{options}: not outwards")
            else:
                check(points is not None and len(points) == size, f"{options}: wrong number")

        # sides
        few = ("-POINTS", "1000")
        south = [f"{c:.12g}" for c in (CENTER[0], CENTER[1] - 100, CENTER[2])]
        for options, source, is_right in (
                (("-VIEWPOINT", ",".join(south)), "sphere.ply", lambda p: p["ny"] < 0.2),
                (("-UP", "0,0,-1"), "sphere.ply", lambda p: p["nz"] < 0.2),
                (("-ORIENT_BY_NORMALS",), "sphere.ply", outwards),
                (("-ORIENT_BY_NORMALS",), "inwards.ply", lambda p: not outwards(p))):
            status, text, points = cloudcompare.run(*few, *options, source=source)
            check(status == 0, f"{options}: status {status}\n{text}")
            check_result(points, 1000, options)
            check(share(points, is_right) > 0.99, f"{options} {source}: wrong sides")

        # a scan grid knows its scanner
        for height, sign in ((3, 1), (-3, -1)):
            write_plane(folder / "plane.ptx", height)
            status, text, points = cloudcompare.run("-VIEWPOINT", "sensor", source="plane.ptx")
            check(status == 0 and points is not None, f"plane.ptx: status {status}\n{text}")
            if points:
                check(share(points, lambda p, sign=sign: sign * p["nz"] > 0.9) == 1,
                      f"scanner at {height}: wrong sides")

        # the next command is left alone
        status, text, points = cloudcompare.run(*few, "-AUTO_SAVE", "OFF", "-SS", "RANDOM", "100")
        check(status == 0 and "[SUBSAMPLING]" in text, f"-SS was not run\n{text}")

        # what is refused, in whose words
        check_refusal(cloudcompare, ("-PERCENTAGE", "0"), "percentage")
        check_refusal(cloudcompare, ("-NEIGHBOR_RADIUS", "-1"), "neighbor_radius")
        check_refusal(cloudcompare, ("-UP", "0,0,0"), "up_direction")
        check_refusal(cloudcompare, ("-POINTS", "many"), "-POINTS: 'many' is not a whole number")
        check_refusal(cloudcompare, ("-METHOD", "best"), "is not default, lor or alor")
        check_refusal(cloudcompare, ("-UP", "0,1"), "is not three coordinates")
        check_refusal(cloudcompare, ("-POINTS",), "-POINTS: a value is missing")
        check_refusal(cloudcompare, ("-UP", "0,0,1", "-ORIENT_BY_NORMALS"), "excludes -UP")
        check_refusal(cloudcompare, ("-VIEWPOINT", "sensor"), "the cloud has no sensor")
        check_refusal(cloudcompare, ("-ORIENT_BY_NORMALS",), "the cloud has no normals", "bare.ply")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
