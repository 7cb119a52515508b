#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what the manual quotes: generate_text.py DEFAULTS.json SOURCE_DIRECTORY OUTPUT_DIRECTORY

- figures_of_the_code: Doxygen aliases, one for each default, constant and measured figure, such as
  \\default_normal_weight, \\constant_inner_radius_factor, \\quality_fandisk_10_default_distance
  (noise of 1.0 %) or \\speed_default_seconds;
- formula_macros.tex: the same for formulas, where their names have letters only, such as
  \\constantInnerRadiusFactor, as TeX knows no underscores;
- table_*.txt: the tables of the benchmarks, for \\include{doc}, each with the commit that it was
  measured at; for figures, that is an alias such as \\measured_quality_thin_plates;
- table_of_sizes.txt: the files of each part of the repository, and their lines.

DEFAULTS.json is what the program print_defaults prints.
"""

import csv
import html
import json
import re
import sys
import tomllib
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
        is_unbroken = tag == "td" and len(text) <= LONGEST_UNBROKEN_CELL
        classes = ["l0Number"] * is_number + ["l0Unbroken"] * is_unbroken
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


def measured_line(commit):
    return f'<p class="l0Measured">Measured at commit <code>{commit}</code>.</p>\n'


def camel_case(name):
    first, *others = name.split("_")
    return first + "".join(word.capitalize() for word in others)


def code_figures(defaults):
    for group, values in defaults.items():
        for name, value in values.items():
            of_list = value if isinstance(value, list) else [value]
            yield f"{group}_{name}", ", ".join(f"{v:g}" for v in of_list)


QUALITY_NAMES = {"mean distance, %": "distance", "mean coverage, %": "coverage",
                 "normal error, degrees": "normal_error",
                 "normals inwards, %": "inwards", "edge recall": "recall", "NN6 cv": "evenness"}


def quality_figures(name, figures):
    """Of each method, and the best figure of CGAL's in each column."""
    for noise, methods in figures.items():
        noise_digits = f"{noise:.1f}".replace(".", "")
        for method, columns in methods.items():
            for heading, value in columns.items():
                if heading in QUALITY_NAMES and value != "-":
                    yield f"quality_{name}_{noise_digits}_{method}_{QUALITY_NAMES[heading]}", value


def speed_figures(fitted_exponent, comparison, scaling):
    for method in ("lor", "alor", "default"):
        run = comparison[method]
        seconds = run["wall_seconds"]
        yield f"speed_{method}_seconds", f"{seconds:.2g}"
        yield f"speed_{method}_bytes", f"{run['bytes_a_point']:.0f}"
        for slow in ("wlop", "ear"):
            yield f"speed_{method}_over_{slow}", f"{comparison[slow]['wall_seconds'] / seconds:.0f}"
        on_two_threads = comparison[f"{method}, 2 threads"]["wall_seconds"]
        yield f"speed_{method}_two_threads", f"{seconds / on_two_threads:.1f}"
        runs = [run for run in scaling if run["method"] == method]
        exponent = fitted_exponent([(run["points_in"], run["cpu_seconds"]) for run in runs])
        yield f"speed_{method}_exponent", f"{exponent:.2f}"
        largest = max(runs, key=lambda run: run["points_in"])
        yield f"speed_{method}_bytes_of_most_points", f"{largest['bytes_a_point']:.0f}"
        yield "speed_most_points", str(largest["points_in"])
    lor, alor = comparison["lor"], comparison["alor"]
    yield "speed_half_sampling_gain", f"{lor['wall_seconds'] / alor['wall_seconds']:.2f}"
    yield "speed_points_in", str(lor["points_in"])
    yield "speed_points_out", str(lor["points_out"])


def solver_figures(solvers):
    """What the paper's rows cost beside the collapsed problem, and what half-sampling saves of
    them."""
    yield "solver_points_in", str(solvers[0]["points_in"])
    for run in solvers:
        name = f"solver_{run['solver']}_{run['method']}"
        yield f"{name}_seconds", f"{run['wall_seconds']:.2g}"
        yield f"{name}_bytes", f"{run['bytes_a_point']:.0f}"


def device_figures(results):
    for run in results:
        yield f"device_{run['points_in']}_{run['method']}_ms", f"{1000 * run['seconds']:.3g}"


def load_csv(path):
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def test_figures(tests):
    """How often the function and the readers were attacked, and how many planted bugs there
    are."""
    attacks = load_csv(tests / "attack" / "attacks.csv")
    runs = load_csv(tests / "fuzz" / "executions.csv")
    yield "attack_number", str(sum(int(campaign["attacks"]) for campaign in attacks))
    yield "attack_broken", str(sum(int(campaign["broken_promises"]) for campaign in attacks))
    yield "fuzz_executions", str(sum(int(run["executions"]) for run in runs))
    yield "fuzz_broken", str(sum(int(run["broken"]) for run in runs))
    table = tests / "planted_bugs" / "planted_bugs.toml"
    yield "bugs_number", str(len(tomllib.loads(table.read_text(encoding="utf-8"))["bug"]))


# Parts of the repository, their folders, and how many files and lines they had at BEGINNING. The
# last one has all files that lie in none of these.
BEGINNING = "21414df"
PARTS = (("the package", ("include", "src/CGAL_L0_resampling_compiled"), 186, 25632),
         ("its stages on devices", ("src/CGAL_L0_CUDA",), 62, 12487),
         ("the tool", ("src/l0_resample", "src/common"), 146, 15384),
         ("the Python package", ("src/cgal_l0",), 29, 3692),
         ("tests", ("test",), 235, 39491),
         ("benchmarks", ("benchmark",), 158, 18196),
         ("manual, paper and examples", ("doc", "paper", "examples"), 89, 6980),
         ("data", ("data",), 20, 10496),
         ("plugins", ("plugins", "demo"), 28, 2089),
         ("packaging, scripts and the rest",
          ("packaging", "package_info", "cmake", "scripts", ".ci", ".github", "."), 35, 2614))


def files_of(source, folder):
    """Those that the repository has, and none that was made in its folders."""
    found = source.glob("*") if folder == "." else (source / folder).rglob("*")
    return [path for path in found
            if path.is_file() and not {"__pycache__", "output", ".git"} & set(path.parts)]


def size_table(source):
    rows, total = [], [0, 0, 0, 0]
    for name, folders, files_before, lines_before in PARTS:
        files = [path for folder in folders for path in files_of(source, folder)]
        contents = [path.read_bytes() for path in files]
        lines = sum(text.count(b"\n") for text in contents if b"\0" not in text)
        numbers = [len(files), lines, files_before, lines_before]
        total = [a + b for a, b in zip(total, numbers)]
        rows.append([name, *numbers])
    header = ["part", "files", "lines", f"files at {BEGINNING}", f"lines at {BEGINNING}"]
    lines = [header, ["---"] + ["---:"] * 4, *rows, ["all", *total]]
    return html_tables("\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines))[0]


# Files of tables, and their names in the manual where these differ
TABLES = {"quality": {"fandisk": "quality_fandisk", "armadillo": "quality_armadillo",
                      "creases": "creases", "deviations": "deviations",
                      "pcednet": "edge_points", "punet": "learned", "rounding": "rounding",
                      "rounding_h200": "rounding_of_device"},
          "performance": {"fandisk": "speed", "beside": "beside", "cuda_h200": "device",
                          "large_clouds": "large_clouds"}}
# Of figures that are plots, and of tables that the text names
PLOTTED = ("quality/noise_sweep", "quality/scans", "quality/sides", "quality/thin_plates",
           "performance/crowds", "performance/cuda_h200", "performance/scaling")


def main():
    defaults, source, output = load(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
    benchmark = source / "benchmark" / "L0_resampling"
    sys.path += [str(benchmark / folder) for folder in ("common", "quality", "performance")]
    sys.dont_write_bytecode = True   # the benchmarks lie in the source tree
    from measured import load_notes, short
    from performance_tables import fitted_exponent
    from quality_tables import read_figures
    from results import found_in

    texts = {name: (benchmark / folder / "results" / f"{file}.md").read_text(encoding="utf-8")
             for folder, names in TABLES.items() for file, name in names.items()}
    measured = {name: short(result["commit"]) for name, result in load_notes()["results"].items()}
    commit_of_text = {name: measured[f"{folder}/{file}"]
                      for folder, names in TABLES.items() for file, name in names.items()}
    tables = {name: [table + measured_line(commit_of_text[name]) for table in html_tables(text)]
              for name, text in texts.items()}
    speed, scaling, device = (load(benchmark / "performance" / "results" / f"{name}.json")
                              for name in ("fandisk", "scaling", "cuda_h200"))

    figures = dict(code_figures(defaults))
    for name in ("fandisk", "armadillo"):
        figures.update(quality_figures(name, read_figures(texts[f"quality_{name}"])))
    figures.update(speed_figures(fitted_exponent, speed["comparison"], scaling["scaling"]))
    figures.update(solver_figures(speed["solvers"]))
    figures.update(device_figures(device["results"]))
    figures.update(test_figures(source / "test" / "L0_resampling"))
    figures.update({f"measured_{name.replace('/', '_')}": measured[name] for name in PLOTTED})
    machine = speed["machine"]
    figures["speed_machine"] = f"{machine['cores']} cores of {machine['processor']}"
    figures["speed_flags"], = found_in("Release `([^`]+)`", texts["speed"])

    output.mkdir(parents=True, exist_ok=True)
    aliases = "".join(f'ALIASES += "{name}={value}"\n' for name, value in figures.items())
    (output / "figures_of_the_code").write_text(aliases, encoding="utf-8")
    macros = "".join(f"\\newcommand{{\\{camel_case(name)}}}{{{value}}}\n"
                     for name, value in figures.items() if camel_case(name).isalpha())
    (output / "formula_macros.tex").write_text(macros, encoding="utf-8")
    (output / "table_of_sizes.txt").write_text(size_table(source), encoding="utf-8")
    for name, of_name in tables.items():
        for number, table in enumerate(of_name, start=1):
            (output / f"table_{name}_{number}.txt").write_text(table, encoding="utf-8")


if __name__ == "__main__":
    main()
