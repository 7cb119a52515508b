# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs programs for a report, several at a time."""

import json
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from selections import SUBSTITUTE_FOR_SCANS, SUBSTITUTES

ROOT = Path(__file__).resolve().parents[3]
# Shares of normals inwards between which there is no surface: its mesh would be a tangle, which
# takes minutes. All inwards is as good as none.
MIXED_NORMALS = (0.4, 0.6)
SHARE_OF_SCANS = 0.7    # of points that are left; in the paper, 0.69 of FIFA's and 0.73 of Clock's
sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("methods", "quality")]
from methods import ROWS, Method
from poisson_bench import Poisson_bench
from quality_bench import describe


class Laboratory(Poisson_bench):
    """Programs of a build; files stay in the folder `files`.

    `demo_data` is the data folder of libcgal-demo, or None.
    """

    def __init__(self, build, files, demo_data, jobs):
        super().__init__(build / "bin", files, threads=1)
        self.demo_data = demo_data
        self.pool = ThreadPoolExecutor(max_workers=jobs)

    def mesh(self, shape):
        own = ROOT / "data"
        if self.demo_data and (self.demo_data / "meshes" / f"{shape}.off").exists():
            return self.demo_data / "meshes" / f"{shape}.off"
        return own / f"{shape if (own / f'{shape}.off').exists() else SUBSTITUTES[shape]}.off"

    def input(self, cloud, name):
        """The sampled cloud, as an experiment of `quality_bench` and as a file."""
        mesh = self.mesh(cloud.shape)
        experiment = {"mesh": mesh.name, "noise_percent": cloud.noise_percent,
                      "outliers_percent": 0, "density_gradient": cloud.density_gradient, "seed": 1,
                      "input_points": cloud.input_points, "output_points": cloud.output_points}
        return experiment, mesh, self.sample(mesh, experiment, f"{name}.ply")

    def scan(self, scan, largest_count, name):
        """A real scan of at most so many points, as what is known of it and as a file."""
        path = (self.demo_data / "points_3" / scan.file if self.demo_data
                else ROOT / "data" / SUBSTITUTE_FOR_SCANS)
        source = self.scratch / f"{name}.ply"
        line = json.loads(self.run("baseline_filter", path, source, "--filter", "random",
                                   "--points", largest_count))
        count = line["number_of_output_points"]
        return {"mesh": path.name, "stands_for": scan.stands_for, "input_points": count,
                "output_points": round(SHARE_OF_SCANS * count)}, source

    def all_of(self, *calls):
        """The results of functions without arguments, run beside each other."""
        return [future.result() for future in [self.pool.submit(call) for call in calls]]

    def distance_of_mesh(self, name, mesh, evaluation):
        """Of the Poisson mesh of NAME.ply, whose evaluation is given. None where there is none, as
        the normals are mixed or contradict each other."""
        surface = self.scratch / f"{name}.off"
        is_mixed = MIXED_NORMALS[0] < evaluation["normals"]["share_inwards"] < MIXED_NORMALS[1]
        if is_mixed or not self.reconstruct(self.scratch / f"{name}.ply", surface):
            return None
        return self.mean_distance_of_mesh(surface, mesh)

    def measure_variant(self, experiment, mesh, source, method, name):
        """One method on one cloud."""
        points, result = experiment["output_points"], self.scratch / f"{name}.ply"
        line = self.resample(source, method, points, result)
        measured = {key: line[key] for key in ("wall_seconds", "resident_growth_bytes",
                                               "number_of_output_points")}
        return measured | {"evaluation": self.evaluate(mesh, method, points, result)}

    def measure_row(self, experiment, mesh, source, row, name):
        """A row of the table of methods, by its variant of least mean distance."""
        variants = {}
        for variant, method in row.variants.items():
            stem = f"{name} {variant}".strip().replace(" ", "_").replace(",", "")
            variants[variant] = stem, self.measure_variant(experiment, mesh, source, method, stem)
        best = min(variants, key=lambda v: variants[v][1]["evaluation"]["distance"]["mean"])
        stem, measured = variants[best]
        distance = self.distance_of_mesh(stem, mesh, measured["evaluation"])
        print(f"{describe(experiment)}: {row.name} {best}", file=sys.stderr, flush=True)
        return measured | {"variant": best, "mesh_distance": distance}

    def measure_rows(self, experiment, mesh, source, name):
        """All rows; one that cannot be run has None."""
        measured = self.all_of(*(lambda row=row: self.measure_row(
            experiment, mesh, source, row, f"{name}_{row.name}") if row.variants else None
            for row in ROWS))
        return {row.name: run for row, run in zip(ROWS, measured)}

    def study(self, experiment, mesh, source, title, name, *options, reconstruct=False):
        """LOR with changes to its energy."""
        method, result = Method("study_l0", options), self.scratch / f"{name}.ply"
        line = self.resample(source, method, experiment["output_points"], result)
        evaluation = self.evaluate(mesh, method, experiment["output_points"], result)
        print(f"{describe(experiment)}: {title}", file=sys.stderr, flush=True)
        distance = self.distance_of_mesh(name, mesh, evaluation) if reconstruct else None
        return {"title": title, "evaluation": evaluation,
                "densities_over_iterations": line["densities"],
                "wall_seconds": line["wall_seconds"], "mesh_distance": distance}
