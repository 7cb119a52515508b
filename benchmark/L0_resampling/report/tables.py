# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables of a report, made from its JSON."""

import sys
from dataclasses import dataclass
from pathlib import Path

sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("methods", "quality")]
from methods import ROWS
from quality_tables import COLUMNS

# Table 1 of the paper, seconds: |Q|, |P|, then LOR and ALOR: Init, BF, OLHS, L0, total
PAPER_TABLE_1 = {
    "fandisk": (110_000, 60_000, (2.1, 3.5, None, 350.6, 356.2), (2.1, 3.5, 2.1, 42.5, 50.2)),
    "armadillo": (100_000, 80_000, (3.8, 4.7, None, 956.1, 964.6), (3.8, 4.7, 4.5, 99.6, 112.6)),
    "Lord Quas": (160_000, 100_000, (4.2, 5.6, None, 2112.3, 2122.1), (4.2, 5.6, 8.5, 149.7, 168.0)),
    "anchor": (120_000, 83_000, (2.1, 3.2, None, 537.5, 542.8), (2.1, 3.2, 1.9, 55.3, 62.5)),
    "FIFA": (130_000, 90_000, (2.7, 4.8, None, 910.7, 918.2), (2.7, 4.8, 4.8, 88.1, 100.4)),
    "Box": (200_000, 200_000, (4.8, 6.0, None, 4213.4, 4224.4), (4.8, 6.0, 12.5, 513.7, 537.0)),
    "Clock": (300_000, 220_000, (5.9, 6.7, None, 5350.0, 5362.6), (5.9, 6.7, 14.4, 584.4, 611.4)),
}
TIMING_COLUMNS = ["Init", "BF", "OLHS", "L0", "total"]
METHOD_NAMES = {"lor": "LOR", "alor": "ALOR", "default": "default"}
SOLVERS = {"rows": "the paper's rows, CGLS", "cuda_rows": "the paper's rows, CGLS on the device", "block": "collapsed, Chebyshev"}


@dataclass(frozen=True)
class Table:
    header: list
    rows: list    # of texts; numbers stand to the right, so all columns but the first `left` do
    left: int = 1
    caption: str = ""

    def markdown(self):
        lines = [self.header, ["---"] * self.left + ["---:"] * (len(self.header) - self.left), *self.rows]
        caption = f"{self.caption}:\n\n" if self.caption else ""
        return caption + "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}f}"


def seconds(value):
    if value is None:
        return "-"
    return f"{value:.3g}" if value < 100 else f"{value:.0f}"


def name_of_input(experiment):
    words = [Path(experiment["mesh"]).stem]
    if "stands_for" in experiment:
        words.append(f"for {experiment['stands_for']}")
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
        for run in model["runs"]:
            speed = seconds(speed_up(model["runs"], run["solver"])) if run["method"] == "ALOR" else ""
            rows.append([name_of_input(model), run["method"], SOLVERS[run["solver"]], *timing_cells(run), speed])
    return Table(["input", "method", "solver", *TIMING_COLUMNS, "speed-up"], rows, 3, "Measured here, seconds")


def printed_table_1():
    rows = []
    for name, (points_in, points_out, *lines) in PAPER_TABLE_1.items():
        for method, times in zip(("LOR", "ALOR"), lines):
            speed = seconds(lines[0][-1] / lines[1][-1]) if method == "ALOR" else ""
            rows.append([f"{name}, {points_in} points to {points_out}", method, *map(seconds, times), speed])
    return Table(["input", "method", *TIMING_COLUMNS, "speed-up"], rows, 2, "Printed in the paper, seconds")


def timing_cells(run, unit=1):
    """In units of so many seconds."""
    olhs = run["olhs"] if run["olhs"] > 0 else None
    return [seconds(value and value / unit) for value in (run["init"], run["bf"], olhs, run["l0"], run["total"])]


def device_table(report):
    rows = [[f"{run['input_points']} points to {run['output_points']}", METHOD_NAMES[run["method"]], *timing_cells(run, 1e-3)]
            for run in report["device_runs"]["runs"]]
    return Table(["input", "method", *TIMING_COLUMNS], rows, 2, f"On one {report['device_runs']['device']}, points and result on the device, milliseconds")


def beside_device_table(report):
    rows = [[f"{run['input_points']} points to {run['output_points']}", METHOD_NAMES[run["method"]], SOLVERS[run["solver"]], str(run["threads"]),
             *timing_cells(run)] for run in report["device_runs"]["beside"]]
    return Table(["input", "method", "solver", "threads", *TIMING_COLUMNS], rows, 3,
                 f"Beside it, on {report['device_runs']['machine']}; rows are solved on the device with cuSPARSE and cuBLAS, seconds")


def methods_table():
    return Table(["method", "what it is", "of these, the best"],
                 [[row.name, row.remark, "; ".join(variant for variant in row.variants if variant)] for row in ROWS], 3)


def study_table(experiment):
    """Fig. 2, 4 and 5."""
    rows = []
    for study in experiment["studies"]:
        evaluation = study["evaluation"]
        rows.append([study["title"], number(evaluation["uniformity"]["density_variation"], 4),
                     number(evaluation["uniformity"]["spacing_variation"]), number(evaluation["distance"]["mean"], 4),
                     number(study["mesh_distance"], 4), seconds(study["wall_seconds"])])
    return Table(["variant of LOR", "density cv", "NN6 cv", "mean distance, %", "of the Poisson mesh, %", "seconds"], rows)


def normal_weight_table(experiment):
    rows = []
    for run in experiment["runs"]:
        evaluation = run["evaluation"]
        rows.append([f"{run['normal_weight']:g}", *cells_of(evaluation), number(run["mesh_distance"], 4)])
    return Table(["λ", *(column.heading for column in COLUMNS), "Poisson mesh, %"], rows)


def value_of(column, evaluation):
    """None also for distance and normals at edges of a result without a point there."""
    if column.field == "mean_distance" and evaluation["features"] and evaluation["features"]["number_of_points"] == 0:
        return None
    return column.value([evaluation])


def cells_of(evaluation):
    return [number(value_of(column, evaluation), column.digits) for column in COLUMNS]


def bold_best(values, column):
    """The cells of a column, the best of them bold."""
    best = column.best((value for value in values if value is not None), default=None)
    return [f"**{number(value, column.digits)}**" if value is not None and value == best else number(value, column.digits) for value in values]


def method_titles(experiment):
    remarks = {row.name: row.remark for row in ROWS}
    return [f"{name}: {remarks[name]}" if run is None else f"{name}, {run['variant']}" if run["variant"] else name
            for name, run in experiment["measurements"].items()]


def comparison_table(experiment):
    """The best figure of each column is bold."""
    runs = list(experiment["measurements"].values())
    filled = [bold_best([run and value_of(column, run["evaluation"]) for run in runs], column) for column in COLUMNS]
    others = {"Poisson mesh, %": lambda run: number(run["mesh_distance"], 4),
              "points": lambda run: str(run["number_of_output_points"]),
              "seconds": lambda run: seconds(run["wall_seconds"]),
              "MiB": lambda run: f"{run['resident_growth_bytes'] / 2**20:.0f}"}
    filled += [[value(run) if run else "-" for run in runs] for value in others.values()]
    return Table(["method", *(column.heading for column in COLUMNS), *others],
                 [list(cells) for cells in zip(method_titles(experiment), *filled)])
