#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs l0_resample_point_set() beside what people use in its place, on the same points: how many
points a core takes in a second, and how far the result is from the surface.

Methods that keep the number of points get a random subset of their result. Normals of methods that
have none are not timed, nor is their orientation. The methods of PCL are run if it was found when
the programs were built, as Debian's package libpcl-dev.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

from run_performance import Bench, machine

sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("common", "methods",
                                                                              "quality")]
from methods import EAR_EXAMPLE
from quality_bench import argument_parser, command_line, parse_finite, write_result
from quality_tables import table

# Name, program, options, and the phase that is timed if not all of it is
METHODS = (
    ("default", "run_l0", ("--method", "default"), None),
    ("LOR", "run_l0", ("--method", "lor"), None),
    ("CGAL's WLOP", "baseline_wlop", (), "wlop"),
    ("CGAL's EAR", "baseline_ear", EAR_EXAMPLE, None),
    ("CGAL's jet smoothing, 24 neighbors", "baseline_filter",
     ("--filter", "jet", "--neighbors", 24), "jet"),
    ("CGAL's jet smoothing, 240 neighbors", "baseline_filter",
     ("--filter", "jet", "--neighbors", 240), "jet"),
    ("CGAL's bilateral smoothing, 60 neighbors", "baseline_filter",
     ("--filter", "bilateral", "--neighbors", 60), "bilateral"),
    ("PCL's moving least squares, 4 spacings", "baseline_mls", ("--radius-in-spacings", 4), "mls"),
    ("PCL's moving least squares, 8 spacings", "baseline_mls", ("--radius-in-spacings", 8), "mls"),
)


def measure(bench, mesh, source, arguments):
    rows = []
    for name, program, options, phase in METHODS:
        if not (bench.programs / program).exists():
            print(f"{name} was not built", file=sys.stderr)
            continue
        line = bench.run(program, source, arguments.output_points, "--threads", arguments.threads,
                         *options, exact=program != "baseline_ear")
        seconds = (line["wall_seconds"] if phase is None else
                   next(one["wall_seconds"] for one in line["phases"] if one["name"] == phase))
        evaluation = parse_finite(subprocess.run(
            [bench.programs / "evaluate_point_set", bench.scratch / f"{program}.ply", mesh],
            check=True, stdout=subprocess.PIPE, text=True).stdout)
        rows.append({"method": name, "seconds": seconds,
                     "points_a_second_a_core": arguments.input_points / seconds / arguments.threads,
                     "distance": evaluation["distance"]["mean"],
                     "normal_error": evaluation["normals"]["mean_error_degrees"]})
    return rows


def markdown(result):
    machine_ = result["machine"]
    return "\n".join([
        "# Beside what people use", "", "Made by", "", f"    {result['command']}", "",
        f"on {result['threads']} threads of {machine_['processor']}, {machine_['compiler']}, "
        f"`{machine_['flags']}`; PCL is Debian's, for any processor. "
        f"{result['input_points']} points of {result['mesh']} with noise of "
        f"{result['noise_percent']:g} % of the diagonal, {result['output_points']} out. The distance "
        "is the mean one to the mesh, in % of the diagonal; the error of normals disregards their "
        "signs.",
        "",
        table(["method", "seconds", "points a second a core", "distance, %",
               "normal error, degrees"],
              [[row["method"], f"{row['seconds']:.3g}", f"{row['points_a_second_a_core']:.0f}",
                f"{row['distance']:.4f}", f"{row['normal_error']:.2f}"]
               for row in result["rows"]])])


def main():
    parser = argument_parser(__doc__, "a few thousand points")
    parser.add_argument("mesh", type=Path, help="mesh to sample")
    parser.add_argument("--noise", type=float, default=0.5)
    parser.add_argument("--input-points", type=int, default=110_000)
    parser.add_argument("--output-points", type=int, default=60_000)
    parser.add_argument("--threads", type=int, default=2)
    arguments = parser.parse_args()
    if arguments.small:
        arguments.input_points, arguments.output_points = 2_000, 1_100
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch))
        source = bench.sample(arguments.mesh, arguments.input_points, arguments.noise)
        result = {"command": command_line("run_beside.py", sys.argv[1:]),
                  "machine": machine(arguments.build), "mesh": arguments.mesh.name,
                  "noise_percent": arguments.noise, "threads": arguments.threads,
                  "input_points": arguments.input_points, "output_points": arguments.output_points,
                  "rows": measure(bench, arguments.mesh, source, arguments)}
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
