# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The experiments of a report, each named after what it reproduces. Each returns what stands in the
report's JSON."""

import json
import sys
from dataclasses import replace
from pathlib import Path

from laboratory import Method

# All other stages are Init; see `columns`.
COLUMN_OF_STAGE = {"filter normals": "bf", "L0 minimization": "l0"}

TIMED_RUNS = (("LOR", "lor", "rows"), ("ALOR", "alor", "rows"), ("LOR", "lor", "block"),
              ("ALOR", "alor", "block"), ("default", "default", "block"))


def columns(report, method):
    """The columns of the paper's Table 1. Listing the fit rows is OLHS where Algorithm 2 is part of
    it, else Init."""
    result = {"init": 0, "bf": 0, "olhs": 0, "l0": 0}
    for stage in report["stages"]:
        column = COLUMN_OF_STAGE.get(stage["name"], "init")
        if stage["name"] == "fit rows" and method == "alor":
            column = "olhs"
        result[column] += stage["seconds"]
    return result


def fastest(lab, source, points, method, solver):
    """Of three runs, so that what else the machine does counts less."""
    lines = [json.loads(lab.run("run_l0", source, lab.scratch / "timed.ply", "--points", points,
                                "--method", method, "--solver", solver)) for _ in range(3)]
    return min(lines, key=lambda line: line["wall_seconds"])


def table_1(lab, selection):
    """One run at a time, on one thread: these are timings."""
    inputs = []
    for number, cloud in enumerate(selection.timed):
        experiment, _, source = lab.input(cloud.scaled(selection.factor), f"table_1_{number}")
        inputs.append(({**experiment, "shape": cloud.shape}, source))
    for number, scan in enumerate(selection.timed_scans):
        experiment, source = lab.scan(scan, selection.scan_points, f"table_1_scan_{number}")
        inputs.append(({**experiment, "shape": scan.stands_for}, source))
    models = []
    for experiment, source in inputs:
        runs = []
        for name, method, solver in TIMED_RUNS:
            line = fastest(lab, source, experiment["output_points"], method, solver)
            runs.append({"method": name, "solver": solver, **columns(line["report"], method),
                         "total": line["wall_seconds"]})
            print(f"Table 1: {experiment['mesh']}, {name}, {solver}: {line['wall_seconds']:.3g} s",
                  file=sys.stderr, flush=True)
        models.append({**experiment, "runs": runs})
    return models


def equations(lab, selection):
    """Fig. 2: the local density after Eq. (3), (4) and (6)."""
    experiment, mesh, source = lab.input(selection.equations.scaled(selection.factor), "fig_2")
    studies = lab.all_of(*(lambda e=e: lab.study(experiment, mesh, source, f"Eq. ({e})",
                                                 f"fig_2_eq_{e}", "--equation", e)
                           for e in (3, 4, 6)))
    return {**experiment, "studies": studies}


def half_sampling(lab, selection):
    """Fig. 4: what is lost with fewer original neighbors."""
    experiment, mesh, source = lab.input(selection.half_sampling.scaled(selection.factor), "fig_4")
    kinds = {"all": "all neighbors", "smaller-radius": "smaller radius",
             "random-half": "random half", "merged-pairs": "Algorithm 2"}
    studies = lab.all_of(*(lambda k=k, t=t: lab.study(experiment, mesh, source, t, f"fig_4_{k}",
                                                      "--neighbors", k, reconstruct=True)
                           for k, t in kinds.items()))
    return {**experiment, "studies": studies}


def interleaving(lab, selection):
    """Fig. 5: the local density of three samples over the iterations."""
    experiment, mesh, source = lab.input(selection.interleaving.scaled(selection.factor), "fig_5")
    studies = lab.all_of(
        lambda: lab.study(experiment, mesh, source, "every iteration", "fig_5_full"),
        lambda: lab.study(experiment, mesh, source, "interleaved", "fig_5_interleaved",
                          "--interleave"))
    return {**experiment, "studies": studies}


def normal_weights(lab, selection):
    """Fig. 6: lambda swept, with ALOR."""

    experiment, mesh, source = lab.input(selection.normal_weight.scaled(selection.factor), "fig_6")

    def one(weight):
        name, method = f"fig_6_{weight:g}", Method("run_l0", ("--method", "alor",
                                                              "--normal-weight", weight))
        measured = lab.measure_variant(experiment, mesh, source, method, name)
        return {"normal_weight": weight, **measured,
                "mesh_distance": lab.distance_of_mesh(name, mesh, measured["evaluation"])}

    return {**experiment,
            "runs": lab.all_of(*(lambda w=w: one(w) for w in selection.normal_weights))}


def compared(lab, cloud, name):
    """The methods beside each other."""
    experiment, mesh, source = lab.input(cloud, name)
    return {**experiment, "measurements": lab.measure_rows(experiment, mesh, source, name)}


def comparison(lab, selection):
    """Fig. 1."""
    return compared(lab, selection.comparison.scaled(selection.factor), "fig_1")


def thin_plate(lab, selection):
    """Fig. 12: the paper's failure."""
    return compared(lab, selection.thin_plate.scaled(selection.factor), "fig_12")


def noise(lab, selection):
    """The measures of all methods against the noise."""
    cloud = selection.noise_cloud.scaled(selection.factor * selection.noise_factor)
    return [compared(lab, replace(cloud, noise_percent=percent), f"noise_{percent:g}")
            for percent in selection.noise]


def device_runs(_lab, _selection):
    """What was measured on a CUDA device, as committed with the command that made it."""
    folder = Path(__file__).resolve().parents[1] / "performance" / "results"
    recorded = json.loads((folder / "cuda_h200.json").read_text(encoding="utf-8"))

    def timing(run):
        return {"input_points": run["points_in"], "output_points": run["points_out"],
                "method": run["method"], **columns(run, run["method"]), "total": run["seconds"]}

    return {"command": recorded["command"], "device": recorded["results"][0]["device"],
            "runs": [timing(run) for run in recorded["results"]],
            "machine": recorded["beside_machine"],
            "beside": [{**timing(run), "solver": run["solver"], "threads": run["threads"]}
                       for run in recorded["beside"]]}
