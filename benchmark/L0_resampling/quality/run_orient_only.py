#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the sides that l0_orient_normals() and CGAL's mst_orient_normals() give to normals.

Both get the same points and the same normals, estimated by pca_estimate_normals() and with signs by
chance: of closed meshes with noise, of some of them with uneven spacing, and of scenes that were
scanned. The right side of a normal is that of the nearest face of the mesh. Of an open scene, whose
outside none of the two can know, the side is taken that makes fewer wrong. OUTPUT.md has a row for
each input.
"""

import json
import sys
import tempfile
from pathlib import Path

from quality_bench import Bench, command_line
from quality_tables import table
from run_sides import SCENES, SHAPES, meshes_of, print_or_write, read_arguments

SHAPES_OF_UNEVEN_SPACING = ("bracket", "torus", "armadillo", "camel", "elephant", "fandisk", "hand", "turbine")
DENSITY_GRADIENT = 10
THEIRS, OURS = "mst_orient_normals", "l0_orient_normals"


def compare(bench, mesh, points, is_closed=True):
    result = json.loads(bench.run("compare_orientations", points, mesh))
    for name in (THEIRS, OURS):
        wrong = result[name]["wrong_share"]
        result[name]["wrong"] = 100 * (wrong if is_closed else min(wrong, 1 - wrong))
    return result


def compare_meshes(bench, meshes, number_of_points, **sampling):
    rows = {}
    for mesh in meshes:
        experiment = {"input_points": number_of_points, "noise_percent": 0.3, "seed": 1} | sampling
        rows[mesh.stem] = compare(bench, mesh, bench.sample(mesh, experiment))
        print(mesh.stem, rows[mesh.stem], file=sys.stderr, flush=True)
    return rows


def compare_scenes(bench, scenes):
    rows = {}
    for scene, scanner, views in scenes:
        scan = bench.scratch / "scan"
        bench.run("scan_scene", scene, scan, "--scanner", scanner, "--views", views, "--columns", 300)
        rows[f"{scene}, {scanner}"] = compare(bench, f"{scan}_truth.off", f"{scan}.ply", is_closed=False)
    return rows


def times_faster(row, clock):
    return row[THEIRS][clock] / row[OURS][clock]


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def summary(name, rows):
    differences = [row[OURS]["wrong"] - row[THEIRS]["wrong"] for row in rows.values()]
    both_right = sum(row[OURS]["wrong"] == 0 == row[THEIRS]["wrong"] for row in rows.values())
    return [name, str(len(rows)),
            *(f"{mean(row[method]['wrong'] for row in rows.values()):.2f}" for method in (OURS, THEIRS)),
            str(sum(d < 0 for d in differences)),
            f"{sum(d == 0 for d in differences)} ({both_right})",
            str(sum(d > 0 for d in differences)),
            *(f"{mean(times_faster(row, clock) for row in rows.values()):.1f}"
              for clock in ("seconds", "processor_seconds"))]


def markdown(command, groups):
    parts = [f"""# Orientation alone, beside CGAL's

Made by

    {command}

The same estimated normals with signs by chance are oriented by `l0_orient_normals()` and by
`mst_orient_normals()`, which runs on one thread. Wrong are those that point away from the side of the
nearest face; of a scene, which is open, those on the side of fewer. Points on two sheets that noise has
made one have no right side. Parts of a scene that no points connect, such as the table of the room and
the wall behind it, are on each other's side by chance, with both functions. Times of processor add up
all threads.
""",
             table(["inputs", "number", "wrong, mean, %", "CGAL's", "fewer wrong", "equal (none wrong)", "more wrong",
                    "times as fast", "in processor time"],
                   [summary(name, rows) for name, rows in groups.items()])]
    for name, rows in groups.items():
        parts += [f"## {name}\n",
                  table(["input", "points", "wrong, %", "CGAL's", "times as fast", "in processor time"],
                        [[shape, str(row["points"]), f"{row[OURS]['wrong']:.3f}", f"{row[THEIRS]['wrong']:.3f}",
                          f"{times_faster(row, 'seconds'):.1f}", f"{times_faster(row, 'processor_seconds'):.1f}"]
                         for shape, row in rows.items()])]
    return "\n".join(parts)


def main():
    arguments = read_arguments(__doc__)
    shapes, uneven, scenes, number_of_points = SHAPES, SHAPES_OF_UNEVEN_SPACING, SCENES, 50000
    if arguments.small:
        shapes, uneven, scenes, number_of_points = ("torus", "bracket"), ("torus",), SCENES[3:4], 3000
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(arguments.build / "bin", Path(folder), threads=2)
        groups = {
            "closed meshes, noise 0.3 %": compare_meshes(bench, meshes_of(shapes, arguments), number_of_points),
            f"density gradient {DENSITY_GRADIENT}, no noise": compare_meshes(
                bench, meshes_of(uneven, arguments), number_of_points, noise_percent=0, density_gradient=DENSITY_GRADIENT),
            "scenes": compare_scenes(bench, scenes),
        }
    print_or_write(markdown(command_line("run_orient_only.py", sys.argv[1:]), groups), arguments)


if __name__ == "__main__":
    main()
