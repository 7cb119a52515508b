#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the signed error of samples by their distance from the nearest sharp edge.

Where noise moves points of one face across an edge, a fit that takes them for points of the other
face is biased: to the outside at convex edges, to the inside at concave ones. There is a table for
each method.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from quality_bench import Bench, command_line, mesh_of, write_result
from quality_tables import table

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ear, ours, wlop

METHODS = {
    "default": ours("default"),
    "wlop_4": wlop(4),
    "smoothed_ear_4": ear("baseline_smoothed_ear", 4),
}
SHAPES = ("cube", "staircase", "dodecahedron", "fandisk")
NOISE_PERCENT = (0.3, 0.7, 1.2)
CUBE = """OFF
8 12 0
0 0 0
1 0 0
1 1 0
0 1 0
0 0 1
1 0 1
1 1 1
0 1 1
3 0 2 1
3 0 3 2
3 4 5 6
3 4 6 7
3 0 1 5
3 0 5 4
3 1 2 6
3 1 6 5
3 2 3 7
3 2 7 6
3 3 0 4
3 3 4 7
"""
FAR = 4  # % of the diagonal: bands from here on are far from edges
FEWEST_POINTS = 30  # in a band whose mean is shown
GOALS = {"near": 0.05, "far": 0.015}  # largest absolute bias of a band at a noise of 1.2 %


def mesh_file(shape, mesh_folder, scratch):
    if shape != "cube":
        return mesh_of(shape, mesh_folder)
    path = scratch / "cube.off"
    path.write_text(CUBE, encoding="ascii")
    return path


def refuse(constant):
    raise ValueError(f"{constant} is not a finite number")


def measure(bench, mesh, experiment, method):
    source = bench.sample(mesh, experiment)
    result = bench.scratch / "result.ply"
    line = bench.resample(source, method, experiment["output_points"], result)
    bias = json.loads(bench.run("evaluate_edge_bias", result, mesh), parse_constant=refuse)
    return {"cgal_version": line["cgal_version"], "bias": bias}


def bands_of(experiments, method, kind):
    """For each band its start, points and mean errors over experiments that differ by seed."""
    runs = [experiment["measurements"][method]["bias"][kind] for experiment in experiments]
    merged = []
    for bands in zip(*runs):
        count = sum(band["number_of_points"] for band in bands)
        means = {
            name: sum(band[name] * band["number_of_points"] for band in bands) / count
            if count
            else 0
            for name in ("signed_error", "absolute_error")
        }
        merged.append({"from_edge": bands[0]["from_edge"], "number_of_points": count, **means})
    return merged


def extreme_bias(bands, is_far):
    values = [
        abs(band["signed_error"])
        for band in bands
        if band["number_of_points"] >= FEWEST_POINTS and (band["from_edge"] >= FAR) == is_far
    ]
    return max(values, default=None)


def method_table(groups, method, edges):
    rows = []
    for (shape, noise), experiments in groups.items():
        for kind in ("convex", "concave"):
            bands = bands_of(experiments, method, kind)
            if not any(band["number_of_points"] for band in bands):
                continue
            total = sum(band["number_of_points"] for band in bands)
            error = sum(band["absolute_error"] * band["number_of_points"] for band in bands) / total
            cells = [
                f"{band['signed_error']:+.3f}" if band["number_of_points"] >= FEWEST_POINTS else "-"
                for band in bands
            ]
            rows.append([f"{shape}, {noise:g} %, {kind}", *cells, f"{error:.4f}"])
    ranges = [f"{low:g} to {high:g} %" for low, high in zip(edges, edges[1:])] + [
        f"beyond {edges[-1]:g} %"
    ]
    return table(["shape, noise, nearest edge", *ranges, "mean distance"], rows)


def goal_lines(groups):
    noise = max(noise for _, noise in groups)
    rows = []
    for (shape, of_row), experiments in groups.items():
        if of_row != noise:
            continue
        cells = [shape]
        for place in GOALS:
            values = [
                extreme_bias(bands_of(experiments, "default", kind), place == "far")
                for kind in ("convex", "concave")
            ]
            cells.append(f"{max((value for value in values if value is not None), default=0):.3f}")
        rows.append(cells)
    return (
        f"## Largest bias of the default method at a noise of {noise:g} %\n\n"
        f"Of the bands below and beyond {FAR} % from an edge. The goals at a noise of 1.2 % are "
        f"{GOALS['near']} and {GOALS['far']}.\n\n"
        + table(["shape", "near an edge", "far from edges"], rows)
    )


def markdown(result):
    groups = {}
    for experiment in result["experiments"]:
        groups.setdefault(
            (experiment["mesh"].split(".")[0], experiment["noise_percent"]), []
        ).append(experiment)
    first = result["experiments"][0]
    edges = [band["from_edge"] for band in first["measurements"]["default"]["bias"]["convex"]]
    commands = "".join(f"    {command}\n" for command in result["commands"])
    version = first["measurements"]["default"]["cgal_version"]
    sizes = f"{first['input_points']} points in, {first['output_points']} out"
    parts = [
        f"""# Bias near sharp edges

Made by

{commands}
with CGAL {version}: {sizes}. Mean signed distance to the mesh in % of the diagonal, positive
outside, by the distance of the foot from the nearest edge of 30 degrees or more. The last column is
the mean distance without sign. Bands with fewer than {FEWEST_POINTS} points are left out.
""",
        goal_lines(groups),
    ]
    for method in first["measurements"]:
        parts += [f"## {method}\n", method_table(groups, method, edges)]
    return "\n".join(parts)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument(
        "meshes", type=Path, metavar="mesh_folder", help="has fandisk.off of libcgal-demo"
    )
    parser.add_argument(
        "--output",
        type=Path,
        metavar="FOLDER/NAME",
        help="what to write, see common/results.py; else the tables are printed",
    )
    parser.add_argument("--shapes", nargs="+", choices=SHAPES, default=SHAPES)
    parser.add_argument(
        "--noise",
        type=float,
        nargs="+",
        default=NOISE_PERCENT,
        help="standard deviations, %% of the diagonal",
    )
    parser.add_argument("--methods", nargs="+", choices=METHODS, default=list(METHODS))
    parser.add_argument(
        "--seeds",
        type=int,
        nargs="+",
        default=[1, 2],
        help="of the sampling; the tables show means",
    )
    parser.add_argument(
        "--small",
        action="store_true",
        help="the cube with one noise and 2000 points, to see that all runs",
    )
    arguments = parser.parse_args()
    input_points, output_points = 12_000, 8_000
    if arguments.small:
        arguments.shapes, arguments.noise, arguments.seeds = ["cube"], [1.2], [1]
        input_points, output_points = 2_000, 1_300
    if "default" not in arguments.methods:
        parser.error("--methods needs default")
    result = {"commands": [command_line("run_edge_bias.py", sys.argv[1:])], "experiments": []}
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), 1)
        for shape in arguments.shapes:
            mesh = mesh_file(shape, arguments.meshes, bench.scratch)
            for noise in arguments.noise:
                for seed in arguments.seeds:
                    experiment = {
                        "mesh": mesh.name,
                        "noise_percent": noise,
                        "seed": seed,
                        "input_points": input_points,
                        "output_points": output_points,
                        "measurements": {},
                    }
                    for name in arguments.methods:
                        experiment["measurements"][name] = measure(
                            bench, mesh, experiment, METHODS[name]
                        )
                    result["experiments"].append(experiment)
                    print(f"{shape}, {noise:g} %, seed {seed}", file=sys.stderr, flush=True)
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as failure:
        sys.exit(f"run_edge_bias.py: {failure}")
