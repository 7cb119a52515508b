#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the files that `run_poisson.py --small` wrote: check_poisson.py OUTPUT

Each method has a mesh near the truth, as noise and resolution allow, and the table has the figures that were measured.
"""

import sys
from pathlib import Path

from check_comparison import table_after
from poisson_tables import MEASURES, own_and_best
from quality_bench import load_raw
from results import tables_file

METHODS = {"default", "wlop_4", "wlop_4_uniform", "ear_4", "smoothed_ear_4"}


def errors(output):
    result = load_raw(output)
    text = tables_file(output).read_text(encoding="utf-8")
    for experiment in result["experiments"]:
        if experiment["measurements"].keys() != METHODS:
            yield f"the methods are {sorted(experiment['measurements'])}"
        for name, run in experiment["measurements"].items():
            surface = run["surface"]
            if surface is None:
                yield f"{name} has no mesh"
            elif not 0 < surface["mean_distance"] < 5 * experiment["noise_percent"]:
                yield f"the mesh of {name} is {surface['mean_distance']} % off"
            elif not max(surface["mean_distance"], surface["mean_coverage"]) < surface["hausdorff"] < 10:
                yield f"the mesh of {name} has means of {surface['mean_distance']} and {surface['mean_coverage']} %, and " \
                      f"{surface['hausdorff']} % at most"
    _, rows = table_after(text, "# Poisson")
    if len(rows) != len(result["experiments"]):
        yield f"the table has {len(rows)} rows"
    for experiment, row in zip(result["experiments"], rows):
        for measure, cell in zip(MEASURES, row[1:]):
            own, best = own_and_best(experiment, measure)
            if cell != f"{own:.3f} ({own / best:.2f})":
                yield f"{measure} is {cell} in the table, and {own} measured, of CGAL's best {best}"
    _, goals = table_after(text, "## Goals")
    if len(goals) != len(MEASURES):
        yield f"there are {len(goals)} goals"


if __name__ == "__main__":
    found = list(errors(Path(sys.argv[1])))
    for error in found:
        print("check_poisson:", error, file=sys.stderr)
    sys.exit(1 if found else 0)
