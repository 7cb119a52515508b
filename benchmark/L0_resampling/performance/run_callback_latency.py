#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints, for each input and method, the longest time between two calls of the callback, and the
longest from its `false` to the end of the call, in milliseconds of wall-clock and processor time.

Promised are 100 ms and 200 ms, on a machine that does nothing else. Ends with 1 if a time is more
than ten times as long, which a busy machine does not explain. On a busy machine the processor time
tells more; with several threads it is the sum over all of them."""

import argparse
import itertools
import json
import subprocess
import sys
from pathlib import Path

INPUTS = ("sphere", "volume", "crowd")
LONGEST_SILENCE, LONGEST_CANCELLATION = 0.1, 0.2  # seconds, as promised
TOLERATED_FACTOR = 10
# LOR and ALOR with the radius of four spacings, so that each ball holds as many points at any
# number of them
METHODS = {"lor": ("--radius-in-spacings", "4"), "alor": ("--radius-in-spacings", "4"),
           "default": ()}


def measure(build, input_name, method, points, threads, cancellations):
    command = [build / "bin" / "callback_latency", "--input", input_name, "--points", points,
               "--method", method, "--threads", threads, "--cancellations", cancellations]
    if input_name != "volume":  # no surface has the spacing that the radius would be of
        command += METHODS[method]
    output = subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE,
                            text=True).stdout
    return json.loads(output)


def longest(durations, clock):
    return max((duration[f"{clock}_seconds"] for duration in durations), default=0)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the program")
    parser.add_argument("--inputs", nargs="+", default=INPUTS, choices=INPUTS)
    parser.add_argument("--methods", nargs="+", default=list(METHODS), choices=list(METHODS))
    parser.add_argument("--points", type=int, default=20_000)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--cancellations", type=int, default=3, help="of each run")
    arguments = parser.parse_args()
    are_kept = True
    for input_name, method, threads in itertools.product(arguments.inputs, arguments.methods,
                                                         arguments.threads):
        run = measure(arguments.build, input_name, method, arguments.points, threads,
                      arguments.cancellations)
        silences, ends = run["longest_gaps"], run["cancellations"]
        print(f"{input_name}, {method}, {arguments.points} points, {threads} threads: silence "
              + " / ".join(f"{1000 * longest(silences, clock):.0f}" for clock in ("wall", "cpu"))
              + ", end " + " / ".join(f"{1000 * longest(ends, clock):.0f}"
                                      for clock in ("wall", "cpu")), flush=True)
        are_kept &= (longest(silences, "wall") <= TOLERATED_FACTOR * LONGEST_SILENCE
                     and longest(ends, "wall") <= TOLERATED_FACTOR * LONGEST_CANCELLATION
                     and run["is_monotonic"])
    if not are_kept:
        sys.exit("run_callback_latency.py: a time is far longer than promised, or progress falls")


if __name__ == "__main__":
    main()
