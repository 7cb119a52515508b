#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts bytes and operations of each stage on a CUDA device, and sets them against what the device can do.

Nsight Compute's hardware counters count what one call after the warm-up does, kernel by kernel, each with empty caches; cuda_limits measures the
limits; the times are those of a run without counters, which disturb them.
"""

import argparse
import csv
import io
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import write_result

RUNS = ((110_000, 60_000, "lor", ()), (110_000, 60_000, "default", ()), (300_000, 220_000, "lor", ()),
        (1_000_000, 600_000, "lor", ("--noise-in-spacings", "0.5", "--radius-in-spacings", "4")))
PREFIX = "smsp__sass_thread_inst_executed_op_"
OPERATIONS = {PREFIX + kind + "_pred_on.sum": (precision, count) for precision, kinds in
              (("float", ("fadd", "fmul", "ffma")), ("double", ("dadd", "dmul", "dfma"))) for kind, count in zip(kinds, (1, 1, 2))}
MEMORY, CACHE, ISSUED = "dram__bytes.sum", "lts__t_bytes.sum", "smsp__inst_issued.sum"
UNITS = {"byte": 1, "Kbyte": 1e3, "Mbyte": 1e6, "Gbyte": 1e9, "Tbyte": 1e12, "inst": 1, "": 1}


def counts_of_stages(text, stages):
    """Sums of the counters over the kernels of each stage."""
    lines = text.splitlines()
    start = next((i for i, line in enumerate(lines) if line.startswith('"ID"')), None)
    if start is None:
        sys.exit("ncu counted no kernel:\n" + text)
    rows = csv.reader(io.StringIO("\n".join(lines[start:])))
    names, units = next(rows), next(rows)
    counts_of = {}
    for row in rows:
        ranges = " ".join(value for name, value in zip(names, row) if "Range" in name)
        stage = next((s for s in sorted(stages, key=len, reverse=True) if s in ranges), None)
        if stage is None:
            continue
        counts = counts_of.setdefault(stage, {"kernels": 0})
        counts["kernels"] += 1
        for name, unit, value in zip(names, units, row):
            if name in OPERATIONS or name in (MEMORY, CACHE, ISSUED):
                counts[name] = counts.get(name, 0) + float(value.replace(",", "")) * UNITS[unit]
    if not counts_of:
        sys.exit("no kernel is in a range of a stage, of these columns: " + ", ".join(names))
    return counts_of


def measure(programs, mesh):
    """Yields the times and counts of one run after the other."""
    for points_in, points_out, method, options in RUNS:
        command = [str(word) for word in (programs / "run_l0_cuda", mesh, "--points-in", points_in, "--points", points_out,
                                          "--method", method, *options)]
        timed = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        stages = [stage["name"] for stage in timed["stages"]]
        with tempfile.TemporaryDirectory() as scratch:
            log = Path(scratch) / "counters.csv"
            subprocess.run(["ncu", "--profile-from-start", "off", "--clock-control", "none", "--nvtx", "--csv", "--page", "raw", "--log-file",
                            str(log), "--metrics", ",".join((*OPERATIONS, MEMORY, CACHE, ISSUED)), *command, "--repetitions", "1",
                            "--profile"],
                           check=True, stdout=subprocess.DEVNULL)
            counts = counts_of_stages(log.read_text(encoding="utf-8"), stages)
        for stage in timed["stages"]:
            c = counts.get(stage["name"], {"kernels": 0})
            stage.update(kernels=c["kernels"], memory_bytes=c.get(MEMORY, 0), cache_bytes=c.get(CACHE, 0), instructions=c.get(ISSUED, 0))
            for precision in ("float", "double"):
                stage[precision + "_operations"] = sum(weight * c.get(name, 0) for name, (p, weight) in OPERATIONS.items() if p == precision)
        yield {"points_in": points_in, "points_out": points_out, "method": method, "stages": timed["stages"],
               "turns": timed["turns"], "solver_iterations": timed["solver_iterations"],
               "device_resident_seconds": timed["device_resident_seconds"]["median"]}


def bound_of(stage, limits):
    """Shares of the stage's time that its bytes and operations would take at the limits."""
    seconds = stage["seconds"]
    return {"memory": stage["memory_bytes"] / limits["memory_bytes_a_second"] / seconds,
            "cache": stage["cache_bytes"] / limits["cache_bytes_a_second"] / seconds,
            "operations": (stage["float_operations"] / limits["float_operations_a_second"]
                           + stage["double_operations"] / limits["double_operations_a_second"]) / seconds,
            "issue": stage["instructions"] / limits["instructions_a_second"] / seconds}


def waits_of(run, limits):
    """Seconds that launches and the solver's barriers take at least, however little there is to do."""
    kernels = sum(stage["kernels"] for stage in run["stages"])
    sums = 2 * run["turns"] + run["solver_iterations"]   # weights and right-hand side of a turn; one of each step and the residual
    return {"kernels": kernels, "launches": kernels * limits["launch_seconds"], "sums": sums, "barriers": sums * limits["sum_seconds"]}


def table(data):
    limits = data["limits"]
    lines = ["# Stages on a CUDA device against its limits", "",
             f"Made by `run_cuda_roofline.py build/bin fandisk.off --output cuda_roofline` on one {limits['device']}. Measured limits: "
             f"{limits['memory_bytes_a_second'] / 1e12:.3g} TB/s of memory, read and written; {limits['cache_bytes_a_second'] / 1e12:.3g} TB/s read from the "
             f"second cache; {limits['float_operations_a_second'] / 1e12:.3g} and {limits['double_operations_a_second'] / 1e12:.3g} TFLOP/s of `float` and "
             "`double`; one instruction a cycle and scheduler, as many as the multiplications and additions of `float` at their limit. Of the "
             "time of a stage, the *shares* are what its bytes, operations and instructions would take at these limits: the largest one is what holds "
             "the stage up, and where all are small it waits: for barriers, for dependent reads, for launches and for the host. "
             f"The host takes {1e6 * limits['launch_seconds']:.2g} microseconds to launch a kernel, and {1e6 * limits['read_seconds']:.2g} pass until it has "
             "read a number and launched the next one, which it does wherever the size of an array depends on the points; a sum over all "
             f"threads takes {1e6 * limits['sum_seconds']:.2g}.", ""]
    for run in data["runs"]:
        lines += [f"## {run['points_in']} points to {run['points_out']}, {run['method']}: {1e3 * run['device_resident_seconds']:.3g} ms", "",
                  "| stage | ms | kernels | MB of memory | MB of cache | MFLOP | share of memory | of cache | of operations | of instructions |",
                  "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |"]
        for stage in run["stages"]:
            b = bound_of(stage, limits)
            lines.append(f"| {stage['name']} | {1e3 * stage['seconds']:.3g} | {stage['kernels']} | {stage['memory_bytes'] / 1e6:.3g} "
                         f"| {stage['cache_bytes'] / 1e6:.3g} | {(stage['float_operations'] + stage['double_operations']) / 1e6:.3g} "
                         + "".join(f"| {100 * b[kind]:.0f} % " for kind in ("memory", "cache", "operations", "issue")) + "|")
        least = sum(max(bound_of(stage, limits).values()) * stage["seconds"] for stage in run["stages"])
        waits = waits_of(run, limits)
        lines += ["", f"With the bytes and instructions that they have, the stages would take {1e3 * least:.3g} ms at these limits; the rest is waiting. "
                  f"To launch the {waits['kernels']} kernels one after the other takes {1e3 * waits['launches']:.3g} ms, were they empty, and the "
                  f"{waits['sums']} barriers of the solver, with their sums, {1e3 * waits['barriers']:.3g} ms.", ""]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", type=Path, help="folder with run_l0_cuda and cuda_limits")
    parser.add_argument("mesh", type=Path)
    parser.add_argument("--output", type=Path, default=Path("cuda_roofline"), metavar="FOLDER/NAME",
                        help="what to write, see common/results.py")
    arguments = parser.parse_args()
    limits = json.loads(subprocess.run([arguments.programs / "cuda_limits"], check=True, capture_output=True, text=True).stdout)
    # a multiplication with addition of 32 threads is one instruction, and counts as 64 operations
    limits["instructions_a_second"] = limits["float_operations_a_second"] / 64
    data = {"limits": limits, "runs": []}
    start = time.monotonic()
    for run in measure(arguments.programs, arguments.mesh):
        data["runs"].append(run)
        print(f"{run['points_in']} {run['method']}: done after {time.monotonic() - start:.0f} s", file=sys.stderr)
        write_result(arguments.output, data, table(data))


if __name__ == "__main__":
    main()
