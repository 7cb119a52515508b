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
import textwrap
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE / folder) for folder in ("common", "quality", "performance")]
sys.dont_write_bytecode = True

import performance_tables  # noqa: E402
import quality_tables  # noqa: E402
from measured import measured_at  # noqa: E402
from results import found_in, load_json, read_tables  # noqa: E402

# Without ALOR, whose results and times differ little from those of LOR
METHODS = {"lor": "LOR", "default": "default"}
QUALITY_METHODS = {"lor": "LOR", "default": "default", "wlop_6_uniform": "WLOP, radius 6, uniform", "ear_4": "EAR, radius 4",
                   "smoothed_ear_6_again": "EAR, radius 6, input smoothed first and after WLOP"}
QUALITY_HEADINGS = ("mean distance, %", "normal error, degrees", "edge recall", "NN6 cv")


def read(path):
    return (HERE / path).read_text(encoding="utf-8")


def paragraph(text):
    return textwrap.fill(text, 100, break_long_words=False, break_on_hyphens=False) + "\n"


def duration(seconds):
    return f"{seconds:.3g} s" if seconds >= 1 else f"{1000 * seconds:.3g} ms"


def picture():
    result = load_json(HERE / "quality/results/picture.json")
    experiment, tried = result["experiment"], result["methods"]
    best = {name: min(tried[name]["mean_distance_percent"].values()) for name in tried}
    of_cgal = len(tried["WLOP"]["mean_distance_percent"]), len(tried["EAR"]["mean_distance_percent"])
    return paragraph(
        f"Above: {experiment['input_points']} points of the fandisk mesh with noise of {experiment['noise_percent']:g} % of its diagonal, "
        f"and {experiment['output_points']} points by each method; those of WLOP and EAR are the best of {of_cgal[0]} and "
        f"{of_cgal[1]} variants. Middle: CGAL's Poisson mesh of these points, red where it is "
        f"{result['largest_error_percent']:g} % off the surface or more. Its mean distance from the surface is {best['WLOP']:.2f} % for WLOP, "
        f"{best['EAR']:.2f} % for EAR, {best['ours']:.2f} % for this package, and {best['input']:.2f} % for the input with "
        "CGAL's normals. Below: a scan from CGAL's data, and the result of this package.")


def quality():
    text = read("quality/results/fandisk.md")
    rows = [[f"{noise:g} %", name, *(figures[method][heading] for heading in QUALITY_HEADINGS)]
            for noise, figures in quality_tables.read_figures(text).items()
            for method, name in QUALITY_METHODS.items()]
    header = ["noise", "method", *(heading.replace(", %", "") for heading in QUALITY_HEADINGS)]
    lines = quality_tables.table(header, rows).splitlines()
    lines[1] = "| --- | --- |" + " ---: |" * len(QUALITY_HEADINGS)
    points_in, points_out = found_in(r"(\d+) points in, (\d+) out", text)
    text = paragraph(f"The input has {points_in} points of the fandisk mesh with Gaussian noise, and each result {points_out} points. Lengths and "
                     "noise are in % of the diagonal. Smaller is better, except for the recall.")
    return text + "\n" + "\n".join(lines) + "\n"


def speed():
    result = load_json(HERE / "performance/results/fandisk.json")
    comparison, lor = result["comparison"], result["comparison"]["lor"]

    def times_faster(slow, method):
        return f"{comparison[slow]['cpu_seconds'] / comparison[method]['cpu_seconds']:.0f}"

    table = performance_tables.table(
        ["method", "WLOP", "EAR, CGAL's defaults", "EAR, as in its example", "bytes per input point"],
        [[name, *(times_faster(slow, method) for slow in ("wlop", "ear defaults", "ear")),
          f"{comparison[method]['bytes_a_point']:.0f}"] for method, name in METHODS.items()])
    flags, = found_in("Release `([^`]+)`", read("performance/results/fandisk.md"))
    text = paragraph(
        "How many times as long WLOP with its default radius and the pipeline of WLOP and EAR take, on one thread, and the memory of a call: "
        f"fandisk with noise of {result['noise_percent']:g} %, {lor['points_in']} points to {lor['points_out']}, on "
        f"{result['machine']['processor']}, all compiled with `{flags}`.")
    return f"{text}\n{table}"


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
    text = paragraph(f"On the processor of that machine LOR takes {beside('block', 1)} on one core for the first row and "
                     f"{beside('block', most)} on {most}. With the paper's explicit rows it takes {beside('rows', most)} there, or "
                     f"{beside('cuda_rows', most)} with those rows solved on the device.")
    return f"On one {name}, with points and result on the device:\n\n{table}\n{text}"


def large_clouds():
    table = read_tables(read("performance/results/large_clouds.md"))[0]
    points, how, seconds, _, memory, tiles, _ = table.rows[-1]
    if not how.startswith("--as-one"):
        sys.exit("readme_figures: the last row of large_clouds.md is not of a run by tiles")
    return paragraph(f"The tool resamples a scan of {points} points, in a LAS file, with `{how}` on two threads "
                     f"in {float(seconds):.0f} seconds, in {tiles} {'tile' if tiles == '1' else 'tiles'}, and takes {memory} MB of memory at its peak.")


# What writes each part, and the results that it is of
PARTS = {"picture": (picture, ["quality/picture"]), "quality": (quality, ["quality/fandisk"]),
         "speed": (speed, ["performance/fandisk"]), "device": (device, ["performance/cuda_h200"]),
         "large_clouds": (large_clouds, ["performance/large_clouds"])}
PARTS_OF_README = ["picture", "quality", "speed"]


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
