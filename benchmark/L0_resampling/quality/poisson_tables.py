#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns what run_poisson.py measured into Markdown: poisson_tables.py RESULT.json"""

import json
import sys
from pathlib import Path

from quality_tables import is_ours, table

MEASURES = {"mean_distance": "mesh to truth, mean, %", "mean_coverage": "truth to mesh, mean, %", "hausdorff": "Hausdorff, %"}

EXACT = "surface_of_exact_points"


def name_of(experiment):
    return f"{Path(experiment['mesh']).stem}, {experiment['noise_percent']:g} %"


def own_and_best(experiment, measure, surface="surface"):
    """The figure of the default method and the best of CGAL's pipelines; None where no mesh could be made."""
    runs = experiment["measurements"].values()
    own = next(run[surface] for run in runs if is_ours([run]))
    rivals = [run["surface"][measure] for run in runs if not is_ours([run]) and run["surface"]]
    return own[measure] if own else None, min(rivals, default=None)


def cell(experiment, measure, surface="surface"):
    own, best = own_and_best(experiment, measure, surface)
    if own is None:
        return "fails"
    return f"{own:.3f} ({own / best:.2f})" if best else f"{own:.3f}"


def finest_distance(result):
    return min((run["surface_distance"] for experiment in result["experiments"]
                for run in experiment["measurements"].values() if run["surface_distance"]), default=float("nan"))


def remark_cell(experiment, finest):
    """The meshes that follow their surface less closely, or are missing."""
    distances = {name: run["surface_distance"] for name, run in experiment["measurements"].items()}
    coarser = [name for name, distance in distances.items() if distance and distance > finest]
    failed = [name for name, distance in distances.items() if distance is None]
    return "; ".join(f"{word}: {', '.join(names)}" for word, names in (("coarser", coarser), ("failed", failed)) if names) or "-"


def goal_rows(result, surface="surface"):
    for measure, heading in MEASURES.items():
        figures = [(own_and_best(experiment, measure, surface), name_of(experiment)) for experiment in result["experiments"]]
        ratios = sorted(((own / best if own is not None else float("inf"), name) for (own, best), name in figures if best),
                        reverse=True)
        met = sum(ratio < 1 for ratio, _ in ratios)
        yield [f"{heading}: less than the best of CGAL", "met" if met == len(ratios) else "not met", f"{met} of {len(ratios)}",
               f"{ratios[0][0]:.3g}: {ratios[0][1]}" if ratios else "-"]


def markdown(result):
    experiment = result["experiments"][0]
    runs, finest = experiment["measurements"], finest_distance(result)
    commands = "".join(f"    {command}\n" for command in result["commands"])
    rows = [[name_of(e), *(cell(e, measure) for measure in MEASURES), remark_cell(e, finest)] for e in result["experiments"]]
    exact_rows = [[name_of(e), *(cell(e, measure, EXACT) for measure in MEASURES)] for e in result["experiments"]]
    return "\n".join([f"""# Poisson meshes of the results

Made by

{commands}
with CGAL {next(iter(runs.values()))['cgal_version']}: {experiment['input_points']} points in, {experiment['output_points']} out.
Each result becomes a mesh by CGAL's Poisson reconstruction, within {finest:g} spacings of its surface, where such a
mesh can be made; the last column names the others. Distances are taken at points uniform by area, in % of the diagonal of the true
mesh. In parentheses, the ratio to the best figure of CGAL's pipelines in that row and column:
{", ".join(name for name, run in runs.items() if not is_ours([run]))}.
""", table(["input", *MEASURES.values(), "coarser meshes"], rows), "## Goals\n",
                      table(["goal", "", "rows", "worst"], goal_rows(result)), """## Meshes of exact points

The same points once more, each moved to the nearest one of the true mesh, with its normal there: what a method without any
error would make of them.
""", table(["input", *MEASURES.values()], exact_rows), """## Goals for exact points
""", table(["goal", "", "rows", "worst"], goal_rows(result, EXACT))])


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        print(markdown(json.load(stream)), end="")
