#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how well the creases of results follow the edges of meshes.

Points are sampled from each mesh with noise and resampled to half as many, with creases. Lines that
are nearer than three spacings to an edge of 30 degrees or more have a distance, others are astray;
an edge is covered where a line is within a spacing. Of smooth shapes, all lines are astray.
"""

import json
import math
import os
import sys
import tempfile
from pathlib import Path

from quality_bench import Bench, argument_parser, command_line, mesh_of, write_result
from quality_tables import table

SHAPES = ("cube", "bolt", "cone", "staircase", "bracket", "dodecahedron", "torus", "ellipsoid")
SCANNED = ("fandisk", "joint", "anchor_dense", "couplingdown")  # of the folder of meshes
NOISE_PERCENT = (0.1, 0.3, 0.5, 0.7, 1, 1.2)
INPUT_POINTS, OUTPUT_POINTS = 60_000, 30_000
STEPS = 96


def hexagon(radius, angle):
    """A place on a hexagon whose sides are this far from its middle."""
    rest = (angle + math.pi / 6) % (math.pi / 3) - math.pi / 6
    return radius / math.cos(rest)


def turned(profile):
    """A closed mesh of rings: radius as a function of the angle, and height, from below to above."""
    rings = [[(r(a) * math.cos(a), r(a) * math.sin(a), z)
              for a in (2 * math.pi * k / STEPS for k in range(STEPS))] for r, z in profile]
    vertices = [p for ring in rings for p in ring] + [(0, 0, profile[0][1]), (0, 0, profile[-1][1])]
    below, above = len(vertices) - 2, len(vertices) - 1
    faces = []
    for k in range(STEPS):
        n = (k + 1) % STEPS
        faces.append((below, n, k))
        for ring in range(len(rings) - 1):
            a, b = ring * STEPS + k, ring * STEPS + n
            faces += [(a, b, b + STEPS), (a, b + STEPS, a + STEPS)]
        last = (len(rings) - 1) * STEPS
        faces.append((above, last + k, last + n))
    return vertices, faces


def made(shape):
    if shape == "bolt":    # with a hexagonal head
        return turned([(lambda a: hexagon(1, a), 0), (lambda a: hexagon(1, a), 0.7),
                       (lambda a: 0.55, 0.7), (lambda a: 0.55, 2.5)])
    if shape == "cone":    # the edge of its base has 68 degrees more than its flank
        return turned([(lambda a: 1, 0), (lambda a: 0.6, 1)])
    if shape == "cube":
        return turned([(lambda a: 1 / max(abs(math.cos(a)), abs(math.sin(a))), z) for z in (-1, 1)])
    rings = 64             # an ellipsoid, which has no edge
    return turned([(lambda a, t=t: math.sin(t), -0.6 * math.cos(t))
                   for t in (math.pi * (k + 0.5) / rings for k in range(rings))])


def mesh_file(shape, meshes, scratch):
    if shape not in ("bolt", "cone", "cube", "ellipsoid"):
        return mesh_of(shape, meshes)
    vertices, faces = made(shape)
    path = scratch / f"{shape}.off"
    path.write_text("\n".join([f"OFF\n{len(vertices)} {len(faces)} 0",
                               *(f"{x:.9g} {y:.9g} {z:.9g}" for x, y, z in vertices),
                               *(f"3 {a} {b} {c}" for a, b, c in faces), ""]), encoding="ascii")
    return path


def measure(bench, shape, mesh, noise, input_points, output_points):
    experiment = {"mesh": shape, "noise_percent": noise, "seed": 1, "input_points": input_points,
                  "output_points": output_points}
    source = bench.sample(mesh, experiment)
    lines = bench.scratch / "creases.obj"
    bench.run("l0_resample", source, bench.scratch / "result.ply", "--force", "--quiet",
              "--points", output_points, "--device", "cpu", "--creases", lines,
              "--json", bench.scratch / "report.json")
    report = json.loads((bench.scratch / "report.json").read_text(encoding="utf-8"))
    seconds = {stage["name"]: stage["seconds"] for stage in report["resampling"]["stages"]}
    experiment["share_of_time"] = seconds["creases"] / sum(seconds.values())
    experiment["creases"] = json.loads(bench.run("evaluate_creases", lines, mesh,
                                                 "--points", output_points))
    return experiment


def markdown(result):
    lines = ["# Creases", "", "Made by", "", *(f"    {command}" for command in result["commands"]),
             "",
             f"{result['experiments'][0]['input_points']} points in, "
             f"{result['experiments'][0]['output_points']} out. Lengths are in spacings of the "
             "result. Edges are those of 30 degrees or more. The time is that of the stage, of "
             f"all, on {os.cpu_count()} threads.", ""]
    header = ["noise, %", "distance", "covered", "astray", "length, of edges",
              "corners found (false)", "time, %"]
    rows = []
    for noise in result["noises"]:
        runs = [run for run in result["experiments"]
                if run["noise_percent"] == noise and run["creases"]["length_of_edges"] > 0]
        found = [run["creases"] for run in runs]
        mean = {key: sum(one[key] for one in found) / len(found)
                for key in ("distance", "covered", "astray")}
        total = {key: sum(one[key] for one in found)
                 for key in ("corners", "corners_found", "false_corners")}
        rows.append([f"{noise:g}", f"{mean['distance']:.2f}", f"{mean['covered']:.3f}",
                     f"{mean['astray']:.3f}", "",
                     f"{total['corners_found']} of {total['corners']} ({total['false_corners']})",
                     f"{100 * sum(run['share_of_time'] for run in runs) / len(runs):.1f}"])
    lines += ["## Mean of shapes with edges", "", table(header, rows)]
    for shape in dict.fromkeys(run["mesh"] for run in result["experiments"]):
        rows = []
        for run in (run for run in result["experiments"] if run["mesh"] == shape):
            found = run["creases"]
            has_edges = found["length_of_edges"] > 0
            rows.append([f"{run['noise_percent']:g}",
                         f"{found['distance']:.2f}" if has_edges else "-",
                         f"{found['covered']:.3f}" if has_edges else "-",
                         f"{found['astray']:.3f}",
                         f"{found['length']:.0f} of {found['length_of_edges']:.0f}",
                         f"{found['corners_found']} of {found['corners']} "
                         f"({found['false_corners']})",
                         f"{100 * run['share_of_time']:.1f}"])
        lines += [f"## {shape}", "", table(header, rows)]
    return "\n".join(lines)


def main():
    parser = argument_parser(__doc__, "a few points of two shapes, to see that everything runs")
    parser.add_argument("--meshes", type=Path, metavar="FOLDER",
                        help=f"that has {', '.join(SCANNED)} too, as OFF, of CGAL's demo data")
    arguments = parser.parse_args()
    shapes, noises, factor = ((("cube", "torus"), (0.5,), 0.2) if arguments.small else
                              ((*SHAPES, *(SCANNED if arguments.meshes else ())), NOISE_PERCENT, 1))
    result = {"commands": [command_line("run_creases.py", sys.argv[1:])], "noises": noises,
              "experiments": []}
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), 1)
        for shape in shapes:
            mesh = mesh_file(shape, arguments.meshes, Path(scratch))
            result["experiments"] += [
                measure(bench, shape, mesh, noise, round(factor * INPUT_POINTS),
                        round(factor * OUTPUT_POINTS)) for noise in noises]
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
