#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the longest time between two calls of the callback, and that from its `false` to the end of the call, with callback_latency, and writes
NAME.json and NAME.md.

Nothing is judged by its time: what is promised, 100 ms and 200 ms, is so for a machine that has nothing else to do. On a busy one, the processor time of the same
intervals tells more; with several threads it is that of all of them."""

import argparse
import json
import shlex
import subprocess
import sys
from pathlib import Path

from performance_tables import write_or_print
from run_performance import machine

# LOR and ALOR with the radius of four spacings, so that each ball holds as many points at any number of them
METHODS = {"lor": ("--radius-in-spacings", "4"), "alor": ("--radius-in-spacings", "4"), "default": ()}


def milliseconds(durations, clock):
    return f"{1000 * max(d[clock + '_seconds'] for d in durations):.0f}" if durations else "-"


def markdown(result):
    info = result["machine"]
    lines = ["# Callback and cancellation", "",
             f"Made by `{result['command']}` on {info['cores']} cores of {info['processor']} (load average before: {info['load_average_before']:.1f}). A noisy sphere, "
             "six tenths of its points out. Milliseconds of wall-clock time, and behind the stroke of processor time.", "",
             "| points in | method | threads | seconds | calls | longest gap | where | second and third longest | longest by processor time | where | longest from `false` to the end | where | progress never falls |",
             "| ---: | --- | ---: | ---: | ---: | ---: | --- | --- | ---: | --- | ---: | --- | --- |"]
    for run in result["runs"]:
        gaps = run["longest_gaps"]
        busiest = max(gaps, key=lambda g: g["cpu_seconds"])
        ends = sorted(run["cancellations"], key=lambda c: -c["wall_seconds"])
        pair = lambda d: f"{milliseconds([d], 'wall')} / {milliseconds([d], 'cpu')}"
        place = lambda g: g["from"] if g["from"] == g["to"] else f"{g['from']} to {g['to']}"
        lines.append(f"| {run['points_in']} | {run['method']} | {run['threads']} | {run['wall_seconds']:.1f} | {run['calls']} | {pair(gaps[0])} | {place(gaps[0])} | "
                     + ", ".join(f"{pair(g)} ({place(g)})" for g in gaps[1:3])
                     + f" | {pair(busiest)} | {place(busiest)} | {pair(ends[0]) if ends else '-'} | {ends[0]['stage'] if ends else '-'} | {'yes' if run['is_monotonic'] else 'NO'} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the program")
    parser.add_argument("--output", type=Path, help="writes OUTPUT.json and OUTPUT.md; else the table is printed")
    parser.add_argument("--points", type=int, default=10_000_000)
    parser.add_argument("--methods", nargs="+", default=list(METHODS), choices=list(METHODS))
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--cancellations", type=int, default=5, help="of each run")
    arguments = parser.parse_args()
    result = {"command": shlex.join(["run_callback_latency.py", "build", *sys.argv[2:]]), "machine": machine(arguments.build), "runs": []}
    for method in arguments.methods:
        for threads in arguments.threads:
            command = [arguments.build / "bin" / "callback_latency", "--points", arguments.points, "--method", method, "--threads", threads, "--cancellations",
                       arguments.cancellations, *METHODS[method]]
            output = subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE, text=True).stdout
            result["runs"].append(json.loads(output))
            print(method, threads, file=sys.stderr, flush=True)
    write_or_print(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
