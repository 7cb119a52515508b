#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the default method with the best that CGAL's pipelines reach, on many shapes and kinds of input.

Each shape is sampled with each noise, and each of these once more with outliers and with a density gradient. Where there
are outliers, CGAL's pipelines get the points that its remove_outliers() leaves, which is told their share; ours gets all.
The tables have a row for each input, and what is met of the goals.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import comparison_tables
from quality_bench import (CGAL_SHAPES, OWN_SHAPES, Bench, command_line, load_raw, mesh_of, reuse, reuse_known,
                           write_result)

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ear, ours, wlop

NOISE_PERCENT = (0, 0.25, 0.5, 1, 1.5)
OUTLIERS_PERCENT = 5
DENSITY_GRADIENT = 10


def methods(radii):
    chosen = {"default": ours("default")}
    for radius in radii:
        chosen[f"wlop_{radius:g}"] = wlop(radius)
        chosen[f"wlop_{radius:g}_uniform"] = wlop(radius, "--require-uniform-sampling")
        chosen[f"ear_{radius:g}"] = ear("baseline_ear", radius)
        chosen[f"smoothed_ear_{radius:g}"] = ear("baseline_smoothed_ear", radius)
    return chosen


def plan(arguments):
    """The experiments of this command line, each with its mesh, without measurements."""
    inputs = [(noise, outliers, gradient)
              for outliers, gradient in ((0, 1), (OUTLIERS_PERCENT, 1), (0, DENSITY_GRADIENT))
              for noise in arguments.noise]
    return [(mesh_of(shape, arguments.meshes),
             {"mesh": f"{shape}.off", "noise_percent": noise, "outliers_percent": outliers,
              "density_gradient": gradient, "seed": seed, "input_points": arguments.input_points,
              "output_points": arguments.output_points, "measurements": {}})
            for shape in arguments.shapes for noise, outliers, gradient in inputs for seed in arguments.seeds]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("meshes", type=Path, metavar="mesh_folder", help="has the meshes of libcgal-demo")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the tables are printed")
    parser.add_argument("--shapes", nargs="+", choices=CGAL_SHAPES + OWN_SHAPES, default=CGAL_SHAPES + OWN_SHAPES)
    parser.add_argument("--noise", type=float, nargs="+", default=NOISE_PERCENT,
                        help="standard deviations, %% of the diagonal")
    parser.add_argument("--radii", type=float, nargs="+", default=[4, 6], help="of CGAL's pipelines, in spacings")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1], help="of the sampling; the tables show means")
    parser.add_argument("--input-points", type=int, default=12_000)
    parser.add_argument("--output-points", type=int, default=8_000)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--only-ours", action="store_true",
                        help="takes the figures of CGAL's pipelines from an earlier run")
    parser.add_argument("--note", help="what a reader of this run has to know, for the tables' heading")
    parser.add_argument("--keep-baselines", action="store_true",
                        help="the same, but measures these too on inputs that it lacks")
    parser.add_argument("--full", action="store_true",
                        help="100000 points to 66000, three seeds, radii 4, 6 and 8: takes a night")
    parser.add_argument("--small", action="store_true",
                        help="one shape of our own, one noise, one radius, 2000 points to 1300")
    arguments = parser.parse_args()
    if arguments.full:
        arguments.input_points, arguments.output_points = 100_000, 66_000
        arguments.seeds, arguments.radii = [1, 2, 3], [4, 6, 8]
    if arguments.small:
        arguments.input_points, arguments.output_points = 2_000, 1_300
        arguments.shapes, arguments.noise, arguments.radii = ["staircase"], [0.5], [4]
    if (arguments.only_ours or arguments.keep_baselines) and arguments.output is None:
        parser.error("--only-ours and --keep-baselines need the --output of an earlier run")
    return arguments


def main():
    arguments = parse_arguments()
    command = command_line("run_comparison.py", sys.argv[1:])
    result = {"commands": [command], "experiments": []}
    if arguments.note:
        result["note"] = f"\n{arguments.note}\n"
    planned, compared = plan(arguments), methods(arguments.radii)
    if arguments.only_ours or arguments.keep_baselines:
        previous = load_raw(arguments.output)
        if arguments.only_ours:
            reuse(previous, planned, compared, ["default"])
        else:
            reuse_known(previous, planned, compared, ["default"])
        result["commands"] = [old for old in previous["commands"] if old != command] + [command]
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), arguments.threads)
        for mesh, experiment in planned:
            source = bench.sample(mesh, experiment)
            measured = {name: method for name, method in compared.items()
                        if name == "default" or name not in experiment["measurements"]}
            cleaned = source
            if experiment["outliers_percent"] > 0 and len(measured) > 1:
                cleaned = bench.remove_outliers(source, experiment["outliers_percent"])
            bench.measure_all(mesh, experiment, measured,
                              lambda name, all_points=source, rest=cleaned: all_points if name == "default" else rest)
            result["experiments"].append(experiment)
            if arguments.output is not None:   # a long run that fails leaves what it has
                write_result(arguments.output, result, comparison_tables.markdown(result))
    if arguments.output is None:
        write_result(None, result, comparison_tables.markdown(result))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"run_comparison.py: {error}")
