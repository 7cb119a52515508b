#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the result of l0_resample_point_set() beside those of CGAL's WLOP and EAR against the mesh they sample.

Each mesh is sampled with each noise and each seed, all methods get the same points, and each result is measured with
evaluate_point_set. There is a table for each mesh and noise. A number that is missing or not finite,
or a result with the wrong count, ends the run with an error.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import quality_tables
from quality_bench import Bench, argument_parser, command_line, load_raw, reuse, write_result

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ear, ours, wlop

METHODS = {
    "lor": ours("lor"),
    "alor": ours("alor"),
    "default": ours("default"),
    "wlop_4": wlop(4),
    "wlop_6": wlop(6),
    "wlop_4_uniform": wlop(4, "--require-uniform-sampling"),
    "wlop_6_uniform": wlop(6, "--require-uniform-sampling"),
    "ear_4": ear(4),
    "smoothed_ear_6": ear(6, "first"),
    "smoothed_ear_6_again": ear(6, "both"),
}


def parse_arguments():
    parser = argument_parser(__doc__, "a few thousand points, one noise")
    parser.add_argument("meshes", type=Path, nargs="+", metavar="mesh", help="OFF file to sample")
    parser.add_argument("--noise", type=float, nargs="+", default=[0.5, 1.0],
                        help="standard deviations, %% of the diagonal")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1], help="of the sampling; the tables show means")
    parser.add_argument("--input-points", type=int, default=110_000)
    parser.add_argument("--output-points", type=int, default=60_000)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--only", nargs="+", choices=METHODS, metavar="METHOD",
                        help="measures these anew and takes all others from an earlier run: " + ", ".join(METHODS))
    parser.add_argument("--mesh-origin", help="where the meshes are from, for the tables' heading")
    arguments = parser.parse_args()
    if arguments.small:
        arguments.input_points, arguments.output_points, arguments.noise = 4_000, 2_200, [0.5]
    if arguments.only and arguments.output is None:
        parser.error("--only needs the --output of a complete run")
    return arguments


def plan(arguments):
    """The experiments of this command line, each with its mesh, without measurements."""
    return [(mesh, {"mesh": mesh.name, "noise_percent": noise, "seed": seed, "input_points": arguments.input_points,
                    "output_points": arguments.output_points, "measurements": {}})
            for mesh in arguments.meshes for noise in arguments.noise for seed in arguments.seeds]


def main():
    arguments = parse_arguments()
    command = command_line("run_quality.py", sys.argv[1:])
    result = {"commands": [command], "mesh_origin": arguments.mesh_origin, "experiments": []}
    planned = plan(arguments)
    if arguments.only:
        previous = load_raw(arguments.output)
        reuse(previous, planned, METHODS, arguments.only)
        result["commands"] = [old for old in previous["commands"] if old != command] + [command]
        result["mesh_origin"] = arguments.mesh_origin or previous["mesh_origin"]
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), arguments.threads)
        for mesh, experiment in planned:
            source = bench.sample(mesh, experiment)
            methods = {name: METHODS[name] for name in arguments.only or METHODS}
            bench.measure_all(mesh, experiment, methods, lambda name, source=source: source)
            measured = experiment["measurements"]
            experiment["measurements"] = {name: measured[name] for name in METHODS if name in measured}
            result["experiments"].append(experiment)
    write_result(arguments.output, result, quality_tables.markdown(result))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"run_quality.py: {error}")
