# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plots of a report as SVG, made from its JSON."""

import io

import matplotlib

matplotlib.use("svg")
from matplotlib import pyplot

matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "report", "font.size": 9, "axes.grid": True,
                            "grid.alpha": 0.3, "font.family": "sans-serif"})


def svg(figure):
    """The drawing as an element of a page, without what stands before it in a file of its own."""
    stream = io.StringIO()
    figure.savefig(stream, format="svg", bbox_inches="tight", metadata={"Date": None})
    pyplot.close(figure)
    text = stream.getvalue()
    return text[text.index("<svg"):]


def histograms(experiment):
    figure, panels = pyplot.subplots(1, len(experiment["studies"]), figsize=(9, 2.6), sharey=True)
    bins = experiment["bins"]
    for panel, study in zip(panels, experiment["studies"]):
        panel.bar(bins[:-1], study["histogram"], width=bins[1] - bins[0], align="edge", color="#4878a8")
        panel.set_title(study["title"])
        panel.set_xlabel("local density, Eq. (5)")
    panels[0].set_ylabel("share of the points")
    return svg(figure)


def densities_over_iterations(experiment):
    figure, panel = pyplot.subplots(figsize=(6, 3))
    for study, style in zip(experiment["studies"], ("-", "--")):
        for number, values in enumerate(zip(*study["densities_over_iterations"])):
            panel.plot(range(1, len(values) + 1), values, style, color=f"C{number}", label=f"sample {number + 1}, {study['title']}")
    panel.set_xlabel("iteration")
    panel.set_ylabel("local density, Eq. (5)")
    panel.legend(fontsize=7, ncol=2)
    return svg(figure)


STYLES = {"LOR": "s-", "ALOR": "s--", "default": "o-"}


def against_noise(experiments, heading, value):
    """One curve a method over the noise, all experiments of one shape."""
    figure, panel = pyplot.subplots(figsize=(6, 3.4))
    names = [name for name, run in experiments[0]["measurements"].items() if run]
    for number, name in enumerate(names):
        values = [value(experiment["measurements"][name]["evaluation"]) for experiment in experiments]
        panel.plot([experiment["noise_percent"] for experiment in experiments], values, STYLES.get(name, ".-"),
                   color=f"C{number % 10}", linewidth=2 if name == "default" else 1, alpha=1 if name in STYLES else 0.6, label=name)
    panel.set_xlabel("noise, % of the diagonal")
    panel.set_ylabel(heading)
    panel.set_ylim(bottom=0)
    panel.legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    return svg(figure)
