#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the measured parts of README.md anew, from the results beside this file:

  readme_figures.py README.md [--check]
  readme_figures.py paper/paper.md --parts quality device large_clouds [--check]

A part stands between the lines <!-- measured: NAME --> and <!-- end -->. With --check, nothing is written, and the exit
status tells whether the parts are what the results say.
"""

import argparse
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE / folder) for folder in ("common", "quality", "performance")]
sys.dont_write_bytecode = True

import performance_tables  # noqa: E402
import quality_tables  # noqa: E402
from measured import measured_at  # noqa: E402
from results import found_in, load_json, read_tables  # noqa: E402

METHODS = {"lor": "LOR", "alor": "ALOR", "default": "default"}
QUALITY_METHODS = {**METHODS, "wlop_6_uniform": "WLOP, radius 6, uniform", "ear_4": "EAR, radius 4",
                   "smoothed_ear_6_again": "EAR, radius 6, input smoothed first and after WLOP"}
QUALITY_HEADINGS = ("mean distance, %", "normal error, degrees", "edge recall", "NN6 cv")


def read(path):
    return (HERE / path).read_text(encoding="utf-8")


def duration(seconds):
    return f"{seconds:.3g} s" if seconds >= 1 else f"{1000 * seconds:.3g} ms"


def picture():
    result = load_json(HERE / "quality/results/picture.json")
    experiment, tried = result["experiment"], result["methods"]
    best = {name: min(tried[name]["mean_distance_percent"].values()) for name in tried}
    of_cgal = len(tried["WLOP"]["mean_distance_percent"]), len(tried["EAR"]["mean_distance_percent"])
    radii = ", ".join(f"{radius:g}" for radius in result["radii"])
    return (f"Above: {experiment['input_points']} points of the fandisk mesh with noise of {experiment['noise_percent']:g} % of its diagonal, and "
            f"{experiment['output_points']} points that each method makes of them. Of\nWLOP and EAR, in CGAL's programs, it is the best of "
            f"{of_cgal[0]} and {of_cgal[1]} variants (radii of {radii} spacings, with and without uniform density, with and without\nsmoothing). "
            f"Middle: CGAL's Poisson mesh of these points, red where it is {result['largest_error_percent']:g} % off the true surface or more. On "
            f"average it is {best['WLOP']:.2f} % off for\nWLOP, {best['EAR']:.2f} % for EAR, {best['ours']:.2f} % for this package, and "
            f"{best['input']:.2f} % for all points of the input with CGAL's normals. Below: a real scan of CGAL's data, of a\nhippo from one side, "
            "drawn with the normals that it comes with, and what this package makes of its points alone. Drawn by `draw_comparison.py` in `benchmark/L0_resampling/quality`.\n")


def quality():
    text = read("quality/results/fandisk.md")
    rows = [[f"{noise:g} %", name, *(figures[method][heading] for heading in QUALITY_HEADINGS)]
            for noise, figures in quality_tables.read_figures(text).items()
            for method, name in QUALITY_METHODS.items()]
    header = ["noise", "method", *(heading.replace(", %", "") for heading in QUALITY_HEADINGS)]
    lines = quality_tables.table(header, rows).splitlines()
    lines[1] = "| --- | --- |" + " ---: |" * len(QUALITY_HEADINGS)
    points_in, points_out = found_in(r"(\d+) points in, (\d+) out", text)
    return (f"On {points_in} points of the fandisk mesh with Gaussian noise, {points_out} points out. "
            "Lengths and noise are in %\nof the diagonal; smaller is better but for recall.\n\n" + "\n".join(lines) + "\n")


def speed():
    result = load_json(HERE / "performance/results/fandisk.json")
    scaling = load_json(HERE / "performance/results/scaling.json")["scaling"]
    comparison, cores = result["comparison"], result["machine"]["cores"]

    def times_faster(slow, method):
        return f"{comparison[slow]['cpu_seconds'] / comparison[method]['cpu_seconds']:.0f}"

    rows = []
    for method, name in METHODS.items():
        gain = comparison[method]["wall_seconds"] / comparison[f"{method}, 2 threads"]["wall_seconds"]
        rows.append([name, times_faster("wlop", method),
                     f"{times_faster('ear defaults', method)} / {times_faster('ear', method)}", f"{gain:.2f}",
                     f"{comparison[method]['bytes_a_point']:.0f}"])
    table = performance_tables.table(
        ["method", "times faster than CGAL's WLOP (default radius)",
         "than the EAR pipeline on it, CGAL's defaults / parameters of its example", "two threads against one",
         "own arrays, bytes an input point"], rows)
    points = {method: [(run["points_in"], run["cpu_seconds"]) for run in scaling if run["method"] == method]
              for method in METHODS}
    growth = [f"n^{performance_tables.fitted_exponent(points[method]):.2f}" for method in METHODS]
    counts = [n for n, _ in points["default"]]
    lor, noise = comparison["lor"], result["noise_percent"]
    return (f"Fandisk, {lor['points_in']} points in, {lor['points_out']} out, noise "
            f"{noise:g} %, one thread of a machine with {cores} cores, all methods in one run:\n\n"
            f"{table}\nFrom {min(counts)} to {max(counts)} points, with noise of {noise:g} % of the diagonal "
            f"throughout, the time of LOR, ALOR and the\ndefault method grows as {', '.join(growth[:2])} and {growth[2]}.\n")


def device():
    result = load_json(HERE / "performance/results/cuda_h200.json")
    seconds = {(run["points_in"], run["points_out"], run["method"]): run["seconds"] for run in result["results"]}
    rows = [[f"{points_in} to {points_out}", *(duration(seconds[points_in, points_out, method])
                                             for method in ("lor", "default"))]
            for points_in, points_out, method in seconds if method == "default"]
    table = performance_tables.table(["points", "LOR", "default"], rows)

    def beside(solver, threads):
        return duration(next(run["seconds"] for run in result["beside"]
                             if (run["method"], run["solver"], run["threads"]) == ("lor", solver, threads)))

    most = max(run["threads"] for run in result["beside"])
    name = result["results"][0]["device"]
    return (f"On one {name}, with points and result on the device:\n\n{table}\n"
            f"On the processor of that machine LOR takes {beside('block', 1)} on one core for the first row and "
            f"{beside('block', most)} on {most}. With the\npaper's explicit rows it takes {beside('rows', most)} "
            f"there, or {beside('cuda_rows', most)} with those rows solved on the device.\n")


def report():
    small = read("report/results/small.md")
    minutes, = found_in(r"The experiments took ([\d.]+) minutes", small)
    cores, = found_in(r"(\d+) cores of ", small)
    claims = read_tables(read("report/results/full.md"))[0].rows
    kept = sum(row[-1] == "holds" for row in claims)
    return (f"The small version took {minutes} minutes on {cores} cores, without the build. "
            f"Of {len(claims)} sentences of the paper that are checked, with its numbers of points,\n{kept} hold and {len(claims) - kept} do not; the tables of both "
            "versions stand in `benchmark/L0_resampling/report/results`.\n")


def large_clouds():
    table = read_tables(read("performance/results/large_clouds.md"))[0]
    points, how, seconds, _, memory, tiles, _ = table.rows[-1]
    if not how.startswith("--as-one"):
        sys.exit("readme_figures: the last row of large_clouds.md is not of a run by tiles")
    return (f"The tool resamples a scan of {points} points, in a LAS file, with `{how}` on two threads "
            f"in {float(seconds):.0f} seconds,\nin {tiles} tiles, and takes {memory} MB of memory at its peak.\n")


# What writes each part, and the results that it is of
PARTS = {"picture": (picture, ["quality/picture"]), "report": (report, ["report/small", "report/full"]),
         "quality": (quality, ["quality/fandisk"]), "speed": (speed, ["performance/fandisk", "performance/scaling"]),
         "device": (device, ["performance/cuda_h200"]), "large_clouds": (large_clouds, ["performance/large_clouds"])}
PARTS_OF_README = ["picture", "report", "quality", "speed", "device"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("readme", type=Path)
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS_OF_README)
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()

    old = text = arguments.readme.read_text(encoding="utf-8")
    for name in arguments.parts:
        part, results = PARTS[name]
        written = f"{part()}\n{measured_at(*results)}\n"
        text, found = re.subn(rf"(<!-- measured: {name} -->\n).*?(<!-- end -->)",
                              lambda match, written=written: match[1] + written + match[2], text, flags=re.DOTALL)
        if found != 1:
            sys.exit(f"readme_figures: {arguments.readme} has {found} parts {name}")
    if arguments.check and text != old:
        sys.exit(f"readme_figures: {arguments.readme} is not what the results say; readme_figures.py {arguments.readme} writes it anew")
    if not arguments.check:
        arguments.readme.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
