#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures, with callback_latency, the longest time between two calls of the callback, the time
from its `false` to the end of the call, and the peak of the function's own arrays. With --add, what
an earlier run has measured of other inputs, methods and counts is kept, because ten million points
take long.

Promised are 100 ms and 200 ms, on a machine that does nothing else. Ends with 1 if a time is more
than ten times as long, which a busy machine does not explain. On a busy machine the processor time
of the same intervals tells more; with several threads it is the sum over all of them."""

import argparse
import itertools
import json
import shlex
import subprocess
import sys
from pathlib import Path

from run_performance import machine

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import load_raw, write_result

BYTES_PER_PAIR = 12
INPUTS = ("sphere", "volume", "crowd")
LONGEST_SILENCE, LONGEST_CANCELLATION = 0.1, 0.2  # seconds, as promised
TOLERATED_FACTOR = 10
# LOR and ALOR with the radius of four spacings, so that each ball holds as many points at any number of them
METHODS = {"lor": ("--radius-in-spacings", "4"), "alor": ("--radius-in-spacings", "4"), "default": ()}


COLUMNS = {  # with the alignment of each
    "input": "---", "points in": "---:", "method": "---", "threads": "---:", "seconds": "---:",
    "calls": "---:", "longest gap": "---:", "where": "---", "second and third longest": "---",
    "longest by processor time": "---:", "where ": "---",
    "longest from `false` to the end": "---:", "where  ": "---",
    "from the last call to the end, output included": "---:", "progress never falls": "---"}


def milliseconds(duration):
    return " / ".join(f"{1000 * duration[clock + '_seconds']:.0f}" for clock in ("wall", "cpu"))


def stages_of(gap):
    return gap["from"] if gap["from"] == gap["to"] else f"{gap['from']} to {gap['to']}"


def table_row(cells):
    return "| " + " | ".join(cell.strip() for cell in cells) + " |"


def row_of(run):
    gaps, busiest = run["longest_gaps"], run["busiest_gaps"][0]
    ends = sorted(run["cancellations"], key=lambda c: -c["wall_seconds"])
    return table_row([
        run["input"], str(run["points_in"]), run["method"], str(run["threads"]),
        f"{run['wall_seconds']:.1f}", str(run["calls"]), milliseconds(gaps[0]), stages_of(gaps[0]),
        ", ".join(f"{milliseconds(gap)} ({stages_of(gap)})" for gap in gaps[1:3]),
        milliseconds(busiest), stages_of(busiest), milliseconds(ends[0]) if ends else "-",
        ends[0]["stage"] if ends else "-", milliseconds(run["last_gap"]),
        "yes" if run["is_monotonic"] else "NO"])


def markdown(result):
    info = result["machine"]
    commands = ", ".join(f"`{command}`" for command in result["commands"])
    return "\n".join([
        "# Callback, cancellation and memory", "",
        f"Made by {commands} on {info['cores']} cores of {info['processor']} (load average before: "
        f"{info['load_average_before']:.1f}). Inputs: a noisy sphere; points all over a cube "
        "(volume); a noisy sphere with half of its points in one place (crowd). Six tenths of the "
        "points out. Milliseconds of wall-clock time, and behind the stroke of processor time; of "
        "two threads that is the sum.", "",
        table_row(COLUMNS), table_row(COLUMNS.values()), *map(row_of, result["runs"]), "",
        "Peaks of the function's own arrays for the sphere, on one thread, in bytes an input "
        "point, and the share of them that an index and two numbers for each pair of self "
        "neighbors take.", "", *memory_table(result["runs"])]) + "\n"


def broken_bounds(run):
    """What took far longer than promised, as text."""
    silence = max(gap["wall_seconds"] for gap in [*run["longest_gaps"], run["last_gap"]])
    ends = [cancellation["wall_seconds"] for cancellation in run["cancellations"]]
    name = f"{run['input']}, {run['points_in']} points, {run['method']}, {run['threads']} threads"
    if silence > TOLERATED_FACTOR * LONGEST_SILENCE:
        yield f"{name}: no call of the callback for {silence:.2f} s"
    if max(ends, default=0) > TOLERATED_FACTOR * LONGEST_CANCELLATION:
        yield f"{name}: ended {max(ends):.2f} s after the callback returned false"


def memory_table(runs):
    of_one_thread = {(run["points_in"], run["method"]): run for run in runs
                     if run["threads"] == 1 and run["input"] == "sphere"}
    methods = [method for method in METHODS if any(m == method for _, m in of_one_thread)]

    def cell(run):
        if run is None:
            return "-"
        return f"{run['peak_bytes'] / run['points_in']:.0f} ({100 * BYTES_PER_PAIR * run['self_neighbor_pairs'] / run['peak_bytes']:.0f} %)"

    rows = [f"| {count} | " + " | ".join(cell(of_one_thread.get((count, method))) for method in methods) + " |"
            for count in sorted({count for count, _ in of_one_thread})]
    return ["| points in | " + " | ".join({"lor": "LOR", "alor": "ALOR"}.get(method, method) for method in methods) + " |", "| ---: |" + " ---: |" * len(methods), *rows]


def key(run):
    """Of two runs with the same key only the last one is kept; runs are in the order of keys."""
    return (INPUTS.index(run["input"]), run["points_in"], list(METHODS).index(run["method"]),
            run["threads"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the program")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the table is printed")
    parser.add_argument("--add", action="store_true", help="to what an earlier run has measured")
    parser.add_argument("--inputs", nargs="+", default=["sphere"], choices=INPUTS)
    parser.add_argument("--points", type=int, nargs="+", default=[10_000_000])
    parser.add_argument("--methods", nargs="+", default=list(METHODS), choices=list(METHODS))
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--cancellations", type=int, default=5, help="of each run")
    parser.add_argument("--small", action="store_true", help="every input, with 20000 points")
    arguments = parser.parse_args()
    if arguments.small:
        arguments.inputs, arguments.points, arguments.cancellations = INPUTS, [20_000], 3
    result = {"commands": [], "machine": machine(arguments.build), "runs": []}
    if arguments.add:
        result = load_raw(arguments.output)
    result["commands"].append(shlex.join(["run_callback_latency.py", "build", *sys.argv[2:]]))
    broken = []
    for input_name, points, method, threads in itertools.product(
            arguments.inputs, arguments.points, arguments.methods, arguments.threads):
        command = [arguments.build / "bin" / "callback_latency", "--input", input_name, "--points",
                   points, "--method", method, "--threads", threads, "--cancellations",
                   arguments.cancellations]
        if input_name != "volume":  # no surface has the spacing that the radius would be of
            command += METHODS[method]
        output = subprocess.run([str(word) for word in command], check=True,
                                stdout=subprocess.PIPE, text=True).stdout
        run = json.loads(output)
        others = [other for other in result["runs"] if key(other) != key(run)]
        result["runs"] = sorted([*others, run], key=key)
        broken += broken_bounds(run)
        print(input_name, method, points, threads, file=sys.stderr, flush=True)
        if arguments.output:
            write_result(arguments.output, result, markdown(result))
    if not arguments.output:
        print(markdown(result), end="")
    if broken:
        sys.exit("\n".join(broken))


if __name__ == "__main__":
    main()
