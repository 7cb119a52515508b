#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns what run_ablation.py measured into Markdown: ablation_tables.py RESULT.json"""

import json
import statistics
import sys
from pathlib import Path

from comparison_tables import DISTANCE, EVENNESS, INPUT_NAMES, INWARDS, NORMALS, RECALL
from quality_tables import Column, group, table

GAPS = Column("99th percentile of coverage, %", "coverage", "p99", 3)
RELATIVE = (DISTANCE, NORMALS, RECALL, EVENNESS, GAPS)   # inwards may be zero


def input_name(key):
    mesh, noise, outliers, gradient = key
    words = [f"{Path(mesh).stem} {noise:g} %"]
    if outliers > 0:
        words.append("outliers")
    if gradient != 1:
        words.append("gradient")
    return ", ".join(words)


class Ablation:
    """Means over the seeds, by variant and input; inputs are keys of (mesh, noise, outliers, gradient)."""

    def __init__(self, result):
        self.descriptions = result["variants"]
        self.experiments = group(result["experiments"], INPUT_NAMES)
        self.inputs = list(self.experiments)
        self.variants = [name for name in self.descriptions if name != "full"]

    def value(self, variant, key, column):
        """None where the mesh has no edges."""
        return column.value([experiment["measurements"][variant]["evaluation"] for experiment in self.experiments[key]])

    def ratio(self, variant, key, column):
        whole = self.value("full", key, column)
        return None if whole is None else self.value(variant, key, column) / whole

    def ratios(self, variant, column):
        found = (self.ratio(variant, key, column) for key in self.inputs)
        return [ratio for ratio in found if ratio is not None]

    def mean_time(self, variant):
        """Relative to the whole method's."""
        return statistics.geometric_mean(experiment["measurements"][variant]["relative_time"]
                                         for experiments in self.experiments.values() for experiment in experiments)

    def mean_ratio(self, variant, column):
        """Geometric; arithmetic for recall, which may be zero."""
        mean = statistics.fmean if column is RECALL else statistics.geometric_mean
        return mean(self.ratios(variant, column))

    def worst_ratio(self, variant, column):
        """The one that speaks most for the ingredient."""
        return (min if column.best is max else max)(self.ratios(variant, column))


def overview(ablation):
    header = ["in place of the whole method",
              *(f"{column.heading.split(',')[0]}: mean (worst)" for column in RELATIVE), "time"]
    rows = [[ablation.descriptions[variant],
             *(f"{ablation.mean_ratio(variant, column):.2f} ({ablation.worst_ratio(variant, column):.2f})"
               for column in RELATIVE), f"{ablation.mean_time(variant):.2f}"]
            for variant in ablation.variants]
    return table(header, rows)


def relative_table(ablation, column):
    def text(value, digits):
        return "-" if value is None else f"{value:.{digits}f}"

    whole = [text(ablation.value("full", key, column), column.digits) for key in ablation.inputs]
    rows = [[ablation.descriptions[variant],
             *(text(ablation.ratio(variant, key, column), 2) for key in ablation.inputs)]
            for variant in ablation.variants]
    return table([column.heading, *map(input_name, ablation.inputs)], [[ablation.descriptions["full"], *whole], *rows])


def absolute_table(ablation, column):
    rows = [[ablation.descriptions[variant],
             *(f"{ablation.value(variant, key, column):.{column.digits}f}" for key in ablation.inputs)]
            for variant in ("full", *ablation.variants)]
    return table([column.heading, *map(input_name, ablation.inputs)], rows)


def markdown(result):
    ablation = Ablation(result)
    experiment = result["experiments"][0]
    seeds = len({experiment["seed"] for experiment in result["experiments"]})
    commands = "".join(f"    {command}\n" for command in result["commands"])
    introduction = f"""# What each ingredient of the default method gains

Made by

{commands}
with {experiment['input_points']} points in, {experiment['output_points']} out, seeds: {seeds}.
Each row has one ingredient switched off, or the paper's form of it, and all others as they are. Figures are relative to
those of the whole method: above 1, the ingredient gains that much; for recall, below 1. The first table has the
geometric mean over the inputs (for recall, which may be zero, the arithmetic mean) and, in parentheses, the figure of
the input that speaks most for the ingredient; its last column is the CPU time, of runs side by side, and below 1 the
ingredient costs that much. The others have each input, and the figures of the whole method in the first row.
"""
    return "\n".join([introduction, "## Overview\n", overview(ablation),
                      *(f"## {column.heading}\n\n{relative_table(ablation, column)}" for column in RELATIVE),
                      f"## {INWARDS.heading}\n\nNot relative, as the share may be zero.\n",
                      absolute_table(ablation, INWARDS)])


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        print(markdown(json.load(stream)), end="")
