#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resamples one file with CGAL's WLOP and EAR and with this package, and prints how long each took and, where the
true surface is known, how good its points are:

    beside_cgal.py BUILD INPUT.ply PICTURES --points M [--mesh TRUTH.off] [--view X,Y,Z]

PICTURES is the beginning of the names of pictures, one for each method, with the input on the left. Times are those of
one run, all threads, and tell little more than the order of magnitude; run_performance.py measures.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from quality_bench import Bench

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ear, ours, wlop

RADIUS = 4    # of WLOP and EAR, in spacings: the one that serves them best on most inputs
METHODS = {"WLOP": wlop(RADIUS), "EAR": ear(RADIUS), "ours": ours("default")}


def columns(evaluation):
    """What is told of points beside the true surface."""
    recall = (evaluation["features"] or {}).get("edge_recall")
    return {"distance, %": f"{evaluation['distance']['mean']:.3f}",
            "normals, degrees": f"{evaluation['normals']['mean_error_degrees']:.1f}",
            "edges found": "-" if recall is None else f"{recall:.0%}",
            "unevenness": f"{evaluation['uniformity']['spacing_variation']:.2f}"}


def table(rows):
    """Rows of the same keys, aligned."""
    lines = [list(rows[0]), *(list(row.values()) for row in rows)]
    widths = [max(map(len, column)) for column in zip(*lines)]
    return "\n".join("  ".join(cell.ljust(width) if k == 0 else cell.rjust(width)
                               for k, (cell, width) in enumerate(zip(line, widths))) for line in lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder, with the programs in bin/ and the Python package")
    parser.add_argument("input", type=Path, help="PLY file; only the positions are used")
    parser.add_argument("pictures", help="beginning of the names of the pictures")
    parser.add_argument("--points", type=int, required=True, help="of each result")
    parser.add_argument("--mesh", type=Path, help="OFF file of the true surface")
    parser.add_argument("--view", type=lambda text: tuple(map(float, text.split(","))), help="direction towards the eye")
    arguments = parser.parse_args()
    sys.path.insert(0, str(arguments.build.resolve() / "python"))
    import cgal_l0

    noisy = cgal_l0.read_points(arguments.input).points
    rows, seconds = [], {}
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build.resolve() / "bin", Path(scratch), os.cpu_count() or 1)
        path = Path(scratch) / "result.ply"
        for name, method in METHODS.items():
            seconds[name] = bench.resample(arguments.input, method, arguments.points, path)["wall_seconds"]
            result = cgal_l0.read_points(path)
            row = {"method": name, "points": str(len(result.points)), "seconds": f"{seconds[name]:.2f}"}
            if arguments.mesh:
                row |= columns(bench.evaluate(arguments.mesh, method, arguments.points, path))
            rows.append(row)
            cgal_l0.snapshot(noisy, result.points, result.normals, view=arguments.view,
                             path=f"{arguments.pictures}_{name.lower()}.png")
    print(f"{arguments.input.name}: {len(noisy)} points in")
    print(table(rows))
    print(", ".join(f"{name} took {seconds[name] / seconds['ours']:.0f} times as long as ours"
                    for name in METHODS if name != "ours"))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"beside_cgal.py: {error}")
