#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the processor time and the memory of clouds whose points crowd with those of an even
cloud of as many points. Each cloud is resampled to half as many points on one thread; the time is
that of the stages, without reading and writing."""

import argparse
import json
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import write_result


def cube(n, generator):
    """A unit cube with noise of 0.3 % of its side."""
    points = generator.random((n, 3))
    points[numpy.arange(n), generator.integers(0, 3, n)] = generator.integers(0, 2, n)
    return points + generator.normal(0, 0.003, (n, 3))


def clouds(n):
    generator = numpy.random.default_rng(1)
    place = numpy.array([1, 0.4, 0.5])
    even = cube(n, generator)

    def with_crowd(size, points):
        crowded = even.copy()
        crowded[:size] = points
        return crowded

    scattered = generator.normal(0, 1, (n, 3))
    places = generator.random((10, 3))[generator.integers(0, 10, n // 2)]
    line = numpy.zeros((n, 3))
    line[:, 0] = generator.random(n)
    return {
        "even": even,
        "all at one place": numpy.tile(place, (n, 1)),
        "half at one place": with_crowd(n // 2, place),
        "half within 1e-9 of the side": with_crowd(n // 2, place + 1e-9 * scattered[: n // 2]),
        "all but 100 within 1e-3 of the side": with_crowd(n - 100, place + 1e-3 * scattered[:-100]),
        "half in ten places": with_crowd(n // 2, places + 1e-6 * scattered[: n // 2]),
        "a line": line,
        "one point": place.reshape(1, 3),
    }


def measure(tool, folder, points, size, method):
    source, report = folder / "cloud.npy", folder / "report.json"
    numpy.save(source, points)
    command = [tool, source, folder / "result.ply", "--force", "--method", method, "--threads", 1,
               "--device", "cpu", "--points", size, "--quiet", "--json", report]
    subprocess.run([str(word) for word in command], check=True, stderr=subprocess.DEVNULL)
    resampling = json.loads(report.read_text(encoding="utf-8"))["resampling"]
    return {"seconds": sum(stage["seconds"] for stage in resampling["stages"]),
            "bytes": resampling["peak_bytes"]}


def markdown(result):
    lines = ["# Crowded points", "",
             f"Made by `{result['command']}`. Time and memory of the default method and of LOR, as",
             "multiples of those of an even cloud of as many points; the shortest of "
             f"{result['repetitions']} runs.", "",
             "| points | cloud | default: time | memory | LOR: time | memory |",
             "| ---: | --- | ---: | ---: | ---: | ---: |"]
    for row in result["rows"]:
        figures = [f"{row[method][key]:.2f}" for method in ("default", "lor") for key in ("seconds", "bytes")]
        lines.append(f"| {row['points']} | {row['cloud']} | {' | '.join(figures)} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tool", type=Path)
    parser.add_argument("--points", type=int, nargs="+", default=[100_000, 1_000_000])
    parser.add_argument("--repetitions", type=int, default=3)
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME", help="see common/results.py")
    arguments = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        for n in arguments.points:
            of_even = {}
            for name, points in clouds(n).items():
                row = {"points": n, "cloud": name}
                for method in ("default", "lor"):
                    runs = [measure(arguments.tool, Path(scratch), points, n // 2, method)
                            for _ in range(arguments.repetitions)]
                    best = {key: min(run[key] for run in runs) for key in ("seconds", "bytes")}
                    of_even.setdefault(method, best)
                    row[method] = {key: best[key] / of_even[method][key] for key in best}
                rows.append(row)
                print(n, name, file=sys.stderr, flush=True)
    result = {"command": shlex.join(["run_crowds.py", "build/bin/l0_resample", *sys.argv[2:]]),
              "repetitions": arguments.repetitions, "rows": rows}
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
