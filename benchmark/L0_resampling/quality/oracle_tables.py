#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns what run_oracle.py measured into Markdown: oracle_tables.py RESULT.json"""

import json
import sys
from pathlib import Path

from comparison_tables import DISTANCE, INWARDS, NORMALS, RECALL
from quality_tables import Column, is_ours, table

COLUMNS = (DISTANCE, NORMALS, RECALL)
TURNED = Column("of these, more than 120 degrees off, %", "normals", "share_turned", 2, scale=100)
HEADER = ("input", "best of CGAL", "default", "best radius", "true normals", "both")


def best_of_cgal(experiment):
    rivals = [run["evaluation"] for run in experiment["measurements"].values() if not is_ours([run])]
    return {column.heading: column.best(column.value([evaluation]) for evaluation in rivals) for column in COLUMNS}


def figures(experiment, column):
    """Of the method itself and of the three oracles, in the order of the header."""
    def best(normals, factors=None):
        return column.best(column.value([run["evaluation"]]) for run in experiment["runs"]
                           if run["normals"] == normals and (factors is None or run["radius_factor"] in factors))

    return [best("own normals", [1]), best("own normals"), best("true normals", [1]), best("true normals")]


def rows(result, column):
    for experiment in result["experiments"]:
        best = experiment["best_of_cgal"][column.heading]
        yield [f"{Path(experiment['mesh']).stem}, {experiment['noise_percent']:g} %", f"{best:.{column.digits}f}",
               *(f"{value:.{column.digits}f} ({value / best:.2f})" if best else f"{value:.{column.digits}f}"
                 for value in figures(experiment, column))]


def inwards_rows(result):
    for experiment in result["experiments"]:
        turned = figures(experiment, TURNED)[0]
        inwards, *of_oracles = (f"{value:.{INWARDS.digits}f}" for value in figures(experiment, INWARDS))
        yield [f"{Path(experiment['mesh']).stem}, {experiment['noise_percent']:g} %", inwards, f"{turned:.{TURNED.digits}f}", *of_oracles]


def markdown(result):
    experiment = result["experiments"][0]
    factors = sorted({run["radius_factor"] for run in experiment["runs"]})
    commands = "".join(f"    {command}\n" for command in result["commands"])
    parts = [f"""# What the default method would reach if it knew the truth

Made by

{commands}
with {experiment['input_points']} points in, {experiment['output_points']} out. *Best radius*: the one of the least
error against the mesh, of {factors[0]:g} to {factors[-1]:g} times the method's own. *True normals*: each point has that of the face
nearest to it, in place of PCA. In parentheses, the ratio to the best of CGAL's pipelines.
"""]
    for column in COLUMNS:
        parts.append(f"## {column.heading}\n\n{table(HEADER, rows(result, column))}")
    parts.append(f"## {INWARDS.heading}\n\n{table([HEADER[0], HEADER[2], TURNED.heading, *HEADER[3:]], inwards_rows(result))}")
    return "\n".join(parts)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        print(markdown(json.load(stream)), end="")
