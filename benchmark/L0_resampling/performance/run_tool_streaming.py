#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Has the tool convert a file of ten million points on a terminal, and tells when it drew which progress while it read, and how much memory
it took. A tool that holds the whole file beside the points takes more than their coordinates by at least the size of the file."""

import argparse
import os
import pty
import random
import re
import shlex
import struct
import sys
import tempfile
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import write_result

COORDINATES = 3 * 8   # bytes a point in memory


def write_ply(path, points):
    """Binary, of `double`; the same million again and again, each time beside the last."""
    generator = random.Random(1)
    with open(path, "wb") as stream:
        stream.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {points}\nproperty double x\nproperty double y\nproperty double z\nend_header\n".encode())
        block = 100_000
        numbers = [generator.random() for _ in range(2 * block)]
        for first in range(0, points, block):
            rows = [value for i in range(min(block, points - first)) for value in (first + numbers[2 * i], numbers[2 * i + 1], 0.5)]
            stream.write(struct.pack(f"<{len(rows)}d", *rows))


def write_xyz(path, points):
    generator = random.Random(1)
    block = 100_000
    rows = "".join(f"{generator.random():.6f} {generator.random():.6f} {generator.random():.6f}\n" for _ in range(block))
    with open(path, "w", encoding="ascii") as stream:
        for first in range(0, points, block):
            stream.write(rows if points - first >= block else "".join(rows.splitlines(keepends=True)[:points - first]))


def run_on_terminal(command):
    """Seconds and text of all that is drawn, the exit status, and the peak of resident memory in bytes."""
    start = time.monotonic()
    child, terminal = pty.fork()
    if child == 0:
        os.execv(command[0], command)
    drawn = []
    while True:
        try:
            text = os.read(terminal, 65536)
        except OSError:   # the other end is closed
            break
        if not text:
            break
        drawn.append((time.monotonic() - start, text.decode(errors="replace")))
    _, status, usage = os.wait4(child, 0)
    return drawn, os.waitstatus_to_exitcode(status), usage.ru_maxrss * 1024


def measure(tool, scratch, suffix, points):
    source = scratch / f"points.{suffix}"
    {"ply": write_ply, "xyz": write_xyz}[suffix](source, points)
    drawn, status, peak = run_on_terminal([str(tool), str(source), str(scratch / "converted.ply"), "--convert-only"])
    if status != 0:
        raise RuntimeError("".join(text for _, text in drawn))
    shares = [(seconds, int(share)) for seconds, text in drawn for share in re.findall(r"(\d+) %  read", text)]
    gaps = [b[0] - a[0] for a, b in zip(shares, shares[1:])]
    return {"file": suffix, "points": points, "file_bytes": source.stat().st_size, "peak_bytes": peak, "shares": shares,
            "longest_gap_seconds": max(gaps, default=None), "is_monotonic": all(a[1] <= b[1] for a, b in zip(shares, shares[1:]))}


def markdown(result):
    lines = ["# The tool on many points", "", f"Made by `{result['command']}`.", "",
             "| file | points | bytes of the file | peak of resident memory, bytes a point | times that progress was drawn while reading | from, to | longest gap, seconds | never falls |",
             "| --- | ---: | ---: | ---: | ---: | --- | ---: | --- |"]
    for run in result["runs"]:
        shares = [share for _, share in run["shares"]]
        gap = run["longest_gap_seconds"]
        lines.append(f"| {run['file']} | {run['points']} | {run['file_bytes']} | {run['peak_bytes'] / run['points']:.1f} | {len(shares)} | "
                     f"{shares[0] if shares else '-'} %, {shares[-1] if shares else '-'} % | {'-' if gap is None else f'{gap:.2f}'} | {'yes' if run['is_monotonic'] else 'NO'} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tool", type=Path)
    parser.add_argument("--points", type=int, default=10_000_000)
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the table is printed")
    arguments = parser.parse_args()
    result = {"command": shlex.join(["run_tool_streaming.py", "build/bin/l0_resample", *sys.argv[2:]]), "runs": []}
    with tempfile.TemporaryDirectory() as scratch:
        for suffix in ("ply", "xyz"):
            result["runs"].append(measure(arguments.tool.resolve(), Path(scratch), suffix, arguments.points))
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
