#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the Poisson mesh of each method's result: of the default method, and of CGAL's pipelines.

Inputs and pipelines are those of run_comparison.py. All results of an input become meshes by CGAL's
poisson_surface_reconstruction_delaunay() with the same parameters. The tables
have a row for each input, and what is met of the goals.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import poisson_tables
from quality_bench import (CGAL_SHAPES, OWN_SHAPES, Bench, command_line, describe, load_raw, mesh_of, reuse_known,
                           write_result)
from run_comparison import methods

# How far triangles may be off the Poisson surface, in spacings of the points. The first keeps the distances of that
# surface; it fails where normals contradict each other and the surface is a tangle.
SURFACE_DISTANCES = (0.1, 0.375, 1)
SURFACE_SAMPLES = 50_000
SECONDS, BYTES = 300, 4 << 30    # of a reconstruction, at most
ALL_TRIANGLES = 10**9            # of the copy that a report shows: it is not simplified


class Poisson_bench(Bench):
    """What is measured of a result is its mesh."""

    def distances(self, source, target):
        """From area-uniform samples of one mesh to another: mean and maximum, times a hundred as `evaluate_point_set` has
        them in % of the diagonal, and that diagonal."""
        samples = self.scratch / "samples.ply"
        self.run("sample_mesh", source, samples, "--points", SURFACE_SAMPLES)
        evaluation = json.loads(self.run("evaluate_point_set", samples, target))
        diagonal = evaluation["diagonal_length"]
        return evaluation["distance"]["mean"] * diagonal, evaluation["distance"]["max"] * diagonal, diagonal

    def reconstruct(self, points, surface):
        """Writes the mesh. Returns how closely it follows the Poisson surface, in spacings, or None if it cannot be made."""
        for distance in SURFACE_DISTANCES:
            command = ["prlimit", f"--cpu={SECONDS}", f"--as={BYTES}", self.programs / "reconstruct_surface", points,
                       surface, str(distance), self.scratch / "picture.off", str(ALL_TRIANGLES)]
            if subprocess.run(command, stderr=subprocess.DEVNULL).returncode == 0:
                return distance
        return None

    def measure_mesh(self, mesh, points):
        """How closely the mesh of the points follows its Poisson surface, and its distances; both None if it cannot be made."""
        surface = self.scratch / "surface.off"
        surface_distance = self.reconstruct(points, surface)
        if surface_distance is None:
            return None, None
        mean, largest, diagonal = self.distances(surface, mesh)
        mean_of_truth, largest_of_truth, _ = self.distances(mesh, surface)
        return surface_distance, {"mean_distance": mean / diagonal, "mean_coverage": mean_of_truth / diagonal,
                                  "hausdorff": max(largest, largest_of_truth) / diagonal}

    def measure(self, mesh, source, method, points):
        result = self.scratch / "result.ply"
        line = self.resample(source, method, points, result)
        surface_distance, surface = self.measure_mesh(mesh, result)
        return {"program": line["program"], "cgal_version": line["cgal_version"], "parameters": line["parameters"],
                "surface_distance": surface_distance, "surface": surface}

    def measure_ours(self, mesh, source, method, points):
        """Beside it, the mesh of the same points without any error: moved to the truth, with its normals."""
        measured, exact = self.measure(mesh, source, method, points), self.scratch / "exact.ply"
        self.run("attach_true_normals", self.scratch / "result.ply", mesh, exact, "--move-to-surface")
        _, measured[poisson_tables.EXACT] = self.measure_mesh(mesh, exact)
        return measured


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("meshes", type=Path, metavar="mesh_folder", help="has the meshes of libcgal-demo")
    parser.add_argument("--output", type=Path, required=True, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py")
    parser.add_argument("--shapes", nargs="+", choices=CGAL_SHAPES + OWN_SHAPES, default=CGAL_SHAPES + OWN_SHAPES)
    parser.add_argument("--noise", type=float, nargs="+", default=(0.5, 1.5), help="standard deviations, %% of the diagonal")
    parser.add_argument("--radii", type=float, nargs="+", default=[4, 6], help="of CGAL's pipelines, in spacings")
    parser.add_argument("--input-points", type=int, default=12_000)
    parser.add_argument("--output-points", type=int, default=8_000)
    parser.add_argument("--keep-baselines", action="store_true",
                        help="takes the meshes of CGAL's pipelines that an earlier run with that --output has measured from there")
    parser.add_argument("--small", action="store_true",
                        help="one shape of our own, one noise, one radius, 2000 points to 1300")
    arguments = parser.parse_args()
    if arguments.small:
        arguments.input_points, arguments.output_points = 2_000, 1_300
        arguments.shapes, arguments.noise, arguments.radii = ["dodecahedron"], [0.5], [4]
    return arguments


def plan(arguments):
    """Each mesh, and what is measured on it."""
    planned = []
    for noise in arguments.noise:
        for shape in arguments.shapes:
            mesh = mesh_of(shape, arguments.meshes)
            planned.append((mesh, {"mesh": mesh.name, "noise_percent": noise, "outliers_percent": 0, "density_gradient": 1,
                                   "seed": 1, "input_points": arguments.input_points,
                                   "output_points": arguments.output_points, "measurements": {}}))
    return planned


def main():
    arguments = parse_arguments()
    command = command_line("run_poisson.py", sys.argv[1:])
    result = {"commands": [command], "experiments": []}
    planned, compared = plan(arguments), methods(arguments.radii)
    if arguments.keep_baselines:
        previous = load_raw(arguments.output)
        reuse_known(previous, planned, compared, ["default"])
        result["commands"] = [old for old in previous["commands"] if old != command] + [command]
    with tempfile.TemporaryDirectory() as scratch:
        bench = Poisson_bench(arguments.build / "bin", Path(scratch), 1)
        for mesh, experiment in planned:
            source = bench.sample(mesh, experiment)
            for name, method in compared.items():
                if name == "default" or name not in experiment["measurements"]:
                    measure = bench.measure_ours if name == "default" else bench.measure
                    measured = measure(mesh, source, method, experiment["output_points"])
                    experiment["measurements"][name] = measured
                    print(f"{describe(experiment)}, {name}: {measured['surface']}", file=sys.stderr, flush=True)
            result["experiments"].append(experiment)
            write_result(arguments.output, result, poisson_tables.markdown(result))  # a long run that fails leaves what it has


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"run_poisson.py: {error}")
