#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns what run_performance.py measured into Markdown: performance_tables.py RESULT.json"""

import json
import math
import statistics
import sys

PROGRAMS = {"lor": "LOR", "alor": "ALOR", "default": "default", "wlop": "WLOP", "ear": "EAR",
            "ear defaults": "EAR, its defaults"}


def table(header, rows):
    lines = [header, ["---"] + ["---:"] * (len(header) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def phase_of_interest(line):
    """For WLOP without the normals that the program adds: the stricter comparison for ours, which computes them."""
    if line["program"] == "baseline_wlop":
        return next(phase for phase in line["phases"] if phase["name"] == "wlop")
    return line


def wall_seconds(line):
    return phase_of_interest(line)["wall_seconds"]


def cpu_seconds(line):
    return phase_of_interest(line)["cpu_seconds"]


def median(runs, value=wall_seconds):
    return statistics.median(map(value, runs))


def seconds_and_spread(runs, time=wall_seconds):
    times = [time(line) for line in runs]
    middle = f"{statistics.median(times):.3g}"
    return middle if len(times) == 1 else f"{middle} ({min(times):.3g} to {max(times):.3g})"


def bytes_per_input_point(runs, value):
    return f"{median(runs, lambda line: value(line) / line['number_of_input_points']):.0f}"


def memory_cells(runs):
    resident = bytes_per_input_point(runs, lambda line: line["resident_growth_bytes"])
    if "report" not in runs[0]:
        return [resident, "-"]
    return [resident, bytes_per_input_point(runs, lambda line: line["report"]["peak_bytes"])]


def comparison_table(comparison):
    rows = []
    for name, runs in comparison.items():
        method, _, threads = name.partition(", ")
        ratios = ["-", "-"]
        if "report" in runs[0] and not threads:
            ratios = [" / ".join(f"{median(comparison[slow], time) / median(runs, time):.0f}"
                                 for time in (wall_seconds, cpu_seconds)) for slow in ("wlop", "ear")]
        rows.append([PROGRAMS[method], str(runs[0]["threads"]), str(runs[0]["number_of_output_points"]), str(len(runs)),
                     seconds_and_spread(runs), f"{median(runs, cpu_seconds):.3g}",
                     *ratios, *memory_cells(runs)])
    return table(["method", "threads", "points out", "runs", "seconds, median (range)", "CPU seconds",
                  "times faster than WLOP, wall / CPU", "than EAR, wall / CPU", "resident growth, bytes a point",
                  "own arrays, bytes a point"], rows)


def comparison_ratios(comparison):
    wall, cpu = (median(comparison["lor"], time) / median(comparison["alor"], time)
                 for time in (wall_seconds, cpu_seconds))
    lines = [f"- LOR takes {wall:.2f} times as long as ALOR, {cpu:.2f} times its CPU time."]
    for method in ("lor", "alor", "default"):
        gain = median(comparison[method]) / median(comparison[f"{method}, 2 threads"])
        lines.append(f"- Two threads are {gain:.2f} times faster than one: {PROGRAMS[method]}.")
    return "\n".join(lines) + "\n"


def stage_table(columns):
    """`columns` maps a heading to runs of run_l0. A stage that a method has not leaves its cell empty."""
    stages = []
    for runs in columns.values():
        place = 0
        for stage in runs[0]["report"]["stages"]:
            if stage["name"] not in stages:
                stages.insert(place, stage["name"])   # behind the one before it
            place = stages.index(stage["name"]) + 1

    def cell(runs, stage):
        times = [sum(s["seconds"] for s in line["report"]["stages"] if s["name"] == stage) for line in runs]
        return f"{statistics.median(times):.3g}" if any(times) else ""

    rows = [[stage, *(cell(runs, stage) for runs in columns.values())] for stage in stages]
    rows.append(["whole function", *(f"{median(runs):.3g}" for runs in columns.values())])
    rows.append(["solver iterations", *(f"{runs[0]['report']['solver_iterations']}" for runs in columns.values())])
    rows.append(["peak of own arrays, bytes a point", *(memory_cells(runs)[1] for runs in columns.values())])
    return table(["stage, seconds", *columns], rows)


def fitted_exponent(points):
    """Slope of the least-squares line through (log n, log seconds)."""
    x, y = zip(*((math.log(n), math.log(seconds)) for n, seconds in points))
    mean_x, mean_y = statistics.fmean(x), statistics.fmean(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def group(runs, key):
    groups = {}
    for line in runs:
        groups.setdefault(key(line), []).append(line)
    return groups


def scaling_table(scaling):
    by_method = {method: group(runs, lambda line: line["number_of_input_points"])
                 for method, runs in group(scaling, lambda line: line["parameters"]["method"]).items()}
    rows = []
    for count in next(iter(by_method.values())):
        at_count = [by_count[count] for by_count in by_method.values()]
        rows.append([str(count), *(seconds_and_spread(runs, cpu_seconds) for runs in at_count),
                     *(" / ".join(memory_cells(runs)) for runs in at_count),
                     *(f"{pairs_per_sample(runs[0]):.1f}" for runs in at_count)])
    exponents = [fitted_exponent([(n, median(runs, cpu_seconds)) for n, runs in by_count.items()])
                 for by_count in by_method.values()]
    names = [PROGRAMS[method] for method in by_method]
    rows.append(["exponent", *(f"{exponent:.2f}" for exponent in exponents), *[""] * 2 * len(names)])
    return table(["points in", *(f"{name}, CPU seconds" for name in names),
                  *(f"{name}, bytes a point: resident growth / own arrays" for name in names),
                  *(f"{name}, self neighbors a sample" for name in names)], rows)


def pairs_per_sample(line):
    return line["report"]["number_of_self_neighbor_pairs"] / line["number_of_output_points"]


def figures_of_runs(runs):
    """Medians of runs of one method with one number of points."""
    line = runs[0]
    figures = {"method": line["parameters"].get("method", line["program"]),
               "solver": line["parameters"].get("solver"), "threads": line["threads"],
               "points_in": line["number_of_input_points"], "points_out": line["number_of_output_points"],
               "wall_seconds": median(runs), "cpu_seconds": median(runs, cpu_seconds)}
    if "report" in line:
        figures["bytes_a_point"] = median(runs, lambda run: run["report"]["peak_bytes"]) / line["number_of_input_points"]
    return figures


def figures(result):
    """What README and manual quote."""
    quoted = {"machine": {name: result["machine"][name] for name in ("processor", "cores")},
              "noise_percent": result["noise_percent"]}
    if "comparison" in result:
        quoted["comparison"] = {name: figures_of_runs(runs) for name, runs in result["comparison"].items()}
    for name in ("scaling", "solvers"):
        if name in result:
            of_one = group(result[name], lambda line: (line["parameters"]["method"], line["parameters"]["solver"],
                                                       line["number_of_input_points"]))
            quoted[name] = [figures_of_runs(runs) for runs in of_one.values()]
    return quoted


def markdown(result):
    machine = result["machine"]
    parts = ["# Speed and memory\n",
             f"Made by `{result['command']}` on {machine['cores']} cores of {machine['processor']} (load average "
             f"before: {machine['load_average_before']:.1f}), {machine['compiler']}, {machine['build_type']} "
             f"`{machine['flags']}`. Input: {result['mesh']}, sampled uniformly with Gaussian noise of "
             f"{result['noise_percent']:g} % of the bounding box's diagonal. Bytes are counted beyond input and output "
             "and divided by the number of input points: what the process's resident memory grew by, and what the "
             "function's own report says.\n"]
    if "comparison" in result:
        comparison = result["comparison"]
        n = comparison["lor"][0]["number_of_input_points"]
        parts += [f"## Side by side\n\n{n} points in. WLOP with its default radius, timed without normals. EAR is the "
                  "whole pipeline, that WLOP included, with sharpness angle and edge sensitivity of CGAL's example "
                  "(25, 0); with CGAL's defaults for both (30, 1) it is slower.\n",
                  comparison_table(comparison), comparison_ratios(comparison),
                  stage_table({PROGRAMS[method]: comparison[method] for method in ("lor", "alor", "default")})]
    if "scaling" in result:
        parts += ["## Cost against the number of points\n\nOne thread, 0.55 n points out; CPU time, median (range).\n",
                  scaling_table(result["scaling"])]
    if "solvers" in result:
        groups = group(result["solvers"],
                       lambda line: f"{line['parameters']['solver']}, {PROGRAMS[line['parameters']['method']]}")
        first = result["solvers"][0]
        parts += [f"## What half-sampling saves\n\n{first['number_of_input_points']} points in, "
                  f"{first['number_of_output_points']} out, one thread. `rows` solves the paper's explicit rows with "
                  "least-squares conjugate gradients, `block` the same problem with its fit term collapsed.\n",
                  stage_table(groups)]
    return "\n".join(parts)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as stream:
        print(markdown(json.load(stream)), end="")
