#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the picture at the top of README, and writes the numbers of its caption to results/picture.json:

    draw_comparison.py BUILD DEMO_DATA

A noisy part, what WLOP, EAR and the default method make of it, and below each the Poisson mesh of these points, colored by
its distance to the true surface; then a real scan of CGAL's data before and after. WLOP and EAR may choose: of all their
radii and variants, the one with the least mean distance of the mesh is shown. Meshes are drawn as many points on them, by the
renderer of `cgal_l0.snapshot()`, so that everything is seen in one light. README is written anew by readme_figures.py.
"""

import argparse
import io
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib
import numpy
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LinearSegmentedColormap, Normalize
from PIL import Image

from poisson_bench import Poisson_bench
from quality_bench import command_line, mesh_of

HERE = Path(__file__).resolve().parent
PICTURE = HERE.parents[2] / "doc" / "L0_resampling" / "fig" / "comparison.png"
NUMBERS = HERE / "results" / "picture.json"
sys.path += [str(HERE.parent / folder) for folder in ("common", "methods")]
from methods import ear, ours, simple_filter, wlop
from results import write_json

matplotlib.use("Agg")
from matplotlib import pyplot

EXPERIMENT = {"mesh": "fandisk.off", "noise_percent": 0.75, "seed": 1, "input_points": 12_000, "output_points": 8_000}
RADII = (3, 4, 6)                        # of WLOP and EAR, in spacings
INPUT = "input"
POINTS_OF_MESH = 300_000                 # to draw it
LARGEST_ERROR = 0.5                      # % of the diagonal, in full color
VIEW_OF_PART, UP_OF_PART = (1, -1, 0.6), (0, 0, 1)
SIZE, DOTS_PER_INCH = (10.8, 8), 140    # inches, and pixels of each
RIGHT = 0.92                            # the rest of the width has the color bar


def halves(picture):
    return numpy.split(picture, 2, axis=1)


def read_off(path):
    """Vertices and triangles."""
    words = path.read_text(encoding="ascii").split()
    vertices, triangles = int(words[1]), int(words[2])
    numbers = numpy.array(words[4:4 + 3 * vertices + 4 * triangles], dtype=float)
    return numbers[:3 * vertices].reshape(-1, 3), numbers[3 * vertices:].reshape(-1, 4)[:, 1:].astype(int)


def points_on(vertices, triangles):
    """Points uniform by area, and the normals of the triangles they are on."""
    corners = vertices[triangles]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = numpy.linalg.norm(normals, axis=1)
    random = numpy.random.default_rng(1)
    chosen = random.choice(len(triangles), POINTS_OF_MESH, p=areas / areas.sum())
    weights = random.dirichlet((1, 1, 1), POINTS_OF_MESH)
    return numpy.einsum("ij,ijk->ik", weights, corners[chosen]), normals[chosen] / areas[chosen, None]


class Picture_bench(Poisson_bench):
    def __init__(self, build, scratch):
        super().__init__(build / "bin", scratch, 1)
        sys.path.insert(0, str(build / "python"))
        import cgal_l0
        self.cgal_l0 = cgal_l0
        self.result, self.surface = scratch / "result.ply", scratch / "surface.off"

    def mean_distance(self, mesh, source, method, points):
        """Of the Poisson mesh of a result, in % of the diagonal; infinite if there is none."""
        self.resample(source, method, points, self.result)
        made = self.reconstruct(self.result, self.surface)
        return self.mean_distance_of_mesh(self.surface, mesh) if made else float("inf")

    def draw(self, source, points, normals, **options):
        """The input, which gives all pictures the same camera, and points."""
        noisy = self.cgal_l0.read_points(source).points
        return self.cgal_l0.snapshot(noisy, points, normals, view=VIEW_OF_PART, up=UP_OF_PART, **options)

    def draw_mesh(self, mesh, source, surface):
        points, normals = points_on(*surface)
        drawn, values = self.scratch / "drawn.ply", self.scratch / "values"
        self.cgal_l0.write_points(drawn, points, normals)
        self.run("evaluate_point_set", drawn, mesh, "--values", values)
        errors = numpy.fromfile(values, dtype="<f4").reshape(-1, 2)[:, 0]    # beside densities
        return halves(self.draw(source, points, normals, feature_confidences=numpy.minimum(errors / LARGEST_ERROR, 1)))[1]

    def compare(self, mesh):
        """Pictures of the points and of the mesh of each method, and the numbers."""
        source = self.sample(mesh, EXPERIMENT)
        columns, numbers = [], {"experiment": EXPERIMENT, "radii": RADII, "largest_error_percent": LARGEST_ERROR, "methods": {}}
        for title, tried in candidates().items():
            points = EXPERIMENT["input_points" if title == INPUT else "output_points"]
            measured = {}
            for name, method in tried.items():
                measured[name] = self.mean_distance(mesh, source, method, points)
                if measured[name] == min(measured.values()):
                    best, result, surface = name, self.cgal_l0.read_points(self.result), read_off(self.surface)
            panel = self.draw(source, result.points, result.normals)
            columns.append((title, halves(panel)[0 if title == INPUT else 1], self.draw_mesh(mesh, source, surface), measured[best]))
            numbers["methods"][title] = {"best": best, "mean_distance_percent": measured}
            print(title, best, measured, file=sys.stderr, flush=True)
        return columns, numbers

    def draw_scan(self, path):
        """Before, with the normals of the file, and after."""
        scan = self.cgal_l0.read_points(path)
        positions, normals = self.cgal_l0.l0_resample_point_set(scan.points, select_percentage=100)
        return halves(self.cgal_l0.snapshot(scan.points, positions, normals, input_normals=scan.normals))


def candidates():
    """The variants of each method, by their names."""
    uniform = "--require-uniform-sampling"
    return {INPUT: {"": simple_filter("random")},    # all points of it, with normals as WLOP's get them
            "WLOP": {f"wlop_{radius}": wlop(radius) for radius in RADII}
            | {f"wlop_{radius}_uniform": wlop(radius, uniform) for radius in RADII},
            "EAR": {f"ear_{radius}": ear(radius) for radius in RADII}
            | {f"smoothed_ear_{radius}": ear(radius, "first") for radius in RADII},
            "ours": {"default": ours("default")}}


def without_white_rows(pictures):
    """Cropped all alike."""
    rows = numpy.flatnonzero((numpy.stack(pictures) < 255).any(axis=(0, 2, 3)))
    return [picture[rows[0]:rows[-1] + 1] for picture in pictures]


def draw_row(figure, top, height, titles, pictures):
    """Side by side, from the left edge of the figure to its color bar."""
    width = RIGHT / len(pictures)
    for k, (title, picture) in enumerate(zip(titles, without_white_rows(pictures))):
        axis = figure.add_axes([k * width, top - height, 0.98 * width, height])
        axis.set_axis_off()
        axis.imshow(picture)
        axis.set_title(title, fontsize=11, pad=4)


def compose(columns, scan):
    """The figure."""
    figure = pyplot.figure(figsize=SIZE, dpi=DOTS_PER_INCH)
    titles, points, meshes, distances = zip(*columns)
    draw_row(figure, 0.96, 0.29, titles, points)
    draw_row(figure, 0.62, 0.29, [f"its mesh, {d:.2f} %" if numpy.isfinite(d) else "no mesh" for d in distances], meshes)
    draw_row(figure, 0.27, 0.27, ["a scan", "ours"], scan)
    # As the renderer has it: light gray to red
    colors = LinearSegmentedColormap.from_list("errors", [(0.85, 0.85, 0.85), (0.85, 0, 0)])
    bar = figure.colorbar(ScalarMappable(Normalize(0, LARGEST_ERROR), colors), extend="max",
                          cax=figure.add_axes([RIGHT + 0.005, 0.34, 0.012, 0.27]))
    bar.set_label("distance to the truth, % of the diagonal", fontsize=8)
    bar.ax.tick_params(labelsize=8)
    buffer = io.BytesIO()
    figure.savefig(buffer)
    return Image.open(buffer).convert("RGB")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder, with the programs in bin/ and the Python package")
    parser.add_argument("demo_data", type=Path, help="the data folder of libcgal-demo")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        bench = Picture_bench(arguments.build.resolve(), Path(scratch))
        columns, numbers = bench.compare(mesh_of("fandisk", arguments.demo_data / "meshes"))
        scan = bench.draw_scan(arguments.demo_data / "points_3" / "hippo1.ply")
    compose(columns, scan).quantize(256, dither=Image.Dither.NONE).save(PICTURE, optimize=True)
    write_json(NUMBERS, {"command": command_line("draw_comparison.py", sys.argv[1:]), **numbers})


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"draw_comparison.py: {error}")
