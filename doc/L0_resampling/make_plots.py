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
METHODS = {"LOR": ("s", "tab:orange"), "ALOR": ("^", "tab:olive"), "default": ("o", "tab:blue"),
           "WLOP": ("v", "tab:red")}


def tables_of(folder, name):
    text = (BENCHMARK / folder / "results" / f"{name}.md").read_text(encoding="utf-8")
    return read_tables(text)


def thin_plates_data():
    """[method][noise]: pairs of thickness and distance."""
    return {table.heading: {noise: [[float(row[0]), float(row[i].split(" / ")[0])]
                                    for row in table.rows]
                            for i, noise in enumerate(table.header) if i > 0}
            for table in tables_of("quality", "thin_plates")}


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


PLOTS = {"thin_plates": (thin_plates_data, draw_thin_plates),
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
