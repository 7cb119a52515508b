# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs programs for a report, several at a time, and keeps what its pictures need."""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from selections import SUBSTITUTES

ROOT = Path(__file__).resolve().parents[3]
sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("methods", "quality")]
from methods import ROWS, Method
from quality_bench import Bench, describe


class Laboratory(Bench):
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
        experiment = {"mesh": mesh.name, "noise_percent": cloud.noise_percent, "outliers_percent": 0,
                      "density_gradient": cloud.density_gradient, "seed": 1, "input_points": cloud.input_points,
                      "output_points": cloud.output_points}
        return experiment, mesh, self.sample(mesh, experiment, f"{name}.ply")

    def all_of(self, *calls):
        """The results of functions without arguments, run beside each other."""
        return [future.result() for future in [self.pool.submit(call) for call in calls]]

    def scene(self, title, name, mesh=None, reconstruct=False):
        """What the viewer shows of NAME.ply: its points and, if asked for, its Poisson mesh with distances to the truth."""
        scene = {"title": title, "points": f"{name}.ply"}
        if not reconstruct:
            return scene
        surface = self.scratch / f"{name}.off"
        try:
            self.run("reconstruct_surface", self.scratch / f"{name}.ply", surface)
        except subprocess.CalledProcessError:
            scene["remark"] = "no Poisson mesh: CGAL's reconstruction failed"
            return scene
        scene["mesh"] = surface.name
        if mesh is not None:
            values = self.scratch / f"{name}.values"
            evaluation = json.loads(self.run("evaluate_point_set", surface, mesh, "--values", values))   # vertices have no normals
            scene |= {"values": values.name, "mesh_distance": evaluation["distance"], "mesh_coverage": evaluation["coverage"]}
        return scene

    def measure_variant(self, experiment, mesh, source, method, name):
        """One method on one cloud. Without a mesh nothing is known that could be measured."""
        result = self.scratch / f"{name}.ply"
        line = self.resample(source, method, experiment["output_points"], result)
        measured = {key: line[key] for key in ("program", "parameters", "wall_seconds", "cpu_seconds",
                                               "resident_growth_bytes", "number_of_output_points")}
        if mesh is not None:
            measured["evaluation"] = self.evaluate(mesh, method, experiment["output_points"], result)
        return measured

    def measure_row(self, experiment, mesh, source, row, name, reconstruct):
        """A row of the table of methods, by its best variant: that of least mean distance, or the first without a truth."""
        variants = {}
        for variant, method in row.variants.items():
            stem = f"{name} {variant}".strip().replace(" ", "_").replace(",", "")
            variants[variant] = stem, self.measure_variant(experiment, mesh, source, method, stem)
        best = min(variants, key=lambda v: variants[v][1]["evaluation"]["distance"]["mean"]) if mesh else next(iter(variants))
        stem, measured = variants[best]
        measured |= {"variant": best, "scene": self.scene(row.name, stem, mesh, reconstruct)}
        where = describe(experiment) if mesh else experiment["mesh"]
        print(f"{where}: {row.name} {best}", file=sys.stderr, flush=True)
        return row.name, measured

    def measure_rows(self, experiment, mesh, source, names, name, reconstruct):
        """All rows of these names, or all there are; one that cannot be run has None."""
        rows = [row for row in ROWS if not names or row.name in names]
        calls = [lambda row=row: self.measure_row(experiment, mesh, source, row, f"{name}_{row.name.replace(' ', '_')}", reconstruct)
                 for row in rows if row.variants]
        measured = dict(self.all_of(*calls))
        return {row.name: measured.get(row.name) for row in rows}

    def study(self, experiment, mesh, source, title, name, *options, reconstruct=False):
        """LOR with changes to its energy."""
        method = Method("study_l0", options)
        line = self.resample(source, method, experiment["output_points"], self.scratch / f"{name}.ply")
        values = self.scratch / f"{name}.densities"
        evaluation = self.evaluate(mesh, method, experiment["output_points"], self.scratch / f"{name}.ply", "--values", values)
        print(f"{describe(experiment)}: {title}", file=sys.stderr, flush=True)
        return {"title": title, "evaluation": evaluation, "densities_over_iterations": line["densities"],
                "wall_seconds": line["wall_seconds"], "values": values.name,
                "scene": self.scene(title, name, mesh, reconstruct)}
