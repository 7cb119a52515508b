# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the drivers of this folder share: they sample a mesh, run programs on the points, and measure the results."""

import argparse
import json
import math
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import command_line, load_raw, write_result  # for the drivers

OWN_DATA = Path(__file__).resolve().parents[3] / "data"


def parse_finite(text):
    """Raises ValueError for NaN, infinities and null, which is how evaluate_point_set's library writes both."""

    def check(value, name):
        if isinstance(value, dict):
            for key, item in value.items():
                if item is not None or key not in ("normals", "features", "mean_normal_error_degrees"):  # null: there is none
                    check(item, f"{name}.{key}" if name else key)
        elif not isinstance(value, (int, float)) or not math.isfinite(value):
            raise ValueError(f"{name} is {value}, not a finite number")

    result = json.loads(text)
    check(result, "")
    return result


def mesh_of(shape, mesh_folder):
    """In our data if it is there, else in `mesh_folder`."""
    own = OWN_DATA / f"{shape}.off"
    return own if own.exists() else mesh_folder / own.name


def describe(experiment):
    """The input of an experiment in words; `outliers_percent` and `density_gradient` may be missing."""
    words = [experiment["mesh"], f"noise {experiment['noise_percent']:g} %"]
    if experiment.get("outliers_percent"):
        words.append(f"outliers {experiment['outliers_percent']:g} %")
    if experiment.get("density_gradient", 1) != 1:
        words.append(f"density gradient {experiment['density_gradient']:g}")
    return ", ".join(words)


class Bench:
    """Runs the programs of one build and keeps their files in one folder."""

    def __init__(self, programs, scratch, threads):
        self.programs = programs
        self.scratch = scratch
        self.threads = threads

    def run(self, program, *arguments):
        return subprocess.run([self.programs / program, *map(str, arguments)], check=True, stdout=subprocess.PIPE,
                              text=True).stdout

    def sample(self, mesh, experiment, name="input.ply"):
        path = self.scratch / name
        self.run("sample_mesh", mesh, path, "--points", experiment["input_points"],
                 "--noise", experiment["noise_percent"], "--seed", experiment["seed"],
                 "--outliers", experiment.get("outliers_percent", 0),
                 "--density-gradient", experiment.get("density_gradient", 1))
        return path

    def resample(self, source, method, points, result):
        """Runs the method, which writes `result`, and returns what it prints."""
        return json.loads(self.run(method.program, source, result, "--points", points, "--threads", self.threads,
                                   *method.options))

    def evaluate(self, mesh, method, points, result, *options):
        evaluation = parse_finite(self.run("evaluate_point_set", result, mesh, *options))
        count = evaluation["number_of_points"]
        if count != points and (method.is_exact or not 0 < count < points):
            raise ValueError(f"{count} points instead of {points}")
        if evaluation["normals"] is None:
            raise ValueError("the result has no normals")
        return evaluation

    def measure(self, mesh, source, method, points):
        result = self.scratch / "result.ply"
        line = self.resample(source, method, points, result)
        return {"program": line["program"], "cgal_version": line["cgal_version"], "parameters": line["parameters"],
                "evaluation": self.evaluate(mesh, method, points, result)}

    def measure_all(self, mesh, experiment, methods, sources):
        """Adds a measurement for each of `methods` to the experiment, and replaces the one it has.

        `sources` maps the name of a method to the points it gets.
        """
        for name, method in methods.items():
            try:
                measured = self.measure(mesh, sources(name), method, experiment["output_points"])
            except ValueError as error:
                raise ValueError(f"{name} on {describe(experiment)}: {error}") from error
            experiment["measurements"][name] = measured
            print(f"{describe(experiment)}, seed {experiment['seed']}, {name}: mean distance "
                  f"{measured['evaluation']['distance']['mean']:.4f} %", file=sys.stderr, flush=True)


def settings(experiment):
    return {key: value for key, value in experiment.items() if key != "measurements"}


def reuse(previous, planned, methods, only):
    """Fills `planned` with the measurements of an earlier run.

    Raises ValueError unless that run was on the same experiments, so that no table mixes two samplings, and has all
    of `methods` but those of `only`.
    """
    experiments = previous["experiments"]
    if list(map(settings, experiments)) != [settings(experiment) for _, experiment in planned]:
        raise ValueError("--only: the earlier run was on other meshes, noise, outliers, gradients, seeds or counts")
    for (_, experiment), old in zip(planned, experiments):
        missing = set(methods) - old["measurements"].keys() - set(only)
        if missing:
            raise ValueError("--only: the earlier run lacks " + ", ".join(sorted(missing)))
        experiment["measurements"] = old["measurements"]


def argument_parser(description, small):
    """Of a driver. `small` says what its tests run."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the tables are printed")
    parser.add_argument("--small", action="store_true", help=small)
    return parser
