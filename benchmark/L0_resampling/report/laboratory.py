# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs programs for a report, several at a time, and keeps what its pictures need."""

import hashlib
import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import cache
from pathlib import Path

from scenes import read_ply
from selections import SUBSTITUTE_FOR_SCANS, SUBSTITUTES

ROOT = Path(__file__).resolve().parents[3]
SURFACE_SAMPLES = 20_000
# CGAL's default is the second. The first is preferred, so that distances measured on the mesh are those of the points.
SURFACE_DISTANCES = (0.1, 0.375, 1)
# Shares of normals inwards between which there is no surface: its mesh would be a tangle, which takes minutes. All inwards is as good as none.
MIXED_NORMALS = (0.4, 0.6)
SHARE_OF_SCANS = 0.7    # of points that are left; in the paper, 0.69 of FIFA's and 0.73 of Clock's
sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("methods", "quality")]
from methods import ROWS, Method
from quality_bench import Bench, describe


@cache
def digest_of_programs(folder, names):
    """Measurements of other programs do not belong into the same report; those of a method that has not changed do."""
    digest = hashlib.sha256()
    for name in sorted(names | {"sample_mesh", "evaluate_point_set", "reconstruct_surface"}):
        digest.update((folder / name).read_bytes())
    return digest.hexdigest()


class Laboratory(Bench):
    """Programs of a build; files stay in the folder `files`.

    `demo_data` is the data folder of libcgal-demo, or None. Meshes of the page have `picture_triangles` at most, where collapsing
    edges makes them so small. With `resume`, what an interrupted run has measured is not measured again.
    """

    def __init__(self, build, files, demo_data, jobs, picture_triangles, resume):
        super().__init__(build / "bin", files, threads=1)
        self.demo_data = demo_data
        self.picture_triangles = picture_triangles
        self.resume = resume
        self.pool = ThreadPoolExecutor(max_workers=jobs)

    def once(self, name, programs, asked, measure):
        """What `measure` returns, which is kept in NAME.json; a resumed run takes it from there, if the programs that it runs, by name, and `asked` are the same."""
        path = self.scratch / f"{name}.json"
        asked = json.loads(json.dumps([digest_of_programs(self.programs, frozenset(programs)), self.picture_triangles, asked], default=vars))
        if self.resume and path.exists():
            kept = json.loads(path.read_text(encoding="utf-8"))
            if kept["asked"] == asked:
                return kept["measured"]
        measured = measure()
        unfinished = path.with_suffix(".unfinished")
        unfinished.write_text(json.dumps({"asked": asked, "measured": measured}), encoding="utf-8")
        unfinished.replace(path)    # at once, so that an interrupted run leaves no half of it
        return measured

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

    def scan(self, scan, largest_count, name):
        """A real scan of at most so many points, as what is known of it and as a file."""
        path = self.demo_data / "points_3" / scan.file if self.demo_data else ROOT / "data" / SUBSTITUTE_FOR_SCANS
        source = self.scratch / f"{name}.ply"
        line = json.loads(self.run("baseline_filter", path, source, "--filter", "random", "--points", largest_count))
        count = line["number_of_output_points"]
        return {"mesh": path.name, "stands_for": scan.stands_for, "input_points": count,
                "output_points": round(SHARE_OF_SCANS * count)}, source

    def all_of(self, *calls):
        """The results of functions without arguments, run beside each other."""
        return [future.result() for future in [self.pool.submit(call) for call in calls]]

    def reconstruct(self, points, surface, picture):
        """Writes the Poisson mesh, and a coarser one for the page. Returns how closely the first follows the Poisson surface, in spacings, or None if it cannot be made.

        Where normals contradict each other, that surface is a tangle, and its mesh would grow until memory ends.
        """
        count = len(read_ply(points)[0])
        for distance in SURFACE_DISTANCES:
            limits = ("--cpu", str(20 + count // 300)), ("--as", str(4 << 30))
            command = ["prlimit", *(f"{name}={value}" for name, value in limits), self.programs / "reconstruct_surface", points, surface, str(distance),
                       picture, str(self.picture_triangles)]
            if subprocess.run(command, stderr=subprocess.DEVNULL).returncode == 0:
                return distance
        return None

    def scene(self, title, name, mesh=None, reconstruct=False, of_points=None):
        """What the viewer shows of NAME.ply: its points and, if asked for, its Poisson mesh with distances to the truth.

        There is none where `of_points`, their evaluation, says that the normals are mixed.
        """
        scene = {"title": title, "points": f"{name}.ply"}
        if not reconstruct:
            return scene
        if of_points is not None and MIXED_NORMALS[0] < of_points["normals"]["share_inwards"] < MIXED_NORMALS[1]:
            scene["remark"] = "no mesh: the normals contradict each other"
            return scene
        surface, picture = self.scratch / f"{name}.off", self.scratch / f"{name}_picture.off"
        distance = self.reconstruct(self.scratch / f"{name}.ply", surface, picture)
        if distance is None:
            scene["remark"] = "CGAL's Poisson reconstruction fails"
            return scene
        if distance > SURFACE_DISTANCES[0]:
            scene["remark"] = f"mesh within {distance:g} spacings of CGAL's Poisson surface, as a closer one fails"
        scene["mesh"] = picture.name
        if mesh is not None:
            values, samples = self.scratch / f"{name}.values", self.scratch / f"{name}_mesh.ply"
            self.run("evaluate_point_set", picture, mesh, "--values", values)    # at the vertices, for the colors
            # Most vertices are where the surface bends: its distance is that of points that are even by area.
            self.run("sample_mesh", surface, samples, "--points", SURFACE_SAMPLES)
            evaluation = json.loads(self.run("evaluate_point_set", samples, mesh))
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
        return self.once(name, {variant.program for variant in row.variants.values()}, [experiment, row.variants, reconstruct],
                         lambda: self.measure_row_now(experiment, mesh, source, row, name, reconstruct))

    def measure_row_now(self, experiment, mesh, source, row, name, reconstruct):
        variants = {}
        # without a truth there is no best one to look for
        for variant, method in list(row.variants.items())[:None if mesh else 1]:
            stem = f"{name} {variant}".strip().replace(" ", "_").replace(",", "")
            variants[variant] = stem, self.measure_variant(experiment, mesh, source, method, stem)
        best = min(variants, key=lambda v: variants[v][1]["evaluation"]["distance"]["mean"]) if mesh else next(iter(variants))
        stem, measured = variants[best]
        scene = self.scene(row.name, stem, mesh, reconstruct, measured.get("evaluation"))
        measured |= {"variant": best, "scene": scene}
        where = describe(experiment) if mesh else experiment["mesh"]
        print(f"{where}: {row.name} {best}", file=sys.stderr, flush=True)
        return measured

    def start_rows(self, experiment, mesh, source, name, reconstruct, left_out=()):
        """All rows, without the variants named in `left_out`; a row that cannot be run has None.

        Returns what waits for them, so that those of several experiments can run beside each other.
        """
        rows = [replace(row, variants={name: method for name, method in row.variants.items() if name not in left_out}) for row in ROWS]
        measured = {row.name: self.pool.submit(self.measure_row, experiment, mesh, source, row, f"{name}_{row.name.replace(' ', '_')}", reconstruct)
                    for row in rows if row.variants}
        return lambda: {row.name: measured[row.name].result() if row.name in measured else None for row in rows}

    def study(self, experiment, mesh, source, title, name, *options, reconstruct=False):
        """LOR with changes to its energy."""
        return self.once(name, {"study_l0"}, [experiment, options, reconstruct],
                         lambda: self.study_now(experiment, mesh, source, title, name, *options, reconstruct=reconstruct))

    def study_now(self, experiment, mesh, source, title, name, *options, reconstruct):
        method = Method("study_l0", options)
        line = self.resample(source, method, experiment["output_points"], self.scratch / f"{name}.ply")
        values = self.scratch / f"{name}.densities"
        evaluation = self.evaluate(mesh, method, experiment["output_points"], self.scratch / f"{name}.ply", "--values", values)
        print(f"{describe(experiment)}: {title}", file=sys.stderr, flush=True)
        return {"title": title, "evaluation": evaluation, "densities_over_iterations": line["densities"],
                "wall_seconds": line["wall_seconds"], "values": values.name,
                "scene": self.scene(title, name, mesh, reconstruct, evaluation)}
