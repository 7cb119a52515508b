#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the longest time between two calls of the callback, that from its `false` to the end of the call, and the peak of the function's own arrays, with
callback_latency. With --add, what an earlier run has measured of other methods and counts is kept,
as ten million points take their time.

Nothing is judged by its time: what is promised, 100 ms and 200 ms, is so for a machine that has nothing else to do. On a busy one, the processor time of the same
intervals tells more; with several threads it is that of all of them."""

import argparse
import json
import shlex
import subprocess
import sys
from pathlib import Path

from run_performance import machine

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import load_raw, write_result

BYTES_PER_PAIR = 12
# LOR and ALOR with the radius of four spacings, so that each ball holds as many points at any number of them
METHODS = {"lor": ("--radius-in-spacings", "4"), "alor": ("--radius-in-spacings", "4"), "default": ()}


def milliseconds(durations, clock):
    return f"{1000 * max(d[clock + '_seconds'] for d in durations):.0f}" if durations else "-"


def markdown(result):
    info = result["machine"]
    commands = ", ".join(f"`{command}`" for command in result["commands"])
    lines = ["# Callback, cancellation and memory", "",
             f"Made by {commands} on {info['cores']} cores of {info['processor']} (load average before: {info['load_average_before']:.1f}). A noisy sphere, "
             "six tenths of its points out. Milliseconds of wall-clock time, and behind the stroke of processor time; of two threads that is the sum.", "",
             "| points in | method | threads | seconds | calls | longest gap | where | second and third longest | longest by processor time | where | longest from `false` to the end | where | from the last call to the end, output included | progress never falls |",
             "| ---: | --- | ---: | ---: | ---: | ---: | --- | --- | ---: | --- | ---: | --- | ---: | --- |"]
    for run in result["runs"]:
        gaps, busiest = run["longest_gaps"], run["busiest_gaps"][0]
        ends = sorted(run["cancellations"], key=lambda c: -c["wall_seconds"])
        pair = lambda d: f"{milliseconds([d], 'wall')} / {milliseconds([d], 'cpu')}"
        place = lambda g: g["from"] if g["from"] == g["to"] else f"{g['from']} to {g['to']}"
        lines.append(f"| {run['points_in']} | {run['method']} | {run['threads']} | {run['wall_seconds']:.1f} | {run['calls']} | {pair(gaps[0])} | {place(gaps[0])} | "
                     + ", ".join(f"{pair(g)} ({place(g)})" for g in gaps[1:3])
                     + f" | {pair(busiest)} | {place(busiest)} | {pair(ends[0]) if ends else '-'} | {ends[0]['stage'] if ends else '-'} | {pair(run['last_gap'])} | {'yes' if run['is_monotonic'] else 'NO'} |")
    return "\n".join(lines + ["", "Peaks of the function's own arrays on one thread, in bytes an input point, and the share of them that an index and two numbers for each pair "
                              "of self neighbors take.", "", *memory_table(result["runs"])]) + "\n"


def memory_table(runs):
    of_one_thread = {(run["points_in"], run["method"]): run for run in runs if run["threads"] == 1}
    methods = [method for method in METHODS if any(m == method for _, m in of_one_thread)]

    def cell(run):
        if run is None:
            return "-"
        return f"{run['peak_bytes'] / run['points_in']:.0f} ({100 * BYTES_PER_PAIR * run['self_neighbor_pairs'] / run['peak_bytes']:.0f} %)"

    rows = [f"| {count} | " + " | ".join(cell(of_one_thread.get((count, method))) for method in methods) + " |"
            for count in sorted({count for count, _ in of_one_thread})]
    return ["| points in | " + " | ".join({"lor": "LOR", "alor": "ALOR"}.get(method, method) for method in methods) + " |", "| ---: |" + " ---: |" * len(methods), *rows]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the program")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the table is printed")
    parser.add_argument("--add", action="store_true", help="to what an earlier run has measured")
    parser.add_argument("--points", type=int, nargs="+", default=[10_000_000])
    parser.add_argument("--methods", nargs="+", default=list(METHODS), choices=list(METHODS))
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--cancellations", type=int, default=5, help="of each run")
    arguments = parser.parse_args()
    result = {"commands": [], "machine": machine(arguments.build), "runs": []}
    if arguments.add:
        result = load_raw(arguments.output)
    result["commands"].append(shlex.join(["run_callback_latency.py", "build", *sys.argv[2:]]))
    key = lambda run: (run["points_in"], list(METHODS).index(run["method"]), run["threads"])
    for points in arguments.points:
        for method in arguments.methods:
            for threads in arguments.threads:
                command = [arguments.build / "bin" / "callback_latency", "--points", points, "--method", method, "--threads", threads, "--cancellations",
                           arguments.cancellations, *METHODS[method]]
                output = subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, text=True).stdout
                run = json.loads(output)
                result["runs"] = sorted([other for other in result["runs"] if key(other) != key(run)] + [run], key=key)
                print(method, points, threads, file=sys.stderr, flush=True)
                write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
