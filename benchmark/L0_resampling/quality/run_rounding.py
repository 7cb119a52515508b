#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how far results move when nothing changes but roundings: coordinates are scaled by 1 plus or minus about 1e-9, in four ways.

With --device, the results of a CUDA device are compared with those of the CPU instead.
"""

import json
import sys
import tempfile
from pathlib import Path

from quality_bench import Bench, argument_parser, command_line, write_result
from quality_tables import NAMES, table

DATA = Path(__file__).resolve().parents[3] / "data"
SHAPES = ("bracket", "dodecahedron", "staircase", "thin_plate", "torus")
METHODS = ("lor", "alor", "default")
NOISES = (0, 0.5, 1.5)    # % of the diagonal
SEEDS = range(1, 4)
INPUT_POINTS, OUTPUT_POINTS = 12_000, 8_000
THOSE_OF_SCALED = "those of the same input scaled in four ways by 1 plus or minus about 1e-9, unequally along x, y and z"


def measure(bench, shape, noise, seed, factor, options):
    experiment = {"mesh": f"{shape}.off", "noise_percent": noise, "seed": seed, "input_points": round(factor * INPUT_POINTS),
                  "output_points": round(factor * OUTPUT_POINTS)}
    source = bench.sample(DATA / f"{shape}.off", experiment)
    for method in METHODS:
        experiment[method] = json.loads(bench.run("rounding_sensitivity", source, "--points", experiment["output_points"], "--method", method, *options))
    print(f"{shape}, noise {noise:g} %, seed {seed}", file=sys.stderr, flush=True)
    return experiment


def row(name, comparisons, samples):
    """`samples` is how many a result has."""
    def largest(key):
        return f"{max(comparison[key] for comparison in comparisons):.2g}"

    far = [comparison["number_far"] for comparison in comparisons]
    apart = sum(comparison["hausdorff"] > 0.05 for comparison in comparisons)
    return [name, str(len(comparisons)), largest("median"), largest("largest_but_a_thousandth"), largest("hausdorff"), str(apart),
            f"{1e6 * sum(far) / (samples * len(far)):.3g}"]


def markdown(result):
    experiments = result["experiments"]
    samples = experiments[0]["output_points"]
    noises = ", ".join(f"{noise:g}" for noise in sorted({run["noise_percent"] for run in experiments}))
    lines = ["# What roundings move", "", "Made by", "", *(f"    {command}" for command in result["commands"]), "",
             f"{len(SHAPES)} shapes with noise of {noises} % of the diagonal, {experiments[0]['input_points']} points in, "
             f"{samples} out. Each result of the CPU is compared with {'that of the CUDA device' if result['of_device'] else THOSE_OF_SCALED}. "
             "Distances are those from a sample to the nearest of the other result, in radii.", ""]
    rows = [row(NAMES[method], [one for run in experiments for one in run[method]], samples) for method in METHODS]
    header = ["method", "compared", "largest median", "largest but 1/1000", "largest Hausdorff distance", "of these beyond 0.05", "samples beyond 0.05, in a million"]
    return "\n".join([*lines, table(header, rows)])


def main():
    parser = argument_parser(__doc__, "a tenth of the points, without noise, one seed: to see that everything runs")
    parser.add_argument("--device", action="store_true", help="compare with the CUDA device, not with scaled coordinates")
    arguments = parser.parse_args()
    noises, seeds, factor = (NOISES[:1], SEEDS[:1], 0.1) if arguments.small else (NOISES, SEEDS, 1)
    options = ["--device"] if arguments.device else []
    result = {"commands": [command_line("run_rounding.py", sys.argv[1:])], "of_device": arguments.device, "experiments": []}
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), 1)
        result["experiments"] = [measure(bench, shape, noise, seed, factor, options) for shape in SHAPES for noise in noises for seed in seeds]
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
