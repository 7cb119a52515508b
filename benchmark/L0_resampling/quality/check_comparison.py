#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the files that `run_comparison.py --small` wrote: check_comparison.py OUTPUT

The rows and columns have to be there, and the ratios have to be those of the figures; how good they are is not judged.
"""

import sys
from pathlib import Path

from comparison_tables import GOALS, SHOWN, rows_of
from quality_bench import load_raw
from results import read_tables, tables_file

COLUMNS = ["mean distance, %", "normal error, degrees", "edge recall", "NN6 cv", "normals inwards, %"]


def table_after(text, heading):
    """Header and rows of the first table after a heading."""
    table = read_tables(text[text.index(heading):])[0]
    return table.header, table.rows


def errors(output):
    result = load_raw(output)
    text = tables_file(output).read_text(encoding="utf-8")
    inputs = [(experiment["noise_percent"], experiment["outliers_percent"], experiment["density_gradient"])
              for experiment in result["experiments"]]
    if inputs != [(0.5, 0, 1), (0.5, 5, 1), (0.5, 0, 10)]:
        yield f"the inputs are {inputs}"
    methods = {"default", "wlop_4", "wlop_4_uniform", "ear_4", "smoothed_ear_4"}
    for experiment in result["experiments"]:
        if experiment["measurements"].keys() != methods:
            yield f"the methods are {sorted(experiment['measurements'])}"

    header, rows = table_after(text, "# Comparison")
    if header != ["input", *COLUMNS]:
        yield f"the columns are {header}"
    if len(rows) != len(inputs) or any(len(row) != len(header) for row in rows):
        yield "the table lacks cells"
    header, goals = table_after(text, "## Goals")
    if [row[0] for row in goals] != [goal.name for goal in GOALS]:
        yield "the goals are not all there"
    for row in rows_of(result):
        runs = experiment_of(result, row)["measurements"].values()
        rivals = [run["evaluation"] for run in runs if run["program"] != "run_l0"]
        for column in SHOWN:
            if row.best[column] != column.best(column.value([evaluation]) for evaluation in rivals):
                yield f"{row.name}: the best {column.heading} is not that of the pipelines"


def experiment_of(result, row):
    key = (row.outliers_percent, row.density_gradient)
    return next(experiment for experiment in result["experiments"]
                if (experiment["outliers_percent"], experiment["density_gradient"]) == key)


if __name__ == "__main__":
    found = list(errors(Path(sys.argv[1])))
    for error in found:
        print("check_comparison:", error, file=sys.stderr)
    sys.exit(1 if found else 0)
