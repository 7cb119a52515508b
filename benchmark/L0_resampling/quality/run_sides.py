#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how many normals are on the right side, and how many were expected to be.

Closed meshes with noise, views of them by a range camera, and scanned scenes with and without the
viewpoints of the scanner are resampled by the tool. The right side of a normal is that of the
nearest face of the mesh; what the tool expects is `right_side_share` of its report. OUTPUT.md has a
row for each input.
"""

import argparse
import json
import sys
import tempfile
from pathlib import Path

from quality_bench import Bench, command_line
from quality_tables import table

OWN_SHAPES = ("bracket", "dodecahedron", "staircase", "thin_plate", "torus")
SHAPES = OWN_SHAPES + (
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


def resample_and_measure(bench, mesh, points, options):
    """The percentages of normals that are right, and that were expected to be."""
    result, report = bench.scratch / "result.ply", bench.scratch / "report.json"
    bench.run("l0_resample", points, result, "--force", "--quiet", "--json", report, *options)
    expected = json.loads(report.read_text(encoding="utf-8"))["resampling"]["right_side_share"]
    evaluation = json.loads(bench.run("evaluate_point_set", result, mesh))
    return 100 * expected, 100 - 100 * evaluation["normals"]["share_inwards"]


def measure_meshes(bench, mesh_of, shapes, noises):
    rows = []
    for shape in shapes:
        for noise in noises:
            source = bench.sample(mesh_of(shape), {"input_points": 12000, "noise_percent": noise, "seed": 1})
            rows.append((f"{shape}, noise {noise:g} %",
                         *resample_and_measure(bench, mesh_of(shape), source, ["--points", 8000])))
    return rows


def measure_views(bench, mesh_of, shapes):
    rows = []
    for shape in shapes:
        for views in (1, 2):
            bench.run("scan_scene", mesh_of(shape), bench.scratch / "scan", "--scanner", "range-camera",
                      "--views", views, "--columns", 160)
            rows.append((f"{shape}, views {views}",
                         *resample_and_measure(bench, mesh_of(shape), bench.scratch / "scan.ply",
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
    close = sum(abs(expected - right) <= CLOSE for _, expected, right in rows)
    overstated = sum(expected > 97 and right < 90 for _, expected, right in rows)
    wrong = sum(100 - right for _, _, right in rows) / len(rows)
    return [name, str(len(rows)), f"{wrong:.2f}", str(close), str(overstated)]


def markdown(command, groups):
    parts = [
        f"""# Sides of normals

Made by

    {command}

12000 points to 8000 of closed meshes; views of a range camera; scenes by a scanner. The right side of
a normal is that of the nearest face. Two sheets that noise has made one have no right side: half of
their normals count as wrong (thin_plate at 1.2 %, rotor, turbine, parts of bones and cheese).
""",
        table(["inputs", "number", "wrong, mean, %", f"expected within {CLOSE} points",
               "more than 97 % expected, less than 90 % right"],
              [summary(name, rows) for name, rows in groups.items()]),
    ]
    for name, rows in groups.items():
        parts += [f"## {name}\n",
                  table(["input", "expected, %", "right, %"],
                        [[row, f"{expected:.1f}", f"{right:.1f}"] for row, expected, right in rows])]
    return "\n".join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("meshes", type=Path, metavar="mesh_folder", help="has the meshes of libcgal-demo")
    parser.add_argument("--output", type=Path, help="writes OUTPUT.md; else the tables are printed")
    parser.add_argument("--small", action="store_true",
                        help="two shapes of our own, one noise, one scene; needs no meshes")
    arguments = parser.parse_args()
    own = Path(__file__).resolve().parents[3] / "data"

    def mesh_of(shape):
        return (own if shape in OWN_SHAPES else arguments.meshes) / f"{shape}.off"

    shapes, shapes_of_views, noises, scenes = SHAPES, SHAPES_OF_VIEWS, NOISE_PERCENT, SCENES
    if arguments.small:
        shapes, shapes_of_views, noises, scenes = ("torus", "bracket"), ("torus",), (0.3,), SCENES[3:4]
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.build / "bin", Path(folder), threads=2)
        groups = {
            "closed meshes": measure_meshes(bench, mesh_of, shapes, noises),
            "views of meshes, without a hint": measure_views(bench, mesh_of, shapes_of_views),
            "scenes, with viewpoints": measure_scenes(bench, scenes, True),
            "scenes, without a hint": measure_scenes(bench, scenes, False),
        }
    text = markdown(command_line("run_sides.py", sys.argv[1:]), groups)
    if arguments.output:
        Path(f"{arguments.output}.md").write_text(text, encoding="utf-8")
    else:
        print(text)


if __name__ == "__main__":
    main()
