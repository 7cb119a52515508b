# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the meshes that CGAL's poisson_surface_reconstruction_delaunay() makes of results, all
with the same parameters."""

import json
import subprocess

from quality_bench import Bench

# How far triangles may be off the Poisson surface, in spacings of the points. The first keeps the
# distances of that surface; it fails where normals contradict each other and the surface is a
# tangle.
SURFACE_DISTANCES = (0.1, 0.375, 1)
SURFACE_SAMPLES = 50_000
SECONDS, BYTES = 300, 4 << 30    # of a reconstruction, at most


class Poisson_bench(Bench):
    def reconstruct(self, points, surface):
        """Writes the mesh, and tells whether it could be made."""
        for distance in SURFACE_DISTANCES:
            command = ["prlimit", f"--cpu={SECONDS}", f"--as={BYTES}",
                       self.programs / "reconstruct_surface", points, surface, str(distance)]
            if subprocess.run(command, stderr=subprocess.DEVNULL).returncode == 0:
                return True
        return False

    def mean_distance_of_mesh(self, surface, mesh):
        """Of a mesh to the true one, at points that are uniform by area, in % of the diagonal."""
        samples = surface.with_name(f"{surface.stem}_samples.ply")
        self.run("sample_mesh", surface, samples, "--points", SURFACE_SAMPLES)
        evaluation = json.loads(self.run("evaluate_point_set", samples, mesh))
        return evaluation["distance"]["mean"]
