#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resamples one scene in several tilings, and compares samples near the seams with the others.

The scene is one of `stream_scene`, with scanners whose density falls with the distance. Memory decides on the number of tiles, and
whether they have the facts of the whole cloud.
"""

import argparse
import json
import subprocess
import tempfile
from pathlib import Path

from quality_tables import table

# --memory and --halo, by the number of points
RUNS = {1_000_000: (("4GB", 20), ("320MB", 20), ("320MB", 60), ("235MB", 60), ("180MB", 20), ("142MB", 20)), 60_000: (("4GB", 20),)}
SAMPLES_PER_POINT = 0.3
MEASURES = {"samples": "samples", "mean_distance": "mean distance of six", "variation": "its variation", "doubled_percent": "doubled, %",
            "gap_percent": "gaps, %", "angle": "angle, degrees", "opposed_percent": "opposed, %"}


def run(*words):
    return subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE, text=True).stdout


def samples(programs, cloud, scratch):
    """Positions and normals of all points, as they are stored."""
    text = scratch / "all.xyz"
    run(programs / "l0_resample", cloud, text, "--convert-only", "--force", "--quiet")
    return {tuple(line.split()[:6]) for line in text.read_text(encoding="utf-8").splitlines()}


def measure(programs, scene, number, memory, halo, scratch):
    folder, merged, report = scratch / "tiles", scratch / "all.ply", scratch / "report.json"
    run(programs / "l0_resample", scene, "--as-one", "--points", int(number * SAMPLES_PER_POINT), "--memory", memory, "--halo", halo,
        "--output-directory", folder, "--output", merged, "--json", report, "--force", "--quiet")
    index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
    return {"memory": memory, "halo": halo, "tiles": len(index["tiles"]), "overlap": index["overlap"], "sample_spacing": index["sample_spacing"],
            "samples": samples(programs, merged, scratch), "peak_bytes": json.loads(report.read_text(encoding="utf-8"))["peak_bytes"],
            "evaluation": json.loads(run(programs / "evaluate_seams", merged, folder / "index.json"))}


def markdown(number, runs):
    lines = ["# Seams between tiles", "", "Made by `run_tiles.py build`.", "",
             f"A scene of {number} points, resampled to {int(number * SAMPLES_PER_POINT)}. Lengths are in spacings of the samples. Samples within a neighbor radius of "
             "a seam, and all others: the mean distance to the six nearest samples and its coefficient of variation; samples with another one within 0.3; those "
             "whose six are further away than 1.6 in the mean; and the angle to the normal of the nearest, without and with its sign.", ""]
    rows = [[str(result["tiles"]), str(result["halo"]), place, str(evaluation["samples"]), *(f"{evaluation[name]:.3g}" for name in list(MEASURES)[1:])]
            for result in runs for place, evaluation in result["evaluation"].items()]
    lines += [table(["tiles", "--halo", "where", *MEASURES.values()], rows), ""]
    rows = [[str(result["tiles"]), result["memory"], str(result["halo"]), f"{result['peak_bytes'] / 2**20:.0f}", str(result["overlap"]["samples"]),
             f"{100 * result['overlap']['matches'] / max(1, result['overlap']['samples']):.1f}", str(result["overlap"]["opposed"]),
             f"{result['overlap']['root_mean_square_distance'] / result['sample_spacing']:.3f}",
             str(len(result["samples"] - runs[0]["samples"]))] for result in runs]
    lines += ["What two tiles have both found: samples of one with a sample of the other within half a spacing, and how far off these are. Where "
              "--memory holds all points once, the facts of the cloud are found at once, else in passes over it; where it holds 220 bytes for each sample, "
              "sides are found at once, else tile by tile. Samples that one tile has not: by any bit of their positions and normals.", "",
              table(["tiles", "--memory", "--halo", "peak of memory, MB", "samples", "matched, %", "opposed", "root mean square distance", "that one tile has not"], rows)]
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder")
    parser.add_argument("--small", action="store_true", help="a small scene, to see that all runs")
    parser.add_argument("--output", type=Path, help="the table; by default results/tiles.md, and none with --small")
    arguments = parser.parse_args()
    number = min(RUNS) if arguments.small else max(RUNS)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = Path(scratch)
        scene = scratch / "scene.las"
        run(arguments.build / "bin/stream_scene", scene, "--points", number)
        runs = [measure(arguments.build / "bin", scene, number, memory, halo, scratch) for memory, halo in RUNS[number]]
    text = markdown(number, runs)
    output = arguments.output or (None if arguments.small else Path(__file__).with_name("results") / "tiles.md")
    if output:
        output.write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
