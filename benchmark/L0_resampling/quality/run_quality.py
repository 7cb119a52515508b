#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the result of l0_resample_point_set() beside those of CGAL's WLOP and EAR against the mesh they sample.

Each mesh is sampled with each noise and each seed, all methods get the same points, and each result is measured with
evaluate_point_set. OUTPUT.json keeps all that was measured, OUTPUT.md a table for each mesh and noise. A number that is
missing or not finite, or a result with the wrong count, ends the run with an error.
"""

import argparse
import json
import math
import os
import shlex
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import quality_tables

# The example of CGAL's manual for edge-aware upsampling
EXAMPLE_EAR = ("--sharpness-angle", 25, "--edge-sensitivity", 0)


@dataclass(frozen=True)
class Method:
    program: str
    options: tuple
    is_exact: bool = True    # edge-aware upsampling may stop before it has all points


def wlop(radius, *options):
    return Method("baseline_wlop", ("--radius-in-spacings", radius, *options))


def ear(program, radius, *options):
    return Method(program, ("--radius-in-spacings", radius, *EXAMPLE_EAR, *options), False)


METHODS = {
    "lor": Method("run_l0", ("--method", "lor")),
    "alor": Method("run_l0", ("--method", "alor")),
    "default": Method("run_l0", ("--method", "default")),
    "wlop_4": wlop(4),
    "wlop_6": wlop(6),
    "wlop_4_uniform": wlop(4, "--require-uniform-sampling"),
    "wlop_6_uniform": wlop(6, "--require-uniform-sampling"),
    "ear_4": ear("baseline_ear", 4),
    "smoothed_ear_6": ear("baseline_smoothed_ear", 6),
    "smoothed_ear_6_again": ear("baseline_smoothed_ear", 6, "--smooth-again"),
}


def parse_finite(text):
    """Raises ValueError for NaN, infinities and null, which is how evaluate_point_set's library writes both."""

    def check(value, name):
        if isinstance(value, dict):
            for key, item in value.items():
                if item is not None or key not in ("normals", "features"):  # null is what these have none of
                    check(item, f"{name}.{key}" if name else key)
        elif not isinstance(value, (int, float)) or not math.isfinite(value):
            raise ValueError(f"{name} is {value}, not a finite number")

    result = json.loads(text)
    check(result, "")
    return result


class Bench:
    """Runs the programs of one build and keeps their files in one folder."""

    def __init__(self, programs, scratch, threads):
        self.programs = programs
        self.scratch = scratch
        self.threads = threads

    def run(self, program, *arguments):
        return subprocess.run([self.programs / program, *map(str, arguments)], check=True, stdout=subprocess.PIPE,
                              text=True).stdout

    def sample(self, mesh, experiment):
        path = self.scratch / "input.ply"
        self.run("sample_mesh", mesh, path, "--points", experiment["input_points"],
                 "--noise", experiment["noise_percent"], "--seed", experiment["seed"])
        return path

    def measure(self, mesh, source, method, points):
        result = self.scratch / "result.ply"
        line = json.loads(self.run(method.program, source, result, "--points", points,
                                   "--threads", self.threads, *method.options))
        evaluation = parse_finite(self.run("evaluate_point_set", result, mesh))
        count = evaluation["number_of_points"]
        if count != points and (method.is_exact or not 0 < count < points):
            raise ValueError(f"{count} points instead of {points}")
        if evaluation["normals"] is None:
            raise ValueError("the result has no normals")
        return {"program": method.program, "cgal_version": line["cgal_version"], "parameters": line["parameters"],
                "evaluation": evaluation}


def run_experiment(bench, mesh, experiment, methods):
    """Adds a measurement for each of `methods` to the experiment, and replaces the one it has."""
    source = bench.sample(mesh, experiment)
    measured = experiment["measurements"]
    for name in methods:
        try:
            measured[name] = bench.measure(mesh, source, METHODS[name], experiment["output_points"])
        except ValueError as error:
            raise ValueError(f"{name} on {mesh.name}, noise {experiment['noise_percent']:g} %: {error}") from error
        print(f"{mesh.name}, noise {experiment['noise_percent']:g} %, seed {experiment['seed']}, {name}: mean distance "
              f"{measured[name]['evaluation']['distance']['mean']:.4f} %", file=sys.stderr, flush=True)
    experiment["measurements"] = {name: measured[name] for name in METHODS if name in measured}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("meshes", type=Path, nargs="+", metavar="mesh", help="OFF file to sample")
    parser.add_argument("--output", type=Path, help="writes OUTPUT.json and OUTPUT.md; else the tables are printed")
    parser.add_argument("--noise", type=float, nargs="+", default=[0.5, 1.0],
                        help="standard deviations, %% of the diagonal")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1], help="of the sampling; the tables show means")
    parser.add_argument("--input-points", type=int, default=110_000)
    parser.add_argument("--output-points", type=int, default=60_000)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--only", nargs="+", choices=METHODS, metavar="METHOD",
                        help="measures these anew and takes all others from OUTPUT.json: " + ", ".join(METHODS))
    parser.add_argument("--mesh-origin", help="where the meshes are from, for the tables' heading")
    parser.add_argument("--small", action="store_true", help="a few thousand points, one noise")
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


def settings(experiment):
    return {key: value for key, value in experiment.items() if key != "measurements"}


def reuse(previous, planned, only):
    """Fills `planned` with the measurements of an earlier run.

    Raises ValueError unless that run was on the same experiments, so that no table mixes two samplings, and has all
    but the methods `only`.
    """
    experiments = previous["experiments"]
    if list(map(settings, experiments)) != [settings(experiment) for _, experiment in planned]:
        raise ValueError("--only: the earlier run was on other meshes, noise, seeds or counts")
    for (_, experiment), old in zip(planned, experiments):
        missing = METHODS.keys() - old["measurements"].keys() - set(only)
        if missing:
            raise ValueError("--only: the earlier run lacks " + ", ".join(sorted(missing)))
        experiment["measurements"] = old["measurements"]


def main():
    arguments = parse_arguments()
    words = [os.path.basename(word) if os.path.isabs(word) else word for word in sys.argv[1:]]
    command = shlex.join(["run_quality.py", *words])
    result = {"commands": [command], "mesh_origin": arguments.mesh_origin, "experiments": []}
    planned = plan(arguments)
    if arguments.only:
        previous = json.loads(arguments.output.with_suffix(".json").read_text())
        reuse(previous, planned, arguments.only)
        result["commands"] = [old for old in previous["commands"] if old != command] + [command]
        result["mesh_origin"] = arguments.mesh_origin or previous["mesh_origin"]
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), arguments.threads)
        for mesh, experiment in planned:
            run_experiment(bench, mesh, experiment, arguments.only or METHODS)
            result["experiments"].append(experiment)
    tables = quality_tables.markdown(result)
    if arguments.output is None:
        print(tables, end="")
        return
    arguments.output.parent.mkdir(parents=True, exist_ok=True)
    arguments.output.with_suffix(".json").write_text(json.dumps(result, indent=1, allow_nan=False) + "\n")
    arguments.output.with_suffix(".md").write_text(tables)


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"run_quality.py: {error}")
