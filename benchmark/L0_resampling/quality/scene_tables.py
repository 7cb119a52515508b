#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns what run_scenes.py measured into Markdown: scene_tables.py RESULT.json"""

import json
import math
import sys
from dataclasses import dataclass

from quality_tables import table

SUBSET = "subset"  # a random subset of the scan as it is: what the methods start from, and no rival


@dataclass(frozen=True)
class Measure:
    key: str
    heading: str
    digits: int
    scale: float = 1
    worst_ratio: float = None  # the goal for each row, as a share of the best of CGAL's pipelines
    mean_ratio: float = None  # the goal for the geometric mean


MEASURES = (
    Measure("distance", "Distance to the scene, mean, mm", 2, 1000, 1, 0.8),
    Measure("at_scan", "The same, of the points nearest to those of the scan, mean, mm", 2, 1000),
    Measure("p95", "Distance to the scene, 95th percentile, mm", 2, 1000),
    Measure("normals", "Error of normals, mean, degrees, without sign", 2, mean_ratio=0.7),
    Measure("inwards", "Normals on the wrong side, %", 2),
    Measure("uneven", "Unevenness of the spacing", 3, mean_ratio=0.5),
    Measure("lost", "Lost: the scan's points without a point of the result near, %", 2),
    Measure("ghosts", "Ghosts: points of the result without a point of the scan near, %", 2),
    Measure("seconds", "Time, seconds, one thread", 2),
)


def read_viewpoints(path):
    """Positions of the views, by their numbers, which count from 0."""
    rows = path.read_text(encoding="ascii").splitlines()
    return [[float(number) for number in row.split()] for row in rows]


def ratio(experiment, measure):
    """Of the default method to the best of CGAL's pipelines; None without them or if that is 0."""
    values = {
        name: run["measures"][measure.key] for name, run in experiment["measurements"].items()
    }
    rivals = [value for name, value in values.items() if name not in ("default", SUBSET)]
    if "default" not in values or not rivals or min(rivals) <= 0:
        return None
    return values["default"] / min(rivals)


def geometric_mean(ratios):
    return math.exp(math.fsum(map(math.log, ratios)) / len(ratios))


def verdict(measure, ratios):
    words = [
        f"Geometric mean of the ratios {geometric_mean(ratios):.2f}, largest {max(ratios):.2f}."
    ]
    if measure.mean_ratio is not None:
        met = "met" if geometric_mean(ratios) <= measure.mean_ratio else "not met"
        words.append(f"Goal for the mean, {measure.mean_ratio:g}: {met}.")
    if measure.worst_ratio is not None:
        count = sum(value <= measure.worst_ratio for value in ratios)
        words.append(
            f"Goal for each row, {measure.worst_ratio:g}: met in {count} of {len(ratios)}."
        )
    return " ".join(words) + "\n"


def section(experiments, measure):
    methods = [
        name
        for name in experiments[0]["measurements"]
        if all(name in experiment["measurements"] for experiment in experiments)
    ]
    rows = []
    for experiment in experiments:
        found = ratio(experiment, measure)
        runs = experiment["measurements"]
        values = {name: runs[name]["measures"][measure.key] for name in methods}
        rows.append(
            [
                experiment["name"],
                *(f"{values[name] * measure.scale:.{measure.digits}f}" for name in methods),
                "-" if found is None else f"{found:.2f}",
            ]
        )
    parts = [f"## {measure.heading}\n", table(["scan", *methods, "ratio"], rows)]
    ratios = [
        value for value in (ratio(experiment, measure) for experiment in experiments) if value
    ]
    if ratios:
        parts.append(verdict(measure, ratios))
    return "\n".join(parts)


def markdown(result):
    commands = "".join(f"    {command}\n" for command in result["commands"])
    experiments = result["experiments"]
    version = next(iter(experiments[0]["measurements"].values()))["cgal_version"]
    introduction = f"""# Scans of known scenes

Made by

{commands}
with CGAL {version}. `scan_scene` makes the scans; percentages in their names are errors of
registration, of the scene's diagonal. Lengths of the street, the forest and the room are in
millimeters, those of single objects in thousandths of their unit. Ratios are those of the default
method to the best of CGAL's pipelines in that row: below 1 is better. `{SUBSET}` is a random subset
of the scan as it is. A point of the scan is lost if it is farther from the result than three
spacings, of the scan there or median ones of the result. A ghost is a point of the result that is
farther than two spacings from the scan. Both are measured from where the rays really met the scene.
Even results have a larger share of their points where the scan is sparse, far away, and errors are
large. The second table weighs all methods alike: for each point of the scan it takes the point of
the result that is nearest.
"""
    sizes = table(
        ["scan", "points", "result"],
        [
            [experiment["name"], str(experiment["input_points"]), str(experiment["output_points"])]
            for experiment in experiments
        ],
    )
    return "\n".join(
        [introduction, sizes, *(section(experiments, measure) for measure in MEASURES)]
    )


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        print(markdown(json.load(stream)), end="")
