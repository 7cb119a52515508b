# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The experiments of a report, each named after what it reproduces. Each returns what stands in the report's JSON."""

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy

from laboratory import Method

COLUMN_OF_STAGE = {"filter normals": "bf", "L0 minimization": "l0"}   # all others are Init; see `columns`

TIMED_RUNS = (("LOR", "lor", "rows"), ("ALOR", "alor", "rows"), ("LOR", "lor", "block"), ("ALOR", "alor", "block"),
              ("default", "default", "block"))


def columns(report, method):
    """The columns of the paper's Table 1. Listing the fit rows is OLHS where Algorithm 2 is part of it, else Init."""
    result = {"init": 0, "bf": 0, "olhs": 0, "l0": 0}
    for stage in report["stages"]:
        column = COLUMN_OF_STAGE.get(stage["name"], "init")
        if stage["name"] == "fit rows" and method == "alor":
            column = "olhs"
        result[column] += stage["seconds"]
    return result


def fastest(lab, source, points, method, solver):
    """Of three runs, so that what else the machine does counts less."""
    lines = [json.loads(lab.run("run_l0", source, lab.scratch / "timed.ply", "--points", points, "--method", method, "--solver", solver))
             for _ in range(3)]
    return min(lines, key=lambda line: line["wall_seconds"])


def table_1(lab, selection):
    """One run at a time, on one thread: these are timings."""
    inputs = []
    for number, cloud in enumerate(selection.timed):
        experiment, _, source = lab.input(cloud.scaled(selection.factor), f"table_1_{number}")
        inputs.append(({**experiment, "shape": cloud.shape}, source))
    for scan in selection.scans:
        experiment, source = lab.scan(scan, selection.scan_points, f"table_1_{scan.figure}")
        inputs.append(({**experiment, "shape": scan.stands_for}, source))
    models = []
    for experiment, source in inputs:
        runs = []
        for name, method, solver in TIMED_RUNS:
            line = lab.once(f"{source.stem}_{method}_{solver}", {"run_l0"}, experiment,
                            lambda: fastest(lab, source, experiment["output_points"], method, solver))
            runs.append({"method": name, "solver": solver, **columns(line["report"], method), "total": line["wall_seconds"],
                         "solver_iterations": line["report"]["solver_iterations"]})
            print(f"Table 1: {experiment['mesh']}, {name}, {solver}: {line['wall_seconds']:.3g} s", file=sys.stderr, flush=True)
        models.append({**experiment, "runs": runs})
    return models


def equations(lab, selection):
    """Fig. 2: the local density after Eq. (3), (4) and (6)."""
    experiment, mesh, source = lab.input(selection.equations.scaled(selection.factor), "fig_2")
    studies = lab.all_of(*(lambda e=e: lab.study(experiment, mesh, source, f"Eq. ({e})", f"fig_2_eq_{e}", "--equation", e)
                           for e in (3, 4, 6)))
    densities = [numpy.fromfile(lab.scratch / study["values"], dtype="<f4").reshape(-1, 2)[:, 1] for study in studies]
    edges = numpy.linspace(1, max(numpy.quantile(d, 0.999) for d in densities), 41)
    for study, values in zip(studies, densities):
        study["histogram"] = (numpy.histogram(values, edges)[0] / len(values)).round(5).tolist()
    return {**experiment, "bins": edges.round(5).tolist(), "studies": studies}


def half_sampling(lab, selection):
    """Fig. 4: what is lost with fewer original neighbors."""
    experiment, mesh, source = lab.input(selection.half_sampling.scaled(selection.factor), "fig_4")
    kinds = {"all": "all neighbors", "smaller-radius": "smaller radius", "random-half": "random half",
             "merged-pairs": "Algorithm 2"}
    studies = lab.all_of(*(lambda k=k, t=t: lab.study(experiment, mesh, source, t, f"fig_4_{k}", "--neighbors", k, reconstruct=True)
                           for k, t in kinds.items()))
    return {**experiment, "studies": studies}


def interleaving(lab, selection):
    """Fig. 5: the local density of three samples over the iterations."""
    experiment, mesh, source = lab.input(selection.interleaving.scaled(selection.factor), "fig_5")
    studies = lab.all_of(lambda: lab.study(experiment, mesh, source, "every iteration", "fig_5_full"),
                         lambda: lab.study(experiment, mesh, source, "interleaved", "fig_5_interleaved", "--interleave"))
    return {**experiment, "studies": studies}


def normal_weights(lab, selection):
    """Fig. 6: lambda swept, with ALOR."""

    experiment, mesh, source = lab.input(selection.normal_weight.scaled(selection.factor), "fig_6")

    def one(weight):
        name = f"fig_6_{weight:g}"
        measured = lab.measure_variant(experiment, mesh, source,
                                       Method("run_l0", ("--method", "alor", "--normal-weight", weight)), name)
        return {"normal_weight": weight, **measured, "scene": lab.scene(f"λ = {weight:g}", name, mesh, True, measured["evaluation"])}

    return {**experiment, "runs": lab.all_of(*(lambda w=w: lab.once(f"fig_6_{w:g}", {"run_l0"}, experiment, lambda: one(w))
                                             for w in selection.normal_weights))}


def start_comparison(lab, figure, cloud, left_out=()):
    """The known part of an experiment, and what waits for its measurements."""
    experiment, mesh, source = lab.input(cloud, f"fig_{figure}")
    return ({**experiment, "figure": figure, "shape": cloud.shape, "input_scene": {"title": "input", "points": source.name}},
            lab.start_rows(experiment, mesh, source, f"fig_{figure}", True, left_out))


def finished(started):
    return [{**experiment, "measurements": wait()} for experiment, wait in started]


def comparisons(lab, selection):
    """Fig. 1, 7, 8 and 9: the methods beside each other."""
    return finished([start_comparison(lab, c.figure, c.cloud.scaled(selection.factor)) for c in selection.comparisons])


def thin_plate(lab, selection):
    """Fig. 12: the paper's failure."""
    left_out = selection.thin_plate_left_out
    return {**finished([start_comparison(lab, "12", selection.thin_plate.scaled(selection.thin_plate_factor), left_out)])[0], "left_out": left_out}


def scans(lab, selection):
    """Fig. 10 and 11 on real scans: pictures only, since nobody knows the truth."""
    started = []
    for scan in selection.scans:
        experiment, source = lab.scan(scan, selection.scan_points, f"fig_{scan.figure}")
        started.append(({**experiment, "figure": scan.figure, "input_scene": {"title": "input", "points": source.name, "is_raw": True}},
                        lab.start_rows(experiment, None, source, f"fig_{scan.figure}", True)))
    return finished(started)


def noise(lab, selection):
    """The measures of all methods against the noise."""
    started = []
    for number, cloud in enumerate(selection.noise_clouds):
        for percent in selection.noise:
            noisy = replace(cloud.scaled(selection.factor * selection.noise_factor), noise_percent=percent)
            experiment, mesh, source = lab.input(noisy, f"noise_{number}_{percent:g}")
            started.append((experiment, lab.start_rows(experiment, mesh, source, f"noise_{number}_{percent:g}", False)))
    return finished(started)


def device_runs(_lab, _selection):
    """What was measured on a CUDA device, as committed with the command that made it."""
    path = Path(__file__).resolve().parents[1] / "performance" / "results" / "cuda_h200.json"
    recorded = json.loads(path.read_text(encoding="utf-8"))

    def timing(run):
        return {"input_points": run["points_in"], "output_points": run["points_out"], "method": run["method"],
                **columns(run, run["method"]), "total": run["seconds"]}

    runs = [timing(run) for run in recorded["results"]]
    beside = [{**timing(run), "solver": run["solver"], "threads": run["threads"]} for run in recorded["beside"]]
    return {"command": recorded["command"], "device": recorded["results"][0]["device"], "runs": runs,
            "machine": recorded["beside_machine"], "beside": beside}
