#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the manual quotes: generate_text.py DEFAULTS.json BENCHMARK_DIRECTORY OUTPUT_DIRECTORY

- figures_of_the_code: Doxygen aliases, one for each default, constant and measured figure, such as \\default_normal_weight,
  \\constant_pca_radius_factor, \\quality_fandisk_10_default_distance (noise of 1.0 %) or \\speed_default_seconds;
- formula_macros.tex: the same for formulas, where their names have letters only, such as \\constantPcaRadiusFactor, as
  TeX knows no underscores;
- table_*.txt: the tables of the benchmarks, for \\include{doc}.

DEFAULTS.json is what the program print_defaults prints, BENCHMARK_DIRECTORY is benchmark/L0_resampling.
"""

import html
import json
import re
import sys
from pathlib import Path


def load(path):
    with open(path, encoding="utf-8") as stream:
        return json.load(stream)


def is_table_line(line):
    return line.startswith("|")


def cell(text):
    text = html.escape(text, quote=False)
    text = re.sub(r"\*\*(.+?)\*\*", r"<b>\1</b>", text)
    return re.sub(r"`(.+?)`", r"<code>\1</code>", text)


def cells(line):
    return [text.strip() for text in line.strip()[1:-1].split("|")]


LONGEST_UNBROKEN_CELL = 16    # characters; a longer one may have several lines


def row(line, tag, are_numbers):
    parts = []
    for text, is_number in zip(cells(line), are_numbers, strict=True):
        classes = [name for name, applies in (("l0Number", is_number), ("l0Unbroken", tag == "td" and len(text) <= LONGEST_UNBROKEN_CELL)) if applies]
        attribute = f' class="{" ".join(classes)}"' if classes else ""
        parts.append(f"<{tag}{attribute}>{cell(text)}</{tag}>")
    return "<tr>" + "".join(parts) + "</tr>"


def html_tables(markdown):
    """The tables of a Markdown text, in their order."""
    tables, lines = [], []
    for line in [*markdown.splitlines(), ""]:
        if is_table_line(line):
            lines.append(line)
        elif lines:
            header, alignment, *body = lines
            are_numbers = [text.endswith(":") for text in cells(alignment)]
            rows = [row(header, "th", are_numbers), *(row(b, "td", are_numbers) for b in body)]
            tables.append("\n".join(['<table class="l0Table">', *rows, "</table>"]) + "\n")
            lines = []
    return tables


def camel_case(name):
    first, *others = name.split("_")
    return first + "".join(word.capitalize() for word in others)


def code_figures(defaults):
    for group, values in defaults.items():
        for name, value in values.items():
            yield f"{group}_{name}", f"{value:g}"


QUALITY_NAMES = {"mean distance, %": "distance", "mean coverage, %": "coverage", "normal error, degrees": "normal_error",
                 "normals inwards, %": "inwards", "edge recall": "recall", "NN6 cv": "evenness"}


def quality_figures(quality_tables, name, result):
    """Of each method, and the best figure of CGAL's in each column."""
    for experiment in result["experiments"]:
        noise = f"{experiment['noise_percent']:.1f}".replace(".", "")
        for method, runs in experiment["measurements"].items():
            for column in quality_tables.COLUMNS:
                value = column.value([runs["evaluation"]])
                if column.heading in QUALITY_NAMES and value is not None:
                    yield f"quality_{name}_{noise}_{method}_{QUALITY_NAMES[column.heading]}", f"{value:.{column.digits}f}"
        theirs = [[run["evaluation"]] for run in experiment["measurements"].values() if not quality_tables.is_ours([run])]
        for column in quality_tables.COLUMNS:
            if column.heading in QUALITY_NAMES:
                best = column.best(column.value(evaluations) for evaluations in theirs)
                yield f"quality_{name}_{noise}_best_{QUALITY_NAMES[column.heading]}", f"{best:.{column.digits}f}"


def speed_figures(performance_tables, comparison, scaling):
    median = performance_tables.median
    for method in ("lor", "alor", "default"):
        runs = comparison[method]
        yield f"speed_{method}_seconds", f"{median(runs):.2g}"
        yield f"speed_{method}_bytes", performance_tables.memory_cells(runs)[1]
        for slow in ("wlop", "ear"):
            yield f"speed_{method}_over_{slow}", f"{median(comparison[slow]) / median(runs):.0f}"
        yield f"speed_{method}_two_threads", f"{median(runs) / median(comparison[f'{method}, 2 threads']):.1f}"
        points = [(line["number_of_input_points"], line["cpu_seconds"]) for line in scaling
                  if line["parameters"]["method"] == method]
        yield f"speed_{method}_exponent", f"{performance_tables.fitted_exponent(points):.2f}"
        most = max(points)[0]
        yield (f"speed_{method}_bytes_of_most_points",
               performance_tables.memory_cells([line for line in scaling if line["parameters"]["method"] == method
                                                and line["number_of_input_points"] == most])[1])
        yield "speed_most_points", str(most)
    yield "speed_half_sampling_gain", f"{median(comparison['lor']) / median(comparison['alor']):.2f}"
    yield "speed_points_in", str(comparison["lor"][0]["number_of_input_points"])
    yield "speed_points_out", str(comparison["lor"][0]["number_of_output_points"])


def solver_figures(performance_tables, solvers):
    """What the paper's rows cost beside the collapsed problem, and what half-sampling saves of them."""
    yield "solver_points_in", str(solvers[0]["number_of_input_points"])
    for line in solvers:
        name = f"solver_{line['parameters']['solver']}_{line['parameters']['method']}"
        runs = [other for other in solvers if other["parameters"] == line["parameters"]]
        yield f"{name}_seconds", f"{performance_tables.median(runs):.2g}"
        yield f"{name}_bytes", performance_tables.memory_cells(runs)[1]


def device_figures(results):
    for line in results:
        yield f"device_{line['points_in']}_{line['method']}_ms", f"{1000 * line['device_resident_seconds']['median']:.3g}"


def main():
    defaults, benchmark, output = load(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
    sys.path += [str(benchmark / "quality"), str(benchmark / "performance"), str(benchmark / "report")]
    sys.dont_write_bytecode = True   # the benchmarks lie in the source tree
    import ablation_tables
    import claims
    import comparison_tables
    import oracle_tables
    import performance_tables
    import poisson_tables
    import quality_tables
    import run_callback_latency
    import run_cuda_performance
    import run_cuda_roofline
    import run_rounding
    import run_thin_plates

    quality = {name: load(benchmark / "quality" / "results" / f"{name}.json") for name in ("fandisk", "armadillo")}
    comparison, oracle, poisson, ablation, thin_plates = (
        load(benchmark / "quality" / "results" / f"{name}.json")
        for name in ("comparison", "oracle", "poisson", "ablation", "thin_plates"))
    rounding, rounding_of_device = (load(benchmark / "quality" / "results" / f"{name}.json") for name in ("rounding", "rounding_h200"))
    speed, scaling, callback, device, roofline = (load(benchmark / "performance" / "results" / f"{name}.json")
                                                  for name in ("fandisk", "scaling", "callback", "cuda_h200", "cuda_roofline"))
    report = load(benchmark / "report" / "results" / "full.json")
    texts = {**{f"quality_{name}": quality_tables.markdown(result) for name, result in quality.items()},
             "comparison": comparison_tables.markdown(comparison), "oracle": oracle_tables.markdown(oracle),
             "poisson": poisson_tables.markdown(poisson),
             "ablation": ablation_tables.markdown(ablation), "thin_plates": run_thin_plates.markdown(thin_plates),
             "rounding": run_rounding.markdown(rounding), "rounding_of_device": run_rounding.markdown(rounding_of_device),
             "speed": performance_tables.markdown(speed), "scaling": performance_tables.markdown(scaling),
             "callback": run_callback_latency.markdown(callback),
             "device": run_cuda_performance.markdown(device["results"], device["beside"], device["beside_machine"],
                                                     device["command"]),
             "roofline": run_cuda_roofline.table(roofline),
             "claims": claims.claims_table(report["experiments"]).markdown()}

    figures = dict(code_figures(defaults))
    for name, result in quality.items():
        figures.update(quality_figures(quality_tables, name, result))
    figures["comparison_points_in"] = str(comparison["experiments"][0]["input_points"])
    figures["comparison_samplings"] = str(len({experiment["seed"] for experiment in comparison["experiments"]}))
    figures["comparison_points_out"] = str(comparison["experiments"][0]["output_points"])
    figures.update(speed_figures(performance_tables, speed["comparison"], scaling["scaling"]))
    figures.update(solver_figures(performance_tables, speed["solvers"]))
    figures.update(device_figures(device["results"]))
    figures["speed_machine"] = f"{speed['machine']['cores']} cores of {speed['machine']['processor']}"

    output.mkdir(parents=True, exist_ok=True)
    aliases = "".join(f'ALIASES += "{name}={value}"\n' for name, value in figures.items())
    (output / "figures_of_the_code").write_text(aliases, encoding="utf-8")
    macros = "".join(f"\\newcommand{{\\{camel_case(name)}}}{{{value}}}\n" for name, value in figures.items()
                     if camel_case(name).isalpha())
    (output / "formula_macros.tex").write_text(macros, encoding="utf-8")
    for name, text in texts.items():
        for number, table in enumerate(html_tables(text), start=1):
            (output / f"table_{name}_{number}.txt").write_text(table, encoding="utf-8")


if __name__ == "__main__":
    main()
