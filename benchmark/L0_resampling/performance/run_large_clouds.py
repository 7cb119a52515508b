#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resamples scenes of any size by one call in memory and by tiles, and compares time and memory.

The scenes are those of `stream_scene`. All threads are used, tile after tile."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from performance_tables import table
from results import command_line, processor, write_result

SAMPLES_PER_POINT = 0.3


def run(*words):
    """Wall-clock seconds, and the peak of resident memory of the process in bytes."""
    start = time.monotonic()
    process = subprocess.Popen([str(word) for word in words])
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise subprocess.CalledProcessError(process.returncode, [str(word) for word in words])
    return time.monotonic() - start, usage.ru_maxrss * 1024


def size_of(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def measure(programs, scratch, points, memories, in_memory):
    scene, result = scratch / "scene.las", scratch / "result.las"
    seconds, _ = run(programs / "stream_scene", scene, "--points", points)
    outputs = int(points * SAMPLES_PER_POINT)
    rows = [{"points": points, "how": "written by stream_scene", "seconds": seconds, "bytes_written": scene.stat().st_size}]
    if in_memory:
        seconds, peak = run(programs / "l0_resample", scene, result, "--points", outputs, "--force", "--quiet")
        rows.append({"points": points, "how": "in memory", "seconds": seconds, "peak_bytes": peak, "tiles": 1, "bytes_written": result.stat().st_size})
    for memory in memories:
        folder = scratch / "tiles"
        seconds, peak = run(programs / "l0_resample", scene, "--as-one", "--points", outputs, "--memory", memory, "--output-directory", folder,
                            "--force", "--quiet")
        index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
        written = sum(tile["output_points"] for tile in index["tiles"])
        if written != outputs:
            raise RuntimeError(f"{written} points instead of {outputs}")
        rows.append({"points": points, "how": f"--as-one --memory {memory}", "seconds": seconds, "peak_bytes": peak, "tiles": len(index["tiles"]),
                     "bytes_written": size_of(folder)})
    return rows


def markdown(result):
    rows = [[str(row["points"]), row["how"], f"{row['seconds']:.1f}", f"{row['points'] / row['seconds'] / 1e6:.2f}",
                     f"{row['peak_bytes'] / 1e6:.0f}" if "peak_bytes" in row else "", str(row.get("tiles", "")), f"{row['bytes_written'] / 1e6:.0f}"]
            for row in result["runs"]]
    return "\n".join(["# Large clouds", "", f"Made by `{result['command']}` on {result['threads']} threads of {result['processor']}.", "",
                      f"Scenes of `stream_scene` as LAS files, and {SAMPLES_PER_POINT} samples a point.", "",
                      table(["points", "how", "seconds", "million points a second", "peak of resident memory, MB", "tiles", "MB written in the end"],
                            rows)]) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder")
    parser.add_argument("--points", type=int, nargs="+", default=[1_000_000])
    parser.add_argument("--memory", nargs="+", default=["1GB"], help="for the runs by tiles of each number of points")
    parser.add_argument("--in-memory-up-to", type=int, default=10_000_000, metavar="POINTS", help="clouds that one call in memory resamples too")
    parser.add_argument("--scratch", type=Path, help="where scenes and tiles lie while they are needed")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME", help="what to write, see common/results.py; else the table is printed")
    arguments = parser.parse_args()
    result = {"command": command_line("run_large_clouds.py", sys.argv[1:]), "threads": len(os.sched_getaffinity(0)), "processor": processor(),
              "runs": []}
    for points in arguments.points:
        with tempfile.TemporaryDirectory(dir=arguments.scratch) as scratch:
            result["runs"] += measure(arguments.build / "bin", Path(scratch), points, arguments.memory, points <= arguments.in_memory_up_to)
        print(markdown(result), flush=True)
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
