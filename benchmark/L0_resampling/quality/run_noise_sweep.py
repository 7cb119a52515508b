#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures whether the estimate of the noise, and with it the result, follows a noise that grows in steps.

Each shape is sampled with every noise, for several numbers of points and conditions. The estimated noise is compared with the true one. A radius that
falls while the noise rises, a distance that more than doubles from one noise to the next, and one that is larger than the input's own are cliffs.
"""

import statistics
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from quality_bench import Bench, argument_parser, command_line, mesh_of, write_result
from quality_tables import table

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ours, wlop

SHAPES = ("fandisk", "staircase", "joint", "camel", "elephant", "thin_plate", "torus")
NOISES = (0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.2, 1.4, 1.7, 2, 2.5, 3)    # % of the diagonal
CONDITIONS = {"60000 points": {"input_points": 60_000}, "10000 points": {"input_points": 10_000},
              "60000 points, gradient 3": {"input_points": 60_000, "density_gradient": 3},
              "60000 points, outliers 5 %": {"input_points": 60_000, "outliers_percent": 5}}
WLOP_POINTS = 10_000    # so many points and no more WLOP runs on
LARGEST_ERROR = 1.15    # of an estimate that is right, as a factor


def measure(bench, mesh, condition, noise):
    """One row: of our result, of the input, and of WLOP where there are few points."""
    experiment = {"mesh": mesh.name, "noise_percent": noise, "seed": 1, "density_gradient": 1, "outliers_percent": 0, **condition}
    experiment["output_points"] = experiment["input_points"] // 2
    source, result = bench.sample(mesh, experiment), bench.scratch / "result.ply"
    report = bench.resample(source, ours("default"), experiment["output_points"], result)["report"]
    evaluation = bench.evaluate(mesh, ours("default"), experiment["output_points"], result)
    true_noise = noise / 100 * evaluation["diagonal_length"]
    row = {**experiment, "estimate_per_truth": report["estimated_noise"] / true_noise,
           "radius_percent": 100 * report["neighbor_radius"] / evaluation["diagonal_length"],
           "distance": evaluation["distance"]["mean"], "normal_error": evaluation["normals"]["mean_error_degrees"],
           "outliers": report["number_of_outliers"] - experiment["outliers_percent"] / 100 * experiment["input_points"],
           "unexplained": report["number_of_unexplained_samples"] / experiment["output_points"]}
    # of points whose coordinates are off by the noise, the mean distance from a plane
    row["input_distance"] = noise * (2 / 3.141592653589793) ** 0.5
    if experiment["input_points"] <= WLOP_POINTS and not experiment["outliers_percent"]:
        method = wlop(6, "--require-uniform-sampling")
        bench.resample(source, method, experiment["output_points"], result)
        row["wlop_distance"] = bench.evaluate(mesh, method, experiment["output_points"], result)["distance"]["mean"]
    print(f"{mesh.stem}, {noise} %: {row['estimate_per_truth']:.2f} of the noise, distance {row['distance']:.4f} %", file=sys.stderr, flush=True)
    return row


def cliffs(rows):
    """How often in rows of one shape and condition the radius falls, the distance doubles, or is larger than that of the input."""
    pairs = list(zip(rows, rows[1:]))
    return (sum(b["radius_percent"] < 0.98 * a["radius_percent"] for a, b in pairs),
            sum(b["distance"] > 2 * a["distance"] and b["noise_percent"] < 2 * a["noise_percent"] for a, b in pairs),
            sum(row["distance"] > row["input_distance"] for row in rows))


def summary(rows_of):
    rows = []
    for condition in dict.fromkeys(condition for condition, _ in rows_of):
        groups = [group for (name, _), group in rows_of.items() if name == condition]
        ratios = [row["estimate_per_truth"] for group in groups for row in group]
        wrong = sum(not 1 / LARGEST_ERROR < ratio < LARGEST_ERROR for ratio in ratios)
        found = [sum(numbers) for numbers in zip(*map(cliffs, groups))]
        rows.append([condition, str(len(ratios)), str(wrong), f"{statistics.median(ratios):.2f}", *map(str, found)])
    return table(["input", "estimates", "off by more than 15 %", "median over truth", "radius falls", "distance doubles",
                  "farther than the input"], rows)


def markdown(result):
    rows_of = {}
    for row in result["rows"]:
        rows_of.setdefault((row["condition"], row["mesh"]), []).append(row)
    lines = ["# Noise that grows", "", "Made by", "", *(f"    {command}" for command in result["commands"]), "",
             "The estimated noise over the true one, the radius, the mean distance to the surface and the normal error of half as many points; lengths in % "
             "of the diagonal. Outliers are those left out beyond the ones put in. The share of unexplained samples is that of the report.", "", summary(rows_of)]
    for (condition, mesh), rows in rows_of.items():
        with_wlop = all("wlop_distance" in row for row in rows)
        header = ["noise, %", "estimate / truth", "radius", "distance", "normal error", "outliers", "unexplained, %", *(["WLOP's distance"] if with_wlop else [])]
        lines += [f"## {mesh}, {condition}", "",
                  table(header, [[f"{row['noise_percent']:g}", f"{row['estimate_per_truth']:.2f}", f"{row['radius_percent']:.2f}", f"{row['distance']:.4f}",
                                  f"{row['normal_error']:.2f}", f"{row['outliers']:.0f}", f"{100 * row['unexplained']:.1f}",
                                  *([f"{row['wlop_distance']:.4f}"] if with_wlop else [])] for row in rows])]
    return "\n".join(lines)


def main():
    parser = argument_parser(__doc__, "few points on one shape of ours; fails if there is a cliff")
    parser.add_argument("meshes", type=Path, help="folder of CGAL's demo data with the shapes that are not ours")
    parser.add_argument("--jobs", type=int, default=1, help="so many shapes at a time")
    arguments = parser.parse_args()
    shapes, noises, conditions = SHAPES, NOISES, CONDITIONS
    if arguments.small:
        shapes, noises, conditions = ("staircase",), (0.5, 0.9, 1.4, 2, 2.5), {"8000 points": {"input_points": 8_000}}
    result = {"commands": [command_line("run_noise_sweep.py", sys.argv[1:])], "rows": []}

    def rows_of(name, shape):
        with tempfile.TemporaryDirectory() as scratch:
            bench, mesh = Bench(arguments.build / "bin", Path(scratch), 1), mesh_of(shape, arguments.meshes)
            return [{"condition": name, **measure(bench, mesh, conditions[name], noise)} for noise in noises]

    with ThreadPoolExecutor(arguments.jobs) as pool:
        for rows in pool.map(rows_of, *zip(*((name, shape) for name in conditions for shape in shapes))):
            result["rows"] += rows
    write_result(arguments.output, result, markdown(result))
    if arguments.small:
        if any(cliffs(result["rows"])):
            sys.exit("run_noise_sweep: there are cliffs")


if __name__ == "__main__":
    main()
