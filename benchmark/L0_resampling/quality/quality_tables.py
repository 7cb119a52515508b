#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns what run_quality.py measured into Markdown: quality_tables.py RESULT.json"""

import json
import statistics
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import found_in, read_tables

NAMES = {"lor": "LOR", "alor": "ALOR", "default": "default",
         "wlop_4": "WLOP, radius 4", "wlop_6": "WLOP, radius 6",
         "wlop_4_uniform": "WLOP, radius 4, uniform", "wlop_6_uniform": "WLOP, radius 6, uniform",
         "ear_4": "EAR, radius 4", "smoothed_ear_6": "smoothed EAR, radius 6",
         "smoothed_ear_6_again": "smoothed EAR, radius 6, again"}


@dataclass(frozen=True)
class Column:
    heading: str
    group: str    # of the evaluation, or empty for what stands in none
    field: str
    digits: int
    scale: float = 1
    best: type(min) = min

    def value(self, evaluations):
        """Mean over the seeds; None where the mesh has no feature edges, or no point is near them."""
        groups = [evaluation[self.group] if self.group else evaluation for evaluation in evaluations]
        if any(group is None or group[self.field] is None for group in groups):
            return None
        return statistics.fmean(group[self.field] for group in groups) * self.scale


COLUMNS = [Column("mean distance, %", "distance", "mean", 4),
           Column("95th percentile, %", "distance", "p95", 4),
           Column("mean coverage, %", "coverage", "mean", 4),
           Column("normal error, degrees", "normals", "mean_error_degrees", 2),
           Column("normals inwards, %", "normals", "share_inwards", 2, scale=100),
           Column("edge recall", "features", "edge_recall", 3, best=max),
           Column("distance at edges, %", "features", "mean_distance", 4),
           Column("NN6 cv", "uniformity", "spacing_variation", 3)]


def table(header, rows):
    lines = [header, ["---"] + ["---:"] * (len(header) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def is_ours(runs):
    return runs[0]["program"] == "run_l0"


def experiment_table(measurements):
    """`measurements` maps a method to its runs, one for each seed."""
    values = {method: [column.value([run["evaluation"] for run in runs]) for column in COLUMNS]
              for method, runs in measurements.items()}
    baselines = [method for method, runs in measurements.items() if not is_ours(runs)]
    best = [None if values["default"][c] is None else column.best(values[method][c] for method in baselines)
            for c, column in enumerate(COLUMNS)]

    def cell(method, c):
        value = values[method][c]
        if value is None:
            return "-"
        text = f"{value:.{COLUMNS[c].digits}f}"
        return f"**{text}**" if method in baselines and value == best[c] else text

    rows = [[NAMES[method], *(cell(method, c) for c in range(len(COLUMNS)))] for method in measurements]
    rows.append(["default / best of CGAL",
                 *(f"{ours / theirs:.2f}" if theirs else "-" for ours, theirs in zip(values["default"], best))])
    return table(["method", *(column.heading for column in COLUMNS)], rows)


def read_figures(text):
    """The figures of what markdown() has made of one mesh, as they are printed.

    They are found by noise, method and heading of the column. Of the method "best", they are the
    best of CGAL.
    """
    methods = {name: method for method, name in NAMES.items()}
    figures = {}
    for table_of_noise in read_tables(text):
        noise, = found_in(r"noise ([\d.]+) %", table_of_noise.heading)
        of_noise = figures.setdefault(float(noise), {"best": {}})
        for name, *cells in table_of_noise.rows[:-1]:    # the last one has ratios
            of_noise[methods[name]] = {}
            for heading, cell in zip(table_of_noise.header[1:], cells, strict=True):
                of_noise[methods[name]][heading] = cell.strip("*")
                if cell.startswith("**"):
                    of_noise["best"][heading] = cell.strip("*")
    return figures


def group(experiments, names=("mesh", "noise_percent", "input_points", "output_points")):
    """Experiments that have these in common, and differ by their seed alone, stand together."""
    groups = {}
    for experiment in experiments:
        groups.setdefault(tuple(experiment[name] for name in names), []).append(experiment)
    return groups


def introduction(result):
    version = next(iter(result["experiments"][0]["measurements"].values()))["cgal_version"]
    commands = "".join(f"    {command}\n" for command in result["commands"])
    origin = f" The meshes are from {result['mesh_origin']}." if result["mesh_origin"] else ""
    return f"""# Quality

Made by

{commands}
with CGAL {version}.{origin}
Points uniform by area, each coordinate with Gaussian noise whose standard deviation is given in % of the diagonal of
the mesh's bounding box, as all lengths below. Distance is from the result to the mesh, coverage from the mesh to the
nearest point of the result. A normal's error disregards its sign, which the next column counts. Edges are those of 30
degrees and more; recall is the share of their length with a point within two median spacings, points at edges are those
within 1.5 %. NN6 cv is the coefficient of variation of the mean distance to the 6 nearest neighbors. Recall and
uniformity mean little where the distance is large: points that keep their noise are near every edge.

Radii are multiples of the average spacing; uniform is `require_uniform_sampling`; normals of WLOP are PCA normals
oriented over a spanning tree. EAR is the pipeline WLOP, normals, bilateral smoothing, edge-aware upsampling with the
parameters of CGAL's example (25 degrees, edge sensitivity 0). Smoothed EAR has normals and bilateral smoothing of the
whole input first, then WLOP with uniform sampling, normals and upsampling; "again" smooths also after WLOP. The best
figure of CGAL in each column is bold; the last row divides that of `default` by it: below 1 is better, but for recall.
"""


def markdown(result):
    parts = [introduction(result)]
    for (mesh, noise, input_points, output_points), experiments in group(result["experiments"]).items():
        seeds = [experiment["seed"] for experiment in experiments]
        methods = experiments[0]["measurements"]
        parts += [f"## {mesh}, noise {noise:g} %\n\n{input_points} points in, {output_points} out, "
                  + (f"seed {seeds[0]}.\n" if len(seeds) == 1 else f"means over {len(seeds)} seeds.\n"),
                  experiment_table({method: [experiment["measurements"][method] for experiment in experiments]
                                    for method in methods})]
    return "\n".join(parts)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        print(markdown(json.load(stream)), end="")
