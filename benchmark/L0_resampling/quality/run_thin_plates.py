#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how thin a plate may be before its two sheets become one, without noise and with some.

The plates are 1 x 0.7 wide and as thick as so many spacings of the points, of which r_p of the default method covers four where they are clean. There is
a table for each method.
"""

import sys
import tempfile
from pathlib import Path

from quality_bench import Bench, argument_parser, command_line, mesh_of, write_result
from quality_tables import table

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ours, wlop

METHODS = {"default": ours("default"), "LOR": ours("lor"), "WLOP": wlop(4)}
THICKNESSES = (1.2, 1.6, 2, 2.4, 3.2, 4, 6, 12)    # in spacings
NOISES = (0, 1 / 8, 1 / 6, 1 / 5, 1 / 4)           # standard deviation, in thicknesses
INPUT_POINTS, OUTPUT_POINTS = 12_000, 8_000
PLATE, ITS_THICKNESS, WIDTH, DEPTH = mesh_of("thin_plate", None), "0.025", 1, 0.7


def measure(bench, spacings, noise, input_points, output_points):
    thickness = spacings * (2 * WIDTH * DEPTH / input_points) ** 0.5
    mesh = bench.scratch / "plate.off"
    mesh.write_text(PLATE.read_text(encoding="ascii").replace(ITS_THICKNESS, f"{thickness:.6f}"), encoding="ascii")
    diagonal = (WIDTH**2 + DEPTH**2 + thickness**2) ** 0.5
    experiment = {"mesh": mesh.name, "spacings": spacings, "thickness_percent": 100 * thickness / diagonal, "noise_per_thickness": noise,
                  "noise_percent": 100 * noise * thickness / diagonal, "seed": 1, "input_points": input_points, "output_points": output_points,
                  "measurements": {}}
    source = bench.sample(mesh, experiment)
    bench.measure_all(mesh, experiment, METHODS, lambda _: source)
    return experiment


def markdown(result):
    lines = ["# Plates that become thinner", "", "Made by", "", *(f"    {command}" for command in result["commands"]), "",
             f"Plates of {WIDTH} x {DEPTH}, {result['experiments'][0]['input_points']} points in, {result['experiments'][0]['output_points']} out. Each cell has the mean "
             "distance to the plate in % of its thickness, which is 50 half-way between the sheets, and behind the stroke the normals inwards, in %.", ""]
    header = ["thickness, spacings", *("no noise" if noise == 0 else f"noise 1/{round(1 / noise)} of it" for noise in result["noises"])]
    for method in METHODS:
        rows = []
        for spacings in result["thicknesses"]:
            of_row = {run["noise_per_thickness"]: run for run in result["experiments"] if run["spacings"] == spacings}
            cells = []
            for noise in result["noises"]:
                evaluation = of_row[noise]["measurements"][method]["evaluation"]
                cells.append(f"{100 * evaluation['distance']['mean'] / of_row[noise]['thickness_percent']:.1f} / "
                             f"{100 * evaluation['normals']['share_inwards']:.1f}")
            rows.append([f"{spacings:g}", *cells])
        lines += [f"## {method}", "", table(header, rows)]
    return "\n".join(lines)


def main():
    parser = argument_parser(__doc__, "a tenth of the points on one plate, to see that everything runs")
    arguments = parser.parse_args()
    thicknesses, noises, factor = ((4,), (0, 1 / 8), 0.1) if arguments.small else (THICKNESSES, NOISES, 1)
    result = {"commands": [command_line("run_thin_plates.py", sys.argv[1:])], "thicknesses": thicknesses, "noises": noises, "experiments": []}
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), 1)
        result["experiments"] = [measure(bench, spacings, noise, round(factor * INPUT_POINTS), round(factor * OUTPUT_POINTS))
                                 for spacings in thicknesses for noise in noises]
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
