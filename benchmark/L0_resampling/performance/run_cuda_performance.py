#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times the stages on a CUDA device with run_l0_cuda, for clouds of several sizes.

Nothing is judged by its time. Clouds from a million points on have the noise of half a spacing, and LOR the radius of four spacings, so that each
ball holds as many points in all of them; the smaller ones are the paper's, with 0.5 % noise and the radius rule of the method.
"""

import argparse
import json
import math
import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import load_raw, processor, write_result

LINEAR = ("--noise-in-spacings", "0.5")
LINEAR_LOR = LINEAR + ("--radius-in-spacings", "4")
RUNS = (
    (110_000, 60_000, "lor", ("--bandwidth",)),
    (110_000, 60_000, "alor", ()),
    (110_000, 60_000, "default", ()),
    (300_000, 220_000, "lor", ()),
    (300_000, 220_000, "default", ()),
    (1_000_000, 600_000, "lor", LINEAR_LOR),
    (1_000_000, 600_000, "default", LINEAR),
    (10_000_000, 6_000_000, "lor", LINEAR_LOR + ("--repetitions", "20")),
    (10_000_000, 6_000_000, "default", LINEAR + ("--repetitions", "20")),
    (100_000_000, 60_000_000, "lor", LINEAR_LOR + ("--repetitions", "5")),
)


def measure(program, mesh):
    """The results of all runs, as `run_l0_cuda` prints them."""
    results = []
    for points_in, points_out, method, options in RUNS:
        command = [program, mesh, "--points-in", points_in, "--points", points_out, "--method", method, *options]
        output = subprocess.run([str(word) for word in command], check=True, capture_output=True, text=True).stdout
        results.append(json.loads(output))
        print(points_in, method, file=sys.stderr)
    return results


def measure_beside(programs, mesh):
    """The same fandisk with the stages on the processor of the same machine, and with the paper's rows on the device."""
    cores = str(os.cpu_count())
    runs = ([("lor", "block", threads) for threads in ("1", cores)] + [("default", "block", threads) for threads in ("1", cores)]
            + [(method, solver, cores) for method in ("lor", "alor") for solver in ("rows", "cuda_rows")])
    results = []
    with tempfile.TemporaryDirectory() as scratch:
        cloud = Path(scratch) / "cloud.ply"
        subprocess.run([programs / "sample_mesh", mesh, cloud, "--points", "110000", "--noise", "0.5", "--seed", "1"], check=True,
                       stdout=subprocess.DEVNULL)
        for method, solver, threads in runs:
            command = [programs / "run_l0", cloud, Path(scratch) / "result.ply", "--points", "60000", "--method", method,
                       "--solver", solver, "--threads", threads]
            lines = [json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
                     for _ in range(5 if solver == "block" else 1)]
            results.append(sorted(lines, key=lambda line: line["wall_seconds"])[len(lines) // 2])
            print("beside:", method, solver, threads, file=sys.stderr)
    return results


def milliseconds(seconds):
    return f"{float(f'{1e3 * seconds:.3g}'):g}"   # three digits, and no exponent


def exponent(results, method):
    """By which power of the number of points the time grows, over the clouds whose balls hold equally many."""
    linear = [r for r in results if r["method"] == method and r["points_in"] >= 1_000_000]
    if len(linear) < 2:
        return None
    first, last = linear[0], linear[-1]
    ratio = last["device_resident_seconds"]["median"] / first["device_resident_seconds"]["median"]
    return math.log(ratio) / math.log(last["points_in"] / first["points_in"])


def markdown(results, beside, beside_machine, command):
    lines = ["# Speed on a CUDA device", "", f"Made by `{command}` on one {results[0]['device']}. Input: {Path(results[0]['mesh']).name}, "
             "sampled uniformly with Gaussian noise. Medians in milliseconds, warm. *On the device*: points and result stay there; host clock around "
             "the call. *Host to host*: upload, extent of the cloud, resampling and download, from and to plain memory. Up to 300000 points: noise of 0.5 % "
             "of the bounding box's diagonal and the method's own radius; above: noise of half a spacing, and four spacings as LOR's radius.", ""]
    bandwidth = next((r["copy_bytes_a_second"] for r in results if "copy_bytes_a_second" in r), None)
    if bandwidth:
        lines += [f"A copy on the device moves {bandwidth / 1e12:.2f} TB/s, read and written.", ""]
    lines += ["| points in | points out | method | on the device (range) | host to host | neighbors a sample | solver iterations | device memory, bytes a point |",
              "| ---: | ---: | --- | ---: | ---: | ---: | ---: | ---: |"]
    for r in results:
        time = r["device_resident_seconds"]
        lines.append(f"| {r['points_in']} | {r['points_out']} | {r['method']} | {milliseconds(time['median'])} "
                     f"({milliseconds(time['least'])} to {milliseconds(time['greatest'])}) | {milliseconds(r['host_to_host_seconds']['median'])} | "
                     f"{r['number_of_self_neighbor_pairs'] / r['points_out']:.1f} | {r['solver_iterations']} | {r['peak_bytes_a_point']:.0f} |")
    lines.append("")
    for method in ("lor", "default"):
        power = exponent(results, method)
        if power is not None:
            lines.append(f"- {method}: time grows as n^{power:.2f} from a million points on.")
    if beside:
        lines += ["", f"Beside them, 110000 points to 60000 on the processor of the same machine ({beside_machine}), median of 5 calls, with explicit rows one, milliseconds. `block`: the "
                  "function's own solver; `rows`: the paper's explicit rows with least-squares conjugate gradients, stages and solver on the processor; "
                  "`cuda_rows`: the same rows solved on the device with cuSPARSE and cuBLAS, warm.", "",
                  "| method | solver | threads | whole function | L0 minimization | solver iterations |", "| --- | --- | ---: | ---: | ---: | ---: |"]
        for r in beside:
            l0 = next(s["seconds"] for s in r["report"]["stages"] if s["name"] == "L0 minimization")
            lines.append(f"| {r['parameters']['method']} | {r['parameters']['solver']} | {r['threads']} | {milliseconds(r['wall_seconds'])} | "
                         f"{milliseconds(l0)} | {r['report']['solver_iterations']} |")
    names = list(dict.fromkeys(stage["name"] for r in results for stage in r["stages"]))
    lines += ["", "By the device's clock, milliseconds:", "",
              "| stage | " + " | ".join(f"{r['points_in']} {r['method']}" for r in results) + " |", "| --- |" + " ---: |" * len(results)]
    for name in names:
        cells = [next((milliseconds(s["seconds"]) for s in r["stages"] if s["name"] == name), "") for r in results]
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def figures(recorded):
    """What README, the manual and the report of the paper's figures quote."""
    def stages(run):
        return [{"name": stage["name"], "seconds": stage["seconds"]} for stage in run["stages"]]

    results = [{**{name: run[name] for name in ("device", "points_in", "points_out", "method")},
                "seconds": run["device_resident_seconds"]["median"], "stages": stages(run)}
               for run in recorded["results"]]
    beside = [{"points_in": run["number_of_input_points"], "points_out": run["number_of_output_points"],
               "method": run["parameters"]["method"], "solver": run["parameters"]["solver"],
               "threads": run["threads"], "seconds": run["wall_seconds"], "stages": stages(run["report"])}
              for run in recorded["beside"]]
    return {"command": recorded["command"], "results": results, "beside": beside,
            "beside_machine": recorded["beside_machine"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="run_l0_cuda; sample_mesh and run_l0 are taken from the same folder")
    parser.add_argument("mesh", help="OFF file")
    parser.add_argument("--output", type=Path, default=Path("cuda"), metavar="FOLDER/NAME",
                        help="what to write, see common/results.py")
    parser.add_argument("--tables-only", action="store_true", help="write the tables of an earlier run")
    arguments = parser.parse_args()
    if arguments.tables_only:
        recorded = load_raw(arguments.output)
    else:
        words = [Path(arguments.program).name, Path(arguments.mesh).name, "--output", arguments.output.name]
        recorded = {"command": "run_cuda_performance.py " + shlex.join(words), "results": measure(arguments.program, arguments.mesh),
                    "beside": measure_beside(Path(arguments.program).resolve().parent, arguments.mesh), "beside_machine": f"{os.cpu_count()} cores of {processor()}"}
    text = markdown(recorded["results"], recorded["beside"], recorded["beside_machine"], recorded["command"])
    write_result(arguments.output, recorded, text, figures(recorded))


if __name__ == "__main__":
    main()
