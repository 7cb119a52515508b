#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the benchmark that learned methods of denoising are compared by: test meshes of PU-Net, sampled by Poisson disks, with noise of 1, 2 and 3 % of the
radius of the bounding sphere, as many points out as in.

Distances are those of score-denoise (Luo and Hu 2021), squared and times 10^4: CD is the Chamfer distance to the points before the noise, P2M that to the mesh,
both in both directions, in the unit of the bounding sphere. The meshes are data/test/*.off of github.com/GabrielleTse/PU-EVA.
"""

import json
import statistics
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy
from scipy.spatial import cKDTree

from quality_bench import Bench, argument_parser, command_line, write_result
from quality_tables import table

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ours

SHAPES = ("camel", "casting", "chair", "coverrear_Lp", "cow", "duck", "eight", "elephant", "elk", "fandisk", "genus3", "horse", "kitten", "pig", "star")
NUMBER_OF_TEST_SHAPES = 20
NOISES = (1, 2, 3)    # % of the radius of the bounding sphere
NUMBERS_OF_POINTS = (10_000, 50_000)
CANDIDATES_PER_POINT = 5

# P2M as published, over all test shapes, in the order of NOISES: the best known on these meshes
PUBLISHED = {"StraightPCF (de Silva Edirimuni et al. 2024)": {10_000: (0.24, 0.60, 1.13)},
             "P2P-Bridge (Vogel et al. 2024)": {10_000: (0.39, 0.81, 1.42), 50_000: (0.09, 0.32, 0.84)}}


def write_points(path, points):
    header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty double x\nproperty double y\nproperty double z\nend_header\n"
    path.write_bytes(header.encode("ascii") + numpy.ascontiguousarray(points, "<f8").tobytes())


def read_points(path):
    """Of a binary PLY file of sample_mesh."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    kind = "<f8" if b"property double x" in header else "<f4"
    return numpy.frombuffer(data, kind).reshape(-1, 3).astype(float)


def far_apart(tree, radius, priorities):
    """Which of the points stay if the one of least priority always takes those within `radius` with it."""
    pairs = tree.query_pairs(radius, output_type="ndarray")
    first, second = numpy.where((priorities[pairs[:, 0]] < priorities[pairs[:, 1]])[:, None], pairs, pairs[:, ::-1]).T
    is_kept = numpy.zeros(tree.n, bool)
    is_open = numpy.ones(tree.n, bool)
    while is_open.any():
        is_beaten = numpy.zeros(tree.n, bool)
        is_beaten[second] = True
        chosen = is_open & ~is_beaten
        is_kept |= chosen
        is_open &= ~chosen
        is_open[second[chosen[first]]] = False
        is_left = is_open[first] & is_open[second]
        first, second = first[is_left], second[is_left]
    return is_kept


def poisson_disks(candidates, number, generator):
    """`number` of the candidates, as far apart as these allow."""
    tree, priorities = cKDTree(candidates), generator.permutation(len(candidates))
    distances = tree.query(candidates[:1000], 2)[0][:, 1]
    low, high = 0., 20 * float(numpy.median(distances))
    kept = numpy.ones(len(candidates), bool)
    while numpy.count_nonzero(kept) > 1.005 * number:
        radius = (low + high) / 2
        fewer = far_apart(tree, radius, priorities)
        if numpy.count_nonzero(fewer) >= number:
            low, kept = radius, fewer
        else:
            high = radius
    return candidates[generator.permutation(numpy.flatnonzero(kept))[:number]]


def radius_of_sphere(points):
    middle = (points.min(0) + points.max(0)) / 2
    return float(numpy.sqrt(((points - middle) ** 2).sum(1).max()))


def measure(build, mesh, noises, number):
    """One shape with all noises, and with the noisy points as they are beside."""
    runs = []
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(build / "bin", Path(scratch), 1)
        source = bench.sample(mesh, {"input_points": CANDIDATES_PER_POINT * number, "noise_percent": 0, "seed": 1})
        generator = numpy.random.Generator(numpy.random.PCG64(1))
        points = poisson_disks(read_points(source), number, generator)
        clean, noisy, result = (bench.scratch / f"{name}.ply" for name in ("clean", "noisy", "result"))
        write_points(clean, points)
        for noise in noises:
            deviation = noise / 100 * radius_of_sphere(points)
            write_points(noisy, points + deviation * generator.standard_normal(points.shape))
            report = bench.resample(noisy, ours("default"), number, result)["report"]
            run = {"mesh": mesh.stem, "points": number, "noise_percent": noise, "noise_over_truth": report["estimated_noise"] / deviation,
                   **{name: json.loads(bench.run("evaluate_denoising", path, clean, mesh)) for name, path in (("default", result), ("noisy", noisy))}}
            if run["default"]["number_of_points"] != number:
                raise ValueError(f"{mesh.stem}: {run['default']['number_of_points']} points instead of {number}")
            runs.append(run)
            print(f"{mesh.stem}, {number} points, noise {noise} %: P2M {p2m(run['default']):.3f}", file=sys.stderr, flush=True)
    return runs


def p2m(measured):
    return 1e4 * (measured["points_to_mesh"] + measured["mesh_to_points"])


def chamfer(measured):
    return 1e4 * measured["chamfer"]


def markdown(result):
    runs, noises, numbers = result["runs"], result["noises"], result["numbers_of_points"]
    shapes = sorted({run["mesh"] for run in runs})

    def of(number, noise, mesh=None):
        return [run for run in runs if run["points"] == number and run["noise_percent"] == noise and mesh in (None, run["mesh"])]

    def cells(number, name, mesh=None):
        return [f"{statistics.fmean(measure_of(run[name]) for run in of(number, noise, mesh)):.2f}" for noise in noises for measure_of in (chamfer, p2m)]

    def estimates(number, mesh):
        return [f"{of(number, noise, mesh)[0]['noise_over_truth']:.2f}" for noise in noises]

    lines = ["# The benchmark of learned denoising", "", "Made by", "", *(f"    {command}" for command in result["commands"]), "",
             f"{len(shapes)} of the {NUMBER_OF_TEST_SHAPES} test shapes of PU-Net (those that the set of meshes has): {', '.join(shapes)}. Poisson disks of our own, "
             "as the points of the published set cannot be had here. CD and P2M in 10^-4, squared, both directions, in the unit of the bounding sphere. Published "
             "figures are means over all shapes. Behind the distances the estimated noise over the true one.", ""]
    header = ["method", *(f"{name} {noise} %" for noise in noises for name in ("CD", "P2M"))]
    for number in numbers:
        rows = [["default", *cells(number, "default")], ["noisy points", *cells(number, "noisy")]]
        for method, published in PUBLISHED.items():
            if number in published and tuple(noises) == NOISES:
                rows.append([method, *(cell for value in published[number] for cell in ("-", f"{value:.2f}"))])
        of_shapes = [[mesh, *cells(number, "default", mesh), *estimates(number, mesh)] for mesh in shapes]
        lines += [f"## {number} points", "", table(header, rows), table(["shape", *header[1:], *(f"noise {noise} %" for noise in noises)], of_shapes)]
    return "\n".join(lines)


def main():
    parser = argument_parser(__doc__, "a thousand points and one noise, to see that everything runs")
    parser.add_argument("meshes", type=Path, help="folder of the meshes")
    parser.add_argument("--shapes", nargs="+", default=SHAPES, help="names of meshes without .off")
    parser.add_argument("--jobs", type=int, default=1, help="shapes at a time")
    arguments = parser.parse_args()
    noises, numbers = (NOISES[:1], (1000,)) if arguments.small else (NOISES, NUMBERS_OF_POINTS)
    with ThreadPoolExecutor(arguments.jobs) as pool:
        measured = [pool.submit(measure, arguments.build, arguments.meshes / f"{shape}.off", noises, number) for number in numbers for shape in arguments.shapes]
        runs = [run for one in measured for run in one.result()]
    result = {"commands": [command_line("run_punet.py", sys.argv[1:])], "noises": noises, "numbers_of_points": numbers, "runs": runs}
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
