# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a report, made from its JSON: lists of cells, for Markdown and for the page alike."""

import sys
from dataclasses import dataclass
from pathlib import Path

sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("methods", "quality")]
from methods import ROWS
from quality_tables import COLUMNS

# Table 1 of the paper, seconds: shape -> |Q|, |P|, then LOR and ALOR: Init, BF, OLHS, L0, total
PAPER_TABLE_1 = {
    "fandisk": (110_000, 60_000, (2.1, 3.5, None, 350.6, 356.2), (2.1, 3.5, 2.1, 42.5, 50.2)),
    "armadillo": (100_000, 80_000, (3.8, 4.7, None, 956.1, 964.6), (3.8, 4.7, 4.5, 99.6, 112.6)),
    "anchor_dense": (120_000, 83_000, (2.1, 3.2, None, 537.5, 542.8), (2.1, 3.2, 1.9, 55.3, 62.5)),
}


@dataclass(frozen=True)
class Table:
    header: list
    rows: list    # of texts; numbers stand to the right, so all columns but the first `left` do
    left: int = 1

    def markdown(self):
        lines = [self.header, ["---"] * self.left + ["---:"] * (len(self.header) - self.left), *self.rows]
        return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}f}"


def seconds(value):
    return "-" if value is None else f"{value:.3g}"


def name_of_input(experiment):
    words = [Path(experiment["mesh"]).stem]
    if "noise_percent" in experiment:
        words.append(f"noise {experiment['noise_percent']:g} %")
    if experiment.get("density_gradient", 1) != 1:
        words.append(f"density gradient {experiment['density_gradient']:g}")
    return ", ".join(words) + f", {experiment['input_points']} points to {experiment['output_points']}"


def total_seconds(runs, method, solver):
    return next(run["total"] for run in runs if run["method"] == method and run["solver"] == solver)


def speed_up(runs, solver):
    """Of ALOR over LOR."""
    return total_seconds(runs, "LOR", solver) / total_seconds(runs, "ALOR", solver)


def table_1(report):
    rows = []
    for model in report["table_1"]:
        paper = PAPER_TABLE_1.get(model["shape"]) if f"{model['shape']}.off" == model["mesh"] else None
        if paper:
            for method, times in zip(("LOR", "ALOR"), paper[2:]):
                speed = seconds(paper[2][-1] / paper[3][-1]) if method == "ALOR" else ""
                rows.append([f"{model['shape']}, {paper[0]} points to {paper[1]}", method, "printed in the paper",
                             *map(seconds, times), speed])
        for run in model["runs"]:
            solver = {"rows": "the paper's rows, CGLS", "block": "collapsed, block CG"}[run["solver"]]
            olhs = run["olhs"] if run["olhs"] > 0 else None
            speed = seconds(speed_up(model["runs"], run["solver"])) if run["method"] == "ALOR" else ""
            rows.append([name_of_input(model), run["method"], solver,
                         *map(seconds, (run["init"], run["bf"], olhs, run["l0"], run["total"])), speed])
    return Table(["input", "method", "solver", "Init, s", "BF, s", "OLHS, s", "L0, s", "total, s", "speed-up"], rows, 3)


def device_table(report):
    return Table(["points in", "points out", "method", "milliseconds"],
                 [[str(run["points_in"]), str(run["points_out"]), run["method"], f"{1e3 * run['seconds']:.3g}"]
                  for run in report["device_runs"]["runs"]], 0)


def study_table(experiment):
    """Fig. 2, 4 and 5."""
    rows = []
    for study in experiment["studies"]:
        evaluation, scene = study["evaluation"], study["scene"]
        rows.append([study["title"], number(evaluation["uniformity"]["density_variation"], 4),
                     number(evaluation["uniformity"]["spacing_variation"]), number(evaluation["distance"]["mean"], 4),
                     number(scene.get("mesh_distance", {}).get("mean"), 4), seconds(study["wall_seconds"])])
    return Table(["variant of LOR", "density cv", "NN6 cv", "mean distance, %", "of the Poisson mesh, %", "seconds"], rows)


def normal_weight_table(experiment):
    rows = []
    for run in experiment["runs"]:
        evaluation = run["evaluation"]
        rows.append([f"{run['normal_weight']:g}", *cells_of(evaluation), number(run["scene"].get("mesh_distance", {}).get("mean"), 4)])
    return Table(["λ", *(column.heading for column in COLUMNS), "Poisson mesh, %"], rows)


def value_of(column, evaluation):
    """None also for the distance at edges of a result without a point there."""
    if column.field == "mean_distance" and evaluation["features"] and evaluation["features"]["number_of_points"] == 0:
        return None
    return column.value([evaluation])


def cells_of(evaluation):
    return [number(value_of(column, evaluation), column.digits) for column in COLUMNS]


def comparison_table(experiment):
    """The best figure of each column is bold."""
    remarks = {row.name: row.remark for row in ROWS}
    measured = {name: run for name, run in experiment["measurements"].items() if run is not None}
    has_truth = all("evaluation" in run for run in measured.values())
    rows, columns = [], COLUMNS if has_truth else ()
    known = [[value for run in measured.values() if (value := value_of(column, run["evaluation"])) is not None] for column in columns]
    best = [column.best(values) if values else None for column, values in zip(columns, known)]
    has_meshes = any("mesh" in run["scene"] for run in measured.values())
    for name, run in experiment["measurements"].items():
        if run is None:
            rows.append([f"{name}: {remarks[name]}"] + ["-"] * (len(columns) + 3 + (has_meshes and has_truth)))
            continue
        cells = []
        for column, least in zip(columns, best):
            value = value_of(column, run["evaluation"])
            text = number(value, column.digits)
            cells.append(f"**{text}**" if value is not None and value == least else text)
        if has_meshes and has_truth:
            cells.append(number(run["scene"].get("mesh_distance", {}).get("mean"), 4))
        title = f"{name}, {run['variant']}" if run["variant"] else name
        rows.append([title, *cells, str(run["number_of_output_points"]), seconds(run["wall_seconds"]),
                     f"{run['resident_growth_bytes'] / 2**20:.0f}"])
    header = ["method", *(column.heading for column in columns)]
    if has_meshes and has_truth:
        header.append("Poisson mesh, %")
    return Table([*header, "points", "seconds", "MiB"], rows)
