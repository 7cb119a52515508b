# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What the tests of cgal_l0 share. L0_RESAMPLE names the program whose results are the truth."""

import json
import os
import subprocess

import numpy
import pytest


def noisy_cube(n, seed=1):
    """Points on the surface of a cube of side 1, moved by noise of 0.01, and the true normals with
    random signs."""
    random = numpy.random.default_rng(seed)
    axis = random.integers(3, size=n)
    side = random.choice([-1.0, 1.0], size=n)
    points = random.uniform(-0.5, 0.5, size=(n, 3))
    normals = numpy.zeros((n, 3))
    points[numpy.arange(n), axis] = side / 2
    normals[numpy.arange(n), axis] = random.choice([-1.0, 1.0], size=n)
    return points + random.normal(scale=0.01, size=(n, 3)), normals


@pytest.fixture(scope="session")
def cube():
    return noisy_cube(6000)[0]


@pytest.fixture(scope="session")
def cube_normals():
    return noisy_cube(6000)[1]


@pytest.fixture(scope="session")
def endless():
    """A call of ten thousand iterations. Were it not cancelled, it would outlast the time limit of
    the test."""
    return {"points": noisy_cube(200_000)[0], "method": "lor", "penalty_growth": 1.0003}


@pytest.fixture
def tool(tmp_path):
    """Runs the program on points; gives positions, normals and the report."""

    def run(points, *options, normals=None):
        source, target, report = tmp_path / "in.xyz", tmp_path / "out.xyz", tmp_path / "report.json"
        table = points if normals is None else numpy.hstack([points, normals])
        numpy.savetxt(source, table, fmt="%.17g")
        command = [os.environ["L0_RESAMPLE"], "--force", source, target, "--device", "cpu"]
        command += ["--json", report, "--quiet", *options]
        subprocess.run([str(word) for word in command], check=True)
        result = numpy.loadtxt(target, ndmin=2)
        return result[:, :3], result[:, 3:], json.loads(report.read_text())

    return run
