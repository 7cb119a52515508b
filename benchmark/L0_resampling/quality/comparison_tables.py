#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns what run_comparison.py measured into Markdown: comparison_tables.py RESULT.json"""

import json
import sys
from dataclasses import dataclass
from pathlib import Path

from quality_tables import COLUMNS, group, is_ours, table

DISTANCE, NORMALS, RECALL, EVENNESS, INWARDS = (
    next(column for column in COLUMNS if column.heading == heading)
    for heading in ("mean distance, %", "normal error, degrees", "edge recall", "NN6 cv", "normals inwards, %"))
SHOWN = (DISTANCE, NORMALS, RECALL, EVENNESS, INWARDS)

INPUT_NAMES = ("mesh", "noise_percent", "outliers_percent", "density_gradient")

ORGANIC_SHAPES = ("armadillo.off",)


@dataclass(frozen=True)
class Row:
    """One input, means over its seeds. Of what the mesh has none, the values are None."""
    mesh: str
    noise_percent: float
    outliers_percent: float
    density_gradient: float
    ours: dict    # from a column to the figure of the default method
    best: dict    # to the best figure of CGAL's pipelines

    @property
    def has_edges(self):
        return self.mesh not in ORGANIC_SHAPES

    @property
    def name(self):
        words = [Path(self.mesh).stem, f"{self.noise_percent:g} %"]
        if self.outliers_percent > 0:
            words.append(f"{self.outliers_percent:g} % outliers")
        if self.density_gradient != 1:
            words.append(f"gradient {self.density_gradient:g}")
        return ", ".join(words)

    def ratio(self, column):
        """None where the best is zero too, as noiseless input or right signs can be."""
        if self.ours[column] is None or self.best[column] == 0:
            return None
        return self.ours[column] / self.best[column]


def rows_of(result):
    rows = []
    for key, experiments in group(result["experiments"], INPUT_NAMES).items():
        methods = experiments[0]["measurements"]
        runs = {method: [experiment["measurements"][method] for experiment in experiments] for method in methods}
        values = {column: {method: column.value([run["evaluation"] for run in runs[method]]) for method in methods}
                  for column in COLUMNS}
        rivals = [method for method in methods if not is_ours(runs[method])]
        figures = {column: values[column]["default"] for column in COLUMNS}
        best = {column: None if figures[column] is None else column.best(values[column][method] for method in rivals)
                for column in COLUMNS}
        rows.append(Row(*key, figures, best))
    return rows


def row_cells(row):
    def cell(column):
        if row.ours[column] is None:
            return "-"
        text = f"{row.ours[column]:.{column.digits}f}"
        ratio = row.ratio(column)
        return text if ratio is None else f"{text} ({ratio:.2f})"

    return [row.name, *map(cell, SHOWN)]


@dataclass(frozen=True)
class Goal:
    """A figure of each row it concerns, which has to be at most the limit, or at least, where `best` is max."""
    name: str
    limit: float
    figure: object     # from a row to a number, or None
    concerns: object   # from a row to whether the goal is one for it
    best: type(min) = min

    def is_met(self, value):
        return value >= self.limit if self.best is max else value <= self.limit

    def outcome(self, rows):
        """The rows' figures, from the worst to the best."""
        found = [(self.figure(row), row) for row in rows if self.concerns(row) and self.figure(row) is not None]
        return sorted(found, key=lambda pair: pair[0], reverse=self.best is min)


def ratio_goals(column, kind, concerns, limit):
    name = column.heading.split(",")[0]
    return [Goal(f"{name}, {kind}: at most {bound:g} of the best of CGAL", bound,
                 lambda row: row.ratio(column), concerns) for bound in (limit, 1)]


def has_edges(row):
    return row.has_edges


def is_organic(row):
    return not row.has_edges


GOALS = [*ratio_goals(DISTANCE, "shapes with sharp edges", has_edges, 0.6),
         *ratio_goals(NORMALS, "shapes with sharp edges", has_edges, 0.6),
         *ratio_goals(DISTANCE, "organic shapes", is_organic, 0.8),
         *ratio_goals(NORMALS, "organic shapes", is_organic, 0.8),
         Goal("edge recall, shapes with sharp edges: at least 0.98", 0.98, lambda row: row.ours[RECALL], has_edges,
              max),
         Goal("NN6 cv: at most that of the best of CGAL", 1, lambda row: row.ratio(EVENNESS), lambda row: True),
         Goal("NN6 cv, noise of at most 1 %: at most 0.16", 0.16, lambda row: row.ours[EVENNESS],
              lambda row: row.noise_percent <= 1),
         Goal("normals inwards: at most 0.1 %", 0.1, lambda row: row.ours[INWARDS], lambda row: True)]


def goal_cells(goal, rows):
    outcome = goal.outcome(rows)
    if not outcome:
        return [goal.name, "-", "-", "-"]
    met = sum(goal.is_met(value) for value, _ in outcome)
    value, row = outcome[0]
    verdict = "met" if met == len(outcome) else "not met"
    return [goal.name, verdict, f"{met} of {len(outcome)}", f"{value:.3g}: {row.name}"]


def introduction(result):
    experiment = result["experiments"][0]
    version = next(iter(experiment["measurements"].values()))["cgal_version"]
    seeds = len({experiment["seed"] for experiment in result["experiments"]})
    rivals = ", ".join(name for name, run in experiment["measurements"].items() if not is_ours([run]))
    commands = "".join(f"    {command}\n" for command in result["commands"])
    return f"""# Comparison with the best of CGAL

Made by

{commands}
with CGAL {version}: {experiment['input_points']} points in, {experiment['output_points']} out, seeds: {seeds}.
Noise is the standard deviation of each coordinate, in % of the diagonal of the mesh's bounding box, as the distances.
Outliers are uniform in the box grown by a tenth; the gradient is the ratio of densities at the two ends of the longest
axis. A figure of the default method is followed, in parentheses, by its ratio to the best figure that any of CGAL's
pipelines has in that column and row, so that no single pipeline has all of these: below 1 is better, but for recall.
Where there is no ratio, the best figure is zero. The pipelines, named with their radius in spacings:
{rivals}.
Where there are outliers, these pipelines get the points that CGAL's `remove_outliers()` leaves, which is told the share
of outliers; the default method gets all points.
{result.get("note", "")}"""


def markdown(result):
    rows = rows_of(result)
    header = ["input", *(column.heading for column in SHOWN)]
    goals = """## Goals

They were set before anything was measured. The Poisson mesh of the result and the time have goals too, which this
table does not measure.
"""
    return "\n".join([introduction(result), table(header, map(row_cells, rows)), goals,
                      table(["goal", "", "rows", "worst"], [goal_cells(goal, rows) for goal in GOALS])])


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        print(markdown(json.load(stream)), end="")
