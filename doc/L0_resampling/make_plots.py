#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the plots of the manual from the tables that the benchmarks have written:

  make_plots.py [NAME...]   draws these plots, or all, to fig/plot_NAME.png (Debian:
                            python3-matplotlib and python3-pil)
  make_plots.py --check     fails unless each plot shows what its tables say now

Each file holds a digest of the numbers that it shows, so that --check needs nothing but Python.
"""

import hashlib
import io
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FIGURES = Path(__file__).resolve().parent / "fig"
BENCHMARK = ROOT / "benchmark" / "L0_resampling"
sys.path.append(str(BENCHMARK / "common"))
sys.dont_write_bytecode = True   # the benchmarks lie in the source tree
from results import read_tables

KEY = "Digest of the numbers"
SHAPES = {"fandisk": ("o", "tab:blue"), "anchor_dense": ("s", "tab:orange"),
          "dodecahedron": ("^", "tab:green"), "staircase": ("v", "tab:olive"),
          "armadillo": ("D", "tab:red"), "thin_plate": ("x", "tab:gray")}
METHODS = {"LOR": ("s", "tab:orange"), "ALOR": ("^", "tab:olive"), "default": ("o", "tab:blue"),
           "WLOP": ("v", "tab:red")}
VARIANTS = {"default": ("o", "tab:blue"), "best radius": ("s", "tab:orange"),
            "true normals": ("^", "tab:green"), "both": ("v", "tab:red")}


TITLES = {"mean distance, %": "mean distance", "normal error, degrees": "normal error",
          "NN6 cv": "unevenness (NN6 cv)", "mesh to truth, mean, %": "mesh to truth, mean",
          "truth to mesh, mean, %": "truth to mesh, mean", "Hausdorff, %": "furthest place"}


def tables_of(folder, name):
    text = (BENCHMARK / folder / "results" / f"{name}.md").read_text(encoding="utf-8")
    return read_tables(text)


def ratio_in(cell):
    """What stands in parentheses, the ratio to the best of CGAL, or None."""
    found = re.search(r"\(([\d.]+)\)", cell)
    return float(found[1]) if found else None


def parts_of_input(name):
    """Shape, noise in percent of the diagonal, and what else the input has: "fandisk, 1 %, ..."."""
    shape, noise, *rest = name.split(", ")
    return shape, float(noise.removesuffix(" %")), rest[0] if rest else ""


def ratios_by_noise(table, columns):
    """[kind of input][column][shape]: pairs of noise and ratio."""
    curves = {}
    for row in table.rows:
        shape, noise, kind = parts_of_input(row[0])
        for column in columns:
            ratio = ratio_in(row[table.header.index(column)])
            if ratio is not None:
                curves.setdefault(kind, {}).setdefault(column, {}).setdefault(shape, []).append(
                    [noise, ratio])
    return curves


def comparison_data():
    return ratios_by_noise(tables_of("quality", "comparison")[0],
                           ["mean distance, %", "normal error, degrees", "NN6 cv"])


def poisson_data():
    tables = tables_of("quality", "poisson")
    columns = ["mesh to truth, mean, %", "truth to mesh, mean, %", "Hausdorff, %"]
    exact = next(t for t in tables if t.heading == "Meshes of exact points")
    return {"of the result": ratios_by_noise(tables[0], columns)[""],
            "of exact points": ratios_by_noise(exact, columns)[""]}


def oracle_data():
    """[measure][shape][variant]: pairs of noise and ratio."""
    curves = {}
    for table in tables_of("quality", "oracle")[:2]:
        for row in table.rows:
            shape, noise, _ = parts_of_input(row[0])
            for variant, cell in zip(table.header[2:], row[2:]):
                of_shape = curves.setdefault(table.heading, {}).setdefault(shape, {})
                of_shape.setdefault(variant, []).append([noise, ratio_in(cell)])
    return curves


def thin_plates_data():
    """[method][noise]: pairs of thickness and distance."""
    return {table.heading: {noise: [[float(row[0]), float(row[i].split(" / ")[0])]
                                    for row in table.rows]
                            for i, noise in enumerate(table.header) if i > 0}
            for table in tables_of("quality", "thin_plates")}


def scenes_data():
    """[measure][scan]: ratio to the best of CGAL."""
    measures = {"Distance to the scene, mean, mm": "mean distance",
                "Error of normals, mean, degrees, without sign": "normal error"}
    return {measures[table.heading]: {row[0]: float(row[-1]) for row in table.rows}
            for table in tables_of("quality", "scenes") if table.heading in measures}


def scaling_data():
    table = tables_of("performance", "scaling")[0]
    rows = [row for row in table.rows if row[0].isdigit()]
    return {method: [[int(row[0]), float(row[table.header.index(f"{method}, CPU seconds")])]
                     for row in rows]
            for method in ("LOR", "ALOR", "default")}


def stages_data():
    """[input and method][stage]: milliseconds on the device."""
    table = tables_of("performance", "cuda_h200")[2]
    return {run: {row[0]: float(row[table.header.index(run)] or 0) for row in table.rows}
            for run in ("110000 lor", "110000 default", "1000000 lor", "1000000 default")}


def draw_ratios(panel, curves):
    for shape, points in curves.items():
        marker, color = SHAPES[shape]
        panel.plot(*zip(*points), marker=marker, color=color, label=shape)
    as_ratios(panel)


def as_ratios(panel):
    from matplotlib.ticker import NullFormatter, ScalarFormatter
    panel.set_yscale("log")
    panel.yaxis.set_major_formatter(ScalarFormatter())
    panel.yaxis.set_minor_formatter(NullFormatter())
    panel.set_yticks([0.1, 0.25, 0.5, 1, 2, 4])
    panel.axhline(1, color="black", linewidth=1)
    panel.grid(alpha=0.3)


def draw_grid(plt, rows):
    """A panel of ratios for each pair of a row and a column; `rows`: [row][column][shape]."""
    columns = list(next(iter(rows.values())))
    figure, panels = plt.subplots(len(rows), len(columns), figsize=(10, 2.7 * len(rows) + 0.7),
                                  sharex=True, sharey=True, squeeze=False)
    for line, (name, curves) in zip(panels, rows.items()):
        for panel, column in zip(line, columns):
            draw_ratios(panel, curves[column])
        line[0].set_ylabel(f"{name}\nratio to the best of CGAL")
    for panel, column in zip(panels[0], columns):
        panel.set_title(TITLES.get(column, column))
    for panel in panels[-1]:
        panel.set_xlabel("noise, % of the diagonal")
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=len(labels))
    figure.tight_layout(rect=(0, 0.35 / figure.get_figheight(), 1, 1))
    return figure


def draw_comparison(plt, data):
    names = {"": "noise only", "5 % outliers": "with outliers", "gradient 10": "uneven density"}
    return draw_grid(plt, {names[kind]: curves for kind, curves in data.items()})


def draw_poisson(plt, data):
    return draw_grid(plt, {f"meshes\n{name}": curves for name, curves in data.items()})


def draw_oracle(plt, data):
    shapes = list(next(iter(data.values())))
    figure, panels = plt.subplots(len(data), len(shapes), figsize=(10, 5.6), sharex=True,
                                  sharey=True)
    for line, (measure, curves) in zip(panels, data.items()):
        for panel, shape in zip(line, shapes):
            for variant, points in curves[shape].items():
                marker, color = VARIANTS[variant]
                panel.plot(*zip(*points), marker=marker, color=color, label=variant)
            as_ratios(panel)
        line[0].set_ylabel(f"{measure.split(',')[0]}\nratio to the best of CGAL")
    panels[0][0].set_ylim(0.05, 7)
    for panel, shape in zip(panels[0], shapes):
        panel.set_title(shape)
    for panel in panels[-1]:
        panel.set_xlabel("noise, %")
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=len(labels))
    figure.tight_layout(rect=(0, 0.06, 1, 1))
    return figure


def draw_thin_plates(plt, data):
    figure, panels = plt.subplots(1, len(data), figsize=(10, 3.6), sharey=True)
    for panel, (method, curves) in zip(panels, data.items()):
        for shade, (noise, points) in enumerate(curves.items()):
            color = plt.get_cmap("viridis")(0.9 - 0.2 * shade)
            label = noise.replace("of it", "of the thickness")
            panel.plot(*zip(*points), marker="o", markersize=4, color=color, label=label)
        panel.set_title(method)
        panel.set_xlabel("thickness, spacings")
        panel.grid(alpha=0.3)
    panels[0].set_ylabel("distance, % of the thickness")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=3, fontsize="small")
    figure.tight_layout(rect=(0, 0.13, 1, 1))
    return figure


def draw_scenes(plt, data):
    figure, panels = plt.subplots(1, len(data), figsize=(10, 3.8), sharey=True)
    for panel, (measure, ratios) in zip(panels, data.items()):
        names = list(ratios)[::-1]
        values = [ratios[name] for name in names]
        colors = ["tab:blue" if value <= 1 else "tab:red" for value in values]
        panel.barh(names, values, color=colors)
        for i, value in enumerate(values):
            panel.text(value, i, f" {value:g}", va="center", fontsize="small")
        panel.axvline(1, color="black", linewidth=1)
        panel.set_xlim(0, 1.15 * max(values))
        panel.set_title(f"{measure}, ratio to the best of CGAL")
    figure.tight_layout()
    return figure


def draw_scaling(plt, data):
    figure, panel = plt.subplots(figsize=(6.5, 4))
    for method, points in data.items():
        marker, color = METHODS[method]
        panel.loglog(*zip(*points), marker=marker, color=color, label=method)
    panel.set_xlabel("points")
    panel.set_ylabel("seconds, one thread")
    panel.grid(alpha=0.3)
    panel.legend()
    figure.tight_layout()
    return figure


def draw_stages(plt, data):
    figure, panel = plt.subplots(figsize=(10, 3.6))
    names = list(data)[::-1]
    colors = plt.get_cmap("tab20").colors
    left = {name: 0 for name in names}
    for i, stage in enumerate(next(iter(data.values()))):
        share = [100 * data[name][stage] / sum(data[name].values()) for name in names]
        panel.barh(names, share, left=[left[name] for name in names], color=colors[2 * i % 20
                   + (2 * i // 20)], label=stage)
        left = {name: left[name] + part for name, part in zip(names, share)}
    panel.set_xlabel("% of the time of all stages on the device")
    panel.set_xlim(0, 100)
    figure.legend(loc="lower center", ncol=5, fontsize="small")
    figure.tight_layout(rect=(0, 0.16, 1, 1))
    return figure


PLOTS = {"comparison": (comparison_data, draw_comparison),
         "poisson": (poisson_data, draw_poisson),
         "oracle": (oracle_data, draw_oracle),
         "thin_plates": (thin_plates_data, draw_thin_plates),
         "scenes": (scenes_data, draw_scenes),
         "scaling": (scaling_data, draw_scaling),
         "stages": (stages_data, draw_stages)}


def digest(data):
    return hashlib.sha256(json.dumps(data).encode()).hexdigest()


def file_of(name):
    return FIGURES / f"plot_{name}.png"


def digest_in(path):
    """The digest that a plot has, or None."""
    found = re.search(KEY.encode() + rb"\0([0-9a-f]{64})", path.read_bytes())
    return found[1].decode() if found else None


def draw(name):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from PIL import Image, PngImagePlugin

    data_of, drawn = PLOTS[name]
    data = data_of()
    picture = io.BytesIO()
    figure = drawn(plt, data)
    figure.savefig(picture, format="png", dpi=110)
    plt.close(figure)
    information = PngImagePlugin.PngInfo()
    information.add_text(KEY, digest(data))
    image = Image.open(picture).convert("RGB").quantize(64, Image.Quantize.MAXCOVERAGE)
    image.save(file_of(name), optimize=True, pnginfo=information)


def main():
    if sys.argv[1:] == ["--check"]:
        old = [name for name, (data_of, _) in PLOTS.items()
               if not file_of(name).exists() or digest_in(file_of(name)) != digest(data_of())]
        sys.exit(f"make_plots.py: draw again: {' '.join(old)}" if old else 0)
    for name in sys.argv[1:] or PLOTS:
        draw(name)


if __name__ == "__main__":
    main()
