#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what the default method would reach if it knew the truth.

One oracle tells it the best radius, of several times its own, by the error that is measured against the mesh; one gives
each point the normal of the nearest face in place of PCA; a third does both. What an oracle does not reach is not a matter of the
choice of radius, nor of the first normals. The tables have the figures beside
the best of CGAL's pipelines, from the results of run_comparison.py on the same inputs, of which it takes the first sampling.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import oracle_tables
from quality_bench import CGAL_SHAPES, OWN_SHAPES, Bench, command_line, mesh_of, parse_finite, write_result

RADIUS_FACTORS = (0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.25, 1.5)
SOURCES = ("own normals", "true normals")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the tool and the programs that measure")
    parser.add_argument("meshes", type=Path, metavar="mesh_folder", help="has the meshes of libcgal-demo")
    parser.add_argument("comparison", type=Path, help="JSON file that run_comparison.py has written to output")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the tables are printed")
    parser.add_argument("--shapes", nargs="+", choices=CGAL_SHAPES + OWN_SHAPES,
                        default=("armadillo", "fandisk", "anchor_dense", "thin_plate"))
    return parser.parse_args()


def resample(bench, source, points, *options):
    """Measures the result later: returns its file and the radius."""
    result, report = bench.scratch / "result.ply", bench.scratch / "report.json"
    bench.run("l0_resample", "--force", source, result, "--points", points,
              "--threads", bench.threads, "--quiet", "--json", report, *options)
    return result, json.loads(report.read_text(encoding="utf-8"))["resampling"]["neighbor_radius"]


def measure(bench, mesh, experiment):
    source, with_normals = bench.sample(mesh, experiment), bench.scratch / "with_normals.ply"
    bench.run("attach_true_normals", source, mesh, with_normals)
    points, runs = experiment["output_points"], []
    _, radius = resample(bench, source, points)
    for name, file, options in zip(SOURCES, (source, with_normals), ((), ("--use-normals",))):
        for factor in RADIUS_FACTORS:
            given = () if factor == 1 else ("--neighbor-radius", factor * radius)
            result, _ = resample(bench, file, points, *options, *given)
            runs.append({"normals": name, "radius_factor": factor,
                         "evaluation": parse_finite(bench.run("evaluate_point_set", result, mesh))})
    return runs


def main():
    arguments = parse_arguments()
    comparison = json.loads(arguments.comparison.read_text(encoding="utf-8"))
    result = {"commands": [command_line("run_oracle.py", sys.argv[1:])], "experiments": []}
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), 1)
        first_seed = comparison["experiments"][0]["seed"]
        for compared in comparison["experiments"]:
            shape = Path(compared["mesh"]).stem
            if (shape not in arguments.shapes or compared["outliers_percent"] or compared["density_gradient"] != 1
                    or compared["seed"] != first_seed):
                continue
            experiment = {key: value for key, value in compared.items() if key != "measurements"}
            experiment["best_of_cgal"] = oracle_tables.best_of_cgal(compared)
            experiment["runs"] = measure(bench, mesh_of(shape, arguments.meshes), experiment)
            result["experiments"].append(experiment)
            print(f"{shape}, noise {experiment['noise_percent']:g} %", file=sys.stderr, flush=True)
            if arguments.output is not None:   # a long run that is cut short leaves what it has
                write_result(arguments.output, result, oracle_tables.markdown(result))
    if arguments.output is None:
        write_result(None, result, oracle_tables.markdown(result))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"run_oracle.py: {error}")
