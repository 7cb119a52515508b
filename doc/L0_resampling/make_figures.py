#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures of the manual:  make_figures.py BUILD_DIRECTORY [NAME...]

BUILD_DIRECTORY has the programs draw_variants, sample_mesh and examples. Points are those in data/.
Needs Pillow and NumPy (Debian: python3-pil, python3-numpy) to make the files small and to draw
meshes. Each figure is a row of pictures; what differs from one to the next stands below. The figure
`comparison`, README's too, is by draw_comparison.py in benchmark/L0_resampling/quality.
"""

import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parents[2]
FIGURES = Path(__file__).resolve().parent / "fig"

EVERYTHING = "-9,-9,-9,9,9,9"
CORNER = "0.6,0.55,1"           # where the eye is
FRONT, ABOVE = "0,0,1", "0.2,0.1,1"
STEPS = "0.1,0.2,0.3,0.8,0.8,0.7"     # a slab through two steps of the staircase
FACE = "0.5,0,0.4,0.9,0.4,0.6"        # a part of the front of the bracket

METHODS = {"default": "method=0", "lor": "method=1", "alor": "method=2"}


def sampled(mesh, **options):
    """Points drawn from a mesh, with options of sample_mesh."""
    return mesh, ["--seed", "2",
                  *(word for name, value in options.items()
                    for word in (f"--{name.replace('_', '-')}", str(value)))]


NOISY_STAIRCASE = sampled("staircase.off", points=10000, noise=1.5)
# a radius that sees through the noise
ON_NOISY_STAIRCASE = "method=1,select_percentage=100,neighbor_radius=2"


def corrugated_sheet():
    """Points of a sheet with hills and valleys in strips that are apart from each other, as some
    scanners move. One strip alone has no side."""
    generator = random.Random(2)
    number_of_strips, strip_distance = 20, 0.15
    points_across, points_along, step, height = 4, 125, 0.012, 0.12

    def near(i):
        return (i + generator.uniform(-0.3, 0.3)) * step

    for strip in range(number_of_strips):
        for across in range(points_across):
            for along in range(points_along):
                x, y = strip * strip_distance + near(across), near(along)
                yield x, y, height * math.sin(2 * math.pi * x) + generator.gauss(0, 0.001)


# name: (points, towards the eye, what is drawn, variants for draw_variants)
FIGURE_LIST = {
    "teaser": ("bracket_noisy", CORNER, EVERYTHING, ["input", "default"]),
    "torus": ("torus_noisy", CORNER, EVERYTHING, ["input", "dots=1"]),
    "methods": ("bracket_noisy", CORNER, EVERYTHING, ["input", *METHODS.values()]),
    "profile": ("staircase_noisy", FRONT, STEPS,
                ["input", *(f"{method},select_percentage=100" for method in METHODS.values())]),
    "number_of_output_points": ("dodecahedron_noisy", CORNER, EVERYTHING,
                                [f"dots=1,select_percentage={p}" for p in (5, 20, 50, 200)]),
    "neighbor_radius": ("bracket_noisy", CORNER, EVERYTHING,
                        [f"neighbor_radius={r}" for r in (0.4, 1, 2)]),
    "normal_filter_radius": ("bracket_noisy", CORNER, EVERYTHING,
                             [f"normal_filter_radius={r}" for r in (0.5, 1, 2.5)]),
    "sharpness_angle": ("bracket_noisy", CORNER, EVERYTHING,
                        [f"sharpness_angle={a}" for a in (4, 15, 50)]),
    "number_of_normal_filter_iterations": ("bracket_noisy", CORNER, EVERYTHING,
                                           [f"number_of_normal_filter_iterations={n}"
                                            for n in (0, 1, 5, 40)]),
    "normal_weight": (NOISY_STAIRCASE, FRONT, STEPS,
                      ["input",
                       *(f"{ON_NOISY_STAIRCASE},maximum_penalty=200,normal_weight={w}"
                         for w in (0, 0.9, 50))]),
    "regularization_weight": ("bracket_noisy", ABOVE, FACE,
                              ["input",
                               *(f"dots=1,regularization_weight={w}" for w in (0, 0.15, 1.5))]),
    "penalties": (NOISY_STAIRCASE, FRONT, STEPS,
                  ["input", *(f"{ON_NOISY_STAIRCASE},maximum_penalty={p}" for p in (0.1, 2, 200))]),
    "number_of_orientation_neighbors": (corrugated_sheet, "0.3,-0.6,1", EVERYTHING,
                                        ["input",
                                         *(f"number_of_orientation_neighbors={k}"
                                           for k in (12, 100))]),
    "random_seed": ("dodecahedron_noisy", CORNER, "-9,-9,1,9,9,9",
                    [f"dots=1,select_percentage=20,random_seed={s}" for s in (0, 1, 2)]),
    "keep_density": (sampled("dodecahedron.off", points=8000, noise=0.5, density_gradient=10),
                     CORNER, EVERYTHING,
                     ["input", "dots=1", "dots=1,keep_density=1"]),
    "drop_outliers": (sampled("bracket.off", points=10000, noise=0.5, outliers=5),
                      CORNER, EVERYTHING,
                      ["input", "drop_outliers=0", "drop_outliers=1"]),
    "feature_confidence": ("bracket_noisy", CORNER, EVERYTHING, ["default", "features=1"]),
    "creases": (sampled("bracket.off", points=20000, noise=0.5), CORNER, EVERYTHING,
                ["input", "creases=1"]),
    "viewpoint": ("torus_noisy", "0,-0.25,1", "-9,-9,-9,9,9,-0.2",
                  ["input", "cut=1", "cut=1,viewpoint_z=5", "cut=1,hints=3"]),
    "misled": ("torus_noisy", "0,-0.25,-1", EVERYTHING, ["default", "viewpoint_z=5", "up=1"]),
}

# The same for what examples make of points, a mesh each
FIGURES_OF_MESHES = {
    "meshes": ("bracket_noisy", CORNER, ["l0_resample_poisson_example", "sharp_mesh_example"]),
}
MESH_SIZE, SAMPLING = 480, 3    # of a picture, and pixels that become one
LIGHT = (-0.5, 0.8, 0.35)       # where it is: to the right, up, towards the eye


def write_ply(points, path):
    lines = [f"{x:.6f} {y:.6f} {z:.6f}" for x, y, z in points]
    header = ["ply", "format ascii 1.0", f"element vertex {len(lines)}",
              *(f"property float {axis}" for axis in "xyz"), "end_header"]
    path.write_text("\n".join([*header, *lines, ""]), encoding="ascii")


def input_file(points, programs, scratch):
    if isinstance(points, str):
        return ROOT / "data" / f"{points}.ply"
    path = scratch / "input.ply"
    if callable(points):
        write_ply(points(), path)
        return path
    mesh, options = points
    subprocess.run([programs / "sample_mesh", ROOT / "data" / mesh, path, *options], check=True,
                   stdout=subprocess.DEVNULL)
    return path


def unit(vectors):
    return vectors / numpy.maximum(numpy.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300)


def draw_mesh(path, eye):
    """Its triangles, the furthest ones first."""
    words = path.read_text(encoding="ascii").split()
    number = 3 * int(words[1])
    numbers = numpy.array(words[4:4 + number + 4 * int(words[2])], float)
    towards_eye = unit(numpy.array(eye.split(","), float))
    right = unit(numpy.cross((0, 0, 1), towards_eye))
    axes = numpy.stack([right, numpy.cross(towards_eye, right), towards_eye])
    seen = numbers[:number].reshape(-1, 3) @ axes.T
    seen -= (seen.min(0) + seen.max(0)) / 2
    corners = seen[numbers[number:].reshape(-1, 4)[:, 1:].astype(int)]
    normals = unit(numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    brightness = normals @ unit(numpy.array(LIGHT)) * numpy.where(normals[:, 2] < 0, -1, 1)
    grays = (150 + 95 * numpy.maximum(brightness, -0.5)).astype(int)
    size = MESH_SIZE * SAMPLING
    pixels = corners[:, :, :2] * (1, -1) * 0.9 * size / numpy.ptp(seen[:, :2]) + size / 2
    picture = Image.new("L", (size, size), 255)
    drawing = ImageDraw.Draw(picture)
    for triangle in numpy.argsort(corners[:, :, 2].mean(1)):
        drawing.polygon([tuple(corner) for corner in pixels[triangle]], fill=int(grays[triangle]),
                        outline=int(grays[triangle]) - 30)
    return picture.resize((MESH_SIZE, MESH_SIZE), Image.Resampling.LANCZOS)


def draw_meshes(name, programs, scratch):
    points, eye, examples = FIGURES_OF_MESHES[name]
    row = Image.new("L", (MESH_SIZE * len(examples), MESH_SIZE), 255)
    for place, example in enumerate(examples):
        subprocess.run([programs / "examples", example, input_file(points, programs, scratch),
                        scratch / "mesh.off"], check=True, stdout=subprocess.DEVNULL)
        row.paste(draw_mesh(scratch / "mesh.off", eye), (MESH_SIZE * place, 0))
    rows = numpy.flatnonzero((numpy.asarray(row) < 255).any(1))
    row.crop((0, rows[0] - 10, row.width, rows[-1] + 10)).save(FIGURES / f"{name}.png")
    return len(examples)


def draw_variants(name, programs, scratch):
    points, eye, box, variants = FIGURE_LIST[name]
    subprocess.run([programs / "draw_variants", input_file(points, programs, scratch),
                    FIGURES / f"{name}.png", eye, box, *variants], check=True)
    return len(variants)


def check_pictures(row, number):
    """Raises ValueError if one of the pictures of a row shows nothing, as when no point of a result
    lies in the part that is drawn."""
    width = row.width // number
    for i in range(number):
        if row.crop((i * width, 0, (i + 1) * width, row.height)).convert("L").getextrema()[0] > 240:
            raise ValueError(f"picture {i + 1} of {number} is empty")


def main():
    programs = Path(sys.argv[1]) / "bin"
    with tempfile.TemporaryDirectory() as scratch:
        for name in sys.argv[2:] or [*FIGURE_LIST, *FIGURES_OF_MESHES]:
            draw = draw_variants if name in FIGURE_LIST else draw_meshes
            number = draw(name, programs, Path(scratch))
            figure = FIGURES / f"{name}.png"
            try:
                check_pictures(Image.open(figure), number)
            except ValueError as error:
                sys.exit(f"make_figures.py: {figure.name}: {error}")
            Image.open(figure).quantize(256, Image.Quantize.MAXCOVERAGE).save(figure, optimize=True)


if __name__ == "__main__":
    main()
