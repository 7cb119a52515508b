#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how many normals are on the right side, and how many were expected to be.

Closed meshes with noise, views of them by a range camera, and scanned scenes with and without the
viewpoints of the scanner are resampled by the tool. The right side of a normal is that of the
nearest face of the mesh; what the tool expects is `right_side_share` of its report. The tables have a
row for each input.
"""

import json
import sys
import tempfile
from pathlib import Path

from quality_bench import Bench, argument_parser, command_line, mesh_of, write_result
from quality_tables import table

SHAPES = (
    "bracket", "dodecahedron", "staircase", "thin_plate", "torus",
    "anchor_dense", "armadillo", "bones", "bull", "camel", "cheese", "couplingdown", "cow",
    "diplodocus", "dragknob", "eight", "elephant", "fandisk", "femur", "hand", "homer", "knot1",
    "man", "mpi_triang", "part", "pinion", "rotor", "spool", "star", "triceratops", "tripod",
    "turbine",
)
SHAPES_OF_VIEWS = (
    "anchor_dense", "armadillo", "bones", "bracket", "bull", "camel", "cheese", "cow",
    "dodecahedron", "elephant", "fandisk", "hand", "homer", "man", "triceratops", "turbine",
)
NOISE_PERCENT = (0, 0.3, 0.7, 1.2)
SCENES = (
    ("street", "spinning", 1), ("street", "terrestrial", 1), ("forest", "terrestrial", 1),
    ("room", "terrestrial", 1), ("room", "structured-light", 3),
)
CLOSE = 3  # points of a hundred


def resample_and_measure(bench, mesh, points, options, apart=0):
    """Percentages of normals: expected to be right, right, and wrong where no sheet is within `apart`."""
    result, report = bench.scratch / "result.ply", bench.scratch / "report.json"
    bench.run("l0_resample", points, result, "--force", "--quiet", "--json", report, *options)
    expected = json.loads(report.read_text(encoding="utf-8"))["resampling"]["right_side_share"]
    normals = json.loads(bench.run("evaluate_point_set", result, mesh, "--apart", apart))["normals"]
    wrong_apart = normals["share_inwards_where_apart"]
    return (100 * expected, 100 - 100 * normals["share_inwards"],
            None if wrong_apart is None else 100 * wrong_apart)


def measure_meshes(bench, meshes, noises):
    rows = []
    for mesh in meshes:
        for noise in noises:
            source = bench.sample(mesh, {"input_points": 12000, "noise_percent": noise, "seed": 1})
            rows.append((f"{mesh.stem}, noise {noise:g} %",
                         *resample_and_measure(bench, mesh, source, ["--points", 8000], 2 * noise)))
    return rows


def measure_views(bench, meshes):
    rows = []
    for mesh in meshes:
        for views in (1, 2):
            bench.run("scan_scene", mesh, bench.scratch / "scan", "--scanner", "range-camera",
                      "--views", views, "--columns", 160)
            rows.append((f"{mesh.stem}, views {views}",
                         *resample_and_measure(bench, mesh, bench.scratch / "scan.ply",
                                               ["--percentage", 60])))
    return rows


def measure_scenes(bench, scenes, with_viewpoints):
    rows = []
    for scene, scanner, views in scenes:
        scan = bench.scratch / "scan"
        bench.run("scan_scene", scene, scan, "--scanner", scanner, "--views", views, "--columns", 300)
        options = []
        if with_viewpoints:
            options = ["--viewpoints", f"{scan}_views.txt", "--view-property", "view"]
        rows.append((f"{scene}, {scanner}, views {views}",
                     *resample_and_measure(bench, f"{scan}_truth.off", f"{scan}.ply", options)))
    return rows


def summary(name, rows):
    close = sum(abs(expected - right) <= CLOSE for _, expected, right, _ in rows)
    overstated = sum(expected > 97 and right < 90 for _, expected, right, _ in rows)
    wrong = sum(100 - right for _, _, right, _ in rows) / len(rows)
    apart = [wrong_apart for *_, wrong_apart in rows if wrong_apart is not None]
    few = sum(wrong_apart <= 1 for wrong_apart in apart)
    return [name, str(len(rows)), f"{wrong:.2f}", f"{sum(apart) / len(apart):.2f}", f"{few} of {len(apart)}",
            str(close), str(overstated)]


def markdown(command, groups):
    parts = [
        f"""# Sides of normals

Made by

    {command}

12000 points to 8000 of closed meshes; views of a range camera; scenes by a scanner. The right side of
a normal is that of the nearest face. Two sheets that noise has made one have no right side: half of
their normals count as wrong (thin_plate at 1.2 %, rotor, turbine, parts of bones and cheese). Apart
are points whose sheet is farther than two standard deviations of the noise from the next one.
""",
        table(["inputs", "number", "wrong, mean, %", "wrong where apart, mean, %",
               "at most 1 % wrong where apart", f"expected within {CLOSE} points",
               "more than 97 % expected, less than 90 % right"],
              [summary(name, rows) for name, rows in groups.items()]),
    ]
    for name, rows in groups.items():
        parts += [f"## {name}\n",
                  table(["input", "expected, %", "right, %", "wrong where apart, %"],
                        [[row, f"{expected:.1f}", f"{right:.1f}",
                          "" if wrong_apart is None else f"{wrong_apart:.1f}"]
                         for row, expected, right, wrong_apart in rows])]
    return "\n".join(parts)


def main():
    parser = argument_parser(__doc__, "two shapes of our own, one noise, one scene; needs no meshes")
    parser.add_argument("meshes", type=Path, metavar="mesh_folder", help="has the meshes of libcgal-demo")
    arguments = parser.parse_args()
    shapes, shapes_of_views, noises, scenes = SHAPES, SHAPES_OF_VIEWS, NOISE_PERCENT, SCENES
    if arguments.small:
        shapes, shapes_of_views, noises, scenes = ("torus", "bracket"), ("torus",), (0.3,), SCENES[3:4]
    meshes, meshes_of_views = ([mesh_of(shape, arguments.meshes) for shape in named]
                               for named in (shapes, shapes_of_views))
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.build / "bin", Path(folder), threads=2)
        groups = {
            "closed meshes": measure_meshes(bench, meshes, noises),
            "views of meshes, without a hint": measure_views(bench, meshes_of_views),
            "scenes, with viewpoints": measure_scenes(bench, scenes, True),
            "scenes, without a hint": measure_scenes(bench, scenes, False),
        }
    text = markdown(command_line("run_sides.py", sys.argv[1:]), groups)
    write_result(arguments.output, groups, text)


if __name__ == "__main__":
    main()
